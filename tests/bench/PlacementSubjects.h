#pragma once
// The structures that placement is measured on.

#include <string>
#include <vector>

#include "io/study/ReadStudy.h"

namespace fenestra::bench {

struct Structure {
  std::string name;
  io::StudyRequest scene;
  bool isPhantom = false;
};

/// Two of the phantoms and ten of the real-data collection. Real data that is not there is left out, with a line on
/// standard error.
std::vector<Structure> structures();
/// The kinds of data that the paper measured: a hand, a foot, a head, a torso; left out in the same way.
std::vector<Structure> paperSubjects();

/// Belongs to what shows the hand or the foot.
inline constexpr const char* bodyPartsCredit =
    "BodyParts3D, © The Database Center for Life Science licensed under CC Attribution-Share Alike 2.1 Japan";

}  // namespace fenestra::bench
