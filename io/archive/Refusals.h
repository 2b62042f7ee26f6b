#pragma once
// What was not let in.

#include <cstddef>

namespace fenestra::io::archive {

/// What our storage provider refused while it listened.
struct Refusals {
  std::size_t connections = 0;  ///< too many, silent, or not of DICOM
  std::size_t titles = 0;       ///< associations of another AE title, or to another
  std::size_t classes = 0;      ///< associations for classes that were not asked for
  std::size_t objects = 0;      ///< not asked for, too large, or broken
};

}  // namespace fenestra::io::archive
