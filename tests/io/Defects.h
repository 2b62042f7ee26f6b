#pragma once
// A table of damaged, incomplete and contradictory files: how each is made, and the error or warning that it must give.
// A row is added in DicomDefects.cpp (damage), DicomKindDefects.cpp (what writers do differently), FileDefects.cpp,
// MeaningDefects.cpp, TiffDefects.cpp, LabelDefects.cpp or LabelNameDefects.cpp.

#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/base/Reading.h"

namespace fenestra::tests {

enum class Outcome { Error, Warning, Opens };

/// The result that a defect must give: an error or a warning that holds `says`, or a volume without any warning.
struct Expected {
  Outcome outcome = Outcome::Opens;
  std::string says;
};
Expected error(std::string says);
Expected warning(std::string says);
inline const Expected opens{};

/// A defect is made from real data that are not here; what() is the file's name in the collection.
struct MissingTestData : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Defect {
  std::string name;
  /// Writes the files into an empty folder and returns the path to open. Throws MissingTestData.
  std::function<std::filesystem::path(const std::filesystem::path& folder)> make;
  Expected expected;
  std::string raw = {};                      ///< description of raw voxels
  std::optional<int> time = {};              ///< time point to open
  std::optional<glm::dvec3> spacing = {};    ///< mm, that the volume must have
  std::optional<glm::dvec3> told = {};       ///< mm, the size of voxels that the user says
  std::string labelsOf = {};                 ///< name of the volume beside the file, where the file holds labels
  std::string labelTable = {};               ///< name of the table beside the file that is chosen for them
  std::vector<std::string> labelNames = {};  ///< "value name" or "value name #rrggbb" of labels that the file must have

  io::OpenOptions options() const;
  /// The words after `fenestra-cli` that open `path`.
  std::vector<std::string> command(const std::filesystem::path& path) const;
};
std::ostream& operator<<(std::ostream& stream, const Defect& defect);
/// The name with what a test's name may hold.
std::string testNameOf(const Defect& defect);

std::vector<Defect> dicomDefects();
std::vector<Defect> dicomKindDefects();
std::vector<Defect> fileDefects();
/// Whole files whose headers mean something that a reader may get wrong: units, commas, axes.
std::vector<Defect> meaningDefects();
std::vector<Defect> tiffDefects();
std::vector<Defect> labelDefects();
/// Label maps with tables of names and colours, and folders of masks.
std::vector<Defect> labelNameDefects();
/// All of the above.
std::vector<Defect> allDefects();

}  // namespace fenestra::tests
