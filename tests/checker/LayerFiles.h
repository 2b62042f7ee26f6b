#pragma once
// Writes what the checker reads, and runs it.

#include <filesystem>
#include <string>

#include "rendering/reference/Reference.h"

namespace fenestra::tests {

/// MetaImage files with the scene's values and labels, IMAGE.mha and LABELS.mha, in `folder`.
void writeScene(const Scene& scene, const std::filesystem::path& folder);
/// The layers and camera.json as `fenestra-cli render --layers` writes them.
void writeLayers(const reference::Stages& stages, const Camera& camera, glm::ivec2 size, const Grid& grid,
                 const std::filesystem::path& folder);

/// A program's exit code and what it printed.
struct Outcome {
  int exitCode = -1;
  std::string output;
};
Outcome runCommand(const std::string& command);
/// A path as one word of a command.
std::string quoted(const std::filesystem::path& path);

}  // namespace fenestra::tests
