#include "rendering/passes/PullPushPass.h"

namespace fenestra {
namespace {
gl::Choice fineChoice(std::size_t level) { return {"fine", level == 0 ? "lib/fine/Hits.glsl" : "lib/fine/Level.glsl"}; }
}  // namespace

void PullPushPass::run(Steps& steps, Schedule schedule, const gl::Texture& hitPoints, gl::Texture& filled) {
  glm::ivec2 size(hitPoints.size());
  const glm::ivec2 half = (size + 1) / 2;
  if (known_.empty() || glm::ivec2(known_.front().size()) != half) {
    release();
    // One level more than needed is never made: the coarsest is 1×1, and a 1×1 picture has a 1×1 level above it.
    do {
      size = (size + 1) / 2;
      known_.push_back(gl::Texture::make2D(gl::Format::R32F, size));
      filled_.push_back(gl::Texture::make2D(gl::Format::R32F, size));
    } while (size != glm::ivec2(1));
  }
  for (std::size_t level = 0; level < known_.size(); ++level)
    steps.add(glm::ivec2(known_[level].size()), [this, schedule, level, &hitPoints](Regions tile) {
      gl::ShaderProgram& up = analysis_.get({{}, {scheduleChoice(schedule), fineChoice(level)}});
      up.bind("fine", level == 0 ? hitPoints : known_[level - 1]);
      up.bind("coarse", known_[level], gl::Access::Write);
      up.dispatch(tile);
    });
  for (std::size_t level = known_.size(); level-- > 0;) {
    gl::Texture& target = level == 0 ? filled : filled_[level - 1];
    steps.add(glm::ivec2(target.size()), [this, schedule, level, &hitPoints, &target](Regions tile) {
      // The coarsest level is one pixel: known, or no pixel of the picture is.
      const gl::Texture& coarse = level + 1 == known_.size() ? known_.back() : filled_[level];
      gl::ShaderProgram& down = synthesis_.get({{}, {scheduleChoice(schedule), fineChoice(level)}});
      down.bind("fine", level == 0 ? hitPoints : known_[level - 1]);
      down.bind("coarse", coarse);
      down.bind("filled", target, gl::Access::Write);
      down.dispatch(tile);
    });
  }
}

void PullPushPass::release() {
  known_.clear();
  filled_.clear();
}

std::size_t PullPushPass::bytes() const {
  std::size_t sum = 0;
  for (const gl::Texture& texture : known_) sum += 2 * texture.bytes();
  return sum;
}

}  // namespace fenestra
