#include "io/dicom/RtStruct.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "io/dicom/ContourFill.h"
#include "io/dicom/RtContours.h"
#include "io/dicom/Slabs.h"
#include "rendering/volume/Threads.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Twice the area of a polygon along its normal (Newell).
glm::dvec3 areaVector(const Contour& contour) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < contour.size(); ++i)
    sum += glm::cross(contour[i] - contour[0], contour[(i + 1) % contour.size()] - contour[0]);
  return sum;
}

/// Axes of the contours' planes: u and v on the plane, w along the normal; w is never mixed with the others.
struct PlaneAxes {
  glm::dvec3 u{1, 0, 0}, v{0, 1, 0}, w{0, 0, 1};
  glm::dvec3 of(const glm::dvec3& world) const { return {glm::dot(world, u), glm::dot(world, v), glm::dot(world, w)}; }
};

/// The normal that most contours have.
glm::dvec3 usualNormal(const std::vector<Structure>& structures, const glm::dvec3& otherwise) {
  struct Group {
    glm::dvec3 normal, largest;
    std::size_t count;
  };
  constexpr std::size_t most = 16;  // directions to tell apart; a series has one
  std::vector<Group> groups;
  for (const Structure& structure : structures)
    for (const Contour& contour : structure.contours) {
      const glm::dvec3 area = areaVector(contour);
      if (!(glm::length(area) > 0.0)) continue;
      const glm::dvec3 normal = glm::normalize(area);
      // A hundredth of a radian: small contours have few digits.
      const auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& each) {
        return glm::length(glm::cross(each.normal, normal)) < 0.01;
      });
      if (group != groups.end()) {
        ++group->count;
        if (glm::length(area) > glm::length(group->largest)) group->largest = area;
      } else if (groups.size() < most) {
        groups.push_back({normal, area, 1});
      }
    }
  const auto usual =
      std::max_element(groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.count < b.count; });
  return usual == groups.end() ? otherwise : glm::normalize(usual->largest);
}

/// The normal is that of most contours, or the target's slice normal where that differs by rounding alone. Along the
/// target's rows v is constant: a row of voxels meets one line of each plane that it crosses.
PlaneAxes axesOf(const std::vector<Structure>& structures, const Grid& target) {
  PlaneAxes axes;
  const glm::dvec3 slice = glm::normalize(glm::cross(target.direction[0], target.direction[1]));
  axes.w = usualNormal(structures, slice);
  // A thousandth of a radian: coordinates are written with few decimals.
  if (glm::length(glm::cross(axes.w, slice)) < 1e-3) axes.w = slice;
  const auto flattened = [&](const glm::dvec3& direction) { return direction - glm::dot(direction, axes.w) * axes.w; };
  glm::dvec3 along = flattened(target.direction[0]);
  if (glm::length(along) < 1e-3) along = flattened(target.direction[1]);
  axes.u = glm::normalize(along);
  axes.v = glm::cross(axes.w, axes.u);
  return axes;
}

/// The contours of one structure, plane by plane.
struct Planes {
  std::vector<double> positions;
  std::vector<ContourFill> fills;
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};  ///< u, v, w
};

Planes planesOf(const Structure& structure, const PlaneAxes& axes, double tolerance, std::size_t& bent) {
  // Half a millimetre: a contour that leaves its plane further does not lie on a slice of the series.
  constexpr double flat = 0.5;
  // Contours of one slice carry the same position, up to rounding to a hundredth.
  constexpr double samePlane = 0.01;
  struct Flat {
    double w;
    std::vector<glm::dvec2> points;
  };
  Planes planes;
  std::vector<Flat> contours;
  for (const Contour& contour : structure.contours) {
    Flat on{0.0, {}};
    double least = axes.of(contour.front()).z, greatest = least;
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
    for (const glm::dvec3& point : contour) {
      const glm::dvec3 local = axes.of(point);
      on.points.push_back(glm::dvec2(local));
      on.w += local.z / static_cast<double>(contour.size());
      least = std::min(least, local.z);
      greatest = std::max(greatest, local.z);
      low = glm::min(low, local);
      high = glm::max(high, local);
    }
    if (greatest - least > flat) {
      ++bent;
      continue;
    }
    planes.low = glm::min(planes.low, low);
    planes.high = glm::max(planes.high, high);
    contours.push_back(std::move(on));
  }
  std::stable_sort(contours.begin(), contours.end(), [](const Flat& a, const Flat& b) { return a.w < b.w; });
  for (const Flat& contour : contours) {
    if (planes.positions.empty() || contour.w - planes.positions.back() > samePlane) {
      planes.positions.push_back(contour.w);
      planes.fills.emplace_back(tolerance);
    }
    planes.fills.back().add(contour.points);
  }
  for (ContourFill& fill : planes.fills) fill.finish();
  return planes;
}

/// A stretch of voxels along x.
struct Run {
  std::size_t begin = 0, length = 0;
};

/// Voxels of the target that may lie in a structure: `low` to `high`, ends included; empty when low > high.
struct VoxelBox {
  glm::ivec3 low{0}, high{-1};
};

VoxelBox voxelsWithin(const Planes& planes, const PlaneAxes& axes, double step, const Grid& target) {
  const glm::dvec3 low = planes.low - glm::dvec3(0.0, 0.0, step), high = planes.high + glm::dvec3(0.0, 0.0, step);
  const glm::dmat4 indexFromWorld = target.indexFromWorld();
  glm::dvec3 least(std::numeric_limits<double>::infinity()), greatest(-least);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
    const glm::dvec3 index(indexFromWorld * glm::dvec4(at.x * axes.u + at.y * axes.v + at.z * axes.w, 1.0));
    least = glm::min(least, index);
    greatest = glm::max(greatest, index);
  }
  const glm::dvec3 last(target.dims - 1);
  // A voxel more, so that contours through voxel centres at the border are kept.
  return {glm::ivec3(glm::clamp(glm::floor(least) - 1.0, glm::dvec3(0.0), last + 1.0)),
          glm::ivec3(glm::clamp(glm::ceil(greatest) + 1.0, glm::dvec3(-1.0), last))};
}

/// The voxels of one structure. Rows of voxels within a plane take its line's stretches at once.
std::vector<Run> voxelsOf(const Planes& planes, double step, const PlaneAxes& axes, const Grid& target,
                          const std::function<void()>& checkCancelled) {
  const VoxelBox box = voxelsWithin(planes, axes, step, target);
  const Slabs slabs(planes.positions, step);
  const glm::dmat4 worldFromIndex = target.worldFromIndex();
  const glm::dvec3 along = axes.of(glm::dvec3(worldFromIndex[0]));
  std::vector<Run> all;
  std::mutex mutex;
  const auto rows = static_cast<std::size_t>(std::max(0, box.high.y - box.low.y + 1));
  parallelFor(rows, 4, [&](std::size_t begin, std::size_t end) {
    std::vector<Run> runs;
    std::vector<ContourFill::Stretch> inside;
    for (std::size_t row = begin; row < end; ++row) {
      const int y = box.low.y + static_cast<int>(row);
      {
        const std::scoped_lock lock(mutex);
        checkCancelled();
      }
      int plane = -1;
      double line = 0.0;
      for (int z = box.low.z; z <= box.high.z; ++z) {
        const glm::dvec3 start = axes.of(glm::dvec3(worldFromIndex * glm::dvec4(0.0, y, z, 1.0)));
        for (int x = box.low.x; x <= box.high.x; ++x) {
          const glm::dvec3 at = start + static_cast<double>(x) * along;
          const int nearest = slabs.at(at.z);
          if (nearest < 0) continue;
          // A billionth of a millimetre: the same line but for rounding.
          if (nearest != plane || std::abs(at.y - line) > 1e-9) {
            plane = nearest;
            line = at.y;
            planes.fills[static_cast<std::size_t>(plane)].stretches(line, inside);
          }
          const auto after = std::upper_bound(inside.begin(), inside.end(), at.x,
                                              [](double u, const auto& stretch) { return u < stretch.begin; });
          if (after == inside.begin() || at.x > std::prev(after)->end) continue;
          const std::size_t offset = target.offset({x, y, z});
          if (!runs.empty() && runs.back().begin + runs.back().length == offset)
            ++runs.back().length;
          else
            runs.push_back({offset, 1});
        }
      }
    }
    const std::scoped_lock lock(mutex);
    all.insert(all.end(), runs.begin(), runs.end());
  });
  return all;
}

/// Refuses contours that would take hours.
void checkCost(const Planes& planes, double step, const PlaneAxes& axes, const Grid& target, const fs::path& path) {
  const VoxelBox box = voxelsWithin(planes, axes, step, target);
  const glm::dvec3 size = glm::max(glm::dvec3(box.high - box.low + 1), glm::dvec3(0.0));
  double edges = 0.0;
  for (const ContourFill& fill : planes.fills) edges += fill.edgesPerLine();
  // On a grid whose slices are parallel to the contours, the slices of a slab share its lines.
  const bool aligned = std::abs(axes.of(target.direction[0]).z) + std::abs(axes.of(target.direction[1]).z) < 1e-12;
  const double looks = edges * size.y * (aligned ? 1.0 : size.z);
  constexpr double most = 2e11;  // a minute or two
  if (looks > most)
    throw Error(path, "its contours have too many edges to be filled on this volume", "open them on their own series");
}

}  // namespace

LabelsOnGrid readStructureSet(DcmDataset& dataset, const fs::path& path, const Grid& target, const Progress& progress) {
  const StructureSet set = readContours(dataset, path);
  const PlaneAxes axes = axesOf(set.structures, target);
  // A hundredth of a voxel: contours are written with few decimals.
  const double tolerance = 0.01 * std::min({target.spacing.x, target.spacing.y, target.spacing.z});
  LabelsOnGrid read;
  std::size_t bent = 0, contours = 0;
  std::vector<Planes> planes;
  std::vector<double> gaps;
  for (const Structure& structure : set.structures) {
    planes.push_back(planesOf(structure, axes, tolerance, bent));
    contours += structure.contours.size();
    if (const double gap = usualGap(planes.back().positions); gap > 0.0) gaps.push_back(gap);
  }
  std::sort(gaps.begin(), gaps.end());
  const double sliceStep = std::abs(glm::dot(target.direction[2], axes.w)) * target.spacing.z;
  // A structure on one plane is as thick as the others' usual distance, or as a slice of the target.
  const double usual = !gaps.empty() ? gaps[(gaps.size() - 1) / 2] : sliceStep > 0.0 ? sliceStep : target.spacing.z;

  std::vector<std::vector<Run>> runs(planes.size());
  LabelOverlap overlap;
  std::size_t done = 0, outside = 0;
  const auto checkCancelled = [&] {
    const double fraction = static_cast<double>(done) / static_cast<double>(planes.size());
    if (progress && !progress(fraction, "filling contours")) throw Cancelled();
  };
  for (; done < planes.size(); ++done) {
    if (planes[done].positions.empty()) continue;
    const double gap = usualGap(planes[done].positions), step = gap > 0.0 ? gap : usual;
    checkCost(planes[done], step, axes, target, path);
    runs[done] = voxelsOf(planes[done], step, axes, target, checkCancelled);
    std::uint64_t voxels = 0;
    for (const Run& run : runs[done]) voxels += run.length;
    overlap.add(set.structures[done].label.value, voxels);
    outside += voxels == 0;
  }
  read.values.assign(target.voxelCount(), 0);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    read.labels.push_back(set.structures[i].label);
    for (const Run& run : runs[i])
      for (std::size_t at = run.begin; at < run.begin + run.length; ++at)
        read.values[at] = overlap.keep(read.values[at], set.structures[i].label.value);
  }
  overlap.warn(path, read.labels, read.warnings);
  const auto warn = [&](std::size_t count, const std::string& what) {
    if (count > 0) read.warnings.push_back({Warning::Kind::Other, std::to_string(count) + what, {path}});
  };
  warnOfLeftOut(set, path, read.warnings);
  warn(bent, " of its contours left out: they do not lie on planes parallel to the others");
  if (contours > 0 && labelledVoxels(read.values) == 0)
    warnOfPlacement(path, 1, 0, true, read.warnings);
  else
    warn(outside, " of its structures have no voxel of the volume");
  return read;
}

}  // namespace fenestra::io
