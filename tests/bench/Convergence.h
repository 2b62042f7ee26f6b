#pragma once
// How the cameras settle as more candidate views are measured (the paper's Figure 7): C1 and C2 for a growing number N
// of directions, and for the hierarchical refinement, against the answer of a far finer sphere.
//
// All by the focus alone, as in the paper: without habits, first C1 and then C2. Default weights and region.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "tests/bench/Chart.h"
#include "tests/bench/PlacementSubjects.h"

namespace fenestra::bench {

/// The angle between two directions.
double degreesBetween(glm::dvec3 a, glm::dvec3 b);

/// N, each 12·nside².
inline constexpr std::array<int, 10> candidateCounts{12, 48, 108, 192, 300, 432, 588, 768, 972, 1200};

/// Degrees from the converged cameras, and how much of their qualities is lost.
struct Deviation {
  double c1 = 0.0, c2 = 0.0, lost = 0.0, lostByC2 = 0.0;
};

struct Convergence {
  std::string name;
  int side = 0;                                        ///< pixels of the images
  double error = 0.0;                                  ///< of qualities, by images four times as fine
  std::array<Deviation, candidateCounts.size()> of{};  ///< for each of candidateCounts
  Deviation refined;
  std::size_t refinedImages = 0;
};

/// The least N from which on the deviation stays within `limit` up to the greatest N; empty where the greatest N does
/// not keep it.
std::optional<int> settledFrom(const Convergence& measured, double Deviation::*deviation, double limit);

/// A camera's degrees against N, a line for each; the refinement at its number of images, as a ring.
Chart convergenceChart(const std::vector<Convergence>& measured, double Deviation::*angle, const std::string& camera);

/// Writes convergence.md and its charts, convergence-c1.svg and convergence-c2.svg, of paperSubjects(), and tables of
/// these and structures(), for those whose names hold `part`. Needs a current context; `gl` describes it. Written anew
/// after each structure.
void writeConvergencePage(const std::filesystem::path& folder, const std::string& part, const std::string& gl);

}  // namespace fenestra::bench
