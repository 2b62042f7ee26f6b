#pragma once
// Measures candidate cameras on the GPU, many in one dispatch.

#include <vector>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/placement/FocusSurface.h"
#include "rendering/viewpoints/Choice.h"

namespace fenestra::placement {

/// Needs the current context that `gpu` lives in.
///
/// An image is side² rays of first focus hits, of which only those are traced that the focus's box projects onto. Where
/// of two neighbours one meets the focus, its outline is found between them to 1/32 of a pixel, and areas, depths and
/// centroids are integrals over the polygons so found (marching squares; Lorensen, Cline 1987, in two dimensions): they
/// change smoothly with the direction, where counted pixels jump. Opposite candidates have the same outline and share
/// its rays.
class CandidateImages {
 public:
  /// A multiple of `least`, so that the focus spans some 50 pixels at least, from corner to corner of its box.
  static int sideFor(const GpuScene& gpu, int least = defaultImageSide);

  /// Sums over the images, one a direction; descriptors filled in but for those of describeTogether(). `surface` may be
  /// empty; else each candidate's seen points are found. `gpu` is up to date. The same call gives the same answer to
  /// the bit.
  std::vector<Candidate> measure(const GpuScene& gpu, const std::vector<glm::dvec3>& directions,
                                 const FocusSurface& surface, int side);

 private:
  /// The scene's variant of a program that looks for first hits, with all that it reads of the scene.
  gl::ShaderProgram& prepared(gl::ShaderVariants& programs, const GpuScene& gpu);
  void measureImages(const GpuScene& gpu, std::vector<Candidate>& candidates, int side);
  void measureVisibility(const GpuScene& gpu, const FocusSurface& surface, std::vector<Candidate>& candidates);

  gl::ShaderVariants hits_{"CandidateHits.comp"}, edges_{"CandidateEdges.comp"}, outlines_{"CandidateOutlines.comp"},
      areas_{"CandidateAreas.comp"}, sums_{"CandidateSums.comp"}, visibility_{"CandidateVisibility.comp"};
};

}  // namespace fenestra::placement
