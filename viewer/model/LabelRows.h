#pragma once
// What is told of each label in a table, and that table as a file.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <QString>

#include "rendering/volume/LabelStatistics.h"

namespace fenestra::viewer {

struct LabelRow : LabelStatistics {
  std::string name;
  glm::dvec3 place{0.0};  ///< of a voxel near the label's middle, world (LPS) mm; see placesWithin()
};

/// A row for each label that has voxels, by value. Reads all voxels, on all cores.
std::vector<LabelRow> labelRows(const LabelMap& labels, const Volume& volume);

/// The shares of a label's surface that C1 and C2 see; see PlacementController::share().
struct SeenByCameras {
  std::optional<double> c1, c2;
};

/// A table of RFC 4180 with a header; numbers have a decimal point in every language. Places and boxes are those of the
/// patient (LPS), mm. `seen` has an element for each row. What is not known is an empty field.
QString labelsCsv(const std::vector<LabelRow>& rows, const std::vector<SeenByCameras>& seen, const std::string& unit);

}  // namespace fenestra::viewer
