#pragma once
// The subjects of the report: data, views and pixels, the same for the renderer and for its peers.

#include <string>
#include <vector>

#include "app/benchmark/Views.h"
#include "io/study/ReadStudy.h"

namespace CLI {
class App;
}

namespace fenestra::bench {

/// Settings that the renderer and its peers must share so that their pictures can be compared.
struct Views {
  glm::ivec2 size{700, 650};
  int cameras = 3;          ///< along the path
  int compared = 2;         ///< of them with the reference, from the first on
  int pixelBlock = 8;       ///< one pixel of each block of this side is compared with the reference
  int phantomVoxels = 256;  ///< along a phantom's longest side
  bool parallel = false;    ///< parallel projection, which is all that some peers draw
  std::string only;         ///< subjects whose id starts with it
  Projection projection() const { return parallel ? Projection::Orthographic : Projection::Perspective; }
  bool operator==(const Views&) const = default;
};
/// --size, --cameras, --compared, --block, --voxels, --parallel and --only.
void addViewOptions(CLI::App& program, Views& views);

/// One data set with a focus, as the programs' options describe it.
struct Subject {
  std::string id;  ///< for switches and file names
  std::string name;
  io::StudyRequest options;
  double aroundFocus = 0.0;  ///< mm along each axis, which pictures of methods frame; 0: all of the body
};

struct Subjects {
  std::vector<Subject> here;
  std::vector<std::string> missing;  ///< a line for each that is left out because its data are not there
};
/// The report's data: a phantom, a CT head, a labelled torso, an MR head; those that `views` asks for.
Subjects reportSubjects(const Views& views);
/// The subjects on which methods are compared: a small structure behind a rib, a skull, a deep one in a labelled brain,
/// organs and a vessel of a labelled torso.
Subjects methodSubjects(const Views& views);
/// Ten scenes of every kind, for the error bound.
Subjects boundSubjects(const Views& views);

/// Samples per voxel that the peers are timed at; with lighting, which costs them several times as much, at one alone.
inline const std::vector<double> stepLadder{0.5, 1.0, 2.0, 4.0}, litLadder{2.0};
/// And those at which one view of the first subject shows what a peer's picture converges to.
inline const std::vector<double> limitLadder{8.0, 16.0};
/// With lighting, whose models differ, a peer's picture is compared with its own at this many samples per voxel.
inline constexpr double litLimit = 16.0;
/// How often the path is gone along, for the times' median.
inline constexpr int pathRounds = 3;

/// Millimetres between samples, from their number per voxel at the finest spacing.
double stepLength(const Grid& grid, double samplesPerVoxel);

}  // namespace fenestra::bench
