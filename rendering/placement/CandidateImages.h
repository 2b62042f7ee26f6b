#pragma once
// Measures candidate cameras on the GPU, many in one dispatch.

#include <vector>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/placement/FocusSurface.h"
#include "rendering/viewpoints/Choice.h"
#include "rendering/viewpoints/FocusImage.h"

namespace fenestra::placement {

/// Needs the current context that `gpu` lives in.
///
/// An image holds the first focus hits of side² rays; only rays that the focus's box projects onto are traced. Where
/// one of two neighbouring rays meets the focus and the other does not, the outline between them is located to 1/32 of
/// a pixel. Areas, depths and centroids are integrals over the polygons inside the outline (marching squares; Lorensen,
/// Cline 1987, in two dimensions), so they change smoothly with the direction; counts of pixels would jump. Opposite
/// candidates have the same outline and share their rays.
class CandidateImages {
 public:
  /// An image's side: the multiple of `least` at which the diagonal of the focus's box spans some 50 pixels or more.
  static int sideFor(const GpuScene& gpu, int least = defaultImageSide);

  /// One candidate for each direction, with all descriptors but those of describeTogether(). The points that it sees
  /// are found unless `surface` is empty; end faces are measured with `endFaces`, at the resolution of the pixels.
  /// Clipped material does not count: `kept` are the scene's halfSpaces(). A capped face is no end face. `gpu` must
  /// be up to date. Equal calls give bit-identical results.
  std::vector<Candidate> measure(const GpuScene& gpu, const std::vector<glm::dvec3>& directions,
                                 const FocusSurface& surface, int side, bool endFaces = false,
                                 const std::vector<HalfSpace>& kept = {});

  /// One candidate's image as plain data, by the same rays as in measure(); `side` and `kept` as there. Empty where
  /// there is no focus.
  FocusImage image(const GpuScene& gpu, glm::dvec3 direction, int side, const std::vector<HalfSpace>& kept = {});

 private:
  struct Traced;
  /// The scene's variant of a program that looks for first hits, with all that it reads of the scene.
  gl::ShaderProgram& prepared(gl::ShaderVariants& programs, const GpuScene& gpu);
  void trace(const GpuScene& gpu, const Traced& traced, int side);
  void measureImages(const GpuScene& gpu, std::vector<Candidate>& candidates, int side, bool endFaces);
  void measureVisibility(const GpuScene& gpu, const FocusSurface& surface, std::vector<Candidate>& candidates);

  Clip clip_;  ///< of the measurement under way
  gl::ShaderVariants hits_{"CandidateHits.comp"}, edges_{"CandidateEdges.comp"}, outlines_{"CandidateOutlines.comp"},
      ends_{"CandidateEnds.comp"}, areas_{"CandidateAreas.comp"}, sums_{"CandidateSums.comp"},
      visibility_{"CandidateVisibility.comp"};
};

}  // namespace fenestra::placement
