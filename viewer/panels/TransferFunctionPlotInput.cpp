// What the mouse, the wheel and the keys do in a TransferFunctionPlot.

#include <algorithm>
#include <cmath>

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QWheelEvent>

#include "viewer/model/Document.h"
#include "viewer/panels/TransferFunctionPlot.h"

namespace fenestra::viewer {
namespace {

// Device-independent pixels.
constexpr double nodeReach = 9.0, lineReach = 5.0, tremor = 3.0;

double distanceToSegment(QPointF at, QPointF a, QPointF b) {
  const QPointF along = b - a, from = at - a;
  const double length = QPointF::dotProduct(along, along);
  const double s = length > 0.0 ? std::clamp(QPointF::dotProduct(from, along) / length, 0.0, 1.0) : 0.0;
  const QPointF off = from - s * along;
  return std::hypot(off.x(), off.y());
}

}  // namespace

std::optional<Grip> TransferFunctionPlot::gripAt(QPointF at) const {
  const TransferFunction function = this->function();
  const auto& nodes = function.nodes;
  std::vector<QPointF> places;
  for (const auto& node : nodes) places.push_back(place(node.value, opacityFromExtinction(node.properties.extinction)));
  std::optional<Grip> nearest;
  double least = nodeReach;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const QPointF off = at - places[node];
    const double distance = std::hypot(off.x(), off.y());
    // Where two nodes share a place, take the selected one, or else the later one, which can be dragged to the right.
    if (distance > least || (nearest && distance == least && nearest->node == selected_)) continue;
    least = distance;
    nearest = Grip{Grip::Part::Node, node};
  }
  if (nearest) return nearest;
  if (nodes.size() == 2 && !hasNodes(target_, document_))
    return distanceToSegment(at, places[0], places[1]) <= lineReach ? std::optional(Grip{Grip::Part::Plateau, 0})
                                                                    : std::nullopt;
  for (const std::size_t first : trapezoidsOf(function)) {
    if (distanceToSegment(at, places[first + 1], places[first + 2]) <= lineReach)
      return Grip{Grip::Part::Plateau, first};
    if (distanceToSegment(at, places[first], places[first + 1]) <= lineReach) return Grip{Grip::Part::LeftEdge, first};
    if (distanceToSegment(at, places[first + 2], places[first + 3]) <= lineReach)
      return Grip{Grip::Part::RightEdge, first};
    const double value = valueAt(at.x());
    const double curve = place(value, opacityFromExtinction(function.evaluate(value).extinction)).y();
    if (value > nodes[first].value && value < nodes[first + 3].value && at.y() > curve && at.y() < area().bottom())
      return Grip{Grip::Part::Whole, first};
  }
  return std::nullopt;
}

void TransferFunctionPlot::edit(const TransferFunction& function) {
  setFunction(target_, document_, function, document_.look());
}

void TransferFunctionPlot::setValue(double value) {
  const auto node = selected();
  if (!node) return;
  const TransferFunction now = function();
  edit(movedOf(target_, document_, now, {Grip::Part::Node, *node}, value - now.nodes[*node].value, 0.0));
}

void TransferFunctionPlot::setOpacity(double opacity) {
  const auto node = selected();
  if (!node) return;
  const TransferFunction now = function();
  const double before = opacityFromExtinction(now.nodes[*node].properties.extinction);
  edit(movedOf(target_, document_, now, {Grip::Part::Node, *node}, 0.0, opacity - before));
}

void TransferFunctionPlot::setColour(glm::dvec3 colour) {
  if (!selected() || !hasColour(target_, document_)) return;
  TransferFunction now = function();
  const auto [first, last] = hasNodes(target_, document_) ? selection() : std::pair(std::size_t{0}, now.nodes.size());
  for (std::size_t node = first; node < last; ++node) now.nodes[node].properties.colour = colour;
  edit(now);
}

void TransferFunctionPlot::addNode(double value, double opacity) {
  if (!hasNodes(target_, document_) || !document_.hasVolume()) return;
  const WithNode with = withNode(function(), value, opacity);
  edit(with.function);
  select(with.node);
}

void TransferFunctionPlot::addTrapezoid(double value) {
  if (!hasNodes(target_, document_) || !document_.hasVolume()) return;
  const double half = 0.1 * (shown_.high - shown_.low);
  const double middle = std::clamp(value, axis_.low + half, axis_.high - half);
  const WithNode with = withTrapezoid(function(), {middle - half, middle + half}, 0.5);
  edit(with.function);
  selectTrapezoid(with.node);
}

void TransferFunctionPlot::deleteSelected() {
  if (!selected() || !hasNodes(target_, document_)) return;
  TransferFunction now = function();
  const auto [first, last] = selection();
  // The last nodes stay: without any the context would vanish, and nothing could be dragged to bring it back.
  if (now.nodes.size() == last - first) return;
  for (std::size_t count = first; count < last; ++count) now = withoutNode(now, first);
  edit(now);
  select(first > 0 ? first - 1 : 0);
}

void TransferFunctionPlot::selectPart(Grip grip) {
  // A level and a box have one material.
  if (grip.part == Grip::Part::Node || !hasNodes(target_, document_))
    select(grip.node);
  else
    selectTrapezoid(grip.node);
}

void TransferFunctionPlot::mousePressEvent(QMouseEvent* event) {
  if (!document_.hasVolume()) return;
  if (event->button() == Qt::MiddleButton) panFrom_ = valueAt(event->position().x());
  if (event->button() != Qt::LeftButton) return;
  const std::optional<Grip> grip = gripAt(event->position());
  if (!grip) return;
  selectPart(*grip);
  drag_ = Drag{document_.look(), function(), *grip, event->position()};
  document_.history().beginGesture();
}

void TransferFunctionPlot::mouseMoveEvent(QMouseEvent* event) {
  if (panFrom_ && event->buttons() & Qt::MiddleButton) {
    const double by = *panFrom_ - valueAt(event->position().x());
    showValues({shown_.low + by, shown_.high + by});
  } else if (drag_ && event->buttons() & Qt::LeftButton) {
    dragTo(event->position(), event->modifiers());
  } else {
    showCursor(event->position());
  }
}

void TransferFunctionPlot::dragTo(QPointF at, Qt::KeyboardModifiers modifiers) {
  const QRectF plot = area();
  at = {std::clamp(at.x(), plot.left(), plot.right()), std::clamp(at.y(), plot.top(), plot.bottom())};
  QPointF by = at - drag_->from;
  if (!drag_->hasMoved && std::hypot(by.x(), by.y()) < tremor) return;
  drag_->hasMoved = true;
  if (modifiers & Qt::ShiftModifier) (std::abs(by.x()) > std::abs(by.y()) ? by.ry() : by.rx()) = 0.0;
  const double values = by.x() / plot.width() * (shown_.high - shown_.low);
  setFunction(target_, document_,
              movedOf(target_, document_, drag_->function, drag_->grip, values, -by.y() / plot.height()), drag_->look);
}

void TransferFunctionPlot::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::MiddleButton) panFrom_.reset();
  if (event->button() == Qt::LeftButton) endDrag();
}

void TransferFunctionPlot::endDrag() {
  if (!drag_) return;
  drag_.reset();
  document_.history().endGesture();
  follow();
}

void TransferFunctionPlot::cancelDrag() {
  if (!drag_) return;
  setFunction(target_, document_, drag_->function, drag_->look);
  endDrag();
}

void TransferFunctionPlot::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !document_.hasVolume()) return;
  const std::optional<Grip> grip = gripAt(event->position());
  if (grip && grip->part == Grip::Part::Node) {
    select(grip->node);
    Q_EMIT colourWanted();
  } else if (area().adjusted(-1, -1, 1, 1).contains(event->position())) {
    addNode(valueAt(event->position().x()), opacityAt(event->position().y()));
  }
}

void TransferFunctionPlot::wheelEvent(QWheelEvent* event) {
  // A panel that scrolls gets the wheel unless the plot was chosen.
  if (!hasFocus() && !(event->modifiers() & Qt::ControlModifier)) return event->ignore();
  constexpr double perNotch = 1.25, notch = 120.0, mostEnlarged = 64.0;
  const double factor = std::pow(perNotch, -event->angleDelta().y() / notch);
  const double all = axis_.high - axis_.low, span = shown_.high - shown_.low;
  const double wanted = std::clamp(span * factor, all / mostEnlarged, all);
  if (wanted >= all) return showValues(axis_);
  const double fixed = valueAt(event->position().x()), share = (fixed - shown_.low) / span;
  showValues({fixed - share * wanted, fixed + (1.0 - share) * wanted});
}

bool TransferFunctionPlot::event(QEvent* event) {
  // Menus have some of these keys, too; here they are the plot's.
  if (event->type() == QEvent::ShortcutOverride && useKey(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

bool TransferFunctionPlot::useKey(const QKeyEvent& event) {
  const bool control = event.modifiers() & Qt::ControlModifier;
  switch (event.key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Down:
      return !control;
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Home:
    case Qt::Key_End:
    case Qt::Key_Insert:
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return event.modifiers() == Qt::NoModifier || event.modifiers() == Qt::KeypadModifier;
    case Qt::Key_Escape:
      return drag_.has_value();
    default:
      return false;
  }
}

void TransferFunctionPlot::keyPressEvent(QKeyEvent* event) {
  const std::optional<std::size_t> node = selected();
  if (!document_.hasVolume() || !node || !useKey(*event)) return QWidget::keyPressEvent(event);
  const TransferFunction now = function();
  switch (event->key()) {
    case Qt::Key_PageUp:
      return select(*node > 0 ? *node - 1 : 0);
    case Qt::Key_PageDown:
      return select(std::min(*node + 1, now.nodes.size() - 1));
    case Qt::Key_Home:
      return select(0);
    case Qt::Key_End:
      return select(now.nodes.size() - 1);
    case Qt::Key_Insert: {
      // Half way to the next node, or before the last one.
      const std::size_t left = now.nodes.size() > 1 ? std::min(*node, now.nodes.size() - 2) : *node;
      const std::size_t right = std::min(left + 1, now.nodes.size() - 1);
      const double value = 0.5 * (now.nodes[left].value + now.nodes[right].value);
      return addNode(value, opacityFromExtinction(now.evaluate(value).extinction));
    }
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      return deleteSelected();
    case Qt::Key_Return:
    case Qt::Key_Enter:
      Q_EMIT colourWanted();
      return;
    case Qt::Key_Escape:
      return cancelDrag();
    default:
      moveByKey(*event);
  }
}

Grip TransferFunctionPlot::selectedGrip(Grip::Part part) const {
  const std::size_t node = selected().value_or(0);
  for (const std::size_t first : trapezoidsOf(function()))
    if (node >= first && node < first + 4) return {part, first};
  return {Grip::Part::Node, node};
}

std::pair<std::size_t, std::size_t> TransferFunctionPlot::selection() const {
  const std::size_t node = selected().value_or(0);
  const Grip grip = isTrapezoidSelected_ ? selectedGrip(Grip::Part::Whole) : Grip{Grip::Part::Node, node};
  return {grip.node, grip.node + (grip.part == Grip::Part::Whole ? 4 : 1)};
}

void TransferFunctionPlot::moveByKey(const QKeyEvent& event) {
  if (drag_) return;
  // A held key is one step of the history.
  if (!event.isAutoRepeat()) document_.history().beginGesture();
  constexpr double pixels = 2.0, percent = 0.01, coarse = 10.0;
  const double times = event.modifiers() & Qt::ShiftModifier ? coarse : 1.0;
  const double value = times * pixels / area().width() * (shown_.high - shown_.low), opacity = times * percent;
  const bool isWhole = event.modifiers() & Qt::AltModifier,
             isAcross = event.key() == Qt::Key_Left || event.key() == Qt::Key_Right;
  const Grip grip = isWhole ? selectedGrip(isAcross ? Grip::Part::Whole : Grip::Part::Plateau)
                            : Grip{Grip::Part::Node, selected().value_or(0)};
  const double sign = event.key() == Qt::Key_Left || event.key() == Qt::Key_Down ? -1.0 : 1.0;
  edit(movedOf(target_, document_, function(), grip, isAcross ? sign * value : 0.0, isAcross ? 0.0 : sign * opacity));
}

void TransferFunctionPlot::keyReleaseEvent(QKeyEvent* event) {
  if (!event->isAutoRepeat() && !drag_) document_.history().endGesture();
  QWidget::keyReleaseEvent(event);
}

void TransferFunctionPlot::contextMenuEvent(QContextMenuEvent* event) {
  if (!document_.hasVolume() || drag_) return;
  QPointF at = event->pos();
  if (const auto node = selected(); node && event->reason() == QContextMenuEvent::Keyboard) {
    const TransferFunction::Node shown = function().nodes[*node];
    at = place(shown.value, opacityFromExtinction(shown.properties.extinction));
  }
  QMenu menu(this);
  fillMenu(menu, at);
  if (!menu.isEmpty())
    menu.exec(event->reason() == QContextMenuEvent::Keyboard ? mapToGlobal(at.toPoint()) : event->globalPos());
}

void TransferFunctionPlot::fillMenu(QMenu& menu, QPointF at) {
  const std::optional<Grip> grip = gripAt(at);
  const bool isNode = grip && grip->part == Grip::Part::Node;
  if (grip) selectPart(*grip);
  if (grip && hasColour(target_, document_)) menu.addAction(tr("Colour…"), this, &TransferFunctionPlot::colourWanted);
  if (hasNodes(target_, document_)) {
    const auto [first, last] = selection();
    if (grip)
      menu.addAction(isNode ? tr("Delete the point") : tr("Delete the trapezoid"), this,
                     &TransferFunctionPlot::deleteSelected)
          ->setEnabled(function().nodes.size() > last - first);
    if (!isNode) menu.addAction(tr("Add a point"), this, [this, at] { addNode(valueAt(at.x()), opacityAt(at.y())); });
    menu.addAction(tr("Add a trapezoid"), this, [this, at] { addTrapezoid(valueAt(at.x())); });
  }
  if (canBeByValue(target_, document_)) {
    QAction* byValue = menu.addAction(tr("By value"), this, &TransferFunctionPlot::setByValue);
    byValue->setCheckable(true);
    byValue->setChecked(isByValue(target_, document_));
  }
  menu.addAction(tr("Show all values"), this, [this] { showValues(axis_); })
      ->setEnabled(shown_.low > axis_.low || shown_.high < axis_.high);
}

void TransferFunctionPlot::showCursor(QPointF at) {
  const std::optional<Grip> grip = document_.hasVolume() ? gripAt(at) : std::nullopt;
  if (!grip) return setCursor(Qt::ArrowCursor);
  const bool moves = hasValues(target_, document_);
  switch (grip->part) {
    case Grip::Part::Node:
      return setCursor(moves ? Qt::SizeAllCursor : Qt::SizeVerCursor);
    case Grip::Part::Plateau:
      return setCursor(Qt::SizeVerCursor);
    default:
      return setCursor(Qt::SizeHorCursor);
  }
}

}  // namespace fenestra::viewer
