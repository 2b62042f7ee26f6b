#include "rendering/passes/EdgePass.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "rendering/scene/EdgeRays.h"

namespace fenestra {
namespace {

/// The list's count, a word that nothing uses, and its first pixel: at the picture's first one, of no weight.
constexpr std::array<std::uint32_t, 4> emptyList{};
constexpr std::size_t wordsBefore = 2, wordsOfPixel = 2;

std::size_t bytesOfList(std::size_t pixels) { return (wordsBefore + wordsOfPixel * pixels) * sizeof(std::uint32_t); }

}  // namespace

void EdgePass::find(Steps& steps, Schedule schedule, const gl::Texture& picture,
                    const std::optional<OpeningRim>& opening, Regions regions, gl::Texture& smoothed) {
  const glm::ivec3 size = picture.size();
  const std::size_t needed = bytesOfList(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  if (list_.bytes() != needed) list_ = gl::Buffer::zeroed(needed);
  steps.then([this] { list_.write(std::as_bytes(std::span(emptyList))); });
  steps.add(regions, [this, schedule, &picture, opening, &smoothed](Regions tile) {
    const gl::Choice edges{"edges", opening ? "lib/edges/Opened.glsl" : "lib/edges/Plain.glsl"};
    gl::ShaderProgram& program = find_.get({{}, {scheduleChoice(schedule), edges}});
    list_.bind(Scatter::binding);
    program.bind("picture", picture);
    if (opening) {
      program.bind("hitPoints", opening->hitPoints);
      program.bind("distances", opening->distances);
      program.set("widths", glm::vec2(opening->widths));
      program.set("outline", static_cast<float>(edges::outline));
    }
    program.set("contrasts", glm::vec2(edges::leastContrast, edges::fullContrast));
    program.bind("smoothed", smoothed, gl::Access::Write);
    program.dispatch(tile);
  });
}

int EdgePass::count() const {
  std::uint32_t listed = 0;
  list_.read(std::as_writable_bytes(std::span(&listed, 1)));
  const std::size_t room = (list_.bytes() / sizeof(std::uint32_t) - wordsBefore) / wordsOfPixel;
  return static_cast<int>(std::min<std::size_t>(listed, room));
}

void EdgePass::blend(Steps& steps, Schedule schedule, const Scatter& batch, const gl::Texture& picture,
                     const gl::Texture& drawn, gl::Texture& smoothed) {
  steps.add(batch.blocks(), [this, schedule, batch, &picture, &drawn, &smoothed](Regions tile) {
    gl::ShaderProgram& program = means_.get({{}, {scheduleChoice(schedule)}});
    batch.bind(program);
    program.bind("picture", picture);
    program.bind("drawn", drawn);
    program.bind("smoothed", smoothed, gl::Access::Write);
    program.dispatch(tile);
  });
}

}  // namespace fenestra
