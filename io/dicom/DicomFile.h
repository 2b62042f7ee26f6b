#pragma once
// What a DICOM file's header says about its images: everything that stacking and decoding need, without pixels.
// Attribute names are DICOM's (PS3.6); geometry as in PS3.3 C.7.6.2.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/base/Reading.h"
#include "io/dicom/DicomPixels.h"
#include "rendering/volume/Volume.h"

namespace fenestra::io {

struct DicomLabelObject;

enum class Sample : std::uint8_t { Integer, Float32, Float64 };

/// How samples lie in their words.
struct PixelFormat {
  Sample sample = Sample::Integer;
  int rows = 0, columns = 0;  ///< of the stored frame
  int bitsAllocated = 0, bitsStored = 0, highBit = 0;
  bool isSigned = false;
  /// The range of integers that the format can store.
  std::int64_t least() const { return isSigned ? -(std::int64_t{1} << (bitsStored - 1)) : 0; }
  std::int64_t greatest() const { return (std::int64_t{1} << (isSigned ? bitsStored - 1 : bitsStored)) - 1; }
  std::size_t frameBytes() const {
    return static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns) *
           static_cast<std::size_t>(bitsAllocated / 8);
  }
};

/// Stored values that an image holds, as its header says.
struct ValueLimits {
  std::int64_t least = 0, greatest = 0;                ///< Smallest and Largest Image Pixel Value
  std::int64_t leastPadding = 1, greatestPadding = 0;  ///< of padding, which these leave out; empty when reversed
  bool contain(std::int64_t value) const {
    return (value >= least && value <= greatest) || (value >= leastPadding && value <= greatestPadding);
  }
};

/// Modality LUT Sequence (PS3.3 C.11.1): stored values from `first` on become values[0], values[1], …; clamped beyond.
struct ModalityLut {
  std::int64_t first = 0;
  std::vector<std::uint16_t> values;
  bool operator==(const ModalityLut&) const = default;
};

/// What a header lacks or garbles, so that a default takes its place or it is ignored; bits of DicomFrame::assumed.
namespace assumed {
inline constexpr unsigned spacing = 1;          ///< no pixel spacing: 1 mm
inline constexpr unsigned garbledSpacing = 2;   ///< one that is not two positive numbers: 1 mm
inline constexpr unsigned detectorSpacing = 4;  ///< that on the detector, which is magnified, in place of the patient's
inline constexpr unsigned slope = 8;            ///< none or 0 or no number: 1
inline constexpr unsigned intercept = 16;       ///< no number: 0
inline constexpr unsigned doseScaling = 32;     ///< none or 0 or no number: 1
inline constexpr unsigned lut = 64;             ///< a Modality LUT that cannot be read: ignored
inline constexpr unsigned representation = 128;    ///< neither signed nor unsigned: unsigned
inline constexpr unsigned photometric = 256;       ///< none: MONOCHROME2
inline constexpr unsigned realWorldValues = 512;   ///< a mapping to physical values: not applied
inline constexpr unsigned decimalCommas = 1024;    ///< numbers with a comma: read as decimals
inline constexpr unsigned followingFrames = 2048;  ///< the place of the first frame alone: the others follow it
inline constexpr unsigned volumePlace = 4096;      ///< places in the frame of an ultrasound volume
inline constexpr unsigned noFrames = 8192;         ///< a number of frames of 0: 1
inline constexpr unsigned acrNema = 16384;         ///< a file from before DICOM: its place is taken for DICOM's
}  // namespace assumed

/// One slice. Usually a whole stored frame; of a mosaic a tile of it.
struct DicomFrame {
  std::size_t file = 0;  ///< index into the scanned files
  int number = 0;        ///< of the stored frame in its file, from 0
  glm::ivec2 tile{0};    ///< column and row of the slice's first pixel in the stored frame
  glm::ivec2 size{0};    ///< columns and rows of the slice

  bool hasGeometry = false;
  glm::dvec3 position{0.0};        ///< centre of the first pixel, LPS mm
  glm::dmat2x3 axes{1.0};          ///< unit vectors along a row and down a column
  glm::dvec2 spacing{1.0};         ///< mm between columns and between rows
  bool hasAxes = false;            ///< the axes are the header's; true with geometry
  bool ownPlace = false;           ///< given for this frame, not for the first one of its file
  double thickness = 0.0;          ///< mm, of the slice; 0 when not said
  double step = 0.0;               ///< mm, Spacing Between Slices; 0 when not said
  std::optional<double> location;  ///< mm, Slice Location

  double slope = 1.0, intercept = 0.0;
  std::vector<WindowLevel> windows;
  unsigned assumed = 0;  ///< bits of fenestra::io::assumed

  std::string frameOfReference, frameType, stack;  ///< frames that differ here form different volumes
  std::vector<std::string> parts;                  ///< values of the attributes of ImageParts.h, in their order
  /// Order among frames at one position.
  std::int64_t temporal = 0, acquisition = 0, instance = 0;
  double trigger = 0.0;  ///< ms behind the trigger; comes behind `temporal`
};

struct DicomFile {
  std::filesystem::path path;
  std::string sopClass, instance, series, modality, description, unit;
  std::string study, date;  ///< description of the study; YYYYMMDD of the series, or else of the study
  std::string studyUid;
  std::optional<std::int64_t> seriesNumber;
  std::string imageType;
  PatientText patient;
  std::string refusal;                             ///< why this is no scalar image; empty when it is one
  std::shared_ptr<const DicomLabelObject> labels;  ///< of a segmentation or structure set
  PixelFormat format;
  int transferSyntax = 0;      ///< DCMTK's E_TransferSyntax
  std::string syntaxUid = {};  ///< as the meta header gives it; empty: there is none
  PixelPlace pixels;
  bool monochrome1 = false;
  bool acrNema = false;        ///< from before DICOM
  bool mosaicUnsplit = false;  ///< a mosaic whose layout is unknown; it stays one slice
  std::shared_ptr<const ModalityLut> lut;
  std::optional<ValueLimits> limits;
  std::vector<DicomFrame> frames;
};

}  // namespace fenestra::io
