#pragma once
// What a retrieval tells of the objects that come, while others are still on their way.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace fenestra::io::archive {

/// An object that is here, or a frame of one, while others of its series may still be missing.
struct ArrivedObject {
  std::string series;          ///< Series Instance UID
  std::filesystem::path file;  ///< once the series is whole, at the same name in the folder without ".part"
  int number = 0;              ///< Instance Number (PS3.3 C.7.6.1); 0 where the server tells none
  std::size_t total = 0;       ///< objects of the series
  /// Where the object is still on its way, `file` holds frame `frame` of its `frames`; it is deleted before the object
  /// itself is told. 0: the object itself is here.
  int frame = 0, frames = 0;
};
/// Called for one object after the other, on the threads that receive them; returns at once.
using Arrival = std::function<void(const ArrivedObject&)>;

}  // namespace fenestra::io::archive
