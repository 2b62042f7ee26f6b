// The reference of clipped scenes against closed forms.

#include <gtest/gtest.h>

#include "rendering/reference/Picture.h"
#include "rendering/scene/Lighting.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::referenceClippingTest {
namespace {

using namespace tests;

/// 40 mm of one material, unlit, without a focus.
Scene slab(double extinction) {
  Scene scene;
  scene.volume = volumeOf<std::uint8_t>(gridOf({40, 40, 40}), [](glm::ivec3) { return 100; });
  scene.look.context.function = {{{50.0, {{0.8, 0.6, 0.4}, extinction}}, {150.0, {{0.8, 0.6, 0.4}, extinction}}}};
  scene.look.shading.enabled = false;
  return scene;
}

/// From anterior, parallel rays along y.
Camera parallelTo(const Grid& grid, double height = 20.0) {
  const glm::dvec3 centre = grid.centre();
  return lookAt(centre - glm::dvec3(0.0, 100.0, 0.0), centre, Projection::Orthographic, height);
}

TEST(ReferenceClipping, ASlabIsAsOpaqueAsItIsThick) {
  const double extinction = 0.05;
  Scene scene = slab(extinction);
  const Camera camera = parallelTo(scene.volume->grid);
  const auto opacity = [&] { return picture(scene, camera, {5, 5}).final[12].a; };
  EXPECT_NEAR(opacity(), -std::expm1(-extinction * 40.0), 1e-6);
  for (const double thickness : {0.1, 1.0, 7.3, 25.0}) {
    scene.look.clipping = {};
    scene.look.clipping.cropped = true;
    scene.look.clipping.box = {{-10.0, 11.2, -10.0}, {60.0, 11.2 + thickness, 60.0}};
    EXPECT_NEAR(opacity(), -std::expm1(-extinction * thickness), 1e-6) << "box of " << thickness;
    scene.look.clipping = {};
    scene.look.clipping.planes = {{{0.0, 1.0, 0.0}, 11.2}, {{0.0, -1.0, 0.0}, -11.2 - thickness}};
    EXPECT_NEAR(opacity(), -std::expm1(-extinction * thickness), 1e-6) << "planes " << thickness << " apart";
  }
  // Askew, a ray runs through more of it.
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, 1.0, -0.2));
  const double middle = glm::dot(normal, scene.volume->grid.centre());
  scene.look.clipping.planes = {{normal, middle - 3.0}, {-normal, -middle - 3.0}};
  EXPECT_NEAR(opacity(), -std::expm1(-extinction * 6.0 / normal.y), 1e-6);
}

TEST(ReferenceClipping, AStepOfAVoxelTheVolumesOrNoneMakeNoDifference) {
  Scene scene = slab(0.05);
  const Camera camera = Camera::fromAngles(30.0, 20.0, scene.volume->grid);
  const auto whole = picture(scene, camera, {16, 12}).final;
  const CropFrame frame(scene.volume->grid);
  scene.look.clipping.cropped = true;
  scene.look.clipping.box = {frame.low, frame.high};
  EXPECT_EQ(picture(scene, camera, {16, 12}).final, whole);
  scene.look.clipping = {};
  scene.look.clipping.planes = {{{0.0, 0.0, 1.0}, -1e3}};
  EXPECT_EQ(picture(scene, camera, {16, 12}).final, whole) << "a plane beyond the volume";
}

TEST(ReferenceClipping, ABallIsMetWhereThePlaneCutsIt) {
  // The field is linear along y and z at the axis; hits on the cap are the plane's, to rounding.
  const Grid grid = gridOf({48, 48, 48});
  const double radius = 14.0;
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3 i) { return radius - glm::length(glm::dvec3(i) - 23.5); });
  scene.look.context.function = opaqueFrom(0.0);
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    Camera camera = Camera::fromAngles(25.0, 15.0, grid, projection);
    const glm::ivec2 size(40, 40);
    const HitPoints whole = hitPoints(scene, camera, size);
    Scene cut = scene;
    const HalfSpace plane{glm::normalize(glm::dvec3(0.2, 1.0, 0.3)), 23.0};
    cut.look.clipping.planes = {plane};
    const HitPoints hits = hitPoints(cut, camera, size);
    int onCap = 0, onBall = 0;
    for (std::size_t i = 0; i < hits.tContext.size(); ++i) {
      const Ray ray = pixelRay(camera, size, {static_cast<int>(i) % size.x, static_cast<int>(i) / size.x});
      const double tPlane = -plane.distance(ray.origin) / glm::dot(ray.direction, plane.normal);
      const double fromCentre = glm::length(ray.origin + tPlane * ray.direction - 23.5);
      if (fromCentre < radius - 0.2) {
        ++onCap;
        EXPECT_NEAR(hits.tContext[i], tPlane, 1e-9);
      } else if (fromCentre > radius + 0.2) {
        // The plane passes the ball by: in front of it, or behind where the ray meets it.
        const bool before = !(whole.tContext[i] < tPlane);
        if (before && !std::isnan(whole.tContext[i])) ++onBall;
        EXPECT_EQ(std::isnan(hits.tContext[i]), std::isnan(whole.tContext[i]) || !before);
        if (!std::isnan(hits.tContext[i])) {
          EXPECT_NEAR(hits.tContext[i], whole.tContext[i], 1e-9);
        }
      }
    }
    EXPECT_GT(onCap, 40);
    EXPECT_GT(onBall, 20);
  }
}

TEST(ReferenceClipping, HardCases) {
  Scene scene = slab(0.3);
  const Grid& grid = scene.volume->grid;
  const Camera camera = parallelTo(grid);
  const glm::dvec3 centre = grid.centre();
  const auto opacity = [&](const Camera& from) { return picture(scene, from, {5, 5}).final[12].a; };
  Clipping& clipping = scene.look.clipping;
  clipping.planes = {{{1.0, 0.0, 0.0}, centre.x - 1.0}};
  EXPECT_NEAR(opacity(camera), -std::expm1(-0.3 * 40.0), 1e-6) << "the ray runs along the plane, before it";
  clipping.planes = {{{1.0, 0.0, 0.0}, centre.x + 1.0}};
  EXPECT_EQ(opacity(camera), 0.0) << "and behind it";
  clipping.planes = {{{0.0, 1.0, 0.0}, 7.5}};
  EXPECT_NEAR(opacity(camera), -std::expm1(-0.3 * 32.0), 1e-6) << "on the face between two voxels";
  clipping.planes = {{{0.0, 1.0, 0.0}, 30.0}, {{0.0, -1.0, 0.0}, -10.0}};
  EXPECT_EQ(opacity(camera), 0.0) << "planes that keep nothing";
  clipping = {};
  clipping.cropped = true;
  clipping.box = {{19.0, 12.5, 19.0}, {20.0, 13.5, 20.0}};
  EXPECT_NEAR(opacity(camera), -std::expm1(-0.3), 1e-6) << "a box of one voxel";
  clipping.box = {{20.0, 0.0, 0.0}, {10.0, 40.0, 40.0}};
  EXPECT_EQ(opacity(camera), 0.0) << "a box turned inside out";
  clipping.box = {{10.0, 10.0, 10.0}, {30.0, 30.0, 30.0}};
  EXPECT_NEAR(opacity(lookAt(centre, centre + glm::dvec3(0.0, 1.0, 0.0))), -std::expm1(-0.3 * 10.5), 1e-6)
      << "an eye inside the box sees to its face, from where it is";
}

TEST(ReferenceClipping, ACappedFaceHasItsOwnLight) {
  // Homogeneous tissue has no gradient: only the face makes the light differ from that of an average surface.
  Scene scene = slab(50.0);
  scene.look.shading = {.specular = 0.0};
  const Camera camera = parallelTo(scene.volume->grid);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -1.0, 0.5));
  scene.look.clipping.planes = {{-normal, -glm::dot(normal, scene.volume->grid.centre())}};
  const glm::dvec4 seen = picture(scene, camera, {5, 5}).final[12];
  const Shading& light = scene.look.shading;
  const auto incident = [&](double cosine) { return light.ambient + light.diffuse * cosine; };
  // Lighting.h: 0.75 of it at the face; light is absorbed within 1/50 mm, over which that share hardly falls.
  const double own = incident(std::abs(glm::dot(normal, lightDirection(camera.axes(), light))));
  EXPECT_NEAR(seen.r / seen.a, 0.8 * glm::mix(incident(0.7), own, 0.75), 0.01);
  EXPECT_GT(std::abs(own - incident(0.7)), 0.05) << "too little to tell";
}

TEST(ReferenceClipping, GreyFacesShowTheValuesAsSlicesDo) {
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(gridOf({40, 40, 40}), [](glm::ivec3 i) { return 10 * i.x; });
  scene.look.context.function = opaqueFrom(1e6);  // the transfer function shows nothing
  scene.look.clipping.planes = {{{0.0, 1.0, 0.0}, 11.3}};
  scene.look.clipping.grey = WindowLevel{200.0, 195.0};
  const Camera camera = parallelTo(scene.volume->grid, 40.0);
  const glm::ivec2 size(40, 40);
  const auto colours = picture(scene, camera, size).final;
  const HitPoints hits = hitPoints(scene, camera, size);
  for (int x = 1; x < 39; ++x) {
    const std::size_t at = static_cast<std::size_t>(20 * 40 + x);
    const double value = 10.0 * (camera.eye + (x + 0.5 - 20.0) * camera.axes().right).x;
    const double grey = std::clamp((value - 95.0) / 200.0, 0.0, 1.0);
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(colours[at][channel], grey, 1e-9);
    EXPECT_EQ(colours[at].a, 1.0);
    EXPECT_NEAR(hits.tContext[at], 11.3 - camera.eye.y, 1e-9);
  }
}

TEST(ReferenceClipping, GreyFacesOfSplinesShowTheSplinesValues) {
  // A parabola, which the cubic spline through its values is; straight lines between them lie up to 1/8 above it.
  Scene scene;
  scene.volume = volumeOf<float>(gridOf({40, 40, 40}), [](glm::ivec3 i) { return 0.5f * i.x * i.x; });
  scene.look.context.function = opaqueFrom(1e6);  // the transfer function shows nothing
  scene.look.reconstruction = Reconstruction::Cubic;
  scene.look.clipping.planes = {{{0.0, 1.0, 0.0}, 11.3}};
  scene.look.clipping.grey = WindowLevel{800.0, 400.0};
  const double height = 30.0;
  const Camera camera = parallelTo(scene.volume->grid, height);
  const glm::ivec2 size(40, 40);
  const auto colours = picture(scene, camera, size).final;
  for (int x = 0; x < size.x; ++x) {
    const double at = (camera.eye + height / size.y * (x + 0.5 - 20.0) * camera.axes().right).x;
    const glm::dvec4 colour = colours[static_cast<std::size_t>(20 * 40 + x)];
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(colour[channel], 0.5 * at * at / 800.0, 1e-9);
    EXPECT_EQ(colour.a, 1.0);
  }
}

}  // namespace
}  // namespace fenestra::reference::referenceClippingTest
