// The pixels of a slice that an opening removes, against the closed form for a picture of known depths.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "rendering/scene/Opening.h"

namespace fenestra::openingTest {
namespace {

const Grid grid{{40, 40, 40}, {1.0, 1.0, 1.0}, {-19.5, -19.5, -19.5}, glm::dmat3(1.0)};

/// Rays meet the context at its front plane, y = -15, and within `radius` mm of the axis start at y = 5.
RayStarts startsOf(Projection projection, double radius) {
  RayStarts starts{Camera::standard(StandardView::Anterior, grid, projection), grid, {200, 200}, {}, {}};
  const Camera& camera = starts.camera;
  const Camera::Axes axes = camera.axes();
  const double half = projection == Projection::Perspective ? std::tan(glm::radians(0.5 * camera.verticalFov))
                                                            : 0.5 * camera.orthographicHeight;
  for (int j = 0; j < starts.size.y; ++j)
    for (int i = 0; i < starts.size.x; ++i) {
      const glm::dvec2 ndc(2.0 * (i + 0.5) / starts.size.x - 1.0, 1.0 - 2.0 * (j + 0.5) / starts.size.y);
      const glm::dvec3 aside = half * (ndc.x * axes.right + ndc.y * axes.up);
      const bool perspective = projection == Projection::Perspective;
      const glm::dvec3 from = perspective ? camera.eye : camera.eye + aside;
      const glm::dvec3 along = perspective ? glm::normalize(axes.forward + aside) : axes.forward;
      const double context = (-15.0 - from.y) / along.y, start = (5.0 - from.y) / along.y;
      const glm::dvec3 there = from + start * along;
      const bool open = std::hypot(there.x, there.z) < radius;
      starts.tContext.push_back(static_cast<float>(context));
      starts.tStart.push_back(static_cast<float>(open ? start : context));
    }
  return starts;
}

TEST(Opening, RemovesWhatLiesBetweenTheContextsSurfaceAndTheRaysStart) {
  constexpr double radius = 8.0;
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    const RayStarts starts = startsOf(projection, radius);
    for (const SlicePlane plane : {SlicePlane::Axial, SlicePlane::Sagittal, SlicePlane::Coronal}) {
      const SliceGeometry geometry = sliceGeometry(grid, plane);
      for (const int slice : {12, 20, 30}) {
        const std::vector<char> opened = openedPixels(starts, geometry, slice);
        int removed = 0;
        for (int j = 0; j < geometry.height; ++j)
          for (int i = 0; i < geometry.width; ++i) {
            const glm::dvec3 world = geometry.worldFromPixel(i, j, slice);
            // The opening narrows towards the eye.
            const double share = projection == Projection::Perspective
                                     ? (world.y - starts.camera.eye.y) / (5.0 - starts.camera.eye.y)
                                     : 1.0;
            const double edge = std::hypot(world.x, world.z) - radius * share;
            // A pixel of the picture is 0.3 mm wide: nearer to the edge than that, the nearest ray may differ.
            if (std::abs(edge) < 0.5 || std::abs(world.y + 15.0) < 0.05 || std::abs(world.y - 5.0) < 0.05) continue;
            const bool wanted = edge < 0.0 && world.y > -15.0 && world.y < 5.0;
            const bool is = opened[static_cast<std::size_t>(j * geometry.width + i)] != 0;
            ASSERT_EQ(is, wanted) << world.x << ", " << world.y << ", " << world.z;
            removed += is;
          }
        if (slice == 20) {  // through the middle
          EXPECT_GT(removed, 0) << static_cast<int>(plane) << " " << slice;
        }
      }
    }
  }
}

TEST(Opening, RemovesNothingWhereThereIsNone) {
  const SliceGeometry geometry = sliceGeometry(grid, SlicePlane::Axial);
  const auto count = [&](const RayStarts& starts) {
    int sum = 0;
    for (const char each : openedPixels(starts, geometry, 20)) sum += each;
    return sum;
  };
  EXPECT_EQ(count(startsOf(Projection::Perspective, 0.0)), 0);
  EXPECT_EQ(count({}), 0);
  RayStarts nothing = startsOf(Projection::Perspective, 8.0);
  for (float& t : nothing.tStart) t = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(count(nothing), 0);
}

}  // namespace
}  // namespace fenestra::openingTest
