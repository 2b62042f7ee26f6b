// Walls in the reference: colours at known pixels, what they are laid over and beneath, and what they give way to.

#include "rendering/reference/Walls.h"

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "rendering/scene/Walls.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceWallsTest {
namespace {

using namespace tests;

constexpr glm::ivec2 size{80, 60};
const Grid grid = gridOf({20, 30, 24});

/// Seen from the front, 0.5 mm a pixel, the picture's middle on the volume's: x to the right, z upwards.
Camera front(Projection projection = Projection::Orthographic) {
  Camera camera = Camera::standard(StandardView::Anterior, grid, projection);
  camera.orthographicHeight = 30.0;
  return camera;
}

/// World coordinates of a pixel's centre in that picture.
glm::dvec2 placeOf(glm::ivec2 pixel) {
  return {9.5 + 0.5 * (pixel.x + 0.5 - 40.0), 11.5 - 0.5 * (pixel.y + 0.5 - 30.0)};
}

Scene rampAlongX() {
  Scene scene;
  scene.volume = volumeOf(grid, [](glm::ivec3 i) { return 10.0 * i.x; });
  scene.look.method = methods::Walls{};
  scene.look.context.function = {{{0.0, {glm::dvec3(1.0), 0.0}}}};
  return scene;
}

std::vector<WallRay> raysOf(const Camera& camera) {
  std::vector<WallRay> rays;
  for (const glm::dvec2 place : centresOf(size)) rays.push_back({rayThrough(camera, size, place), {}});
  return rays;
}

glm::dvec4 at(const std::vector<glm::dvec4>& picture, glm::ivec2 pixel) {
  return picture[static_cast<std::size_t>(pixel.y * size.x + pixel.x)];
}

TEST(ReferenceWalls, ColoursAreGreysUnderTheWindow) {
  Scene scene = rampAlongX();
  scene.look.method.of<methods::Walls>().outlines = false;
  ShownSlices slices{.crosshair = glm::dvec3(3.0, 15.0, 4.0), .window = WindowLevel{100.0, 100.0}};
  for (const bool inverted : {false, true}) {
    slices.inverted = inverted;
    const std::vector<glm::dvec4> walls = wallColours(scene, front(), size, slices, raysOf(front()));
    int compared = 0;
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) {
        const glm::dvec2 place = placeOf({i, j});
        // Lines where other slices cut are half a mm wide, and a pixel is one.
        if (std::abs(place.x - 3.0) < 0.6 || std::abs(place.y - 4.0) < 0.6) continue;
        const glm::dvec4 colour = at(walls, {i, j});
        // The rim's box is a pixel wide.
        const double inwards = std::min({place.x + 0.5, 19.5 - place.x, place.y + 0.5, 23.5 - place.y});
        const double opacity = std::clamp(0.5 + inwards / 0.5, 0.0, 1.0);
        const double grey = std::clamp((10.0 * std::clamp(place.x, 0.0, 19.0) - 50.0) / 100.0, 0.0, 1.0);
        EXPECT_NEAR(colour.a, opacity, 1e-12) << i << ", " << j;
        EXPECT_NEAR(colour.r, opacity * (inverted ? 1.0 - grey : grey), 1e-12) << i << ", " << j;
        EXPECT_EQ(colour.r, colour.b);
        ++compared;
      }
    EXPECT_GT(compared, 4000);
  }
}

TEST(ReferenceWalls, LinesHaveTheirWidth) {
  const Scene scene = rampAlongX();
  const ShownSlices slices{.crosshair = glm::dvec3(3.0, 15.0, 4.0), .window = WindowLevel{1.0, 1000.0}};  // all black
  const std::vector<glm::dvec4> walls = wallColours(scene, front(), size, slices, raysOf(front()));
  const Wall wall = wallsAt(*wallsOf(scene.look), grid, slices, front())[2];
  EXPECT_EQ(wall.plane, SlicePlane::Coronal);
  EXPECT_EQ(lineWidth(wall, grid), 0.5) << "half a voxel";
  double sum = 0.0;
  for (int i = 0; i < size.x; ++i) sum += at(walls, {i, 20}).g;
  EXPECT_NEAR(sum * 0.5, 0.5 * 0.85, 1e-9) << "mm of the line's colour, whose green is 0.85";
}

TEST(ReferenceWalls, AreNaNFreeWhereVoxelsAreNot) {
  Scene scene = rampAlongX();
  scene.volume = volumeOf(grid, [](glm::ivec3 i) { return i.x < 10 ? nan : i.x < 15 ? infinity : 7.0 * i.z; });
  for (const glm::dvec4& colour : wallColours(scene, front(), size, {}, raysOf(front())))
    for (int channel = 0; channel < 4; ++channel) {
      EXPECT_GE(colour[channel], 0.0);
      EXPECT_LE(colour[channel], 1.0);
    }
}

TEST(ReferenceWalls, AroundTheVolumeTheyLieBehindThePicture) {
  Scene scene = rampAlongX();
  scene.look.shading.enabled = false;
  const Camera camera = Camera::fromAngles(30.0, 20.0, grid);
  // Haze of an optical depth that varies from ray to ray.
  scene.look.context.function = {{{0.0, {glm::dvec3(0.2, 0.6, 0.9), 0.03}}}};
  const ShownSlices slices{.window = WindowLevel{200.0, 100.0}};
  PictureOptions options;
  options.slices = slices;
  const Picture with = picture(scene, camera, size, options);
  Scene plain = scene;
  plain.look.method = {};
  const Picture without = picture(plain, camera, size, options);
  ASSERT_EQ(with.walls.size(), with.final.size());
  EXPECT_TRUE(without.walls.empty());
  int through = 0;
  for (std::size_t i = 0; i < with.final.size(); ++i) {
    const glm::dvec4 expected = without.final[i] + (1.0 - without.final[i].a) * with.walls[i];
    EXPECT_LT(glm::distance(with.final[i], expected), 1e-12);
    through += without.final[i].a > 0.1 && without.final[i].a < 0.9 && with.walls[i].a == 1.0;
  }
  EXPECT_GT(through, 500) << "walls that show through the volume";
}

/// A block that hides a ball in focus.
Scene openedBlock() {
  Scene scene;
  scene.volume = volumeOf(grid, [](glm::ivec3 i) { return i.y < 3 ? 0.0 : 100.0; });
  scene.labels = labelsOf(
      grid, [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - glm::dvec3(9.5, 20.0, 11.5)) < 4.0 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(50.0);
  scene.look.cutaway.openWidth = 12.0;
  scene.look.method = methods::Walls{.placement = WallPlacement::Inside, .outlines = false};
  return scene;
}

/// The coronal slice cuts the opening across: seen from the front, it shows between the context's surface, at y = 2.5,
/// and the cut face behind it, on rays beside the focus.
TEST(ReferenceWalls, InsideTheOpeningTheyShowInWhatIsRemoved) {
  Scene scene = openedBlock();
  scene.look.method.of<methods::Walls>().axial = scene.look.method.of<methods::Walls>().sagittal = false;
  const Camera camera = front();
  const Stages stages = geometricStages(scene, camera, size);
  PictureOptions options;
  options.slices = {.crosshair = glm::dvec3(9.5, 8.0, 11.5), .window = WindowLevel{400.0, 100.0}};
  const Picture made = picture(scene, camera, size, stages, options);
  const double tWall = 8.0 - camera.eye.y;  // the ray runs along y
  int shown = 0, focus = 0, context = 0;
  for (std::size_t i = 0; i < made.walls.size(); ++i) {
    const bool opened =
        std::isnan(stages.hits.tFocus[i]) && stages.hits.tContext[i] <= tWall && tWall < stages.tStart[i];
    EXPECT_LT(glm::distance(made.walls[i], glm::dvec4(glm::dvec3(opened ? 0.5 : 0.0), opened)), 1e-12) << i;
    if (opened) {
      EXPECT_EQ(made.final[i], made.walls[i]) << "opaque, before all that is left";
      ++shown;
    }
    focus += !std::isnan(stages.hits.tFocus[i]) && tWall < stages.tStart[i];
    context += stages.tStart[i] == stages.hits.tContext[i];
  }
  EXPECT_GT(shown, 100);
  EXPECT_GT(focus, 100) << "it gives way to the focus behind it";
  EXPECT_GT(context, 100);
  scene.look.cutaway.enabled = false;
  EXPECT_TRUE(picture(scene, camera, size, options).walls.empty()) << "without an opening there is none";
}

/// A ray shows the nearest of three walls that it meets within the opening: analytic depths along oblique rays.
TEST(ReferenceWalls, TheNearestWallShows) {
  const Scene scene = openedBlock();
  const Camera camera = Camera::fromAngles(35.0, 25.0, grid);
  const ShownSlices slices{.crosshair = glm::dvec3(6.0, 9.0, 14.0)};
  std::vector<WallRay> rays = raysOf(camera);
  std::vector<double> nearest;
  for (WallRay& ray : rays) {
    double least = infinity;
    for (int axis = 0; axis < 3; ++axis) {
      const double t = ((*slices.crosshair)[axis] - ray.ray.origin[axis]) / ray.ray.direction[axis];
      const glm::dvec3 point = ray.ray.origin + t * ray.ray.direction;
      const bool in = glm::all(glm::greaterThan(point, glm::dvec3(0.5))) &&
                      glm::all(glm::lessThan(point, glm::dvec3(grid.dims) - 1.5));
      if (in) least = std::min(least, t);
    }
    nearest.push_back(least);
  }
  int seen = 0, compared = 0;
  for (const double offset : {-1e-6, 1e-6}) {
    for (std::size_t i = 0; i < rays.size(); ++i)
      rays[i].shown = Span{0.0, std::isfinite(nearest[i]) ? nearest[i] + offset : 0.0};
    const std::vector<glm::dvec4> walls = wallColours(scene, camera, size, slices, rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (!std::isfinite(nearest[i])) continue;
      ++compared;
      // Another wall's half transparent rim may lie before it: a pixel wide, on walls of some 30 pixels.
      seen += walls[i].a == (offset > 0.0 ? 1.0 : 0.0);
    }
  }
  EXPECT_GT(compared, 1500);
  EXPECT_GT(seen, 0.9 * compared) << "there is one from its depth on, and just before there is none";
}

}  // namespace
}  // namespace fenestra::reference::referenceWallsTest
