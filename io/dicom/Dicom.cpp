#include "io/dicom/Dicom.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "io/base/Contents.h"
#include "io/base/PlausibleGrid.h"
#include "io/base/SessionName.h"
#include "io/base/VolumeEnding.h"
#include "io/base/VoxelSink.h"
#include "io/dicom/DicomDir.h"
#include "io/dicom/DicomHeader.h"
#include "io/dicom/DicomRemarks.h"
#include "io/dicom/DicomStack.h"
#include "io/dicom/DicomStart.h"
#include "io/dicom/DicomVoxels.h"
#include "io/dicom/LabelObject.h"
#include "io/dicom/PackedFiles.h"
#include "io/dicom/Placement.h"
#include "io/dicom/SharedProgress.h"
#include "io/dicom/StackFrames.h"
#include "rendering/volume/Threads.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// How far the bar is after the headers and after the pixels, which take most of the time.
constexpr double headersShare = 0.2, pixelsShare = 0.95;

struct Scan {
  std::vector<DicomFile> files;  ///< images
  std::vector<fs::path> unreadable;
  std::vector<std::string> unreadableCauses;
  std::vector<fs::path> closed;                          ///< folders that cannot be listed
  std::vector<fs::path> notImages;                       ///< other files of the folder
  std::map<std::string, std::vector<fs::path>> refused;  ///< DICOM objects that are no scalar images, by reason
  std::vector<DicomFile> segmentations;                  ///< and structure sets
  std::vector<fs::path> repeated;                        ///< the same image (SOP instance) again
  std::vector<fs::path> missing;                         ///< listed in the DICOMDIR that was opened
};

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
std::vector<fs::path> filesToScan(const fs::path& path, Scan& scan) {
  if (fs::is_directory(path)) return filesBelow(path, scan.closed);
  if (path.filename() != "DICOMDIR") return {path};
  DicomDir directory = readDicomDir(path);
  if (directory.files.empty()) return filesBelow(fs::absolute(path).parent_path(), scan.closed);
  scan.missing = std::move(directory.missing);
  return std::move(directory.files);
}

/// What to open instead of a folder without DICOM images.
std::string wayOutOf(const fs::path& folder, const std::vector<fs::path>& files) {
  const auto isVolume = [](const fs::path& file) {
    const std::string_view ending = volumeEnding(file);
    return !ending.empty() && ending != ".img";  // a .hdr lies beside it
  };
  const auto first = std::find_if(files.begin(), files.end(), isVolume);
  if (first == files.end()) return "name a folder with DICOM files, or a volume file itself";
  const auto others = std::count_if(std::next(first), files.end(), isVolume);
  std::string way = "open the volume file in it: " + first->lexically_relative(folder).string();
  if (others > 0) way += others == 1 ? " (or the other one)" : " (or one of " + std::to_string(others) + " others)";
  return way;
}

Scan scanHeaders(const fs::path& path, const OpenOptions& options, PackedFiles& packed) {
  const bool folder = fs::is_directory(path);
  Scan scan;
  std::vector<fs::path> paths = filesToScan(path, scan);
  if (paths.empty() && !scan.closed.empty())
    throw Error(scan.closed.front(), "cannot be listed", "check the folder's permissions");
  if (paths.empty()) throw Error(path, "is an empty folder", "name a folder with DICOM files");

  struct Outcome {
    std::optional<DicomFile> file;
    std::string failure;
    bool dicom = true;
  };
  std::vector<Outcome> outcomes(paths.size());
  SharedProgress progress({options.progress, 0.0, headersShare}, paths.size(), "reading headers");
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

  std::set<std::string> instances;
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
    } else if (!outcome.file->instance.empty() &&
               !instances.insert(outcome.file->series + "/" + outcome.file->instance).second) {
      scan.repeated.push_back(paths[i]);
    } else {
      scan.files.push_back(std::move(*outcome.file));
    }
  }
  if (scan.files.empty()) {
    if (scan.refused.empty() && !scan.segmentations.empty())
      throw Error(scan.segmentations.front().path, scan.segmentations.front().refusal,
                  "open the series that it belongs to, then this file as labels");
    if (!scan.refused.empty()) {
      const auto& [reason, refused] = *scan.refused.begin();
      throw Error(refused.size() == 1 ? refused.front() : path, reason,
                  "only DICOM images of one value a pixel can be opened as a volume");
    }
    if (!scan.unreadable.empty()) {
      if (!folder) throw Error(path, scan.unreadableCauses.front(), "get the file again from its source");
      throw Error(path,
                  "none of its " + std::to_string(scan.unreadable.size()) +
                      " DICOM files can be read (the first: " + scan.unreadableCauses.front() + ")",
                  "get the files again from their source");
    }
    throw Error(path, "holds no DICOM images", wayOutOf(path, scan.notImages));
  }
  return scan;
}

struct Candidate {
  SeriesInfo info;
  DicomStack stack;
};

/// All volumes of a scan, series by series in the order their first files have; the largest of a series first.
std::vector<Candidate> candidatesOf(const Scan& scan) {
  std::vector<std::string> series;
  for (const DicomFile& file : scan.files)
    if (std::find(series.begin(), series.end(), file.series) == series.end()) series.push_back(file.series);

  std::vector<Candidate> candidates;
  for (const std::string& uid : series) {
    std::vector<DicomFrame> frames;
    for (std::size_t i = 0; i < scan.files.size(); ++i)
      if (scan.files[i].series == uid)
        for (DicomFrame frame : scan.files[i].frames) {
          frame.file = i;
          frames.push_back(std::move(frame));
        }
    std::vector<DicomStack> stacks = stackFrames(frames, scan.files);
    for (std::size_t n = 0; n < stacks.size(); ++n) {
      Candidate candidate;
      const DicomFile& first = scan.files[stacks[n].frames.front().file];
      candidate.info.id = (uid.empty() ? "no-uid" : uid) + (n == 0 ? "" : "#" + std::to_string(n + 1));
      candidate.info.modality = first.modality;
      candidate.info.description = first.description;
      candidate.info.study = first.study;
      candidate.info.date = first.date;
      candidate.info.dims = stacks[n].grid.dims;
      candidate.info.time = stacks[n].time;
      candidate.info.times = stacks[n].times;
      std::set<std::size_t> listed;
      for (const DicomFrame& frame : stacks[n].frames)
        if (listed.insert(frame.file).second) candidate.info.files.push_back(scan.files[frame.file].path);
      candidate.stack = std::move(stacks[n]);
      candidates.push_back(std::move(candidate));
    }
  }
  return candidates;
}

/// The series that the options name; otherwise the largest volume whose geometry is plausible.
std::size_t chosenSeries(const std::vector<Candidate>& candidates, const fs::path& path, const std::string& id) {
  std::optional<std::size_t> largest;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Grid& grid = candidates[i].stack.grid;
    if (!id.empty()) {
      if (candidates[i].info.id == id || seriesKey(candidates[i].info.id) == id) return i;
    } else if (!implausibility(grid) &&
               (!largest || grid.voxelCount() > candidates[*largest].stack.grid.voxelCount())) {
      largest = i;
    }
  }
  if (!id.empty()) throw Error(path, "has no series " + id, "list its series with: fenestra-cli info " + path.string());
  return largest.value_or(0);
}

/// chosenSeries, or the wanted one among the time points beside it.
std::size_t chosen(const std::vector<Candidate>& candidates, const fs::path& path, const OpenOptions& options) {
  const std::size_t series = chosenSeries(candidates, path, options.series);
  const Candidate& there = candidates[series];
  if (!options.time || *options.time == std::max(there.info.time, 1)) return series;
  const auto uidOf = [](const Candidate& candidate) {
    return candidate.info.id.substr(0, candidate.info.id.find('#'));
  };
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (uidOf(candidates[i]) == uidOf(there) && candidates[i].stack.group == there.stack.group &&
        candidates[i].info.time == *options.time)
      return i;
  throwNoTime(path, *options.time, there.info.times);
}

void warnOfImplausibleSeries(const std::vector<Candidate>& candidates, std::vector<Warning>& warnings) {
  for (const Candidate& candidate : candidates)
    if (const auto wrong = implausibility(candidate.stack.grid))
      warnings.push_back({Warning::Kind::NoGeometry, "a series cannot be opened: " + *wrong, candidate.info.files});
}

/// Compressed samples that the header rules out.
void warnOfSamplesOutside(const DecodedStack& decoded, const std::vector<DicomFile>& files,
                          std::vector<Warning>& warnings) {
  std::size_t samples = 0;
  std::vector<fs::path> paths;
  for (const auto& [file, count] : decoded.samplesOutside) {
    samples += count;
    paths.push_back(files[file].path);
  }
  if (samples > 0)
    warnings.push_back({Warning::Kind::DamagedPixels,
                        std::to_string(samples) +
                            " pixels hold values that the header rules out (Bits Stored, or Smallest and Largest Image "
                            "Pixel Value); the compressed pixels may be damaged",
                        std::move(paths)});
}

/// Those of the segmentations that belong to a stack; of the others, a warning a reason.
void addSegmentations(const Scan& scan, const DicomStack& stack, OpenedVolume& opened) {
  const DicomFrame& frame = stack.frames.front();
  std::map<std::string, std::vector<fs::path>> others;
  for (const DicomFile& file : scan.segmentations)
    if (file.labels->belongsTo(scan.files[frame.file].series, frame.frameOfReference))
      opened.segmentations.push_back(file.labels->info);
    else
      others[file.refusal + "; it belongs to another series"].push_back(file.path);
  for (const auto& [reason, paths] : others)
    opened.warnings.push_back(
        {Warning::Kind::Other,
         std::to_string(paths.size()) + (paths.size() == 1 ? " file" : " files") + " left out: " + reason, paths});
}

void addScanWarnings(const Scan& scan, std::vector<Warning>& warnings) {
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
  if (!scan.repeated.empty())
    warnings.push_back({Warning::Kind::DuplicateSlices,
                        count(scan.repeated) + " left out: the same images (SOP instances) as in other files",
                        scan.repeated});
}

Modality modalityNamed(const std::string& name) {
  if (name == "CT") return Modality::CT;
  if (name == "MR") return Modality::MR;
  return Modality::Unknown;
}

OpenedVolume openScanned(const fs::path& path, const OpenOptions& options, PackedFiles& packed) {
  Scan scan = scanHeaders(path, options, packed);
  for (;;) {
    std::vector<Candidate> candidates = candidatesOf(scan);
    const std::size_t choice = chosen(candidates, path, options);
    const DicomStack& stack = candidates[choice].stack;
    const DicomFile& first = scan.files[stack.frames.front().file];
    checkGeometry(scan.files.size() == 1 ? first.path : path, stack.grid);
    const Mapping mapping = mappingOf(stack, scan.files);
    DecodedStack decoded = decodeStack(stack, scan.files, mapping,
                                       {.progress = options.progress, .from = headersShare, .to = pixelsShare});
    const auto& failed = decoded.failed;
    if (!failed.empty()) {
      // The other slices are stacked again without them; their places count as missing slices.
      const bool nothingLeft = failed.size() == scan.files.size();
      const bool wantedIsLost = !options.series.empty() && failed.size() == candidates[choice].info.files.size();
      if (nothingLeft || wantedIsLost)
        throw Error(scan.files.size() == 1 ? scan.files.front().path : path, failed.begin()->second,
                    "get the files again from their source");
      for (auto file = failed.rbegin(); file != failed.rend(); ++file) {
        scan.unreadable.push_back(scan.files[file->first].path);
        scan.unreadableCauses.push_back(file->second);
        scan.files.erase(scan.files.begin() + static_cast<std::ptrdiff_t>(file->first));
      }
      continue;
    }

    auto volume = std::make_shared<Volume>();
    volume->slope = mapping.slope;
    volume->intercept = mapping.intercept;
    volume->modality = modalityNamed(first.modality);
    volume->unit = first.unit;
    volume->windows = stack.frames[stack.frames.size() / 2].windows;
    volume->voxels = narrowed(std::move(decoded.voxels));
    volume->lowIsWhite = first.monochrome1;

    OpenedVolume opened;
    opened.geometry = placeSlices(stack, scan.files, options.regularise,
                                  {.progress = options.progress, .from = pixelsShare, .to = 1.0}, *volume);
    opened.volume = std::move(volume);
    opened.format = "DICOM";
    opened.patient = readPatientText(first.path);
    if (opened.geometry) opened.warnings = opened.geometry->findings;
    opened.warnings.insert(opened.warnings.end(), stack.warnings.begin(), stack.warnings.end());
    addSegmentations(scan, stack, opened);
    for (Warning& remark : remarksOn(stack, scan.files)) opened.warnings.push_back(std::move(remark));
    warnOfSamplesOutside(decoded, scan.files, opened.warnings);
    if (options.series.empty()) warnOfImplausibleSeries(candidates, opened.warnings);
    addScanWarnings(scan, opened.warnings);
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (i == choice)
        opened.series = candidates[i].info;
      else
        opened.otherSeries.push_back(candidates[i].info);
    return opened;
  }
}

/// read(packed), with errors that name packed files.
template <class Read>
auto withPackedFiles(const Read& read) {
  PackedFiles packed;
  try {
    return read(packed);
  } catch (const Error& error) {
    throw Error(packed.named(error.file()), error.cause(), error.hint());
  }
}

}  // namespace

std::vector<SeriesInfo> listDicomSeries(const fs::path& path, const OpenOptions& options) {
  return withPackedFiles([&](PackedFiles& packed) {
    std::vector<SeriesInfo> series;
    for (Candidate& candidate : candidatesOf(scanHeaders(path, options, packed))) {
      for (fs::path& file : candidate.info.files) file = packed.named(file);
      series.push_back(std::move(candidate.info));
    }
    return series;
  });
}

OpenedVolume openDicom(const fs::path& path, const OpenOptions& options) {
  return withPackedFiles([&](PackedFiles& packed) {
    OpenedVolume opened = openScanned(path, options, packed);
    renameFiles(opened, [&](const fs::path& file) { return packed.named(file); });
    return opened;
  });
}

}  // namespace fenestra::io
