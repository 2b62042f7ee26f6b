#include "app/SceneSession.h"

#include "io/session/OpenSession.h"

namespace fenestra::app {

void useAsDefaults(const io::Session& session, SceneOptions& options) {
  options.look = session.look;
  options.quality = session.quality;
  options.maxError = session.maxError;
  options.slices = {session.crosshair, session.window, session.inverted};
}

io::Session sessionOf(const SceneOptions& options, const LoadedScene& loaded) {
  io::Session session;
  if (loaded.session) {
    session = *loaded.session;
  } else {
    if (options.phantom.empty())
      session.volume =
          io::sessionVolume(options.path, loaded.volume,
                            {.raw = options.raw, .regularise = options.regularise.value_or(io::Regularise::Automatic)});
    else
      session.phantom = {options.phantom, options.phantomVoxels};
    session.views[1].camera = loaded.view.camera.beside();
  }
  if (!options.labels.empty()) session.labels = io::sessionLabels(options.labels);
  session.look = loaded.asSet.look;
  session.quality = loaded.view.quality;
  session.maxError = loaded.view.maxError;
  session.crosshair = loaded.view.slices.crosshair;
  session.window = loaded.view.slices.window;
  session.inverted = loaded.view.slices.inverted;

  io::SessionView& view = session.views[static_cast<std::size_t>(options.viewOfSession)];
  if (loaded.view.camera != io::shownCamera(view, loaded.view.size))
    view = {.camera = loaded.view.camera, .fitsWidth = false};
  view.size = loaded.view.size;
  view.pixelScale = loaded.view.pixelScale;
  view.frozen = loaded.view.frozen;
  if (!loaded.session) session.home = {session.views[0].camera, session.views[1].camera};
  return session;
}

}  // namespace fenestra::app
