#include "io/dicom/DicomHeader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>

#include "io/base/ByteStream.h"
#include "io/base/Error.h"
#include "io/base/Text.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/Dicom.h"
#include "io/dicom/LabelObject.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

std::vector<WindowLevel> windowsIn(DcmItem& item) {
  std::vector<WindowLevel> windows;
  // 16: more windows than any menu shows.
  for (unsigned long i = 0; i < 16; ++i) {
    const auto level = number(item, DCM_WindowCenter, i), width = number(item, DCM_WindowWidth, i);
    if (!level || !width) break;
    if (*width > 0.0) windows.push_back({*width, *level});
  }
  return windows;
}

std::string frameTypeOf(const Scopes& scopes) {
  for (const DcmTagKey& sequence :
       {DCM_MRImageFrameTypeSequence, DCM_CTImageFrameTypeSequence, DCM_PETFrameTypeSequence})
    for (DcmItem* groups : {scopes.perFrame, scopes.shared})
      if (DcmItem* item = firstItem(groups, sequence)) return text(*item, DCM_FrameType);
  return {};
}

DicomFrame readFrame(const Scopes& scopes, const DicomFile& file, int index) {
  DicomFrame frame;
  frame.number = index;
  frame.size = {file.format.columns, file.format.rows};
  readGeometry(scopes, frame);
  DcmItem* transform = scopes.group(DCM_PixelValueTransformationSequence);
  if (!transform) transform = &scopes.dataset;
  // A slope of 0 would erase the image; it stands for "not set" in the files that have it.
  const double slope = number(*transform, DCM_RescaleSlope).value_or(1.0);
  frame.slope = slope == 0.0 ? 1.0 : slope;
  frame.intercept = number(*transform, DCM_RescaleIntercept).value_or(0.0);
  DcmItem* display = scopes.group(DCM_FrameVOILUTSequence);
  frame.windows = windowsIn(display ? *display : scopes.dataset);
  frame.frameOfReference = text(scopes.dataset, DCM_FrameOfReferenceUID);
  frame.frameType = frameTypeOf(scopes);
  for (DcmItem* groups : {scopes.perFrame, scopes.shared})
    if (DcmItem* content = firstItem(groups, DCM_FrameContentSequence)) {
      frame.stack = text(*content, DCM_StackID);
      frame.temporal = integer(*content, DCM_TemporalPositionIndex).value_or(0);
      break;
    }
  if (!scopes.perFrame) frame.temporal = integer(scopes.dataset, DCM_TemporalPositionIdentifier).value_or(0);
  frame.acquisition = integer(scopes.dataset, DCM_AcquisitionNumber).value_or(0);
  frame.instance = integer(scopes.dataset, DCM_InstanceNumber).value_or(0);
  return frame;
}

/// RT dose (PS3.3 C.8.8.3): frames along the normal at Grid Frame Offset Vector's offsets.
void placeDoseFrames(DcmItem& dataset, DicomFile& file) {
  const double scaling = number(dataset, DCM_DoseGridScaling).value_or(1.0);
  const double first = number(dataset, DCM_GridFrameOffsetVector, 0).value_or(0.0);
  for (std::size_t i = 0; i < file.frames.size(); ++i) {
    DicomFrame& frame = file.frames[i];
    frame.slope = scaling;
    const auto offset = number(dataset, DCM_GridFrameOffsetVector, i);
    if (!offset) {
      frame.hasGeometry = frame.hasGeometry && file.frames.size() == 1;
      continue;
    }
    // Offsets start at 0, or are the slices' own z (C.8.8.3.2): both give distances from the first.
    frame.position += glm::cross(frame.axes[0], frame.axes[1]) * (*offset - first);
  }
  const std::string units = text(dataset, DCM_DoseUnits);
  file.unit = units == "GY" ? "Gy" : lowered(units);
}

/// Numbers of one element of a Siemens CSA header (version SV10): tags of named strings.
std::vector<double> csaNumbers(const Uint8* data, unsigned long size, const std::string& name) {
  const auto word = [&](unsigned long at) -> std::uint64_t {
    if (at + 4 > size) return 0;
    return std::uint64_t{data[at]} | std::uint64_t{data[at + 1]} << 8 | std::uint64_t{data[at + 2]} << 16 |
           std::uint64_t{data[at + 3]} << 24;
  };
  std::vector<double> values;
  if (size < 16 || std::memcmp(data, "SV10", 4) != 0) return values;
  const std::uint64_t tags = word(8);
  unsigned long at = 16;
  for (std::uint64_t tag = 0; tag < tags && at + 84 <= size; ++tag) {
    const char* tagName = reinterpret_cast<const char*>(data + at);
    const bool wanted = std::string(tagName, ::strnlen(tagName, 64)) == name;
    const std::uint64_t items = word(at + 76);
    at += 84;
    for (std::uint64_t item = 0; item < items && at + 16 <= size; ++item) {
      const std::uint64_t length = word(at + 4);
      at += 16;
      if (length > size - at) return values;
      const char* itemText = reinterpret_cast<const char*>(data + at);
      const auto value = numberIn<double>(trimmed({itemText, ::strnlen(itemText, length)}));
      if (wanted && value) values.push_back(*value);
      at += (length + 3) / 4 * 4;
      if (at > size) return values;
    }
    if (wanted) return values;
  }
  return values;
}

/// Siemens mosaic: the slices of a volume as tiles of one square picture, row by row. The stored position is that of
/// the whole picture laid around the slices' centre.
void splitMosaic(DcmItem& dataset, DicomFile& file) {
  file.mosaicUnsplit = true;
  const Uint8* csa = nullptr;
  unsigned long size = 0;
  if (dataset.findAndGetUint8Array(DcmTag(0x0029, 0x1010, EVR_OB), csa, &size).bad() || !csa) return;
  const auto count = csaNumbers(csa, size, "NumberOfImagesInMosaic");
  const auto normal = csaNumbers(csa, size, "SliceNormalVector");
  const double step = number(dataset, DCM_SpacingBetweenSlices).value_or(file.frames[0].thickness);
  // 1024: more slices than a mosaic of any scanner holds.
  if (count.empty() || !(count[0] >= 1 && count[0] <= 1024) || normal.size() != 3 || !(step > 0.0)) return;
  const DicomFrame whole = file.frames[0];
  const int tiles = static_cast<int>(std::ceil(std::sqrt(count[0])));
  if (!whole.hasGeometry || whole.size.x % tiles != 0 || whole.size.y % tiles != 0) return;

  file.mosaicUnsplit = false;
  file.frames.clear();
  const glm::ivec2 tile = whole.size / tiles;
  const glm::dvec2 margin = glm::dvec2(whole.size - tile) * 0.5 * whole.spacing;
  for (int slice = 0; slice < static_cast<int>(count[0]); ++slice) {
    DicomFrame frame = whole;
    frame.tile = glm::ivec2(slice % tiles, slice / tiles) * tile;
    frame.size = tile;
    frame.position =
        whole.position + whole.axes * margin + glm::dvec3(normal[0], normal[1], normal[2]) * (step * slice);
    file.frames.push_back(frame);
  }
}

std::shared_ptr<const ModalityLut> modalityLut(DcmItem& dataset, const PixelFormat& format) {
  DcmItem* item = firstItem(&dataset, DCM_ModalityLUTSequence);
  if (!item) return nullptr;
  auto lut = std::make_shared<ModalityLut>();
  Uint16 entries = 0, first = 0;
  Sint16 signedFirst = 0;
  const Uint16* data = nullptr;
  unsigned long count = 0;
  if (item->findAndGetUint16(DCM_LUTDescriptor, entries, 0).bad()) {
    Sint16 signedEntries = 0;
    item->findAndGetSint16(DCM_LUTDescriptor, signedEntries, 0);
    entries = static_cast<Uint16>(signedEntries);
  }
  if (item->findAndGetUint16(DCM_LUTDescriptor, first, 1).good())
    lut->first = format.isSigned ? static_cast<std::int16_t>(first) : first;
  else if (item->findAndGetSint16(DCM_LUTDescriptor, signedFirst, 1).good())
    lut->first = signedFirst;
  if (item->findAndGetUint16Array(DCM_LUTData, data, &count).bad() || !data || count == 0) return nullptr;
  // An entry count of 0 means 65536.
  const std::size_t described = entries == 0 ? 65536 : entries;
  lut->values.assign(data, data + std::min<std::size_t>(described, count));
  return lut;
}

/// Why a dataset is no stack of scalar images; empty when it is one.
std::string refusalOf(DcmItem& dataset, const PixelFormat& format, const std::string& sopClass) {
  if (sopClass == UID_RTStructureSetStorage) return "is a DICOM structure set, not an image";
  if (isLabelClass(sopClass)) return "is a DICOM segmentation, not an image";
  if (format.rows < 1 || format.columns < 1) return "holds no image";
  const std::string photometric = text(dataset, DCM_PhotometricInterpretation);
  if (integer(dataset, DCM_SamplesPerPixel).value_or(1) != 1 ||
      (!photometric.empty() && !photometric.starts_with("MONOCHROME")))
    return "holds colours (" + (photometric.empty() ? "several samples a pixel" : photometric) + "), not values";
  const bool whole = format.bitsAllocated == 8 || format.bitsAllocated == 16 || format.bitsAllocated == 32;
  if (!whole || format.bitsStored < 1 || format.bitsStored > format.bitsAllocated ||
      format.highBit + 1 < format.bitsStored || format.highBit >= format.bitsAllocated)
    return "has pixels of " + std::to_string(format.bitsStored) + " bits in " + std::to_string(format.bitsAllocated) +
           ", which is not supported";
  return {};
}

}  // namespace

DicomFile readDicomHeader(const fs::path& path) {
  DcmFileFormat fileFormat;
  loadHeader(path, fileFormat);
  DcmDataset& dataset = *fileFormat.getDataset();
  DicomFile file;
  file.path = path;
  const std::string sopClass = text(dataset, DCM_SOPClassUID);
  if (sopClass.empty() && !dataset.tagExists(DCM_Rows))
    throw Error(path, "its DICOM header names no object", "the file is truncated or damaged");
  file.sopClass = sopClass;
  file.instance = text(dataset, DCM_SOPInstanceUID);
  file.series = text(dataset, DCM_SeriesInstanceUID);
  file.modality = text(dataset, DCM_Modality);
  file.description = typedText(dataset, DCM_SeriesDescription);

  PixelFormat& format = file.format;
  format.rows = static_cast<int>(integer(dataset, DCM_Rows).value_or(0));
  format.columns = static_cast<int>(integer(dataset, DCM_Columns).value_or(0));
  format.bitsAllocated = static_cast<int>(integer(dataset, DCM_BitsAllocated).value_or(0));
  format.bitsStored = static_cast<int>(integer(dataset, DCM_BitsStored).value_or(format.bitsAllocated));
  format.highBit = static_cast<int>(integer(dataset, DCM_HighBit).value_or(format.bitsStored - 1));
  format.isSigned = integer(dataset, DCM_PixelRepresentation).value_or(0) == 1;
  file.refusal = refusalOf(dataset, format, sopClass);
  if (isLabelClass(sopClass)) file.labels = std::make_shared<DicomLabelObject>(labelObjectIn(dataset, path));
  if (!file.refusal.empty()) return file;

  file.monochrome1 = text(dataset, DCM_PhotometricInterpretation) == "MONOCHROME1";
  file.lut = modalityLut(dataset, format);
  const std::string rescaleType = text(dataset, DCM_RescaleType);
  if (file.modality == "CT") file.unit = rescaleType.empty() || rescaleType == "US" ? "HU" : rescaleType;
  if (file.modality == "PT") file.unit = text(dataset, DCM_Units);

  const std::int64_t frames = integer(dataset, DCM_NumberOfFrames).value_or(1);
  checkFrameBytes(dataset, path, frames, format.rows, format.columns, format.bitsAllocated);

  DcmSequenceOfItems* perFrame = nullptr;
  dataset.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, perFrame);
  DcmItem* shared = firstItem(&dataset, DCM_SharedFunctionalGroupsSequence);
  const bool hasGroups = perFrame || shared;
  DcmObject* next = nullptr;
  for (std::int64_t index = 0; index < frames; ++index) {
    if (perFrame) next = perFrame->nextInContainer(next);
    if (!next) perFrame = nullptr;  // fewer items than frames
    file.frames.push_back(readFrame({dynamic_cast<DcmItem*>(next), shared, dataset}, file, static_cast<int>(index)));
  }
  if (sopClass == UID_RTDoseStorage)
    placeDoseFrames(dataset, file);
  else if (frames > 1 && !hasGroups)
    // One position for many frames: the format says nothing about where the others are.
    for (DicomFrame& frame : file.frames) frame.hasGeometry = false;
  if (frames == 1 && text(dataset, DCM_ImageType).find("MOSAIC") != std::string::npos) splitMosaic(dataset, file);
  return file;
}

bool looksLikeDicom(const fs::path& file) {
  constexpr std::size_t preamble = 128;
  std::array<char, preamble + 4> bytes{};
  const std::size_t got =
      openStream(file, 0, Packing::None)->read(reinterpret_cast<std::byte*>(bytes.data()), bytes.size());
  if (got == bytes.size() && std::memcmp(bytes.data() + preamble, "DICM", 4) == 0) return true;
  // Without the preamble a dataset starts with an even, small group: 0002 or 0008, either byte order.
  const bool little = (bytes[0] == 2 || bytes[0] == 8) && bytes[1] == 0 && bytes[3] == 0;
  const bool big = bytes[0] == 0 && bytes[1] == 8 && bytes[2] == 0;
  if (got < 8 || !(little || big)) return false;
  try {
    return !readDicomHeader(file).instance.empty();
  } catch (const Error&) {
    return false;
  }
}

}  // namespace fenestra::io
