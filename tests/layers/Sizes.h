#pragma once
// How long files and functions are.

#include <string>
#include <vector>

#include "tests/layers/Sources.h"

namespace fenestra::tests {

/// A function or a file, and its lines.
struct Length {
  std::string where;  ///< "FILE:LINE NAME" of a function, or the file
  int lines = 0;
};

/// Functions of C++ or GLSL that clang-format has laid out, from the first line of the declaration to the closing
/// brace. A lambda belongs to the function around it; one at namespace scope is a function.
std::vector<Length> functionLengths(const SourceFile& source);
/// Lines of a file.
int lineCount(const SourceFile& source);

}  // namespace fenestra::tests
