#pragma once
// What shaders/lib/Uniforms.glsl declares, in std140 layout: structs of the shaders' one uniform block, with the name
// that each has there, and members of the same name and place as in GLSL. tests/gl/ProgramsTest compares the offsets.

#include <array>

#include <glm/glm.hpp>

#include "rendering/settings/Clipping.h"

namespace fenestra {

/// A matrix of three rows, its columns padded as std140 has them.
using Std140Mat3 = glm::mat3x4;

/// shaders/lib/PixelRay.glsl.
struct alignas(16) RayUniforms {
  static constexpr const char* name = "rays";
  Std140Mat3 cellsFromView, worldFromView;
  glm::vec3 anchor;
  float distance;
  glm::vec2 halfSize, spread;
  float depth;
  alignas(8) glm::ivec2 pictureSize;
};

/// shaders/lib/clip.
struct alignas(16) ClipUniforms {
  static constexpr const char* name = "clipping";
  std::array<glm::vec4, mostHalfSpaces> planes, normals;
  glm::vec2 grey{0.0f};
};

/// shaders/lib/Grid.glsl.
struct alignas(16) VolumeUniforms {
  static constexpr const char* name = "volume";
  glm::ivec3 dims;
};

/// shaders/lib/Transfer.glsl.
struct alignas(16) TransferUniforms {
  static constexpr const char* name = "transfer";
  glm::vec4 firstMaterial, lastMaterial;
  glm::vec2 map, visibleEntries;
  int firstLevel = 0;
};

/// shaders/lib/focus/Index.glsl.
struct alignas(16) FocusUniforms {
  static constexpr const char* name = "focus";
  glm::vec4 material{0.0f};
  alignas(16) glm::vec2 range{0.0f};
  alignas(16) glm::ivec3 paletteOrigin{0};
  alignas(16) glm::vec3 smoothOrigin{0.0f};
  alignas(16) glm::vec4 table{0.0f, 0.0f, 0.0f, 1.0f};
  alignas(16) Std140Mat3 worldFromIndexGradient{1.0f};
};

/// shaders/lib/light/BlinnPhong.glsl.
struct alignas(16) LightUniforms {
  static constexpr const char* name = "lighting";
  glm::vec3 direction;
  float ambient, diffuse, specular, shininess, meanIncidence;
  glm::ivec3 gradientOrigin;
  float certainLength;
  alignas(16) glm::ivec3 lastNode{0};
  alignas(16) glm::vec3 nodesPerVoxel{0.0f};
};

/// shaders/Occluders.comp.
struct alignas(16) OccludersUniforms {
  static constexpr const char* name = "occluders";
  Std140Mat3 viewFromCells{1.0f};
  glm::vec3 offset{0.0f};
  float perDepth = 0.0f;
  glm::ivec3 dims{0};
  float nearest = 0.0f;
  glm::vec3 side{1.0f};
  float width = 0.0f;
};

/// shaders/Occlusion.comp.
struct alignas(16) OcclusionUniforms {
  static constexpr const char* name = "occlusion";
  glm::ivec3 dims;
  int around;
  glm::vec2 strength;
  int towardsLight;
};

/// shaders/lib/integral/Settings.glsl.
struct alignas(16) IntegralUniforms {
  static constexpr const char* name = "integral";
  float leastTransmittance, maxError, cutFaceDepth, cutFaceShare, perGap;
};

/// shaders/RemovedParts.comp.
struct alignas(16) OpeningCameraUniforms {
  static constexpr const char* name = "opening";
  Std140Mat3 viewFromWorld;
  glm::vec3 offset;
  float perDepth;
  glm::vec2 halfSize;
  alignas(8) glm::ivec2 pictureSize;
  float nearest;
};

/// shaders/lib/Cones.glsl.
struct alignas(16) ConeUniforms {
  static constexpr const char* name = "cones";
  glm::ivec2 origin, tops;
  float slope, perDepth;
};

/// shaders/lib/Curvature.glsl.
struct alignas(16) DerivativeUniforms {
  static constexpr const char* name = "derivative";
  Std140Mat3 worldFromDerivative;
  glm::vec3 factor;
  float scale;
};

/// shaders/Composite.comp.
struct alignas(16) CutawayUniforms {
  static constexpr const char* name = "cutaway";
  glm::vec2 widths;
  alignas(16) glm::vec3 borderColour;
};
struct alignas(16) ContextLayerUniforms {
  static constexpr const char* name = "contextLook";
  glm::vec3 colour;
  float strength, curvatureWeight, silhouetteWeight, illuminationWeight, valueWeight, curvatureScale, saturation,
      leastLine;
};

/// shaders/Walls.comp.
struct alignas(16) WallUniforms {
  static constexpr const char* name = "walls";
  std::array<glm::vec4, 3> plane, across, down, extent, metric;
};

/// shaders/lib/Candidate.glsl.
struct alignas(16) CandidateUniforms {
  static constexpr const char* name = "candidates";
  glm::vec3 sphereCentre;
  float sphereRadius;
  alignas(16) glm::vec3 focusLower;
  alignas(16) glm::vec3 focusUpper;
};

}  // namespace fenestra
