#include "viewer/style/InterpolatedPlanes.h"

#include <algorithm>
#include <cmath>

#include <QTransform>

namespace fenestra::viewer {
namespace {

/// The index axis along which the planes are counted.
constexpr int planeAxis = 2;

/// A picture's position where the planes' axis has the index `plane`, at the middle of the other two axes.
glm::dvec3 pixelAt(double plane, const Grid& grid, const SliceGeometry& geometry) {
  glm::dvec3 index = 0.5 * glm::dvec3(grid.dims - 1);
  index[planeAxis] = plane;
  return geometry.pixelFromWorld(glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0)));
}

}  // namespace

bool isInterpolated(const std::vector<int>& planes, const Grid& grid, const SliceGeometry& geometry, int slice) {
  return geometry.axis == planeAxis && std::any_of(planes.begin(), planes.end(), [&](int plane) {
           return std::lround(pixelAt(plane, grid, geometry).z) == slice;
         });
}

std::vector<QRectF> interpolatedBands(const std::vector<int>& planes, const Grid& grid, const SliceGeometry& geometry,
                                      int slice) {
  const QRectF picture(0, 0, geometry.width, geometry.height);
  if (isInterpolated(planes, grid, geometry, slice)) return {picture};
  std::vector<QRectF> bands;
  if (geometry.axis == planeAxis) return bands;
  for (std::size_t i = 0; i < planes.size();) {
    std::size_t end = i + 1;
    while (end < planes.size() && planes[end] == planes[end - 1] + 1) ++end;
    const glm::dvec3 from = pixelAt(planes[i] - 0.5, grid, geometry) + 0.5,
                     to = pixelAt(planes[end - 1] + 0.5, grid, geometry) + 0.5;
    // The planes run along the picture's rows or its columns.
    const bool rows = std::abs(to.y - from.y) > std::abs(to.x - from.x);
    const QRectF band = rows ? QRectF(QPointF(0, from.y), QPointF(geometry.width, to.y))
                             : QRectF(QPointF(from.x, 0), QPointF(to.x, geometry.height));
    bands.push_back(band.normalized().intersected(picture));
    i = end;
  }
  return bands;
}

void drawInterpolatedBands(QPainter& painter, const std::vector<QRectF>& bands, const QTransform& widgetFromPixel) {
  constexpr double thickness = 4.0;  // device-independent pixels
  const QColor amber(255, 176, 32);
  painter.save();
  painter.setPen(Qt::NoPen);
  painter.setBrush(amber);
  for (const QRectF& pixels : bands) {
    const QRectF band = widgetFromPixel.mapRect(pixels);
    if (band.width() >= band.height()) {
      painter.drawRect(QRectF(band.left(), band.top(), thickness, band.height()));
      painter.drawRect(QRectF(band.right() - thickness, band.top(), thickness, band.height()));
    }
    if (band.height() >= band.width()) {
      painter.drawRect(QRectF(band.left(), band.top(), band.width(), thickness));
      painter.drawRect(QRectF(band.left(), band.bottom() - thickness, band.width(), thickness));
    }
  }
  painter.restore();
}

}  // namespace fenestra::viewer
