#pragma once
// Stage 5: the volume rendering integral from the ray start on, focus and context each with their own properties.

#include <optional>
#include <span>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"

namespace fenestra {

class FocusLayerPass {
 public:
  /// Where rays start in a cutaway; hitPoints tells cut faces from the focus and the context's own surface.
  struct Opening {
    const gl::Texture& hitPoints;
    const gl::Texture& rayStart;
  };
  /// How the integral is found: with a bound (of a pixel's colour, 0..1) cell by cell, else from face to face of the
  /// cells. Rays are followed on every pitch-th row and column of pixels (a power of two), and between them where
  /// interpolated pixels may be off by more than a tolerance. Half of it is what ends of rays may be off by.
  struct Sampling {
    std::optional<double> maxError{};
    int pitch = 1;
    double tolerance = 1.0 / 256.0;
    bool operator==(const Sampling&) const = default;
  };
  /// A pixel's result depends on the ray starts this many pixels around it: interpolated ones on those up to four half
  /// sides of the lattice's squares away, at each of its sizes; a cut face's normal on its neighbours.
  static int reach(const Sampling& sampling) { return 4 * (sampling.pitch - 1) + 1; }
  /// Writes premultiplied RGBA32F. Without an opening rays start where they enter the volume.
  void run(const GpuScene& gpu, const Look& look, const RayFrame& rays, const std::optional<Opening>& opening,
           const Sampling& sampling, std::span<const gl::Region> regions, gl::Texture& focusLayer);
  std::size_t bytes() const { return list_.bytes(); }

 private:
  struct Drawn {
    const GpuScene& gpu;
    const Look& look;
    const RayFrame& rays;
    const std::optional<Opening>& opening;
    const Sampling& sampling;
  };
  /// The variant that such a picture takes, for pixels of the lattice or listed ones, and the same with all that it
  /// reads.
  gl::ShaderProgram& program(bool listed, const Drawn& drawn);
  gl::ShaderProgram& prepared(bool listed, const Drawn& drawn);

  gl::ShaderVariants programs_{"FocusLayer.comp"}, between_{"PixelsBetween.comp"};
  gl::Buffer list_;  // of pixels between those of the lattice, while there are any
};

}  // namespace fenestra
