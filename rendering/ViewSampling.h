#pragma once
// How densely a view's rays are followed and sampled.

#include "rendering/passes/FocusLayerPass.h"
#include "rendering/scene/View.h"
#include "rendering/volume/Grid.h"

namespace fenestra {

using ViewSampling = FocusLayerPass::Sampling;

/// By the view's bound or quality and by how many pixels wide the narrowest side of a voxel is in the volume's middle.
/// `lit`: the picture is. Needs no OpenGL.
ViewSampling samplingOf(const View& view, const Grid& grid, bool lit);

}  // namespace fenestra
