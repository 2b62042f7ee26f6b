#pragma once
// The project's own sources as text.

#include <string>
#include <string_view>
#include <vector>

namespace fenestra::tests {

struct SourceFile {
  std::string path;  ///< from the project's root, with '/'
  std::string text;
};

/// A file of the project.
std::string readSource(const std::string& path);
/// All files below app, io, rendering, resources and viewer whose names end with one of `endings`, sorted by path.
std::vector<SourceFile> productSources(const std::vector<std::string_view>& endings);
/// Those below `folder`.
std::vector<SourceFile> sourcesBelow(const std::string& folder, const std::vector<std::string_view>& endings);

/// `text` with comments, literals and preprocessor lines blanked out; every line keeps its number and length. Include
/// lines are blanked too.
std::string codeOf(std::string_view text);

}  // namespace fenestra::tests
