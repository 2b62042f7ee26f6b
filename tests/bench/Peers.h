#pragma once
// The results of other volume renderers (tests/peers) for the same subjects.

#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/Prepare.h"

namespace fenestra::bench {

/// One program, subject and step.
struct PeerRun {
  std::string program, subject;
  bool lit = false;
  double samplesPerVoxel = 0.0;
  std::string setting;                          ///< in the program's own terms, where that is no step
  Distribution milliseconds;                    ///< one a frame
  std::vector<std::filesystem::path> pictures;  ///< of the compared pixels, one a camera
};

/// Everything in `folder` that was measured with the same views; `left` names the rest.
struct Peers {
  std::vector<PeerRun> runs;
  std::vector<std::string> left;
  std::vector<std::string> programs;  ///< with version and machine
};
Peers readPeers(const std::filesystem::path& folder, const Views& views);

/// A run's pictures against the truths of `what`, the subject that it drew. Throws io::Error.
ColourErrors errorsOf(const PeerRun& run, const Measurable& what);
/// A lit run's pictures against the limit of that program's own pictures, for the views that both have. Throws
/// io::Error.
ColourErrors errorsOf(const PeerRun& run, const PeerRun& limit);

}  // namespace fenestra::bench
