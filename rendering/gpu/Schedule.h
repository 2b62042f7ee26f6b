#pragma once
// How shaders lay their work out on a machine. A schedule never changes the picture (shaders/lib/schedule).

#include <cstdint>
#include <optional>
#include <string_view>

#include "rendering/gl/ShaderProgram.h"

namespace fenestra {

enum class Schedule : std::uint8_t {
  Plain,    ///< for graphics cards: one ray an invocation, texelFetch, ordinary loops
  Llvmpipe  ///< for Mesa's software rasteriser: rays that wait for each other, images, uniforms read once
};

/// "plain", "llvmpipe": as the command line and stored choices have them.
std::string_view nameOf(Schedule schedule);
std::optional<Schedule> scheduleNamed(std::string_view name);

/// The one that suits the current context's renderer, by its name.
Schedule usualSchedule();

/// What `#include <schedule>` stands for.
gl::Choice scheduleChoice(Schedule schedule);

}  // namespace fenestra
