#include "io/dicom/DicomScan.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>

#include "io/base/FileStart.h"
#include "io/base/OtherContent.h"
#include "io/base/SessionName.h"
#include "io/base/VolumeEnding.h"
#include "io/dicom/DicomDir.h"
#include "io/dicom/DicomHeader.h"
#include "io/dicom/DicomStart.h"
#include "io/dicom/LabelObject.h"
#include "rendering/volume/Threads.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// All files below a folder. Folders that cannot be listed are added to `closed`; throws Error when the first one is.
std::vector<fs::path> filesBelow(const fs::path& folder, std::vector<fs::path>& closed) {
  std::vector<fs::path> paths, folders{folder};
  while (!folders.empty()) {
    const fs::path next = folders.back();
    folders.pop_back();
    std::error_code failure, unknown;
    for (fs::directory_iterator entry(next, failure); !failure && entry != fs::directory_iterator();
         entry.increment(failure)) {
      // Links to folders are not followed: they may lead in circles.
      if (entry->is_directory(unknown) && !entry->is_symlink(unknown)) folders.push_back(entry->path());
      // Sessions are often kept beside the slices that they show.
      if (entry->is_regular_file(unknown) && !isSession(entry->path())) paths.push_back(entry->path());
    }
    if (!failure) continue;
    if (next == folder) throw Error(folder, "cannot be listed: " + failure.message(), "check the folder's permissions");
    closed.push_back(next);
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// A folder's files, a DICOMDIR's, or the file itself. A DICOMDIR without usable records stands for its folder.
std::vector<fs::path> filesToScan(const fs::path& path, DicomScan& scan) {
  if (fs::is_directory(path)) return filesBelow(path, scan.closed);
  if (path.filename() != "DICOMDIR") return {path};
  DicomDir directory = readDicomDir(path);
  if (directory.files.empty()) return filesBelow(fs::absolute(path).parent_path(), scan.closed);
  scan.missing = std::move(directory.missing);
  return std::move(directory.files);
}

/// What to open instead of a folder without DICOM images; empty: it holds no volume file.
std::optional<std::string> volumeIn(const fs::path& folder, const std::vector<fs::path>& files) {
  const auto isVolume = [](const fs::path& file) {
    const std::string_view ending = volumeEnding(file);
    return !ending.empty() && ending != ".img";  // a .hdr lies beside it
  };
  const auto first = std::find_if(files.begin(), files.end(), isVolume);
  if (first == files.end()) return std::nullopt;
  const auto others = std::count_if(std::next(first), files.end(), isVolume);
  std::string way = "open the volume file in it: " + first->lexically_relative(folder).string();
  if (others > 0) way += others == 1 ? " (or the other one)" : " (or one of " + std::to_string(others) + " others)";
  return way;
}

/// Throws the Error for files of which none is DICOM.
[[noreturn]] void refuseOthers(const DicomScan& scan, const fs::path& path) {
  const std::optional<std::string> volume = volumeIn(path, scan.notImages);
  if (!volume) {
    std::map<const OtherContent*, std::size_t> others;
    for (const fs::path& file : scan.notImages) ++others[otherContentOf(FileStart(file).stored())];
    others.erase(nullptr);
    const auto most = std::max_element(others.begin(), others.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != others.end())
      throw Error(path,
                  "holds no DICOM images, but " +
                      (most->second == 1 ? most->first->one : std::to_string(most->second) + " " + most->first->many),
                  most->first->way);
  }
  throw Error(path, "holds no DICOM images",
              volume.value_or("name a folder with DICOM files, or a volume file itself"));
}

/// What came of one file.
struct Outcome {
  std::optional<DicomFile> file;
  std::string failure;
  bool dicom = true;
};

/// Reads the headers on all cores. Paths of packed files become those of their content.
std::vector<Outcome> readAll(std::vector<fs::path>& paths, const ProgressPart& part, PackedFiles& packed) {
  std::vector<Outcome> outcomes(paths.size());
  SharedProgress progress(part, paths.size(), "reading headers");
  parallelFor(paths.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      progress.step();
      try {
        outcomes[i].dicom = looksLikeDicom(FileStart(paths[i])) && paths[i].filename() != "DICOMDIR";
        if (!outcomes[i].dicom) {
          const fs::path content = packed.contentOf(paths[i]);
          outcomes[i].dicom = content != paths[i];
          paths[i] = content;
        }
        if (outcomes[i].dicom) outcomes[i].file = readDicomHeader(paths[i]);
      } catch (const Error& error) {
        outcomes[i].failure = error.cause();
      }
    }
  });
  return outcomes;
}

/// Throws the Error for a scan without images.
[[noreturn]] void refuse(const DicomScan& scan, const fs::path& path) {
  if (scan.refused.empty() && !scan.segmentations.empty())
    throw Error(scan.segmentations.front().path, scan.segmentations.front().refusal,
                "open the series that it belongs to, then this file as labels");
  if (!scan.refused.empty()) {
    const auto& [reason, refused] = *scan.refused.begin();
    throw Error(refused.size() == 1 ? refused.front() : path, reason,
                "only DICOM images of one value a pixel can be opened as a volume");
  }
  if (scan.unreadable.empty()) refuseOthers(scan, path);
  if (!fs::is_directory(path)) throw Error(path, scan.unreadableCauses.front(), "get the file again from its source");
  throw Error(path,
              "none of its " + std::to_string(scan.unreadable.size()) +
                  " DICOM files can be read (the first: " + scan.unreadableCauses.front() + ")",
              "get the files again from their source");
}

}  // namespace

DicomScan scanHeaders(const fs::path& path, const ProgressPart& progress, PackedFiles& packed) {
  DicomScan scan;
  std::vector<fs::path> paths = filesToScan(path, scan);
  if (paths.empty() && !scan.closed.empty())
    throw Error(scan.closed.front(), "cannot be listed", "check the folder's permissions");
  if (paths.empty()) throw Error(path, "is an empty folder", "name a folder with DICOM files");
  std::vector<Outcome> outcomes = readAll(paths, progress, packed);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    Outcome& outcome = outcomes[i];
    if (!outcome.dicom) {
      scan.notImages.push_back(paths[i]);
    } else if (!outcome.file) {
      scan.unreadable.push_back(paths[i]);
      scan.unreadableCauses.push_back(outcome.failure);
    } else if (outcome.file->labels) {
      scan.segmentations.push_back(std::move(*outcome.file));
    } else if (!outcome.file->refusal.empty()) {
      scan.refused[outcome.file->refusal].push_back(paths[i]);
    } else {
      scan.files.push_back(std::move(*outcome.file));
    }
  }
  if (scan.files.empty()) refuse(scan, path);
  scan.identifiers = mendIdentifiers(scan.files);
  return scan;
}

void addScanWarnings(const DicomScan& scan, const std::string& series, std::vector<Warning>& warnings) {
  const auto count = [](const std::vector<fs::path>& paths) {
    return std::to_string(paths.size()) + (paths.size() == 1 ? " file" : " files");
  };
  if (!scan.unreadable.empty())
    warnings.push_back(
        {Warning::Kind::UnreadableFiles,
         count(scan.unreadable) + " left out, unreadable (the first: " + scan.unreadableCauses.front() + ")",
         scan.unreadable});
  if (!scan.closed.empty())
    warnings.push_back({Warning::Kind::UnreadableFiles,
                        std::to_string(scan.closed.size()) + (scan.closed.size() == 1 ? " folder" : " folders") +
                            " left out: not readable",
                        scan.closed});
  if (!scan.notImages.empty())
    warnings.push_back(
        {Warning::Kind::UnreadableFiles, count(scan.notImages) + " of the folder left out: not DICOM", scan.notImages});
  if (!scan.missing.empty())
    warnings.push_back(
        {Warning::Kind::UnreadableFiles, count(scan.missing) + " listed in the DICOMDIR missing", scan.missing});
  for (const auto& [reason, paths] : scan.refused)
    warnings.push_back({Warning::Kind::Other, count(paths) + " left out: " + reason, paths});
  const std::vector<Warning> found = warningsOf(scan.identifiers, series);
  warnings.insert(warnings.end(), found.begin(), found.end());
}

}  // namespace fenestra::io
