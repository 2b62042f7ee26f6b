#pragma once
// Objects of archives on this disk: ROOT/STUDY/SERIES/OBJECT.dcm, each name the hash of a UID, so that no name tells
// whose data it holds. Folders and files are the user's alone. A series whose objects have not all come is kept apart,
// in ROOT/STUDY/SERIES.part, and no reader looks there.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "io/archive/SeriesLock.h"

namespace fenestra::io::archive {

/// $XDG_CACHE_HOME/fenestra/archive, or ~/.cache/fenestra/archive. Empty where there is neither.
std::filesystem::path defaultCacheFolder();
/// The name that stands for a UID.
std::string cacheName(const std::string& uid);

class Cache {
 public:
  /// Makes the folder, for its owner alone. Throws Error.
  explicit Cache(std::filesystem::path root);

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path folderOf(const std::string& study, const std::string& series) const;
  /// Where objects of the series wait for those that are missing. Makes it.
  std::filesystem::path partOf(const std::string& study, const std::string& series) const;
  /// The right to write the series, which one retrieval has at a time; see SeriesLock.
  SeriesLock lock(const std::string& study, const std::string& series, const std::function<void()>& wait) const;
  /// The names of the series' objects that are here, those that wait included.
  std::set<std::string> held(const std::string& study, const std::string& series) const;
  /// The objects that wait are all: they become the series' own.
  void complete(const std::string& study, const std::string& series) const;

  /// Bytes of all objects.
  std::uint64_t bytes() const;
  /// Removes the series used longest ago, never `kept` and none that is being written, until `most` bytes are left or
  /// nothing can go.
  void trim(std::uint64_t most, const std::set<std::filesystem::path>& kept) const;
  /// Removes all of it but series that are being written, which other programs may do.
  void clear() const;

 private:
  std::filesystem::path root_;
};

/// Puts the objects of `series` into a new or empty folder, by links where the disk is the same, whole or not at all.
/// Returns the number of files. Throws Error when the folder holds something.
std::size_t layOut(const std::vector<std::filesystem::path>& series, const std::filesystem::path& folder);

}  // namespace fenestra::io::archive
