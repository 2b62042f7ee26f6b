#pragma once
// A volume as a 3-D texture in the narrowest format that holds it exactly, and what shading needs beside it.

#include <optional>

#include "rendering/gl/Texture.h"
#include "rendering/gpu/Bricks.h"
#include "rendering/scene/ShownVolume.h"

namespace fenestra {

/// The shaders compute in coded values: coded = (real - intercept) / slope - base, which are small non-negative
/// integers wherever the data are integers, and so exact in float32. Floating-point data keep their values, less a base
/// where they lie far from zero.
struct VolumeCoding {
  gl::Format format = gl::Format::R32F;  ///< or R8, or R16
  float texelScale = 1.0f;               ///< coded value per texel unit: 255, 65535 or 1
  bool integers = false;                 ///< coded values are integers
  bool asStored = false;                 ///< and the stored ones themselves
  double base = 0.0;
  double slope = 1.0, offset = 0.0;  ///< real = slope · coded + offset

  double codedFromReal(double real) const { return (real - offset) / slope; }
  /// An interval of real values in coded ones; a negative slope swaps the ends.
  ValueRange codedFromReal(ValueRange real) const;
};
VolumeCoding codingOf(const Volume& volume);

struct VolumeTexture : VolumeCoding {
  gl::Texture texture;
};

/// NaN becomes the volume's least value, ±Inf the ends of its range. Throws RenderError when the volume is larger than
/// the machine's 3-D textures.
VolumeTexture makeVolumeTexture(const ShownVolume& shown);

/// Gated normals for lighting (rendering/scene/Lighting.h), RGB10A2: a component v in -1..1 is stored as
/// round(511·v) + 511.
struct GradientTexture {
  gl::Texture texture;
  glm::ivec3 origin{0};  ///< index of the first texel's voxel
};
/// Over a box of voxels, with a layer of zeros around it where the volume goes on: a lookup outside, clamped to the
/// texture, finds no normal.
GradientTexture makeGradientTexture(const ShownVolume& shown, const std::optional<IndexBox>& box);

/// The volume smoothed and thinned by two along each axis that is finer than twice the finest spacing, for derivatives:
/// on noisy scans curvature needs a scale of more than a voxel. Binomial filter (1 3 3 1)/8 on thinned axes.
struct DerivativeVolume {
  gl::Texture texture;      ///< R16 or R32F
  double texelScale = 1.0;  ///< real value per texel unit
  glm::ivec3 factor{1};     ///< voxels per texel along each axis
  double spacing = 1.0;     ///< mm, the finest texel spacing: the scale of the derivatives
};
DerivativeVolume makeDerivativeVolume(const ShownVolume& shown);

}  // namespace fenestra
