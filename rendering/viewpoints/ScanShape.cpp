#include "rendering/viewpoints/ScanShape.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace fenestra::placement {
namespace {

constexpr int mostSamples = 32;        ///< along an axis
constexpr double solidValue = -500.0;  ///< HU
constexpr double thinShare = 0.02;     ///< of the body's greatest layer: one of less is a nose, a wire or noise

double ramp(double value, double from, double to) { return std::clamp((value - from) / (to - from), 0.0, 1.0); }

/// Which voxels are of the body.
class Body {
 public:
  Body(const ShownVolume& shown, const std::vector<HalfSpace>& kept)
      : shown_(shown), kept_(kept), worldFromIndex_(shown.volume->grid.worldFromIndex()) {
    const Grid& grid = shown.volume->grid;
    for (int axis = 0; axis < 3; ++axis) {
      const int count = std::min(grid.dims[axis], mostSamples);
      for (int i = 0; i < count; ++i) places_[axis].push_back(count == 1 ? 0 : i * (grid.dims[axis] - 1) / (count - 1));
    }
    threshold_ = solidValue;
    if (shown.volume->isInHounsfieldUnits()) return;
    std::vector<double> values;
    withValues(shown_, [&](const auto& valueAt) {
      forEachSample([&](glm::ivec3, glm::ivec3 voxel) { values.push_back(valueAt(voxel)); });
    });
    const auto percentile = [&](std::size_t hundredths) {
      const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * hundredths / 100);
      std::nth_element(values.begin(), at, values.end());
      return *at;
    };
    const double low = percentile(2), high = percentile(98);
    threshold_ = low + 0.1 * (high - low);
  }

  /// Calls use(contains), with contains(voxel).
  template <class F>
  void read(const F& use) const {
    withValues(shown_, [&](const auto& valueAt) {
      use([&](glm::ivec3 voxel) {
        return valueAt(voxel) > threshold_ &&
               (kept_.empty() || keeps(kept_, glm::dvec3(worldFromIndex_ * glm::dvec4(voxel, 1.0))));
      });
    });
  }
  /// Indices of the layers of samples across an index axis.
  const std::vector<int>& places(int axis) const { return places_[static_cast<std::size_t>(axis)]; }
  /// How many samples of each layer across an index axis are of the body; the first and last layer are faces.
  std::array<std::vector<int>, 3> layers() const {
    std::array<std::vector<int>, 3> areas;
    for (std::size_t axis = 0; axis < 3; ++axis) areas[axis].assign(places_[axis].size(), 0);
    read([&](const auto& contains) {
      forEachSample([&](glm::ivec3 place, glm::ivec3 voxel) {
        if (!contains(voxel)) return;
        for (int axis = 0; axis < 3; ++axis)
          ++areas[static_cast<std::size_t>(axis)][static_cast<std::size_t>(place[axis])];
      });
    });
    return areas;
  }

 private:
  /// Voxels spread evenly over the volume, those of its faces among them: visit(place among the samples, voxel).
  template <class F>
  void forEachSample(const F& visit) const {
    for (std::size_t z = 0; z < places_[2].size(); ++z)
      for (std::size_t y = 0; y < places_[1].size(); ++y)
        for (std::size_t x = 0; x < places_[0].size(); ++x)
          visit(glm::ivec3(x, y, z), glm::ivec3(places_[0][x], places_[1][y], places_[2][z]));
  }

  const ShownVolume& shown_;
  const std::vector<HalfSpace>& kept_;
  glm::dmat4 worldFromIndex_;
  std::array<std::vector<int>, 3> places_;  ///< indices of the samples along each axis
  double threshold_ = 0.0;
};

using Layers = std::array<std::vector<int>, 3>;

void findCuts(ScanShape& shape, const Grid& grid, const CropFrame& frame, const Body& body, const Layers& layers,
              std::span<const glm::dvec3> focus) {
  double least = 1.0;
  for (std::size_t f = 0; f < shape.faces.size(); ++f) {
    ScanShape::Face& face = shape.faces[f];
    const std::size_t patient = f % 3;
    face.normal = (f < 3 ? 1.0 : -1.0) * frame.normal[patient];
    const int axis = frame.axis[static_cast<int>(patient)];
    const bool isLast = glm::dot(grid.direction[axis], face.normal) > 0.0;
    const std::vector<int>& areas = layers[static_cast<std::size_t>(axis)];
    face.contact = (isLast ? areas.back() : areas.front()) /
                   static_cast<double>(std::max(1, *std::max_element(areas.begin(), areas.end())));
    std::size_t behind = 0;
    body.read([&](const auto& contains) {
      for (const glm::dvec3 point : focus) {
        glm::ivec3 voxel = glm::clamp(glm::ivec3(glm::round(point)), glm::ivec3(0), grid.dims - 1);
        voxel[axis] = isLast ? grid.dims[axis] - 1 : 0;
        behind += contains(voxel);
      }
    });
    face.behind = focus.empty() ? 0.0 : static_cast<double>(behind) / static_cast<double>(focus.size());
    face.cut = std::max(ramp(face.contact, 0.2, 0.4), face.behind * ramp(face.contact, 0.05, 0.15));
    least = std::min(least, face.cut);
  }
  for (ScanShape::Face& face : shape.faces) face.cut -= least;
}

void findOffset(ScanShape& shape, const Grid& grid, const Body& body, const Layers& layers,
                std::span<const glm::dvec3> focus) {
  if (focus.empty()) return;
  const glm::dvec3 middle =
      std::accumulate(focus.begin(), focus.end(), glm::dvec3(0.0)) / static_cast<double>(focus.size());
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<int>& areas = layers[static_cast<std::size_t>(axis)];
    const double least = thinShare * *std::max_element(areas.begin(), areas.end());
    const auto isBody = [least](int area) { return area > least; };
    const auto first = std::find_if(areas.begin(), areas.end(), isBody);
    if (first == areas.end()) continue;
    const auto last = std::find_if(areas.rbegin(), areas.rend(), isBody).base() - 1;
    const double low = body.places(axis)[static_cast<std::size_t>(first - areas.begin())];
    const double high = body.places(axis)[static_cast<std::size_t>(last - areas.begin())];
    if (high <= low) continue;
    const double along = (2.0 * middle[axis] - low - high) / (high - low);
    shape.offset += std::clamp(along, -1.0, 1.0) * grid.direction[axis];
  }
}

}  // namespace

double ScanShape::throughCutEnd(glm::dvec3 direction) const {
  double sum = 0.0;
  for (const Face& face : faces) {
    const double cosine = std::max(0.0, glm::dot(direction, face.normal));
    const bool isOfStack = face.normal == stack.front || face.normal == -stack.front;
    sum += face.cut * (isOfStack ? 1.0 - stack.flatness : 1.0) * cosine * cosine;
  }
  return std::min(sum, 1.0);
}

double ScanShape::edgeOn(glm::dvec3 direction) const {
  const double cosine = std::max(0.0, glm::dot(direction, stack.front));
  return stack.flatness * std::max(0.0, 1.0 - cosine * cosine);
}

double ScanShape::farSide(glm::dvec3 direction) const { return std::clamp(-glm::dot(direction, offset), 0.0, 1.0); }

ScanShape scanShape(const ShownVolume& shown, const std::vector<HalfSpace>& kept, std::span<const glm::dvec3> focus) {
  const Grid& grid = shown.volume->grid;
  const CropFrame frame(grid);
  ScanShape shape;
  shape.stack = flatStack(frame, grid);
  const Body body(shown, kept);
  const Layers layers = body.layers();
  findCuts(shape, grid, frame, body, layers, focus);
  findOffset(shape, grid, body, layers, focus);
  return shape;
}

}  // namespace fenestra::placement
