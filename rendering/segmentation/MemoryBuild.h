#pragma once
// Finds the tissues and bones of a volume beside other work.

#include <atomic>
#include <functional>
#include <future>
#include <vector>

#include "rendering/segmentation/GrowthMemory.h"
#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// Adds to a memory what it lacks of its volume, on a thread of its own, which ends with this.
class MemoryBuild {
 public:
  /// `volume` outlives this. Bones are found where one is near a seed, in CT alone, and not in very large volumes.
  MemoryBuild(const Volume& volume, const GrowthMemory& memory, std::vector<glm::ivec3> seeds);
  ~MemoryBuild() { stops_ = true; }
  MemoryBuild(const MemoryBuild&) = delete;
  MemoryBuild& operator=(const MemoryBuild&) = delete;

  /// Whether the memory holds all; false when `goOn`, which is asked now and then, has returned false.
  bool wait(const std::function<bool()>& goOn);

 private:
  bool lacksBones(const Volume& volume) const;
  void build(const Volume& volume);

  GrowthMemory memory_;
  std::vector<glm::ivec3> seeds_;
  std::atomic<bool> stops_ = false;
  std::future<void> built_;  ///< last: it is waited for while the others live
};

}  // namespace fenestra::segmentation
