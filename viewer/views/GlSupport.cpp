#include "viewer/views/GlSupport.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

#include "rendering/gl/Context.h"

namespace fenestra::viewer {
namespace {

constexpr int major = 4, minor = 5;

struct GlSupportWords {
  Q_DECLARE_TR_FUNCTIONS(GlSupport)
};

GlSupport unavailable(const QString& problem, const QString& renderer = {}) {
  return {.renderer = renderer, .problem = problem};
}

}  // namespace

void requestOpenGl() {
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setVersion(major, minor);
  format.setDepthBufferSize(0);
  format.setStencilBufferSize(8);  // QPainter clips with it
  QSurfaceFormat::setDefaultFormat(format);
}

GlSupport probeOpenGl() {
  // Qt's offscreen platform makes contexts where there is an X server, but crashes when it shows their widgets.
  if (QGuiApplication::platformName() == QLatin1String("offscreen"))
    return unavailable(GlSupportWords::tr("Qt's offscreen platform has no OpenGL; unset QT_QPA_PLATFORM."));
  QOpenGLContext context;
  if (!context.create())
    return unavailable(
        GlSupportWords::tr("No OpenGL context can be made on this display. Install the graphics driver, or Mesa's "
                           "software renderer (Debian: libgl1-mesa-dri); on a remote desktop, start Fenestra there."));
  QOffscreenSurface surface;
  surface.create();
  if (!context.makeCurrent(&surface))
    return unavailable(
        GlSupportWords::tr("OpenGL cannot draw on this display. On a remote desktop, use one with GLX."));

  const QString renderer = QString::fromStdString(gl::description());
  const QString reason = QString::fromStdString(gl::unsupportedReason());
  const bool software = gl::isSoftwareRasteriser();
  context.doneCurrent();
  if (!reason.isEmpty())
    return unavailable(GlSupportWords::tr("%1 (LIBGL_ALWAYS_SOFTWARE=1 in the environment selects it).").arg(reason),
                       renderer);
  return {.available = true, .software = software, .renderer = renderer};
}

}  // namespace fenestra::viewer
