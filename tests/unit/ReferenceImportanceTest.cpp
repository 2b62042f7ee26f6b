// Levels of importance in the reference: closed forms over discs in a stack, and the rule that defines them, asked of
// points on rays one by one.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "rendering/reference/Reference.h"
#include "rendering/scene/Importance.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceImportanceTest {
namespace {

using namespace tests;

constexpr glm::ivec2 size{48, 48};
constexpr double wide = 40.0;  ///< mm, the height of the parallel picture

std::size_t at(glm::ivec2 pixel) { return static_cast<std::size_t>(pixel.y * size.x + pixel.x); }

/// Along y, which the camera looks along: an opaque body from its face on, in it a disc of label 1 in front of one of
/// label 2 in front of one of label 3, each as thick as a voxel's side.
struct Stack {
  double face = 4.5, first = 8.5, second = 15.5, third = 24.5;  ///< world y of what is met of each
  double firstRadius = 13.0, secondRadius = 8.0, thirdRadius = 4.0;
};

Scene stackScene(const Stack& stack) {
  const Grid grid = gridOf({32, 32, 32});
  Scene scene = labelScene(grid, [&](glm::ivec3 i) {
    const double r = std::hypot(i.x - 15.5, i.z - 15.5);
    if (i.y == 9 && r <= stack.firstRadius) return 1;
    if (i.y == 16 && r <= stack.secondRadius) return 2;
    if (i.y == 25 && r <= stack.thirdRadius) return 3;
    return 0;
  });
  scene.volume = volumeOf<std::uint8_t>(grid, [](glm::ivec3 i) { return i.y >= 5 ? 200 : 0; });
  scene.look.context.function = opaqueFrom(100.0);
  scene.look.focus = LabelFocus{{3}};
  scene.look.method = methods::Importance{.angle = 45.0};
  return scene;
}

/// t is y: the eye is at y = 0.
Camera along() { return lookAt({15.5, 0.0, 15.5}, {15.5, 1.0, 15.5}, Projection::Orthographic, wide); }

void setLevels(Scene& scene, std::initializer_list<std::pair<std::uint16_t, int>> levels) {
  for (const auto& [label, level] : levels) put(scene.look.labels, {.label = label, .importance = level});
}

/// The picture of one label, and how far pixels lie beside it.
class Disc {
 public:
  Disc(const Scene& scene, std::uint16_t label) {
    Scene alone = scene;
    alone.look.focus = LabelFocus{{label}};
    hits_ = hitPoints(alone, along(), size).tFocus;
    distance_ = distanceMap(hits_, size, infinity);
  }
  bool isOn(glm::ivec2 pixel) const { return !std::isnan(hits_[at(pixel)]); }
  double hit(glm::ivec2 pixel) const { return hits_[at(pixel)]; }
  /// The cut around a disc met at `y`, with cones of 45°.
  double cut(glm::ivec2 pixel, double y) const {
    return isOn(pixel) ? hit(pixel) : y - distance_[at(pixel)] * wide / size.y;
  }

 private:
  Image hits_, distance_;
};

TEST(ReferenceImportance, DiscsInAStackAreOpenedForThoseBehindThem) {
  const Stack stack;
  Scene scene = stackScene(stack);
  setLevels(scene, {{1, 1}, {2, 2}, {3, 3}});
  ASSERT_EQ(importanceLevels(scene).size(), 3u);
  const Stages stages = geometricStages(scene, along(), size);
  const Disc first(scene, 1), second(scene, 2), third(scene, 3);
  // A disc's rim is rounded: cones stand on pixels where it is met up to half a voxel deeper.
  constexpr double rounding = 0.5;
  int walls = 0, onSecond = 0, onThird = 0;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const glm::ivec2 here(i, j);
      const double start = stages.tStart[at(here)];
      if (std::isnan(start)) continue;  // beside the body
      const double deepest = std::max(
          {stack.face, first.cut(here, stack.first), second.cut(here, stack.second), third.cut(here, stack.third)});
      EXPECT_GE(start, deepest - 1e-9) << i << ", " << j;
      EXPECT_LE(start, deepest + rounding) << i << ", " << j;
      const bool isMet = start == first.hit(here) || start == second.hit(here) || start == third.hit(here);
      EXPECT_EQ(!std::isnan(stages.hits.tFocus[at(here)]), isMet) << i << ", " << j;
      onThird += start == third.hit(here);
      onSecond += start == second.hit(here);
      walls += first.isOn(here) && !isMet;
    }
  // The third disc lies 9 mm behind the second one and is 4 mm narrower, and 16 mm behind the first one and 9 mm
  // narrower: cones of 45° open all of both.
  EXPECT_GT(onThird, 60);
  EXPECT_EQ(onSecond, 0);
  EXPECT_GT(walls, 400);
}

TEST(ReferenceImportance, SteepConesLeaveTheRestOfEachDisc) {
  // At 1°, cones are 57 mm lower one mm beside their axis, so that each disc shows where no more important one lies
  // behind.
  const Stack stack;
  Scene scene = stackScene(stack);
  scene.look.method.of<methods::Importance>().angle = 1.0;
  setLevels(scene, {{1, 1}, {2, 2}, {3, 3}});
  const Stages stages = geometricStages(scene, along(), size);
  // Away from the rims, of radius 4, 8 and 13 mm, which are rounded over a voxel.
  const auto expectMet = [&](double from, double to, double y) {
    int count = 0;
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) {
        const double r = std::hypot(i + 0.5 - 24.0, j + 0.5 - 24.0) * wide / size.y;
        if (r < from || r > to) continue;
        EXPECT_NEAR(stages.tStart[at({i, j})], y, 1e-9) << i << ", " << j;
        ++count;
      }
    EXPECT_GT(count, 20);
  };
  expectMet(0.0, 2.5, stack.third);
  expectMet(5.5, 6.5, stack.second);
  expectMet(9.8, 11.5, stack.first);
  expectMet(14.8, 15.8, stack.face);
}

TEST(ReferenceImportance, AnEqualOrHigherLevelInFrontIsNeverOpened) {
  const Stack stack;
  for (const int level : {2, 3}) {
    Scene scene = stackScene(stack);
    setLevels(scene, {{1, level}, {3, 2}});
    const Stages stages = geometricStages(scene, along(), size);
    const Disc first(scene, 1);
    int count = 0;
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) {
        if (!first.isOn({i, j})) continue;
        EXPECT_EQ(stages.tStart[at({i, j})], first.hit({i, j}));
        ++count;
      }
    EXPECT_GT(count, 300);
  }
}

TEST(ReferenceImportance, NothingImportantOpensNothing) {
  Scene scene = stackScene({});
  setLevels(scene, {{3, 0}});
  for (const ImportanceMode mode : {ImportanceMode::Maximum, ImportanceMode::Average}) {
    scene.look.method.of<methods::Importance>().mode = mode;
    const Stages stages = geometricStages(scene, along(), size);
    for (std::size_t i = 0; i < stages.tStart.size(); ++i) {
      if (std::isnan(stages.hits.tContext[i])) continue;
      EXPECT_EQ(stages.tStart[i], stages.hits.tContext[i]);
      EXPECT_TRUE(std::isnan(stages.hits.tFocus[i]));
    }
  }
}

/// The interpolated indicator of some labels at a world position, of a grid of unit spacing at the origin.
double indicatorAt(const LabelMap& map, const std::vector<std::uint16_t>& labels, glm::dvec3 world) {
  const glm::ivec3 cell(glm::floor(world));
  const glm::dvec3 within = world - glm::dvec3(cell);
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::ivec3 voxel = glm::clamp(cell + step, glm::ivec3(0), map.grid.dims - 1);
    const glm::dvec3 weights = glm::mix(1.0 - within, within, glm::dvec3(step));
    if (std::find(labels.begin(), labels.end(), map.value(voxel)) != labels.end())
      sum += weights.x * weights.y * weights.z;
  }
  return sum;
}

/// Blobs of six labels; some lie in others.
Scene blobScene(std::mt19937& random) {
  const Grid grid = gridOf({22, 20, 24});
  std::vector<std::pair<glm::dvec3, double>> blobs;
  for (int i = 0; i < 12; ++i)
    blobs.emplace_back(randomIn(random, glm::dvec3(3.0), glm::dvec3(grid.dims) - 4.0),
                       std::uniform_real_distribution(1.5, 6.0)(random));
  Scene scene = labelScene(grid, [&](glm::ivec3 i) {
    int label = 0;
    for (std::size_t b = 0; b < blobs.size(); ++b)
      if (glm::distance(glm::dvec3(i), blobs[b].first) < blobs[b].second) label = 1 + static_cast<int>(b % 6);
    return label;
  });
  scene.volume = volumeOf<std::uint8_t>(
      grid, [&](glm::ivec3 i) { return glm::distance(glm::dvec3(i), grid.centre()) < 9.5 ? 200 : 0; });
  scene.look.context.function = opaqueFrom(100.0);
  scene.look.method.kind = kindOf<methods::Importance>;
  return scene;
}

TEST(ReferenceImportance, APointIsGoneWhereItLiesBeforeTheCutOfAHigherLevelAndNowhereElse) {
  std::mt19937 random(11);
  std::size_t gone = 0, kept = 0, keptBeforeACut = 0;
  for (int run = 0; run < 12; ++run) {
    SCOPED_TRACE(run);
    Scene scene = blobScene(random);
    scene.look.focus = run % 3 == 0 ? LabelFocus{{4}} : LabelFocus{{2, 4, 5}};
    for (std::uint16_t label = 1; label <= 6; ++label)
      put(scene.look.labels, {.label = label, .importance = std::uniform_int_distribution(0, mostImportant)(random)});
    const auto levels = importanceLevels(scene);
    if (levels.empty()) continue;
    const bool onCones = run % 2 == 0;
    scene.look.method.of<methods::Importance>().mode = onCones ? ImportanceMode::Maximum : ImportanceMode::Average;
    scene.look.method.of<methods::Importance>().angle = 20.0;
    const Camera camera = Camera::fromAngles(40.0 * run, 10.0, scene.volume->grid,
                                             run % 4 < 2 ? Projection::Perspective : Projection::Orthographic);
    const Stages stages = geometricStages(scene, camera, size);
    const HitPoints hits = hitPoints(scene, camera, size);
    const MethodStages method = stagesOf(scene.look.method);
    std::vector<Image> cuts;
    for (const auto& labels : levels) {
      Scene alone = scene;
      alone.look.focus = LabelFocus{labels};
      HitPoints ofLevel = hits;
      ofLevel.tFocus = hitPoints(alone, camera, size).tFocus;
      for (std::size_t i = 0; i < ofLevel.tFocus.size(); ++i)
        ofLevel.tFocus[i] = std::isnan(hits.tContext[i]) || std::isnan(ofLevel.tFocus[i])
                                ? nan
                                : std::max(ofLevel.tFocus[i], hits.tContext[i]);
      cuts.push_back(onCones ? coneStart(ofLevel, camera, size, method.slope, true) : ofLevel.tFocus);
    }
    for (int each = 0; each < 4000; ++each) {
      const glm::ivec2 pixel(std::uniform_int_distribution(0, size.x - 1)(random),
                             std::uniform_int_distribution(0, size.y - 1)(random));
      const std::size_t i = at(pixel);
      if (std::isnan(hits.tContext[i])) continue;
      const double t = std::uniform_real_distribution(hits.tContext[i], hits.tOut[i])(random);
      const Ray ray = pixelRay(camera, size, pixel);
      const glm::dvec3 world = ray.origin + t * ray.direction;
      // By the definition: gone before the cut of any level that is not the point's own or a lower one.
      bool isGone = false, liesBeforeACut = false, isUncertain = false;
      for (std::size_t k = 0; k < levels.size(); ++k) {
        const double indicator = indicatorAt(*scene.labels, levels[k], world);
        isUncertain |= std::abs(indicator - 0.5) < 1e-6 || std::abs(t - cuts[k][i]) < 1e-6;
        const bool isBefore = t < cuts[k][i];
        liesBeforeACut |= isBefore;
        if (indicator < 0.5) isGone |= isBefore;
      }
      if (isUncertain) continue;
      EXPECT_EQ(isGone, t < stages.tStart[i]) << pixel.x << ", " << pixel.y << " at " << t;
      ++(isGone ? gone : kept);
      keptBeforeACut += liesBeforeACut && !isGone;
    }
  }
  EXPECT_GT(gone, 2000u);
  EXPECT_GT(kept, 2000u);
  EXPECT_EQ(keptBeforeACut, 0u) << "no point lies before a cut that it does not give way to";
}

}  // namespace
}  // namespace fenestra::reference::referenceImportanceTest
