#include "io/dicom/Dicom.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "io/base/Contents.h"
#include "io/base/PlausibleGrid.h"
#include "io/base/SeriesChoice.h"
#include "io/base/VoxelSink.h"
#include "io/dicom/DicomRemarks.h"
#include "io/dicom/DicomScan.h"
#include "io/dicom/DicomStack.h"
#include "io/dicom/DicomVoxels.h"
#include "io/dicom/ImageParts.h"
#include "io/dicom/LabelObject.h"
#include "io/dicom/PackedFiles.h"
#include "io/dicom/PlaceSlices.h"
#include "io/dicom/StackFrames.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// How far the bar is after the headers and after the pixels, which take most of the time.
constexpr double headersShare = 0.2, pixelsShare = 0.95;

struct Candidate {
  SeriesInfo info;
  DicomStack stack;
};

/// All but the id.
SeriesInfo describe(const DicomStack& stack, const std::vector<DicomFile>& files) {
  const DicomFrame& frame = stack.frames.front();
  const DicomFile& first = files[frame.file];
  SeriesInfo info;
  info.modality = first.modality;
  info.description = first.description;
  info.study = first.study;
  info.studyUid = first.studyUid;
  info.date = first.date;
  info.dims = stack.grid.dims;
  info.part = stack.part;
  info.time = stack.time;
  info.times = stack.times;
  info.number = first.seriesNumber;
  info.imageType = frame.frameType.empty() ? first.imageType : frame.frameType;
  info.sopClass = first.sopClass;
  info.kernel = kernelOf(frame.parts);
  info.step = stack.grid.dims.z > 1 && frame.hasGeometry ? stack.grid.spacing.z : 0.0;
  info.thickness = frame.thickness;
  info.plausible = !implausibility(stack.grid);
  info.patient = first.patient;
  std::set<std::size_t> listed;
  for (const DicomFrame& each : stack.frames)
    if (listed.insert(each.file).second) info.files.push_back(files[each.file].path);
  return info;
}

/// The sources of a stack's slices among the files that describe() lists for it.
std::vector<SliceSource> sourcesOf(const DicomStack& stack) {
  std::map<std::size_t, std::uint32_t> listed;
  std::vector<SliceSource> sources;
  for (const DicomFrame& frame : stack.frames) {
    const auto file = listed.emplace(frame.file, static_cast<std::uint32_t>(listed.size())).first;
    sources.push_back({file->second, static_cast<std::uint32_t>(frame.number)});
  }
  return sources;
}

/// All volumes of a scan, series by series in the order their first files have; the largest of a series first.
std::vector<Candidate> candidatesOf(const DicomScan& scan) {
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
      SeriesInfo info = describe(stacks[n], scan.files);
      info.id = (uid.empty() ? "no-uid" : uid) + (n == 0 ? "" : "#" + std::to_string(n + 1));
      candidates.push_back({std::move(info), std::move(stacks[n])});
    }
  }
  return candidates;
}

SeriesChoice firstOf(const std::vector<Candidate>& candidates) {
  std::vector<SeriesInfo> series;
  for (const Candidate& candidate : candidates) series.push_back(candidate.info);
  return firstSeries(series);
}

/// The series that the options name; otherwise the first by the rule.
std::size_t chosenSeries(const std::vector<Candidate>& candidates, const fs::path& path, const std::string& id) {
  if (id.empty()) return firstOf(candidates).index;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i].info.id == id || seriesKey(candidates[i].info.id) == id) return i;
  throw Error(path, "has no series " + id, "list its series with: fenestra-cli info " + path.string());
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

/// What stands behind the last run of RLE frames.
void warnOfBytesBehind(const DecodedStack& decoded, const std::vector<DicomFile>& files,
                       std::vector<Warning>& warnings) {
  std::size_t bytes = 0;
  std::vector<fs::path> paths;
  for (const auto& [file, count] : decoded.bytesBehind) {
    bytes += count;
    paths.push_back(files[file].path);
  }
  if (bytes > 0)
    warnings.push_back({Warning::Kind::DamagedPixels,
                        std::to_string(bytes) +
                            " bytes behind the last run of RLE pixels left out; the compressed pixels may be damaged",
                        std::move(paths)});
}

/// Those of the segmentations that belong to a stack; of the others, a warning a reason.
void addSegmentations(const DicomScan& scan, const DicomStack& stack, OpenedVolume& opened) {
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

Modality modalityNamed(const std::string& name) {
  if (name == "CT") return Modality::CT;
  if (name == "MR") return Modality::MR;
  if (name == "PT" || name == "NM") return Modality::PT;
  if (name == "US") return Modality::US;
  return Modality::Unknown;
}

OpenedVolume openScanned(const fs::path& path, const OpenOptions& options, PackedFiles& packed) {
  DicomScan scan = scanHeaders(path, {options.progress, 0.0, headersShare}, packed);
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
    opened.slices = sourcesOf(stack);
    opened.patient = first.patient;
    if (const SeriesChoice rule = firstOf(candidates); rule.index == choice) opened.reason = rule.reason;
    if (opened.geometry) opened.warnings = opened.geometry->findings;
    opened.warnings.insert(opened.warnings.end(), stack.warnings.begin(), stack.warnings.end());
    addSegmentations(scan, stack, opened);
    for (Warning& remark : remarksOn(stack, scan.files)) opened.warnings.push_back(std::move(remark));
    warnOfSamplesOutside(decoded, scan.files, opened.warnings);
    warnOfBytesBehind(decoded, scan.files, opened.warnings);
    if (options.series.empty()) warnOfImplausibleSeries(candidates, opened.warnings);
    addScanWarnings(scan, first.series, opened.warnings);
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
    for (Candidate& candidate : candidatesOf(scanHeaders(path, {options.progress, 0.0, headersShare}, packed))) {
      for (fs::path& file : candidate.info.files) file = packed.named(file);
      series.push_back(std::move(candidate.info));
    }
    return series;
  });
}

ListedSlices listDicomSlices(const fs::path& path, const OpenOptions& options) {
  return withPackedFiles([&](PackedFiles& packed) {
    std::vector<Candidate> candidates = candidatesOf(scanHeaders(path, {options.progress, 0.0, 1.0}, packed));
    Candidate& candidate = candidates[chosen(candidates, path, options)];
    for (fs::path& file : candidate.info.files) file = packed.named(file);
    return ListedSlices{std::move(candidate.info), sourcesOf(candidate.stack)};
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
