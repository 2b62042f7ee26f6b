// Stages 1 to 4 of the renderer against the double-precision reference, on ordinary scenes and on the hard ones.

#include "rendering/scene/Phantom.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests {
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
  scene.focus = LabelFocus{{1}};
  scene.context = opaqueFrom(200.0);
  scene.cutaway.openWidth = 9.0;
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
  scene.focus = ValueFocus{{700.0, 2000.0}, 60.0};
  expectStagesMatch(scene, from(20, 30, grid), small);
  // With none dropped there are more hits: the test above would notice if dropping did nothing.
  const auto known = [&](const Scene& s) {
    const std::vector<float> t = renderOnce(s, from(20, 30, grid), small).layers.tFocus;
    return std::count_if(t.begin(), t.end(), [](float v) { return !std::isnan(v); });
  };
  const auto withDropped = known(scene);
  scene.focus = ValueFocus{{700.0, 2000.0}, 0.0};
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
  scene.context = {{{100.0, clear}, {130.0, seen}, {160.0, clear}, {500.0, clear}, {501.0, seen}}};
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
    scene.context = opaqueFrom(level);
    if (slope < 0.0) scene.context = {{{level, {glm::dvec3(1.0), 5.0}}, {level, {glm::dvec3(1.0), 0.0}}}};
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

TEST_F(Stages, FullSixteenBitRange) {
  const Grid grid = gridOf({16, 16, 16});
  Scene scene = ballInBody(grid, 3.0);
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return i.x < 8 ? -32768 : 32767; });
  scene.context = opaqueFrom(12.0);
  expectStagesMatch(scene, from(-70, 10, grid), small);
  scene.volume = volumeOf<std::uint16_t>(grid, [](glm::ivec3 i) { return i.x < 8 ? 0 : 65535; });
  scene.context = opaqueFrom(65000.0);
  expectStagesMatch(scene, from(-70, 10, grid), small);
}

TEST_F(Stages, NotANumberAndInfinity) {
  const Grid grid = gridOf({20, 20, 20});
  Scene scene = ballInBody(grid, 4.0);
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3 i) {
    if (i.x % 7 == 2 && i.y % 5 == 1) return nan;
    if (i.x % 9 == 4 && i.z % 6 == 3) return i.y % 2 ? infinity : -infinity;
    return bumps(i, grid.dims);
  });
  expectStagesMatch(scene, from(33, 12, grid), small);
}

TEST_F(Stages, HugeValue) {
  const Grid grid = gridOf({20, 20, 20});
  Scene scene = ballInBody(grid, 4.0);
  scene.volume =
      volumeOf<float>(grid, [&](glm::ivec3 i) { return i == glm::ivec3(4, 5, 6) ? 1e30 : bumps(i, grid.dims); });
  expectStagesMatch(scene, from(33, 12, grid), small);
}

TEST_F(Stages, AxisParallelRaysOnSlabAndVoxelPlanes) {
  const Grid grid = gridOf({16, 16, 16});
  const Scene scene = ballInBody(grid, 4.0);
  // Parallel rays whose x and z run over voxel centres, cell faces and the box's own faces.
  Camera camera = from(0, 0, grid, Projection::Orthographic);
  camera.orthographicHeight = 20.0;
  expectStagesMatch(scene, camera, {40, 40});
  camera.orthographicHeight = 16.0;
  expectStagesMatch(scene, camera, {32, 32});
}

TEST_F(Stages, CameraInsideTheVolumeAndInsideTheFocus) {
  const Grid grid = gridOf({32, 32, 32});
  const Scene scene = ballInBody(grid);
  expectStagesMatch(scene, lookAt({15.0, 4.0, 16.0}, {15.5, 16.0, 15.5}), small);
  expectStagesMatch(scene, lookAt({15.0, 15.0, 16.0}, {15.5, 30.0, 12.0}), small);
  expectStagesMatch(scene, lookAt({15.0, 30.0, 16.0}, {15.5, 60.0, 12.0}), small);  // looking out
  expectStagesMatch(scene, lookAt({15.0, 15.0, 16.0}, {15.5, 30.0, 12.0}, Projection::Orthographic, 20.0), small);
}

TEST_F(Stages, CameraAThousandKilometresAway) {
  const Grid grid = gridOf({32, 32, 32});
  Camera camera = lookAt({3e5, -9e5, 2e5}, grid.centre());
  camera.verticalFov = 2.2e-3;
  expectStagesMatch(ballInBody(grid), camera, small);
}

TEST_F(Stages, ExtremeSpacingsAndOrigins) {
  const Grid thin = gridOf({40, 40, 12}, {0.05, 0.05, 10.0});
  expectStagesMatch(ballInBody(thin, 5.0), from(20, 40, thin), small);
  const Grid far = gridOf({32, 32, 32}, glm::dvec3(1.0), {1e6, -1e6, 1e6});
  expectStagesMatch(ballInBody(far), from(20, 40, far), small);
}

TEST_F(Stages, DegenerateDimensions) {
  for (const glm::ivec3 dims : {glm::ivec3(1), glm::ivec3(1, 14, 11), glm::ivec3(14, 1, 11), glm::ivec3(14, 11, 1)}) {
    const Grid grid = gridOf(dims);
    Scene scene = ballInBody(grid, 3.0);
    scene.context = opaqueFrom(scene.volume->range.low - 1.0);
    expectStagesMatch(scene, from(25, 35, grid), small);
  }
}

TEST_F(Stages, ConstantVolume) {
  const Grid grid = gridOf({10, 10, 10});
  Scene scene = ballInBody(grid, 3.0);
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3) { return 42; });
  for (const double level : {41.0, 43.0}) {
    scene.context = opaqueFrom(level);
    expectStagesMatch(scene, from(25, 35, grid), small);
  }
}

TEST_F(Stages, FocusOfOneVoxelEmptyEverythingAndAtTheBorder) {
  const Grid grid = gridOf({20, 20, 20});
  Scene scene = ballInBody(grid);
  const auto withLabels = [&](auto&& labelAt) {
    scene.labels = labelsOf(grid, labelAt);
    expectStagesMatch(scene, from(30, 20, grid), small);
  };
  withLabels([](glm::ivec3 i) { return i == glm::ivec3(9, 11, 8) ? 1 : 0; });
  withLabels([](glm::ivec3) { return 0; });
  withLabels([](glm::ivec3) { return 1; });
  withLabels([](glm::ivec3 i) { return i.x == 0 || i.z == 19 ? 1 : 0; });
  withLabels([](glm::ivec3 i) { return (i.x + i.y + i.z) % 2; });
  withLabels([](glm::ivec3 i) { return i.y == 10 ? 1 : 0; });  // one voxel thin
}

TEST_F(Stages, FocusOutOfView) {
  const Grid grid = gridOf({32, 32, 32});
  const Scene scene = ballInBody(grid, 3.0);
  Camera camera = lookAt({-40.0, -60.0, 15.0}, {-40.0, 15.0, 15.0});
  expectStagesMatch(scene, camera, small);
}

TEST_F(Stages, WidthsFromZeroToWiderThanThePicture) {
  const Grid grid = gridOf({32, 32, 32});
  Scene scene = ballInBody(grid);
  for (const glm::dvec2 widths :
       {glm::dvec2(0.0), glm::dvec2(0.0, 3.0), glm::dvec2(0.3, 0.0), glm::dvec2(70.0, 5.0), glm::dvec2(500.0)}) {
    scene.cutaway.openWidth = widths.x;
    scene.cutaway.borderWidth = widths.y;
    expectStagesMatch(scene, from(30, 20, grid), small);
  }
  scene.cutaway.unit = WidthUnit::Millimetre;
  scene.cutaway.openWidth = 6.5;
  scene.cutaway.borderWidth = 1.0;
  expectStagesMatch(scene, from(30, 20, grid), small);
  expectStagesMatch(scene, from(30, 20, grid, Projection::Orthographic), small);
}

TEST_F(Stages, OddAndTinyPictures) {
  const Grid grid = gridOf({32, 32, 32});
  const Scene scene = ballInBody(grid);
  for (const glm::ivec2 size :
       {glm::ivec2(1), glm::ivec2(1, 37), glm::ivec2(53, 1), glm::ivec2(31, 33), glm::ivec2(701, 649)})
    expectStagesMatch(scene, from(30, 20, grid), size);
}

TEST_F(Stages, UpAlongTheView) {
  const Grid grid = gridOf({24, 24, 24});
  Camera camera = from(0, 90, grid);
  camera.up = {0.0, 0.0, 1.0};
  expectStagesMatch(ballInBody(grid), camera, small);
}

TEST_F(Stages, SameFrameTwiceIsTheSameToTheBit) {
  const Grid grid = gridOf({32, 32, 32});
  const Scene scene = ballInBody(grid);
  const Camera camera = from(30, 20, grid);
  const Layers a = renderOnce(scene, camera, {160, 130}, Quality::Normal).layers;
  const Layers b = renderOnce(scene, camera, {160, 130}, Quality::Normal).layers;
  ASSERT_FALSE(a.final.empty());
  EXPECT_EQ(std::memcmp(a.final.data(), b.final.data(), a.final.size() * sizeof(glm::vec4)), 0);
  EXPECT_EQ(std::memcmp(a.tStart.data(), b.tStart.data(), a.tStart.size() * sizeof(float)), 0);
}

}  // namespace
}  // namespace fenestra::tests
