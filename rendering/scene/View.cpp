#include "rendering/scene/View.h"

#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace fenestra {
namespace {

/// Turned about a point so that its eye moves by `offset` degrees towards `direction`, 0 the picture's right, 90 its
/// top.
Camera turned(Camera camera, glm::dvec3 about, double offset, double direction) {
  const Camera::Axes axes = camera.axes();
  const double angle = glm::radians(direction);
  const glm::dvec3 towards = std::cos(angle) * axes.right + std::sin(angle) * axes.up;
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), glm::radians(offset), glm::cross(-axes.forward, towards)));
  camera.eye = about + turn * (camera.eye - about);
  camera.target = about + turn * (camera.target - about);
  camera.up = turn * axes.up;
  return camera;
}

}  // namespace

glm::dvec3 placeOf(const MethodStages::Lens& lens, const ShownSlices& slices, glm::dvec3 focusCentre) {
  return lens.place == LensPlace::OverCrosshair ? slices.crosshair.value_or(focusCentre) : focusCentre;
}

std::optional<double> errorBound(const View& view) {
  if (view.maxError) return view.maxError;
  return view.quality == Quality::High ? std::optional(highQualityError) : std::nullopt;
}

std::optional<OpeningView> openingOf(const View& view, const Cutaway& cutaway, glm::dvec3 focusCentre) {
  if (!view.frozen && cutaway.axisOffset == 0.0) return {};
  OpeningView opening = view.frozen.value_or(OpeningView{view.camera, view.size, view.pixelScale});
  if (cutaway.axisOffset != 0.0)
    opening.camera = turned(opening.camera, focusCentre, cutaway.axisOffset, cutaway.axisDirection);
  return opening;
}

}  // namespace fenestra
