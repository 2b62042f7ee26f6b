#pragma once
// The parts of a scene that the view descriptors need: its focus's surface points, and the candidates' images where
// asked for.

#include "rendering/placement/CandidateImages.h"
#include "rendering/viewpoints/ViewDescriptors.h"

namespace fenestra::placement {

/// Describes the spread candidates of `measured`, which are those of `scene`'s focus by `sampling`, not refined. Their
/// images are measured again with `needsImages`. `gpu` must be up to date, its context current.
DescribedViews describeViews(GpuScene& gpu, const Scene& scene, const Measured& measured, const Sampling& sampling,
                             bool needsImages);

}  // namespace fenestra::placement
