#pragma once
// What every reader takes, gives and throws: progress, options, warnings, the volume or label map that was read.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/base/Error.h"
#include "io/base/Phrase.h"
#include "io/base/Regularise.h"
#include "rendering/volume/LabelMap.h"
#include "rendering/volume/Volume.h"

namespace fenestra::io {

/// Called now and then, from one thread at a time, with a fraction in [0, 1] and what is being done; false cancels.
using Progress = std::function<bool(double fraction, std::string_view doing)>;
/// The part of a progress bar from `begin` to `end`; empty where `progress` is.
Progress partOf(const Progress& progress, double begin, double end);

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
    DamagedPixels,  ///< values that the header rules out; the volume is shown as decoded
    PrecisionLoss,
    TimePoints,   ///< the file or series holds further volumes of the same place (time, repeats, layers); one is shown
    MovedData,    ///< a session's data lie elsewhere now
    ChangedData,  ///< a session's data are not what they were
    Recognised,   ///< nothing is odd: what the file leaves open was told from its values
    SlicePlacement,  ///< where the slices of an irregular series are shown, and how far from their true places
    Other
  };
  Kind kind = Kind::Other;
  std::string text;                          ///< one sentence, with figures
  std::vector<std::filesystem::path> files;  ///< which files it is about; may be empty
  WayOut way = WayOut::None;                 ///< what the user can do about it

  bool operator==(const Warning&) const = default;
};

/// The warning's text and its way out, in the words of the command line.
std::string commandLineText(const Warning& warning);

/// What is odd about the places of a series' slices, and what was done about it.
struct GeometryReport {
  /// mm; what is nearer to its place than this is not mentioned. Headers round to a hundredth and below.
  static constexpr double tolerance = 0.01;

  /// What was found, in which files and how large; the last one is of Kind::SlicePlacement. OpenedVolume's warnings
  /// hold them, too.
  std::vector<Warning> findings;
  Regularise applied = Regularise::Off;  ///< Linear, Cubic or Off
  double scannedStep = 0.0, step = 0.0;  ///< mm along the normal: the series' own, and between the planes shown
  int slices = 0, planes = 0;            ///< scanned, and shown
  bool sheared = false;                  ///< the planes are stacked askew, as a tilted gantry scans them
  double displacement = 0.0;             ///< mm; no pixel is shown farther from its true place
  double displacementAsIs = 0.0;         ///< the same with Regularise::Off
  /// Those shown, counted along the volume's third axis, that lie inside gaps wider than one and a half of the own
  /// steps; ascending.
  std::vector<int> interpolatedPlanes;
  std::size_t emptyVoxels = 0;  ///< outside what was scanned; they hold the least value of the volume
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
struct OpenOptions {
  /// A series' id as listSeries gives it, or its seriesKey(); empty: the first by SeriesChoice.h.
  std::string series = {};
  /// A time point, from 1, of a file or series that holds several volumes of one place; unset: the first, or that of
  /// `series`.
  std::optional<int> time = {};
  std::optional<RawDescription> raw = {};  ///< read PATH as raw bytes
  /// The size of voxels, mm, for a format that may not say it (TIFF); an error for others.
  std::optional<glm::dvec3> spacing = {};
  /// Whether the header of a detached volume may name voxel files anywhere, not only in its own folder and below.
  bool allowOutside = false;
  Regularise regularise = Regularise::Automatic;
  /// What a volume outside DICOM is; unset: what its file says, or CT where its values are those of one.
  std::optional<Modality> modality = {};
  Progress progress = {};  ///< may be empty
};

/// What names the patient of a DICOM series, as its first file says; empty where it says nothing. For the corner text
/// of pictures and the list of series on screen alone: never for files, logs or titles.
struct PatientText {
  std::string name;       ///< "Family^Given^Middle^Prefix^Suffix"
  std::string id, sex;    ///< "F", "M" or "O"
  std::string birthDate;  ///< YYYYMMDD
  bool isEmpty() const { return name.empty() && id.empty() && sex.empty() && birthDate.empty(); }
};

/// A stack of images that forms one volume. `id` tells stacks of one SeriesInstanceUID apart ("UID", "UID#2", …; an
/// empty UID reads "no-uid"); outside DICOM it is the file's name ("NAME", and "NAME#2", … for later time points).
struct SeriesInfo {
  std::string id;
  std::string modality;     ///< "CT", "MR", …; empty outside DICOM
  std::string description;  ///< SeriesDescription; may hold anything the operator typed
  glm::ivec3 dims{0};
  std::vector<std::filesystem::path> files;
  std::string part;         ///< what tells it from others of its series, "echo time 4.92 ms"; empty: nothing
  int time = 0, times = 0;  ///< which of how many time points, from 1; 0: it is the only one
  std::string study;        ///< StudyDescription; may hold anything the operator typed
  std::string studyUid;     ///< empty outside DICOM
  std::string date;         ///< of the series, or else of the study, YYYYMMDD; empty outside DICOM

  // What only DICOM says; of the first image.
  std::optional<std::int64_t> number;  ///< SeriesNumber
  std::string imageType;               ///< Image Type or Frame Type, "ORIGINAL\PRIMARY\AXIAL"
  std::string sopClass;                ///< UID
  std::string kernel;                  ///< reconstruction kernel of CT; empty when not said
  double step = 0.0;                   ///< mm between slices; 0 for one slice, or where places are unknown
  double thickness = 0.0;              ///< mm, of a slice; 0 when not said
  bool plausible = true;               ///< false: its geometry is none that a scanner has, and it cannot be opened
  PatientText patient;
};

/// A segmentation that lies beside a DICOM series and belongs to it; openLabels opens its file.
struct SegmentationInfo {
  std::filesystem::path file;
  std::string kind;                     ///< "SEG" or "RTSTRUCT"
  std::string description;              ///< its series' description or its own label; may hold anything typed
  std::vector<std::string> structures;  ///< their names, in the file's order
};

/// Where a scanned slice lies: its file, an index into SeriesInfo::files, and the stored frame in it, from 0.
struct SliceSource {
  std::uint32_t file = 0, frame = 0;
  bool operator==(const SliceSource&) const = default;
};

/// A series with the sources of its slices.
struct ListedSlices {
  SeriesInfo series;
  std::vector<SliceSource> slices;  ///< as VolumeInfo has them
};

/// What is known of an open volume beside its voxels.
struct VolumeInfo {
  std::string format;  ///< "DICOM", "NIfTI", "NRRD", "MetaImage", "MGH", "Analyze", "TIFF", "raw", "phantom"
  SeriesInfo series;
  PatientText patient;
  std::vector<SeriesInfo> otherSeries;
  /// Why `series` opens first of several, "the thinnest acquired volume, 1.0 mm"; empty: another one does, or all are
  /// alike.
  Phrase reason;
  std::vector<SegmentationInfo> segmentations;  ///< of the series, among the files that were opened with it
  std::optional<Modality> modality;             ///< told by OpenOptions or recognised; unset: the file's own
  std::optional<GeometryReport> geometry;  ///< of a series whose slices do not lie straight behind each other, evenly
  /// Sources of a DICOM series outside archives, in the order of the volume's third axis; each is the plane of its
  /// number unless `geometry` says that planes were interpolated between slices. Otherwise empty.
  std::vector<SliceSource> slices;
};

struct OpenedVolume : VolumeInfo {
  std::shared_ptr<const Volume> volume;
  std::vector<Warning> warnings;  ///< the geometry's findings, too
};

struct OpenedLabels {
  std::shared_ptr<const LabelMap> labels;
  std::vector<Warning> warnings;  ///< e.g. that it was resampled, or lies outside the volume
};

/// Throws the Error for a time point of `path` that does not exist among `times`; 0 or 1: there is only one volume.
[[noreturn]] void throwNoTime(const std::filesystem::path& path, int time, int times);

}  // namespace fenestra::io
