#include "viewer/guide/Tour.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPropertyAnimation>
#include <QPushButton>
#include <QSlider>
#include <QStyleOptionSlider>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "viewer/model/Workspace.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {
namespace {

/// A place in the left kidney of resources/phantoms/torso.json, beside the renal pelvis, and half the kidney's length;
/// world, mm.
constexpr glm::dvec3 kidney(74.0, 46.0, -98.0);
constexpr double kidneyHalfLength = 49.0;

constexpr int travelMilliseconds = 900, stepMilliseconds = 40;

/// A ring with a point: where the tour's mouse is.
class Pointer : public QWidget {
 public:
  Pointer() {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFixedSize(side, side);
    hide();
  }
  static constexpr int side = 36;

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPointF middle = QRectF(rect()).center();
    painter.setPen(QPen(QColor(0, 0, 0, 160), 5.0));
    painter.drawEllipse(middle, 14.0, 14.0);
    painter.setPen(QPen(QColor(255, 214, 92), 2.5));
    painter.drawEllipse(middle, 14.0, 14.0);
    painter.setBrush(QColor(255, 214, 92));
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(middle, 3.5, 3.5);
  }
};

/// The middle of a slider's handle.
QPointF handleOf(const QSlider& slider) {
  QStyleOptionSlider option;
  option.initFrom(&slider);
  option.orientation = slider.orientation();
  option.minimum = slider.minimum();
  option.maximum = slider.maximum();
  option.sliderPosition = option.sliderValue = slider.value();
  option.subControls = QStyle::SC_All;
  return slider.style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider).center();
}

}  // namespace

Tour::Tour(Workspace& workspace, ViewArea& views, QWidget* parent)
    : QFrame(parent),
      workspace_(workspace),
      views_(views),
      title_(new QLabel),
      text_(new QLabel),
      next_(new QPushButton),
      end_(new QPushButton(tr("End the tour"))),
      pointer_(new Pointer) {
  setObjectName(QStringLiteral("notice"));
  pointer_->setParent(this);
  QFont bold = title_->font();
  bold.setBold(true);
  title_->setFont(bold);
  text_->setWordWrap(true);
  text_->setMinimumWidth(200);
  text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* texts = new QVBoxLayout;
  texts->setSpacing(2);
  texts->addWidget(title_);
  texts->addWidget(text_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 6, 10, 6);
  row->addLayout(texts, 1);
  row->addWidget(next_);
  row->addWidget(end_);
  hide();
  connect(next_, &QPushButton::clicked, this, &Tour::next);
  connect(end_, &QPushButton::clicked, this, &Tour::end);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &Tour::doNext);
}

QList<Tour::Step> Tour::allSteps() const {
  return {
      {tr("One body, five views"),
       tr("Above are two 3-D views, C1 and C2; below are three slices. The torso opens with several structures in "
          "focus: what hides them is cut away."),
       nullptr},
      {tr("Choose a structure"),
       tr("A click on the left kidney in the axial slice makes it the focus. The cameras move to the two views that "
          "together see most of it."),
       &Tour::chooseKidney},
      {tr("Turn"),
       tr("Drag with the left button in a 3-D view to turn it. The opening follows the kidney; C2 follows C1."),
       &Tour::turn},
      {tr("Widen the opening"),
       tr("The slider Opening in the panel Cutaway sets how far the opening reaches beyond the focus."), &Tour::widen},
      {tr("Bring tissue back"),
       tr("The brush (P) paints back what the opening removed: here, tissue above the kidney. Ctrl+Z takes a stroke "
          "back."),
       &Tour::paint},
      {tr("Keep it"),
       tr("Ctrl+S saves a session with all that you did; Ctrl+E saves a picture, for a slide. F1 opens the user "
          "guide."),
       nullptr},
  };
}

void Tour::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  // All steps have one height, so that the pictures below keep their size.
  int height = 0;
  for (const Step& step : allSteps())
    height =
        std::max(height, text_->fontMetrics()
                             .boundingRect(QRect(0, 0, text_->width(), QWIDGETSIZE_MAX), Qt::TextWordWrap, step.text)
                             .height());
  text_->setFixedHeight(height + 2);
}

int Tour::steps() const { return static_cast<int>(allSteps().size()); }

void Tour::setPhantom(std::function<bool()> open) {
  phantom_ = std::move(open);
  Q_EMIT canStartChanged(true);
}

void Tour::start() {
  if (!phantom_) return;
  end();
  opens_ = true;  // set first, because reading may end at once
  if (!phantom_()) opens_ = false;
}

void Tour::studyOpened() {
  const bool begins = std::exchange(opens_, false);
  end();
  if (begins) show(0);
}

void Tour::openingEnded() { opens_ = false; }

void Tour::next() {
  if (!step_ || isActing()) return;
  if (*step_ + 1 == steps()) return end();
  show(*step_ + 1);
  perform(*step_);
}

void Tour::end() {
  timer_.stop();
  moves_.clear();
  step_.reset();
  pointer_->hide();
  hide();
}

void Tour::show(int step) {
  step_ = step;
  const Step shown = allSteps()[step];
  title_->setText(tr("%1 of %2: %3").arg(step + 1).arg(steps()).arg(shown.title));
  text_->setText(shown.text);
  next_->setText(step + 1 < steps() ? tr("Next") : tr("Done"));
  setVisible(true);
  next_->setFocus();
}

void Tour::perform(int step) {
  if (const auto act = allSteps()[step].act) (this->*act)();
  doNext();
}

void Tour::add(QWidget* widget, QPointF at, std::function<void()> act, int milliseconds) {
  moves_ << Move{widget, at, std::move(act), milliseconds};
}

void Tour::doNext() {
  while (!moves_.isEmpty()) {
    const Move move = moves_.front();
    if (!move.widget) return end();
    if (animated_ && move.milliseconds > 0) {
      pointer_->setParent(window());
      const QPointF to = move.widget->mapTo(window(), move.at) - QPointF(Pointer::side, Pointer::side) / 2.0;
      if (pointer_->isHidden()) pointer_->move(next_->mapTo(window(), QPoint(0, 0)));
      pointer_->show();
      pointer_->raise();
      auto* way = new QPropertyAnimation(pointer_, "pos", pointer_);
      way->setEndValue(to.toPoint());
      way->setDuration(move.milliseconds);
      way->setEasingCurve(move.milliseconds > stepMilliseconds ? QEasingCurve::InOutQuad : QEasingCurve::Linear);
      moves_.front().milliseconds = 0;
      way->start(QAbstractAnimation::DeleteWhenStopped);
      timer_.start(move.milliseconds);
      return;
    }
    // What the tour does is no work of the user that could be lost.
    QUndoStack& steps = workspace_.document.undoStack();
    const bool nothingToLose = steps.isClean();
    move.act();
    if (nothingToLose) steps.setClean();
    // The action may have ended the tour.
    if (!moves_.isEmpty()) moves_.removeFirst();
  }
  if (animated_ && !pointer_->isHidden()) QTimer::singleShot(travelMilliseconds, pointer_, &QWidget::hide);
}

void Tour::send(QWidget* widget, int type, QPointF at, bool pressed) {
  const auto kind = static_cast<QEvent::Type>(type);
  QMouseEvent event(kind, at, widget->mapToGlobal(at), kind == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
                    pressed ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(widget, &event);
}

void Tour::addDrag(QWidget* widget, const QList<QPointF>& path) {
  add(
      widget, path.front(), [this, widget, at = path.front()] { send(widget, QEvent::MouseButtonPress, at, true); },
      travelMilliseconds);
  for (const QPointF& at : path)
    add(
        widget, at, [this, widget, at] { send(widget, QEvent::MouseMove, at, true); }, stepMilliseconds);
  add(
      widget, path.back(), [this, widget, at = path.back()] { send(widget, QEvent::MouseButtonRelease, at, false); },
      stepMilliseconds);
}

void Tour::chooseKidney() {
  SliceView* axial = views_.sliceViews().front();
  const QPointF place = axial->widgetFromWorld(kidney);
  add(
      axial, place,
      [axial, place] {
        // A notch of the wheel is a slice.
        const int wanted = static_cast<int>(std::lround(axial->sliceGeometry().pixelFromWorld(kidney).z));
        QWheelEvent turn(place, axial->mapToGlobal(place), {}, {0, 120 * (wanted - axial->slice())}, Qt::NoButton,
                         Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(axial, &turn);
      },
      travelMilliseconds);
  add(
      axial, place, [this, axial, place] { send(axial, QEvent::MouseButtonPress, place, true); }, travelMilliseconds);
  add(
      axial, place, [this, axial, place] { send(axial, QEvent::MouseButtonRelease, place, false); }, stepMilliseconds);
}

void Tour::turn() {
  if (views_.volumeViews().empty()) return;
  VolumeView* view = views_.volumeViews().front();
  const QPointF from(0.35 * view->width(), 0.75 * view->height());
  constexpr int moves = 24;
  QList<QPointF> path;
  for (int i = 0; i <= moves; ++i) path << from + QPointF(0.12 * view->width(), -0.02 * view->height()) * i / moves;
  addDrag(view, path);
}

void Tour::widen() {
  const auto* panel = window()->findChild<CutawayPanel*>();
  for (QWidget* each = panel->parentWidget(); each; each = each->parentWidget())
    if (auto* dock = qobject_cast<QDockWidget*>(each)) {  // it may be behind another tab
      dock->show();
      dock->raise();
    }
  QSlider* slider = panel->openWidth()->slider();
  const QPointF from = handleOf(*slider);
  constexpr int moves = 20;
  QList<QPointF> path;
  for (int i = 0; i <= moves; ++i) path << from + QPointF(0.22 * slider->width(), 0.0) * i / moves;
  addDrag(slider, path);
}

void Tour::paint() {
  if (views_.volumeViews().empty()) return;
  VolumeView* view = views_.volumeViews().front();
  const Camera::Axes axes = view->shownCamera().axes();
  QList<QPointF> path;
  constexpr int moves = 16;
  for (int i = 0; i <= moves; ++i) {
    const double across = kidneyHalfLength * (static_cast<double>(i) / moves - 0.5) * 1.6;
    const glm::dvec3 place = kidney + 1.25 * kidneyHalfLength * axes.up + across * axes.right;
    if (const auto at = view->widgetFromWorld(place)) path << *at;
  }
  if (path.isEmpty()) return;
  add(
      view, path.front(), [this] { workspace_.brush.setActive(true); }, travelMilliseconds);
  addDrag(view, path);
  add(
      view, path.back(), [this] { workspace_.brush.setActive(false); }, travelMilliseconds);
}

}  // namespace fenestra::viewer
