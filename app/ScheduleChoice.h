#pragma once
// Which schedule the shaders follow on this machine: what the user asks for, or what drew faster when it was tried.
// Answers are kept in $XDG_CACHE_HOME/fenestra/schedules.json (~/.cache/fenestra), by renderer, driver version and
// voxel type; a file that cannot be read or written costs a trial, nothing else.

#include <memory>
#include <optional>

#include "app/options/Options.h"
#include "rendering/ScheduleTrial.h"

namespace fenestra::app {

/// Adds --schedule.
void addScheduleOption(Command command, std::optional<Schedule>& schedule);

/// `asked`, or the answer kept for such a volume. Needs a current context.
std::optional<Schedule> knownSchedule(std::optional<Schedule> asked, const Volume& volume);

/// Makes the scene follow `asked`, the kept answer, or that of a trial with this view, which is then kept. Needs a
/// current context. Throws RenderError, gl::ShaderError.
void chooseSchedule(std::optional<Schedule> asked, const std::shared_ptr<GpuScene>& gpuScene, const Scene& scene,
                    const View& view);

/// Chooses for a window, whose first picture is waited for: a software rasteriser, on which a trial would compile all
/// programs twice on the CPU that draws, keeps the schedule that is made for it unless an answer is known.
void chooseScheduleQuickly(std::optional<Schedule> asked, bool software, const std::shared_ptr<GpuScene>& gpuScene,
                           const Scene& scene, const View& view);

}  // namespace fenestra::app
