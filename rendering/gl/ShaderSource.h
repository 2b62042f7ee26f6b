#pragma once
// The source of a shader, from the embedded files below rendering/shaders. A line `#include "lib/Ray.glsl"` names a
// file by its path there, `#include <name>` an alternative: a file that the variant chooses. Each file is included
// once.

#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace fenestra::gl {

/// A shader that does not compile or link: a programmer's error or a driver's; what() is the log with file names.
class ShaderError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A line "#define NAME VALUE" before the source.
struct Define {
  std::string name;
  int value = 1;
};
/// The file that a line `#include <name>` stands for: alternatives with one interface, of which a variant takes one.
struct Choice {
  std::string name, file;
};
/// One way to compile a shader. Its source must use every define and every choice, each of which is given once: others
/// are a programmer's error and asserted.
struct Variant {
  std::vector<Define> defines;
  std::vector<Choice> choices;
  Variant& operator+=(const Variant& more);
};
Variant operator+(Variant first, const Variant& more);

using Names = std::set<std::string, std::less<>>;

struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< that line directives in the text number
  Names names;  ///< all words of the code without its comments, to be asserted; empty without assertions
};

/// Throws ShaderError where a file or a choice is missing.
ShaderSource sourceOf(std::string_view path, const Variant& variant);

}  // namespace fenestra::gl
