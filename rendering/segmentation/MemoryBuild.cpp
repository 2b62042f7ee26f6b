#include "rendering/segmentation/MemoryBuild.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace fenestra::segmentation {
namespace {

constexpr std::size_t mostForBones = 200'000'000;  ///< voxels: in larger volumes the search would take too long

bool mayHaveBones(const Volume& volume) { return volume.grid.voxelCount() <= mostForBones; }

}  // namespace

MemoryBuild::MemoryBuild(const Volume& volume, const GrowthMemory& memory, std::vector<glm::ivec3> seeds)
    : memory_(memory), seeds_(std::move(seeds)) {
  if (!memory.tissues() || lacksBones(volume))
    built_ = std::async(std::launch::async, [this, &volume] { build(volume); });
}

bool MemoryBuild::wait(const std::function<bool()>& goOn) {
  if (!built_.valid()) return true;
  while (built_.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
    if (!goOn()) return false;
  built_.get();
  return true;
}

bool MemoryBuild::lacksBones(const Volume& volume) const {
  return mayHaveBones(volume) && !memory_.bones() && std::any_of(seeds_.begin(), seeds_.end(), [&](glm::ivec3 seed) {
           return BoneTree::isNear(volume, memory_.guessOf(volume), seed);
         });
}

void MemoryBuild::build(const Volume& volume) {
  std::future<std::shared_ptr<const BoneTree>> bones;
  if (lacksBones(volume))
    bones = std::async(std::launch::async,
                       [&] { return BoneTree::build(volume, memory_.guessOf(volume), [this] { return !stops_; }); });
  if (!memory_.tissues()) memory_.tissues() = TissueTree::build(volume, [this](double) { return !stops_; });
  if (bones.valid()) memory_.bones() = bones.get();
}

}  // namespace fenestra::segmentation
