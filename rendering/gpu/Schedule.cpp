#include "rendering/gpu/Schedule.h"

#include "rendering/gl/Context.h"

namespace fenestra {

std::string_view nameOf(Schedule schedule) { return schedule == Schedule::Plain ? "plain" : "llvmpipe"; }

std::optional<Schedule> scheduleNamed(std::string_view name) {
  for (const Schedule schedule : {Schedule::Plain, Schedule::Llvmpipe})
    if (name == nameOf(schedule)) return schedule;
  return std::nullopt;
}

Schedule usualSchedule() {
  // zink on lavapipe ("zink (llvmpipe …)") compiles by way of Vulkan, to the same vector code.
  return gl::description().find("llvmpipe") != std::string::npos ? Schedule::Llvmpipe : Schedule::Plain;
}

gl::Choice scheduleChoice(Schedule schedule) {
  return {"schedule", schedule == Schedule::Plain ? "lib/schedule/Plain.glsl" : "lib/schedule/Llvmpipe.glsl"};
}

}  // namespace fenestra
