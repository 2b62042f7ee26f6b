// Which places of the volume a 3-D view shows where, for the mouse and the tools.

#include <algorithm>
#include <cmath>

#include "rendering/Renderer.h"
#include "rendering/scene/SeenPoint.h"
#include "viewer/model/Document.h"
#include "viewer/tools/Canvas.h"
#include "viewer/views/PictureSurface.h"
#include "viewer/views/RefinedPicture.h"
#include "viewer/views/VolumeView.h"

namespace fenestra::viewer {

class VolumeView::ToolCanvas : public PictureCanvas {
 public:
  explicit ToolCanvas(VolumeView& view) : view_(view) {}

  std::optional<QPointF> widgetFromWorld(glm::dvec3 world) const override { return view_.widgetFromWorld(world); }
  Camera::Axes axes() const override { return view_.shownCamera().axes(); }
  Camera::Axes axesAt(glm::dvec3 world) const override {
    Camera::Axes axes = this->axes();
    const std::optional<QPointF> place = view_.picture_ ? widgetFromWorld(world) : std::nullopt;
    if (place) axes.forward = view_.rayThrough(*place);
    return axes;
  }
  std::optional<glm::dvec3> pickSurface(QPointF position) const override {
    const std::optional<Hit> hit = view_.pick(position);
    return hit ? std::optional(hit->start) : std::nullopt;
  }
  std::optional<glm::dvec3> pickVoxel(QPointF position) const override {
    const std::optional<Hit> hit = view_.pick(position);
    return hit ? std::optional(view_.surfaceAt(*hit)) : std::nullopt;
  }
  std::optional<glm::dvec3> pickStructure(QPointF position) const override {
    const std::optional<Hit> hit = view_.pick(position);
    return hit ? std::optional(view_.seenAt(*hit)) : std::nullopt;
  }
  void redraw() const override { view_.repaintSurface(); }

  int camera() const override { return view_.index_; }
  std::optional<BrushPoint> pickBrush(QPointF position, BrushMode mode,
                                      std::optional<glm::dvec3> before) const override {
    std::optional<BrushPoint> point;
    view_.attemptOnPicture([&] { point = view_.picture_->shown().pickBrush(view_.pixelAt(position), mode, before); });
    return point;
  }
  std::vector<std::uint8_t> picture() const override {
    std::vector<std::uint8_t> picture;
    view_.attemptOnPicture([&] {
      RefinedPicture& drawn = *view_.picture_;
      drawn.draw(view_.shownScene(), view_.viewFor(view_.shared_.pacer->atRest()), true);
      view_.surface_->take(drawn.shown());
      picture = drawn.shown().readPicture();
    });
    return picture;
  }

 private:
  VolumeView& view_;
};

std::unique_ptr<PictureCanvas> VolumeView::makeCanvas() { return std::make_unique<ToolCanvas>(*this); }

std::optional<QPointF> VolumeView::widgetFromWorld(glm::dvec3 world) const {
  return widgetFromWorld(world, shownCamera());
}

std::optional<QPointF> VolumeView::widgetFromWorld(glm::dvec3 world, const Camera& camera) const {
  if (!document_.hasVolume()) return std::nullopt;
  const double aspect = static_cast<double>(width()) / std::max(1, height());
  const glm::dvec4 clip = camera.clipFromWorld(aspect, document_.scene().volume->grid) * glm::dvec4(world, 1.0);
  if (!(clip.w > 0.0)) return std::nullopt;
  return QPointF(0.5 * (clip.x / clip.w + 1.0) * width(), 0.5 * (1.0 - clip.y / clip.w) * height());
}

glm::dvec3 VolumeView::shownAt(glm::dvec3 world) const {
  return picture_ && picture_->isShown() ? picture_->shown().shownAt(world) : world;
}

glm::dvec2 VolumeView::pixelAt(QPointF position) const {
  const glm::ivec2 size = picture_->shownView().size;
  return {position.x() / width() * size.x, position.y() / height() * size.y};
}

std::optional<VolumeView::Hit> VolumeView::pick(QPointF position) {
  std::optional<Hit> hit;
  attemptOnPicture([&] {
    Renderer& picture = picture_->shown();
    const std::optional<PickedPlace> picked = picture.pickPlace(pixelAt(position));
    if (!picked) return;
    const std::optional<BrushPoint> opened = picture.pickBrush(pixelAt(position), BrushMode::Open);
    const bool moved = picture.movesContext();
    hit = Hit{picked->place, moved ? picked->ray : rayThrough(position), opened ? opened->removed : 0.0, moved};
  });
  return hit;
}

glm::dvec3 VolumeView::seenAt(const Hit& hit) const {
  if (hit.moved) return surfaceAt(hit);  // behind the moved part, the ray crosses other places of the volume
  return seenPoint(shownScene(), hit.start, hit.ray, hit.removed).value_or(hit.start + halfVoxel() * hit.ray);
}

glm::dvec3 VolumeView::surfaceAt(const Hit& hit) const {
  const glm::dvec3 seen = hit.removed > 0.0 ? seenAt(hit) : hit.start;
  // The start lies on the surface between two voxels; the voxel that is seen lies half a voxel further along the ray.
  return glm::dot(seen - hit.start, hit.ray) < 0.0 ? seen : hit.start + halfVoxel() * hit.ray;
}

double VolumeView::halfVoxel() const {
  const glm::dvec3 spacing = document_.scene().volume->grid.spacing;
  return 0.5 * std::min({spacing.x, spacing.y, spacing.z});
}

glm::dvec3 VolumeView::rayThrough(QPointF position) const {
  const Camera camera = picture_->shownView().camera;
  const Camera::Axes axes = camera.axes();
  if (camera.projection == Projection::Orthographic) return axes.forward;
  const double slope = std::tan(0.5 * glm::radians(camera.verticalFov));
  const glm::dvec2 offset(position.x() - 0.5 * width(), 0.5 * height() - position.y());
  return glm::normalize(axes.forward + 2.0 * slope / height() * (offset.x * axes.right + offset.y * axes.up));
}

double VolumeView::mmPerPixel(const Camera& camera) const {
  const double seen =
      camera.projection == Projection::Orthographic
          ? camera.orthographicHeight
          : 2.0 * glm::distance(camera.eye, camera.target) * std::tan(glm::radians(camera.verticalFov) * 0.5);
  return seen / std::max(1, height());
}

}  // namespace fenestra::viewer
