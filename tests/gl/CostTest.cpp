// Only what a scene needs: which memory and passes each kind of scene takes, and that a feature costs nothing while it
// is off.

#include <map>
#include <set>

#include "rendering/scene/Occlusion.h"
#include "tests/gl/GlTest.h"
#include "tests/support/FeatureScenes.h"

namespace fenestra::tests::costTest {
namespace {

// So small that a voxel is less than a pixel wide, and every ray is followed.
constexpr glm::ivec2 size{64, 48};
constexpr std::size_t pixels = 64 * 48;

using Cost = GlTest;
using Memory = std::map<std::string, std::size_t>;

/// Two labelled balls inside a larger one of values falling outwards, in air.
Scene ballScene() {
  const Grid grid = gridOf({40, 40, 40});
  const auto radius = [&](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 19.5); };
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) { return 1000.0 - 60.0 * radius(i); });
  const auto labels = labelsOf(grid, [&](glm::ivec3 i) { return radius(i) < 5.0 ? 1 : radius(i) < 9.0 ? 2 : 0; });
  labels->labels = {{1, "inner", glm::dvec3(0.9, 0.2, 0.2)}, {2, "outer", glm::dvec3(0.2, 0.2, 0.9)}};
  scene.labels = labels;
  scene.look.focus = LabelFocus{{1, 2}};
  scene.look.context.function = {
      {{100.0, {glm::dvec3(0.8, 0.5, 0.4), 0.0}}, {100.0, {glm::dvec3(0.8, 0.5, 0.4), 0.5}}}};
  return scene;
}

std::vector<FeatureScene> kinds() { return featureScenes(ballScene(), ValueFocus{{800.0, 2000.0}, 0.0}); }

View viewOf(const Scene& scene) { return {Camera::fromAngles(25.0, 15.0, scene.volume->grid), size}; }

Memory memoryOf(const GpuScene& gpu, const Renderer& renderer) {
  Memory memory;
  for (const GpuScene::Resource& resource : gpu.resources()) memory[resource.name] = resource.bytes;
  memory["images"] = renderer.imageBytes();
  return memory;
}

std::set<std::string> namesOf(const Memory& memory) {
  std::set<std::string> names;
  for (const auto& [name, bytes] : memory) names.insert(name);
  return names;
}

struct Drawn {
  Memory memory;
  std::set<std::string> passes;
};

Drawn draw(const Scene& scene) {
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  renderer.render(scene, viewOf(scene));
  Drawn drawn{memoryOf(*gpu, renderer), {}};
  for (std::size_t pass = 0; pass < passCount; ++pass)
    if (renderer.stats()[pass].runs > 0) drawn.passes.insert(std::string(nameOf(static_cast<Pass>(pass))));
  return drawn;
}

TEST_F(Cost, Thorough_EveryKindOfSceneTakesItsOwnPassesAndResourcesAndNoOthers) {
  using Names = std::set<std::string>;
  const Names always{"volume", "transfer tables", "pre-integration", "empty-space skipping", "images"};
  const auto with = [](Names names, const Names& more) {
    names.insert(more.begin(), more.end());
    return names;
  };
  const Names plainPasses{"focus layer"};
  const Names cutPasses = with(plainPasses, {"hit points", "pull-push", "distance map", "ray start", "composite"});
  const Names lit = with(always, {"gradient"}), byValue = with(lit, {"focus index"});
  const Names byLabel = with(byValue, {"focus normals"});
  const Names withLayer = with(byLabel, {"derivative volume"}), layerPasses = with(cutPasses, {"context layer"});
  struct Expected {
    Names resources, passes;
  };
  const std::map<std::string, Expected> expected{
      {"plain, unlit", {always, plainPasses}},
      {"plain", {lit, plainPasses}},
      {"plain, occlusion", {with(lit, {"occluders"}), with(plainPasses, {"occlusion"})}},
      {"labels, no cutaway", {byLabel, plainPasses}},
      {"cutaway by value", {byValue, cutPasses}},
      {"cutaway by a label", {byLabel, cutPasses}},
      {"cutaway by two labels", {with(byLabel, {"focus palette"}), cutPasses}},
      {"with a border", {byLabel, cutPasses}},
      {"with the context layer", {withLayer, layerPasses}},
      {"with occlusion", {with(byLabel, {"occluders"}), with(cutPasses, {"occlusion"})}},
      {"with a brush stroke", {withLayer, with(layerPasses, {"edit map"})}},
  };
  const std::vector<FeatureScene> scenes = kinds();
  EXPECT_EQ(scenes.size(), expected.size());
  for (const FeatureScene& kind : scenes) {
    const Drawn drawn = draw(kind.scene);
    EXPECT_EQ(namesOf(drawn.memory), expected.at(kind.name).resources) << kind.name;
    EXPECT_EQ(drawn.passes, expected.at(kind.name).passes) << kind.name;
  }
}

TEST_F(Cost, PicturesWithinABoundAreNotPreIntegrated) {
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  const Scene scene = kinds().front().scene;
  View view = viewOf(scene);
  view.quality = Quality::High;
  renderer.render(scene, view);
  EXPECT_FALSE(memoryOf(*gpu, renderer).contains("pre-integration"));
  view.quality = Quality::Normal;
  renderer.render(scene, view);
  EXPECT_TRUE(memoryOf(*gpu, renderer).contains("pre-integration"));
}

TEST_F(Cost, AFeatureAddsItsOwnBytesAndNoOthers) {
  std::map<std::string, Memory> memory;
  for (const FeatureScene& kind : kinds()) memory[kind.name] = draw(kind.scene).memory;
  const std::size_t voxels = 40 * 40 * 40;

  const Memory& unlit = memory["plain, unlit"];
  EXPECT_EQ(unlit.at("volume"), voxels * 2);
  EXPECT_EQ(unlit.at("images"), pixels * 16);  // the focus layer, which is the picture, RGBA32F

  const Memory plainWithGradient = memory["plain"];
  Memory plain = memory["plain"];
  EXPECT_EQ(plain.erase("gradient"), 1u);
  EXPECT_EQ(plain, unlit);

  // Three extinctions and a fourth that fills the vector.
  Memory occluded = memory["plain, occlusion"];
  const std::size_t cells = voxels;  // of one voxel each in a volume as small as this
  EXPECT_EQ(occluded["occluders"], cells * 16);
  EXPECT_EQ(occluded.erase("occluders"), 1u);
  // The medium, the light at its nodes, that light with four nodes in a texel, and the steps in each direction. No ray
  // takes more steps than there are cells along the three axes together, and one more ends them.
  const occlusion::Directions directions;
  const auto rays = static_cast<std::size_t>(directions.around + directions.towardsLight);
  const std::size_t steps = occluded["images"] - unlit.at("images") - cells * (4 + 4 + 16);
  EXPECT_GE(steps, rays * 16);
  EXPECT_LE(steps, rays * (3 * 40 + 1) * 16);
  occluded["images"] = unlit.at("images");
  EXPECT_EQ(occluded, plainWithGradient);

  // Labels that open nothing bring the focus, no image and no pass.
  EXPECT_EQ(memory["labels, no cutaway"].at("images"), unlit.at("images"));

  EXPECT_EQ(memory["with a border"], memory["cutaway by a label"]);

  Memory layer = memory["with the context layer"];
  EXPECT_EQ(layer.erase("derivative volume"), 1u);
  layer["images"] -= pixels * (16 + 4);  // the layer and its silhouette
  EXPECT_EQ(layer, memory["with a border"]);

  Memory stroke = memory["with a brush stroke"];
  const std::size_t edits = stroke["images"] - memory["with the context layer"]["images"];
  EXPECT_GE(edits, pixels * 8);         // the edit map, RG32F
  EXPECT_LE(edits, pixels * 8 + 4096);  // and a few lists of one stroke
  stroke["images"] -= edits;
  EXPECT_EQ(stroke, memory["with the context layer"]);
}

TEST_F(Cost, Thorough_AFeatureSwitchedOffGivesBackWhatItTook) {
  const std::vector<FeatureScene> scenes = kinds();
  for (const FeatureScene& kind : scenes) {
    const auto gpu = std::make_shared<GpuScene>();
    Renderer renderer(gpu);
    for (const FeatureScene& before : scenes) {
      renderer.render(before.scene, viewOf(before.scene));
      renderer.render(kind.scene, viewOf(kind.scene));
    }
    Memory after = memoryOf(*gpu, renderer), fresh = draw(kind.scene).memory;
    // The gradient covers whatever has shown so far, so that a change need not make it anew.
    if (fresh.count("gradient")) {
      EXPECT_GE(after["gradient"], fresh["gradient"]) << kind.name;
      after["gradient"] = fresh["gradient"];
    }
    EXPECT_EQ(after, fresh) << kind.name;
  }
}

}  // namespace
}  // namespace fenestra::tests::costTest
