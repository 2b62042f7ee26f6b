#pragma once
// Labels on the command line: found by value or name, and how single ones are shown.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/SceneOptions.h"

namespace fenestra::app {

/// Adds --hidden, --protected, --label-opacity, --label-colour and --importance-levels.
void addLabelSettings(CLI::App& command, LabelChanges& changes);
/// Applies them to the scene's look, whose focus is set. Throws io::Error where a label does not exist, or cannot have
/// a role because it is in focus, or levels of importance have no labels in focus.
void setLabelSettings(const SceneOptions& options, Scene& scene);

/// Adds --focus-transfer.
void addFocusTransfer(CLI::App& command, LabelChanges& changes);
/// Applies it to the scene's look, whose focus is set. Throws io::Error where a label does not exist, there is no
/// focus, or a file holds no transfer function.
void setFocusFunctions(const SceneOptions& options, Scene& scene);

/// Label values for `wanted` (values or names, case ignored) out of `labels`; sorted, unique. Throws io::Error with
/// `file` and the nearest names.
std::vector<std::uint16_t> resolveLabels(const LabelMap& labels, const std::vector<std::string>& wanted,
                                         const std::filesystem::path& file);

}  // namespace fenestra::app
