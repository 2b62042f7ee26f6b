#pragma once
// --crop, --clip-plane and what else clips pictures (rendering/scene/Clipping.h).

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rendering/scene/Scene.h"

namespace CLI {
class App;
}

namespace fenestra::app {

struct SceneOptions;

/// Changes of what clips the scene.
struct ClipChanges {
  /// Low and high end along L, P and S, mm; a missing one is the volume's.
  using Ends = std::array<std::array<std::optional<double>, 2>, 3>;
  std::optional<Ends> crop;
  std::vector<std::string> exempt;  ///< labels by value or name
};

/// Adds --crop, --clip-plane, --clip-exempt and --clip-grey. What needs no data goes into `clipping` while parsing.
void addClipping(CLI::App& command, ClipChanges& changes, Clipping& clipping);
/// Applies the changes to the scene's look. Throws io::Error where a label does not exist or the box holds nothing of
/// the volume.
void setClipping(const SceneOptions& options, Scene& scene);

}  // namespace fenestra::app
