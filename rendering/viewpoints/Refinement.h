#pragma once
// From a coarse sphere of directions down to a fine one where it counts: finds what trying every fine direction finds,
// with a fraction of the images.

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "rendering/viewpoints/Placement.h"

namespace fenestra::placement {

/// Pixels of the NESTED sphere, level by level: from all 12·start² (start = 2^k) the children that promise most by what
/// is known around them, and the best one's neighbours, down to those of 12·finest²; first for C1 anywhere and on the
/// opposite side, then for C2 in C1's region. Tells what to measure next, so that who measures may pause in between;
/// deterministic. A focus that is not seen from any coarse direction ends it.
class Refinement {
 public:
  static constexpr std::size_t mostImages = 299;

  /// `points` of the focus's surface are what candidates may have seen; 0 when that is not measured.
  explicit Refinement(const Options& options, std::size_t points = 0, int start = 2, int finest = 32);

  /// Directions to measure next; empty when all is known.
  const std::vector<glm::dvec3>& wanted() const { return wanted_; }
  /// What is wanted only leads the way to finer levels: images of half the width tell enough.
  bool isLeading() const { return !wantedPixels_.empty() && 4 * wantedPixels_.front().nside <= finest_; }
  /// What wanted() asked for, in its order. Descriptors that depend on all candidates are found for the known ones,
  /// where they have a weight.
  void add(const std::vector<Candidate>& measured);
  /// Share of the images that it takes at most.
  double progress() const;

  /// All that was measured: the coarser directions, then those of the finest level from `coarser` on.
  std::vector<Candidate> candidates() const;
  std::size_t coarser() const;

 private:
  struct Pixel {
    int nside = 0;
    long index = 0;
    auto operator<=>(const Pixel&) const = default;
  };
  void plan();
  /// Asks for what is not known; false when there is any.
  bool have(int nside, const std::vector<long>& pixels);
  /// Down to the finest level for C1 (no `c1`) or for C2; false when something is to be measured first.
  bool descend(const std::optional<glm::dvec3>& c1);
  /// Of the children of a level's known pixels those that promise the best qualities.
  std::vector<long> promising(int nside, const std::optional<glm::dvec3>& c1) const;
  /// The quality that the coarser level lets expect of a pixel.
  double promiseOf(Pixel pixel, const std::optional<glm::dvec3>& c1) const;
  /// A pixel's middle; for C2 the place in the region that is nearest to it.
  glm::dvec3 placeOf(Pixel pixel, const std::optional<glm::dvec3>& c1) const;
  bool climb(int nside, const std::optional<glm::dvec3>& c1);
  /// Known pixels of a level that see the focus, and for C2 may hold directions of the region: best first.
  std::vector<long> ranked(int nside, const std::optional<glm::dvec3>& c1) const;
  bool mayHold(Pixel pixel, glm::dvec3 c1) const;
  double qualityAt(Pixel pixel) const;

  Options options_;
  std::size_t points_;
  int start_, finest_;
  std::map<Pixel, Candidate> known_;
  std::vector<Pixel> wantedPixels_;
  std::vector<glm::dvec3> wanted_;
};

}  // namespace fenestra::placement
