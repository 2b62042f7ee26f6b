// The greatest value of the context along rays in the reference: closed forms, and many samples of a ray.

#include "rendering/reference/Maximum.h"

#include <random>

#include <gtest/gtest.h>

#include "rendering/reference/Field.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceMaximumTest {
namespace {

using namespace tests;

constexpr MethodStages::Maximum layer{.thickness = 2.0};

/// Shows a value by its red, from 0 to 1000, with the same extinction everywhere.
constexpr double extinction = 0.3;
TransferFunction byRed() {
  return {{{0.0, {glm::dvec3(0.0, 0.5, 1.0), extinction}}, {1000.0, {glm::dvec3(1.0, 0.5, 1.0), extinction}}}};
}
const double opacity = 1.0 - std::exp(-extinction * layer.thickness);

double valueIn(const glm::dvec4& colour) {
  EXPECT_NEAR(colour.a, opacity, 1e-12);
  return 1000.0 * colour.r / colour.a;
}

/// Along x at a height and depth in the middle of a cell, in world coordinates.
CutRay alongX(const Scene& scene, double y = 4.3, double z = 5.6) {
  CutRay ray{.ray = {{-50.0, y, z}, {1.0, 0.0, 0.0}}, .span = {1.0, 0.0}};
  if (const auto span = clip(ray.ray, scene.volume->grid)) ray.span = *span;
  return ray;
}

Scene rampAlongX() {
  Scene scene;
  scene.volume = volumeOf(gridOf({12, 10, 10}), [](glm::ivec3 i) { return 50.0 * i.x; });
  scene.look.context.function = byRed();
  return scene;
}

TEST(ReferenceMaximum, OfARampIsAtItsHigherEnd) {
  const Scene scene = rampAlongX();
  CutRay ray = alongX(scene);
  EXPECT_NEAR(valueIn(maximumLayer(scene, {ray}, layer).front()), 550.0, 1e-9);
  ray.span.tOut = 50.0 + 7.25;
  EXPECT_NEAR(valueIn(maximumLayer(scene, {ray}, layer).front()), 362.5, 1e-9);
  ray.span = {1.0, 0.0};
  EXPECT_EQ(maximumLayer(scene, {ray}, layer).front(), glm::dvec4(0.0));
}

TEST(ReferenceMaximum, LeavesOutTheFocusAndTheHole) {
  Scene scene = rampAlongX();
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.x >= 6 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  CutRay ray = alongX(scene);
  // Half way between the last voxel before the focus and its first one.
  EXPECT_NEAR(valueIn(maximumLayer(scene, {ray}, layer).front()), 275.0, 1e-9);
  scene.look.focus = ValueFocus{{400.0, 1e9}, 0.0};
  EXPECT_NEAR(valueIn(maximumLayer(scene, {ray}, layer).front()), 400.0, 1e-6);
  scene.look.focus = {};
  ray.hole = {50.0 + 3.0, infinity};
  EXPECT_NEAR(valueIn(maximumLayer(scene, {ray}, layer).front()), 150.0, 1e-9);
}

TEST(ReferenceMaximum, LeavesOutValuesThatDoNotShow) {
  Scene scene = rampAlongX();
  scene.look.context.function = {{{0.0, {glm::dvec3(0.0, 0.5, 1.0), extinction}},
                                  {300.0, {glm::dvec3(0.3, 0.5, 1.0), extinction}},
                                  {300.0, {glm::dvec3(0.3, 0.5, 1.0), 0.0}}}};
  EXPECT_NEAR(valueIn(maximumLayer(scene, {alongX(scene)}, layer).front()), 300.0, 1e-6);
}

TEST(ReferenceMaximum, IsTheGreatestOfManySamples) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(0.0, 1000.0);
  const Grid grid = gridOf({12, 10, 10});
  Scene scene;
  scene.volume = volumeOf(grid, [&](glm::ivec3) { return value(random); });
  scene.look.context.function = byRed();
  const Field field(scene);
  for (int trial = 0; trial < 40; ++trial) {
    const glm::dvec3 from = randomIn(random, glm::dvec3(-20.0), glm::dvec3(30.0)),
                     to = randomIn(random, glm::dvec3(1.0), glm::dvec3(8.0));
    CutRay ray{.ray = {from, glm::normalize(to - from)}, .span = {1.0, 0.0}};
    const auto span = clip(ray.ray, grid);
    ASSERT_TRUE(span);
    ray.span = *span;
    double greatest = 0.0;
    constexpr int count = 40000;
    withValues(shownVolume(scene), [&](auto valueAt) {
      for (int i = 0; i <= count; ++i) {
        const double t = span->tIn + (span->tOut - span->tIn) * i / count;
        greatest = std::max(greatest, field.value(ray.ray.origin + t * ray.ray.direction, valueAt));
      }
    });
    const double found = valueIn(maximumLayer(scene, {ray}, layer).front());
    EXPECT_GE(found, greatest - 1e-6);
    // Between samples 5e-4 voxels apart a cubic of such values rises by less than 1e-3 at a turn.
    EXPECT_LE(found, greatest + 0.5);
  }
}

}  // namespace
}  // namespace fenestra::reference::referenceMaximumTest
