// The reference of exploded views against closed forms, and against plain pictures of single parts.

#include <gtest/gtest.h>

#include "rendering/reference/Exploded.h"
#include "rendering/reference/Picture.h"
#include "rendering/scene/Explosion.h"
#include "tests/unit/FadingContexts.h"

namespace fenestra::reference::referenceExplodedTest {
namespace {

using namespace tests;

constexpr glm::ivec2 size{41, 41};
const glm::dvec3 colour(0.8, 0.6, 0.4);

/// A cube of 40 mm of one material, unlit, with a ball of 4 mm in its middle as label 1.
Scene block(double extinction, int planes, double degree) {
  Scene scene;
  const Grid grid = gridOf({40, 40, 40});
  scene.volume = volumeOf<std::uint8_t>(grid, [](glm::ivec3) { return 100; });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) { return glm::distance(glm::dvec3(i), glm::dvec3(19.5)) < 4.0; });
  scene.look.context.function = {{{50.0, {colour, extinction}}, {150.0, {colour, extinction}}}};
  scene.look.focusAppearance = {{0.2, 0.3, 0.9}, 2.0, {}};
  scene.look.shading.enabled = false;
  scene.look.method = methods::Explode{.degree = degree, .planes = static_cast<ExplosionPlanes>(planes - 1)};
  return scene;
}

Camera along(StandardView side, const Grid& grid, double height = 120.0) {
  Camera camera = Camera::standard(side, grid, Projection::Orthographic);
  camera.orthographicHeight = height;
  return camera;
}

ExplodedView layoutOf(const Scene& scene, const Camera& camera) {
  return {*explosionOf(scene.look), scene.volume->grid, focusCentre(scene), camera};
}

glm::dvec4 at(const Picture& picture, int i, int j) { return picture.final[static_cast<std::size_t>(j * size.x + i)]; }

/// Seen along the plane, both halves stand apart by their translations, and between them is nothing.
TEST(ReferenceExploded, TwoHalvesOfABlockLeaveAGap) {
  for (const double extinction : {0.02, 0.5})
    for (const double degree : {0.2, 1.0}) {
      const Scene scene = block(extinction, 1, degree);
      const Camera camera = along(StandardView::Anterior, scene.volume->grid);
      const ExplodedView layout = layoutOf(scene, camera);
      const double right = layout.translation(1).x, left = layout.translation(0).x;
      ASSERT_GT(right, 1.0);
      EXPECT_NEAR(right, -left, 1e-6);
      // Nothing else moves them: the forces along the planes are the same for both.
      EXPECT_NEAR(layout.translation(1).y, layout.translation(0).y, 1e-6);
      const Picture here = picture(scene, camera, size, {.tolerance = 1e-8, .pixels = {}});
      const double opacity = -std::expm1(-extinction * 40.0), pixel = 120.0 / size.y;
      int inside = 0, between = 0;
      for (int i = 0; i < size.x; ++i) {
        const double x = (i + 0.5 - 0.5 * size.x) * pixel;  // of the ray, to the patient's left
        const double place = x > 0.0 ? x - right : x - left;
        const bool hits = (x > 0.0 ? place > 0.0 : place < 0.0) && std::abs(place) < 20.0;
        const glm::dvec4 found = at(here, i, size.y / 2);
        EXPECT_NEAR(found.a, hits ? opacity : 0.0, 1e-7) << i;
        EXPECT_LT(glm::distance(glm::dvec3(found), (hits ? opacity : 0.0) * colour), 2e-7) << i;
        (hits ? inside : between) += 1;
      }
      EXPECT_GT(inside, 10);
      EXPECT_GT(between, 10);
    }
}

/// Across the plane: a ray passes one half, the gap, and the other half, so the whole block.
TEST(ReferenceExploded, ARayAcrossThePlanePassesBothHalves) {
  const Scene scene = block(0.02, 1, 0.6);
  const Camera camera = along(StandardView::Left, scene.volume->grid, 30.0);
  const Picture here = picture(scene, camera, size, {.tolerance = 1e-8, .pixels = {}});
  const ExplodedView layout = layoutOf(scene, camera);
  ASSERT_GT(layout.translation(1).x - layout.translation(0).x, 5.0);
  // The front half is pushed out of the line of sight; this pixel is in the shadow of both.
  EXPECT_NEAR(at(here, size.x / 2, 2 * size.y / 3).a, -std::expm1(-0.02 * 40.0), 1e-7);
}

TEST(ReferenceExploded, AtDegreeZeroItIsThePlainPicture) {
  Scene scene = block(0.05, 3, 0.0);
  scene.look.focus = LabelFocus{{1}};
  const Camera camera = Camera::fromAngles(20.0, 15.0, scene.volume->grid);
  const Picture here = picture(scene, camera, size);
  scene.look.cutaway.enabled = false;
  EXPECT_EQ(picture(scene, camera, size).final, here.final);
}

TEST(ReferenceExploded, TheFocusStaysInItsPlace) {
  for (int planes = 1; planes <= 3; ++planes) {
    Scene scene = block(0.05, planes, 0.8);
    scene.look.focus = LabelFocus{{1}};
    for (TransferFunction::Node& node : scene.look.context.function.nodes) node.properties.extinction = 0.0;
    expectTheFocusAlone(scene, Camera::fromAngles(20.0, 15.0, scene.volume->grid), size, 0.9);
  }
}

/// A focus without extinction shows only as the hollow that it leaves in the parts.
TEST(ReferenceExploded, PartsAreHollowWhereTheFocusWas) {
  Scene scene = block(0.02, 1, 0.6);
  scene.look.focus = LabelFocus{{1}};
  scene.look.focusAppearance.extinction = 0.0;
  const Camera camera = along(StandardView::Anterior, scene.volume->grid, 60.0);
  const double right = layoutOf(scene, camera).translation(1).x;
  Scene solid = scene;
  solid.look.focus = {};
  const Picture here = picture(scene, camera, size), whole = picture(solid, camera, size);
  const double pixel = 60.0 / size.y;
  int hollow = 0;
  for (int i = size.x / 2 + 1; i < size.x; ++i) {
    const double place = (i + 0.5 - 0.5 * size.x) * pixel - right;
    const glm::dvec4 a = at(here, i, size.y / 2), b = at(whole, i, size.y / 2);
    if (place > 0.0 && place < 3.0) {
      EXPECT_LT(a.a, b.a - 0.05) << place;
      ++hollow;
    } else if (place < 0.0 || place > 5.0) {
      EXPECT_NEAR(a.a, b.a, 2e-5) << place;
    }
  }
  EXPECT_GE(hollow, 1);
}

/// One part after the other as a plain picture by a camera moved back, clipped to the part: laid over each other in the
/// order of the parts.
TEST(ReferenceExploded, ItsPartsAreClippedPicturesLaidOverEachOther) {
  for (const ExplosionAxes axes : {ExplosionAxes::Patient, ExplosionAxes::View})
    for (int planes = 1; planes <= 3; ++planes) {
      Scene scene = block(0.05, planes, 0.7);
      scene.volume = volumeOf<float>(scene.volume->grid, [](glm::ivec3 i) { return 60.0 + 0.05 * i.y * i.y + i.x; });
      scene.look.context.function.nodes[1].properties = {{0.1, 0.9, 0.3}, 0.2};
      scene.look.shading.enabled = true;
      scene.look.method.of<methods::Explode>().axes = axes;
      const Camera camera = Camera::fromAngles(25.0, 15.0, scene.volume->grid);
      const Picture here = picture(scene, camera, size);
      std::vector<glm::dvec4> laid(here.final.size(), glm::dvec4(0.0));
      for (const ExplodedPart& part : layoutOf(scene, camera).parts()) {
        Scene alone = scene;
        alone.look.cutaway.enabled = false;
        alone.look.clipping.planes = part.kept;
        Camera moved = camera;
        moved.eye -= part.translation;
        moved.target -= part.translation;
        const Picture layer = picture(alone, moved, size);
        for (std::size_t i = 0; i < laid.size(); ++i) laid[i] += (1.0 - laid[i].a) * layer.final[i];
      }
      double greatest = 0.0;
      for (std::size_t i = 0; i < laid.size(); ++i) {
        // Nine integrals of a tolerance of 1e-5 in each of four channels.
        EXPECT_LT(glm::distance(laid[i], here.final[i]), 2e-4) << i;
        greatest = std::max(greatest, laid[i].a);
      }
      EXPECT_GT(greatest, 0.5);
    }
}

TEST(ReferenceExploded, TheEstimatedErrorKeepsToTheTolerance) {
  Scene scene = block(0.3, 3, 0.7);
  scene.look.focus = LabelFocus{{1}};
  scene.volume = volumeOf<float>(scene.volume->grid, [](glm::ivec3 i) { return 60.0 + 0.05 * i.y * i.y + i.x; });
  scene.look.shading.enabled = true;
  expectErrorsWithinTheTolerance(scene, Camera::fromAngles(20.0, 15.0, scene.volume->grid), size);
}

}  // namespace
}  // namespace fenestra::reference::referenceExplodedTest
