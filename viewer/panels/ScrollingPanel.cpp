#include "viewer/panels/ScrollingPanel.h"

#include <algorithm>

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QLayout>
#include <QResizeEvent>
#include <QScrollBar>

namespace fenestra::viewer {
namespace {

/// Whether a part of a layout is the widget, or holds it.
bool holds(QLayoutItem& item, const QWidget& widget) {
  if (item.widget()) return item.widget() == &widget || item.widget()->isAncestorOf(&widget);
  const QLayout* layout = item.layout();
  for (int i = 0; layout && i < layout->count(); ++i)
    if (holds(*layout->itemAt(i), widget)) return true;
  return false;
}

}  // namespace

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
    // A list's scroll bar is a slider, too, and gets the wheel of the list.
    if (qobject_cast<QComboBox*>(widget) || qobject_cast<QAbstractSpinBox*>(widget) ||
        (qobject_cast<QAbstractSlider*>(widget) && !qobject_cast<QScrollBar*>(widget))) {
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

int ScrollingPanel::usefulHeight() const { return sizeHint().height(); }

int ScrollingPanel::heightThrough(const QWidget& last) const {
  const QLayout& layout = *widget()->layout();
  const QMargins margins = layout.contentsMargins();
  int height = margins.top() + margins.bottom();
  for (int i = 0; i < layout.count(); ++i) {
    QLayoutItem& row = *layout.itemAt(i);
    if (row.isEmpty()) continue;
    height += row.minimumSize().height();
    if (holds(row, last)) break;
    height += layout.spacing();
  }
  return height;
}

void ScrollingPanel::holdPlace() {
  QWidget& body = *widget();
  const int held = verticalScrollBar()->value() > 0 ? verticalScrollBar()->value() + viewport()->height() : 0;
  // A least height that is set takes the place of what the rows need.
  body.setMinimumHeight(held > body.minimumSizeHint().height() ? held : 0);
}

void ScrollingPanel::releasePlace() {
  if (!widget() || widget()->minimumHeight() == 0) return;
  widget()->setMinimumHeight(0);
  widget()->resize(widget()->width(), std::max(viewport()->height(), widget()->minimumSizeHint().height()));
}

void ScrollingPanel::leaveEvent(QEvent* event) {
  releasePlace();
  QScrollArea::leaveEvent(event);
}

void ScrollingPanel::resizeEvent(QResizeEvent* event) {
  if (event->size().height() != event->oldSize().height()) releasePlace();
  QScrollArea::resizeEvent(event);
}

bool ScrollingPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == this->widget() && event->type() == QEvent::LayoutRequest) {
    holdPlace();
    updateGeometry();  // rows that appear may be wider than those before: the dock grows with them
  }
  const auto* widget = qobject_cast<QWidget*>(watched);
  // A scroll area watches its own bars, too, to which it hands the wheel.
  if (event->type() != QEvent::Wheel || !widget || widget->hasFocus() || qobject_cast<const QScrollBar*>(widget))
    return QScrollArea::eventFilter(watched, event);
  event->ignore();  // so that it goes on to the scroll area
  return true;
}

}  // namespace fenestra::viewer
