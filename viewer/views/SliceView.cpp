#include "viewer/views/SliceView.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rendering/volume/Outline.h"
#include "viewer/model/OpeningEdge.h"
#include "viewer/model/SlicePlanes.h"
#include "viewer/model/Workspace.h"
#include "viewer/style/FocusRing.h"
#include "viewer/style/Overlay.h"
#include "viewer/tools/Canvas.h"

namespace fenestra::viewer {
namespace {

/// Share of the label's colour in a tinted pixel.
constexpr int tintPercent = 25, focusTintPercent = 45;

QRgb blend(int grey, glm::dvec3 colour, int percent) {
  const auto channel = [&](double value) {
    return (grey * (100 - percent) + static_cast<int>(255.0 * value) * percent) / 100;
  };
  return qRgb(channel(colour.r), channel(colour.g), channel(colour.b));
}

/// Turns pixels whose centres are whole numbers into pixels from the picture's corner.
QList<QPolygonF> polygonsOf(const std::vector<std::vector<glm::dvec2>>& loops) {
  QList<QPolygonF> polygons;
  for (const std::vector<glm::dvec2>& loop : loops) {
    QPolygonF& line = polygons.emplace_back();
    for (const glm::dvec2 point : loop) line << QPointF(point.x + 0.5, point.y + 0.5);
  }
  return polygons;
}

}  // namespace

SliceView::SliceView(SlicePlane plane, Workspace& workspace, OpeningEdge& opening, QWidget* parent)
    : QWidget(parent),
      document_(workspace.document),
      cursor_(workspace.cursor),
      planes_(workspace.planes),
      options_(workspace.options),
      opening_(opening),
      canvas_(makeCanvas()),
      carveTool_(workspace.carving, document_, *canvas_),
      selectionTool_(workspace.selection, document_, *canvas_),
      toleranceWheel_(document_),
      clipTool_(document_, options_, workspace.tool, *canvas_),
      ballTool_(workspace, *canvas_),
      pathTool_(workspace.path, document_, options_, *canvas_),
      measureTool_(workspace.measuring, document_, options_, *canvas_),
      planeTool_(workspace, *canvas_),
      tools_({&carveTool_, &selectionTool_, &toleranceWheel_, &clipTool_, &pathTool_, &measureTool_, &planeTool_,
              &ballTool_}) {
  geometry_.plane = plane;
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(planeName(plane));
  setProperty(FocusRing::drawnByWidget, true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setObjectName(QStringLiteral("slice%1").arg(static_cast<int>(plane)));

  connect(&document_, &Document::volumeChanged, this, &SliceView::showVolume);
  for (const auto signal : {&Document::windowChanged, &Document::focusChanged, &Document::labelSettingsChanged})
    connect(&document_, signal, this, &SliceView::invalidate);
  connect(&document_, &Document::labelsChanged, this, [this] {
    labels_.clear();
    invalidate();
  });
  connect(&options_, &ViewOptions::changed, this, &SliceView::invalidate);
  connect(&cursor_, &SliceCursor::moved, this, &SliceView::followCursor);
  connect(&planes_, &SlicePlanes::changed, this, [this](SlicePlane changed) {
    // Another plane's cut shows as a line here.
    changed == geometry_.plane ? followPlane() : update();
  });
  connect(&document_, &Document::removalsChanged, this, [this] { removedOutline_.reset(); });
  for (const auto signal : {&Document::measuresChanged, &Document::clippingChanged, &Document::removalsChanged})
    connect(&document_, signal, this, [this] { update(); });
  connect(&opening, &OpeningEdge::changed, this, [this] {
    openingOutline_.reset();
    update();
  });
  connect(&document_, &Document::focusChanged, this, [this] { setAwaits(awaits_); });
  connect(&lateness_, &Lateness::changed, this, [this] { update(); });
  const auto showTools = [this] {
    setCursor(tools_.pointer(last_));
    update();
  };
  connect(&workspace.tool, &ActiveTool::changed, this, showTools);
  connect(&workspace.measuring, &MeasureMode::changed, this, showTools);
  connect(&workspace.path, &PathMode::changed, this, showTools);
  connect(&workspace.path, &PathMode::moved, this, [this] { update(); });
  connect(&workspace.ball, &RegionBall::changed, this, [this] { update(); });
  readGeometry();
}

SliceView::~SliceView() = default;

void SliceView::setAwaits(bool awaits) {
  awaits_ = awaits;
  lateness_.setBehind(awaits_ || document_.awaitsGrowth());
}

void SliceView::showVolume() {
  tools_.abandon();
  toolTookPress_ = false;
  beforeClick_.reset();
  windowAtPress_ = document_.window();
  pressed_ = last_;
  dragging_ = true;  // so that a release that follows is no click
  turn_ = {};
  readGeometry();
}

void SliceView::readGeometry() {
  forgetSlice();
  if (!document_.hasVolume()) return update();
  geometry_ = planes_.geometry(geometry_.plane);
  fitted_ = {geometry_.width * glm::length(geometry_.right), geometry_.height * glm::length(geometry_.down)};
  zoom_ = 1.0;
  centre_ = {0.5 * geometry_.width * glm::length(geometry_.right),
             0.5 * geometry_.height * glm::length(geometry_.down)};
  slice_ = cursor_.slice(geometry_);
  preparePicture();
  invalidate();
}

void SliceView::forgetSlice() {
  openingOutline_.reset();
  removedOutline_.reset();
  values_.clear();
  grey_.clear();
  labels_.clear();
  steps_ = {};
  awaited_ = {};
  image_ = {};
}

void SliceView::setGeometry(const SliceGeometry& geometry, glm::dvec3 kept) {
  const QPointF before = widgetFromWorld(kept);
  geometry_ = geometry;
  slice_ = cursor_.slice(geometry_);
  // A view of no size has no scale.
  if (pixelsPerMm() > 0.0) centre_ += mmOfMove(widgetFromWorld(kept) - before);
}

void SliceView::followPlane() {
  if (!document_.hasVolume()) return;
  setGeometry(planes_.geometry(geometry_.plane), cursor_.position());
  preparePicture();
  update();
}

SliceView::Picture SliceView::wantedPicture() const {
  const Slab slab = planes_.pose(geometry_.plane).slab;
  if (!planes_.isTurned(geometry_.plane) || !(pixelsPerMm() > 0.0)) return {geometry_, slice_, {}, slab};
  // A turned slice costs an interpolation a pixel, so it is made of those in sight. While it moves, fewer.
  const double voxel = glm::length(geometry_.right), scale = pixelsPerMm();
  const double coarser = planes_.isMoving(geometry_.plane) ? 2.0 : 1.0;
  const double side = std::max(voxel, coarser / (scale * devicePixelRatioF()));
  const QSizeF view = sizeAlongSlice();
  const QPointF half(0.5 * view.width() / scale, 0.5 * view.height() / scale);
  // Whole pixels from the corner of geometry_, so that they stay where they are while the view is moved.
  const auto span = [side](double low, double high, double most) {
    const int first = static_cast<int>(std::floor(std::clamp(low, 0.0, most) / side));
    const int last = static_cast<int>(std::ceil(std::clamp(high, 0.0, most) / side));
    return std::pair(first, std::max(last - first, 1));
  };
  const auto [left, columns] = span(centre_.x() - half.x(), centre_.x() + half.x(), geometry_.width * voxel);
  const auto [top, rows] = span(centre_.y() - half.y(), centre_.y() + half.y(), geometry_.height * voxel);
  Picture picture{geometry_, 0, QPointF(left, top) * side, slab};
  SliceGeometry& pixels = picture.geometry;
  pixels.origin = geometry_.worldFromPixel((left + 0.5) * side / voxel - 0.5, (top + 0.5) * side / voxel - 0.5, slice_);
  pixels.right *= side / voxel;
  pixels.down *= side / voxel;
  pixels.width = columns;
  pixels.height = rows;
  pixels.count = 1;
  return picture;
}

void SliceView::preparePicture() {
  const Picture wanted = wantedPicture();
  // A millionth of a millimetre is rounding: the crosshair has moved within the slice.
  const auto same = [](glm::dvec3 a, glm::dvec3 b) { return glm::distance(a, b) < 1e-6; };
  const SliceGeometry &a = picture_.geometry, &b = wanted.geometry;
  const bool fits = picture_.slice == wanted.slice && picture_.slab == wanted.slab && a.width == b.width &&
                    a.height == b.height && same(a.origin, b.origin) &&
                    same(a.worldFromPixel(a.width, 0, 0), b.worldFromPixel(a.width, 0, 0)) &&
                    same(a.worldFromPixel(0, a.height, 0), b.worldFromPixel(0, a.height, 0));
  if (!fits) forgetSlice();
  picture_ = wanted;
}

void SliceView::followCursor() {
  if (document_.hasVolume() && planes_.isTurned(geometry_.plane)) {
    setGeometry(planes_.geometry(geometry_.plane), document_.scene().volume->grid.centre());
    preparePicture();
    update();
    return;
  }
  const int slice = cursor_.slice(geometry_);
  if (slice != slice_) {
    slice_ = slice;
    forgetSlice();
    if (document_.hasVolume()) preparePicture();
  }
  update();
}

void SliceView::invalidate() {
  image_ = {};
  update();
}

void SliceView::resetView() {
  turn_ = {};
  readGeometry();
  document_.resetWindow();
}

/// The look of each label, found once a label rather than once a pixel.
class SliceView::Tints {
 public:
  struct Tint {
    glm::dvec3 colour{0.0};
    int percent = 0;
    bool focused = false;
  };

  Tints(const Document& document, const SliceView& view) : view_(view) {
    const Scene& scene = document.scene();
    const segmentation::DrawnScene& drawn = document.study().drawn;
    if (const auto* values = std::get_if<ValueFocus>(&drawn.focus())) values_ = values->values;
    focus_ = {drawn.showsRegion() ? segmentation::regionColour : scene.look.focusAppearance.colour, focusTintPercent,
              true};
    const auto* focused = std::get_if<LabelFocus>(&drawn.focus());
    if (focused && drawn.showsRegion()) lastStep_ = focused->labels.back();
    if (view.labels_.empty()) return;
    labels_.resize(std::size_t{1} + *std::max_element(view.labels_.begin(), view.labels_.end()));
    for (const Label& label : document.labels()->labels) {
      if (label.value >= labels_.size() || label.value == 0) continue;
      const LabelSetting setting = document.labelSetting(label.value);
      if (!setting.visible) continue;
      const bool isFocused = focused && !drawn.showsRegion() &&
                             std::binary_search(focused->labels.begin(), focused->labels.end(), label.value);
      const double percent = setting.opacity * (isFocused ? focusTintPercent : tintPercent);
      labels_[label.value] = {document.colourOf(label), static_cast<int>(std::lround(percent)), isFocused};
    }
  }

  const Tint& at(std::size_t pixel) const {
    static const Tint none;
    const float value = view_.values_[pixel];
    if (values_ && value >= values_->low && value <= values_->high) return focus_;
    // Makes 0, which stands for no step, greater than all steps.
    if (!view_.steps_.all.empty() && static_cast<std::uint16_t>(view_.steps_.all[pixel] - 1) < lastStep_) return focus_;
    return labels_.empty() ? none : labels_[view_.labels_[pixel]];
  }

 private:
  const SliceView& view_;
  std::vector<Tint> labels_;
  Tint focus_;
  std::optional<ValueRange> values_;
  std::uint16_t lastStep_ = 0;
};

void SliceView::makeImage() {
  const Volume& volume = *document_.scene().volume;
  const SliceGeometry& pixels = picture_.geometry;
  if (values_.empty())
    values_ = picture_.slab.thickness > 0.0 ? slabValues(volume, pixels, picture_.slice, picture_.slab)
                                            : sliceValues(volume, pixels, picture_.slice);
  if (labels_.empty() && document_.labels()) labels_ = sliceLabels(*document_.labels(), pixels, picture_.slice);
  const segmentation::DrawnScene& drawn = document_.study().drawn;
  readSteps(steps_, drawn.showsRegion() ? drawn.labels() : nullptr);
  readSteps(awaited_, document_.growth() && !document_.showsGrowth() ? document_.growth()->steps : nullptr);
  // What is in focus changes far more often than the window does: with every step of a region's tolerance.
  const GreyLevels levels{document_.window(), volume.lowIsWhite != document_.isInverted()};
  if (grey_.empty() || levels != greyLevels_) grey_ = windowed(values_, levels.window, levels.lowIsWhite);
  greyLevels_ = levels;

  const Tints tints(document_, *this);
  std::vector<char> focused(values_.size(), 0);
  image_ = QImage(picture_.geometry.width, picture_.geometry.height, QImage::Format_RGB32);
  for (int row = 0; row < picture_.geometry.height; ++row) {
    auto* line = reinterpret_cast<QRgb*>(image_.scanLine(row));
    for (int column = 0; column < picture_.geometry.width; ++column) {
      const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(picture_.geometry.width) +
                             static_cast<std::size_t>(column);
      const Tints::Tint& tint = tints.at(at);
      focused[at] = tint.focused;
      line[column] = options_.labels() && tint.percent ? blend(grey_[at], tint.colour, tint.percent)
                                                       : qRgb(grey_[at], grey_[at], grey_[at]);
    }
  }
  collectOutlines(focused);
}

void SliceView::readSteps(Steps& steps, std::shared_ptr<const LabelMap> of) const {
  if (std::exchange(steps.of, of) != of) steps.all.clear();
  if (of && steps.all.empty()) steps.all = sliceLabels(*of, picture_.geometry, picture_.slice);
}

void SliceView::collectOutlines(const std::vector<char>& focused) {
  outline_.clear();
  awaitedOutline_.clear();
  if (!options_.labels()) return;
  outline_ = polygonsOf(smoothOutlines(focused, picture_.geometry.width, picture_.geometry.height));
  if (awaited_.all.empty()) return;
  const auto last = static_cast<std::uint16_t>(document_.regionStep());
  std::vector<char> awaited(awaited_.all.size());
  std::transform(awaited_.all.begin(), awaited_.all.end(), awaited.begin(),
                 [last](std::uint16_t step) { return step != 0 && step <= last; });
  awaitedOutline_ = polygonsOf(smoothOutlines(awaited, picture_.geometry.width, picture_.geometry.height));
}

QPainterPath SliceView::openingEdge() const {
  if (!opening_.starts() || !document_.hasVolume()) return {};
  if (!openingOutline_)
    openingOutline_ = polygonsOf(smoothOutlines(openedPixels(*opening_.starts(), picture_.geometry, picture_.slice),
                                                picture_.geometry.width, picture_.geometry.height));
  QPainterPath path;
  for (const QPolygonF& line : *openingOutline_) {
    path.addPolygon(line);
    path.closeSubpath();
  }
  return widgetFromPixels().map(path);
}

const QList<QPolygonF>& SliceView::removedOutline() const {
  if (removedOutline_) return *removedOutline_;
  removedOutline_.emplace();
  const std::shared_ptr<const RemovedVoxels>& removed = document_.scene().removed;
  if (!removed) return *removedOutline_;
  std::vector<char> gone(
      static_cast<std::size_t>(picture_.geometry.width) * static_cast<std::size_t>(picture_.geometry.height), 0);
  const glm::dmat4 indexFromWorld = removed->grid.indexFromWorld();
  for (int row = 0; row < picture_.geometry.height; ++row)
    for (int column = 0; column < picture_.geometry.width; ++column) {
      const glm::dvec4 world(picture_.geometry.worldFromPixel(column, row, picture_.slice), 1.0);
      const glm::ivec3 voxel(glm::floor(glm::dvec3(indexFromWorld * world) + 0.5));
      gone[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture_.geometry.width) +
           static_cast<std::size_t>(column)] = RemovedVoxels::isGone(removed->at(voxel));
    }
  *removedOutline_ = polygonsOf(smoothOutlines(gone, picture_.geometry.width, picture_.geometry.height));
  return *removedOutline_;
}

bool SliceView::inPicture(glm::dvec3 world) const {
  const glm::dvec3 pixel = geometry_.pixelFromWorld(world);
  return pixel.x >= -0.5 && pixel.y >= -0.5 && pixel.x < geometry_.width - 0.5 && pixel.y < geometry_.height - 0.5;
}

}  // namespace fenestra::viewer
