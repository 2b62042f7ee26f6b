#include "io/study/Interpret.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <system_error>

#include "io/MaskFolder.h"
#include "io/base/Text.h"
#include "io/base/VolumeEnding.h"

namespace fenestra::io {
namespace {

namespace fs = std::filesystem;

bool isFolder(const fs::path& path) {
  std::error_code unknown;
  return fs::is_directory(path, unknown);
}

/// Whether a name says that a file holds labels. File managers drop several files in any order.
bool soundsLikeLabels(const fs::path& path) {
  const std::string name = lowered(path.filename().string());
  const char* const words[] = {"seg", "label", "mask", "rtstruct"};
  return std::any_of(std::begin(words), std::end(words),
                     [&](const char* word) { return name.find(word) != std::string::npos; });
}

bool isMaskFolder(const fs::path& path) { return isFolder(path) && soundsLikeLabels(path) && !maskFiles(path).empty(); }

/// The folder that holds these folders and no others, whose series are then those of all; empty: there is none.
fs::path folderOfAll(const std::vector<fs::path>& folders) {
  const fs::path parent = folders.front().parent_path();
  std::error_code unknown;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, unknown))
    if (std::find(folders.begin(), folders.end(), entry.path()) == folders.end()) return {};
  return unknown ? fs::path() : parent;
}

DataRequest requestOf(const fs::path& volume, const fs::path& labels = {}) {
  DataRequest request;
  request.path = volume;
  request.labels = labels;
  return request;
}

}  // namespace

bool mayBeLabels(const fs::path& path) { return !isFolder(path) || !maskFiles(path).empty(); }

DataRequest interpret(const std::vector<fs::path>& paths) {
  if (paths.size() == 1) return requestOf(paths.front());
  const fs::path folder = paths.front().parent_path();
  const auto folders = std::count_if(paths.begin(), paths.end(), isFolder);
  if (folders == 2 && paths.size() == 2 && isMaskFolder(paths[0]) != isMaskFolder(paths[1]))
    return isMaskFolder(paths[1]) ? requestOf(paths[0], paths[1]) : requestOf(paths[1], paths[0]);
  if (folders == static_cast<std::ptrdiff_t>(paths.size())) {
    const fs::path all = folderOfAll(paths);
    if (!all.empty()) return requestOf(all);
    throw Error(paths[1], "is a second folder", "open one folder, or the folder that holds them all");
  }
  const bool slices = folders == 0 && std::all_of(paths.begin(), paths.end(), [&](const fs::path& path) {
                        return path.parent_path() == folder && volumeEnding(path).empty();
                      });
  if (slices) return requestOf(folder.empty() ? fs::path(".") : folder);
  if (paths.size() > 2)
    throw Error(paths[2], "too many files at once", "open a volume, a volume and its label map, or one folder");
  if (folders == 1) {
    const std::size_t inner = isFolder(paths[0]) ? 0 : 1;
    const fs::path &directory = paths[inner], &file = paths[1 - inner];
    return isMaskFolder(directory) && !soundsLikeLabels(file) ? requestOf(file, directory) : requestOf(directory, file);
  }
  const bool swapped = soundsLikeLabels(paths[0]) && !soundsLikeLabels(paths[1]);
  return swapped ? requestOf(paths[1], paths[0]) : requestOf(paths[0], paths[1]);
}

}  // namespace fenestra::io
