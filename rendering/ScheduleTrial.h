#pragma once
// Which schedule draws a scene faster on this machine, found out by drawing a small picture of it with each.

#include <memory>
#include <string>

#include "rendering/Renderer.h"
#include "rendering/gpu/Schedule.h"

namespace fenestra {

/// Milliseconds of a small picture: GPU time by timer queries on hardware, until the picture is read back on a software
/// rasteriser. The least of several frames; infinite where the driver refuses one of the schedule's programs.
struct ScheduleTimes {
  double plain = 0.0, llvmpipe = 0.0;
  Schedule faster() const { return plain <= llvmpipe ? Schedule::Plain : Schedule::Llvmpipe; }
};

/// Draws the view, made small, with both schedules; the scene's schedule is then the faster one. Compiles the programs
/// of both. Needs a current context. Throws RenderError, and gl::ShaderError where the driver refuses both.
ScheduleTimes tryBothSchedules(const std::shared_ptr<GpuScene>& gpuScene, const Scene& scene, const View& view);

/// What the answer depends on: renderer, driver version and voxel type, for an application that keeps answers.
std::string scheduleKey(const Volume& volume);

}  // namespace fenestra
