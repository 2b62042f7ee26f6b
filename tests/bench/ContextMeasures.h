#pragma once
// What a method leaves of the context, and where its picture shows structures in the wrong order of depth: over rays
// through some of a picture's pixels, from where the picture's rays start and what its method does on them
// (MethodStages). Two methods of one view share the samples.
//
// At a point of a ray the method leaves the share k of the context's extinction κ:
//
//   k = 1 behind the ray's start, w before it        where it opens (w of MethodStages; 0 where nothing stays)
//   k = m                                            where the context fades; of a ghost, before the ray's start alone
//   k = 1                                            where nothing is opened
//
// The context's volume kept is the mean of k over the context in the picture, by extinction: ∫ k κ dV / ∫ κ dV. Its
// surface kept is the same in a skin of one finest spacing behind the context's first hit, of the pixels whose ray
// meets context first: each by its area across the ray.
//
// An outline of the focus is a pixel p that shows some of it, beside a pixel q whose ray misses it and meets context. A
// picture's outlines say what lies in front: it belongs to the nearer of the two things that it parts (a figure before
// its ground), so p's focus is taken to lie before what q shows. Where q shows more than p of what lies nearer than
// half way from q's first hit to p's focus, that is wrong, by the difference of these opacities:
//
//   e = max(0, a_q(h) - a_p(h)),   h = (t_context(q) + t_focus(p)) / 2,   a(h): the opacity of the context before h
//
// which counts by how much of the focus p shows. What lies over both, like a film that keeps its place, is in no wrong
// order, and the wall of an opening that rises to the surface over two pixels or more is none, either: it begins at the
// focus.

#include <optional>
#include <vector>

#include "rendering/scene/Fading.h"
#include "tests/bench/RaySamples.h"

namespace fenestra::bench {

/// The effect of a picture's method along its rays; elements are pixels, row by row from the top.
struct MethodRays {
  std::vector<float> starts;  ///< t, mm; of a ghost, where it ends; empty: rays start where they enter
  std::vector<float> shares;  ///< w, of what lies before the starts; empty: nothing of it stays
  std::optional<MethodStages::Fading> fading{};
};

/// w of a lens at each pixel, from where rays meet context and focus and from what Layers::lens holds: the surface's
/// normal and its distance in mm from the lens's middle. `radius` is in mm.
std::vector<float> lensShares(const MethodStages::Lens& lens, double radius, glm::ivec2 size,
                              const std::vector<float>& tContext, const std::vector<float>& tFocus,
                              const std::vector<glm::vec4>& surfaces);

struct ContextKept {
  double volume = 1.0, surface = 1.0;
};

struct DepthOrder {
  double wrong = 0.0;  ///< mean e over the outlines that the picture shows; 0 without any
  /// Pairs of a structure in focus and the one of the context that shows most beside its outline: those whose mean e is
  /// above a half, and all. A pair counts where it shows half a pixel of the sampled outline or more.
  int wrongPairs = 0, pairs = 0;
};

/// Rays of one view.
class ViewSamples {
 public:
  struct Sampling {
    int step = 4;        ///< of every so many pixels along either side one ray for what is kept
    int outlines = 200;  ///< about so many places of the focus's outlines, evenly along them; fewer where there are
  };
  /// `tContext` and `tFocus`: where the rays of the view's pixels first meet anything, and the focus; NaN where they do
  /// not. `sampler` must outlive it.
  ViewSamples(const RaySampler& sampler, const Camera& camera, glm::ivec2 size, const std::vector<float>& tContext,
              const std::vector<float>& tFocus, Sampling sampling);

  ContextKept kept(const MethodRays& method) const;
  DepthOrder order(const MethodRays& method) const;
  /// The opacity that the method's picture has at each pixel of the grid, without lines and borders; for tests.
  std::vector<double> opacities(const MethodRays& method) const;

 private:
  struct GridRay {
    std::size_t pixel;
    double area;  ///< in mm² across the ray at t = 1 mm, up to a factor; where rays are parallel, at any t
    bool meetsContextFirst;
    SampledRay sampled;
  };
  struct Outline {
    std::size_t inside, outside;  ///< pixels p and q
    SampledRay p, q;
  };
  class Along;

  void addGrid(glm::ivec2 size, int step, const std::vector<float>& tContext, const std::vector<float>& tFocus);
  void addOutlines(glm::ivec2 size, int most, const std::vector<float>& tContext, const std::vector<float>& tFocus);
  double areaAt(const GridRay& ray, double t) const;

  const RaySampler& sampler_;
  Camera camera_;
  EyeRange eyeRange_;
  std::vector<float> tContext_, tFocus_;
  std::vector<GridRay> grid_;
  std::vector<Outline> outlines_;
};

}  // namespace fenestra::bench
