#pragma once
// The lines of a NRRD header, and the vectors in its fields.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace fenestra::io {

struct NrrdHeader {
  std::map<std::string, std::string> fields;  ///< by name without blanks
  std::map<std::string, std::string> pairs;   ///< "key:=value"
  std::vector<std::string> listed;            ///< data files after "data file: LIST"
  std::uint64_t bytes = 0;                    ///< length with the blank line
};

/// Throws Error when a line is no field, or the header has no end.
NrrdHeader readNrrdLines(const std::filesystem::path& path);

/// A direction or position in the file's space, which may have two dimensions, three, or time as a fourth.
struct SpaceVector {
  glm::dvec3 place{0.0};
  double time = 0.0;
  std::size_t dimension = 0;
  bool isTime() const { return dimension == 4 && place == glm::dvec3(0.0) && time != 0.0; }
};

/// "(a,b,c)" or "none", one each, blanks allowed inside the parentheses; all of one dimension. Empty for any other
/// text.
std::optional<std::vector<std::optional<SpaceVector>>> vectorsIn(const std::string& text);
/// The words between quotes, or without quotes those between blanks.
std::vector<std::string> quotedWords(const std::string& text);

}  // namespace fenestra::io
