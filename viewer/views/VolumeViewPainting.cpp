// How a 3-D view looks on the screen: its picture with the marks over it.

#include <utility>

#include <QMouseEvent>
#include <QPainter>

#include "viewer/model/Document.h"
#include "viewer/model/PatientLines.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/style/Overlay.h"
#include "viewer/views/FidelityChip.h"
#include "viewer/views/PictureSurface.h"
#include "viewer/views/RefinedPicture.h"
#include "viewer/views/RegionMark.h"
#include "viewer/views/VolumeView.h"

namespace fenestra::viewer {

void VolumeView::repaintSurface() { surface_->widget().update(); }

void VolumeView::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  repaintSurface();
}

void VolumeView::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  repaintSurface();
}

PictureState VolumeView::pictureState() const {
  PictureState state{.isCurrent = !lateness_.isLate(),
                     .isDraft = !settled_,
                     .reduction = reduction_.isEmpty() ? QString() : reduction_.left(1).toLower() + reduction_.mid(1),
                     .verified = verified_};
  const View shown = hasPicture() ? picture_->shownView() : restView();
  state.scale = shown.pixelScale / devicePixelRatioF();
  state.quality = shown.quality;
  state.maxError = shown.maxError;
  return state;
}

bool VolumeView::showsText() const { return options_.text(); }

std::vector<FidelityCause> VolumeView::fidelity() const {
  return fidelityOf(document_.study(), document_.scene(), pictureState());
}

std::vector<FidelityCause> VolumeView::fidelityAtRest() const {
  PictureState state = pictureState();
  const View rest = restView();
  state.isCurrent = true;
  state.isDraft = false;
  state.quality = rest.quality;
  state.maxError = rest.maxError;
  if (!settled_) state.verified.clear();
  return fidelityOf(document_.study(), document_.scene(), state);
}

void VolumeView::noteVerified(const QString& statement) {
  if (!settled_) return;
  verified_ = statement;
  repaintSurface();
}

void VolumeView::paint() {
  checkLate();  // a view that was hidden
  if (problem_.isEmpty() && document_.hasVolume()) attempt([this] { present(); });
  drawOverlay();
  if (isSettled()) Q_EMIT settled();
}

QImage VolumeView::grabSurface() { return surface_->grab(); }

void VolumeView::present() {
  // A view that was hidden asks for its turn here; one that skips a frame does not, while its new picture is painted.
  if (!isNew_ && (due_ != Due::Nothing || !picture_)) askToDraw();
  if (!picture_ || !picture_->isShown()) return;
  isTimed_ |= std::exchange(isNew_, false);
  isUnseen_ |= std::exchange(isUnpainted_, false);
  surface_->show(picture_->shown());
}

void VolumeView::drawOverlay() {
  QPainter painter(&surface_->widget());
  const QRectF view = rect();
  if (!problem_.isEmpty() || !document_.hasVolume() || !hasPicture())
    painter.fillRect(rect(), toColour(document_.scene().look.background));
  if (!problem_.isEmpty()) {
    painter.setPen(QColor(220, 222, 226));
    painter.drawText(view.adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, problem_);
    return;
  }
  if (!document_.hasVolume()) return;
  drawMarks(painter, shownCamera(), fidelity());
  // Not one of the marks, because saved pictures must not name the patient.
  if (options_.text() && !options_.hidesPatient())
    drawStudyText(painter, view, patientLines(document_.study().patient, document_.study().series), 0);
  if (!hasPicture()) {
    painter.setPen(overlayGrey);
    painter.drawText(view, Qt::AlignCenter, tr("The first 3-D picture of this study is being made…"));
  } else if (lateness_.isLate() || document_.asksToOpen()) {
    const QString region = regionMark(document_);
    viewer::drawWaiting(painter, view,
                        !region.isEmpty() ? region
                        : awaits_         ? tr("Editing the label; the one before still shows")
                                          : tr("Not yet as asked for: the picture is being prepared"));
  }
  tools_.draw(painter, view);
  drawWaiting(painter);
  // Filled, because OpenGL leaves out lines along the rim.
  if (hasFocus())
    for (const QRect& side : QRegion(rect()) - rect().adjusted(1, 1, -1, -1))
      painter.fillRect(side, QColor(86, 140, 190));
}

void VolumeView::drawWaiting(QPainter& painter) const {
  if (waiting_.empty()) return;
  const QColor colour(220, 222, 226);
  QPolygonF line;
  for (const std::unique_ptr<QMouseEvent>& event : waiting_) line << event->position();
  painter.setPen(QPen(colour, 1.5, Qt::DotLine));
  painter.drawPolyline(line);
  drawText(painter, QRectF(line.front(), QSizeF()).adjusted(-150.0, -30.0, 150.0, -10.0),
           Qt::AlignCenter | Qt::TextSingleLine, tr("Waits for the picture"), colour);
}

void VolumeView::drawMarks(QPainter& painter, const Camera& camera, const std::vector<FidelityCause>& causes) const {
  const QRectF view = rect();
  drawFidelity(painter, view, causes);
  if (options_.crosshair() && hasPicture())
    if (const std::optional<QPointF> at = widgetFromWorld(shownAt(cursor_.position()), camera)) drawMark(painter, *at);
  if (options_.text()) {
    QStringList lines{tr("C%1").arg(index_ + 1)};
    lines << (camera.projection == Projection::Perspective ? tr("perspective") : tr("parallel"));
    drawCorner(painter, besideChip(view), Qt::AlignTop | Qt::AlignLeft, lines, QColor(120, 190, 240));
  }
  constexpr double cube = 58.0;
  drawOrientationCube(painter, {view.left() + overlayMargin, view.bottom() - overlayMargin - cube, cube, cube},
                      camera.axes());
  if (camera.projection == Projection::Orthographic) drawScaleBar(painter, view, mmPerPixel(camera));
}

}  // namespace fenestra::viewer
