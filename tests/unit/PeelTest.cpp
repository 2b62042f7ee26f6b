// Where a peeled layer lies, and what the peeled volume holds there, against closed forms.

#include "rendering/scene/PeeledScene.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::peelTest {
namespace {

using namespace tests;

constexpr double pi = std::numbers::pi;

/// A block of 60 × 48 × 40 mm of one value, its front 4 mm of air, with a ball of 6 mm in focus.
Scene block(const MethodStages::Peel& peel, const Grid& grid = gridOf({60, 48, 40})) {
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return i.y < 4 ? -1000 : 100; });
  scene.labels =
      labelsOf(grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(30, 30, 20)) < 6.0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.method = methods::Peel{.amount = peel.amount,
                                    .side = peel.side,
                                    .turn = peel.turn,
                                    .depth = peel.depth,
                                    .radius = peel.radius,
                                    .margin = peel.margin};
  return scene;
}

Peel layerOf(const Scene& scene) {
  return {*peelOf(scene.look), FocusVoxels(scene), scene.volume->grid, bodyBox(shownVolume(scene))};
}

TEST(Peel, LiesAsItsDefinitionSays) {
  const Scene scene = block({.amount = 1.0, .depth = 0.0, .radius = 7.0, .margin = 3.0});
  const Peel peel = layerOf(scene);
  // The ball's voxels reach from 25 to 35 along y, counted whole from 24.5; the break lies half a voxel before them.
  EXPECT_NEAR(peel.world(glm::dvec3(0.0)).y, 24.0, 1e-9);
  EXPECT_NEAR(peel.thickness(), 24.0 - 3.5, 1e-9);
  EXPECT_NEAR(peel.halfWidth(), 5.5 + 3.0, 1e-9);
  EXPECT_NEAR(peel.halfLength(), 5.5 + 3.0, 1e-9);
  EXPECT_NEAR(peel.radius(), peel.thickness() + 7.0, 1e-9);
  EXPECT_NEAR(peel.roll(), peel.halfWidth() + peel.radius(), 1e-9);
  const Peel deep = layerOf(block({.amount = 1.0, .depth = 1.0, .radius = 7.0, .margin = 3.0}));
  EXPECT_NEAR(deep.world(glm::dvec3(0.0)).y, 36.0, 1e-9);
}

TEST(Peel, EachSideAndTurnHasADirectionOfThePatient) {
  const auto axesOf = [](PeelSide side, double turn) {
    const Peel peel = layerOf(block({.amount = 0.5, .side = side, .turn = turn, .depth = 0.0, .radius = 5.0}));
    const glm::dvec3 origin = peel.world(glm::dvec3(0.0));
    return std::array{peel.world({1.0, 0.0, 0.0}) - origin, peel.world({0.0, 0.0, 1.0}) - origin};
  };
  const std::vector<std::pair<PeelSide, glm::dvec3>> sides{
      {PeelSide::Anterior, {0, -1, 0}}, {PeelSide::Posterior, {0, 1, 0}}, {PeelSide::Left, {1, 0, 0}},
      {PeelSide::Right, {-1, 0, 0}},    {PeelSide::Superior, {0, 0, 1}},  {PeelSide::Inferior, {0, 0, -1}}};
  for (const auto& [side, direction] : sides) {
    const glm::dvec3 head = direction.z == 0.0 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    EXPECT_LT(glm::distance(axesOf(side, 0.0)[1], direction), 1e-12);
    EXPECT_LT(glm::distance(axesOf(side, 0.0)[0], head), 1e-12);
    EXPECT_LT(glm::distance(axesOf(side, 90.0)[0], glm::cross(direction, head)), 1e-12);
    EXPECT_LT(glm::distance(axesOf(side, 30.0)[1], direction), 1e-12);
  }
}

/// shownAt() rolls up, sourceOf() unrolls: each is the other's inverse in all of the layer.
TEST(Peel, TheInverseIsExact) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int folded = 0, negative = 0;
  for (int i = 0; i < 60; ++i) {
    // Margins wide and radii small enough that some of the layer folds back.
    const Peel peel = layerOf(block({.amount = between(0.05, 1.0),
                                     .side = static_cast<PeelSide>(i % 6),
                                     .turn = between(-180.0, 180.0),
                                     .depth = between(0.0, 0.3),
                                     .radius = between(1.0, 20.0),
                                     .margin = between(0.0, 150.0)},
                                    gridOf({160, 48, 40})));
    const double roll = peel.roll();
    for (int j = 0; j < 100; ++j) {
      const glm::dvec3 local(between(-0.999, 0.999) * peel.halfLength(), between(-0.999, 0.999) * roll,
                             between(0.001, 0.999) * peel.thickness());
      const glm::dvec3 place = peel.world(local), shown = peel.shownAt(place);
      const Peel::Source source = peel.sourceOf(shown);
      ASSERT_EQ(source.part, local.y < 0.0 ? Peel::Part::Negative : Peel::Part::Positive) << i << ", " << j;
      ASSERT_LT(glm::distance(source.world, place), 1e-9) << i << ", " << j;
      folded += (roll - std::abs(local.y)) > pi * peel.radius();
      negative += local.y < 0.0;
    }
  }
  EXPECT_GT(folded, 100);
  EXPECT_GT(negative, 1000);
}

/// Along each radius of the roll, lengths stay; on the break, along it, too. So a slab keeps its optical depth along
/// every normal of the roll.
TEST(Peel, KeepsTheLayersThickness) {
  const Peel peel = layerOf(block({.amount = 0.9, .depth = 0.0, .radius = 6.0, .margin = 4.0}));
  for (double l = 0.05; l < peel.roll(); l += 0.5) {
    const double w = peel.roll() - l;
    const glm::dvec3 below = peel.shownAt(peel.world({1.0, w, 1e-5})),
                     above = peel.shownAt(peel.world({1.0, w, peel.thickness()}));
    EXPECT_NEAR(glm::distance(below, above), peel.thickness() - 1e-5, 1e-9) << l;
    const double step = 1e-3;
    const glm::dvec3 next = peel.shownAt(peel.world({1.0, w - step, 1e-5}));
    EXPECT_NEAR(glm::distance(below, next) / step, 1.0, 1e-5) << l;
  }
}

/// At amount 1 no point of the layer lies before the focus's extent; and the least amount changes hardly anything.
TEST(Peel, OpensTheFocusesExtent) {
  for (const double margin : {0.0, 10.0, 80.0}) {
    const Peel peel = layerOf(block({.amount = 1.0, .depth = 0.2, .radius = 3.0, .margin = margin}));
    for (double w = 0.0; w < peel.halfWidth() - 1e-3; w += 0.25)
      for (double h = 0.01; h < 3.0 * peel.radius(); h += 0.25)
        for (const double side : {-1.0, 1.0})
          ASSERT_EQ(peel.sourceOf(peel.world({0.0, side * w, h})).part, Peel::Part::Nothing) << w << ", " << h;
  }
  const Peel little = layerOf(block({.amount = 1e-4, .depth = 0.2, .radius = 3.0, .margin = 10.0}));
  for (double w = 0.0; w < 20.0; w += 0.001) {
    const glm::dvec3 place = little.world({0.0, w, 2.0});
    EXPECT_LT(glm::distance(little.shownAt(place), place), 0.01);
  }
}

/// The limit of a peeled volume's gradient: (I + ∂D/∂x)ᵀ ∇f, here of a linear f.
TEST(PeeledScene, GradientsFollowTheJacobian) {
  const glm::dvec3 slope(3.0, -5.0, 4.0);
  Scene scene = block({.amount = 0.9, .depth = 0.0, .radius = 12.0, .margin = 6.0});
  const auto volume = volumeOf<double>(
      scene.volume->grid, [&](glm::ivec3 i) { return i.y < 4 ? -1000.0 : 500.0 + glm::dot(slope, glm::dvec3(i)); });
  scene.volume = volume;
  Peeler peeler;
  const auto peeled = peeler.of(scene);
  ASSERT_TRUE(peeled);
  const Peel& peel = peeled->peel;
  const Volume& drawn = *peeled->scene.volume;
  int compared = 0;
  double worst = 0.0;
  forEachVoxel(drawn.grid.dims, [&](glm::ivec3 voxel) {
    const glm::dvec3 world(drawn.grid.worldFromIndex() * glm::dvec4(glm::dvec3(voxel), 1.0));
    // So far inside of the layer and of the block that no value beside them counts: a voxel across the roll stands for
    // R / (R - h) < 3 of the layer's.
    const Peel::Source source = peel.sourceOf(world);
    const glm::dvec3 local = peel.local(source.world);
    if (source.part != Peel::Part::Positive || local.z < 4.0 || local.z > peel.thickness() - 4.0 || local.y < 4.0 ||
        std::abs(local.x) > peel.halfLength() - 2.0 || source.world.x < 4.0 || source.world.x > 55.0)
      return;
    glm::dvec3 wanted, found;
    constexpr double step = 1e-4;
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 d(0.0);
      d[axis] = step;
      wanted[axis] = glm::dot(slope, peel.sourceOf(world + d).world - peel.sourceOf(world - d).world) / (2.0 * step);
      glm::ivec3 next(0);
      next[axis] = 1;
      found[axis] = 0.5 * (drawn.value(voxel + next) - drawn.value(voxel - next));
    }
    worst = std::max(worst, glm::distance(wanted, found) / glm::length(wanted));
    ++compared;
  });
  EXPECT_GT(compared, 500);
  // Trilinear values of a linear f are exact, so that the only error is the central difference's own: a sixth of the
  // third derivative, which is 2/ρ² of the first for an angle at the distance ρ from the roll's axis, ρ ≥ 16 - 1.
  EXPECT_LT(worst, 2.0 / (6.0 * 15.0 * 15.0));
}

TEST(PeeledScene, KeepsTheFocusAndWhatIsBehindToTheBit) {
  for (const double depth : {0.0, 0.5, 1.0}) {
    const Scene scene = block({.amount = 0.8, .depth = depth, .radius = 5.0, .margin = 2.0},
                              gridOf({60, 48, 40}, {1.0, 1.1, 0.9}, {-20.0, 33.0, 7.0}));
    Peeler peeler;
    const auto peeled = peeler.of(scene);
    ASSERT_TRUE(peeled);
    const Volume& drawn = *peeled->scene.volume;
    const glm::ivec3 shift(
        glm::round(glm::dvec3(drawn.grid.indexFromWorld() * glm::dvec4(scene.volume->grid.origin, 1.0))));
    std::size_t kept = 0, focus = 0, inFocus = 0;
    forEachVoxel(scene.volume->grid.dims, [&](glm::ivec3 voxel) {
      const glm::dvec3 world(scene.volume->grid.worldFromIndex() * glm::dvec4(glm::dvec3(voxel), 1.0));
      const bool isBehind = peeled->peel.local(world).z < -1.7;
      const bool isFocus = scene.labels->value(voxel) == 1;
      if (!isBehind && !isFocus) return;
      kept += drawn.value(voxel + shift) == scene.volume->value(voxel) &&
              peeled->scene.labels->value(voxel + shift) == scene.labels->value(voxel);
      focus += isFocus;
      inFocus += isBehind || isFocus;
    });
    EXPECT_EQ(kept, inFocus);
    std::size_t drawnFocus = 0;
    forEachVoxel(drawn.grid.dims, [&](glm::ivec3 voxel) { drawnFocus += peeled->scene.labels->value(voxel) == 1; });
    EXPECT_EQ(drawnFocus, focus) << "the layer takes none of it along";
  }
}

TEST(PeeledScene, MapsPlacesThereAndBack) {
  const Scene scene = block({.amount = 0.7, .depth = 0.5, .radius = 5.0, .margin = 6.0});
  Peeler peeler;
  const auto peeled = peeler.of(scene);
  ASSERT_TRUE(peeled);
  const glm::dvec3 inFocus(30.0, 27.0, 20.0), inLayer(33.0, 15.0, 20.0), behind(30.0, 40.0, 20.0);
  EXPECT_EQ(peeled->shownAt(inFocus), inFocus);
  EXPECT_EQ(peeled->sourceOf(inFocus), inFocus);
  EXPECT_EQ(peeled->shownAt(behind), behind);
  const glm::dvec3 shown = peeled->shownAt(inLayer);
  EXPECT_GT(glm::distance(shown, inLayer), 3.0);
  ASSERT_TRUE(peeled->sourceOf(shown));
  EXPECT_LT(glm::distance(*peeled->sourceOf(shown), inLayer), 1e-9);
  EXPECT_FALSE(peeled->sourceOf({30.0, 22.0, 20.0})) << "before the focus there is nothing";
}

TEST(Peeler, KeepsWhatHasNotChangedAndForgetsWhatIsNotUsed) {
  Scene scene = block({.amount = 0.7, .depth = 0.5, .radius = 5.0, .margin = 6.0});
  Peeler peeler;
  EXPECT_FALSE(peeler.knows(scene));
  const auto first = peeler.of(scene);
  EXPECT_TRUE(peeler.knows(scene));
  EXPECT_FALSE(peelOf(first->scene.look)) << "it is not peeled again";
  scene.look.shading.ambient = 0.9;
  const auto lit = peeler.of(scene);
  EXPECT_EQ(lit->scene.volume, first->scene.volume);
  EXPECT_EQ(lit->scene.look.shading.ambient, 0.9);
  for (double methods::Peel::*number : {&methods::Peel::amount, &methods::Peel::turn, &methods::Peel::depth,
                                        &methods::Peel::radius, &methods::Peel::margin}) {
    Scene other = scene;
    other.look.method.of<methods::Peel>().*number += 0.125;
    EXPECT_FALSE(peeler.knows(other));
  }
  Scene other = scene;
  other.look.focus = std::monostate{};
  EXPECT_FALSE(peeler.knows(other));
  EXPECT_TRUE(peeler.of(other)) << "without a focus, it opens the volume's middle";
  other.look.method.of<methods::Peel>().amount = 0.0;
  EXPECT_TRUE(peeler.knows(other));
  EXPECT_EQ(peeler.of(other), nullptr);
  EXPECT_FALSE(peeler.knows(scene));
}

/// The layer is empty: the focus is the front of the body.
TEST(Peeler, LeavesAVolumeWithoutALayerAsItIs) {
  Scene scene = block({.amount = 1.0, .depth = 0.0, .radius = 5.0, .margin = 6.0});
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.y < 6; });
  Peeler peeler;
  EXPECT_EQ(peeler.of(scene), nullptr);
  EXPECT_TRUE(peeler.knows(scene));
}

/// Halves of a block that are rolled up by little look blurred as far as trilinear values between voxels are: at least
/// (2/3)^½ of the deviation of white noise stays along each axis that moves off the voxels, on average over places.
TEST(PeeledScene, BlursOnlyWhatIsMoved) {
  Scene scene = block({.amount = 0.5, .depth = 0.0, .radius = 12.0, .margin = 6.0});
  std::mt19937 random(3);
  std::normal_distribution<float> noise(500.0f, 100.0f);
  const auto noisy = volumeOf<float>(scene.volume->grid, [&](glm::ivec3) { return noise(random); });
  scene.volume = noisy;
  Peeler peeler;
  const auto peeled = peeler.of(scene);
  ASSERT_TRUE(peeled);
  double sum = 0.0, squares = 0.0;
  int count = 0;
  const Volume& drawn = *peeled->scene.volume;
  forEachVoxel(drawn.grid.dims, [&](glm::ivec3 voxel) {
    const glm::dvec3 world(drawn.grid.worldFromIndex() * glm::dvec4(glm::dvec3(voxel), 1.0));
    const Peel::Source source = peeled->peel.sourceOf(world);
    const glm::dvec3 local = peeled->peel.local(source.world);
    if (source.part != Peel::Part::Positive || local.z < 2.0 || local.z > peeled->peel.thickness() - 2.0 ||
        local.y < 2.0 || std::abs(local.x) > peeled->peel.halfLength() - 2.0 || source.world.x > 57.0)
      return;
    sum += drawn.value(voxel);
    squares += drawn.value(voxel) * drawn.value(voxel);
    ++count;
  });
  ASSERT_GT(count, 500);
  const double mean = sum / count, deviation = std::sqrt(squares / count - mean * mean);
  EXPECT_NEAR(mean, 500.0, 6.0 * 100.0 / std::sqrt(count));
  // Along the cut the layer does not move off the voxels, so that two axes blur: 2/3 of the deviation stays. The
  // estimate's own deviation is 1/√(2n) of it, and neighbours depend on each other: 10 % is beyond both.
  EXPECT_NEAR(deviation / 100.0, 2.0 / 3.0, 0.067);
}

}  // namespace
}  // namespace fenestra::peelTest
