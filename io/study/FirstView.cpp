#include "io/study/FirstView.h"

#include "io/session/CameraFile.h"
#include "io/study/PhantomView.h"
#include "io/study/Study.h"
#include "io/study/StudyRequest.h"
#include "rendering/settings/FlatStack.h"

namespace fenestra::io {
namespace {

namespace fs = std::filesystem;

/// A camera that is not placed; with a size where a file names one.
CameraFile cameraOf(const CameraChoice& choice, const StudyRequest& request, Study& study) {
  if (const auto* file = std::get_if<fs::path>(&choice)) {
    CameraFile read = readCamera(*file);
    read.camera.projection = request.projection.value_or(read.camera.projection);
    return read;
  }
  const Framing& framing = visibleOf(study);
  const Projection projection = request.projection.value_or(Projection::Perspective);
  if (const auto* view = std::get_if<StandardView>(&choice))
    return {Camera::standard(*view, framing, projection), glm::ivec2(0)};
  const auto& angles = std::get<ViewAngles>(choice);
  return {Camera::fromAngles(angles.azimuth, angles.elevation, framing, projection), glm::ivec2(0)};
}

Camera unchosenCamera(const StudyRequest& request, Study& study) {
  return firstCamera(study.scene.volume->grid, visibleOf(study), request.projection.value_or(Projection::Perspective));
}

const SessionView* sessionView(const StudyRequest& request, const Study& study) {
  return study.restoresSession ? &study.session.views[static_cast<std::size_t>(request.viewIndex)] : nullptr;
}

/// Camera and size.
void setCamera(const StudyRequest& request, Study& study) {
  View& view = *study.view;
  const SessionView* saved = sessionView(request, study);
  if (saved) {
    view.size = saved->size;
    view.pixelScale = saved->pixelScale;
  }
  if (saved && !request.camera) {
    view.camera = saved->camera;
    view.camera.projection = request.projection.value_or(view.camera.projection);
    view.size = request.size.value_or(view.size);
    if (saved->fitsWidth) view.camera = view.camera.fittedTo(static_cast<double>(view.size.x) / view.size.y);
    return;
  }
  const bool plainPhantom = !request.phantom.empty() && request.focusLabels.empty() && !request.focusRange;
  std::optional<CameraChoice> choice = request.camera;
  if (!choice && plainPhantom) choice = phantomView(request.phantom).camera;
  if (const auto* placed = choice ? std::get_if<PlacedView>(&*choice) : nullptr) {
    study.placed = *placed;
    choice.reset();
  }
  const CameraFile chosen =
      choice ? cameraOf(*choice, request, study) : CameraFile{.camera = unchosenCamera(request, study)};
  view.camera = chosen.camera;
  if (chosen.size.x > 0) view.size = chosen.size;
  view.size = request.size.value_or(view.size);
}

/// The opening's own camera, from the request or else from the session's view.
void setFrozen(const StudyRequest& request, Study& study) {
  View& view = *study.view;
  if (const SessionView* saved = sessionView(request, study)) view.frozen = saved->frozen;
  if (!request.frozen) return;
  const CameraFile chosen = cameraOf(*request.frozen, request, study);
  view.frozen = OpeningView{chosen.camera, chosen.size.x > 0 ? chosen.size : view.size, view.pixelScale};
}

ShownSlices slicesOf(const StudyRequest& request, const Study& study) {
  const Volume& volume = *study.scene.volume;
  ShownSlices slices = request.slices;
  // Emission is read in black on white.
  if (!study.restoresSession && volume.modality == Modality::PT) slices.inverted = true;
  if (!request.windowWidth && !request.windowLevel) return slices;
  WindowLevel window = slices.window ? *slices.window : volume.defaultWindow();
  window.width = request.windowWidth.value_or(window.width);
  window.level = request.windowLevel.value_or(window.level);
  slices.window = window;
  return slices;
}

}  // namespace

void setFirstView(const StudyRequest& request, Study& study) {
  study.viewIndex = request.viewIndex;
  study.view = View{.camera = {}, .size = {960, 720}, .quality = request.quality, .maxError = request.maxError};
  setCamera(request, study);
  setFrozen(request, study);
  study.view->slices = slicesOf(request, study);
}

}  // namespace fenestra::io
