#include "io/session/Session.h"

namespace fenestra::io {

Camera shownCamera(const SessionView& view, glm::ivec2 size) {
  return view.fitsWidth ? view.camera.fittedTo(static_cast<double>(size.x) / size.y) : view.camera;
}

}  // namespace fenestra::io
