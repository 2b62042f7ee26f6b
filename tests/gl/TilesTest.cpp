// Pictures that are drawn a tile at a time: every stage has the bits of a single run, whichever picture was abandoned
// half way before. ProgramsTest draws other kinds of scenes so.

#include <random>

#include "rendering/passes/Steps.h"
#include "tests/gl/GlTest.h"
#include "tests/gl/SameLayers.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::tilesTest {
namespace {

using Tiles = GlTest;

Layers whole(const std::shared_ptr<GpuScene>& gpu, const Scene& scene, const View& view) {
  Renderer renderer(gpu);
  renderer.render(scene, view);
  return renderer.readLayers();
}

/// A change of scene or view; each change affects different stages.
struct Change {
  std::string name;
  std::function<void(Scene&, View&)> apply;
};

const std::vector<Change> changes{
    {"turned", [](Scene&, View& view) { view.camera = view.camera.orbited(0.3, 0.1); }},
    {"wider opening", [](Scene& scene, View&) { scene.look.cutaway.openWidth += 5.0; }},
    {"border", [](Scene& scene, View&) { scene.look.cutaway.borderWidth = 4.0; }},
    {"larger", [](Scene&, View& view) { view.size += 13; }},
    {"brushed", [](Scene& scene, View&) { scene = brushed(scene); }},
    {"stronger edges", [](Scene& scene, View&) { scene.look.contextLayer.strength = 0.9; }},
    {"no cutaway", [](Scene& scene, View&) { scene.look.cutaway.enabled = false; }},
    {"draft", [](Scene&, View& view) { view.quality = Quality::Draft; }},
    {"ClearView", [](Scene& scene, View&) { scene.look.method.kind = kindOf<methods::ClearView>; }},
    {"context-preserving", [](Scene& scene, View&) { scene.look.method.kind = kindOf<methods::ContextPreserving>; }},
    {"focal region",
     [](Scene& scene, View&) { scene.look.method = methods::FocalRegion{.size = 5.0, .fallOff = 5.0}; }},
    {"walls around", [](Scene& scene, View&) { scene.look.method.kind = kindOf<methods::Walls>; }},
    {"walls inside",
     [](Scene& scene, View&) { scene.look.method = methods::Walls{.placement = WallPlacement::Inside}; }},
    {"exploded", [](Scene& scene, View&) { scene.look.method.kind = kindOf<methods::Explode>; }},
    {"peeled", [](Scene& scene, View&) { scene.look.method.kind = kindOf<methods::Peel>; }},
    {"ghosted selection", [](Scene& scene, View&) { scene.look.method.kind = kindOf<methods::Selection>; }},
    {"maximum", [](Scene& scene, View&) { scene.look.method.kind = kindOf<methods::Mip>; }},
    {"smooth edges", [](Scene& scene, View&) { scene.look.edges = Edges::Smooth; }},
};

/// From a whole picture to a changed one that is dropped after some tiles, then to another changed one: for one pair of
/// changes of `every`, which leaves none out that is either dropped or wanted.
void expectNoTrace(std::size_t every) {
  Scene scene = bodyWithOrgans<std::int16_t>(gridOf({24, 22, 20}));
  scene.look.focus = LabelFocus{{1}};
  scene.look.contextLayer.strength = 0.7;
  const View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), {61, 53}};
  const auto gpu = std::make_shared<GpuScene>();
  Renderer kept(gpu);
  std::mt19937 random(3);
  for (std::size_t d = 0; d < changes.size(); ++d)
    for (std::size_t w = d % every; w < changes.size(); w += every) {
      const Change &dropped = changes[d], &wanted = changes[w];
      SCOPED_TRACE(dropped.name + ", then " + wanted.name);
      kept.render(scene, view);
      Scene first = scene, second = scene;
      View firstView = view, secondView = view;
      dropped.apply(first, firstView);
      wanted.apply(second, secondView);
      kept.begin(first, firstView);
      const int slices = static_cast<int>(random() % 700);
      for (int i = 0; i < slices && !kept.advance(0.0);) ++i;
      kept.render(second, secondView);
      EXPECT_EQ(differingLayers(kept.readLayers(), whole(gpu, second, secondView)), "");
      if (testing::Test::HasFailure()) return;
    }
}

TEST_F(Tiles, Thorough_ADroppedPictureLeavesNoTrace) { expectNoTrace(4); }

TEST_F(Tiles, Exhaustive_ADroppedPictureLeavesNoTraceBeforeAnyOther) { expectNoTrace(1); }

TEST_F(Tiles, APictureBegunAgainGoesOnWhereTheSharedSceneHasChanged) {
  Scene scene = bodyWithOrgans<std::int16_t>(gridOf({24, 22, 20})), other = scene;
  scene.look.focus = LabelFocus{{1}};
  other.look.focus = LabelFocus{{2}};
  const View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), {61, 53}};
  const auto gpu = std::make_shared<GpuScene>();
  Renderer slow(gpu), quick(gpu);
  slow.begin(scene, view);
  for (int i = 0; i < 100; ++i) ASSERT_FALSE(slow.advance(0.0));
  quick.render(other, view);
  while (!slow.advance(5.0)) {
  }
  EXPECT_EQ(differingLayers(slow.readLayers(), whole(gpu, scene, view)), "");
}

TEST_F(Tiles, CoverEveryPixelOnceInTheOrderOfTheSteps) {
  std::mt19937 random(7);
  const auto upTo = [&](int limit) { return 1 + static_cast<int>(random() % static_cast<unsigned>(limit)); };
  for (int round = 0; round < 50; ++round) {
    const gl::Region a{{0, 0}, {upTo(90), upTo(90)}}, b{{100, 3}, {upTo(90), upTo(90)}};
    std::vector<int> counts(200 * 100);
    int firstDone = 0;
    bool secondBegun = false;
    Steps steps;
    steps.add(std::vector{a, b}, [&](Regions tile) {
      EXPECT_FALSE(secondBegun);
      for (const gl::Region& region : tile) {
        const gl::Region& of = region.origin.x < 100 ? a : b;
        EXPECT_EQ((region.origin - of.origin) % 8, glm::ivec2(0)) << "whole groups";
        for (int y = 0; y < region.size.y; ++y)
          for (int x = 0; x < region.size.x; ++x) {
            const glm::ivec2 at = region.origin + glm::ivec2(x, y);
            ++counts[static_cast<std::size_t>(at.y * 200 + at.x)];
          }
      }
    });
    steps.then([&] { ++firstDone; });
    steps.add(glm::ivec2(9, 9), [&](Regions) {
      secondBegun = true;
      EXPECT_EQ(firstDone, 1);
    });
    while (!steps.advance(round % 2 ? 0.0 : 0.01)) {
    }
    EXPECT_TRUE(secondBegun);
    int sum = 0;
    for (const int count : counts) {
      EXPECT_LE(count, 1);
      sum += count;
    }
    EXPECT_EQ(sum, a.size.x * a.size.y + b.size.x * b.size.y);
  }
}

TEST_F(Tiles, AStepThatThrowsEndsThePictureAndTheNextOneIsRight) {
  Steps steps;
  steps.add(glm::ivec2(64, 64), [](Regions) { throw std::runtime_error("lost"); });
  EXPECT_THROW(steps.advance(1.0), std::runtime_error);
  steps.drop();
  EXPECT_TRUE(steps.advance(1.0));
}

}  // namespace
}  // namespace fenestra::tests::tilesTest
