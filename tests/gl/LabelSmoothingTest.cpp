// Smoothed surfaces of labels: hits and bounded pictures against the reference, what they cost while they are off, and
// that they follow the labels.

#include "rendering/gpu/FocusIndex.h"
#include "rendering/reference/Picture.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests::labelSmoothingTest {
namespace {

constexpr glm::ivec2 size{64, 52};
constexpr std::array<LabelSmoothing, 2> strengths{LabelSmoothing::Light, LabelSmoothing::Strong};

using LabelSmoothingTest = GlTest;

/// Two organs, one with a thin stalk and a single voxel beside it, in a body of noise.
Scene body(const Grid& grid, LabelSmoothing smoothing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-12.0, 12.0);
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = (glm::dvec3(i) + 0.5) / glm::dvec3(grid.dims) * 2.0 - 1.0;
    return 1000.0 * (1.0 - glm::length(p)) + 100.0 * std::sin(5.0 * p.x) * std::cos(4.0 * p.y + p.z) + noise(random);
  });
  const glm::dvec3 middle = (glm::dvec3(grid.dims) - 1.0) * 0.5;
  const auto labels = labelsOf(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = glm::dvec3(i) - middle;
    if (glm::length(p + glm::dvec3(2, 0, 0)) < 3.2) return 1;
    if (i.y == grid.dims.y / 2 && i.z == grid.dims.z / 2 && p.x > 0 && p.x < 5) return 1;
    if (i == glm::ivec3(middle) + glm::ivec3(-2, 4, 3)) return 1;
    return glm::length(p - glm::dvec3(2, 2, -3)) < 2.5 ? 2 : 0;
  });
  labels->labels = {{1, "one", {1.0, 0.4, 0.2}}, {2, "two", {0.2, 0.5, 1.0}}};
  scene.labels = labels;
  scene.look.focus = LabelFocus{{1, 2}};
  scene.look.context.function = {{{150.0, {{0.9, 0.6, 0.3}, 0.0}},
                                  {300.0, {{0.9, 0.7, 0.5}, 0.3}},
                                  {600.0, {{0.5, 0.2, 0.7}, 0.05}},
                                  {900.0, {{0.3, 0.9, 0.4}, 0.8}}}};
  scene.look.cutaway.openWidth = 9.0;
  scene.look.labelSmoothing = smoothing;
  return scene;
}

Camera aside(const Grid& grid) { return Camera::fromAngles(33, 21, grid, Projection::Perspective); }

TEST_F(LabelSmoothingTest, Thorough_HitsAreThoseOfTheReference) {
  for (const LabelSmoothing strength : strengths)
    for (const Grid& grid : {gridOf({18, 17, 16}, glm::dvec3(3.0)), obliqueGrid({21, 17, 12})}) {
      Scene scene = body(grid, strength);
      expectStagesMatch(scene, aside(grid), size);
      scene.look.reconstruction = Reconstruction::Cubic;
      expectStagesMatch(scene, aside(grid), size);
    }
}

TEST_F(LabelSmoothingTest, HitsDifferFromThoseOfSteps) {
  const Grid grid = gridOf({18, 17, 16}, glm::dvec3(3.0));
  const reference::HitPoints steps = reference::hitPoints(body(grid, LabelSmoothing::Off), aside(grid), size);
  for (const LabelSmoothing strength : strengths) {
    const Layers layers = renderOnce(body(grid, strength), aside(grid), size).layers;
    const StageErrors moved = compareMaps(layers.tFocus, steps.tFocus, 3.0);
    // Else the test above would hold for either. A ray crosses the surface aslant, so it may move by more along it.
    EXPECT_GT(moved.percentile(0.5), 0.02);
    EXPECT_LT(moved.percentile(0.9), 1.0);
  }
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

TEST_F(LabelSmoothingTest, Thorough_BoundsHoldLitAndUnlit) {
  const Grid grid = gridOf({18, 17, 16}, glm::dvec3(3.0));
  for (const LabelSmoothing strength : strengths)
    for (const bool lit : {false, true})
      for (const bool open : {false, true}) {
        Scene scene = body(grid, strength);
        scene.look.shading.enabled = lit;
        scene.look.cutaway.enabled = open;
        View view{.camera = aside(grid), .size = {128, 104}};  // more than 10 000 pixels
        const reference::Picture truth = reference::picture(scene, view.camera, view.size);
        for (const Schedule schedule : pictureSchedules())
          for (const double bound : {4.0, 2.0, 1.0, 0.5}) {
            view.maxError = bound;
            EXPECT_LE(errorOf(scene, view, schedule, truth), bound)
                << "strength " << int(strength) << ", lit " << lit << ", open " << open << ", schedule "
                << int(schedule);
          }
      }
}

std::map<std::string, std::size_t> resourcesOf(const GpuScene& gpu) {
  std::map<std::string, std::size_t> bytes;
  for (const GpuScene::Resource& resource : gpu.resources()) bytes[resource.name] = resource.bytes;
  return bytes;
}

TEST_F(LabelSmoothingTest, SwitchedOffItLeavesNothingBehind) {
  const Grid grid = gridOf({18, 17, 16}, glm::dvec3(3.0));
  const View view{.camera = aside(grid), .size = size};
  const auto never = std::make_shared<GpuScene>(), toggled = std::make_shared<GpuScene>();
  Renderer plain(never), other(toggled);
  plain.render(body(grid, LabelSmoothing::Off), view);
  EXPECT_EQ(never->focus().smoothed, nullptr);
  Scene scene = body(grid, LabelSmoothing::Strong);
  other.render(scene, view);
  EXPECT_NE(other.readPicture(), plain.readPicture());
  EXPECT_NE(resourcesOf(*toggled), resourcesOf(*never));
  scene.look.labelSmoothing = LabelSmoothing::Off;
  other.render(scene, view);
  EXPECT_EQ(other.readPicture(), plain.readPicture());
  EXPECT_EQ(toggled->focus().smoothed, nullptr);
  EXPECT_EQ(resourcesOf(*toggled), resourcesOf(*never));
}

TEST_F(LabelSmoothingTest, OtherFocusesAreDrawnAsWithout) {
  const Grid grid = gridOf({18, 17, 16}, glm::dvec3(3.0));
  const View view{.camera = aside(grid), .size = size};
  for (const Focus& focus : {Focus(), Focus(ValueFocus{{650.0, 1e9}, 100.0})}) {
    Scene off = body(grid, LabelSmoothing::Off), on = body(grid, LabelSmoothing::Strong);
    off.look.focus = on.look.focus = focus;
    const auto gpu = std::make_shared<GpuScene>();
    Renderer plain(std::make_shared<GpuScene>()), other(gpu);
    plain.render(off, view);
    other.render(on, view);
    EXPECT_EQ(other.readPicture(), plain.readPicture());
    EXPECT_EQ(gpu->focus().smoothed, nullptr);
  }
}

TEST_F(LabelSmoothingTest, ItFollowsTheLabelsAndTheStrength) {
  const Grid grid = gridOf({18, 17, 16}, glm::dvec3(3.0));
  const View view{.camera = aside(grid), .size = size};
  Scene scene = body(grid, LabelSmoothing::Light);
  const auto gpu = std::make_shared<GpuScene>();
  Renderer reused(gpu);
  reused.render(scene, view);
  const std::vector<std::function<void()>> changes{
      [&] { scene.look.focus = LabelFocus{{1}}; },
      [&] { scene.look.labelSmoothing = LabelSmoothing::Strong; },
      [&] {
        scene.look.focus = LabelFocus{{1, 2}};
      },
      [&] { scene.look.labelSmoothing = LabelSmoothing::Off; },
      [&] { scene.look.focus = LabelFocus{{2}}; },
      [&] { scene.look.labelSmoothing = LabelSmoothing::Light; },
      [&] { scene.labels = labelsOf(grid, [](glm::ivec3 i) { return i.x > 8 && i.y > 6 ? 2 : 0; }); },
      [&] { scene.look.shading.enabled = false; },
      [&] { scene.look.shading.enabled = true; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    changes[i]();
    EXPECT_EQ(gpu->holds(scene), i == 7) << "change " << i;  // light alone is dropped in no time
    reused.render(scene, view);
    EXPECT_TRUE(gpu->holds(scene));
    Renderer fresh(std::make_shared<GpuScene>());
    fresh.render(scene, view);
    EXPECT_EQ(reused.readPicture(), fresh.readPicture()) << "change " << i;
  }
}

}  // namespace
}  // namespace fenestra::tests::labelSmoothingTest
