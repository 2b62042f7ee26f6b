// A ghosted selection in the reference: edges and rays along an axis against closed forms, pictures against a sum of
// short steps.

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/reference/Ghosting.h"
#include "rendering/reference/Picture.h"
#include "rendering/scene/Fading.h"
#include "tests/support/Scenes.h"
#include "tests/unit/FadingContexts.h"

namespace fenestra::reference::referenceSelectionTest {
namespace {

using namespace tests;

constexpr glm::ivec2 size{9, 7};
constexpr double extinction = 0.15;
const glm::dvec3 colour(0.9, 0.6, 0.3), focusColour(0.2, 0.3, 0.9);

Method ghosted(double strength, double edge, double outline) {
  return methods::Selection{.strength = strength, .edge = edge, .outline = outline};
}

/// Haze of one extinction, and behind it, seen from the front, the focus: all values of 2 and more.
Scene haze(const Method& method) {
  Scene scene;
  scene.look.context.function = {{{-10.0, {colour, extinction}}, {200.0, {colour, extinction}}}};
  scene.look.focus = ValueFocus{{2.0, 1e6}, 0.0};
  scene.look.focusAppearance = {focusColour, 1e4, {}};
  scene.look.shading.enabled = false;
  scene.look.contextLayer.strength = scene.look.cutaway.borderWidth = scene.look.cutaway.openWidth = 0.0;
  scene.look.method = method;
  return scene;
}

Camera fromTheFront(const Scene& scene) {
  return Camera::standard(StandardView::Anterior, scene.volume->grid, Projection::Orthographic);
}

TEST(ReferenceSelection, EdgesAreWeighedByTheirGradientAndTheSideTheyAreSeenFrom) {
  const glm::dvec3 forward(0.0, 0.6, 0.8), aside(1.0, 0.0, 0.0);
  const Ghosting all({1.0, 0.25, 0.0}), outlines({1.0, 0.25, 1.0}), half({0.5, 0.25, 0.5});
  EXPECT_EQ(all.factor(glm::dvec3(0.0), forward), 0.0) << "what is flat gives way";
  EXPECT_EQ(half.factor(glm::dvec3(0.0), forward), 0.5);
  EXPECT_DOUBLE_EQ(all.edge(0.25 * forward, forward), 0.5);
  EXPECT_DOUBLE_EQ(all.edge(0.25 * aside, forward), 0.5);
  EXPECT_NEAR(all.edge(1e6 * aside, forward), 1.0, 1e-12);
  EXPECT_NEAR(outlines.edge(3.0 * forward, forward), 0.0, 1e-15);
  EXPECT_DOUBLE_EQ(outlines.edge(3.0 * aside, forward), all.edge(3.0 * aside, forward));
  EXPECT_DOUBLE_EQ(half.edge(3.0 * forward, forward), 0.5 * all.edge(3.0 * forward, forward));
  EXPECT_EQ(Ghosting({0.0, 0.25, 0.5}).factor(glm::dvec3(0.3), forward), 1.0) << "no strength, no ghost";
}

/// A plane of the context in which values step from 0 to 1 between two voxels, and the focus behind it. Central
/// differences are half the step at those two voxels, which is the steepest slope; between voxels they are linear. So g
/// rises from 0 to 1 over a voxel's length h, stays, and falls; with E = edge, over all three
///
///   ∫ g²/(g² + E²) dt = h (1/(1 + E²) + 2 (1 - E atan(1/E)))
///
/// and the ray looks along the gradient.
TEST(ReferenceSelection, AStepBeforeTheFocusHasAClosedForm) {
  const Grid grid = gridOf({9, 30, 9});
  const double h = grid.spacing.y;
  for (const double strength : {1.0, 0.6, 0.0})
    for (const double edge : {0.01, 0.3, 10.0})
      for (const double outline : {0.0, 0.7, 1.0}) {
        SCOPED_TRACE(testing::Message() << strength << ", " << edge << ", " << outline);
        Scene scene = haze(ghosted(strength, 100.0 * edge, outline));
        scene.volume = volumeOf<float>(grid, [](glm::ivec3 i) { return i.y <= 8 ? 0.0 : 1.0; });
        scene.labels = labelsOf(grid, [](glm::ivec3 i) { return i.y >= 20 ? 1 : 0; });
        scene.look.focus = LabelFocus{{1}};
        const double edges =
            (1.0 - outline) * h * (1.0 / (1.0 + edge * edge) + 2.0 * (1.0 - edge * std::atan(1.0 / edge)));
        // The volume begins half a voxel before its first, and the indicator of the focus is ½ half a voxel before its.
        const double opacity = -std::expm1(-extinction * ((1.0 - strength) * 20.0 * h + strength * edges));
        const Picture here = picture(scene, fromTheFront(scene), size, {.tolerance = 1e-9, .pixels = {}});
        const glm::dvec4 found = here.final[here.final.size() / 2];
        EXPECT_NEAR(found.a, 1.0, 2e-9);
        // Channel by channel: ghost over a focus of another colour, which follows from a picture without the ghost.
        Scene alone = scene;
        alone.look.context.function = {{{-10.0, {colour, 0.0}}, {200.0, {colour, 0.0}}}};
        const glm::dvec3 behind(picture(alone, fromTheFront(scene), size).final[here.final.size() / 2]);
        EXPECT_LT(glm::distance(glm::dvec3(found), opacity * colour + (1.0 - opacity) * behind), 4e-5);
      }
}

TEST(ReferenceSelection, AFlatSlabLeavesTheFocusAsItIs) {
  Scene scene = haze(ghosted(1.0, 10.0, 0.5));
  const Grid grid = gridOf({20, 30, 24});
  // All voxels have one value but for a corner, which gives the volume a range: without one there are no edges.
  scene.volume = volumeOf<float>(grid, [](glm::ivec3 i) { return i == glm::ivec3(0, 29, 0) ? 1.0 : 0.0; });
  scene.labels = labelsOf(
      grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(10.0, 18.0, 12.0)) < 5.0 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  Scene alone = scene, plain = scene;
  alone.look.context.function = {{{-10.0, {colour, 0.0}}, {200.0, {colour, 0.0}}}};
  plain.look.cutaway.enabled = false;
  const Camera camera = fromTheFront(scene);
  const glm::ivec2 wide{31, 25};
  const Picture here = picture(scene, camera, wide), focus = picture(alone, camera, wide),
                whole = picture(plain, camera, wide);
  const HitPoints hits = hitPoints(scene, camera, wide);
  int met = 0, beside = 0;
  for (std::size_t i = 0; i < here.final.size(); ++i) {
    const bool isMet = !std::isnan(hits.tFocus[i]);
    (isMet ? met : beside) += whole.final[i].a > 0.5;
    // The one voxel of another value lies behind everything that is met.
    EXPECT_LT(glm::distance(here.final[i], isMet ? focus.final[i] : whole.final[i]), 4e-5) << i;
  }
  EXPECT_GT(met, 30);
  EXPECT_GT(beside, 100);
}

/// The sum of short steps along a ray, in the middle of each.
glm::dvec4 summed(const Scene& scene, const Camera& camera, const Stages& stages, glm::ivec2 pixel, int count) {
  const Volume& volume = *scene.volume;
  const Ray ray = pixelRay(camera, size, pixel), inIndex = indexRay(ray, volume.grid);
  const std::optional<Span> span = clip(ray, volume.grid);
  glm::dvec4 sum(0.0);
  if (!span) return sum;
  const auto i = static_cast<std::size_t>(pixel.y * size.x + pixel.x);
  const bool opened = stages.tStart[i] > stages.hits.tContext[i] || !std::isnan(stages.hits.tFocus[i]);
  const Method& method = scene.look.method;
  const auto& focus = std::get<ValueFocus>(scene.look.focus);
  const double step = (span->tOut - span->tIn) / count, half = 0.01 * method.of<methods::Selection>().edge;
  for (int k = 0; k < count; ++k) {
    const double t = span->tIn + (k + 0.5) * step;
    const glm::dvec3 at = inIndex.origin + t * inIndex.direction;
    const double value = interpolated(volume.grid, at, [&](glm::ivec3 voxel) { return volume.value(voxel); });
    OpticalProperties shown = scene.look.context.function.evaluate(value);
    bool ghost = opened && t < stages.tStart[i];
    if (stages.apart) ghost = ghost || (stages.apart->holeBegin[i] < t && t < stages.apart->holeEnd[i]);
    if (value >= focus.values.low) {
      shown = {scene.look.focusAppearance.colour, scene.look.focusAppearance.extinction};
    } else if (ghost) {
      const glm::dvec3 inWorld =
          glm::transpose(glm::dmat3(volume.grid.indexFromWorld())) * gradientAt(volume, at) / steepestSlope(volume);
      const double length = glm::length(inWorld), cosine = glm::dot(inWorld, ray.direction) / std::max(length, 1e-30);
      const double edge = length * length / (length * length + half * half) *
                          (1.0 - method.of<methods::Selection>().outline * cosine * cosine);
      shown.extinction *= 1.0 - method.of<methods::Selection>().strength * (1.0 - edge);
    }
    sum += (1.0 - sum.a) * -std::expm1(-shown.extinction * step) * glm::dvec4(shown.colour, 1.0);
  }
  return sum;
}

/// Values that bend, with a ridge in focus.
Scene bent(const Method& method) {
  Scene scene = haze(method);
  scene.volume = volumeOf<float>(gridOf({20, 30, 24}), [](glm::ivec3 i) {
    const glm::dvec3 from = glm::dvec3(i) - glm::dvec3(9.0, 17.0, 12.0);
    return 60.0 * std::exp(-0.04 * glm::dot(from, from)) + 8.0 * std::sin(0.5 * i.y) * std::cos(0.3 * i.x) + 0.5 * i.z;
  });
  scene.look.context.function = {{{-20.0, {colour, 0.1}}, {60.0, {glm::dvec3(0.2, 0.5, 0.9), 0.3}}}};
  scene.look.focus = ValueFocus{{45.0, 1e6}, 0.0};
  scene.look.focusAppearance = {focusColour, 0.4, {}};
  return scene;
}

TEST(ReferenceSelection, PicturesAreTheLimitOfTheSum) {
  for (const double width : {0.0, 2.5})
    for (const bool frozen : {false, true}) {
      SCOPED_TRACE(testing::Message() << width << (frozen ? ", frozen" : ""));
      Scene scene = bent(ghosted(0.9, 12.0, 0.6));
      scene.look.cutaway.openWidth = width;
      const Grid& grid = scene.volume->grid;
      View view{.camera = Camera::fromAngles(20.0, 15.0, grid, Projection::Perspective), .size = size};
      if (frozen) view.frozen = OpeningView{Camera::fromAngles(70.0, 5.0, grid), size, 1.0};
      const Stages stages = geometricStages(scene, view);
      const Picture here = picture(scene, view.camera, size, stages);
      Scene adaptive = scene, plain = scene;
      adaptive.look.method = {};
      plain.look.cutaway.enabled = false;
      const Picture cut = picture(adaptive, view.camera, size, stages), whole = picture(plain, view.camera, size);
      double fromCut = 0.0, fromWhole = 0.0;
      for (int j = 0; j < size.y; ++j)
        for (int i = 0; i < size.x; ++i) {
          const glm::dvec4 found = here.final[static_cast<std::size_t>(j * size.x + i)];
          // The four steps of 2 µm at the ends of a ghost and of the focus are half wrong: 0.4 · 4e-3; and the
          // reference has a tolerance of 1e-5.
          EXPECT_LT(glm::distance(found, summed(scene, view.camera, stages, {i, j}, 20000)), 9e-4) << i << ", " << j;
          fromCut = std::max(fromCut, glm::distance(found, cut.final[static_cast<std::size_t>(j * size.x + i)]));
          fromWhole = std::max(fromWhole, glm::distance(found, whole.final[static_cast<std::size_t>(j * size.x + i)]));
        }
      EXPECT_GT(fromCut, 0.01) << "the test would notice what is cut away";
      EXPECT_GT(fromWhole, 0.01) << "the test would notice what is not ghosted";
    }
}

TEST(ReferenceSelection, WithoutStrengthOrFocusOrCutawayItIsPlainRendering) {
  for (const bool lit : {false, true}) {
    Scene scene = bent(ghosted(1.0, 12.0, 0.6));
    scene.look.shading.enabled = lit;
    scene.look.cutaway.openWidth = 2.5;
    const Camera camera = Camera::fromAngles(20.0, 15.0, scene.volume->grid);
    const Picture ghost = picture(scene, camera, size);
    Scene weak = scene, off = scene, unfocused = scene, never = scene;
    weak.look.method.of<methods::Selection>().strength = 0.0;
    off.look.cutaway.enabled = false;
    unfocused.look.focus = {};
    never.look.focus = {};
    never.look.method = {};
    const Picture plain = picture(off, camera, size), unghosted = picture(weak, camera, size);
    const Picture here = picture(unfocused, camera, size), there = picture(never, camera, size);
    double greatest = 0.0;
    for (std::size_t i = 0; i < plain.final.size(); ++i) {
      // Two integrals of tolerance 1e-5 in each of four channels.
      EXPECT_LT(glm::distance(unghosted.final[i], plain.final[i]), 4e-5) << i;
      EXPECT_EQ(here.final[i], there.final[i]) << i;
      EXPECT_LE(ghost.final[i].a, plain.final[i].a + 2e-5) << "a ghost is never more opaque";
      greatest = std::max(greatest, plain.final[i].a - ghost.final[i].a);
    }
    EXPECT_GT(greatest, 0.05) << "the test would notice";
  }
}

TEST(ReferenceSelection, TheEstimatedErrorKeepsToTheTolerance) {
  for (const double edge : {0.5, 30.0}) {
    Scene scene = bent(ghosted(1.0, edge, 0.6));
    scene.look.shading.enabled = true;
    scene.look.cutaway.openWidth = 2.5;
    for (TransferFunction::Node& node : scene.look.context.function.nodes) node.properties.extinction *= 10.0;
    expectErrorsWithinTheTolerance(scene, Camera::fromAngles(20.0, 15.0, scene.volume->grid), size);
  }
}

}  // namespace
}  // namespace fenestra::reference::referenceSelectionTest
