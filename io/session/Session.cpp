#include "io/session/Session.h"

#include <algorithm>
#include <utility>

#include "io/TransferFunctionFile.h"

namespace fenestra::io {

Scene sceneOf(const Session& session) {
  Scene scene;
  scene.look.context = session.context;
  scene.look.focus = session.focus;
  scene.look.focusAppearance = session.focusAppearance;
  scene.look.cutaway = session.cutaway;
  scene.look.contextLayer = session.contextLayer;
  scene.look.strokes = session.strokes;
  scene.look.shading = session.shading;
  scene.look.background = session.background;
  return scene;
}

ContextFunction sessionContext(const std::string& presetOrPath, TransferFunction function, double shift) {
  ContextFunction context;
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
