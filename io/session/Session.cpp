#include "io/session/Session.h"

#include <algorithm>
#include <utility>

#include "io/TransferFunctionFile.h"

namespace fenestra::io {

Scene sceneOf(const Session& session) {
  Scene scene;
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

SessionContext sessionContext(const std::string& presetOrPath, TransferFunction function, double shift) {
  SessionContext context;
  const std::vector<TransferFunctionPreset> presets = transferFunctionPresets();
  const bool builtIn = std::any_of(presets.begin(), presets.end(),
                                   [&](const TransferFunctionPreset& preset) { return preset.id == presetOrPath; });
  if (builtIn)
    context.preset = presetOrPath;
  else if (!presetOrPath.empty())
    context.file = std::filesystem::absolute(presetOrPath);
  context.function = std::move(function);
  context.shift = shift;
  return context;
}

Camera shownCamera(const SessionView& view, glm::ivec2 size) {
  return view.fitsWidth ? view.camera.fittedTo(static_cast<double>(size.x) / size.y) : view.camera;
}

}  // namespace fenestra::io
