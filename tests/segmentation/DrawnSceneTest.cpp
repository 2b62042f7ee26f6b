// The scene that is drawn follows the one that is set.

#include "rendering/segmentation/DrawnScene.h"

#include <gtest/gtest.h>

#include "rendering/segmentation/RegionGrowing.h"
#include "tests/support/Scenes.h"

namespace fenestra::segmentation::drawnSceneTest {
namespace {

/// A ball of 1000 around (20, 20, 20) in air of 0, on a grid of 40³ mm; all of it is label 9.
SetScene ballInAir() {
  SetScene set;
  const Grid grid = tests::gridOf(glm::ivec3(40));
  set.volume = tests::volumeOf<std::int16_t>(
      grid, [](glm::ivec3 index) { return glm::length(glm::dvec3(index) - 20.0) < 8.0 ? 1000 : 0; });
  set.labels = tests::labelsOf(grid, [](glm::ivec3) { return 9; });
  return set;
}

TEST(DrawnScene, IsTheSetSceneWhereNothingTakesWork) {
  SetScene set = ballInAir();
  set.look.focus = LabelFocus{{9}};
  DrawnScene drawn;
  drawn.update(set, nullptr);
  EXPECT_EQ(drawn.scene(), sceneOf(set));
}

TEST(DrawnScene, TheFocusBeforeStaysUntilARegionIsGrown) {
  SetScene set = ballInAir();
  set.look.focus = LabelFocus{{9}};
  DrawnScene drawn;
  drawn.update(set, nullptr);

  const RegionFocus region{{glm::dvec3(20.0)}, {}, {}};
  set.look.focus = region;
  for (int update = 0; update < 2; ++update) {
    drawn.update(set, nullptr);
    EXPECT_EQ(drawn.scene().labels, set.labels);
    EXPECT_EQ(drawn.scene().structures, set.labels);
    EXPECT_EQ(drawn.scene().look.focus, Focus(LabelFocus{{9}}));
  }

  const auto growth = growRegion(*set.volume, region, wholeOf(set.volume->grid.dims));
  drawn.update(set, &*growth);
  EXPECT_EQ(drawn.scene().labels, growth->steps);
  EXPECT_EQ(drawn.scene().structures, set.labels) << "the look's labels are still those of the map";
  EXPECT_EQ(std::get<LabelFocus>(drawn.scene().look.focus).labels.size(),
            static_cast<std::size_t>(growth->stepOf(region)));
}

TEST(DrawnScene, SettingsOfLabelsGoWhereARegionHasNoMapBesideIt) {
  SetScene set = ballInAir();
  set.labels = nullptr;
  set.look.labels = {{.label = 9, .role = LabelRole::Hidden}};
  const RegionFocus region{{glm::dvec3(20.0)}, {}, {}};
  set.look.focus = region;
  const auto growth = growRegion(*set.volume, region, wholeOf(set.volume->grid.dims));
  DrawnScene drawn;
  drawn.update(set, &*growth);
  EXPECT_TRUE(drawn.scene().look.labels.empty()) << "they would hide a step of the growth";
  EXPECT_FALSE(set.look.labels.empty());
}

}  // namespace
}  // namespace fenestra::segmentation::drawnSceneTest
