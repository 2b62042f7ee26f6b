#pragma once
// How the shaders of the 3-D views get their schedule (rendering/gpu/Schedule.h).

#include <functional>
#include <memory>

namespace fenestra {
class GpuScene;
struct Scene;
struct View;
}  // namespace fenestra

namespace fenestra::viewer {

/// Makes a new volume's shaders follow the schedule that suits this machine; called with the context current. Empty:
/// the renderer's name decides.
using ChooseSchedule = std::function<void(const std::shared_ptr<GpuScene>&, const Scene&, const View&)>;

}  // namespace fenestra::viewer
