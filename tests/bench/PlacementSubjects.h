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

}  // namespace fenestra::bench
