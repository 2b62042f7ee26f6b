#pragma once
// A folder that appears as a whole or not at all.

#include <filesystem>
#include <vector>

namespace fenestra::io::deidentify {

/// Whether `inner` is `outer` or lies below it, links resolved.
bool liesIn(const std::filesystem::path& inner, const std::filesystem::path& outer);

class OutputFolder {
 public:
  /// Makes a folder beside `folder`, for its owner alone. Throws Error where `folder` holds files, lies in one of
  /// `sources` or cannot be made.
  OutputFolder(const std::filesystem::path& folder, const std::vector<std::filesystem::path>& sources);
  /// Removes all that was written, unless it was finished.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write meanwhile.
  const std::filesystem::path& place() const { return place_; }
  /// Gives the folder its name. Throws Error.
  void finish();

 private:
  std::filesystem::path folder_, place_;
};

}  // namespace fenestra::io::deidentify
