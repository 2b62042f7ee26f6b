#include "rendering/stages/Stage.h"

#include <utility>

#include "rendering/gl/Context.h"

namespace fenestra {

std::size_t StageList::bytes() const {
  std::size_t sum = 0;
  for (const Stage* stage : stages_) sum += stage->bytes();
  return sum;
}

Stage::Stage(StageList& list, Pass pass) : list_(list), pass_(pass) { list.stages_.push_back(this); }

void Stage::release() { dropHoldings(); }

void Stage::dropHoldings() {
  for (const Holding& each : holdings_) each.release();
}

std::size_t Stage::bytes() const {
  std::size_t sum = 0;
  for (const Holding& each : holdings_) sum += each.bytes();
  return sum;
}

void Stage::addSteps(Steps& steps, const std::vector<gl::Region>& regions, const std::function<void(Regions)>& add,
                     std::function<void()> done) {
  std::uint64_t pixels = 0;
  for (const gl::Region& region : regions) pixels += std::uint64_t(region.size.x) * std::uint64_t(region.size.y);
  const auto timer = list_.timing ? std::make_shared<gl::TimerQuery>() : nullptr;
  steps.beginPass(static_cast<std::size_t>(pass_));
  add(regions);
  steps.then([this, pixels, timer, done = std::move(done)] {
    PassStats& mine = list_.stats[static_cast<std::size_t>(pass_)];
    ++mine.runs;
    mine.pixels = pixels;
    if (timer) mine.milliseconds = timer->elapsedMilliseconds();
    done();
  });
}

Stage::Holding Stage::holding(gl::Texture& image) {
  return {[&image] { return image.bytes(); }, [&image] { image = {}; }};
}

Stage::Holding Stage::holding(std::vector<gl::Texture>& images) {
  return {[&images] {
            std::size_t sum = 0;
            for (const gl::Texture& image : images) sum += image.bytes();
            return sum;
          },
          [&images] { images.clear(); }};
}

}  // namespace fenestra
