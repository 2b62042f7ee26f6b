#include "viewer/views/PictureMaker.h"

#include <algorithm>
#include <stdexcept>

#include <QPainter>

#include "rendering/Renderer.h"
#include "rendering/gpu/GpuScene.h"
#include "viewer/style/Overlay.h"
#include "viewer/views/FidelityChip.h"
#include "viewer/views/RenderProblem.h"
#include "viewer/views/SliceView.h"
#include "viewer/views/ViewArea.h"
#include "viewer/views/VolumeView.h"

namespace fenestra::viewer {
namespace {

constexpr double pictureSliceMilliseconds = 20.0;  ///< of drawing before the window handles events again

}  // namespace

PictureMaker::PictureMaker(ViewArea& views, QObject* parent) : QObject(parent), views_(views) {
  connect(&timer_, &QTimer::timeout, this, [this] {
    try {
      advance();
    } catch (const std::exception& error) {
      cancel();
      Q_EMIT failed(describeRenderProblem(error));
    }
  });
}

PictureMaker::~PictureMaker() { cancel(); }

QRect PictureMaker::areaOf(const Request& request) const {
  QRect area;
  const auto add = [&](const QWidget* view) { area |= QRect(view->mapTo(&views_, QPoint(0, 0)), view->size()); };
  for (const VolumeView* view : request.volumes) add(view);
  for (const SliceView* view : request.slices) add(view);
  return area;
}

QSize PictureMaker::sizeOf(const Request& request) const { return areaOf(request).size(); }

QRectF PictureMaker::placeOf(const QWidget& view) const {
  return {view.mapTo(&views_, QPoint(0, 0)) - areaOf(request_).topLeft(), view.size()};
}

void PictureMaker::start(const Request& request) {
  cancel();
  request_ = request;
  const QSize size = (QSizeF(sizeOf(request)) * request.scale).toSize();
  picture_ = QImage(size, QImage::Format_RGB32);
  if (picture_.isNull()) {
    Q_EMIT failed(tr("There is no memory for a picture of %1 × %2 pixels.").arg(size.width()).arg(size.height()));
    return;
  }
  picture_.fill(Qt::black);
  fidelity_.clear();
  next_ = 0;
  timer_.start(0);
}

void PictureMaker::cancel() {
  timer_.stop();
  if (renderer_ && next_ < request_.volumes.size())
    request_.volumes[next_]->inGlContext([this](const auto&) { renderer_.reset(); });
  renderer_.reset();
}

void PictureMaker::begin(VolumeView& view) {
  view_ = view.restView();
  view_.camera = view_.camera.orbited(request_.turn, 0.0);
  const QSizeF size = placeOf(view).size() * request_.scale;
  view_.size = glm::max(glm::ivec2(glm::round(glm::dvec2(size.width(), size.height()))), glm::ivec2(1));
  view_.pixelScale = request_.scale;
}

void PictureMaker::advance() {
  if (next_ < request_.volumes.size()) {
    VolumeView& view = *request_.volumes[next_];
    std::vector<std::uint8_t> pixels;
    const bool ran = view.inGlContext([&](const std::shared_ptr<GpuScene>& gpuScene) {
      if (!renderer_) {
        renderer_ = std::make_unique<Renderer>(gpuScene);
        begin(view);
        renderer_->begin(view.shownScene(), view_);
      }
      if (!renderer_->advance(pictureSliceMilliseconds)) return;
      pixels = renderer_->readPicture();
      renderer_.reset();
    });
    if (!ran) throw std::runtime_error("the 3-D views are not on screen");
    if (pixels.empty()) return;
    paint(view, pixels, {view_.size.x, view_.size.y});
    ++next_;
    return;
  }
  for (SliceView* view : request_.slices) {
    QPainter painter(&picture_);
    const QRectF place = placeOf(*view);
    painter.scale(request_.scale, request_.scale);
    painter.translate(place.topLeft());
    painter.setClipRect(QRectF(QPointF(0, 0), place.size()));
    view->draw(painter, request_.marks);
    const std::vector<FidelityCause> causes = view->fidelity();
    note(view->name(), causes);
    if (request_.marks && request_.causes && view->showsText())
      writeFidelity(painter, QRectF(QPointF(0, 0), place.size()), causes);
  }
  timer_.stop();
  Q_EMIT made(picture_);
}

void PictureMaker::paint(VolumeView& view, const std::vector<std::uint8_t>& pixels, QSize size) {
  QPainter painter(&picture_);
  const QRectF place = placeOf(view);
  painter.fillRect(QRectF(place.topLeft() * request_.scale, size), toColour(view.shownScene().look.background));
  painter.drawImage((place.topLeft() * request_.scale).toPoint(),
                    QImage(pixels.data(), size.width(), size.height(), QImage::Format_RGBA8888_Premultiplied));
  const std::vector<FidelityCause> causes = view.fidelityAtRest();
  note(tr("C%1").arg(view.index() + 1), causes);
  if (!request_.marks) return;
  painter.scale(request_.scale, request_.scale);
  painter.translate(place.topLeft());
  painter.setClipRect(QRectF(QPointF(0, 0), place.size()));
  view.drawMarks(painter, view_.camera, causes);
  if (request_.causes && view.showsText()) writeFidelity(painter, QRectF(QPointF(0, 0), place.size()), causes);
}

void PictureMaker::note(const QString& view, const std::vector<FidelityCause>& causes) {
  fidelity_ << view + QStringLiteral(": ") + linesOf(causes).join(QStringLiteral("; "));
}

}  // namespace fenestra::viewer
