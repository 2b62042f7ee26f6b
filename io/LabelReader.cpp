#include "io/LabelReader.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "io/LabelColours.h"
#include "io/Probe.h"
#include "io/base/Archive.h"
#include "io/base/LabelReading.h"
#include "io/base/Memory.h"
#include "io/base/PlausibleGrid.h"
#include "io/base/Text.h"
#include "io/dicom/DicomLabels.h"
#include "io/formats/ImageFile.h"
#include "rendering/scene/Parallel.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// One segment of 3D Slicer's SegmentN_* fields (the "Segmentation" NRRD layout of 3D Slicer's documentation).
struct Segment {
  std::int64_t layer = 0;
  std::uint16_t storedValue = 0;
  Label label;
};

std::vector<Segment> slicerSegments(const ImageFile& image) {
  std::vector<Segment> segments;
  std::set<std::uint16_t> taken;
  for (int n = 0;; ++n) {
    const std::string prefix = "Segment" + std::to_string(n) + "_";
    const auto field = [&](const char* name) {
      const auto at = image.fields.find(prefix + name);
      return at == image.fields.end() ? std::string() : at->second;
    };
    if (field("ID").empty() && field("Name").empty() && field("LabelValue").empty()) return segments;
    Segment segment;
    // Files from before layers existed have neither field: one label a segment, counted from 1.
    const auto value = field("LabelValue").empty() ? std::optional<std::uint16_t>(static_cast<std::uint16_t>(n + 1))
                                                   : numberIn<std::uint16_t>(field("LabelValue"));
    if (!value || *value == 0)
      throw Error(image.path, "its " + prefix + "LabelValue is no label", "the file is damaged");
    segment.storedValue = *value;
    segment.layer = numberIn<std::int64_t>(field("Layer")).value_or(0);
    // Layers number their labels from 1 each: a value that another layer has gets the next free one.
    std::uint16_t unique = *value;
    while (taken.contains(unique)) {
      if (unique == greatestLabel)
        throw Error(image.path, "has more labels than fit 16 bits", "split the segmentation");
      ++unique;
    }
    taken.insert(unique);
    const auto colour = numbersIn<double>(field("Color"));
    segment.label = {unique, field("Name"), noColour};
    if (colour && colour->size() == 3)
      segment.label.colour = glm::clamp(glm::dvec3((*colour)[0], (*colour)[1], (*colour)[2]), 0.0, 1.0);
    segments.push_back(segment);
  }
}

/// Lines of "value name", divided by tabs or blanks, or with the name in quotes at the end (ITK-SNAP); other lines are
/// headings or comments.
std::map<std::uint16_t, std::string> readNameTable(const fs::path& path) {
  std::map<std::uint16_t, std::string> names;
  std::ifstream file(path);
  for (std::string text; std::getline(file, text);) {
    const std::string line = trimmed(text);
    const std::size_t end = line.find_first_of(" \t");
    const auto value = numberIn<std::uint16_t>(line.substr(0, end));
    if (!value || *value == 0 || end == std::string::npos) continue;
    const std::string rest = trimmed(line.substr(end));
    const std::size_t quote = rest.find('"');
    std::string name = rest.substr(0, rest.find_first_of(line[end] == '\t' ? "\t" : " \t"));
    if (quote != std::string::npos) name = rest.substr(quote + 1, rest.find('"', quote + 1) - quote - 1);
    if (!name.empty()) names[*value] = trimmed(name);
  }
  return names;
}

/// The table beside a label map: its own name with .txt or .tsv, or the folder's labels.tsv.
std::map<std::uint16_t, std::string> namesBeside(const fs::path& path) {
  std::vector<fs::path> candidates;
  for (fs::path stem = path; stem.has_extension();) {
    stem.replace_extension();
    candidates.push_back(fs::path(stem) += ".txt");
    candidates.push_back(fs::path(stem) += ".tsv");
  }
  candidates.push_back(path.parent_path() / "labels.tsv");
  std::error_code unknown;
  for (const fs::path& candidate : candidates)
    if (fs::is_regular_file(candidate, unknown)) return readNameTable(candidate);
  return {};
}

/// Label values as stored, checked to be labels and scaled as the header says. Headers round a scale such as SPM's
/// 1/255 to single precision or six digits, so that a scaled label is whole only within a millionth of its terms.
std::vector<std::uint16_t> labelsOf(const Voxels& voxels, const ImageFile& image) {
  const bool scaled = image.slope != 1.0 || image.intercept != 0.0;
  std::vector<std::uint16_t> labels(voxels.count());
  voxels.visit([&](auto scalars) {
    parallelFor(scalars.size(), 1 << 20, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const double term = image.slope * static_cast<double>(scalars[i]);
        double value = term + image.intercept;
        const double whole = std::round(value);
        if (scaled && std::abs(value - whole) <= 1e-6 * (std::abs(term) + std::abs(image.intercept))) value = whole;
        if (!(value >= 0.0 && value <= greatestLabel) || value != std::floor(value)) {
          const auto text = std::isfinite(value) ? std::to_string(value) : std::string("no number");
          throw Error(image.path, "is no label map: it holds the value " + text,
                      "label maps hold whole numbers from 0 to 65535; open this file as a volume");
        }
        labels[i] = static_cast<std::uint16_t>(value);
      }
    });
  });
  return labels;
}

/// All layers in one map.
std::vector<std::uint16_t> mergedLayers(const std::vector<Voxels>& layers, const std::vector<Segment>& segments,
                                        const ImageFile& image, std::vector<Warning>& warnings) {
  if (layers.size() == 1 && segments.empty()) return labelsOf(layers.front(), image);
  std::vector<std::vector<std::uint16_t>> maps;
  std::vector<std::uint64_t> voxels(greatestLabel + 1u, 0);
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    std::vector<std::uint16_t> labels = labelsOf(layers[layer], image);
    std::vector<std::uint16_t> renamed(greatestLabel + 1u);
    std::iota(renamed.begin(), renamed.end(), std::uint16_t{0});
    for (const Segment& segment : segments)
      if (segment.layer == static_cast<std::int64_t>(layer)) renamed[segment.storedValue] = segment.label.value;
    for (std::uint16_t& label : labels) ++voxels[label = renamed[label]];
    maps.push_back(std::move(labels));
  }
  LabelOverlap overlap;
  std::vector<Label> known;
  for (const Segment& segment : segments) {
    overlap.add(segment.label.value, voxels[segment.label.value]);
    known.push_back(segment.label);
  }
  std::vector<std::uint16_t> merged = std::move(maps.front());
  for (std::size_t layer = 1; layer < maps.size(); ++layer)
    for (std::size_t i = 0; i < merged.size(); ++i) merged[i] = overlap.keep(merged[i], maps[layer][i]);
  overlap.warn(image.path, known, warnings);
  return merged;
}

/// Whether `from`'s voxel centres are `to`'s, up to the axes' order and direction.
bool isSameLattice(const glm::dmat4& toFromFrom, const Grid& from) {
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 index((corner & 1) ? from.dims.x - 1 : 0, (corner & 2) ? from.dims.y - 1 : 0,
                           (corner & 4) ? from.dims.z - 1 : 0);
    if (!isVoxelCentre(glm::dvec3(toFromFrom * glm::dvec4(index, 1.0)))) return false;
  }
  for (int column = 0; column < 3; ++column)
    if (std::abs(glm::length(glm::dvec3(toFromFrom[column])) - 1.0) > 0.01) return false;
  return true;
}

std::vector<std::uint16_t> resampled(const std::vector<std::uint16_t>& labels, const Grid& from, const Grid& to,
                                     const fs::path& path, std::vector<Warning>& warnings) {
  const glm::dmat4 fromIndexFromTo = from.indexFromWorld() * to.worldFromIndex();
  const bool sameLattice = isSameLattice(fromIndexFromTo, to);
  std::vector<std::uint16_t> result(to.voxelCount(), 0);
  const std::size_t rows = static_cast<std::size_t>(to.dims.y) * static_cast<std::size_t>(to.dims.z);
  parallelFor(rows, 64, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      const int y = static_cast<int>(row % static_cast<std::size_t>(to.dims.y));
      const int z = static_cast<int>(row / static_cast<std::size_t>(to.dims.y));
      for (int x = 0; x < to.dims.x; ++x) {
        const glm::dvec3 at = glm::floor(glm::dvec3(fromIndexFromTo * glm::dvec4(x, y, z, 1.0)) + 0.5);
        // Compared before the conversion: a far-off position overflows int.
        if (glm::any(glm::lessThan(at, glm::dvec3(0.0))) || glm::any(glm::greaterThanEqual(at, glm::dvec3(from.dims))))
          continue;
        result[to.offset({x, y, z})] = labels[from.offset(glm::ivec3(at))];
      }
    }
  });
  warnOfPlacement(path, labelledVoxels(labels), labelledVoxels(result), sameLattice, warnings);
  return result;
}

bool isSameGrid(const Grid& a, const Grid& b) {
  if (a.dims != b.dims) return false;
  const auto cornersA = a.corners(), cornersB = b.corners();
  const double tolerance = 0.05 * std::min({b.spacing.x, b.spacing.y, b.spacing.z});
  for (std::size_t corner = 0; corner < cornersA.size(); ++corner)
    if (!(glm::distance(cornersA[corner], cornersB[corner]) < tolerance)) return false;
  return true;
}

/// Labels of any format but DICOM.
LabelsOnGrid readImageLabels(const fs::path& path, Format format, const Grid& target, const Progress& progress,
                             bool allowOutside) {
  ImageFile image = readImageHeader(path, format, allowOutside);
  checkGeometry(image);
  const std::vector<Segment> segments = slicerSegments(image);
  if (image.layers() > 1 && segments.empty())
    throw Error(path, "holds " + std::to_string(image.layers()) + " volumes, not one label map",
                "extract one of them first");
  LabelsOnGrid read;
  read.warnings = std::move(image.warnings);
  {
    const std::vector<Voxels> layers = readVoxels(image, {0, image.layers()}, progress, read.warnings);
    read.values = mergedLayers(layers, segments, image, read.warnings);
  }
  if (!isSameGrid(image.grid, target)) read.values = resampled(read.values, image.grid, target, path, read.warnings);
  for (const auto& [value, name] : namesBeside(path)) read.labels.push_back({value, name, noColour});
  // Later entries replace earlier ones: the file's own names win over the table's.
  for (const Segment& segment : segments) read.labels.push_back(segment.label);
  return read;
}

OpenedLabels readLabels(const fs::path& path, Format format, const Grid& target, const Progress& progress,
                        bool allowOutside) {
  LabelsOnGrid read = format == Format::Dicom ? readDicomLabels(path, target, progress)
                                              : readImageLabels(path, format, target, progress, allowOutside);
  const std::vector<std::uint16_t>& values = read.values;
  std::vector<bool> present(greatestLabel + 1u, false);
  for (const std::uint16_t value : values) present[value] = true;
  std::map<std::uint16_t, Label> labels;
  for (const Label& label : read.labels) labels[label.value] = label;
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

OpenedLabels readArchivedLabels(const fs::path& archivePath, const fs::path& path, const Grid& target,
                                const Progress& progress, bool allowOutside) {
  const UnpackedArchive archive(archivePath, progress);
  try {
    const fs::path file = labelMapIn(archive, path);
    const Format format = formatOf(file);
    if (format == Format::Archive) throw Error(file, "is an archive in an archive", "unpack it and open what it holds");
    OpenedLabels opened = readLabels(file, format, target, progress, allowOutside);
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
    if (place.format == Format::Dicom) return {path};
    return readImageHeader(path, place.format, allowOutside).source.files;
  });
}

OpenedLabels openLabels(const fs::path& path, const Grid& target, const Progress& progress, bool allowOutside) {
  return withinMemory(path, [&] {
    const Place place = placeOf(path);
    if (place.format == Format::Archive) return readArchivedLabels(place.archive, path, target, progress, allowOutside);
    return readLabels(path, place.format, target, progress, allowOutside);
  });
}

}  // namespace fenestra::io
