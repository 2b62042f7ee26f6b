#pragma once
// Places both cameras for a scene's focus. Measurements are kept, so that another weight, region or C1 needs no
// rendering.

#include <optional>
#include <string>
#include <vector>

#include "rendering/placement/CandidateImages.h"
#include "rendering/placement/Refinement.h"

namespace fenestra::placement {

/// How candidates are spread.
struct Sampling {
  int count = 192;                          ///< 12·nside²
  bool refined = false;                     ///< refine 48 directions to the resolution of 12 288 instead
  int side = CandidateImages::defaultSide;  ///< pixels across the model in a candidate's image, at least
  int surfacePoints = 1024;                 ///< gives shares to about a hundredth
  bool operator==(const Sampling&) const = default;
};

/// The cameras chosen among measured candidates; indices into Measured::candidates.
struct Placement {
  std::optional<std::size_t> c1, c2;
  double share = 0.0;  ///< of the focus's surface that at least one of the two sees
  std::string note;    ///< why there is no answer, or none that stands out; empty otherwise
};

/// The measured candidates of one focus: the spread ones, then the six standard views.
struct Measured {
  std::vector<Candidate> candidates;
  std::size_t coarser = 0;  ///< refined: how many at the front are of coarser levels
  /// The options that guided a refinement. By these choose() considers the finest level alone, as an exhaustive search
  /// would; by others, all candidates.
  std::optional<Options> refinedFor;
  std::size_t spread = 0;  ///< number of spread candidates; the standard views serve comparisons and the joint search
  std::size_t surfacePoints = 0;
  double surfaceArea = 0.0;  ///< mm²
};

/// In the paper's order: the best view, then the best view of its region. With `joint` both at once (jointSearch), the
/// standard views included. Needs no rendering. A focus that looks the same from everywhere gets the first direction
/// and a note.
Placement choose(const Measured& measured, const Options& options, bool joint);
/// C2 for a C1 anywhere on the sphere.
Placement chooseDual(const Measured& measured, glm::dvec3 c1, const Options& options);

class Placer {
 public:
  /// Measures the candidates of the scene's focus, or returns what it measured before: again only when the volume, the
  /// focus, the sampling, or (refined) the options changed. `gpu` is brought up to date. Needs a current context.
  const Measured& measure(GpuScene& gpu, const Scene& scene, const Sampling& sampling, const Options& options);
  /// The next measure() measures anew.
  void forget() { key_.reset(); }

  /// The same in slices, so that a window stays responsive: begin(), then advance() until it returns true, then
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
    std::optional<Options> options;  ///< a refinement follows them
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
