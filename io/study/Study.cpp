#include "io/study/Study.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "rendering/scene/VisibleFraming.h"
#include "rendering/settings/FlatStack.h"

namespace fenestra::io {

const Framing& visibleOf(Study& study) {
  const Scene& scene = study.drawn.scene();
  if (!study.visible) study.visible = visibleFraming(shownVolume(scene), scene.look.context.shifted());
  return *study.visible;
}

void takeVolume(OpenedVolume opened, Study& study) {
  study.scene.volume = std::move(opened.volume);
  std::move(opened.warnings.begin(), opened.warnings.end(), std::back_inserter(study.warnings));
  static_cast<VolumeInfo&>(study) = std::move(opened);
}

Session sessionOf(const Study& study) {
  Session session = study.session;
  session.look = study.scene.look;
  if (!study.view) return session;
  const View& shown = *study.view;
  session.quality = shown.quality;
  session.maxError = shown.maxError;
  session.crosshair = shown.slices.crosshair;
  session.window = shown.slices.window;
  session.inverted = shown.slices.inverted;
  if (!study.restoresSession) session.views[1].camera = secondCamera(shown.camera, study.scene.volume->grid);
  SessionView& view = session.views[static_cast<std::size_t>(study.viewIndex)];
  if (shown.camera != shownCamera(view, shown.size)) view = {.camera = shown.camera, .fitsWidth = false};
  view.size = shown.size;
  view.pixelScale = shown.pixelScale;
  view.frozen = shown.frozen;
  if (!study.restoresSession) session.home = {session.views[0].camera, session.views[1].camera};
  return session;
}

}  // namespace fenestra::io
