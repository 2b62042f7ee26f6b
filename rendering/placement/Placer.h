#pragma once
// Places both cameras for a scene's focus. Measurements are kept, so that another weight, region or C1 needs no
// rendering.

#include <optional>
#include <vector>

#include "rendering/placement/CandidateImages.h"
#include "rendering/viewpoints/Choice.h"
#include "rendering/viewpoints/Refinement.h"

namespace fenestra::placement {

class Placer {
 public:
  /// Measures the candidates of the scene's focus, or returns what it measured before: again only when the volume, the
  /// focus, what clips it, the sampling, (refined) the options, or (where end faces have a weight) the context's
  /// visible values changed. `gpu` is brought up to date. Needs a current context.
  const Measured& measure(GpuScene& gpu, const Scene& scene, const Sampling& sampling, const Options& options);
  /// The next measure() measures anew.
  void forget() { key_.reset(); }

  /// Measures in slices, so that a window stays responsive: begin(), then advance() until it returns true, then
  /// measured(). Another begin() cancels the one before. `gpu`'s volume and focus must not change in between.
  void begin(GpuScene& gpu, const Scene& scene, const Sampling& sampling, const Options& options);
  /// Measures `count` more candidates, and the opposite of the last one with it, as they share an image. True when all
  /// are measured.
  bool advance(const GpuScene& gpu, std::size_t count);
  /// Share of the candidates that are measured; a refinement counts against the most candidates it may take.
  double progress() const;
  const Measured& measured() const { return measured_; }

 private:
  struct Key {
    std::uint64_t volume = 0, focus = 0;
    Sampling sampling;
    std::optional<Options> options;     ///< a refinement follows them
    std::optional<std::uint64_t> gaps;  ///< of the context, where end faces were measured
    std::vector<HalfSpace> kept;        ///< what clips the scene
    bool operator==(const Key&) const = default;
  };
  /// Directions to measure; `order` puts opposite ones next to each other.
  struct Batch {
    std::vector<glm::dvec3> directions;
    std::vector<std::size_t> order;
    std::vector<Candidate> measured;  ///< as `directions`
    std::size_t done = 0;             ///< of `order`

    explicit Batch(std::vector<glm::dvec3> wanted = {});
    bool isDone() const { return done == order.size(); }
  };
  /// A measurement under way.
  struct Task {
    Key key;
    FocusSurface surface;
    std::optional<Refinement> refinement;
    Batch batch;
    bool standard = false;  ///< the batch is, or ends in, the standard views
    Measured measured;
  };
  void finish();

  std::optional<Key> key_;
  Measured measured_;
  std::optional<Task> task_;
  CandidateImages images_;
};

}  // namespace fenestra::placement
