#include "viewer/tools/ClipTool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QMouseEvent>

#include "viewer/model/ActiveTool.h"
#include "viewer/model/Document.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/tools/Canvas.h"
#include "viewer/tools/CutPolygon.h"
#include "viewer/tools/HandleDrag.h"

namespace fenestra::viewer {
namespace {

/// Sine of the angle between a plane and a slice below which they count as parallel.
constexpr double leastAngle = 0.1;
constexpr double arrowShare = 0.3;  ///< length of a plane's arrow over the radius of the volume

struct ClipToolWords {
  Q_DECLARE_TR_FUNCTIONS(ClipTool)
};

QColor colourOf(std::size_t plane) {
  static const std::array<QColor, Clipping::mostPlanes> colours{QColor(205, 170, 255), QColor(110, 190, 255),
                                                                QColor(240, 150, 220)};
  return colours[plane % colours.size()];
}
const QColor boxColour(255, 196, 80);

/// The part of the box that lies in the volume.
CropBox inVolume(const CropBox& box, const CropFrame& frame) {
  return {glm::clamp(box.low, frame.low, frame.high), glm::clamp(box.high, frame.low, frame.high)};
}

glm::dvec3 onto(const Canvas::Section& section, glm::dvec3 point) {
  return point - section.normal * glm::dot(point - section.point, section.normal);
}

}  // namespace

ClipTool::ClipTool(Document& document, const ViewOptions& options, const ActiveTool& active, const Canvas& canvas)
    : document_(document), options_(options), active_(active), canvas_(canvas) {}

void ClipTool::addFaces(std::vector<Handle>& handles) const {
  const CropFrame frame(document_.scene().volume->grid);
  const CropBox box = inVolume(document_.clipping().box, frame);
  const auto section = canvas_.section();
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const glm::dvec3 normal = frame.normal[static_cast<std::size_t>(axis)];
    if (section && std::abs(glm::dot(normal, section->normal)) > 1.0 - leastAngle) continue;
    glm::dvec3 middle = 0.5 * (box.low + box.high);
    middle[axis] = face % 2 ? box.high[axis] : box.low[axis];
    const glm::dvec3 world = frame.world(middle);
    handles.push_back({Handle::Kind::Face, face, section ? onto(*section, world) : world, normal});
  }
}

void ClipTool::addPlanes(std::vector<Handle>& handles) const {
  const Grid& grid = document_.scene().volume->grid;
  const double arrow = arrowShare * grid.boundingRadius();
  const auto section = canvas_.section();
  const glm::dvec3 centre = section ? onto(*section, grid.centre()) : grid.centre();
  const std::vector<HalfSpace>& planes = document_.clipping().planes;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const HalfSpace& plane = planes[i];
    glm::dvec3 along = plane.normal;
    if (section) along -= section->normal * glm::dot(along, section->normal);
    const double sine = glm::length(along);
    if (sine < leastAngle) continue;
    along /= sine;
    const glm::dvec3 foot = centre - along * (plane.distance(centre) / sine);
    const int which = static_cast<int>(i);
    handles.push_back({Handle::Kind::Move, which, foot, along});
    handles.push_back({Handle::Kind::Tilt, which, foot + along * arrow, along, foot});
  }
}

std::vector<ClipTool::Handle> ClipTool::handles() const {
  std::vector<Handle> handles;
  if (!document_.hasVolume() || !options_.clipHandles()) return handles;
  if (active_.mode() && !canvas_.section()) return handles;
  if (document_.clipping().cropped) addFaces(handles);
  addPlanes(handles);
  return handles;
}

std::optional<ClipTool::Handle> ClipTool::handleAt(QPointF position) const {
  return handleNear(handles(), canvas_, position);
}

std::optional<Qt::CursorShape> ClipTool::pointer(QPointF position) const {
  if (grip_) return Qt::ClosedHandCursor;
  return handleAt(position) ? std::optional(Qt::OpenHandCursor) : std::nullopt;
}

bool ClipTool::press(const QMouseEvent& event) {
  if (event.modifiers() != Qt::NoModifier) return false;
  grip_ = handleAt(event.position());
  if (!grip_) return false;
  before_ = held_ = document_.clipping();
  pressed_ = event.position();
  document_.history().beginGesture();
  return true;
}

void ClipTool::drag(const QMouseEvent& event) {
  // Undone or removed meanwhile, or another study has arrived: there is nothing to drag any more.
  if (!document_.hasVolume() || document_.clipping() != held_) return;
  const QPointF moved = event.position() - pressed_;
  switch (grip_->kind) {
    case Handle::Kind::Face:
      dragFace(moved);
      break;
    case Handle::Kind::Move:
      dragPlane(moved);
      break;
    case Handle::Kind::Tilt:
      tiltPlane(moved);
      break;
  }
  held_ = document_.clipping();
}

void ClipTool::release(const QMouseEvent&) {
  grip_.reset();
  document_.history().endGesture();
}

double ClipTool::draggedBy(QPointF moved) const { return draggedAlong(canvas_, grip_->at, grip_->along, moved); }

void ClipTool::dragFace(QPointF moved) {
  const Grid& grid = document_.scene().volume->grid;
  const CropFrame frame(grid);
  Clipping clipping = before_;
  clipping.box = inVolume(before_.box, frame);
  const int axis = grip_->which / 2;
  double &low = clipping.box.low[axis], &high = clipping.box.high[axis];
  const double least = std::min(grid.spacing[frame.axis[axis]], high - low), by = draggedBy(moved);
  if (grip_->which % 2)
    high = std::clamp(high + by, low + least, frame.high[axis]);
  else
    low = std::clamp(low + by, frame.low[axis], high - least);
  document_.setClipping(std::move(clipping), ClipToolWords::tr("Crop"));
}

void ClipTool::dragPlane(QPointF moved) {
  const Grid& grid = document_.scene().volume->grid;
  Clipping clipping = before_;
  HalfSpace& plane = clipping.planes.at(static_cast<std::size_t>(grip_->which));
  const double middle = glm::dot(plane.normal, grid.centre()), reach = grid.boundingRadius();
  const double by = draggedBy(moved) * glm::dot(grip_->along, plane.normal);
  plane.offset = std::clamp(plane.offset + by, middle - reach, middle + reach);
  document_.setClipping(std::move(clipping), ClipToolWords::tr("Move the clip plane"));
}

void ClipTool::tiltPlane(QPointF moved) {
  const auto [right, up, forward] = canvas_.axes();
  const QPointF perRight = canvas_.pixelsPerMm(grip_->at, right);
  const double pixels = std::hypot(perRight.x(), perRight.y());
  if (!(pixels > 0.0)) return;
  const glm::dvec3 tip = grip_->at + (right * moved.x() - up * moved.y()) / pixels;
  const double length = glm::length(tip - grip_->foot);
  if (!(length > 1e-6 * glm::distance(grip_->at, grip_->foot))) return;
  Clipping clipping = before_;
  HalfSpace& plane = clipping.planes.at(static_cast<std::size_t>(grip_->which));
  // On a slice the plane keeps its angle to the slice.
  const glm::dvec3 along = (tip - grip_->foot) / length;
  const glm::dvec3 aside = plane.normal - grip_->along * glm::dot(plane.normal, grip_->along);
  plane.normal = glm::normalize(along * glm::dot(plane.normal, grip_->along) + aside);
  plane.offset = glm::dot(plane.normal, grip_->foot);
  document_.setClipping(std::move(clipping), ClipToolWords::tr("Tilt the clip plane"));
}

void ClipTool::drawLine(QPainter& painter, glm::dvec3 from, glm::dvec3 to, const QColor& colour) const {
  const auto a = canvas_.widgetFromWorld(from), b = canvas_.widgetFromWorld(to);
  if (!a || !b) return;
  painter.setPen(QPen(QColor(0, 0, 0, 150), 3.0));
  painter.drawLine(*a, *b);
  painter.setPen(QPen(colour, 1.4));
  painter.drawLine(*a, *b);
}

void ClipTool::drawBox(QPainter& painter) const {
  const CropFrame frame(document_.scene().volume->grid);
  const CropBox box = inVolume(document_.clipping().box, frame);
  const auto section = canvas_.section();
  for (int from = 0; from < 8; ++from)
    for (int axis = 0; axis < 3; ++axis) {
      if (from >> axis & 1) continue;
      glm::dvec3 a, b;
      for (int i = 0; i < 3; ++i) a[i] = from >> i & 1 ? box.high[i] : box.low[i];
      b = a;
      b[axis] = box.high[axis];
      const glm::dvec3 first = frame.world(a), last = frame.world(b);
      if (!section)
        drawLine(painter, first, last, boxColour);
      else if (std::abs(glm::dot(frame.normal[static_cast<std::size_t>(axis)], section->normal)) < 1.0 - leastAngle)
        drawLine(painter, onto(*section, first), onto(*section, last), boxColour);
    }
}

void ClipTool::drawPlane(QPainter& painter, std::size_t which) const {
  const Grid& grid = document_.scene().volume->grid;
  const HalfSpace& plane = document_.clipping().planes[which];
  const auto section = canvas_.section();
  const QColor colour = colourOf(which);
  if (!section) {
    const std::vector<glm::dvec3> polygon = cutPolygon(grid, plane);
    for (std::size_t i = 0; i < polygon.size(); ++i)
      drawLine(painter, polygon[i], polygon[(i + 1) % polygon.size()], colour);
  }
  for (const Handle& handle : handles()) {
    if (handle.kind != Handle::Kind::Tilt || handle.which != static_cast<int>(which)) continue;
    if (section) {
      const glm::dvec3 line = glm::cross(section->normal, handle.along) * grid.boundingRadius();
      drawLine(painter, handle.foot - line, handle.foot + line, colour);
    }
    drawLine(painter, handle.foot, handle.at, colour);
  }
}

void ClipTool::draw(QPainter& painter, const QRectF&) const {
  const std::vector<Handle> all = handles();
  if (all.empty()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (document_.clipping().cropped) drawBox(painter);
  for (std::size_t i = 0; i < document_.clipping().planes.size(); ++i) drawPlane(painter, i);
  for (const Handle& handle : all) {
    const auto at = canvas_.widgetFromWorld(handle.at);
    if (!at) continue;
    const bool isFace = handle.kind == Handle::Kind::Face;
    painter.setPen(QPen(QColor(0, 0, 0, 190), 1.5));
    painter.setBrush(isFace ? boxColour : colourOf(static_cast<std::size_t>(handle.which)));
    const QRectF box(*at - QPointF(handleRadius, handleRadius), QSizeF(2.0 * handleRadius, 2.0 * handleRadius));
    if (handle.kind == Handle::Kind::Tilt)
      painter.drawEllipse(box);
    else
      painter.drawRect(box);
  }
  painter.restore();
}

}  // namespace fenestra::viewer
