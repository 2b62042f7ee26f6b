#pragma once
// Whether this machine can draw the 3-D views. To be found out before a view is made: a window that holds an OpenGL
// widget without a context shows nothing at all, not even its slices.

#include <QString>

namespace fenestra::viewer {

struct GlSupport {
  bool available = false;
  bool software = false;  ///< the driver draws on the CPU
  QString renderer{};     ///< the driver's own name for itself
  QString problem{};      ///< what is wrong and what would help; empty when available
};

/// Asks Qt for OpenGL 4.5 core contexts that share objects. Call before the QApplication is made.
void requestOpenGl();
/// Tries a context. Needs the QApplication.
GlSupport probeOpenGl();

}  // namespace fenestra::viewer
