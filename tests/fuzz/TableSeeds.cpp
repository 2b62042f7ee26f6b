#include "tests/fuzz/TableSeeds.h"

#include <algorithm>
#include <array>

#include "tests/io/IoTesting.h"

namespace fenestra::fuzz {
namespace fs = std::filesystem;
namespace {

struct Ending {
  const char* ending;
  const char* target;
};
constexpr std::array volumeEndings{Ending{".dcm", "dicom"},     Ending{".acr", "dicom"},     Ending{".nii", "nifti"},
                                   Ending{".gz", "nifti"},      Ending{".nrrd", "nrrd"},     Ending{".nhdr", "nrrd"},
                                   Ending{".mhd", "metaimage"}, Ending{".mha", "metaimage"}, Ending{".mgh", "mgh"},
                                   Ending{".mgz", "mgh"},       Ending{".tif", "tiff"},      Ending{".zip", "archive"}};
constexpr std::array tableEndings{".txt", ".tsv", ".csv", ".label", ".ctbl", ".lut", ".any"};

/// The target for what a row opens; empty where none suits.
std::string_view targetOf(const tests::Defect& row, const fs::path& path) {
  const bool labels = !row.labelsOf.empty();
  if (!fs::is_directory(path)) {
    if (labels) return "labels";
    for (const auto& [ending, target] : volumeEndings)
      if (path.extension() == ending) return target;
    return {};
  }
  if (labels) return "masks";
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".tif") return "tiff-folder";
  return "dicom-series";
}

void addFile(const fs::path& path, std::vector<std::string>& seeds) {
  constexpr std::uintmax_t most = 1'000'000;
  if (fs::is_regular_file(path) && fs::file_size(path) <= most) seeds.push_back(tests::readFile(path));
}

void addRow(const Target& target, const tests::Defect& row, const fs::path& folder, std::vector<std::string>& seeds) {
  const fs::path path = row.make(folder);
  if (target.name == "label-table" && !row.labelsOf.empty()) {
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (std::find(tableEndings.begin(), tableEndings.end(), entry.path().extension()) != tableEndings.end())
        addFile(entry.path(), seeds);
    return;
  }
  if (!row.raw.empty() || targetOf(row, path) != target.name) return;
  if (fs::is_directory(path))
    seeds.push_back(packFolder(path));
  else
    addFile(path, seeds);
}

}  // namespace

std::vector<std::string> tableSeeds(const Target& target, const std::vector<tests::Defect>& rows) {
  std::vector<std::string> seeds;
  const fs::path folder = fs::temp_directory_path() / ("fenestra-table-seeds-" + std::string(target.name));
  for (const tests::Defect& row : rows) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    try {
      addRow(target, row, folder, seeds);
    } catch (const tests::MissingTestData&) {
    }
  }
  fs::remove_all(folder);
  return seeds;
}

}  // namespace fenestra::fuzz
