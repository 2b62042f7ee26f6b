#pragma once
// The camera that is placed for a study's focus.

#include <filesystem>

#include "io/study/Study.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/settings/Camera.h"

namespace fenestra::cli {

/// The best view or its complement among the default candidates, in the projection of the study's first view. Needs a
/// current context. Throws io::Error, which names `source`, where none can be placed.
Camera placedCamera(const std::filesystem::path& source, io::Study& study, GpuScene& gpuScene, io::PlacedView which);

}  // namespace fenestra::cli
