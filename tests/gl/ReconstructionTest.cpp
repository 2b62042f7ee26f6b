// Splines between the voxels: hits and bounded pictures against the reference's spline, and the
// fallback where the device has no room for one.

#include "rendering/reference/Picture.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests::reconstructionTest {
namespace {

constexpr glm::ivec2 size{64, 52};

using ReconstructionTest = GlTest;

/// Values that bend strongly from voxel to voxel, with a ball of label 1.
Scene coarse(const Grid& grid, Reconstruction reconstruction, double amplitude = 60.0) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-amplitude, amplitude);
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = (glm::dvec3(i) + 0.5) / glm::dvec3(grid.dims) * 2.0 - 1.0;
    return 1000.0 * (1.0 - glm::length(p)) + 200.0 * std::sin(7.0 * p.x) * std::cos(5.0 * p.y + p.z) + noise(random);
  });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) {
    return glm::length(glm::dvec3(i) - (glm::dvec3(grid.dims) - 1.0) * 0.5) < 3.0 ? 1 : 0;
  });
  scene.look.context.function = {{{150.0, {{0.9, 0.6, 0.3}, 0.0}},
                                  {300.0, {{0.9, 0.7, 0.5}, 0.3}},
                                  {600.0, {{0.5, 0.2, 0.7}, 0.05}},
                                  {900.0, {{0.3, 0.9, 0.4}, 0.8}}}};
  scene.look.cutaway.openWidth = 9.0;
  scene.look.reconstruction = reconstruction;
  return scene;
}

Camera aside(const Grid& grid) { return Camera::fromAngles(33, 21, grid, Projection::Perspective); }

TEST_F(ReconstructionTest, Thorough_HitsAreThoseOfTheSpline) {
  for (const Reconstruction kind : {Reconstruction::Cubic, Reconstruction::Smooth, Reconstruction::Smoother})
    for (const Grid& grid : {gridOf({14, 12, 13}, glm::dvec3(3.0)), obliqueGrid({16, 13, 9})}) {
      // In white noise of 60 hits are 0.0016 voxels off at the 99.9th percentile; scans are smoother.
      Scene scene = coarse(grid, kind, 20.0);
      scene.look.focus = LabelFocus{{1}};
      expectStagesMatch(scene, aside(grid), size);
      scene.look.focus = ValueFocus{{650.0, 1e9}, 100.0};
      expectStagesMatch(scene, aside(grid), size);
    }
}

TEST_F(ReconstructionTest, HitsDifferFromThoseOfTrilinearValues) {
  const Grid grid = gridOf({14, 12, 13}, glm::dvec3(3.0));
  Scene scene = coarse(grid, Reconstruction::Cubic);
  scene.look.focus = LabelFocus{{1}};
  Scene straight = scene;
  straight.look.reconstruction = Reconstruction::Linear;
  const reference::HitPoints linear = reference::hitPoints(straight, aside(grid), size);
  // Else the test above would hold for either.
  EXPECT_GT(compareMaps(renderOnce(scene, aside(grid), size).layers.tContext, linear.tContext, 3.0).percentile(0.5),
            0.01);
}

TEST_F(ReconstructionTest, DraftsMeetWhatLiesBetweenTheSplinesSamples) {
  const Grid grid = gridOf({14, 12, 13}, glm::dvec3(3.0));
  Scene scene = coarse(grid, Reconstruction::Cubic);
  scene.look.focus = LabelFocus{{1}};
  const auto hitsOf = [&](Quality quality) {
    Renderer renderer(std::make_shared<GpuScene>());
    renderer.render(scene, {.camera = aside(grid), .size = size, .quality = quality});
    return renderer.readLayers().tContext;
  };
  const reference::Image truth = reference::hitPoints(scene, aside(grid), size).tContext;
  const auto draft = compareMaps(hitsOf(Quality::Draft), truth, 3.0);
  const auto normal = compareMaps(hitsOf(Quality::Normal), truth, 3.0);
  EXPECT_GT(draft.percentile(0.5), 10.0 * normal.percentile(0.5)) << "they are no hits of the spline";
  // A third of a voxel apart, samples leave a ninth of the error of trilinear values, which is above 0.01 (below).
  EXPECT_LT(draft.percentile(0.5), 0.01);
}

/// Greatest error of the finished picture, over all pixels and channels, in 1/255.
double errorOf(const Scene& scene, const View& view, Schedule schedule, const reference::Picture& truth) {
  const auto gpu = std::make_shared<GpuScene>();
  gpu->setSchedule(schedule);
  Renderer renderer(gpu);
  renderer.render(scene, view);
  const Layers layers = renderer.readLayers();
  double worst = 0.0;
  for (std::size_t i = 0; i < truth.final.size(); ++i)
    for (int channel = 0; channel < 4; ++channel) {
      const double error = 255.0 * std::abs(layers.final[i][channel] - truth.final[i][channel]);
      worst = std::isnan(error) ? infinity : std::max(worst, error);
    }
  return worst;
}

double errorOf(const Scene& scene, const View& view, Schedule schedule) {
  return errorOf(scene, view, schedule, reference::picture(scene, view.camera, view.size));
}

TEST_F(ReconstructionTest, Thorough_BoundsHoldLitAndUnlitInBothSchedules) {
  const Grid grid = gridOf({14, 12, 13}, glm::dvec3(3.0));
  constexpr glm::ivec2 large{128, 104};  // more than 10 000 pixels
  for (const Reconstruction kind : {Reconstruction::Cubic, Reconstruction::Smooth, Reconstruction::Smoother})
    for (const bool lit : {false, true}) {
      Scene scene = coarse(grid, kind);
      scene.look.shading.enabled = lit;
      View view{.camera = aside(grid), .size = large};
      const reference::Picture truth = reference::picture(scene, view.camera, view.size);
      for (const Schedule schedule : pictureSchedules())
        for (const double bound : {4.0, 2.0, 1.0, 0.5}) {
          view.maxError = bound;
          EXPECT_LE(errorOf(scene, view, schedule, truth), bound)
              << "kind " << int(kind) << ", lit " << lit << ", schedule " << int(schedule);
        }
    }
}

TEST_F(ReconstructionTest, BoundsHoldWithAnOpeningAroundLabelsAndValues) {
  const Grid grid = obliqueGrid({16, 13, 9});
  Scene scene = coarse(grid, Reconstruction::Cubic);
  scene.look.contextLayer.strength = 0.6;
  View view{.camera = aside(grid), .size = size};
  view.maxError = 1.0;
  for (const Focus& focus : {Focus(LabelFocus{{1}}), Focus(ValueFocus{{650.0, 1e9}, 100.0})}) {
    scene.look.focus = focus;
    EXPECT_LE(errorOf(scene, view, Schedule::Llvmpipe), 1.0);
  }
}

TEST_F(ReconstructionTest, ThinAxesAndNumbersThatAreNone) {
  for (const glm::ivec3 dims : {glm::ivec3(1, 1, 1), glm::ivec3(9, 1, 2), glm::ivec3(3, 8, 1)}) {
    Scene scene;
    scene.volume = volumeOf<float>(gridOf(dims), [](glm::ivec3 i) {
      return i.x == 2 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(100 + 50 * i.x - 30 * i.y);
    });
    scene.look.context.function = {{{0.0, {{1.0, 0.2, 0.1}, 0.1}}, {300.0, {{0.8, 0.7, 0.3}, 0.4}}}};
    scene.look.reconstruction = Reconstruction::Cubic;
    View view{.camera = aside(scene.volume->grid), .size = size};
    view.maxError = 0.5;
    EXPECT_LE(errorOf(scene, view, usualSchedule()), 0.5);
  }
}

TEST_F(ReconstructionTest, WithoutRoomValuesAreTrilinearAndANoticeSaysSo) {
  const Grid grid = gridOf({14, 12, 13}, glm::dvec3(3.0));
  const auto drawn = [&](const Scene& scene, const DeviceLimits& limits, std::string& notice) {
    const auto gpu = std::make_shared<GpuScene>();
    gpu->setLimits(limits);
    Renderer renderer(gpu);
    renderer.render(scene, {.camera = aside(grid), .size = size});
    notice = gpu->reductionNotice();
    return renderer.readPicture();
  };
  std::string notice;
  const Scene cubic = coarse(grid, Reconstruction::Cubic), linear = coarse(grid, Reconstruction::Linear);
  const auto straight = drawn(linear, {2048, {}}, notice);
  EXPECT_EQ(notice, "");
  EXPECT_NE(drawn(cubic, {2048, {}}, notice), straight);
  EXPECT_EQ(notice, "");
  for (const DeviceLimits& limits : {DeviceLimits{2048, std::size_t{100'000}}, DeviceLimits{32, {}}}) {
    EXPECT_EQ(drawn(cubic, limits, notice), straight);
    EXPECT_NE(notice.find("straight lines"), std::string::npos) << notice;
  }
}

}  // namespace
}  // namespace fenestra::tests::reconstructionTest
