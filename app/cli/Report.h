#pragma once
// Progress, warnings and results of a command.

#include <chrono>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>

#include "io/base/Reading.h"

namespace fenestra {
class GpuScene;
}

namespace fenestra::cli {

/// A percentage on standard error while that is a terminal; empty otherwise.
io::Progress progressOnTerminal();
/// One line each on standard error.
void printWarnings(const std::vector<io::Warning>& warnings);
/// A warning where a scene's volume did not fit onto the device as a whole.
void printReduction(const GpuScene& gpu);
/// To standard output, indented; bytes that are not UTF-8 (file names) are replaced.
void printJson(const nlohmann::ordered_json& json);
/// The components, as JSON lists a position or a direction.
nlohmann::ordered_json listOf(glm::dvec3 v);
double millisecondsSince(std::chrono::steady_clock::time_point start);
/// What to do when no camera can be placed.
inline constexpr const char* placementHint = "choose a focus with --focus-labels or --focus-range";
/// `text` without line breaks and other control characters.
std::string oneLine(std::string text);

}  // namespace fenestra::cli
