#include "rendering/viewpoints/ViewDescriptors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "rendering/viewpoints/RankCorrelation.h"
#include "rendering/viewpoints/SurfaceCurvature.h"

namespace fenestra::placement {
namespace {

constexpr std::array<ViewDescriptorEntry, 9> entries{{
    {ViewDescriptor::Entropy, "entropy", "bit", true, false},
    {ViewDescriptor::StructureEntropy, "structure-entropy", "bit", true, false},
    {ViewDescriptor::MutualInformation, "mutual-information", "bit", false, false},
    {ViewDescriptor::I2, "i2", "bit", false, false},
    {ViewDescriptor::Stability, "stability", "1", true, false},
    {ViewDescriptor::DepthDistribution, "depth-distribution", "bit", true, true},
    {ViewDescriptor::SilhouetteLength, "silhouette-length", "model diameters", true, true},
    {ViewDescriptor::SilhouetteCurvature, "silhouette-curvature", "radian", true, true},
    {ViewDescriptor::CurvatureEntropy, "curvature-entropy", "bit", true, false},
}};

/// The outline's curvature leaves out features smaller than this part of the focus's depth range, or than two pixels.
/// Measured on finer images, the orders of views then stay the same.
constexpr double leastFeature = 1.0 / 32.0;

/// Nearest directions that stability compares with: a HEALPix pixel has at most eight neighbours.
constexpr std::size_t comparedDirections = 8;

bool sees(const Candidate& candidate, std::size_t point) { return candidate.seen[point / 64] >> (point % 64) & 1u; }

/// a_z(v) of all candidates and points, mm².
std::vector<std::vector<double>> visibleAreas(const std::vector<Candidate>& candidates, const SurfacePoints& surface) {
  const std::size_t points = surface.normals.size();
  const double each = points > 0 ? surface.area / static_cast<double>(points) : 0.0;
  std::vector<std::vector<double>> areas(candidates.size(), std::vector<double>(points, 0.0));
  for (std::size_t v = 0; v < candidates.size(); ++v)
    for (std::size_t z = 0; z < points; ++z)
      if (sees(candidates[v], z))
        areas[v][z] = each * std::max(0.0, glm::dot(surface.normals[z], candidates[v].direction));
  return areas;
}

/// The candidates nearest to one, without itself.
std::vector<std::size_t> neighboursOf(std::size_t candidate, const std::vector<glm::dvec3>& directions) {
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t other = 0; other < directions.size(); ++other)
    if (other != candidate) near.emplace_back(-glm::dot(directions[other], directions[candidate]), other);
  const std::size_t count = std::min(comparedDirections, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
  std::vector<std::size_t> neighbours;
  for (std::size_t i = 0; i < count; ++i) neighbours.push_back(near[i].second);
  return neighbours;
}

}  // namespace

std::span<const ViewDescriptorEntry> viewDescriptors() { return entries; }

const ViewDescriptorEntry& entryOf(ViewDescriptor descriptor) { return entries[static_cast<std::size_t>(descriptor)]; }

ImageMeasures measuresOf(const FocusImage& image, double nearest, double farthest, double diameter) {
  const double depths = depthEntropy(image, nearest, farthest);
  if (std::isnan(depths)) return {undefined, undefined, undefined};
  const std::vector<std::vector<glm::dvec2>> outlines = outlinesOf(image);
  return {depths, lengthOf(outlines, image.pixel) / diameter,
          turningOf(outlines, std::max(2.0, leastFeature * (farthest - nearest) / image.pixel))};
}

DescribedViews::DescribedViews(const std::vector<Candidate>& candidates, SurfacePoints surface,
                               std::vector<ImageMeasures> images)
    : surface_(std::move(surface)), images_(std::move(images)), channel_(visibleAreas(candidates, surface_)) {
  for (const Candidate& candidate : candidates) {
    directions_.push_back(candidate.direction);
    shares_.push_back(seenShare(candidate, candidate, surface_.normals.size()));
  }
}

std::vector<double> DescribedViews::values(ViewDescriptor descriptor) const {
  if (descriptor == ViewDescriptor::Stability) return stability();
  if (descriptor == ViewDescriptor::StructureEntropy) return structureEntropy();
  if (descriptor == ViewDescriptor::CurvatureEntropy) return curvatureEntropy();
  std::vector<double> values(directions_.size(), undefined);
  if (entryOf(descriptor).needsImages && images_.empty()) return values;
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (descriptor == ViewDescriptor::Entropy) values[v] = channel_.entropy(v);
    if (descriptor == ViewDescriptor::MutualInformation) values[v] = channel_.mutualInformation(v);
    if (descriptor == ViewDescriptor::I2) values[v] = channel_.specificInformation(v);
    if (descriptor == ViewDescriptor::DepthDistribution) values[v] = images_[v].depthDistribution;
    if (descriptor == ViewDescriptor::SilhouetteLength) values[v] = images_[v].silhouetteLength;
    if (descriptor == ViewDescriptor::SilhouetteCurvature) values[v] = images_[v].silhouetteCurvature;
  }
  return values;
}

std::optional<std::size_t> choiceBy(ViewDescriptor descriptor, const std::vector<double>& values) {
  const double sign = entryOf(descriptor).isHighBest ? 1.0 : -1.0;
  std::optional<std::size_t> best;
  for (std::size_t v = 0; v < values.size(); ++v)
    if (!std::isnan(values[v]) && (!best || sign * values[v] > sign * values[*best])) best = v;
  return best;
}

double preferenceCorrelation(ViewDescriptor descriptor, const std::vector<double>& values,
                             const std::vector<double>& with) {
  return (entryOf(descriptor).isHighBest ? 1.0 : -1.0) * rankCorrelation(values, with);
}

std::vector<double> DescribedViews::stability() const {
  std::vector<double> values(directions_.size(), undefined);
  for (std::size_t v = 0; v < values.size(); ++v) {
    if (!(channel_.viewShare(v) > 0.0)) continue;
    double sum = 0.0, count = 0.0;
    for (const std::size_t neighbour : neighboursOf(v, directions_)) {
      if (!(channel_.viewShare(neighbour) > 0.0)) continue;
      sum += channel_.divergence(v, neighbour);
      ++count;
    }
    if (count > 0.0) values[v] = 1.0 - sum / count;
  }
  return values;
}

std::vector<double> DescribedViews::structureEntropy() const {
  std::vector<double> values(directions_.size(), undefined);
  std::map<std::uint16_t, std::size_t> structures;
  for (const std::uint16_t label : surface_.labels)
    if (label != 0) structures.try_emplace(label, structures.size());
  if (structures.size() < 2) return values;
  for (std::size_t v = 0; v < values.size(); ++v) {
    std::vector<double> areas(structures.size(), 0.0);
    for (std::size_t z = 0; z < surface_.labels.size(); ++z)
      if (surface_.labels[z] != 0) areas[structures.at(surface_.labels[z])] += channel_.given(v, z);
    values[v] = entropyOf(areas);
  }
  return values;
}

std::vector<double> DescribedViews::curvatureEntropy() const {
  // Classes are numbered as they come; the last number stands for points whose curvature is not known.
  std::map<int, std::size_t> numbers;
  const std::vector<double> curvatures = gaussianCurvatures(surface_.positions, surface_.normals);
  for (const double curvature : curvatures)
    if (!std::isnan(curvature)) numbers.try_emplace(curvatureClass(curvature, surface_.area), numbers.size());
  std::vector<std::size_t> classes;
  for (const double curvature : curvatures)
    classes.push_back(std::isnan(curvature) ? numbers.size() : numbers.at(curvatureClass(curvature, surface_.area)));
  std::vector<double> values(directions_.size(), undefined);
  for (std::size_t v = 0; v < values.size(); ++v) {
    std::vector<double> histogram(numbers.size() + 1, 0.0);
    for (std::size_t z = 0; z < classes.size(); ++z)
      if (channel_.given(v, z) > 0.0) histogram[classes[z]] += 1.0;
    histogram.pop_back();
    values[v] = entropyOf(histogram);
  }
  return values;
}

}  // namespace fenestra::placement
