#include "viewer/tools/ViewTools.h"

#include <algorithm>
#include <utility>

#include <QMouseEvent>
#include <QWheelEvent>

#include "viewer/tools/Tool.h"

namespace fenestra::viewer {

ViewTools::ViewTools(std::vector<Tool*> tools) : tools_(std::move(tools)) {}

bool ViewTools::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton) return false;
  const auto taker = std::find_if(tools_.begin(), tools_.end(), [&](Tool* tool) { return tool->press(event); });
  holder_ = taker != tools_.end() ? *taker : nullptr;
  return isBusy();
}

bool ViewTools::move(const QMouseEvent& event) {
  for (Tool* tool : tools_) tool == holder_ ? tool->drag(event) : tool->hover(event);
  return isBusy();
}

bool ViewTools::release(const QMouseEvent& event) {
  if (!isBusy() || event.button() != Qt::LeftButton) return isBusy();
  Tool* tool = std::exchange(holder_, nullptr);
  if (tool->wasClick()) {
    tool->leave();
    return false;
  }
  tool->release(event);
  return true;
}

bool ViewTools::wheel(const QWheelEvent& event) {
  return std::any_of(tools_.begin(), tools_.end(), [&](Tool* tool) { return tool->wheel(event); });
}

bool ViewTools::key(const QKeyEvent& event) {
  return std::any_of(tools_.begin(), tools_.end(), [&](Tool* tool) { return tool->key(event); });
}

void ViewTools::leave() {
  for (Tool* tool : tools_) tool->leave();
}

void ViewTools::refresh() {
  for (Tool* tool : tools_) tool->refresh();
}

void ViewTools::abandon() {
  holder_ = nullptr;
  leave();
}

Qt::CursorShape ViewTools::pointer(QPointF position) const {
  for (const Tool* tool : tools_)
    if (const auto shape = tool->pointer(position)) return *shape;
  return Qt::ArrowCursor;
}

void ViewTools::draw(QPainter& painter, const QRectF& view) const {
  for (auto tool = tools_.rbegin(); tool != tools_.rend(); ++tool) (*tool)->draw(painter, view);
}

}  // namespace fenestra::viewer
