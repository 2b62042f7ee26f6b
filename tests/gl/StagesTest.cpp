// Stages 1 to 4 of the renderer against the double-precision reference. The hard cases have a file of their own.

#include "tests/gl/GlTest.h"

namespace fenestra::tests::stagesTest {
namespace {

constexpr glm::ivec2 small{96, 80};

/// A bumpy field whose level sets are curved everywhere.
double bumps(glm::ivec3 index, glm::ivec3 dims) {
  const glm::dvec3 p = (glm::dvec3(index) + 0.5) / glm::dvec3(dims) * 2.0 - 1.0;
  return 1000.0 * (1.0 - glm::length(p)) + 120.0 * std::sin(7.0 * p.x) * std::cos(5.0 * p.y + p.z);
}

int ballLabel(glm::ivec3 index, glm::ivec3 dims, double radius) {
  const glm::dvec3 p = glm::dvec3(index) - (glm::dvec3(dims) - 1.0) * 0.5;
  return glm::length(p) < radius ? 1 : 0;
}

/// A ball of label 1 inside a bumpy body.
Scene ballInBody(const Grid& grid, double radius = 6.0) {
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) { return bumps(i, grid.dims); });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return ballLabel(i, grid.dims, radius); });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(200.0);
  scene.look.cutaway.openWidth = 9.0;
  return scene;
}

Camera from(double azimuth, double elevation, const Grid& grid, Projection projection = Projection::Perspective) {
  return Camera::fromAngles(azimuth, elevation, grid, projection);
}

using Stages = GlTest;

TEST_F(Stages, LabelFocusFromManySides) {
  const Scene scene = ballInBody(gridOf({40, 36, 44}));
  for (const glm::dvec2 angles :
       {glm::dvec2(0, 0), glm::dvec2(37, 21), glm::dvec2(90, 0), glm::dvec2(201, -64), glm::dvec2(0, 90)})
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
      expectStagesMatch(scene, from(angles.x, angles.y, scene.volume->grid, projection), small);
}

TEST_F(Stages, ObliqueAnisotropicAndShearedGrids) {
  Grid oblique = obliqueGrid({40, 36, 20});
  expectStagesMatch(ballInBody(oblique), from(30, 10, oblique), small);
  Grid sheared = gridOf({40, 36, 24}, {0.6, 0.6, 1.7});
  sheared.direction[2] = glm::normalize(glm::dvec3(0.0, -0.33, 1.0));
  expectStagesMatch(ballInBody(sheared), from(-50, 25, sheared), small);
  Grid flipped = gridOf({40, 36, 24});
  flipped.direction[0] = {-1.0, 0.0, 0.0};
  expectStagesMatch(ballInBody(flipped), from(10, 5, flipped), small);
}

TEST_F(Stages, ValueFocusWithIslandsDropped) {
  const Grid grid = gridOf({48, 48, 48});
  Scene scene = ballInBody(grid);
  // A large body, and specks beside it below the least size.
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) {
    const glm::ivec3 speck = (i + glm::ivec3(2, 5, 7)) % 16;
    return speck.x < 2 && speck.y < 2 && speck.z < 2 ? 1900.0 : bumps(i, grid.dims);
  });
  scene.look.focus = ValueFocus{{700.0, 2000.0}, 60.0};
  expectStagesMatch(scene, from(20, 30, grid), small);
  // With none dropped there are more hits: the test above would notice if dropping did nothing.
  const auto known = [&](const Scene& s) {
    const std::vector<float> t = renderOnce(s, from(20, 30, grid), small).layers.tFocus;
    return std::count_if(t.begin(), t.end(), [](float v) { return !std::isnan(v); });
  };
  const auto withDropped = known(scene);
  scene.look.focus = ValueFocus{{700.0, 2000.0}, 0.0};
  expectStagesMatch(scene, from(20, 30, grid), small);
  EXPECT_GT(known(scene), withDropped + 20);
}

TEST_F(Stages, ValueRangeCrossedInsideACell) {
  // Neighbours far below and far above: no voxel lies in the range, the surface between them does.
  const Grid grid = gridOf({12, 12, 12});
  Scene scene = valueScene(
      grid, [](glm::ivec3 i) { return i.z < 6 ? -1000.0 : 3000.0; }, 100.0, 200.0);
  expectStagesMatch(scene, from(15, 70, grid), small);
  const Layers layers = renderOnce(scene, from(0, 90, grid, Projection::Orthographic), small).layers;
  EXPECT_GT(std::count_if(layers.tFocus.begin(), layers.tFocus.end(), [](float t) { return !std::isnan(t); }), 1000);
}

TEST_F(Stages, SeveralTransparentGaps) {
  const Grid grid = gridOf({32, 32, 32});
  Scene scene = ballInBody(grid);
  // Visible in a thin shell of values, then transparent, then visible again.
  const OpticalProperties seen{glm::dvec3(1.0), 3.0}, clear{glm::dvec3(1.0), 0.0};
  scene.look.context.function = {{{100.0, clear}, {130.0, seen}, {160.0, clear}, {500.0, clear}, {501.0, seen}}};
  expectStagesMatch(scene, from(40, -20, grid), small);
}

TEST_F(Stages, EveryVoxelType) {
  const Grid grid = gridOf({24, 24, 24});
  const auto check = [&]<class T>(T, double scale, double shift, double slope, double intercept) {
    Scene scene = ballInBody(grid);
    auto volume = volumeOf<T>(grid, [&](glm::ivec3 i) { return std::round(bumps(i, grid.dims) * scale + shift); });
    volume->slope = slope;
    volume->intercept = intercept;
    volume->computeRange();
    const double level = slope * (200.0 * scale + shift) + intercept;
    scene.look.context.function = opaqueFrom(level);
    if (slope < 0.0) scene.look.context.function = {{{level, {glm::dvec3(1.0), 5.0}}, {level, {glm::dvec3(1.0), 0.0}}}};
    scene.volume = volume;
    expectStagesMatch(scene, from(25, 15, grid), small);
  };
  check(std::uint8_t{}, 0.1, 90.0, 1.0, 0.0);
  check(std::int8_t{}, 0.1, 0.0, 1.0, 0.0);
  check(std::uint16_t{}, 30.0, 26000.0, 1.0, -1024.0);
  check(std::int16_t{}, 25.0, 0.0, 0.5, 10.0);
  check(std::int16_t{}, 25.0, 0.0, -2.0, 0.0);
  check(std::uint32_t{}, 1e5, 1.2e8, 1.0, 0.0);
  check(std::int32_t{}, 1.0, 0.0, 1.0, 0.0);
  check(float{}, 1e-3, 0.0, 1.0, 0.0);
  check(double{}, 1e-3, 0.0, 1.0, 0.0);
}

}  // namespace
}  // namespace fenestra::tests::stagesTest
