#include "io/dicom/Dicom.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <set>

#include "io/base/Contents.h"
#include "io/base/Memory.h"
#include "io/base/SessionName.h"
#include "io/base/VoxelSink.h"
#include "io/dicom/DicomDecoder.h"
#include "io/dicom/DicomDir.h"
#include "io/dicom/DicomStack.h"
#include "rendering/scene/Parallel.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Counts work from many threads and tells the callback, one call at a time.
class SharedProgress {
 public:
  SharedProgress(const Progress& progress, double from, double to, std::size_t count, const char* doing)
      : progress_(progress), from_(from), to_(to), count_(count), doing_(doing) {}

  /// Call before each piece of work; throws Cancelled.
  void step() {
    const std::scoped_lock lock(mutex_);
    const double fraction = from_ + (to_ - from_) * static_cast<double>(done_++) / static_cast<double>(count_);
    if (cancelled_ || (progress_ && !progress_(fraction, doing_))) {
      cancelled_ = true;
      throw Cancelled();
    }
  }

 private:
  const Progress& progress_;
  double from_, to_;
  std::size_t count_, done_ = 0;
  const char* doing_;
  bool cancelled_ = false;
  std::mutex mutex_;
};

/// How far the bar is after the headers; pixels take most of the time.
constexpr double headersShare = 0.2;

struct Scan {
  std::vector<DicomFile> files;  ///< images
  std::vector<fs::path> unreadable;
  std::vector<std::string> unreadableCauses;
  std::vector<fs::path> notImages;                       ///< other files of the folder
  std::map<std::string, std::vector<fs::path>> refused;  ///< DICOM objects that are no scalar images, by reason
  std::vector<DicomFile> segmentations;                  ///< and structure sets
  std::vector<fs::path> repeated;                        ///< the same image (SOP instance) again
  std::vector<fs::path> missing;                         ///< listed in the DICOMDIR that was opened
};

std::vector<fs::path> filesBelow(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code failure;
  fs::recursive_directory_iterator entries(folder, fs::directory_options::skip_permission_denied, failure);
  if (failure) throw Error(folder, "cannot be listed: " + failure.message(), "check the folder's permissions");
  for (const auto end = fs::recursive_directory_iterator(); entries != end; entries.increment(failure)) {
    if (failure) throw Error(folder, "cannot be listed: " + failure.message(), "check the folder's permissions");
    std::error_code unknown;
    // Sessions are often kept beside the slices that they show.
    if (entries->is_regular_file(unknown) && !isSession(entries->path())) paths.push_back(entries->path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

/// A folder's files, a DICOMDIR's, or the file itself. A DICOMDIR without usable records stands for its folder.
std::vector<fs::path> filesToScan(const fs::path& path, std::vector<fs::path>& missing) {
  if (fs::is_directory(path)) return filesBelow(path);
  if (path.filename() != "DICOMDIR") return {path};
  DicomDir directory = readDicomDir(path);
  if (directory.files.empty()) return filesBelow(fs::absolute(path).parent_path());
  missing = std::move(directory.missing);
  return std::move(directory.files);
}

Scan scanHeaders(const fs::path& path, const OpenOptions& options) {
  const bool folder = fs::is_directory(path);
  Scan scan;
  const std::vector<fs::path> paths = filesToScan(path, scan.missing);
  if (paths.empty()) throw Error(path, "is an empty folder", "name a folder with DICOM files");

  struct Outcome {
    std::optional<DicomFile> file;
    std::string failure;
    bool dicom = true;
  };
  std::vector<Outcome> outcomes(paths.size());
  SharedProgress progress(options.progress, 0.0, headersShare, paths.size(), "reading headers");
  parallelFor(paths.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      progress.step();
      try {
        outcomes[i].dicom = looksLikeDicom(paths[i]) && paths[i].filename() != "DICOMDIR";
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
    throw Error(path, "holds no DICOM images", "name a folder with DICOM files, or a volume file itself");
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
      candidate.info.dims = stacks[n].grid.dims;
      std::set<std::size_t> listed;
      for (const DicomFrame& frame : stacks[n].frames)
        if (listed.insert(frame.file).second) candidate.info.files.push_back(scan.files[frame.file].path);
      candidate.stack = std::move(stacks[n]);
      candidates.push_back(std::move(candidate));
    }
  }
  return candidates;
}

std::size_t chosen(const std::vector<Candidate>& candidates, const fs::path& path, const std::string& id) {
  if (id.empty()) {
    const auto largest = std::max_element(
        candidates.begin(), candidates.end(),
        [](const Candidate& a, const Candidate& b) { return a.stack.grid.voxelCount() < b.stack.grid.voxelCount(); });
    return static_cast<std::size_t>(largest - candidates.begin());
  }
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i].info.id == id || seriesKey(candidates[i].info.id) == id) return i;
  throw Error(path, "has no series " + id, "list its series with: fenestra-cli info " + path.string());
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

/// How stored samples become voxels: one map for the whole volume, or each slice's own applied on the way.
struct Mapping {
  ScalarType type = ScalarType::UInt8;
  double slope = 1.0, intercept = 0.0;  ///< of the volume
  bool applied = false;                 ///< voxels are real values already
};

Mapping mappingOf(const DicomStack& stack, const std::vector<DicomFile>& files) {
  const DicomFrame& first = stack.frames.front();
  const DicomFile& firstFile = files[first.file];
  bool uniform = true, whole = true;
  double low = 0.0, high = 0.0;          // of the real values that the formats allow
  std::int64_t least = 0, greatest = 0;  // of the stored values
  for (const DicomFrame& frame : stack.frames) {
    const DicomFile& file = files[frame.file];
    uniform = uniform && frame.slope == first.slope && frame.intercept == first.intercept && !file.lut;
    least = std::min(least, file.format.least());
    greatest = std::max(greatest, file.format.greatest());
    if (file.lut) {
      high = std::max(high, 65535.0);
      continue;
    }
    whole = whole && frame.slope == std::round(frame.slope) && frame.intercept == std::round(frame.intercept);
    for (const std::int64_t stored : {file.format.least(), file.format.greatest()}) {
      low = std::min(low, frame.slope * static_cast<double>(stored) + frame.intercept);
      high = std::max(high, frame.slope * static_cast<double>(stored) + frame.intercept);
    }
  }
  Mapping mapping;
  if (uniform && !firstFile.lut) {
    mapping.type = narrowestInteger(least, static_cast<std::uint64_t>(greatest));
    mapping.slope = first.slope;
    mapping.intercept = first.intercept;
    return mapping;
  }
  mapping.applied = true;
  // 2^31: beyond it whole numbers fit no integer voxel type.
  mapping.type = whole && low >= -2147483648.0 && high <= 2147483647.0
                     ? narrowestInteger(static_cast<std::int64_t>(low), static_cast<std::uint64_t>(high))
                     : ScalarType::Float32;
  return mapping;
}

/// Copies one slice out of a stored frame: the stored bits of each word, sign extended, mapped.
template <class Word, class Voxel>
void storeSlice(std::span<const std::byte> words, const DicomFrame& frame, const DicomFile& file, bool apply,
                Voxel* to) {
  const PixelFormat& format = file.format;
  const int shift = format.highBit + 1 - format.bitsStored;
  const Word mask = static_cast<Word>(~std::uint64_t{0} >> (64 - format.bitsStored));
  const Word sign = format.isSigned ? static_cast<Word>(std::uint64_t{1} << (format.bitsStored - 1)) : Word{0};
  const std::size_t width = static_cast<std::size_t>(frame.size.x);
  std::vector<Word> row(width);
  for (int y = 0; y < frame.size.y; ++y, to += width) {
    const std::size_t at = static_cast<std::size_t>(frame.tile.y + y) * static_cast<std::size_t>(format.columns) +
                           static_cast<std::size_t>(frame.tile.x);
    std::memcpy(row.data(), words.data() + at * sizeof(Word), width * sizeof(Word));
    const auto stored = [&](std::size_t x) {
      const Word bits = static_cast<Word>(static_cast<Word>(row[x] >> shift) & mask);
      return static_cast<std::int64_t>(static_cast<Word>(bits ^ sign)) - static_cast<std::int64_t>(sign);
    };
    if (!apply) {
      for (std::size_t x = 0; x < width; ++x) to[x] = static_cast<Voxel>(stored(x));
    } else if (file.lut) {
      const auto last = static_cast<std::int64_t>(file.lut->values.size()) - 1;
      for (std::size_t x = 0; x < width; ++x)
        to[x] = static_cast<Voxel>(
            file.lut->values[static_cast<std::size_t>(std::clamp<std::int64_t>(stored(x) - file.lut->first, 0, last))]);
    } else {
      for (std::size_t x = 0; x < width; ++x)
        to[x] = static_cast<Voxel>(frame.slope * static_cast<double>(stored(x)) + frame.intercept);
    }
  }
}

void storeSlice(std::span<const std::byte> words, const DicomFrame& frame, const DicomFile& file, bool apply,
                Voxels& voxels, std::size_t offset) {
  std::as_const(voxels).visit([&](auto scalars) {
    using Voxel = std::remove_const_t<typename decltype(scalars)::element_type>;
    Voxel* to = voxels.as<Voxel>().data() + offset;
    switch (file.format.bitsAllocated) {
      case 8:
        return storeSlice<std::uint8_t>(words, frame, file, apply, to);
      case 16:
        return storeSlice<std::uint16_t>(words, frame, file, apply, to);
      default:
        return storeSlice<std::uint32_t>(words, frame, file, apply, to);
    }
  });
}

/// The pixels of a stack. Files that fail are added to `failed`; the voxels are unusable then.
Voxels decode(const DicomStack& stack, const std::vector<DicomFile>& files, const Mapping& mapping,
              const Progress& callback, std::map<std::size_t, std::string>& failed) {
  const std::size_t sliceVoxels =
      static_cast<std::size_t>(stack.grid.dims.x) * static_cast<std::size_t>(stack.grid.dims.y);
  checkMemory(files[stack.frames.front().file].path, saturatingProduct(stack.grid.voxelCount(), sizeOf(mapping.type)));
  Voxels voxels(mapping.type, stack.grid.voxelCount());

  // Slices in the order they are stored, so that each thread opens a file once.
  std::vector<std::size_t> order(stack.frames.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(stack.frames[a].file, stack.frames[a].number) <
           std::pair(stack.frames[b].file, stack.frames[b].number);
  });
  SharedProgress progress(callback, headersShare, 1.0, order.size(), "reading slices");
  std::mutex mutex;
  parallelFor(order.size(), 1, [&](std::size_t begin, std::size_t end) {
    std::optional<DicomDecoder> decoder;
    std::span<const std::byte> words;
    const DicomFrame* last = nullptr;
    for (std::size_t i = begin; i < end; ++i) {
      progress.step();
      const DicomFrame& frame = stack.frames[order[i]];
      const DicomFile& file = files[frame.file];
      try {
        if (!last || last->file != frame.file) decoder.emplace(file);
        if (!last || last->file != frame.file || last->number != frame.number) words = decoder->decode(frame.number);
        storeSlice(words, frame, file, mapping.applied, voxels, order[i] * sliceVoxels);
        last = &frame;
      } catch (const Error& error) {
        const std::scoped_lock lock(mutex);
        failed.emplace(frame.file, error.cause());
        last = nullptr;
      }
    }
  });
  return voxels;
}

Modality modalityNamed(const std::string& name) {
  if (name == "CT") return Modality::CT;
  if (name == "MR") return Modality::MR;
  return Modality::Unknown;
}

void addContentWarnings(const DicomStack& stack, const std::vector<DicomFile>& files, std::vector<Warning>& warnings) {
  const DicomFile& file = files[stack.frames.front().file];
  if (file.mosaicUnsplit)
    warnings.push_back({Warning::Kind::Other,
                        "the slices of a volume lie side by side in one picture (mosaic); it is shown as one slice",
                        {file.path}});
}

}  // namespace

std::vector<SeriesInfo> listDicomSeries(const fs::path& path, const OpenOptions& options) {
  std::vector<SeriesInfo> series;
  for (Candidate& candidate : candidatesOf(scanHeaders(path, options))) series.push_back(std::move(candidate.info));
  return series;
}

OpenedVolume openDicom(const fs::path& path, const OpenOptions& options) {
  Scan scan = scanHeaders(path, options);
  for (;;) {
    std::vector<Candidate> candidates = candidatesOf(scan);
    const std::size_t choice = chosen(candidates, path, options.series);
    const DicomStack& stack = candidates[choice].stack;
    const Mapping mapping = mappingOf(stack, scan.files);
    std::map<std::size_t, std::string> failed;
    Voxels voxels = decode(stack, scan.files, mapping, options.progress, failed);
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

    const DicomFile& first = scan.files[stack.frames.front().file];
    auto volume = std::make_shared<Volume>();
    volume->grid = stack.grid;
    volume->slope = mapping.slope;
    volume->intercept = mapping.intercept;
    volume->modality = modalityNamed(first.modality);
    volume->unit = first.unit;
    volume->windows = stack.frames[stack.frames.size() / 2].windows;
    volume->voxels = narrowed(std::move(voxels));
    volume->computeRange();
    volume->lowIsWhite = scan.files[stack.frames.front().file].monochrome1;

    OpenedVolume opened;
    opened.volume = std::move(volume);
    opened.format = "DICOM";
    opened.warnings = stack.warnings;
    addContentWarnings(stack, scan.files, opened.warnings);
    addSegmentations(scan, stack, opened);
    addScanWarnings(scan, opened.warnings);
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (i == choice)
        opened.series = candidates[i].info;
      else
        opened.otherSeries.push_back(candidates[i].info);
    return opened;
  }
}

}  // namespace fenestra::io
