#include "viewer/style/FocusRing.h"

#include <QApplication>
#include <QCheckBox>
#include <QEvent>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QRadioButton>

namespace fenestra::viewer {
namespace {

class Ring : public QWidget {
 public:
  explicit Ring(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    setObjectName(QStringLiteral("focusRing"));
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    constexpr qreal width = 2.0, radius = 3.0;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Link), width));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5 * width, 0.5 * width, -0.5 * width, -0.5 * width), radius,
                            radius);
  }
};

bool needsRing(const QWidget* control) {
  return control && !control->isWindow() && !control->property(FocusRing::drawnByWidget).toBool() &&
         !qobject_cast<const QMenu*>(control) && !qobject_cast<const QMenuBar*>(control);
}

/// A box to tick reaches to the control's edge, so that a ring within would cover it: its ring lies around the control.
bool ringIsAround(const QWidget* control) {
  return (qobject_cast<const QCheckBox*>(control) || qobject_cast<const QRadioButton*>(control)) &&
         control->parentWidget();
}

/// Where the ring lies, in its parent.
QRect ringOf(const QWidget* control) {
  constexpr int around = 3;  // device-independent pixels: the ring's width, and one that stays free
  return ringIsAround(control) ? control->geometry().adjusted(-around, -around, around, around) : control->rect();
}

}  // namespace

FocusRing::FocusRing(QObject* parent) : QObject(parent) {
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { moveTo(now); });
}

FocusRing::~FocusRing() { delete ring_.data(); }

void FocusRing::moveTo(QWidget* control) {
  if (ring_) {
    if (control_) control_->removeEventFilter(this);
    ring_->deleteLater();
    ring_->hide();
    ring_.clear();
  }
  if (!needsRing(control)) return;
  control_ = control;
  ring_ = new Ring(ringIsAround(control) ? control->parentWidget() : control);
  ring_->setGeometry(ringOf(control));
  ring_->show();
  ring_->raise();
  control->installEventFilter(this);
}

bool FocusRing::eventFilter(QObject* watched, QEvent* event) {
  if (ring_ && watched == control_ && (event->type() == QEvent::Resize || event->type() == QEvent::Move))
    ring_->setGeometry(ringOf(control_));
  return QObject::eventFilter(watched, event);
}

}  // namespace fenestra::viewer
