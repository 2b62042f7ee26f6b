#pragma once
// Places both cameras for a scene's focus. What was rendered is kept: another weight, region or C1 renders nothing.

#include <optional>
#include <string>
#include <vector>

#include "rendering/placement/CandidateImages.h"
#include "rendering/placement/Refinement.h"

namespace fenestra::placement {

/// How candidates are spread.
struct Sampling {
  int count = 192;                          ///< 12·nside²
  bool refined = false;                     ///< instead: hierarchically from 48 to the resolution of 12 288
  int side = CandidateImages::defaultSide;  ///< pixels across the model in a candidate's image, at least
  int surfacePoints = 1024;                 ///< shares are known to about a hundredth by so many
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
  std::size_t coarser = 0;  ///< refined: the first ones, which only led the way
  /// Refined for these: by them choose() takes finest ones, as trying all would; by others, whatever is best.
  std::optional<Options> refinedFor;
  std::size_t spread = 0;  ///< how many of them are spread; the standard views serve comparisons and the joint search
  std::size_t surfacePoints = 0;
  double surfaceArea = 0.0;  ///< mm²
};

/// The paper's order: the best view, then the best of its region. `joint`: both at once (jointSearch), the standard
/// views among the candidates. Costs no rendering. A focus that looks the same from everywhere gets the first direction
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
