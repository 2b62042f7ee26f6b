// Peeled volumes: the voxels against the reference's, and pictures against closed forms.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "rendering/reference/Peeled.h"
#include "rendering/reference/Picture.h"
#include "rendering/scene/PeeledScene.h"
#include "tests/support/FeatureScenes.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referencePeeledTest {
namespace {

using namespace tests;

Method methodOf(const MethodStages::Peel& peel) {
  return methods::Peel{.amount = peel.amount,
                       .side = peel.side,
                       .turn = peel.turn,
                       .depth = peel.depth,
                       .radius = peel.radius,
                       .margin = peel.margin};
}

/// Values that vary everywhere, in a body within air, with three labels; the focus has a share of its radius.
template <class T>
Scene lively(const Grid& grid, const MethodStages::Peel& peel, double focusRadius = 0.3) {
  Scene scene;
  const glm::dvec3 middle = 0.5 * glm::dvec3(grid.dims - 1);
  const auto radius = [=](glm::ivec3 i) { return glm::length((glm::dvec3(i) - middle) / (middle - 1.0)); };
  scene.volume = volumeOf<T>(grid, [&](glm::ivec3 i) {
    return radius(i) > 1.0 ? 0.0 : 80.0 + 30.0 * std::sin(0.9 * i.x) * std::cos(0.7 * i.y) + 3.0 * i.z;
  });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) {
    return radius(i) < focusRadius ? 1 : radius(i) > 0.9 ? 0 : i.x > middle.x ? 2 : 3;
  });
  scene.look.focus = LabelFocus{{1}};
  scene.look.method = methodOf(peel);
  return scene;
}

/// Voxels and labels are the reference's: integers but for ties of their rounding.
void expectAgreement(const Scene& scene) {
  Peeler peeler;
  const auto here = peeler.of(scene);
  const auto truth = peeledScene(scene);
  ASSERT_TRUE(here && truth);
  const Volume &a = *here->scene.volume, &b = *truth->volume;
  ASSERT_EQ(a.grid.dims, b.grid.dims);
  EXPECT_LT(glm::distance(a.grid.origin, b.grid.origin), 1e-9);
  EXPECT_EQ(a.range, b.range);
  const bool isInteger = a.voxels.type() != ScalarType::Float32 && a.voxels.type() != ScalarType::Float64;
  // The exact inverse and bisection agree in 12 digits and values change by less than 100 a voxel.
  const double tolerance = isInteger ? 0.0 : 1e-4;
  std::size_t off = 0, otherLabels = 0, moved = 0, count = 0;
  forEachVoxel(a.grid.dims, [&](glm::ivec3 voxel) {
    ++count;
    off += !(std::abs(a.value(voxel) - b.value(voxel)) <= tolerance);
    EXPECT_LE(std::abs(a.value(voxel) - b.value(voxel)), std::max(std::abs(a.slope), tolerance));
    if (scene.labels) otherLabels += here->scene.labels->value(voxel) != truth->labels->value(voxel);
    if (scene.structures) otherLabels += here->scene.structures->value(voxel) != truth->structures->value(voxel);
    const glm::dvec3 world(a.grid.worldFromIndex() * glm::dvec4(glm::dvec3(voxel), 1.0));
    moved += here->peel.sourceOf(world).part >= Peel::Part::Negative;
  });
  EXPECT_GT(moved, 300u);
  // One in 64 means of 64 integers is a tie, and rounds by its last bit.
  EXPECT_LE(off, count / 200);
  EXPECT_EQ(otherLabels, 0u);
  if (scene.look.clipping.cropped) {
    EXPECT_EQ(here->scene.look.clipping, truth->look.clipping);
  }
  EXPECT_EQ(here->scene.look.reconstruction, truth->look.reconstruction);
}

const std::vector<MethodStages::Peel> peels{
    {.amount = 0.37, .depth = 0.4, .radius = 4.0, .margin = 2.5},
    {.amount = 1.0, .side = PeelSide::Left, .turn = 33.0, .depth = 0.0, .radius = 3.0, .margin = 4.0},
    {.amount = 0.8, .side = PeelSide::Inferior, .turn = -120.0, .depth = 1.0, .radius = 9.0, .margin = 1.0}};

TEST(ReferencePeeled, Thorough_VoxelsAndLabelsAgree) {
  for (const MethodStages::Peel& peel : peels) {
    SCOPED_TRACE(peel.amount);
    expectAgreement(lively<std::int16_t>(gridOf({30, 34, 28}, {1.0, 1.2, 0.9}, {-70.0, 300.0, 12.0}), peel));
    expectAgreement(lively<float>(obliqueGrid({24, 22, 18}), peel));
    expectAgreement(lively<std::uint8_t>(gridOf({31, 27, 25}), peel));
  }
}

/// So thin a layer, so wide a margin and so tight a roll that the layer's ends fold back.
TEST(ReferencePeeled, AFoldedLayerAgrees) {
  const Scene scene =
      lively<std::int16_t>(gridOf({50, 30, 20}), {.amount = 1.0, .depth = 0.0, .radius = 1.0, .margin = 60.0}, 0.75);
  const Peel peel(*peelOf(scene.look), FocusVoxels(scene), scene.volume->grid, bodyBox(shownVolume(scene)));
  ASSERT_GT(peel.roll(), 1.5 * std::numbers::pi * peel.radius());
  expectAgreement(scene);
}

TEST(ReferencePeeled, Thorough_HardCasesAgree) {
  const MethodStages::Peel peel = peels.front();
  const Grid grid = gridOf({30, 34, 28});
  Scene withoutFocus = lively<std::int16_t>(grid, peel);
  withoutFocus.look.focus = std::monostate{};
  expectAgreement(withoutFocus);
  Scene noSuchLabel = lively<std::int16_t>(grid, peel);
  noSuchLabel.look.focus = LabelFocus{{9}};
  expectAgreement(noSuchLabel);
  Scene ofValues = lively<std::int16_t>(grid, peel);
  ofValues.look.focus = ValueFocus{{140.0, 1000.0}, 0.0};
  expectAgreement(ofValues);
  ofValues.look.focus = ValueFocus{{140.0, 1000.0}, 40.0};
  expectAgreement(ofValues);
  Scene hidden = lively<std::int16_t>(grid, peel);
  hidden.look.labels = {{.label = 2, .role = LabelRole::Hidden}};
  hidden.table = tableWhere(grid, [](glm::ivec3 i) { return i.y > 30; });
  Removal ball;
  ball.points = {grid.centre() + glm::dvec3(3.0, -8.0, 0.0)};
  ball.size = 4.0;
  hidden.look.removals = {ball};
  hidden = Sculptor().of(hidden);
  expectAgreement(hidden);
  Scene structures = lively<std::int16_t>(grid, peel);
  structures.structures = structures.labels;
  structures.labels =
      labelsOf(grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(15, 20, 14)) < 4.0; });
  expectAgreement(structures);
  Scene cropped = lively<std::int16_t>(grid, peel);
  const CropFrame frame(grid);
  cropped.look.clipping.cropped = true;
  cropped.look.clipping.box = {frame.low + glm::dvec3(4.0, 0.0, 0.0), frame.high - glm::dvec3(0.0, 0.0, 3.0)};
  expectAgreement(cropped);
  Scene odd = lively<float>(grid, peel);
  auto volume = volumeOf<float>(grid, [&](glm::ivec3 i) { return odd.volume->value(i); });
  volume->slope = -0.5;
  volume->intercept = 300.0;
  volume->computeRange();
  odd.volume = volume;
  expectAgreement(odd);
}

constexpr glm::ivec2 size{33, 33};

/// A slab that is rolled up: a ray that runs along a normal of the roll, through its axis, passes all of its thickness,
/// and so has the slab's own optical depth, wherever on the roll it is.
TEST(ReferencePeeled, ARolledSlabKeepsItsOpticalDepthAlongNormals) {
  const Grid grid = gridOf({120, 40, 12});
  constexpr double extinction = 0.05;
  Scene scene;
  scene.volume = volumeOf<float>(grid, [](glm::ivec3 i) { return i.y < 10 || i.y >= 30 ? 0.0 : 1.0; });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) { return std::abs(i.x - 59.5) < 15.0 && i.y == 20; });
  scene.look.focus = LabelFocus{{1}};
  // In proportion to the value, so that soft faces do not change the depth.
  scene.look.context.function = {{{0.0, {glm::dvec3(1.0), 0.0}}, {1.0, {glm::dvec3(1.0), extinction}}}};
  scene.look.focusAppearance.extinction = 0.0;
  scene.look.shading.enabled = false;
  scene.look.method = methodOf({.amount = 1.0, .depth = 0.0, .radius = 12.0, .margin = 10.0});
  const Peel peel(*peelOf(scene.look), FocusVoxels(scene), grid, bodyBox(shownVolume(scene)));
  ASSERT_GT(peel.roll() / peel.radius(), 1.2) << "rolled far enough";
  Scene rolled = *peeledScene(scene);
  for (const double turn : {0.7, 0.9, 1.1}) {
    const glm::dvec3 axis = peel.world({0.0, peel.roll(), peel.radius()});
    const glm::dvec3 outward = peel.world({0.0, peel.roll() - std::sin(turn), peel.radius() - std::cos(turn)}) - axis;
    Camera camera;
    camera.projection = Projection::Orthographic;
    camera.target = axis;
    camera.eye = axis + 200.0 * outward;
    camera.up = {0.0, 0.0, 1.0};
    camera.orthographicHeight = 1.0;
    // Only the part between the roll's axis and 4 mm beyond the roll counts: there the ray meets nothing else.
    rolled.look.clipping.planes = {{outward, glm::dot(outward, axis)},
                                   {-outward, -glm::dot(outward, axis) - peel.radius() - 4.0}};
    const Picture here = picture(rolled, camera, glm::ivec2(1), {.tolerance = 1e-7, .pixels = {}});
    const double depth = -std::log1p(-here.final.front().a);
    // Soft faces keep the depth but for how they lie among the voxels: half a voxel of the thickness.
    EXPECT_NEAR(depth / (extinction * peel.thickness()), 1.0, 0.5 / peel.thickness()) << turn;
  }
}

/// A ball in the layer: its rays after it is rolled up meet it where its definition, point by point, brings it.
TEST(ReferencePeeled, Thorough_ARolledBallIsSeenWhereItsPointsGo) {
  const Grid grid = gridOf({100, 60, 30});
  const glm::dvec3 ball(58.0, 20.0, 15.0);
  constexpr double radius = 7.0, spread = 1.0;
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3 i) {
    return i.y < 6 ? -500.0 : 0.5 - (glm::distance(glm::dvec3(i), ball) - radius) / spread;
  });
  scene.labels =
      labelsOf(grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(49, 45, 15)) < 9.0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(0.5);
  scene.look.focusAppearance.extinction = 0.0;
  scene.look.shading.enabled = false;
  scene.look.method = methodOf({.amount = 0.6, .depth = 0.0, .radius = 30.0, .margin = 8.0});
  Camera camera = Camera::standard(StandardView::Anterior, grid, Projection::Orthographic);
  camera.orthographicHeight = 32.0;
  const Peel peel(*peelOf(scene.look), FocusVoxels(scene), grid, bodyBox(shownVolume(scene)));
  ASSERT_GT(glm::distance(peel.shownAt(ball), ball), 10.0);
  for (glm::dvec3* point : {&camera.eye, &camera.target}) point->x += peel.shownAt(ball).x - grid.centre().x;
  const Picture here = picture(scene, camera, size, {.tolerance = 1e-4, .pixels = {}});
  int hits = 0, wrong = 0, unsure = 0;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const Ray ray = pixelRay(camera, size, {i, j});
      double nearest = std::numeric_limits<double>::infinity();
      for (double t = 0.0; t < 600.0; t += 0.05) {
        const Peel::Source source = peel.sourceOf(ray.origin + t * ray.direction);
        if (source.part >= Peel::Part::Negative) nearest = std::min(nearest, glm::distance(source.world, ball));
      }
      const bool isHit = here.final[static_cast<std::size_t>(j * size.x + i)].a > 0.5;
      hits += isHit;
      // Trilinear values between moved voxels place the surface within a voxel, and voxels in the roll are up to as
      // much narrower as the roll's radius at the ball to that at the break.
      if (std::abs(nearest - radius) < 1.0)
        ++unsure;
      else
        wrong += isHit != (nearest < radius);
    }
  EXPECT_GT(hits, 100);
  EXPECT_EQ(wrong, 0);
  EXPECT_LT(unsure, hits);
}

TEST(ReferencePeeled, AtAmountZeroItIsThePlainPicture) {
  Scene scene = lively<std::int16_t>(gridOf({20, 20, 20}), peels.front());
  scene.look.method.of<methods::Peel>().amount = 0.0;
  EXPECT_FALSE(peeledScene(scene));
  const Camera camera = Camera::fromAngles(20.0, 15.0, scene.volume->grid);
  const Picture here = picture(scene, camera, size);
  scene.look.cutaway.enabled = false;
  EXPECT_EQ(picture(scene, camera, size).final, here.final);
}

}  // namespace
}  // namespace fenestra::reference::referencePeeledTest
