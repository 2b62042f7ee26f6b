#include "viewer/jobs/RegionGrower.h"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "rendering/segmentation/RegionGrowing.h"
#include "viewer/model/Document.h"

namespace fenestra::viewer {
namespace {

using segmentation::Growth;

constexpr double firstShare = 0.05;  ///< of the progress, for a first part

/// A first part that fills more than this of its box shows no structure.
constexpr double mostOfPart = 0.9;
/// A region that fills more than this of the volume is what surrounds a body. It would hide all else.
constexpr double mostOfVolume = 0.5;

/// The share of the volume's box that a region fills.
double shareOf(const Growth& growth, const RegionFocus& region) {
  const double box = static_cast<double>(growth.box.count()) * growth.steps->grid.voxelVolume();
  return growth.curve.volume[static_cast<std::size_t>(growth.stepOf(region))] / box;
}

std::shared_ptr<const Growth> grow(const Volume& volume, const RegionFocus& seeds, const segmentation::VoxelBox& reach,
                                   const segmentation::Progress& progress) {
  std::optional<Growth> growth = segmentation::growRegion(volume, seeds, reach, progress);
  if (!growth) throw io::Cancelled();
  return std::make_shared<const Growth>(std::move(*growth));
}

/// A region that was grown, with more strokes over it.
std::shared_ptr<const Growth> paint(const std::pair<RegionFocus, std::shared_ptr<const Growth>>& before,
                                    const RegionFocus& wanted, const Volume& volume) {
  return std::make_shared<const Growth>(*segmentation::paintedOn(*before.second, before.first, wanted, volume));
}

}  // namespace

RegionGrower::RegionGrower(Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document, &Document::focusChanged, this, &RegionGrower::follow);
  connect(&document, &Document::volumeChanged, this, &RegionGrower::follow);
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
    before_ = document_.focus();
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
  // A further seed changes a region that shows as a whole; a first part of it would be less than that.
  const bool isNew =
      !std::holds_alternative<RegionFocus>(before_) || std::get<RegionFocus>(before_).origin() != wanted_->origin();
  job_.start([this, seeds = *wanted_, volume = document_.study().scene.volume, before = document_.grownBefore(*wanted_),
              isNew](const io::Progress& progress) -> LoadJob::Show {
    const auto onward = [&](double begin, double end) -> segmentation::Progress {
      return [&progress, begin, end](double fraction) {
        return progress(std::lerp(begin, end, fraction), "Growing the region");
      };
    };
    if (!segmentation::canGrow(*volume, seeds)) throw std::runtime_error(segmentation::cannotGrow);
    const segmentation::VoxelBox near = segmentation::previewBox(*volume, seeds);
    const segmentation::VoxelBox whole = segmentation::wholeOf(volume->grid.dims);
    if (isNew && near != whole && !before) {
      const auto part = grow(*volume, seeds, near, onward(0.0, firstShare));
      const bool shows = shareOf(*part, seeds) <= mostOfPart;
      if (shows)
        QMetaObject::invokeMethod(
            this,
            [this, seeds, part] {
              if (wanted_ && segmentation::haveSameSeeds(*wanted_, seeds) && document_.awaitsGrowth())
                document_.setGrowth(seeds, part, false);
            },
            Qt::QueuedConnection);
    }
    const auto growth = before ? paint(*before, seeds, *volume) : grow(*volume, seeds, whole, onward(firstShare, 1.0));
    return [this, seeds, isNew, growth] {
      const RegionFocus* asked = document_.region();
      const double share = asked ? shareOf(*growth, *asked) : 0.0;
      QString problem;
      const bool isPainted = asked && !asked->painted.empty();
      if (asked && share == 0.0)
        problem = isPainted ? tr("Nothing would be left of the region; it stays as it was.")
                            : tr("No region grows from there; click elsewhere.");
      if (asked && isNew && !isPainted && !asked->tolerance && share > mostOfVolume)
        problem =
            tr("The region there fills more than half of the volume, like the air around a body; click a structure.");
      if (problem.isEmpty()) return document_.setGrowth(seeds, growth, true);
      takeBack();
      Q_EMIT failed(problem);
    };
  });
}

void RegionGrower::cancel() {
  job_.cancel();
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
