#pragma once
// Where the face is in a scan of a head, so that it can be taken out of copies that are given away.

#include <string>

#include "rendering/volume/Volume.h"

namespace fenestra::segmentation {

/// A half space that holds the face and no brain: in front of an oblique plane that runs from the brow down and back,
/// to below the chin. World is LPS, mm.
struct FaceRegion {
  glm::dvec3 normal{0.0, -1.0, 0.0};  ///< unit, to the front and down
  double offset = 0.0;                ///< the plane is dot(normal, p) = offset
  double lowest = 0.0;                ///< nothing below this height (S) is part of it

  bool contains(const glm::dvec3& p) const { return p.z >= lowest && glm::dot(normal, p) > offset; }
};

struct FaceSearch {
  bool isFound = false;
  FaceRegion region;
  std::string reason;  ///< why none was found, as a clause: "its top is cut off"
};

/// Finds the face by the shape of the head alone, in CT, MR and other modalities whose background is dark.
///
/// The patient's outline is taken on cells of 3 mm. It must be as wide and long as a head below its top, and the vault
/// must fit an ellipsoid. The plane is 18 mm within that ellipsoid, seen from the front and 25° from below: brain lies
/// behind it, and nose, eyelids, mouth and chin lie in front of it. A head that is nodded or turned by more than some
/// 20° may keep a part of its face, or lose some brain, so that copies must be looked at. Runs on all cores.
FaceSearch findFace(const Volume& volume);

}  // namespace fenestra::segmentation
