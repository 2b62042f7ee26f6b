// The light's direction: as it was before it could be turned, and around the viewer by its angles.

#include <gtest/gtest.h>

#include "rendering/scene/Lighting.h"

namespace fenestra::tests {
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

}  // namespace
}  // namespace fenestra::tests
