// The context's edges where they may cover but a share of the focus: how much they change, against the reference, drawn
// in tiles, and what they cost where they may cover all.

#include <random>

#include "rendering/reference/Picture.h"
#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::contextLinesTest {
namespace {

constexpr glm::ivec2 size{120, 104};

using ContextLinesTest = GlTest;

/// A ball of label 1 in a body whose values are noise: bends everywhere.
Scene noisyBody() {
  const Grid grid = gridOf({40, 38, 36});
  const glm::dvec3 centre = (glm::dvec3(grid.dims) - 1.0) * 0.5;
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 150.0);
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) {
    return 1000.0 * (1.1 - glm::length((glm::dvec3(i) - centre) / glm::dvec3(grid.dims) * 2.0)) + noise(random);
  });
  scene.labels = labelsOf(
      grid, [&](glm::ivec3 i) { return glm::length((glm::dvec3(i) - centre) / glm::dvec3(grid.dims)) < 0.3 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(300.0);
  scene.look.contextLayer = openingLooks().front().contextLayer;
  scene.look.contextLayer.valueWeight = 0.0;  // a colour that tells them from the body
  return scene;
}

Layers drawn(const Scene& scene, const View& view) {
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, view);
  return renderer.readLayers();
}

/// Share of the focus's projection that the context's edges change by more than 32/255.
double changedShare(const Scene& scene, const View& view) {
  Scene without = scene;
  without.look.contextLayer.strength = 0.0;
  const Layers with = drawn(scene, view), bare = drawn(without, view);
  std::size_t shown = 0, changed = 0;
  for (std::size_t i = 0; i < with.final.size(); ++i) {
    if (std::isnan(with.tFocus[i])) continue;
    ++shown;
    const glm::vec4 difference = glm::abs(with.final[i] - bare.final[i]);
    changed += std::max({difference.r, difference.g, difference.b}) > 32.0f / 255.0f ? 1 : 0;
  }
  EXPECT_GT(shown, 1000u);
  return static_cast<double>(changed) / static_cast<double>(shown);
}

View viewOf(const Scene& scene) { return {.camera = Camera::fromAngles(30.0, 20.0, scene.volume->grid), .size = size}; }

TEST_F(ContextLinesTest, ChangeAnEighthOfTheFocusAtMostHoweverRoughTheContext) {
  Scene scene = noisyBody();
  EXPECT_LE(changedShare(scene, viewOf(scene)), 0.125);
  scene.look.edges = Edges::Smooth;
  EXPECT_LE(changedShare(scene, viewOf(scene)), 0.125);
  scene.look.edges = Edges::Off;
  scene.look.contextLayer.share = 1.0;
  EXPECT_GT(changedShare(scene, viewOf(scene)), 0.25) << "the rule had nothing to do";
}

/// Share of the pixels of a view's picture that differ from the reference's by more than `beyond`/255.
double wrongShare(const Scene& scene, const View& view, const std::vector<glm::dvec4>& truth, double beyond) {
  const Layers layers = drawn(scene, view);
  std::size_t count = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const glm::dvec4 difference = glm::abs(glm::dvec4(layers.final[i]) - truth[i]);
    count += std::max({difference.r, difference.g, difference.b, difference.a}) > beyond / 255.0 ? 1 : 0;
  }
  return static_cast<double>(count) / static_cast<double>(truth.size());
}

TEST_F(ContextLinesTest, Thorough_AgreeWithTheReferenceAtEveryQuality) {
  Scene body = bodyWithOrgans<std::int16_t>(gridOf({26, 24, 22}));
  body.look.focus = LabelFocus{{1, 2}};
  body.look.contextLayer = openingLooks().front().contextLayer;
  for (const Edges edges : {Edges::Off, Edges::Smooth}) {
    body.look.edges = edges;
    View view = viewOf(body);
    view.maxError = 1.0;
    const std::vector<glm::dvec4> truth = reference::picture(body, view).final;
    EXPECT_LE(wrongShare(body, view, truth, 1.0), 0.001);
    view.maxError.reset();
    EXPECT_LE(wrongShare(body, view, truth, 8.0), 0.01);
  }
}

/// In noise, first hits differ where a ray grazes a bump; thinning must add nothing to that.
TEST_F(ContextLinesTest, AgreeInNoiseAsWellAsAllEdgesDo) {
  Scene scene = noisyBody(), every = scene;
  every.look.contextLayer.share = 1.0;
  View view = viewOf(scene);
  view.maxError = 1.0;
  EXPECT_LE(wrongShare(scene, view, reference::picture(scene, view).final, 1.0),
            wrongShare(every, view, reference::picture(every, view).final, 1.0) + 0.0005);
}

TEST_F(ContextLinesTest, TilesGiveTheSamePicture) {
  const Scene scene = noisyBody();
  const View view = viewOf(scene);
  Renderer tiles(std::make_shared<GpuScene>());
  tiles.begin(scene, view);
  while (!tiles.advance(0.0)) {
  }
  EXPECT_TRUE(sameBits(tiles.readLayers().final, drawn(scene, view).final));
}

TEST_F(ContextLinesTest, CostNothingWhereTheyMayCoverAll) {
  Scene scene = noisyBody();
  const View view = viewOf(scene);
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, view);
  EXPECT_EQ(renderer.stats()[std::size_t(Pass::ContextLines)].runs, 1u);
  const std::size_t bytes = renderer.imageBytes();
  scene.look.contextLayer.share = 1.0;
  renderer.render(scene, view);
  EXPECT_EQ(renderer.stats()[std::size_t(Pass::ContextLines)].runs, 1u);
  EXPECT_LT(renderer.imageBytes(), bytes);
  EXPECT_TRUE(sameBits(renderer.readLayers().final, drawn(scene, view).final));
}

}  // namespace
}  // namespace fenestra::tests::contextLinesTest
