#include "rendering/Chain.h"

#include <chrono>
#include <utility>

#include "rendering/FrameOf.h"

namespace fenestra {

const gl::Texture& Chain::picture() const {
  return firstOf({stages_.edges.smoothed(), stages_.pixels.picture()}).image;
}

void Chain::begin(const Scene& scene, const View& view) {
  std::shared_ptr<const PeeledScene> peeled = gpu().peeled(scene);
  const Scene& drawn = peeled ? peeled->scene : scene;
  beginAsDrawn(drawn, view, peeled);
}

void Chain::beginAsDrawn(const Scene& scene, const View& view, std::shared_ptr<const PeeledScene> peeled) {
  drop();
  gpu().update(scene, view.occlusion ? GpuScene::Use::Pictures : GpuScene::Use::WithoutOcclusion);
  Frame made = frameOf(scene, view, gpu(), frame());
  made.peeled = std::move(peeled);
  frame_ = std::move(made);
  begun_ = 0;
  isDrawing_ = true;
}

void Chain::drop() {
  steps_.drop();
  end();
}

void Chain::end() {
  isDrawing_ = false;
  if (frame_) frame_->scene = {};
}

void Chain::beginStage() {
  const std::vector<Stage*>& stages = stages_.list.stages();
  while (begun_ < stages.size()) {
    Stage& stage = *stages[begun_++];
    if (stage.isUsed(*frame_)) return stage.begin(*frame_, steps_);
    stage.release();
  }
  end();
}

bool Chain::advance(std::optional<double> milliseconds) try {
  // Another renderer may have brought the shared scene to another state.
  if (isDrawing_ && gpu().versions() != frame_->drawn) {
    const Frame again = *frame_;
    beginAsDrawn(again.scene, again.view(), again.peeled);
  }
  const auto begun = std::chrono::steady_clock::now();
  bool advanced = false;
  while (isDrawing_) {
    std::optional<double> left = milliseconds;
    if (left) *left -= std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
    if (left && *left <= 0.0 && advanced) return false;
    advanced = !steps_.isDone();
    if (!steps_.advance(left)) return false;
    beginStage();
  }
  return true;
} catch (...) {
  drop();
  throw;
}

}  // namespace fenestra
