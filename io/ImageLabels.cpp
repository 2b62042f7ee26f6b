#include "io/ImageLabels.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "io/base/Text.h"
#include "rendering/volume/Threads.h"

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

/// A stack of TIFF has no place: one of the volume's size lies on it voxel by voxel.
void placeOn(const Grid& target, ImageFile& image) {
  const auto sizeOf = [](const glm::ivec3& dims) {
    return std::to_string(dims.x) + " x " + std::to_string(dims.y) + " x " + std::to_string(dims.z);
  };
  if (image.grid.dims != target.dims)
    throw Error(image.path,
                "has " + sizeOf(image.grid.dims) + " voxels where the volume has " + sizeOf(target.dims) +
                    ", and TIFF does not say where they lie",
                "open a label map of the volume's size, or one of a format with places, such as NIfTI");
  image.grid = target;
  std::erase_if(image.warnings, [](const Warning& warning) { return warning.kind == Warning::Kind::NoGeometry; });
  image.warnings.push_back({Warning::Kind::NoGeometry,
                            "TIFF says no place; the labels are laid on the volume voxel by voxel",
                            {image.path}});
}

}  // namespace

LabelsOnGrid readImageLabels(const fs::path& path, Format format, const Grid& target, const Progress& progress,
                             bool allowOutside) {
  ImageFile image = readImageHeader(path, format, allowOutside);
  if (format == Format::Tiff) placeOn(target, image);
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
  if (format == Format::Nifti) read.labels = niftiLabels(image);
  for (const Segment& segment : segments) read.labels.push_back(segment.label);
  return read;
}

}  // namespace fenestra::io
