#include "rendering/segmentation/Face.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "rendering/volume/Threads.h"

namespace fenestra::segmentation {
namespace {

constexpr double cellSide = 3.0;  // mm
constexpr std::size_t mostCells = std::size_t{1} << 25;
constexpr double openingRadius = 6.0;                          // mm; thinner things are no head: holders, straps, hair
constexpr double closingRadius = 6.0;                          // mm; the skull is 12 mm at most
constexpr double leastHead = 100.0;                            // mm from the top that must be there
constexpr double leastWidth = 90.0, greatestWidth = 200.0;     // mm of a child's head, and of one with ears and a strap
constexpr double leastLength = 110.0, greatestLength = 250.0;  // mm
constexpr double greatestMisfit = 6.0;                         // mm RMS of the vault's surface from an ellipsoid
constexpr double vaultOfWidth = 0.4;  // how far the vault reaches down, of the head's width: above the brow
constexpr double chinOfWidth = 1.65;  // how far below the top the face ends, of the width; adults' chins are at 1.5
// From the vault, continued as an ellipsoid, to the plane. The forehead's scalp and bone take up 12 to 15 mm, and the
// base of the frontal lobes rises to the front: on real heads, brain is 8 to 14 mm behind the plane, and lids in front.
constexpr double skinToPlane = 18.0;
constexpr double pitch = 25.0 * std::numbers::pi / 180.0;

/// The volume on cells along the patient's axes.
struct FaceCells {
  glm::ivec3 dims{0};
  glm::dvec3 origin{0.0};  ///< centre of the first cell, LPS mm
  std::vector<float> values;
  std::vector<std::uint8_t> inside;  ///< 1 where the volume has values

  std::size_t offset(int x, int y, int z) const {
    return static_cast<std::size_t>(x) +
           static_cast<std::size_t>(dims.x) *
               (static_cast<std::size_t>(y) + static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(z));
  }
  glm::dvec3 centre(int x, int y, int z) const { return origin + cellSide * glm::dvec3(x, y, z); }
};

using FaceFlags = std::vector<std::uint8_t>;

/// The mean of eight samples within a cell, so that noise of fine voxels is less.
float meanAround(const Volume& volume, const glm::dmat4& indexFromWorld, const glm::dvec3& centre) {
  constexpr double quarter = 0.25 * cellSide;
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p = centre + quarter * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const glm::dvec3 index(indexFromWorld * glm::dvec4(p, 1.0));
    const glm::ivec3 nearest(glm::round(glm::clamp(index, glm::dvec3(0.0), glm::dvec3(volume.grid.dims - 1))));
    const double value = volume.value(nearest);
    sum += std::isfinite(value) ? value : volume.range.low;
  }
  return static_cast<float>(sum / 8.0);
}

std::optional<FaceCells> faceCells(const Volume& volume) {
  const auto corners = volume.grid.corners();
  glm::dvec3 low = corners[0], high = corners[0];
  for (const glm::dvec3& corner : corners) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  FaceCells cells;
  cells.dims = glm::ivec3(glm::floor((high - low) / cellSide)) + 1;
  cells.origin = low + 0.5 * ((high - low) - cellSide * glm::dvec3(cells.dims - 1));
  const double count = static_cast<double>(cells.dims.x) * cells.dims.y * cells.dims.z;
  if (count > static_cast<double>(mostCells)) return std::nullopt;
  cells.values.assign(static_cast<std::size_t>(count), static_cast<float>(volume.range.low));
  cells.inside.assign(cells.values.size(), 0);
  const glm::dmat4 indexFromWorld = volume.grid.indexFromWorld();
  const glm::dvec3 last = glm::dvec3(volume.grid.dims) - 0.5;
  parallelFor(static_cast<std::size_t>(cells.dims.z), 1, [&](std::size_t begin, std::size_t end) {
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (int y = 0; y < cells.dims.y; ++y)
        for (int x = 0; x < cells.dims.x; ++x) {
          const glm::dvec3 centre = cells.centre(x, y, z), index(indexFromWorld * glm::dvec4(centre, 1.0));
          if (!glm::all(glm::greaterThanEqual(index, glm::dvec3(-0.5))) || !glm::all(glm::lessThanEqual(index, last)))
            continue;
          cells.inside[cells.offset(x, y, z)] = 1;
          cells.values[cells.offset(x, y, z)] = meanAround(volume, indexFromWorld, centre);
        }
  });
  return cells;
}

/// Above it is the patient: -300 HU; else a twentieth of the way from the darkest to the brightest values, or more
/// where the background is that bright: the skin of a T2 is dim, but three times as bright as the noise beside it.
double patientThreshold(const Volume& volume, const FaceCells& cells) {
  if (volume.isInHounsfieldUnits()) return -300.0;
  std::vector<float> values;
  for (std::size_t i = 0; i < cells.values.size(); ++i)
    if (cells.inside[i]) values.push_back(cells.values[i]);
  if (values.empty()) return 0.0;
  const auto at = [](std::vector<float>& of, double share) {
    const auto place = of.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(of.size() - 1));
    std::nth_element(of.begin(), place, of.end());
    return static_cast<double>(*place);
  };
  const double dark = at(values, 0.02), range = at(values, 0.98) - dark;
  std::erase_if(values, [&](float value) { return value > dark + 0.1 * range; });
  const double background = at(values, 0.5) - dark;
  return dark + std::clamp(3.0 * background, 0.05 * range, 0.15 * range);
}

/// The cells of which all (or one) within a cube of `radius` cells are set, axis by axis. Beyond the border counts as
/// not set.
FaceFlags cubed(FaceFlags flags, const glm::ivec3& dims, int radius, bool all) {
  const std::array<std::size_t, 3> strides{1, static_cast<std::size_t>(dims.x),
                                           static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y)};
  for (int axis = 0; axis < 3; ++axis) {
    const FaceFlags from = flags;
    const int length = dims[axis];
    const std::size_t stride = strides[static_cast<std::size_t>(axis)];
    for (std::size_t i = 0; i < flags.size(); ++i) {
      const int at = static_cast<int>(i / stride % static_cast<std::size_t>(length));
      int set = 0;
      for (int step = -radius; step <= radius; ++step)
        if (at + step >= 0 && at + step < length)
          set += from[i + static_cast<std::size_t>(step + radius) * stride - static_cast<std::size_t>(radius) * stride];
      flags[i] = all ? set == 2 * radius + 1 : set > 0;
    }
  }
  return flags;
}

/// The largest part, over faces.
FaceFlags largestOf(const FaceFlags& flags, const glm::ivec3& dims) {
  const std::array<std::size_t, 3> strides{1, static_cast<std::size_t>(dims.x),
                                           static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y)};
  FaceFlags seen(flags.size(), 0);
  std::vector<std::size_t> largest, part;
  for (std::size_t seed = 0; seed < flags.size(); ++seed) {
    if (!flags[seed] || seen[seed]) continue;
    part.assign(1, seed);
    seen[seed] = 1;
    for (std::size_t next = 0; next < part.size(); ++next)
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t stride = strides[static_cast<std::size_t>(axis)];
        const std::size_t at = part[next] / stride % static_cast<std::size_t>(dims[axis]);
        const auto visit = [&](std::size_t neighbour) {
          if (flags[neighbour] && !seen[neighbour]) {
            seen[neighbour] = 1;
            part.push_back(neighbour);
          }
        };
        if (at > 0) visit(part[next] - stride);
        if (at + 1 < static_cast<std::size_t>(dims[axis])) visit(part[next] + stride);
      }
    if (part.size() > largest.size()) largest.swap(part);
  }
  FaceFlags result(flags.size(), 0);
  for (const std::size_t i : largest) result[i] = 1;
  return result;
}

/// Without tables, holders and noise; with the skull, which is dark in MR, between scalp and brain.
FaceFlags patientIn(const FaceCells& cells, double threshold) {
  FaceFlags flags(cells.values.size());
  for (std::size_t i = 0; i < flags.size(); ++i) flags[i] = cells.inside[i] && cells.values[i] > threshold;
  const int gap = static_cast<int>(closingRadius / cellSide), radius = static_cast<int>(openingRadius / cellSide);
  flags = cubed(cubed(std::move(flags), cells.dims, gap, false), cells.dims, gap, true);
  const FaceFlags core = largestOf(cubed(flags, cells.dims, radius, true), cells.dims);
  FaceFlags grown = cubed(core, cells.dims, radius, false);
  for (std::size_t i = 0; i < flags.size(); ++i) grown[i] &= flags[i];
  return grown;
}

/// The outline in one plane of cells.
struct Section {
  int cells = 0, left = 0, right = -1, front = 0, back = -1;
  double width() const { return cellSide * (right - left + 1); }
  double length() const { return cellSide * (back - front + 1); }
};

std::vector<Section> sectionsOf(const FaceFlags& flags, const FaceCells& cells) {
  std::vector<Section> sections(static_cast<std::size_t>(cells.dims.z));
  for (int z = 0; z < cells.dims.z; ++z) {
    Section& section = sections[static_cast<std::size_t>(z)];
    for (int y = 0; y < cells.dims.y; ++y)
      for (int x = 0; x < cells.dims.x; ++x) {
        if (!flags[cells.offset(x, y, z)]) continue;
        if (section.cells++ == 0) section = {1, x, x, y, y};
        section.left = std::min(section.left, x);
        section.right = std::max(section.right, x);
        section.back = y;
      }
  }
  return sections;
}

/// Solves a symmetric system by Gaussian elimination with pivots; false where it is singular.
template <std::size_t N>
bool solve(std::array<std::array<double, N + 1>, N>& rows) {
  for (std::size_t column = 0; column < N; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < N; ++row)
      if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) pivot = row;
    if (std::abs(rows[pivot][column]) < 1e-12) return false;
    std::swap(rows[pivot], rows[column]);
    for (std::size_t row = 0; row < N; ++row) {
      if (row == column) continue;
      const double factor = rows[row][column] / rows[column][column];
      for (std::size_t k = column; k <= N; ++k) rows[row][k] -= factor * rows[column][k];
    }
  }
  return true;
}

/// An ellipsoid with an axis to the left: (p - centre)ᵀ shape (p - centre) = 1.
struct Ellipsoid {
  glm::dvec3 centre{0.0};
  glm::dmat3 shape{1.0}, inverse{1.0};

  /// How far it reaches along a unit vector, from the origin of the world.
  double reach(const glm::dvec3& n) const {
    return glm::dot(n, centre) + std::sqrt(std::max(0.0, glm::dot(n, inverse * n)));
  }
  /// mm from its surface, to first order.
  double distance(const glm::dvec3& p) const {
    const glm::dvec3 from = p - centre;
    const double value = std::sqrt(std::max(1e-12, glm::dot(from, shape * from)));
    return glm::length(from) * (1.0 - 1.0 / value);
  }
};

/// The least squares of A x² + B y² + C z² + D yz + E x + F y + G z = 1 over the points.
std::optional<Ellipsoid> fitted(const std::vector<glm::dvec3>& points) {
  constexpr std::size_t unknowns = 7;
  constexpr double unit = 100.0;  // mm, so that the squares are about 1
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& p : points) mean += p / static_cast<double>(points.size());
  std::array<std::array<double, unknowns + 1>, unknowns> rows{};
  for (const glm::dvec3& point : points) {
    const glm::dvec3 p = (point - mean) / unit;
    const std::array<double, unknowns + 1> terms{p.x * p.x, p.y * p.y, p.z * p.z, p.y * p.z, p.x, p.y, p.z, 1.0};
    for (std::size_t i = 0; i < unknowns; ++i)
      for (std::size_t k = 0; k <= unknowns; ++k) rows[i][k] += terms[i] * terms[k];
  }
  if (points.size() < unknowns || !solve<unknowns>(rows)) return std::nullopt;
  std::array<double, unknowns> s{};
  for (std::size_t i = 0; i < unknowns; ++i) s[i] = rows[i][unknowns] / rows[i][i];
  const glm::dmat3 quadratic(s[0], 0.0, 0.0, 0.0, s[1], 0.5 * s[3], 0.0, 0.5 * s[3], s[2]);
  // Positive definite, or it is no ellipsoid.
  if (s[0] <= 0.0 || s[1] <= 0.0 || s[1] * s[2] - 0.25 * s[3] * s[3] <= 0.0) return std::nullopt;
  const glm::dvec3 linear(s[4], s[5], s[6]), centre = -0.5 * (glm::inverse(quadratic) * linear);
  const double scale = 1.0 + glm::dot(centre, quadratic * centre);
  Ellipsoid result;
  result.centre = mean + unit * centre;
  result.shape = quadratic / (scale * unit * unit);
  result.inverse = glm::inverse(result.shape);
  return result;
}

std::vector<glm::dvec3> surfaceOf(const FaceFlags& flags, const FaceCells& cells, int from, int to) {
  std::vector<glm::dvec3> points;
  for (int z = from; z <= to; ++z)
    for (int y = 1; y + 1 < cells.dims.y; ++y) {
      // The outermost cells of each row: noses of the skull's inside do not count.
      int left = -1, right = -1;
      for (int x = 0; x < cells.dims.x; ++x)
        if (flags[cells.offset(x, y, z)]) {
          if (left < 0) left = x;
          right = x;
        }
      if (left < 0) continue;
      points.push_back(cells.centre(left, y, z));
      if (right != left) points.push_back(cells.centre(right, y, z));
    }
  for (int z = from; z <= to; ++z)
    for (int x = 0; x < cells.dims.x; ++x) {
      int front = -1, back = -1;
      for (int y = 0; y < cells.dims.y; ++y)
        if (flags[cells.offset(x, y, z)]) {
          if (front < 0) front = y;
          back = y;
        }
      if (front < 0) continue;
      points.push_back(cells.centre(x, front, z));
      if (back != front) points.push_back(cells.centre(x, back, z));
    }
  return points;
}

FaceSearch noFace(std::string reason) { return {false, {}, std::move(reason)}; }

/// The planes of the head from its top on, and its size; a reason why it is none.
struct Head {
  int top = 0;         ///< the plane of cells
  double width = 0.0;  ///< mm, the largest above the ears' lobes
  std::string reason = {};
};
Head headIn(const std::vector<Section>& sections) {
  Head head{static_cast<int>(sections.size()) - 1};
  constexpr int leastCells = 40;  // 3.6 cm², so that a tube on the head is none
  while (head.top >= 0 && sections[static_cast<std::size_t>(head.top)].cells < leastCells) --head.top;
  const int deep = static_cast<int>(leastHead / cellSide);
  if (head.top < deep) return {0, 0.0, "less of it is shown than a head has above the ears"};
  double length = 0.0;
  int most = 0;
  for (int z = head.top; z > head.top - deep; --z) {
    const Section& section = sections[static_cast<std::size_t>(z)];
    head.width = std::max(head.width, section.width());
    length = std::max(length, section.length());
    most = std::max(most, section.cells);
  }
  // The uppermost of a vault is small.
  constexpr double largestTop = 0.4;
  if (sections[static_cast<std::size_t>(head.top)].cells > largestTop * most) return {0, 0.0, "its top is cut off"};
  if (head.width < leastWidth || head.width > greatestWidth || length < leastLength || length > greatestLength)
    return {0, 0.0, "what it shows has not the size of a head"};
  return head;
}

}  // namespace

FaceSearch findFace(const Volume& volume) {
  const std::optional<FaceCells> cells = faceCells(volume);
  if (!cells) return noFace("it is too large for a patient");
  const FaceFlags patient = patientIn(*cells, patientThreshold(volume, *cells));
  const Head head = headIn(sectionsOf(patient, *cells));
  if (!head.reason.empty()) return noFace(head.reason);
  const int vault = static_cast<int>(vaultOfWidth * head.width / cellSide);
  const std::vector<glm::dvec3> surface = surfaceOf(patient, *cells, head.top - vault, head.top);
  const std::optional<Ellipsoid> ellipsoid = fitted(surface);
  if (!ellipsoid) return noFace("what it shows has not the shape of a head");
  double squares = 0.0;
  for (const glm::dvec3& p : surface) squares += std::pow(ellipsoid->distance(p), 2.0);
  if (std::sqrt(squares / static_cast<double>(surface.size())) > greatestMisfit)
    return noFace("what it shows has not the shape of a head");
  FaceSearch found;
  found.isFound = true;
  found.region.normal = {0.0, -std::cos(pitch), -std::sin(pitch)};
  found.region.offset = ellipsoid->reach(found.region.normal) + 0.5 * cellSide - skinToPlane;
  found.region.lowest = cells->centre(0, 0, head.top).z - chinOfWidth * head.width;
  return found;
}

}  // namespace fenestra::segmentation
