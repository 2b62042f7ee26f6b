#include "io/MaskFolder.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/ImageLabels.h"
#include "io/base/NaturalOrder.h"
#include "io/base/VolumeEnding.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// A stretch of voxels in the order of the grid.
struct Run {
  std::size_t begin = 0, length = 0;
};

struct Structure {
  Label label;
  std::vector<Run> runs;
  std::uint64_t voxels = 0;
};

std::string nameOf(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.size() - volumeEnding(file).size());
}

/// The voxels of a mask; empty where the values are not 0 and one other.
std::optional<Structure> structureIn(const std::vector<std::uint16_t>& values) {
  Structure structure;
  std::uint16_t inside = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == 0) continue;
    if (inside == 0) inside = values[i];
    if (values[i] != inside) return std::nullopt;
    ++structure.voxels;
    if (!structure.runs.empty() && structure.runs.back().begin + structure.runs.back().length == i)
      ++structure.runs.back().length;
    else
      structure.runs.push_back({i, 1});
  }
  return structure;
}

/// A file's mask on `target`. Throws Error for what is no image file, whatever its name.
LabelsOnGrid maskIn(const fs::path& file, const Grid& target, const Progress& progress, bool allowOutside) {
  const Format format = formatOf(file);
  if (format == Format::Dicom || format == Format::Archive)
    throw Error(file, format == Format::Dicom ? "is DICOM" : "is an archive", "open it as labels by itself");
  return readImageLabels(file, format, target, progress, allowOutside);
}

/// Adds a warning, or its files to one of the same text: masks of a folder mostly share what is odd.
void addWarning(Warning warning, std::vector<Warning>& warnings) {
  const auto same = std::find_if(warnings.begin(), warnings.end(), [&](const Warning& each) {
    return each.kind == warning.kind && each.text == warning.text;
  });
  if (same == warnings.end())
    warnings.push_back(std::move(warning));
  else
    same->files.insert(same->files.end(), warning.files.begin(), warning.files.end());
}

/// What was left out, and why.
struct LeftOut {
  std::vector<fs::path> files;
  std::string why;  ///< of the first

  void add(const fs::path& file, const std::string& cause) {
    if (files.empty()) why = file.filename().string() + " " + cause;
    files.push_back(file);
  }
};

}  // namespace

std::vector<fs::path> maskFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure)) {
    std::error_code unknown;
    const std::string_view ending = volumeEnding(entry->path());
    // A pair is named by its header.
    if (entry->is_regular_file(unknown) && !ending.empty() && ending != ".img") files.push_back(entry->path());
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return isBeforeNaturally(a.filename().string(), b.filename().string());
  });
  return files;
}

LabelsOnGrid readMaskFolder(const fs::path& folder, const Grid& target, const Progress& progress, bool allowOutside) {
  const std::vector<fs::path> files = maskFiles(folder);
  if (files.size() > greatestLabel)
    throw Error(folder, "holds " + std::to_string(files.size()) + " files, more than fit 16 bits", "split the folder");
  LabelsOnGrid read;
  std::vector<Structure> structures;
  LeftOut leftOut;
  LabelOverlap overlap;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto part = [&](std::size_t at) { return static_cast<double>(at) / static_cast<double>(files.size()); };
    const Progress own = partOf(progress, part(i), part(i + 1));
    if (own && !own(0.0, "reading masks")) throw Cancelled();
    try {
      LabelsOnGrid mask = maskIn(files[i], target, own, allowOutside);
      std::optional<Structure> structure = structureIn(mask.values);
      if (!structure) {
        leftOut.add(files[i], "holds several labels");
        continue;
      }
      structure->label = {static_cast<std::uint16_t>(structures.size() + 1), nameOf(files[i]), noColour};
      overlap.add(structure->label.value, structure->voxels);
      structures.push_back(std::move(*structure));
      for (Warning& warning : mask.warnings) addWarning(std::move(warning), read.warnings);
    } catch (const Error& error) {
      leftOut.add(files[i], error.cause());
    }
  }
  if (structures.empty())
    throw Error(folder, "holds no mask that can be read (" + leftOut.why + ")",
                "name a folder with one file of 0 and 1 for each structure, or one label map");
  if (!leftOut.files.empty())
    read.warnings.push_back({Warning::Kind::UnreadableFiles,
                             std::to_string(leftOut.files.size()) + " of " + std::to_string(files.size()) +
                                 " files left out, which are no masks of one structure (" + leftOut.why + ")",
                             leftOut.files});
  read.values.assign(target.voxelCount(), 0);
  for (const Structure& structure : structures) {
    read.labels.push_back(structure.label);
    for (const Run& run : structure.runs)
      for (std::size_t at = run.begin; at < run.begin + run.length; ++at)
        read.values[at] = overlap.keep(read.values[at], structure.label.value);
  }
  overlap.warn(folder, read.labels, read.warnings);
  return read;
}

}  // namespace fenestra::io
