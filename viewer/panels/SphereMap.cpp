#include "viewer/panels/SphereMap.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include "viewer/model/Mollweide.h"
#include "viewer/model/PlacementController.h"
#include "viewer/model/ViewLink.h"
#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

constexpr QSize mapSize(240, 120);
constexpr double margin = 9.0;  ///< device-independent pixels, for the letters and markers at the rim

/// From low to high quality, with even steps of lightness, which colour-blind users see too.
const std::array<glm::dvec3, 5> ramp{glm::dvec3(0.16, 0.13, 0.32), glm::dvec3(0.20, 0.31, 0.55),
                                     glm::dvec3(0.13, 0.52, 0.55), glm::dvec3(0.42, 0.75, 0.38),
                                     glm::dvec3(0.98, 0.90, 0.30)};

QRgb rampColour(double part) {
  const double at = std::clamp(part, 0.0, 1.0) * (ramp.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(at), ramp.size() - 2);
  return toColour(glm::mix(ramp[low], ramp[low + 1], at - static_cast<double>(low))).rgb();
}

}  // namespace

SphereMap::SphereMap(ViewLink& cameras, PlacementController& placement, QWidget* parent)
    : QWidget(parent), cameras_(cameras), placement_(placement) {
  setObjectName(QStringLiteral("sphereMap"));
  setToolTip(tr("How good each viewpoint is, from dark to bright; click to look from there"));
  setCursor(Qt::PointingHandCursor);
  QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  policy.setHeightForWidth(false);
  setSizePolicy(policy);
  connect(&cameras, &ViewLink::changed, this, [this] { update(); });
  connect(&placement, &PlacementController::measuredFocus, this, &SphereMap::findNearest);
  connect(&placement, &PlacementController::changed, this, &SphereMap::colour);
  colour();
}

QRectF SphereMap::frame() const {
  const double height = std::min(this->height() - 2.0 * margin, 0.5 * (width() - 2.0 * margin));
  return {0.5 * width() - height, 0.5 * (this->height() - height), 2.0 * height, height};
}

QPointF SphereMap::widgetFromDirection(glm::dvec3 direction) const {
  const glm::dvec2 at = mapFromDirection(direction);
  const QRectF box = frame();
  return box.center() + QPointF(0.25 * at.x * box.width(), -0.5 * at.y * box.height());
}

std::optional<glm::dvec3> SphereMap::directionFromWidget(QPointF position) const {
  const QRectF box = frame();
  const QPointF offset = position - box.center();
  return directionFromMap({4.0 * offset.x() / box.width(), -2.0 * offset.y() / box.height()});
}

void SphereMap::findNearest() {
  const placement::Measured& measured = *placement_.measured();
  nearest_.assign(static_cast<std::size_t>(mapSize.width() * mapSize.height()), -1);
  for (int y = 0; y < mapSize.height(); ++y)
    for (int x = 0; x < mapSize.width(); ++x) {
      // Pixels outside the ellipse get the colour of its rim, so that smooth scaling mixes in no other colour.
      glm::dvec2 at(4.0 * (x + 0.5) / mapSize.width() - 2.0, 1.0 - 2.0 * (y + 0.5) / mapSize.height());
      at /= std::max(1.0, glm::length(glm::dvec2(0.5 * at.x, at.y)) * (1.0 + 1e-9));
      const std::optional<glm::dvec3> direction = directionFromMap(at);
      double greatest = -2.0;
      int& nearest = nearest_[static_cast<std::size_t>(y * mapSize.width() + x)];
      for (std::size_t i = 0; direction && i < measured.spread; ++i) {
        const double cosine = glm::dot(measured.candidates[i].direction, *direction);
        if (cosine <= greatest) continue;
        greatest = cosine;
        nearest = static_cast<int>(i);
      }
    }
}

void SphereMap::colour() {
  picture_ = {};
  setEnabled(placement_.canPlace());
  update();
  const placement::Measured* measured = placement_.measured();
  if (!measured) return;
  std::vector<double> qualities;
  for (std::size_t i = 0; i < measured->spread; ++i)
    qualities.push_back(placement::worth(measured->candidates[i].descriptors, placement_.settings().options));
  const auto [least, greatest] = std::minmax_element(qualities.begin(), qualities.end());
  const double span = std::max(*greatest - *least, 1e-12);
  picture_ = QImage(mapSize, QImage::Format_RGB32);
  for (int y = 0; y < mapSize.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(picture_.scanLine(y));
    for (int x = 0; x < mapSize.width(); ++x) {
      const int candidate = nearest_[static_cast<std::size_t>(y * mapSize.width() + x)];
      line[x] = rampColour((qualities[static_cast<std::size_t>(std::max(candidate, 0))] - *least) / span);
    }
  }
}

void SphereMap::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF box = frame();
  QPainterPath ellipse;
  ellipse.addEllipse(box);
  painter.fillPath(ellipse, palette().base());
  if (!picture_.isNull()) {
    painter.save();
    painter.setClipPath(ellipse);
    painter.drawImage(box, picture_);
    painter.restore();
  }
  painter.setPen(QPen(palette().color(QPalette::Light), 1.0));
  painter.drawPath(ellipse);

  struct Side {
    char letter;
    glm::dvec3 direction;
  };
  for (const Side& side : {Side{'A', {0, -1, 0}}, Side{'R', {-1, 0, 0}}, Side{'L', {1, 0, 0}}, Side{'S', {0, 0, 1}},
                           Side{'I', {0, 0, -1}}, Side{'P', {1e-9, 1, 0}}, Side{'P', {-1e-9, 1, 0}}}) {
    const QPointF at = widgetFromDirection(side.direction);
    drawText(painter, QRectF(at - QPointF(8, 8), QSizeF(16, 16)), Qt::AlignCenter, QString(QLatin1Char(side.letter)),
             QColor(205, 210, 216));
  }
  if (!isEnabled()) return;
  QFont small = font();
  small.setPointSizeF(0.85 * small.pointSizeF());
  small.setBold(true);
  painter.setFont(small);
  // C1 is drawn last, on top where both are at one place.
  for (int view = ViewLink::count - 1; view >= 0; --view) {
    constexpr double radius = 7.5;
    const QPointF at = widgetFromDirection(directionOf(cameras_.camera(view)));
    painter.setPen(QPen(Qt::black, 1.0));
    painter.setBrush(view == 0 ? QColor(250, 250, 250) : QColor(150, 205, 250));
    painter.drawEllipse(at, radius, radius);
    painter.drawText(QRectF(at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)), Qt::AlignCenter,
                     QString::number(view + 1));
  }
}

void SphereMap::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (const std::optional<glm::dvec3> direction = directionFromWidget(event->position())) Q_EMIT clicked(*direction);
}

}  // namespace fenestra::viewer
