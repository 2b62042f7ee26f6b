#pragma once
// The scenes of SceneKinds.h under both schedules: which programs they need, and whether a schedule, or drawing a tile
// at a time, changes their pictures. Needs a current context.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "rendering/gl/ShaderProgram.h"
#include "rendering/gpu/Schedule.h"

namespace fenestra::tests {

struct Linked {
  std::string path;
  gl::ProgramResources resources;
  /// By block, its members and their offsets in bytes.
  std::map<std::string, std::vector<std::pair<std::string, int>>> blocks;
};

/// By source, so that each counts once.
using Programs = std::map<std::string, Linked>;

extern const std::vector<std::string> blockNames;

struct DrawnKinds {
  Programs programs;                        ///< of all kinds, and of camera placement
  std::size_t kinds = 0, drawn = 0;         ///< how many there are, and how many are drawn under each schedule
  std::vector<std::string> tileFaults;      ///< where a picture that is drawn in tiles is not that of one run
  std::vector<std::string> scheduleFaults;  ///< where the schedules' pictures differ
};

/// Which kinds are drawn. Of the programs of the others only the sources are told, which the reference compiler reads:
/// a driver takes longer for a program than these small pictures do.
enum class Chosen {
  /// So many that each property is drawn; what several have together, tests of the passes and methods draw.
  CoveringProperties,
  All
};

DrawnKinds drawKinds(Chosen chosen);

}  // namespace fenestra::tests
