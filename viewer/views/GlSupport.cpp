#include "viewer/views/GlSupport.h"

#include <QCoreApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

namespace fenestra::viewer {
namespace {

constexpr int major = 4, minor = 5;

QString tr(const char* text) { return QCoreApplication::translate("GlSupport", text); }

GlSupport unavailable(const QString& problem, const QString& renderer = {}) {
  return {.available = false, .software = false, .renderer = renderer, .problem = problem};
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
  QOpenGLContext context;
  if (!context.create())
    return unavailable(tr("No OpenGL context can be made on this display. Install the graphics driver, or Mesa's "
                          "software renderer (Debian: libgl1-mesa-dri); on a remote desktop, start Fenestra there."));
  QOffscreenSurface surface;
  surface.create();
  if (!context.makeCurrent(&surface))
    return unavailable(tr("OpenGL cannot draw on this display. On a remote desktop, use one with GLX."));

  QOpenGLFunctions* functions = context.functions();
  const auto string = [&](GLenum name) {
    const auto* text = reinterpret_cast<const char*>(functions->glGetString(name));
    return QString::fromUtf8(text ? text : "");
  };
  const QString renderer = string(GL_RENDERER), version = string(GL_VERSION);
  context.doneCurrent();

  const QSurfaceFormat got = context.format();
  if (context.isOpenGLES() || got.version() < qMakePair(major, minor))
    return unavailable(tr("The 3-D views need OpenGL 4.5; this display gives “%1” on %2. A newer graphics driver helps, "
                          "or Mesa's software renderer: start Fenestra with LIBGL_ALWAYS_SOFTWARE=1.")
                           .arg(version, renderer),
                       renderer);
  GlSupport support{.available = true, .software = false, .renderer = renderer, .problem = {}};
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR"})
    if (renderer.contains(QLatin1String(name), Qt::CaseInsensitive)) support.software = true;
  return support;
}

}  // namespace fenestra::viewer
