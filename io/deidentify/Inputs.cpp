#include "io/deidentify/Inputs.h"

#include <algorithm>

#include "io/base/FileStart.h"
#include "io/base/SessionName.h"
#include "io/dicom/DicomDir.h"
#include "io/dicom/DicomStart.h"

namespace fenestra::io::deidentify {
namespace fs = std::filesystem;

Inputs::Inputs(const std::vector<fs::path>& paths, const Progress& progress) {
  for (const fs::path& path : paths) {
    std::error_code failure;
    if (!fs::exists(path, failure)) throw Error(path, "does not exist", "check the path");
    add(path, true, progress);
  }
}

void Inputs::add(const fs::path& path, bool mayBeArchive, const Progress& progress) {
  if (fs::is_directory(path)) return addFolder(path, progress);
  if (path.filename() == "DICOMDIR") {
    DicomDir directory = readDicomDir(path);
    if (directory.files.empty()) return addFolder(fs::absolute(path).parent_path(), progress);
    for (const fs::path& file : directory.files) addFile(file);
    missing_.insert(missing_.end(), directory.missing.begin(), directory.missing.end());
    return;
  }
  if (!mayBeArchive || !looksLikeArchive(FileStart(path))) return addFile(path);
  archives_.push_back(std::make_unique<UnpackedArchive>(path, progress));
  addFolder(archives_.back()->folder(), progress);
}

void Inputs::addFolder(const fs::path& folder, const Progress& progress) {
  std::vector<fs::path> files;
  std::error_code failure, unknown;
  // Links to folders are not followed: they may lead in circles.
  fs::recursive_directory_iterator entry(folder, failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    if (progress && !progress(0.0, "listing files")) throw Cancelled();
    if (entry->is_regular_file(unknown) && !isSession(entry->path()) && entry->path().filename() != "DICOMDIR")
      files.push_back(entry->path());
  }
  // A part that cannot be listed would be missing from the copy without a word.
  if (failure) throw Error(folder, "cannot be listed: " + failure.message(), "check its permissions");
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) addFile(file);
}

void Inputs::addFile(const fs::path& file) {
  if (looksLikeDicom(FileStart(file))) return objects_.push_back(file);
  const fs::path content = packed_.contentOf(file);
  (content == file ? others_ : objects_).push_back(content);
}

fs::path Inputs::named(const fs::path& file) const {
  for (const auto& archive : archives_)
    if (const fs::path name = archive->named(file); name != file) return name;
  return packed_.named(file);
}

}  // namespace fenestra::io::deidentify
