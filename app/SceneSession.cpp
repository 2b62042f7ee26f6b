#include "app/SceneSession.h"

#include "io/TransferFunctionFile.h"
#include "io/session/OpenSession.h"

namespace fenestra::app {

void useAsDefaults(const io::Session& session, SceneOptions& options) {
  options.cutaway = session.cutaway;
  options.contextLayer = session.contextLayer;
  options.shading = session.shading;
  options.quality = session.quality;
  options.maxError = session.maxError;
  options.background = session.background;
}

io::Session sessionOf(const SceneOptions& options, const LoadedScene& loaded) {
  io::Session session;
  if (loaded.session) {
    session = *loaded.session;
  } else {
    if (options.phantom.empty())
      session.volume = io::sessionVolume(options.path, loaded.volume, options.raw);
    else
      session.phantom = {options.phantom, options.phantomVoxels};
    session.views[1].camera = loaded.view.camera.beside();
  }
  if (!options.labels.empty()) session.labels = io::sessionLabels(options.labels);
  const Scene& scene = loaded.scene;
  session.focus = scene.look.focus;
  session.focusAppearance = scene.look.focusAppearance;
  if (!loaded.session || !options.transferFunction.empty()) session.context = scene.look.context;
  session.strokes = scene.look.strokes;
  session.cutaway = scene.look.cutaway;
  session.contextLayer = scene.look.contextLayer;
  session.shading = scene.look.shading;
  session.background = scene.look.background;
  session.quality = loaded.view.quality;
  session.maxError = loaded.view.maxError;

  io::SessionView& view = session.views[static_cast<std::size_t>(options.viewOfSession)];
  if (loaded.view.camera != io::shownCamera(view, loaded.view.size))
    view = {.camera = loaded.view.camera, .fitsWidth = false};
  view.size = loaded.view.size;
  view.pixelScale = loaded.view.pixelScale;
  if (!loaded.session) session.home = {session.views[0].camera, session.views[1].camera};
  return session;
}

}  // namespace fenestra::app
