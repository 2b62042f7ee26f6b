#pragma once
// Places both cameras for a scene's focus. What was rendered is kept: another weight, region or C1 renders nothing.

#include <optional>
#include <vector>

#include "rendering/placement/CandidateImages.h"
#include "rendering/viewpoints/Choice.h"
#include "rendering/viewpoints/Refinement.h"

namespace fenestra::placement {

class Placer {
 public:
  /// Measures the candidates of the scene's focus, or returns what it measured before: again only when the volume, the
  /// focus, the sampling, or (refined) the options changed. `gpu` is brought up to date. Needs a current context.
  const Measured& measure(GpuScene& gpu, const Scene& scene, const Sampling& sampling, const Options& options);
  /// The next measure() measures anew.
  void forget() { key_.reset(); }

  /// The same in slices, for a window that must answer in between: begin(), then advance() until it is true, then
  /// measured(). Another begin() drops what was under way; `gpu`'s volume and focus stay as they are meanwhile.
  void begin(GpuScene& gpu, const Scene& scene, const Sampling& sampling, const Options& options);
  /// Measures `count` candidates more, or one beyond that shares its image. True when all are measured.
  bool advance(const GpuScene& gpu, std::size_t count);
  /// Share of the candidates that are measured; of a refinement, of those that it takes at most.
  double progress() const;
  const Measured& measured() const { return measured_; }

 private:
  struct Key {
    std::uint64_t volume = 0, focus = 0;
    Sampling sampling;
    std::optional<Options> options;  ///< a refinement follows them
    bool operator==(const Key&) const = default;
  };
  /// Directions to be measured, each next to its opposite where that is among them.
  struct Batch {
    std::vector<glm::dvec3> directions;
    std::vector<std::size_t> order;
    std::vector<Candidate> measured;  ///< as `directions`
    std::size_t done = 0;             ///< of `order`

    explicit Batch(std::vector<glm::dvec3> wanted = {});
    bool isDone() const { return done == order.size(); }
  };
  /// What begin() began.
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
