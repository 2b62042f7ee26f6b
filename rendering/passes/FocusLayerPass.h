#pragma once
// Stage 5: the volume rendering integral from the ray start on, focus and context each with their own properties.

#include <optional>
#include <vector>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/gpu/SceneVariant.h"
#include "rendering/gpu/Uniforms.h"
#include "rendering/passes/Steps.h"

namespace fenestra {

/// Emission and absorption along a ray from its start s0:
///
///   C = ∫ c κ exp(-∫ κ ds') ds   over s0 ≤ s ≤ s_out
///
/// Let v be the trilinearly interpolated value at a point. Outside the focus, colour c and extinction κ are the
/// context's transfer function of v. In the focus they are one material of the focus, or where it has a function
/// (focusFunction()), that function of v; of a focus of labels, the nearest voxel tells the label whose material or
/// function it is. Where the context fades, its extinction is multiplied by m of MethodStages::Fading, which needs a
/// sampling with a bound on the error. What is focus does not depend on a function: hits and ray starts are those of
/// the same focus of one material. Both are lit as the focus is. Where the context shows by its greatest value
/// (MaximumPass), the integral is that of the focus alone, within a bound on the error.
class FocusLayerPass {
 public:
  explicit FocusLayerPass(const gl::SharedPrograms& programs = std::make_shared<gl::ComputePrograms>())
      : programs_("FocusLayer.comp", programs),
        apart_("FocusLayerApart.comp", programs),
        exploded_("FocusLayerExploded.comp", programs),
        quincunxBetween_("QuincunxBetween.comp", programs),
        centresBetween_("CentresBetween.comp", programs),
        sidesBetween_("SidesBetween.comp", programs) {}
  /// Where rays start in a cutaway; hitPoints tells cut faces from the focus and the context's own surface. Where the
  /// opening is ghosted, rays start where they enter the volume instead, and rayStart is where their ghost ends.
  struct RayStarts {
    const gl::Texture& hitPoints;
    const gl::Texture& rayStart;
    /// Where another camera cuts the opening; see RemovedPass. Needs a sampling with a bound on the error.
    const gl::Texture* hole = nullptr;
    /// With scattered rays, to which the other textures belong: the ray starts of the picture's pixels. They tell the
    /// cut face's normal.
    const gl::Texture* pixelStarts = nullptr;
  };
  /// How the integral is found: cell by cell within a bound on the error of a pixel's colour (0..1), or without one
  /// from face to face of the cells. Rays are traced through every pitch-th pixel of every pitch-th row (a power of
  /// two); of a quincunx, which has a pitch of 2, also through the pixels in the middle between four of those. A pixel
  /// between them is interpolated where the estimated error is within `tolerance`, else it gets a ray of its own. Early
  /// ray termination may change a colour by half the tolerance, of lit pictures by three times the tolerance.
  struct Sampling {
    std::optional<double> maxError{};
    int pitch = 1;
    bool quincunx = false;
    double tolerance = 1.0 / 256.0;
    /// Where the context fades: whether the errors of its steps are guessed, not estimated. No bound is kept then.
    bool roughSteps = false;
    bool operator==(const Sampling&) const = default;
  };
  /// The bound of pictures of draft or normal quality, for which none is asked, where only the integral within a bound
  /// can draw what they show.
  static constexpr double usualBound = 4.0 / 255.0;
  /// This sampling, but with a ray through every pixel.
  static Sampling followingEveryRay(const Sampling& sampling) {
    return {.maxError = sampling.maxError, .tolerance = sampling.tolerance, .roughSteps = sampling.roughSteps};
  }
  /// What a sampling means to the integrals.
  static IntegralUniforms integralUniforms(const GpuScene& gpu, const Sampling& sampling, bool lit);
  /// A pixel's result depends on the ray starts within this many pixels of it: an interpolated pixel on those up to
  /// four half sides of the lattice's squares away, at each size of the squares; a cut face's normal on the next
  /// pixels.
  static int reach(const Sampling& sampling) { return 4 * (sampling.pitch - 1) + 1; }
  /// Writes premultiplied RGBA32F. Without an opening rays start where they enter the volume. `occlusion`: of
  /// OcclusionPass; null: neither ambient occlusion nor shadows.
  void run(Steps& steps, const GpuScene& gpu, const Look& look, const RayFrame& rays,
           const std::optional<RayStarts>& opening, const Sampling& sampling, Regions regions, gl::Texture& focusLayer,
           const gl::Texture* occlusion = nullptr);

  /// What a stretch of the rays of an exploded view shows: a part of the context, up to the focus's first hit or from
  /// there on, or the focus.
  enum class Stretch : std::uint8_t { Before, InFocus, Behind };
  struct ExplodedStretch {
    Stretch shown = Stretch::Before;
    /// Rays of the picture's camera, moved back by the part's translation and clipped to the part.
    RayFrame rays;
    double fromPicture = 0.0;  ///< s on these rays less s on the picture's rays, where both see the same place
  };
  /// The layer of an exploded view (Explosion.h): these stretches, each behind those before it in the list. Needs a
  /// sampling with a bound on the error, of each of them. `focusHits`: hit points of the picture's rays; null without a
  /// focus.
  void runExploded(Steps& steps, const GpuScene& gpu, const Look& look, const std::vector<ExplodedStretch>& stretches,
                   const gl::Texture* focusHits, const Sampling& sampling, Regions regions, gl::Texture& focusLayer);
  std::size_t bytes() const { return list_.bytes(); }
  /// Drops the list of pixels.
  void release() { list_ = {}; }

 private:
  struct Drawn {
    const GpuScene& gpu;
    const Look& look;
    const RayFrame& rays;
    std::optional<RayStarts> opening;
    Sampling sampling;
    const gl::Texture* occlusion;
    const ExplodedStretch* stretch = nullptr;  ///< in an exploded view
    const gl::Texture* focusHits = nullptr;
    bool resumes = false;  ///< other stretches lie before it
  };
  static IntegralKind kindOf(const Drawn& drawn);
  /// The variant that such a picture takes, for pixels of the lattice or listed ones; and that with all that it reads.
  gl::ShaderProgram& program(bool listed, const Drawn& drawn);
  gl::ShaderProgram& prepared(bool listed, const Drawn& drawn);
  /// All that lies on the rays, from the front to the back.
  using Layers = std::vector<Drawn>;
  void add(Steps& steps, const Layers& layers, Regions regions, gl::Texture& focusLayer);
  /// Pixels between those of a lattice whose squares have sides of 2·halfSide: the squares' centres, or the middles of
  /// their sides, which need all centres. A quincunx needs the latter alone.
  void drawBetween(const Layers& layers, int halfSide, bool centres, Regions squares, gl::Texture& focusLayer);

  gl::ShaderVariants programs_, apart_, exploded_, quincunxBetween_, centresBetween_, sidesBetween_;
  gl::Buffer list_;  // pixels between those of the lattice that get a ray; empty when every pixel has one
};

}  // namespace fenestra
