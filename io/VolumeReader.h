#pragma once
// One call opens any volume: a DICOM folder or file, NIfTI, NRRD, MetaImage, or raw bytes with a description.

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/Error.h"
#include "rendering/scene/LabelMap.h"
#include "rendering/scene/Volume.h"

namespace fenestra::io {

/// Endings of the formats that hold a volume in one or two files, in lower case. Reading goes by content; endings serve
/// file dialogs, dropped files and messages.
inline constexpr std::array<std::string_view, 8> volumeEndings{".nii",  ".nii.gz", ".hdr", ".img",
                                                               ".nrrd", ".nhdr",   ".mha", ".mhd"};
/// The one of them that a file's name ends in, whatever the case; empty when there is none.
std::string_view volumeEnding(const std::filesystem::path& path);

/// Called now and then, from one thread at a time, with a fraction in [0, 1] and what is being done; false cancels.
using Progress = std::function<bool(double fraction, std::string_view doing)>;

/// What was noticed about a file's geometry or content that the user must know; the volume is still usable.
struct Warning {
  enum class Kind {
    GantryTilt,
    UnevenSpacing,
    MissingSlices,
    DuplicateSlices,
    MixedSizes,
    MixedOrientations,
    UnreadableFiles,
    NoGeometry,
    PrecisionLoss,
    TimePoints,   ///< the file or series holds further volumes of the same place (time, repeats, layers); one is shown
    MovedData,    ///< a session's data lie elsewhere now
    ChangedData,  ///< a session's data are not what they were
    Other
  };
  Kind kind = Kind::Other;
  std::string text;                          ///< one sentence, with figures
  std::vector<std::filesystem::path> files;  ///< which files it is about; may be empty
};

/// How to read bytes without a header.
struct RawDescription {
  glm::ivec3 dims{0};
  ScalarType type = ScalarType::UInt8;
  bool bigEndian = false;
  std::size_t skip = 0;  ///< bytes before the first voxel
  glm::dvec3 spacing{1.0};
  bool operator==(const RawDescription&) const = default;
};
/// "WxHxD:TYPE[:le|be][:skip=BYTES]", e.g. "256x256x128:uint16:be:skip=512". Throws Error.
RawDescription parseRawDescription(std::string_view text);

struct OpenOptions {
  std::string series = {};  ///< a series' id as listSeries gives it, or its seriesKey(); empty: the largest
  std::optional<RawDescription> raw = {};  ///< read PATH as raw bytes
  Progress progress = {};                  ///< may be empty
};

/// A stack of images that forms one volume. `id` tells stacks of one SeriesInstanceUID apart ("UID", "UID#2", …; an
/// empty UID reads "no-uid"); outside DICOM it is the file's name.
struct SeriesInfo {
  std::string id;
  std::string modality;     ///< "CT", "MR", …; empty outside DICOM
  std::string description;  ///< SeriesDescription; may hold anything the operator typed
  glm::ivec3 dims{0};
  std::vector<std::filesystem::path> files;
};

/// A name for a series that gives nothing of it away: a hash of its id.
std::string seriesKey(const std::string& id);

struct OpenedVolume {
  std::shared_ptr<const Volume> volume;
  std::string format;  ///< "DICOM", "NIfTI", "NRRD", "MetaImage", "raw"
  SeriesInfo series;
  std::vector<SeriesInfo> otherSeries;
  std::vector<Warning> warnings;
};

/// The series (or single volume) in PATH, without decoding pixels. Throws Error, Cancelled.
std::vector<SeriesInfo> listSeries(const std::filesystem::path& path, const OpenOptions& options = {});
/// Opens a volume. Voxel values come out exactly as the format defines them, geometry in LPS mm. Throws Error,
/// Cancelled.
OpenedVolume openVolume(const std::filesystem::path& path, const OpenOptions& options = {});

struct OpenedLabels {
  std::shared_ptr<const LabelMap> labels;
  std::vector<Warning> warnings;  ///< e.g. that it was resampled, or lies outside the volume
};
/// Opens a label map (NIfTI, NRRD incl. Slicer's segment fields, MetaImage) and resamples it to `target` by nearest
/// label when its grid differs. Names come from the file, or from a table of "value name" lines beside it: the file's
/// own name with .txt or .tsv, or labels.tsv. Throws Error, Cancelled.
OpenedLabels openLabels(const std::filesystem::path& path, const Grid& target, const Progress& progress = {});

}  // namespace fenestra::io
