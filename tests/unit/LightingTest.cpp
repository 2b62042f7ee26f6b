// The light's direction: as it was before it could be turned, and around the viewer by its angles. Ready-made light.
// The background, which it does not fall on.

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "rendering/scene/Lighting.h"

namespace fenestra::tests::lightingTest {
namespace {

void expectNear(glm::dvec3 is, glm::dvec3 wanted) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(is[axis], wanted[axis], 1e-15) << axis;
}

Shading litFrom(double azimuth, double elevation) {
  Shading shading;
  shading.lightAzimuth = azimuth;
  shading.lightElevation = elevation;
  return shading;
}

TEST(LightDirection, OfTheDefaultIsUpperLeftBehindTheViewer) {
  Camera camera;
  camera.eye = {3.0, -200.0, 40.0};
  camera.up = {0.1, 0.2, 1.0};
  const Camera::Axes axes = camera.axes();
  expectNear(lightDirection(axes, {}), glm::normalize(-axes.forward + 0.45 * axes.up - 0.35 * axes.right));
}

TEST(LightDirection, TurnsWithTheCamera) {
  const Camera::Axes axes = Camera{}.axes();
  expectNear(lightDirection(axes, litFrom(0.0, 0.0)), -axes.forward);
  expectNear(lightDirection(axes, litFrom(90.0, 0.0)), axes.right);
  expectNear(lightDirection(axes, litFrom(-90.0, 0.0)), -axes.right);
  expectNear(lightDirection(axes, litFrom(180.0, 0.0)), axes.forward);
  expectNear(lightDirection(axes, litFrom(37.0, 90.0)), axes.up);
}

TEST(LightPresets, DifferAndLeaveTheDirection) {
  Shading own = litFrom(12.0, -34.0);
  own.enabled = false;
  std::set<std::string_view> ids;
  std::vector<Shading> made;
  for (const LightPreset& preset : lightPresets()) {
    EXPECT_TRUE(ids.insert(preset.id).second) << preset.id;
    Shading shading = own;
    preset.applyTo(shading);
    EXPECT_EQ(shading.lightAzimuth, 12.0);
    EXPECT_EQ(shading.lightElevation, -34.0);
    EXPECT_TRUE(shading.enabled);
    for (const Shading& other : made) EXPECT_NE(shading, other) << preset.id;
    made.push_back(shading);
  }
  for (const char* id : {"standard", "matte", "bone", "wet", "technical"}) EXPECT_EQ(ids.count(id), 1u) << id;
}

TEST(LightPresets, TheFirstIsTheDefault) {
  Shading shading{.enabled = true, .ambient = 1.0, .diffuse = 2.0, .specular = 3.0, .shininess = 4.0};
  lightPresets().front().applyTo(shading);
  EXPECT_EQ(shading, Shading());
}

TEST(Background, OfAGradientRunsFromTheBottomToTheTop) {
  Look look;
  look.background = {0.1, 0.2, 0.3};
  look.backgroundTop = {0.5, 0.1, 0.9};
  for (const double height : {0.0, 0.25, 1.0}) expectNear(backgroundAt(look, height), look.background);
  look.backdrop = Backdrop::Gradient;
  expectNear(backgroundAt(look, 0.0), look.background);
  expectNear(backgroundAt(look, 1.0), look.backgroundTop);
  expectNear(backgroundAt(look, 0.25), {0.2, 0.175, 0.45});
}

}  // namespace
}  // namespace fenestra::tests::lightingTest
