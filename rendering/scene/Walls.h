#pragma once
// Slices that stand in a picture as walls (MethodStages::Walls): where they stand, and what is drawn on them. The
// renderer and its reference share it.
//
// A wall shows the voxels of one index plane: of the index axis that Grid::patientAxes() has for S (axial), L
// (sagittal) or P (coronal), the plane nearest to the crosshair, as slices do. A place (u, v) on it counts voxels,
// centres on whole numbers, along the other two index axes, the lower one first. Inside the opening a place is where
// its voxels lie. Around the volume the plane is moved along its normal, away from the eye, until it stands wallMargin
// beyond the farthest corner of the volume's box. So a wall never hides the volume.
//
// The colour at a place is the voxels' bilinear value there, clamped to the outermost centres, as grey from 0 to 1 over
// the display window, turned round where low values are bright, with NaN and infinite values as in hitPoints()
// (rendering/reference). Hidden labels and the table are not left out: slices show all. Over it lie lines, each over
// the ones before, of width w = lineWidth(): at the distance d from a line, that line covers this share of a box of
// width f across it:
//
//   (min(d + f/2, w/2) - max(d - f/2, -w/2)) / f,   clamped to 0..1,   f = min(pixel, w)
//
// with `pixel` the width of a pixel, in mm, at the view depth of the place. The wall's opacity is 1, and at its rim,
// half a voxel around the outermost centres, clamp(½ + d/pixel, 0, 1), d the distance in mm inwards from the nearest of
// the four edges.

#include <optional>
#include <vector>

#include "rendering/scene/View.h"
#include "rendering/settings/Camera.h"
#include "rendering/vocabulary/MethodStages.h"
#include "rendering/volume/Slice.h"

namespace fenestra {

struct Look;
struct Scene;

/// The walls of a look's pictures; empty where there are none, or the cutaway is off. Without an opening, there are
/// none inside it.
std::optional<MethodStages::Walls> wallsOf(const Look& look);

/// Whether a look's pictures depend on View::slices.
bool dependsOnSlices(const Look& look);

/// One slice that stands as a wall.
struct Wall {
  SlicePlane plane = SlicePlane::Axial;
  int axis = 2;            ///< the index axis that counts slices
  int slice = 0;           ///< voxel index along it
  glm::ivec2 sides{0, 1};  ///< the index axes along u and v
  glm::ivec2 size{0};      ///< voxels along them
  glm::dvec3 origin{0.0};  ///< world, of the place (0, 0)
  glm::dvec3 right, down;  ///< world, from a voxel to the next along u and v
  glm::dvec3 shift{0.0};   ///< world, by which it stands away from its voxels

  glm::dvec3 worldFromPlace(glm::dvec2 place) const { return origin + place.x * right + place.y * down; }
  /// The voxel index of a place.
  glm::dvec3 indexFromPlace(glm::dvec2 place) const;
  /// mm on the wall from places, x along u.
  glm::dmat2 mmFromPlace() const;
  bool operator==(const Wall&) const = default;
};

/// Share of the radius of the volume's bounding sphere by which walls around it stand off.
inline constexpr double wallMargin = 0.1;

/// In the order axial, sagittal, coronal, without those that are off.
std::vector<Wall> wallsAt(const MethodStages::Walls& walls, const Grid& grid, const ShownSlices& slices,
                          const Camera& camera);

/// The place on a wall where the other two slices at the crosshair cut it.
glm::dvec2 crossingOn(const Wall& wall, const Grid& grid, const ShownSlices& slices);

/// mm: a 250th of the volume's longest side, but at least half and at most three times the wall's finer voxel side.
double lineWidth(const Wall& wall, const Grid& grid);

/// A line of one colour, in pieces between places.
struct WallLine {
  struct Piece {
    glm::dvec2 from, to;
  };
  glm::dvec3 colour{1.0};  ///< display RGB
  std::vector<Piece> pieces;
};
/// The lines on a wall, in the order in which they are drawn. On walls around the volume: where the other two slices
/// cut this one. With outlines: those of the labels of the label map (smoothOutlines), ascending and in the colours of
/// slices, without labels that are invisible or of opacity 0; and that of the region in focus, where there is one.
std::vector<WallLine> linesOn(const Wall& wall, const MethodStages::Walls& walls, const Scene& scene,
                              const ShownSlices& slices);

}  // namespace fenestra
