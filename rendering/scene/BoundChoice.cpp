#include "rendering/scene/BoundChoice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace fenestra {
namespace {

constexpr int chordCount = 2048;

/// Estimated RMS of a picture, 0 to 1, from which on it gets a bound. Normal quality promises 1/255; half of that is
/// for what lies between rays, and for what chords from all over the volume miss.
constexpr double mostEstimate = 0.5 / 255.0;

/// Cells that a ray meets on its way through a volume along its longest side.
double mostCells(const Grid& grid) { return std::max({grid.dims.x, grid.dims.y, grid.dims.z}); }

/// Where a line through `inside` in `direction` enters and leaves the unit cube, in units of the direction.
glm::dvec2 throughUnitCube(glm::dvec3 inside, glm::dvec3 direction) {
  glm::dvec2 span(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) continue;
    const double low = -inside[axis] / direction[axis], high = (1.0 - inside[axis]) / direction[axis];
    span = {std::max(span.x, std::min(low, high)), std::min(span.y, std::max(low, high))};
  }
  return span;
}

/// The trilinear field of one cell.
class CellValues {
 public:
  CellValues(const ShownVoxels& voxels, glm::ivec3 cell) {
    for (int corner = 0; corner < 8; ++corner)
      corners_[static_cast<std::size_t>(corner)] =
          voxels.value(cell + glm::ivec3(corner & 1, (corner >> 1) & 1, corner >> 2));
  }
  bool isFinite() const {
    return std::all_of(corners_.begin(), corners_.end(), [](double value) { return std::isfinite(value); });
  }
  double at(glm::dvec3 w) const {
    std::array<double, 4> alongX;
    for (std::size_t i = 0; i < 4; ++i) alongX[i] = std::lerp(corners_[2 * i], corners_[2 * i + 1], w.x);
    return std::lerp(std::lerp(alongX[0], alongX[1], w.y), std::lerp(alongX[2], alongX[3], w.y), w.z);
  }

 private:
  std::array<double, 8> corners_;  ///< x fastest
};

/// Premultiplied colour and opacity of a path on which the value changes evenly, by the rule of the midpoint.
glm::dvec4 evenly(const TransferFunction& function, double from, double to, double length, int steps) {
  glm::dvec4 result(0.0);
  for (int i = 0; i < steps; ++i) {
    const OpticalProperties there = function.evaluate(from + (to - from) * (i + 0.5) / steps);
    const double opacity = -std::expm1(-there.extinction * length / steps);
    result += (1.0 - result.a) * opacity * glm::dvec4(there.colour, 1.0);
  }
  return result;
}

}  // namespace

std::vector<BoundChoice::Chord> BoundChoice::chordsOf(const ShownVolume& shown) {
  const ShownVoxels voxels(shown);
  const Grid& grid = shown.volume->grid;
  std::vector<Chord> chords;
  if (std::min({grid.dims.x, grid.dims.y, grid.dims.z}) < 2) return chords;
  chords.reserve(chordCount);
  std::mt19937 random(1);
  // The standard fixes what the generator gives, but not what its distributions do.
  const auto share = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  const glm::dmat3 world(grid.worldFromIndex()), index(grid.indexFromWorld());
  for (int i = 0; i < chordCount; ++i) {
    glm::ivec3 cell;
    glm::dvec3 inside;
    for (int axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<int>(share() * (grid.dims[axis] - 1));
      inside[axis] = share();
    }
    const double height = 2.0 * share() - 1.0, turn = 2.0 * std::numbers::pi * share();
    const double aside = std::sqrt(1.0 - height * height);
    const glm::dvec3 direction = index * glm::dvec3(aside * std::cos(turn), aside * std::sin(turn), height);
    const CellValues field(voxels, cell);
    if (!field.isFinite()) continue;
    const glm::dvec2 span = throughUnitCube(inside, direction);
    Chord chord{{}, glm::length(world * direction) * (span.y - span.x)};
    for (std::size_t k = 0; k < chord.values.size(); ++k) {
      const double u = static_cast<double>(k) / static_cast<double>(chord.values.size() - 1);
      chord.values[k] = field.at(inside + direction * glm::mix(span.x, span.y, u));
    }
    chords.push_back(chord);
  }
  return chords;
}

double BoundChoice::errorOf(const std::vector<Chord>& chords, double most, const TransferFunction& context) {
  if (chords.empty()) return 0.0;
  constexpr int stepsOfQuarter = 4;
  double opacities = 0.0, taken = 0.0;
  glm::dvec4 squares(0.0), sums(0.0);
  for (const Chord& chord : chords) {
    const auto& values = chord.values;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const int parts = *low == *high ? 1 : 4 * stepsOfQuarter;
    const glm::dvec4 whole = evenly(context, values.front(), values.back(), chord.length, parts);
    opacities += whole.a;
    taken += whole.a * (2.0 - whole.a);
    if (parts == 1) continue;
    glm::dvec4 quarters(0.0);
    for (std::size_t k = 0; k + 1 < values.size(); ++k)
      quarters += (1.0 - quarters.a) * evenly(context, values[k], values[k + 1], 0.25 * chord.length, stepsOfQuarter);
    const glm::dvec4 off = whole - quarters;
    squares += off * off;
    sums += off;
  }
  const double least = static_cast<double>(chords.size()) / most;
  const glm::dvec4 common = sums / std::max(opacities, least);
  const glm::dvec4 apart = squares / std::max(taken, least);
  double greatest = 0.0;
  for (int channel = 0; channel < 4; ++channel)
    greatest = std::max(greatest, apart[channel] + common[channel] * common[channel]);
  return std::sqrt(greatest);
}

double BoundChoice::errorOf(const ShownVolume& shown, const TransferFunction& context) {
  return errorOf(chordsOf(shown), mostCells(shown.volume->grid), context);
}

bool BoundChoice::exceeds(const ShownVolume& shown, const TransferFunction& context) {
  const Grid& grid = shown.volume->grid;
  // An expired pointer equals none, as a new volume may have the address of an old one.
  ShownVolume before = shown_;
  before.volume = volume_.lock();
  const bool isSame = before == shown;
  if (isSame && context == context_) return exceeds_;
  if (!isSame) {
    chords_ = chordsOf(shown);
    volume_ = shown.volume;
    shown_ = shown;
    shown_.volume.reset();
  }
  exceeds_ = errorOf(chords_, mostCells(grid), context) > mostEstimate;
  context_ = context;
  return exceeds_;
}

std::optional<double> BoundChoice::boundFor(const Scene& scene, const View& view) {
  const Look& look = scene.look;
  if (view.quality != Quality::Normal || view.maxError || look.shading.enabled ||
      reconstructionOf(scene) != Reconstruction::Linear)
    return {};
  return exceeds(shownVolume(scene), look.context.shifted()) ? std::optional(bound) : std::nullopt;
}

}  // namespace fenestra
