#include "viewer/jobs/RegionGrower.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "rendering/segmentation/RegionFacts.h"

namespace fenestra::viewer {
namespace {

using segmentation::Growth;

constexpr double firstShare = 0.05;  ///< of the progress, for a first part

/// A first part that fills more than this of its box is cut by it: a ball that touches all faces fills half. Of a layer
/// of slices, a part that fills more shows no outline.
constexpr double mostOfBox = 0.5, mostOfLayer = 0.9;
/// A region that fills more than this of the volume is no structure. It would hide all else.
constexpr double mostOfVolume = 0.5;

/// The layer of slices around the first seed: a structure that fills a box around the click has an outline there. As
/// many voxels as previewBox() holds, and five slices at least, for paths as wide as a ball.
segmentation::VoxelBox layerAround(const Volume& volume, const RegionFocus& region) {
  constexpr int most = 1'400'000, leastHalf = 2;
  const glm::ivec3 dims = volume.grid.dims;
  const auto voxel = segmentation::voxelAt(volume.grid, region.inside.front());
  if (!voxel) return {};
  const int half = std::max(leastHalf, most / (dims.x * dims.y) / 2);
  return segmentation::VoxelBox{{0, 0, voxel->z - half}, {dims.x, dims.y, voxel->z + half + 1}}.clippedTo(
      segmentation::wholeOf(dims));
}

/// The share of the volume's box that a region fills.
double shareOf(const Growth& growth, const RegionFocus& region) {
  const double box = static_cast<double>(growth.box.count()) * growth.steps->grid.voxelVolume();
  return growth.curve.volume[static_cast<std::size_t>(growth.stepOf(region))] / box;
}

/// Calls `inside` with fractions that run from `begin` to `end`.
segmentation::Progress part(const io::Progress& inside, double begin, double end) {
  return
      [&inside, begin, end](double fraction) { return inside(std::lerp(begin, end, fraction), "Growing the region"); };
}

}  // namespace

RegionGrower::RegionGrower(Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document, &Document::focusChanged, this, &RegionGrower::follow);
  connect(&document, &Document::volumeChanged, this, [this] {
    memory_ = document_.takeMemory();
    follow();
  });
  connect(&job_, &LoadJob::failed, this, [this](const QString& message) {
    takeBack();
    Q_EMIT failed(message);
  });
  connect(&job_, &LoadJob::ended, this, [this] {
    if (std::exchange(starts_, false)) return start();
    // The button beside the progress cancels the job alone.
    if (wanted_ && !job_.isRunning()) takeBack();
  });
  follow();
}

void RegionGrower::follow() {
  if (!document_.awaitsGrowth()) {
    wanted_.reset();
    starts_ = false;
    job_.cancel();
    if (!document_.asksToOpen()) before_ = document_.focus();
    if (!document_.region()) memory_ = {};
    return;
  }
  if (wanted_ && segmentation::haveSameSeeds(*wanted_, *document_.region())) return;
  wanted_ = *document_.region();
  step_ = document_.undoStack().index();
  if (!job_.isRunning()) return start();
  starts_ = true;
  job_.cancel();
}

void RegionGrower::start() {
  Task task{document_.study().scene.volume, *wanted_, false, memory_, document_.grownBefore(*wanted_)};
  // A further seed changes a region that shows as a whole; a first part of it would be less than that.
  const auto* shown = std::get_if<RegionFocus>(&before_);
  task.showsPart = !task.before && (!shown || shown->origin() != wanted_->origin());
  job_.start([this, task = std::move(task)](const io::Progress& progress) -> LoadJob::Show {
    if (!segmentation::canGrow(*task.volume, task.seeds)) throw std::runtime_error(segmentation::cannotGrow);
    Document::Growing grown = grow(task, progress);
    return [this, task, grown = std::move(grown)] { finish(task, grown); };
  });
}

Document::Growing RegionGrower::grow(const Task& task, const io::Progress& progress) {
  const auto made = [&task](Growth growth) -> Document::Growing {
    auto facts = std::make_shared<const segmentation::GrowthFacts>(*task.volume, growth);
    return {std::make_shared<const Growth>(std::move(growth)), std::move(facts)};
  };
  if (task.before) {
    const auto& [first, growth] = *task.before;
    return made(*segmentation::paintedOn(*growth, first, task.seeds, *task.volume));
  }
  showPart(task, part(progress, 0.0, firstShare));
  std::optional<Growth> growth =
      segmentation::growRegion(*task.volume, task.seeds, segmentation::wholeOf(task.volume->grid.dims),
                               part(progress, firstShare, 1.0), task.memory);
  if (!growth) throw io::Cancelled();
  return made(std::move(*growth));
}

void RegionGrower::showPart(const Task& task, const segmentation::Progress& progress) {
  const segmentation::VoxelBox whole = segmentation::wholeOf(task.volume->grid.dims);
  const segmentation::VoxelBox near = segmentation::previewBox(*task.volume, task.seeds);
  if (!task.showsPart || near == whole) return;
  std::optional<Growth> growth;
  for (const auto& [box, most] :
       {std::pair(near, mostOfBox), std::pair(layerAround(*task.volume, task.seeds), mostOfLayer)}) {
    if (box.empty() || box == whole) return;
    growth = segmentation::growRegion(*task.volume, task.seeds, box, progress);
    if (!growth) throw io::Cancelled();
    if (shareOf(*growth, task.seeds) <= most) break;
    growth.reset();
  }
  if (!growth) return;
  QMetaObject::invokeMethod(
      this,
      [this, seeds = task.seeds, part = std::make_shared<const Growth>(std::move(*growth))] {
        if (wanted_ && segmentation::haveSameSeeds(*wanted_, seeds) && document_.awaitsGrowth())
          document_.setGrowth(seeds, {part, nullptr});
      },
      Qt::QueuedConnection);
}

QString RegionGrower::problemOf(const Task& task, const Growth& growth) const {
  const RegionFocus* asked = document_.region();
  if (!asked) return {};
  const double share = shareOf(growth, *asked);
  if (share == 0.0)
    return asked->painted.empty() ? tr("No region grows from there; click elsewhere.")
                                  : tr("Nothing would be left of the region; it stays as it was.");
  const auto* shown = std::get_if<RegionFocus>(&before_);
  const bool isNew = !shown || shown->origin() != asked->origin();
  if (!isNew || !asked->painted.empty() || asked->tolerance || share <= mostOfVolume) return {};
  const auto voxel = segmentation::voxelAt(task.volume->grid, asked->inside.front());
  if (voxel && segmentation::isAir(*task.volume, *voxel))
    return tr("That is air, which fills more than half of the volume; click a structure.");
  return tr(
      "No border holds the region there: it would fill more than half of the volume. Drag a ball around the "
      "structure (Shift+drag), or click elsewhere.");
}

void RegionGrower::finish(const Task& task, Document::Growing grown) {
  const QString problem = problemOf(task, *grown.growth);
  if (problem.isEmpty()) return document_.setGrowth(task.seeds, std::move(grown));
  takeBack();
  Q_EMIT failed(problem);
}

void RegionGrower::cancel() {
  job_.cancel();
  if (document_.asksToOpen()) wanted_ = *document_.region();
  takeBack();
}

void RegionGrower::takeBack() {
  if (!std::exchange(wanted_, std::nullopt)) return;
  starts_ = false;
  if (document_.undoStack().index() == step_ + 1)
    document_.history().takeBack();
  else
    document_.setFocus(before_);
}

}  // namespace fenestra::viewer
