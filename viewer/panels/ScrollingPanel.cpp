#include "viewer/panels/ScrollingPanel.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QScrollBar>

namespace fenestra::viewer {

void ScrollingPanel::setBody(QWidget* body) {
  setFocusPolicy(Qt::NoFocus);  // its controls have the keyboard, and come into sight with it
  setWidget(body);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  // The bar has its place before it is needed: the controls stay where they are when it comes.
  const auto reserve = [this](int, int last) {
    setViewportMargins(0, 0, last > 0 ? 0 : verticalScrollBar()->sizeHint().width(), 0);
  };
  connect(verticalScrollBar(), &QScrollBar::rangeChanged, this, reserve);
  reserve(0, verticalScrollBar()->maximum());
  for (auto* widget : body->findChildren<QWidget*>())
    if (qobject_cast<QComboBox*>(widget) || qobject_cast<QAbstractSlider*>(widget) ||
        qobject_cast<QAbstractSpinBox*>(widget)) {
      widget->setFocusPolicy(Qt::StrongFocus);
      widget->installEventFilter(this);
    }
}

QSize ScrollingPanel::sizeHint() const { return widget() ? widget()->sizeHint() : QScrollArea::sizeHint(); }

QSize ScrollingPanel::minimumSizeHint() const {
  if (!widget()) return QScrollArea::minimumSizeHint();
  constexpr int rows = 3;
  return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(),
          rows * fontMetrics().lineSpacing()};
}

bool ScrollingPanel::eventFilter(QObject* watched, QEvent* event) {
  // Rows that appear may be wider than those before: the dock grows with them.
  if (watched == this->widget() && event->type() == QEvent::LayoutRequest) updateGeometry();
  const auto* widget = qobject_cast<QWidget*>(watched);
  if (event->type() != QEvent::Wheel || !widget || widget->hasFocus()) return QScrollArea::eventFilter(watched, event);
  event->ignore();  // so that it goes on to the scroll area
  return true;
}

}  // namespace fenestra::viewer
