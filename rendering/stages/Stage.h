#pragma once
// A stage of a picture: an object that owns its passes and images and knows when it has to run again.
// rendering/README.md has the whole.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "rendering/gl/Texture.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/passes/Steps.h"
#include "rendering/stages/Frame.h"
#include "rendering/stages/Output.h"
#include "rendering/stages/Pass.h"

namespace fenestra {

class Stage;

/// The stages of one chain in the order in which they are begun, and what they share. A stage is in the list from its
/// construction on and must not outlive it.
class StageList {
 public:
  explicit StageList(std::shared_ptr<GpuScene> gpu) : gpu_(std::move(gpu)) {}
  StageList(const StageList&) = delete;
  StageList& operator=(const StageList&) = delete;

  GpuScene& gpu() const { return *gpu_; }
  const std::vector<Stage*>& stages() const { return stages_; }
  /// Memory of the device that all stages hold.
  std::size_t bytes() const;

  bool timing = false;                       ///< measure each run; waits for the GPU
  std::array<PassStats, passCount> stats{};  ///< by Pass

 private:
  friend class Stage;
  std::shared_ptr<GpuScene> gpu_;
  std::vector<Stage*> stages_;
  std::uint64_t lastVersion_ = 0;
};

/// Needs a current context. What a stage reads is passed to its constructor: earlier stages, which are done when it is
/// begun.
class Stage {
 public:
  Stage(StageList& list, Pass pass);
  virtual ~Stage() = default;
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Whether the picture needs the stage's images. If it does not, the stage is released.
  virtual bool isUsed(const Frame& frame) const = 0;
  /// Adds the steps that bring the images up to date, none where nothing has changed that the stage reads. The frame
  /// lives until they are done or dropped.
  virtual void begin(const Frame& frame, Steps& steps) = 0;
  /// Gives back all that the stage holds.
  virtual void release();
  /// What it holds, in bytes of the device's memory.
  std::size_t bytes() const;

 protected:
  const GpuScene& gpu() const { return list_.gpu(); }
  Version newVersion() { return {++list_.lastVersion_}; }

  /// Names what the stage holds on the device: images, and passes with bytes() and release(). Each member once, in the
  /// constructor.
  template <class... Things>
  void owns(Things&... things) {
    (holdings_.push_back(holding(things)), ...);
  }
  void dropHoldings();

  /// Adds the steps that `add` adds for these regions, as steps of the stage's pass, and counts them; `done` follows.
  void addSteps(Steps& steps, const std::vector<gl::Region>& regions, const std::function<void(Regions)>& add,
                std::function<void()> done);

 private:
  struct Holding {
    std::function<std::size_t()> bytes;
    std::function<void()> release;
  };
  static Holding holding(gl::Texture& image);
  static Holding holding(std::vector<gl::Texture>& images);
  template <class PassWithMemory>
  static Holding holding(PassWithMemory& pass) {
    return {[&pass] { return pass.bytes(); }, [&pass] { pass.release(); }};
  }

  StageList& list_;
  Pass pass_;
  std::vector<Holding> holdings_;
};

}  // namespace fenestra
