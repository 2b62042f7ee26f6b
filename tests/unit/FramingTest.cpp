// A camera's frame encloses what shows, and little more.

#include <algorithm>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "rendering/scene/Scene.h"
#include "rendering/scene/VisibleFraming.h"
#include "rendering/settings/Camera.h"

namespace fenestra::framingTest {
namespace {

/// A head-like ellipsoid in air, aside of the volume's middle, with one bright voxel of noise in a corner.
struct Head {
  static constexpr glm::dvec3 radii{0.3, 0.38, 0.34};  // of the volume's side
  static constexpr glm::dvec3 middle{0.45, 0.55, 0.5};

  explicit Head(int side) : volume(std::make_shared<Volume>()) {
    volume->grid = {.dims = glm::ivec3(side), .spacing = {1.0, 1.0, 1.5}};
    volume->grid.direction = glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.4, glm::dvec3(0.3, 0.2, 0.9)));
    volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
    const auto values = volume->voxels.as<std::int16_t>();
    for (int z = 0; z < side; ++z)
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
          const bool inside = isInside({x, y, z});
          values[volume->grid.offset({x, y, z})] = inside ? 40 : -1000;
          if (inside) shown.emplace_back(volume->grid.worldFromIndex() * glm::dvec4(x, y, z, 1.0));
        }
    values[volume->grid.offset({1, 2, 1})] = 40;
    volume->computeRange();
    context.nodes = {{-200.0, {glm::dvec3(1.0), 0.0}}, {0.0, {glm::dvec3(1.0), 1.0}}};
  }
  bool isInside(glm::ivec3 voxel) const {
    const glm::dvec3 place = (glm::dvec3(voxel) / static_cast<double>(volume->grid.dims.x) - middle) / radii;
    return glm::dot(place, place) < 1.0;
  }

  std::shared_ptr<Volume> volume;
  TransferFunction context;
  std::vector<glm::dvec3> shown;  ///< world
};

/// The greatest distance of a point from the picture's middle, 1 at the border.
double filledBy(const std::vector<glm::dvec3>& points, const Camera& camera, const Grid& grid) {
  const glm::dmat4 clipFromWorld = camera.clipFromWorld(1.0, grid);
  double farthest = 0.0;
  for (const glm::dvec3& point : points) {
    const glm::dvec4 clip = clipFromWorld * glm::dvec4(point, 1.0);
    farthest = std::max({farthest, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
  }
  return farthest;
}

TEST(Framing, EnclosesWhatShowsFromEverywhere) {
  for (const int side : {40, 100, 200}) {
    const Head head(side);
    const Framing framing = visibleFraming({head.volume}, head.context);
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
      for (int azimuth = -170; azimuth <= 180; azimuth += 35)
        for (const int elevation : {-80, -30, 0, 25, 60}) {
          const Camera camera = Camera::fromAngles(azimuth, elevation, framing, projection);
          const double filled = filledBy(head.shown, camera, head.volume->grid);
          EXPECT_LE(filled, 1.0) << side << ", " << azimuth << ", " << elevation;
          // The margin is 3 %, and blocks of voxels stand out by their corners.
          EXPECT_GE(filled, 0.87) << side << ", " << azimuth << ", " << elevation;
        }
  }
}

TEST(Framing, IsTheGridWhereNothingShows) {
  const Head head(40);
  TransferFunction nothing;
  nothing.nodes = {{5000.0, {glm::dvec3(1.0), 0.0}}, {6000.0, {glm::dvec3(1.0), 1.0}}};
  const Framing framing = visibleFraming({head.volume}, nothing);
  const Grid& grid = head.volume->grid;
  for (const StandardView view : {StandardView::Anterior, StandardView::Superior})
    EXPECT_EQ(Camera::standard(view, framing), Camera::standard(view, grid));
}

TEST(Framing, IsTheSameForStoredValuesOfEveryWidth) {
  const Head head(100);
  const Framing expected = visibleFraming({head.volume}, head.context);
  // 16 bits are looked up, 32 are compared; 8 hold the values by slope and intercept.
  const auto as = [&]<class T>(ScalarType type, T air, T inside, double slope, double intercept) {
    auto volume = std::make_shared<Volume>();
    volume->grid = head.volume->grid;
    volume->slope = slope;
    volume->intercept = intercept;
    volume->voxels = Voxels(type, volume->grid.voxelCount());
    const auto own = head.volume->voxels.as<std::int16_t>();
    const auto values = volume->voxels.as<T>();
    std::transform(own.begin(), own.end(), values.begin(),
                   [&](std::int16_t value) { return value == 40 ? inside : air; });
    volume->computeRange();
    return visibleFraming({volume}, head.context);
  };
  for (const Framing& other : {as(ScalarType::UInt8, std::uint8_t{0}, std::uint8_t{104}, 10.0, -1000.0),
                               as(ScalarType::Int8, std::int8_t{-125}, std::int8_t{5}, 8.0, 0.0),
                               as(ScalarType::Int32, std::int32_t{-1000}, std::int32_t{40}, 1.0, 0.0),
                               as(ScalarType::Float32, -1000.0F, 40.0F, 1.0, 0.0)}) {
    EXPECT_EQ(other.centre, expected.centre);
    EXPECT_EQ(other.points, expected.points);
  }
}

TEST(Framing, TurnsAroundTheMiddleOfWhatShows) {
  const Head head(100);
  const Framing framing = visibleFraming({head.volume}, head.context);
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& point : head.shown) mean += point / static_cast<double>(head.shown.size());
  EXPECT_LT(glm::distance(framing.centre, mean), 1.0);
  EXPECT_EQ(Camera::fromAngles(30.0, 40.0, framing).target, Camera::fromAngles(-100.0, 0.0, framing).target);
}

}  // namespace
}  // namespace fenestra::framingTest
