// Pictures of a brush at work that are dropped half way: each stage knows the strokes that its images were made with,
// so that the next picture is what it would be without them.

#include <random>

#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::droppedStrokesTest {
namespace {

using DroppedStrokes = GlTest;

struct Kind {
  std::string name;
  Scene scene;
  View view;
};

std::vector<Kind> kindsOfPictures() {
  Scene scene = bodyWithOrgans<std::int16_t>(gridOf({24, 22, 20}));
  scene.look.focus = LabelFocus{{1}};
  scene.look.contextLayer.strength = 0.7;
  View view{Camera::fromAngles(30.0, 20.0, scene.volume->grid), {61, 53}};
  view.maxError = 2.0;
  View frozen = view;
  frozen.frozen = OpeningView{Camera::fromAngles(0.0, 10.0, scene.volume->grid), {57, 49}, 1.0};
  std::vector<Kind> kinds{{"protected labels", withProtected(scene), view},
                          {"occlusion", occluded(scene), view},
                          {"frozen, with occlusion", occluded(scene), frozen}};
  scene.look.edges = Edges::Smooth;
  kinds.push_back({"smooth edges", scene, view});
  scene.look.method = methods::Walls{.placement = WallPlacement::Inside};
  scene.look.edges = Edges::Off;
  kinds.push_back({"walls", scene, view});
  return kinds;
}

/// The scene before a stroke, with it, while the stroke grows, and with a second one that opens.
std::vector<Scene> strokesOver(const Scene& scene) {
  std::vector<Scene> states{scene, brushed(scene)};
  states.push_back(states.back());
  states.back().look.strokes.front().anchors.push_back(scene.volume->grid.centre() + glm::dvec3(-3.0, -6.0, 3.0));
  states.push_back(states[1]);
  BrushStroke open = states[1].look.strokes.front();
  open.mode = BrushMode::Open;
  for (glm::dvec3& anchor : open.anchors) anchor += glm::dvec3(4.0, 0.0, 3.0);
  states.back().look.strokes.push_back(open);
  return states;
}

TEST_F(DroppedStrokes, Thorough_LeaveNoTrace) {
  std::mt19937 random(11);
  for (const Kind& kind : kindsOfPictures()) {
    SCOPED_TRACE(kind.name);
    const std::vector<Scene> states = strokesOver(kind.scene);
    const auto gpu = std::make_shared<GpuScene>();
    std::vector<Layers> expected;
    for (const Scene& state : states) {
      Renderer fresh(gpu);
      fresh.render(state, kind.view);
      expected.push_back(fresh.readLayers());
    }
    EXPECT_FALSE(expected[0].final == expected[1].final);
    EXPECT_FALSE(expected[1].final == expected[3].final);
    Renderer kept(gpu);
    for (int round = 0; round < 20; ++round) {
      for (std::size_t drops = random() % 3; drops > 0; --drops) {
        kept.begin(states[random() % states.size()], kind.view);
        for (std::size_t slices = random() % 150; slices > 0 && !kept.advance(0.0); --slices) {
        }
      }
      const std::size_t wanted = random() % states.size();
      kept.render(states[wanted], kind.view);
      const Layers layers = kept.readLayers();
      EXPECT_TRUE(sameBits(layers.tStart, expected[wanted].tStart)) << round;
      EXPECT_TRUE(layers.focusLayer == expected[wanted].focusLayer) << round;
      EXPECT_TRUE(layers.final == expected[wanted].final) << round;
      if (HasFailure()) return;
    }
  }
}

}  // namespace
}  // namespace fenestra::tests::droppedStrokesTest
