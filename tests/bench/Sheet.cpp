#include "tests/bench/Sheet.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include <QImage>
#include <QPainter>

#include "rendering/Renderer.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/placement/Placer.h"
#include "rendering/scene/VisibleFraming.h"

namespace fenestra::bench {
namespace {

namespace fs = std::filesystem;

constexpr int gap = 6;                        ///< pixels between cells
constexpr int margin = 24;                    ///< pixels for captions
constexpr int finer = 3;                      ///< times finer is what is rendered and then averaged
constexpr double methodPictureWidth = 700.0;  ///< the method's pictures, which w_open of 24 px refers to

/// The side of the patient (LPS) that a camera looks at. A layer is peeled off a side whatever the camera does, so each
/// row has it peeled off there.
PeelSide sideTowards(const Camera& camera) {
  const glm::dvec3 towards = camera.eye - camera.target, size = glm::abs(towards);
  if (size.z > std::max(size.x, size.y)) return towards.z > 0.0 ? PeelSide::Superior : PeelSide::Inferior;
  if (size.x > size.y) return towards.x > 0.0 ? PeelSide::Left : PeelSide::Right;
  return towards.y > 0.0 ? PeelSide::Posterior : PeelSide::Anterior;
}

/// How a cell is drawn, but for its camera.
View finely(const io::Study& study, const Sheet& sheet) {
  View view = *study.view;
  view.size = finer * glm::ivec2(sheet.cell.width(), sheet.cell.height());
  view.pixelScale = view.size.x / methodPictureWidth;
  view.quality = Quality::High;
  return view;
}

QImage pictureOf(Renderer& renderer, const Scene& scene, const View& view) {
  renderer.render(scene, view);
  const std::vector<std::uint8_t> pixels = renderer.readPicture();
  return QImage(pixels.data(), view.size.x, view.size.y, 4 * view.size.x, QImage::Format_RGBX8888).copy();
}

/// One row's pictures, from left to right.
std::vector<QImage> drawn(const Row& row, const Sheet& sheet) {
  const bool hasBoth =
      std::any_of(sheet.columns.begin(), sheet.columns.end(), [](const Column& column) { return !column.startsPlain; });
  io::StudyRequest plainly = row.options;
  if (hasBoth) {
    plainly.makePlain();
    plainly.look.background = row.options.look.background;
  }
  const io::Study study = io::readStudy(plainly), starting = hasBoth ? io::readStudy(row.options) : study;
  View view = finely(study, sheet);
  view.camera = view.camera.zoomed(row.zoom).panned(0.0, row.raise);
  Renderer renderer(std::make_shared<GpuScene>());
  std::vector<QImage> pictures;
  for (const Column& column : sheet.columns) {
    Scene scene = (column.startsPlain ? study : starting).drawn.scene();
    column.apply(scene.look);
    scene.look.method.of<methods::Peel>().side = sideTowards(view.camera);
    pictures.push_back(pictureOf(renderer, scene, view));
  }
  return pictures;
}

/// C1, then C2 in the half sphere and in the band around it, in the paper's order: first C1, then C2.
std::vector<QImage> drawnPlaced(const Row& row, const Sheet& sheet) {
  const io::Study study = io::readStudy(row.options);
  Scene scene = study.drawn.scene();
  sheet.columns.back().apply(scene.look);
  const auto gpu = std::make_shared<GpuScene>();
  gpu->update(scene);
  placement::Options options;
  placement::Placer placer;
  const placement::Measured& measured = placer.measure(*gpu, scene, {}, options);
  const placement::Placement halfSphere = choose(measured, options, false);
  options.region = placement::Region::Stream;
  const placement::Placement band = choose(measured, options, false);
  const Framing framing = visibleFraming(shownVolume(scene), scene.look.context.shifted());
  View view = finely(study, sheet);
  Renderer renderer(gpu);
  std::vector<QImage> pictures;
  for (const std::optional<std::size_t> index : {halfSphere.c1, halfSphere.c2, band.c2}) {
    view.camera = Camera::fromDirection(measured.candidates[index.value()].direction, framing, Projection::Perspective)
                      .zoomed(row.zoom);
    pictures.push_back(pictureOf(renderer, scene, view));
  }
  return pictures;
}

void save(const QImage& image, const fs::path& path) {
  if (!image.save(QString::fromStdString(path.string())))
    throw std::runtime_error(path.string() + ": cannot be written");
}

/// The cells of a sheet, from left to right and from top to bottom; each picture also goes into the folder.
class Page {
 public:
  Page(const Sheet& sheet, fs::path folder)
      : cell_(sheet.cell),
        edge_(sheet.hasCaptions ? margin : 0),
        folder_(std::move(folder)),
        image_(left(static_cast<int>(sheet.columns.size())) - gap,
               top(static_cast<int>(sheet.rows.size()) + (sheet.placed.empty() ? 0 : 1)) - gap, QImage::Format_RGB888) {
    image_.fill(Qt::white);
    painter_.begin(&image_);
    painter_.setPen(Qt::black);
    if (edge_ == 0) return;
    for (std::size_t c = 0; c < sheet.columns.size(); ++c)
      painter_.drawText(QRect(left(static_cast<int>(c)), 0, cell_.width(), edge_), Qt::AlignCenter,
                        QString::fromStdString(sheet.columns[c].caption));
  }
  void add(const QImage& picture, const std::string& name) {
    painter_.drawImage(QRect(QPoint(left(column_++), top(row_)), cell_),
                       picture.scaled(cell_, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    if (!folder_.empty()) save(picture, folder_ / (name + ".png"));
  }
  void endRow(const std::string& caption) {
    if (edge_ > 0) {
      painter_.save();
      painter_.translate(0, top(row_) + cell_.height());
      painter_.rotate(-90.0);
      painter_.drawText(QRect(0, 0, cell_.height(), edge_), Qt::AlignCenter, QString::fromStdString(caption));
      painter_.restore();
    }
    ++row_;
    column_ = 0;
  }
  QImage take() {
    painter_.end();
    return image_;
  }

 private:
  int left(int column) const { return edge_ + column * (cell_.width() + gap); }
  int top(int row) const { return edge_ + row * (cell_.height() + gap); }

  QSize cell_;
  int edge_, row_ = 0, column_ = 0;
  fs::path folder_;
  QImage image_;
  QPainter painter_;
};

}  // namespace

void draw(const Sheet& sheet, const fs::path& output, const fs::path& folder) {
  const egl::EglContext context;
  Page page(sheet, folder);
  for (const Row& row : sheet.rows) {
    const std::vector<QImage> pictures = drawn(row, sheet);
    for (std::size_t c = 0; c < pictures.size(); ++c) page.add(pictures[c], row.name + "-" + sheet.columns[c].name);
    page.endRow(row.caption);
  }
  for (const Row& row : sheet.placed) {
    const std::vector<QImage> pictures = drawnPlaced(row, sheet);
    const char* const names[] = {"c1", "c2-half-sphere", "c2-band"};
    for (std::size_t c = 0; c < pictures.size(); ++c) page.add(pictures[c], row.name + "-" + names[c]);
  }
  save(page.take(), output);
}

}  // namespace fenestra::bench
