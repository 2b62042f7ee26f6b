// The one ray set-up that every pass shares, so that every t stored for a pixel lies on the same ray.
//
// Cell frame: index + 1. Cell c spans [c, c+1] between voxel centres; the volume's box is [½, dims+½], so coordinates
// inside it are positive and truncation is floor. Positions along a ray are s = t - rayDistance in mm: the ray is
// anchored on a plane near the volume, which keeps float32 exact enough however far away the eye is.

uniform ivec2 pictureSize;
uniform ivec3 volumeDims;
uniform vec3 rayAnchor;        // cell frame: where the view axis meets the anchor plane
uniform mat3 cellsFromView;    // cells per mm along the view's right, up and forward
uniform mat3 worldFromView;    // columns: right, up, forward as unit vectors in world space
uniform vec2 rayHalfSize;      // mm on the anchor plane at the picture's right and top edge
uniform float rayDistance;     // mm from the eye (or the plane through it) to the anchor plane
uniform bool rayPerspective;

const float NONE = -1e30;      // "nothing here" in every map of positions along rays
const float FAR = 1e30;

bool isNone(float s) { return s < -1e29; }

struct Ray {
  vec3 base;        // cell frame, at s = 0
  vec3 direction;   // cells per mm
  vec3 inverse;     // mm per cell; 0 on axes the ray is parallel to
  vec3 world;       // unit direction in world space
  vec3 worldBase;   // world position at s = 0 relative to the middle of the anchor plane, mm
  float sIn, sOut;  // inside the box and in front of the eye; sIn > sOut: the box is missed
};

// Fills in the inverse and the part of the ray inside a box of the cell frame, from s = sFirst on.
void clipTo(inout Ray ray, vec3 lower, vec3 upper, float sFirst) {
  bvec3 parallel = lessThan(abs(ray.direction), vec3(1e-7 * length(ray.direction)));
  ray.inverse = mix(1.0 / ray.direction, vec3(0.0), parallel);
  vec3 a = (lower - ray.base) * ray.inverse, b = (upper - ray.base) * ray.inverse;
  bvec3 outside = bvec3(uvec3(lessThan(ray.base, lower)) | uvec3(greaterThan(ray.base, upper)));
  vec3 near = mix(min(a, b), mix(vec3(-FAR), vec3(FAR), outside), parallel);
  vec3 far = mix(max(a, b), vec3(FAR), parallel);
  ray.sIn = max(max(near.x, near.y), max(near.z, sFirst));
  ray.sOut = min(far.x, min(far.y, far.z));
}

void clipToBox(inout Ray ray, float sFirst) { clipTo(ray, vec3(0.5), vec3(volumeDims) + 0.5, sFirst); }

Ray pixelRay(ivec2 pixel) {
  vec2 ndc = 2.0 * (vec2(pixel) + 0.5) / vec2(pictureSize) - 1.0;
  vec2 offset = vec2(ndc.x, -ndc.y) * rayHalfSize;
  vec3 view = vec3(0.0, 0.0, 1.0);
  float sAnchor = 0.0;
  if (rayPerspective) {
    float along = length(vec3(offset, rayDistance));
    view = vec3(offset, rayDistance) / along;
    sAnchor = dot(offset, offset) / (along + rayDistance);  // = along - rayDistance, without cancellation
  }
  Ray ray;
  ray.direction = cellsFromView * view;
  ray.world = worldFromView * view;
  ray.base = rayAnchor + cellsFromView * vec3(offset, 0.0) - sAnchor * ray.direction;
  ray.worldBase = worldFromView * vec3(offset, 0.0) - sAnchor * ray.world;
  clipToBox(ray, -rayDistance);
  return ray;
}

vec3 worldPosition(Ray ray, float s) { return ray.worldBase + s * ray.world; }

// Where the pixel's ray crosses the plane parallel to the picture `depth` mm behind the anchor plane.
float positionAtDepth(ivec2 pixel, float depth) {
  if (!rayPerspective) return depth;
  vec2 ndc = 2.0 * (vec2(pixel) + 0.5) / vec2(pictureSize) - 1.0;
  vec2 offset = vec2(ndc.x, -ndc.y) * rayHalfSize;
  float along = length(vec3(offset, rayDistance));
  return depth * (along / rayDistance) + dot(offset, offset) / (along + rayDistance);
}

vec3 cellPosition(Ray ray, float s) { return ray.base + s * ray.direction; }

// Where the ray leaves the block of cells [lower, upper), and through which axis.
float blockExit(Ray ray, ivec3 lower, ivec3 upper, out int axis) {
  vec3 plane = mix(vec3(lower), vec3(upper), greaterThan(ray.direction, vec3(0.0)));
  vec3 s = mix((plane - ray.base) * ray.inverse, vec3(FAR), equal(ray.inverse, vec3(0.0)));
  axis = s.x <= s.y && s.x <= s.z ? 0 : s.y <= s.z ? 1 : 2;
  return s[axis];
}

// Carries a ray on from s in `cell`, through the faces of the block of cells [lower, upper) around it; false where it
// ends in there, or the volume does. `axis`: of the face by which it left.
bool leaveBlock(Ray ray, ivec3 lower, ivec3 upper, float sEnd, inout ivec3 cell, inout float s, out int axis) {
  s = max(blockExit(ray, lower, upper, axis), s);
  // Rounding must not carry the other two axes out of the block that was just left.
  cell = clamp(ivec3(floor(cellPosition(ray, s))), lower, upper - 1);
  cell[axis] = ray.direction[axis] > 0.0 ? upper[axis] : lower[axis] - 1;
  return s < sEnd && all(lessThan(uvec3(cell), uvec3(volumeDims + 1)));
}
