#include "viewer/views/RenderProblem.h"

#include <new>

#include <QCoreApplication>

#include "rendering/gl/ShaderProgram.h"

namespace fenestra::viewer {
namespace {

struct RenderProblemWords {
  Q_DECLARE_TR_FUNCTIONS(RenderProblem)
};

}  // namespace

QString describeRenderProblem(const std::exception& error) {
  const QString what = QString::fromUtf8(error.what());
  if (dynamic_cast<const gl::ShaderError*>(&error))
    return RenderProblemWords::tr(
               "The graphics driver refuses a part of Fenestra (%1). Update the driver, or start Fenestra with "
               "LIBGL_ALWAYS_SOFTWARE=1 in the environment.")
        .arg(what.section(QLatin1Char('\n'), 0, 0).section(QLatin1Char(';'), 0, 0));
  if (dynamic_cast<const std::bad_alloc*>(&error))
    return RenderProblemWords::tr(
        "There is not enough memory for this picture. Close other programs, or open a smaller volume.");
  return what;
}

}  // namespace fenestra::viewer
