// The numbers that a scene or a view sets, in one uniform block: structs, each read by its name. They mirror those of
// rendering/gpu/Uniforms.h. One block, because lavapipe of Mesa 22.3 overwrites its own memory with a fourth: its search
// for uniforms to inline notes those that a program's branches depend on in an array of 128 words on the stack, of buffer b
// from word 32 b on. Plain uniforms are buffer 0.
#include <schedule>

const int HALF_SPACES = 12;  // as many as there may be; those not in use keep everything
const int WALLS = 3;         // as many as there may be; those not in use have no extent

// lib/PixelRay.glsl
struct RayUniforms {
  mat3 cellsFromView;  // cells per mm along the view's right, up and forward
  mat3 worldFromView;  // columns: right, up, forward as unit vectors in world space
  vec3 anchor;         // cell frame: where the view axis meets the anchor plane
  float distance;      // mm from the eye (or the plane through it) to the anchor plane
  vec2 halfSize;       // mm on the anchor plane at the picture's right and top edge
  vec2 spread;         // the same for the rays' directions; 0 where rays are parallel
  float depth;         // mm, the distance again; 1 where rays are parallel
  ivec2 pictureSize;
};

// lib/Grid.glsl
struct VolumeUniforms {
  ivec3 dims;  // voxels
};

// lib/clip
struct ClipUniforms {
  vec4 planes[HALF_SPACES];   // cell frame: mm before the plane are xyz·position + w
  vec4 normals[HALF_SPACES];  // unit, world
  vec2 grey;                  // of a capped face: stored value · x + y
};

// lib/Transfer.glsl
struct TransferUniforms {
  vec4 firstMaterial, lastMaterial;  // beyond the tables' ends
  vec2 map;                          // entry = stored value · x + y
  vec2 visibleEntries;               // nothing shows up to the first or from the second on
  int firstLevel;                    // of lib/PreIntegration.glsl
};

// lib/focus/Index.glsl
struct FocusUniforms {
  vec4 material;                // colour, extinction (1/mm)
  vec2 range;                   // of a value focus, stored values, closed
  ivec3 paletteOrigin;          // index of the palette texture's first voxel
  vec3 smoothOrigin;            // cell frame: outer corner of the smoothed indicator's first texel
  vec4 table;                   // as focusTable() has it, where all of the focus has one; w: its opacity
  mat3 worldFromIndexGradient;  // gradients: world (1/mm) from index
};

// lib/integral/Settings.glsl
struct IntegralUniforms {
  float leastTransmittance;  // early ray termination: what lies behind less than that does not show
  float maxError;            // of a pixel's colour; for lib/integral/CellByCell.glsl
  float cutFaceDepth;        // mm behind a cut face over which its own light gives way to the volume's
  float cutFaceShare;        // of a cut face's light that is the face's own at its surface
  float perGap;              // 1/mm: a body ends within the reciprocal behind its last point (lib/integral/Bodies.glsl)
};

// lib/light/BlinnPhong.glsl
struct LightUniforms {
  vec3 direction;        // world, towards the light
  float ambient;
  float diffuse;
  float specular;
  float shininess;
  float meanIncidence;   // |n·l| of a surface of average orientation
  ivec3 gradientOrigin;  // index of the gradient texture's first voxel
  float certainLength;   // of a gated normal, from which on it is lit in full
  ivec3 lastNode;        // of ambient occlusion: index along each axis (lib/occlusion/Nodes.glsl)
  vec3 nodesPerVoxel;
};

// Occluders.comp
struct OccludersUniforms {
  mat3 viewFromCells;  // of the picture that the opening is cut for: mm from its anchor point, for a cell's coordinates
  vec3 offset;         // there, of the corner of the first cell
  float perDepth;      // 1/mm: how that picture widens behind the anchor plane; 0 where rays are parallel
  ivec3 dims;          // cells
  float nearest;       // view depth in mm before which nothing is removed
  vec3 side;           // voxels
  float width;         // mm over which edges are softened
};

// Occlusion.comp
struct OcclusionUniforms {
  ivec3 dims;        // cells
  int around;        // directions all around, the first ones
  vec2 strength;     // of occlusion and shadow, 0 to 1
  int towardsLight;  // directions towards the light, behind those
};

// RemovedParts.comp
struct OpeningCameraUniforms {
  mat3 viewFromWorld;
  vec3 offset;        // mm, in the opening's view axes: from its anchor point to that of this picture's rays
  float perDepth;     // 1/mm: how the picture widens behind the anchor plane; 0 where rays are parallel
  vec2 halfSize;      // mm on the anchor plane at the right and top edge
  ivec2 pictureSize;
  float nearest;      // view depth in mm before which nothing is removed: near the eye, or behind the plane of the rays
};

// lib/Cones.glsl
struct ConeUniforms {
  ivec2 origin;    // pixel of the picture that the pyramid begins at
  ivec2 tops;      // squares of the top level
  float slope;     // mm of depth per pixel beside the axis, on the anchor plane
  float perDepth;  // 1/mm, the reciprocal of the anchor plane's depth; 0 where rays are parallel
};

// lib/Curvature.glsl
struct DerivativeUniforms {
  mat3 worldFromDerivative;  // gradient: world (1/mm) from derivative index (the inverse transpose)
  vec3 factor;               // volume voxels per derivative voxel
  float scale;               // real value per texel unit
};

// Composite.comp
struct CutawayUniforms {
  vec2 widths;        // w_open, w_border in rendered pixels
  vec3 borderColour;
};

// Composite.comp
struct ContextLayerUniforms {
  vec3 colour;
  float strength;           // scales the layer's opacity
  float curvatureWeight;    // opacity of sharp bends
  float silhouetteWeight;   // opacity of what turns away from the eye
  float illuminationWeight; // from the flat colour to the colour as the surface is lit
  float valueWeight;        // from `colour` to the context's own
  float curvatureScale;     // mm: makes curvature dimensionless; the derivative volume's spacing
  float saturation;         // of the context's own colour
  float leastLine;          // strength of the weakest edge; -1 keeps all
};

// Walls.comp: affine functions of a position in the cell frame, xyz·position + w.
struct WallUniforms {
  vec4 plane[WALLS];         // mm before the wall
  vec4 across[WALLS];        // the place on it: u
  vec4 down[WALLS];          // and v, in voxels
  vec4 extent[WALLS];        // voxels along u and v; first row in `greys`
  vec4 metric[WALLS];        // mm on the wall: x of u, x of v, y of v; width of lines
};

// lib/Candidate.glsl
struct CandidateUniforms {
  vec3 sphereCentre;   // cell frame
  float sphereRadius;  // mm
  vec3 focusLower;     // cell frame: nothing of the focus lies outside
  vec3 focusUpper;
};

layout(std140) uniform Uniforms {
  RayUniforms rays;
  VolumeUniforms volume;
  ClipUniforms clipping;
  TransferUniforms transfer;
  FocusUniforms focus;
  IntegralUniforms integral;
  LightUniforms lighting;
  OccludersUniforms occluders;
  OcclusionUniforms occlusion;
  OpeningCameraUniforms opening;
  ConeUniforms cones;
  DerivativeUniforms derivative;
  CutawayUniforms cutaway;
  ContextLayerUniforms contextLook;
  WallUniforms walls;
  CandidateUniforms candidates;
}
STORED_UNIFORMS;

UNIFORM(RayUniforms, rays)
UNIFORM(VolumeUniforms, volume)
UNIFORM(ClipUniforms, clipping)
UNIFORM(TransferUniforms, transfer)
UNIFORM(FocusUniforms, focus)
UNIFORM(IntegralUniforms, integral)
UNIFORM(LightUniforms, lighting)
UNIFORM(OccludersUniforms, occluders)
UNIFORM(OcclusionUniforms, occlusion)
UNIFORM(OpeningCameraUniforms, opening)
UNIFORM(ConeUniforms, cones)
UNIFORM(DerivativeUniforms, derivative)
UNIFORM(CutawayUniforms, cutaway)
UNIFORM(ContextLayerUniforms, contextLook)
UNIFORM(WallUniforms, walls)
UNIFORM(CandidateUniforms, candidates)
