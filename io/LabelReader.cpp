#include "io/LabelReader.h"

#include <algorithm>
#include <map>
#include <optional>

#include "io/ImageLabels.h"
#include "io/LabelColours.h"
#include "io/LabelTable.h"
#include "io/MaskFolder.h"
#include "io/Probe.h"
#include "io/base/Archive.h"
#include "io/base/LabelReading.h"
#include "io/base/Memory.h"
#include "io/dicom/DicomLabels.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Where a label map is, what it is laid on, and how it is read; as in openLabels().
struct Request {
  const Grid& target;
  const Progress& progress;
  bool allowOutside;
  const fs::path& table;
};

bool isMaskFolder(const fs::path& path) {
  std::error_code unknown;
  return fs::is_directory(path, unknown) && !maskFiles(path).empty();
}

LabelsOnGrid readGrid(const fs::path& path, Format format, const Request& request) {
  if (isMaskFolder(path)) return readMaskFolder(path, request.target, request.progress, request.allowOutside);
  if (format == Format::Dicom) return readDicomLabels(path, request.target, request.progress);
  return readImageLabels(path, format, request.target, request.progress, request.allowOutside);
}

/// Names and colours by value: those of the table beside the map, then the file's own, then those of the chosen table.
/// A later name or colour replaces an earlier one. A program's whole table lists what maps may hold: rows of a long
/// table that this map has no voxel of are left out.
std::map<std::uint16_t, Label> namedLabels(const fs::path& path, const std::vector<Label>& own,
                                           const std::vector<bool>& present, const fs::path& chosen) {
  constexpr std::size_t longTable = 256;
  std::map<std::uint16_t, Label> labels;
  const auto add = [&](const std::vector<Label>& rows, bool isTable) {
    for (const Label& row : rows) {
      if (isTable && rows.size() > longTable && !present[row.value]) continue;
      Label& label = labels.try_emplace(row.value, Label{row.value, {}, noColour}).first->second;
      if (!row.name.empty()) label.name = row.name;
      if (row.colour != noColour) label.colour = row.colour;
    }
  };
  if (const fs::path beside = tableBeside(path); !beside.empty()) add(readLabelTable(beside), true);
  add(own, false);
  if (chosen.empty()) return labels;
  const std::vector<Label> rows = readLabelTable(chosen);
  if (rows.empty())
    throw Error(chosen, "is no table of labels",
                "name a table of ITK-SNAP, FreeSurfer, 3D Slicer or BIDS, or one with lines of a number and a name");
  add(rows, true);
  return labels;
}

OpenedLabels readLabels(const fs::path& path, Format format, const Request& request) {
  LabelsOnGrid read = readGrid(path, format, request);
  const Grid& target = request.target;
  const std::vector<std::uint16_t>& values = read.values;
  std::vector<bool> present(greatestLabel + 1u, false);
  for (const std::uint16_t value : values) present[value] = true;
  std::map<std::uint16_t, Label> labels = namedLabels(path, read.labels, present, request.table);
  for (std::uint32_t value = 1; value <= greatestLabel; ++value) {
    const auto label = static_cast<std::uint16_t>(value);
    if (present[label] && (!labels.contains(label) || labels[label].name.empty()))
      labels[label] = {label, "label " + std::to_string(label),
                       labels.contains(label) ? labels[label].colour : noColour};
  }

  OpenedLabels opened;
  opened.warnings = std::move(read.warnings);
  auto map = std::make_shared<LabelMap>();
  map->grid = target;
  for (auto& [value, label] : labels) {
    if (label.colour == noColour) label.colour = labelColour(value, label.name);
    map->labels.push_back(std::move(label));
  }
  const auto greatest = values.empty() ? 0 : *std::max_element(values.begin(), values.end());
  map->voxels = Voxels(greatest <= 255 ? ScalarType::UInt8 : ScalarType::UInt16, values.size());
  if (greatest <= 255)
    std::transform(values.begin(), values.end(), map->voxels.as<std::uint8_t>().begin(),
                   [](std::uint16_t value) { return static_cast<std::uint8_t>(value); });
  else
    std::copy(values.begin(), values.end(), map->voxels.as<std::uint16_t>().begin());
  opened.labels = std::move(map);
  return opened;
}

/// Where a label map is.
struct Place {
  Format format = Format::Archive;
  fs::path archive = {};  ///< that holds it: `path` itself, or the one that it leads into
};
Place placeOf(const fs::path& path) {
  if (std::optional<ArchiveMember> member = archiveMember(path)) {
    checkExists(member->archive);
    return {Format::Archive, std::move(member->archive)};
  }
  checkExists(path);
  return {formatOf(path), path};
}

/// The label map in an unpacked archive: the one that `path` names, or the archive's only file.
fs::path labelMapIn(const UnpackedArchive& archive, const fs::path& path) {
  if (const auto member = archiveMember(path)) {
    const fs::path inside = archive.folder() / member->inside;
    if (std::error_code unknown; !fs::is_regular_file(inside, unknown))
      throw Error(path, "is not in the archive", "check the path");
    return inside;
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(archive.folder()))
    if (entry.is_regular_file()) files.push_back(entry.path());
  if (files.size() != 1)
    throw Error(path, "is an archive of " + std::to_string(files.size()) + " files",
                "name the label map in it, as " + (path / "FILE").string());
  return files.front();
}

OpenedLabels readArchivedLabels(const fs::path& archivePath, const fs::path& path, const Request& request) {
  const UnpackedArchive archive(archivePath, request.progress);
  try {
    const fs::path file = labelMapIn(archive, path);
    const Format format = formatOf(file);
    if (format == Format::Archive) throw Error(file, "is an archive in an archive", "unpack it and open what it holds");
    OpenedLabels opened = readLabels(file, format, request);
    renameFiles(opened.warnings, [&](const fs::path& unpacked) { return archive.named(unpacked); });
    return opened;
  } catch (const Error& error) {
    throw Error(archive.named(error.file()), error.cause(), error.hint());
  }
}

}  // namespace

std::vector<fs::path> labelFiles(const fs::path& path, bool allowOutside) {
  return withinMemory(path, [&]() -> std::vector<fs::path> {
    const Place place = placeOf(path);
    if (place.format == Format::Archive) return {place.archive};
    if (isMaskFolder(path)) return maskFiles(path);
    if (place.format == Format::Dicom) return {path};
    return readImageHeader(path, place.format, allowOutside).source.files;
  });
}

OpenedLabels openLabels(const fs::path& path, const Grid& target, const Progress& progress, bool allowOutside,
                        const fs::path& table) {
  return withinMemory(path, [&] {
    const Request request{target, progress, allowOutside, table};
    const Place place = placeOf(path);
    if (place.format == Format::Archive) return readArchivedLabels(place.archive, path, request);
    return readLabels(path, place.format, request);
  });
}

}  // namespace fenestra::io
