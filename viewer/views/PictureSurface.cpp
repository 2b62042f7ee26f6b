#include "viewer/views/PictureSurface.h"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <QOpenGLWidget>
#include <QPainter>

#include "rendering/Renderer.h"

namespace fenestra::viewer {
namespace {

glm::ivec2 devicePixels(const QWidget& widget) {
  const double ratio = widget.devicePixelRatioF();
  return glm::max(glm::ivec2(std::lround(widget.width() * ratio), std::lround(widget.height() * ratio)), glm::ivec2(1));
}

/// Device pixels that a picture covers, from the top left of a surface of `size`.
glm::ivec2 coveredBy(const Renderer& picture, glm::ivec2 size) {
  const glm::ivec2 half = coveredAtHalf(size);
  return picture.pictureSize() == half / 2 ? half : size;
}

class OpenGlSurface : public QOpenGLWidget, public PictureSurface {
 public:
  OpenGlSurface(QWidget& view, Calls calls) : QOpenGLWidget(&view), calls_(std::move(calls)) {
    connect(this, &QOpenGLWidget::frameSwapped, this, calls_.shown);
  }

  QWidget& widget() override { return *this; }
  void take(Renderer&) override {}  // its texture is shared
  void show(Renderer& picture) override {
    const glm::ivec2 size = devicePixels(*this);
    const glm::ivec2 covered = coveredBy(picture, size);
    picture.present(defaultFramebufferObject(), {0, size.y - covered.y, covered.x, covered.y});
  }
  QImage grab() override { return grabFramebuffer(); }

 protected:
  void paintGL() override { calls_.paint(); }

 private:
  Calls calls_;
};

class RasterSurface : public QWidget, public PictureSurface {
 public:
  RasterSurface(QWidget& view, Calls calls) : QWidget(&view), calls_(std::move(calls)) {}

  QWidget& widget() override { return *this; }
  void take(Renderer& picture) override {
    const glm::ivec2 size = devicePixels(*this);
    const glm::ivec2 covered = coveredBy(picture, size);
    std::vector<std::uint8_t> pixels = picture.readPresented(covered);
    if (pixels.empty()) return;
    pixels_ = std::move(pixels);
    image_ = QImage(pixels_.data(), size.x, size.y, 4 * covered.x, QImage::Format_RGB32);
  }
  void show(Renderer&) override {
    QPainter painter(this);
    // After a resize the last picture is stretched, until one of the new size is drawn.
    const glm::ivec2 size = devicePixels(*this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform, image_.size() != QSize(size.x, size.y));
    painter.drawImage(rect(), image_);
  }
  void tellShown() override {
    if (std::exchange(isPainted_, false)) calls_.shown();
  }
  QImage grab() override {
    isGrabbing_ = true;
    QImage image = QWidget::grab().toImage();
    isGrabbing_ = false;
    return image;
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    calls_.paint();
    // The window brings the painted picture onto the screen before it handles another event.
    if (isGrabbing_) return;
    isPainted_ = true;
    QMetaObject::invokeMethod(
        this, [this] { tellShown(); }, Qt::QueuedConnection);
  }

 private:
  Calls calls_;
  std::vector<std::uint8_t> pixels_;
  QImage image_;  ///< shows pixels_ without a copy
  bool isGrabbing_ = false;
  bool isPainted_ = false;  ///< and Calls::shown has not been called
};

}  // namespace

PictureSurface* PictureSurface::make(bool software, QWidget& view, Calls calls) {
  PictureSurface* surface = software ? static_cast<PictureSurface*>(new RasterSurface(view, std::move(calls)))
                                     : new OpenGlSurface(view, std::move(calls));
  surface->widget().setAttribute(Qt::WA_TransparentForMouseEvents);
  surface->widget().setGeometry(view.rect());
  return surface;
}

}  // namespace fenestra::viewer
