#include "viewer/style/FocusRing.h"

#include <QApplication>
#include <QEvent>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>

namespace fenestra::viewer {
namespace {

class Ring : public QWidget {
 public:
  explicit Ring(QWidget* control) : QWidget(control) {
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

}  // namespace

FocusRing::FocusRing(QObject* parent) : QObject(parent) {
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) { moveTo(now); });
}

FocusRing::~FocusRing() { delete ring_.data(); }

void FocusRing::moveTo(QWidget* control) {
  if (ring_) {
    ring_->parent()->removeEventFilter(this);
    ring_->deleteLater();
    ring_->hide();
    ring_.clear();
  }
  if (!needsRing(control)) return;
  ring_ = new Ring(control);
  ring_->setGeometry(control->rect());
  ring_->show();
  control->installEventFilter(this);
}

bool FocusRing::eventFilter(QObject* watched, QEvent* event) {
  if (ring_ && watched == ring_->parent() && event->type() == QEvent::Resize)
    ring_->setGeometry(static_cast<QWidget*>(watched)->rect());
  return QObject::eventFilter(watched, event);
}

}  // namespace fenestra::viewer
