#pragma once
// Which folder depends on which. A folder of the sources is a layer: "rendering/gl", "viewer/model". Two libraries
// count as layers too: OpenGL (headers of epoxy) and Qt.

#include <compare>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/layers/Sources.h"

namespace fenestra::tests {

/// A layer that uses another, and the line that makes it so.
struct Edge {
  std::string from, to;
  std::string where;  ///< "FILE:LINE" of the first include, or the target's name of a link line
  auto operator<=>(const Edge&) const = default;
};

/// The layers that each layer may use directly.
using LayerRule = std::map<std::string, std::set<std::string>>;

/// From the block of a Markdown text that is fenced as ```layers: "LAYER → LAYER, LAYER" a line, "LAYER →" where
/// nothing may be used. Throws std::runtime_error for another form.
LayerRule layerRule(std::string_view markdown);
/// The line of a rule that holds for a layer: its own, or that of all folders within its parent ("parent/*").
std::string lineOf(const LayerRule& rule, const std::string& layer);

/// One edge for each pair of layers, sorted. Includes within a layer and those of other libraries are left out.
std::vector<Edge> includeEdges(const std::vector<SourceFile>& sources);

/// The sources and links of a CMake target, as its CMakeLists.txt says.
struct Target {
  std::set<std::string> layers;  ///< the folders of its sources
  std::set<std::string> links;   ///< targets of the project, without "fenestra::"
};
/// By name without "fenestra::", from the project's CMakeLists.txt files.
std::map<std::string, Target> cmakeTargets(const std::vector<SourceFile>& cmakeLists);
/// One edge a link line and pair of layers of which at least one is allowed, or else any.
std::vector<Edge> linkEdges(const std::map<std::string, Target>& targets, const LayerRule& rule);

/// One line for each edge that the rule does not allow, and for each layer that it does not name.
std::vector<std::string> breaches(const LayerRule& rule, const std::vector<Edge>& edges);
/// One line for each include edge that no link line stands behind: no target of the first layer links one of the
/// second, directly or through others.
std::vector<std::string> unlinked(const std::map<std::string, Target>& targets, const std::vector<Edge>& edges);
/// One edge for each pair of files of which X.h or X.cpp includes Y.h, sorted; X and Y are the paths without ending.
std::vector<Edge> fileEdges(const std::vector<SourceFile>& sources);
/// The layers, or files, of a cycle in their order, the first again at the end; empty when there is none.
std::vector<std::string> cycleIn(const std::vector<Edge>& edges);

}  // namespace fenestra::tests
