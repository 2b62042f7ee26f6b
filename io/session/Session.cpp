#include "io/session/Session.h"

#include <utility>

namespace fenestra::io {

Scene sceneOf(const Session& session, std::shared_ptr<const Volume> volume, std::shared_ptr<const LabelMap> labels) {
  Scene scene;
  scene.volume = std::move(volume);
  scene.labels = std::move(labels);
  scene.context = session.context.function;
  for (TransferFunction::Node& node : scene.context.nodes) node.value += session.context.shift;
  scene.focus = session.focus;
  scene.focusAppearance = session.focusAppearance;
  scene.cutaway = session.cutaway;
  scene.contextLayer = session.contextLayer;
  scene.strokes = session.strokes;
  scene.shading = session.shading;
  scene.background = session.background;
  return scene;
}

Camera shownCamera(const SessionView& view, glm::ivec2 size) {
  return view.fitsWidth ? view.camera.fittedTo(static_cast<double>(size.x) / size.y) : view.camera;
}

}  // namespace fenestra::io
