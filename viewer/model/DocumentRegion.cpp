// The region in the focus: its seeds, its growths and its tolerance.

#include <algorithm>
#include <utility>

#include "viewer/model/Document.h"

namespace fenestra::viewer {
namespace {

/// Bytes that the growths of regions may hold together, one for each voxel; the latest stays whatever its size.
constexpr std::size_t mostGrownBytes = std::size_t{256} << 20;
/// A corrected region that has grown by no more than this factor is still the one that showed.
constexpr double mostRefinedGrowth = 1.1;

/// A first part that is a layer of slices: it shows an outline there, but no structure in 3-D.
bool isLayer(const segmentation::Growth& part) {
  const glm::ivec3 dims = part.box.dims(), all = part.steps->grid.dims;
  return dims.x == all.x && dims.y == all.y && 2 * dims.z < std::min(dims.x, dims.y);
}

}  // namespace

const Document::Grown* Document::whole() const {
  const RegionFocus* wanted = region();
  if (!wanted) return nullptr;
  for (const Grown& each : grown_)
    if (segmentation::haveSameSeeds(each.seeds, *wanted)) return &each;
  return nullptr;
}

const segmentation::Growth* Document::growth() const {
  if (const Grown* grown = whole()) return grown->growth.get();
  const RegionFocus* wanted = region();
  return wanted && preview_.growth && segmentation::haveSameSeeds(preview_.seeds, *wanted) ? preview_.growth.get()
                                                                                           : nullptr;
}

bool Document::showsGrowth() const { return isWhole() ? !asksToOpen() : growth() && showsPreview_; }

std::optional<Document::Doubt> Document::doubt() const {
  if (!isWhole() || !region()->painted.empty()) return std::nullopt;
  const bool isOpened = std::any_of(opened_.begin(), opened_.end(), [&](const RegionFocus& each) {
    return segmentation::haveSameSeeds(each, *region());
  });
  if (isOpened) return std::nullopt;
  if (regionShareOfBody().value_or(0.0) > segmentation::largeShareOfBody) return Doubt::Share;
  // A tolerance or a ball of the user's own is what was meant.
  if (region()->tolerance || region()->ball > 0.0) return std::nullopt;
  const std::optional<segmentation::RegionFacts> facts = regionFacts();
  return facts && facts->border == segmentation::Border::Doubtful ? std::optional(Doubt::Border) : std::nullopt;
}

void Document::openToRegion() {
  if (!asksToOpen()) return;
  opened_.push_back(*region());
  const bool showsOther = updateDrawn();
  Q_EMIT focusChanged();
  if (showsOther) Q_EMIT sceneChanged();
}

std::optional<segmentation::RegionFacts> Document::regionFacts() const {
  const Grown* grown = whole();
  return grown && grown->facts ? std::optional(grown->facts->at(*grown->growth, regionStep())) : std::nullopt;
}

void Document::setGrowth(const RegionFocus& seeds, Growing grown) {
  const bool isPart = !grown.facts;
  if (isPart) {
    showsPreview_ = std::holds_alternative<std::monostate>(study_.drawn.focus()) && !isLayer(*grown.growth);
    preview_ = {std::move(grown), seeds};
  } else {
    preview_ = {};
    // A correction of a large region that shows is no reason to ask once more.
    const bool refines = !opened_.empty() && opened_.back().origin() == seeds.origin() &&
                         grown.growth->curve.volume[static_cast<std::size_t>(grown.growth->stepOf(seeds))] <=
                             mostRefinedGrowth * openedVolume_;
    if (refines) opened_.push_back(seeds);
    grown_.push_back({std::move(grown), seeds});
    limitGrown();
  }
  if (!region() || !segmentation::haveSameSeeds(seeds, *region())) return;
  bool showsOther = false;
  if (!isPart && std::exchange(showsPreview_, false) && asksToOpen()) {
    // Nothing was in focus before the first part, and nothing is until the user has answered.
    SetScene without = study_.scene;
    without.look.focus = std::monostate{};
    study_.drawn.update(without, nullptr);
    showsOther = true;
  }
  showsOther |= updateDrawn();
  Q_EMIT focusChanged();
  if (showsOther) Q_EMIT sceneChanged();
}

void Document::limitGrown() {
  const auto bytes = [this] {
    std::size_t sum = 0;
    for (const Grown& each : grown_) sum += each.growth->steps->voxels.byteCount();
    return sum;
  };
  while (grown_.size() > 1 && bytes() > mostGrownBytes) grown_.erase(grown_.begin());
}

void Document::growFrom(glm::dvec3 world, double ball) {
  Look changed = look();
  changed.focus = RegionFocus{{world}, {}, {}, {}, RegionRule::Tissues, ball};
  edit(tr("Region"), std::move(changed));
}

void Document::setBall(double radius) {
  if (!region() || region()->inside.empty() || region()->ball == radius) return;
  Look changed = look();
  std::get<RegionFocus>(changed.focus).ball = radius;
  edit(tr("Size of the region"), std::move(changed));
}

void Document::addSeed(glm::dvec3 world, bool inside) {
  if (!region()) return growFrom(world);
  Look changed = look();
  auto& seeds = std::get<RegionFocus>(changed.focus);
  (inside ? seeds.inside : seeds.outside).push_back(world);
  edit(inside ? tr("Add to the region") : tr("Take away from the region"), std::move(changed));
}

void Document::paintSelection(SelectionStroke stroke) {
  if (!region() && !stroke.adds) return;
  const bool adds = stroke.adds;
  Look changed = look();
  if (!region()) changed.focus = RegionFocus{};
  std::get<RegionFocus>(changed.focus).painted.push_back(std::move(stroke));
  edit(adds ? tr("Paint the region") : tr("Erase from the region"), std::move(changed));
}

std::optional<std::pair<RegionFocus, std::shared_ptr<const segmentation::Growth>>> Document::grownBefore(
    const RegionFocus& wanted) const {
  for (auto each = grown_.rbegin(); each != grown_.rend(); ++each) {
    RegionFocus first = wanted;
    if (each->seeds.painted.size() > first.painted.size()) continue;
    first.painted.resize(each->seeds.painted.size());
    if (segmentation::haveSameSeeds(first, each->seeds)) return std::pair(each->seeds, each->growth);
  }
  return std::nullopt;
}

void Document::setTolerance(std::optional<double> tolerance) {
  if (!region() || region()->tolerance == tolerance) return;
  Look changed = look();
  std::get<RegionFocus>(changed.focus).tolerance = tolerance;
  edit(tr("Tolerance"), std::move(changed));
}

void Document::moveTolerance(int steps) {
  if (!growth()) return;
  const int now = regionStep(), wanted = std::clamp(now + steps, 1, segmentation::stepCount);
  if (wanted != now) setTolerance(growth()->toleranceOf(wanted));
}

}  // namespace fenestra::viewer
