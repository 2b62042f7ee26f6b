#pragma once
// Hierarchical search of the sphere of directions: finds the views that an exhaustive search of a fine sphere finds,
// with a fraction of the images.

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "rendering/viewpoints/Placement.h"

namespace fenestra::placement {

/// Starts with all 12·start² pixels of the NESTED sphere (start = 2^k). On each finer level, down to 12·finest², it
/// takes the children of the greatest predicted worth, then the neighbours of the best one: first for C1 on the whole
/// sphere and its opposite side, then for C2 in C1's region. wanted() tells what to measure next, so that the caller
/// may pause in between. Deterministic. Ends at once when no coarse direction sees the focus.
class Refinement {
 public:
  static constexpr std::size_t mostImages = 299;

  /// `points`: the number of the focus's surface points; 0 when seen points are not measured.
  explicit Refinement(const Options& options, std::size_t points = 0, int start = 2, int finest = 32);

  /// Directions to measure next; empty when the search is done.
  const std::vector<glm::dvec3>& wanted() const { return wanted_; }
  /// Whether wanted() is of a level two or more above the finest, where images of half the width are accurate enough.
  bool isLeading() const { return !wantedPixels_.empty() && 4 * wantedPixels_.front().nside <= finest_; }
  /// Takes the candidates of wanted(), in its order. Descriptors that depend on all candidates are found again where
  /// they have a weight.
  void add(const std::vector<Candidate>& measured);
  /// Images measured, over the most that it may take; 1 when done.
  double progress() const;

  /// All measured candidates: the coarser levels first, the finest level from `coarser` on.
  std::vector<Candidate> candidates() const;
  std::size_t coarser() const;

 private:
  struct Pixel {
    int nside = 0;
    int index = 0;
    auto operator<=>(const Pixel&) const = default;
  };
  void plan();
  /// Adds the unmeasured ones of `pixels` to wanted(); true when wanted() stays empty.
  bool have(int nside, const std::vector<int>& pixels);
  /// Searches down to the finest level for C1 (no `c1`) or for C2; false when measurements are missing.
  bool descend(const std::optional<glm::dvec3>& c1);
  /// The pixels of a level with the best predicted quality, among the children of measured ones.
  std::vector<int> promising(int nside, const std::optional<glm::dvec3>& c1) const;
  /// A pixel's quality as predicted from the coarser level.
  double promiseOf(Pixel pixel, const std::optional<glm::dvec3>& c1) const;
  /// A pixel's centre; for C2 the direction of the pixel in C1's region that is nearest to it.
  glm::dvec3 placeOf(Pixel pixel, const std::optional<glm::dvec3>& c1) const;
  bool climb(int nside, const std::optional<glm::dvec3>& c1);
  /// Measured pixels of a level that see the focus and, for C2, overlap C1's region; best first.
  std::vector<int> ranked(int nside, const std::optional<glm::dvec3>& c1) const;
  bool mayHold(Pixel pixel, glm::dvec3 c1) const;
  /// Which of the measured views may be chosen, for C2 those of C1's region.
  CutEndRule ruleFor(const std::optional<glm::dvec3>& c1) const;
  bool admits(const CutEndRule& rule, Pixel pixel) const;

  Options options_;
  std::size_t points_;
  int start_, finest_;
  std::map<Pixel, Candidate> known_;
  std::vector<Pixel> wantedPixels_;
  std::vector<glm::dvec3> wanted_;
};

}  // namespace fenestra::placement
