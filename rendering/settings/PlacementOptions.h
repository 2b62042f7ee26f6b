#pragma once
// How the best view and its complement are chosen: the user's weights, and where the second camera may be.

#include <cstdint>

namespace fenestra::placement {

/// Quality = Σ weight · descriptor. The paper's depth term prefers views through more context when its weight is
/// positive. The defaults are among those with which the pair sees most of the surface of the structures that
/// tests/bench/results measures: a heavy depth weight of either sign draws both cameras to one side of the focus. The
/// small weight that remains decides between opposite views, whose outlines are the same: it prefers the nearer side,
/// where less is cut away. A small positive weight would let C1 see slightly more.
struct Weights {
  double visibility = -0.02, coverage = 16.0, location = 0.5;
  double entropy = 0.0, mutualInformation = 0.0, stability = 0.0;
  double orientation = 0.02;  ///< small: among equally good views the one nearest to a standard view is taken
  double endFace = -1.0;      ///< 0: end faces are not measured
  bool operator==(const Weights&) const = default;
};

/// Where C2 may be. In both regions it stays between 60° and 120° from C1, so that the two views differ.
enum class Region : std::uint8_t {
  Stream,      ///< the band |c·c1| ≤ sin δ
  SemiSphere,  ///< the half sphere c·a ≥ 0 around C1's right axis a
};

/// Where a person would look from, beside what shows most (rendering/viewpoints/Habits.h). All off: the paper's
/// placement, which knows the focus alone.
struct Habits {
  bool avoidCutEnds = true;   ///< not through an end of the scan where the body goes on
  bool uprightFirst = true;   ///< from around the patient rather than from above or below, at equal worth
  bool flatFromFront = true;  ///< a thin stack of slices from its front
  bool nearSideFirst = true;  ///< from the side of the body that the focus is nearer to, at equal worth
  bool operator==(const Habits&) const = default;
};
inline constexpr Habits noHabits{false, false, false, false};

struct Options {
  Weights weights;
  Habits habits;
  Region region = Region::SemiSphere;
  double streamHalfWidth = 15.0;  ///< δ, degrees; more than 30 is as 30
  double shareWeight = 0.8;       ///< joint search: 1 for the share of the surface alone, 0 for the mean quality alone
  bool operator==(const Options&) const = default;
};

/// Rating of a view of a picked point (rendering/viewpoints/LiveSync.h) = Σ weight · score / Σ weight. The published
/// method names no numbers; these are a choice: a radiologist's habits, the shape and what hides it count alike, and
/// the way from the last view decides between views that are nearly as good.
struct LiveSyncWeights {
  double orientation = 1.0, history = 0.5, shape = 1.0, visibility = 1.0;
  bool operator==(const LiveSyncWeights&) const = default;
};

struct LiveSyncOptions {
  LiveSyncWeights weights;
  double reach = 40.0;  ///< mm: how far from the picked point its structure counts
  bool operator==(const LiveSyncOptions&) const = default;
};

/// Whether both cameras are searched at once unless the user asks for the paper's order, first C1 and then C2.
inline constexpr bool jointByDefault = true;

}  // namespace fenestra::placement
