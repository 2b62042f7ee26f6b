#pragma once
// The widget in a 3-D view that its picture is painted in.
//
// With a graphics card it is a QOpenGLWidget, and the picture never leaves the card. Where the CPU draws, the picture
// is read back and painted like any other widget, so that only the pictures' own context calls OpenGL, one thread at a
// time. That is for two reasons. A window that holds an OpenGL widget is put together by OpenGL whenever anything in it
// changes, which takes the CPU as long as a moving picture. And Mesa's llvmpipe, up to 22.3 at least, looks through the
// lists of all contexts while another thread changes its own (lp_setup_is_resource_referenced; later versions lock
// them): uploading voxels on one thread while another puts the window together can end the program.

#include <functional>

#include <glm/glm.hpp>

#include <QImage>

class QWidget;

namespace fenestra {
class Renderer;
}

namespace fenestra::viewer {

/// Device pixels that a picture of half the resolution covers on a surface of `size`: an even number of both, so that
/// each rendered pixel is exactly two shown ones wide.
inline glm::ivec2 coveredAtHalf(glm::ivec2 size) { return 2 * ((size + 1) / 2); }

class PictureSurface {
 public:
  struct Calls {
    std::function<void()> paint;  ///< paints the widget: calls show(), and a QPainter of widget() draws over that
    std::function<void()> shown;  ///< the painted picture is on the screen
  };
  /// Fills `view` and leaves the mouse to it; belongs to it. `software`: the CPU draws.
  static PictureSurface* make(bool software, QWidget& view, Calls calls);
  virtual ~PictureSurface() = default;

  virtual QWidget& widget() = 0;
  /// A picture to be shown from now on: stretched over the surface, or one of coveredAtHalf(), whose last row and
  /// column may lie outside. Needs the context of the pictures.
  virtual void take(Renderer& picture) = 0;
  /// Puts the picture that was taken last, of this renderer, into the widget. Only while it is painted.
  virtual void show(Renderer& picture) = 0;
  /// Calls Calls::shown at once where a painted picture is on the screen and the call waits behind other events.
  virtual void tellShown() {}
  /// The widget as it looks on the screen, in device pixels.
  virtual QImage grab() = 0;
};

}  // namespace fenestra::viewer
