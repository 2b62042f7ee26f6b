#pragma once
// What a click on a picture means: the thing that shows most among all that its ray passes.

#include <optional>

#include "rendering/scene/Scene.h"

namespace fenestra {

/// The point of the structure that contributes most opacity to a ray: a translucent skin before a bone is not what is
/// seen there. `start` (world mm) is where the ray starts to see, `direction` a unit vector. In the `removed` mm
/// before `start`, which the opening removes, only protected labels are seen. Empty where the ray shows nothing.
///
/// After Wiebel, Vos, Foerster, Hege, "WYSIWYP: What You See Is What You Pick", IEEE TVCG 18(12), 2012: the accumulated
/// opacity rises in one stretch for each thing on the ray, and the longest rise is what is seen. The point lies where
/// that stretch contributes most, moved on by up to a voxel and a half to where the values stop changing: at the
/// surface itself, a voxel holds part of what lies before it. Values between voxels are trilinear here, also where
/// pictures are made of splines (Look::reconstruction): the two differ by less than that move.
std::optional<glm::dvec3> seenPoint(const Scene& scene, glm::dvec3 start, glm::dvec3 direction, double removed = 0.0);

}  // namespace fenestra
