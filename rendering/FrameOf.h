#pragma once
// What a scene and a view mean for the stages of a picture.

#include "rendering/stages/Frame.h"

namespace fenestra {

/// `scene` as it is drawn, with what was peeled off already gone; `gpu` is up to date with it. `before`: the picture
/// begun last, null before the first.
Frame frameOf(const Scene& scene, const View& view, const GpuScene& gpu, const Frame* before);

}  // namespace fenestra
