#pragma once
// What the report measures: data, views and pixels, the same for the renderer and for its peers.

#include <string>
#include <vector>

#include "app/SceneOptions.h"

namespace fenestra::bench {

/// One data set with a focus, as the programs' options describe it.
struct Subject {
  std::string id;  ///< for switches and file names
  std::string name;
  app::SceneOptions options;
};

struct Subjects {
  std::vector<Subject> here;
  std::vector<std::string> missing;  ///< a line for each that is left out because its data are not there
};
/// The report's data: a phantom, a CT head, a labelled torso, an MR head. `phantomVoxels` along a phantom's longest
/// side.
Subjects reportSubjects(int phantomVoxels);
/// Ten scenes of every kind, for the error bound.
Subjects boundSubjects(int phantomVoxels);

/// A subject's scene as a plain volume rendering without lighting: what every volume renderer can draw. The outermost
/// voxels have the volume's least value, because some programs end the volume at their centres and others half a voxel
/// beyond; with nothing to see there, all have the same limit.
Scene plainScene(const Scene& scene);

/// `count` views around the patient, up and down, framing what shows.
std::vector<Camera> cameraPath(const Scene& scene, int count);

/// One pixel of every block of side×side, at a place of its own in each, row by row.
std::vector<glm::ivec2> sampledPixels(glm::ivec2 size, int side);

/// Millimetres between samples that the step ladder's `samplesPerVoxel` stands for, on the finest spacing.
double stepLength(const Grid& grid, double samplesPerVoxel);

}  // namespace fenestra::bench
