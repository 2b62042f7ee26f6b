#include "io/dicom/DicomHeader.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/base/Error.h"
#include "io/base/Text.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomValues.h"
#include "io/dicom/FramePlaces.h"
#include "io/dicom/ImageParts.h"
#include "io/dicom/LabelObject.h"
#include "io/dicom/Mosaic.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

std::vector<WindowLevel> windowsIn(DcmItem& item) {
  std::vector<WindowLevel> windows;
  // 16: more windows than any menu shows.
  for (unsigned long i = 0; i < 16; ++i) {
    const auto level = numberOf(item, DCM_WindowCenter, i), width = numberOf(item, DCM_WindowWidth, i);
    if (!level || !width) break;
    if (*width > 0.0) windows.push_back({*width, *level});
  }
  return windows;
}

std::string frameTypeOf(const Scopes& scopes) {
  for (const DcmTagKey& sequence : {DCM_MRImageFrameTypeSequence, DCM_CTImageFrameTypeSequence,
                                    DCM_PETFrameTypeSequence, DCM_ParametricMapFrameTypeSequence})
    for (DcmItem* groups : {scopes.perFrame, scopes.shared})
      if (DcmItem* item = firstItem(groups, sequence)) return textOf(*item, DCM_FrameType);
  return {};
}

/// A factor or summand of stored values: the attribute, or `otherwise` and a bit of DicomFrame::assumed when its value
/// is no usable number.
double mappingNumber(DcmItem& item, const DcmTagKey& tag, double otherwise, unsigned bit, DicomFrame& frame) {
  if (!item.tagExists(tag)) return otherwise;
  // 1e30: beyond it the values of an image would fit no float.
  const auto value = numberOf(item, tag);
  const bool isFactor = otherwise != 0.0;
  if (value && std::abs(*value) < 1e30 && !(isFactor && *value == 0.0)) return *value;
  frame.assumed |= bit;
  return otherwise;
}

DicomFrame readFrame(const Scopes& scopes, const DicomFile& file, int index) {
  DicomFrame frame;
  frame.number = index;
  frame.size = {file.format.columns, file.format.rows};
  readGeometry(scopes, frame);
  DcmItem* transform = scopes.group(DCM_PixelValueTransformationSequence);
  if (!transform) transform = &scopes.dataset;
  frame.slope = mappingNumber(*transform, DCM_RescaleSlope, 1.0, assumed::slope, frame);
  frame.intercept = mappingNumber(*transform, DCM_RescaleIntercept, 0.0, assumed::intercept, frame);
  DcmItem* display = scopes.group(DCM_FrameVOILUTSequence);
  frame.windows = windowsIn(display ? *display : scopes.dataset);
  frame.frameOfReference = textOf(scopes.dataset, DCM_FrameOfReferenceUID);
  frame.frameType = frameTypeOf(scopes);
  for (DcmItem* groups : {scopes.perFrame, scopes.shared})
    if (DcmItem* content = firstItem(groups, DCM_FrameContentSequence)) {
      frame.stack = textOf(*content, DCM_StackID);
      frame.temporal = integerOf(*content, DCM_TemporalPositionIndex).value_or(0);
      break;
    }
  if (!scopes.perFrame) frame.temporal = integerOf(scopes.dataset, DCM_TemporalPositionIdentifier).value_or(0);
  frame.parts = partsOf(scopes, index);
  frame.trigger = numberOf(scopes.dataset, DCM_TriggerTime).value_or(0.0);
  frame.acquisition = integerOf(scopes.dataset, DCM_AcquisitionNumber).value_or(0);
  frame.instance = integerOf(scopes.dataset, DCM_InstanceNumber).value_or(0);
  return frame;
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

PixelFormat pixelFormatOf(DcmItem& dataset, const PixelPlace& pixels) {
  PixelFormat format;
  format.rows = static_cast<int>(integerOf(dataset, DCM_Rows).value_or(0));
  format.columns = static_cast<int>(integerOf(dataset, DCM_Columns).value_or(0));
  format.bitsAllocated = static_cast<int>(integerOf(dataset, DCM_BitsAllocated).value_or(0));
  format.bitsStored = static_cast<int>(integerOf(dataset, DCM_BitsStored).value_or(format.bitsAllocated));
  format.highBit = static_cast<int>(integerOf(dataset, DCM_HighBit).value_or(format.bitsStored - 1));
  format.isSigned = integerOf(dataset, DCM_PixelRepresentation).value_or(0) == 1;
  if (pixels.floatBytes != 0) format.sample = pixels.floatBytes == 4 ? Sample::Float32 : Sample::Float64;
  return format;
}

/// Why a dataset is no stack of scalar images; empty when it is one.
std::string refusalOf(DcmItem& dataset, const PixelFormat& format, const std::string& sopClass) {
  if (sopClass == UID_RTStructureSetStorage) return "is a DICOM structure set, not an image";
  if (isLabelClass(sopClass)) return "is a DICOM segmentation, not an image";
  if (format.rows < 1 || format.columns < 1) return "holds no image";
  const std::string photometric = codeOf(dataset, DCM_PhotometricInterpretation);
  const std::int64_t samples = integerOf(dataset, DCM_SamplesPerPixel).value_or(1);
  const bool monochrome = photometric.empty() || photometric.starts_with("MONOCHROME");
  if (!monochrome) return "holds colours (" + photometric + "), not values";
  if (samples != 1)
    return "says " + std::to_string(samples) + " samples a pixel, where a " +
           (photometric.empty() ? "picture of values" : photometric + " picture") + " has 1";
  const std::string bits = "has pixels of " + std::to_string(format.bitsStored) + " bits in " +
                           std::to_string(format.bitsAllocated) + ", which is not supported";
  if (format.sample != Sample::Integer)
    return format.bitsAllocated == (format.sample == Sample::Float32 ? 32 : 64) ? std::string() : bits;
  const bool whole = format.bitsAllocated == 8 || format.bitsAllocated == 16 || format.bitsAllocated == 32;
  if (!whole || format.bitsStored < 1 || format.bitsStored > format.bitsAllocated ||
      format.highBit + 1 < format.bitsStored || format.highBit >= format.bitsAllocated)
    return bits;
  return {};
}

std::optional<ValueLimits> limitsOf(DcmItem& dataset, const PixelFormat& format) {
  // Both VRs occur whatever the pixels are.
  const auto stored = [&](const DcmTagKey& tag) -> std::optional<std::int64_t> {
    auto value = integerOf(dataset, tag);
    Sint16 negative = 0;
    if (!value && dataset.findAndGetSint16(tag, negative).good()) value = negative;
    if (value && format.isSigned && format.bitsAllocated == 16) value = static_cast<std::int16_t>(*value);
    return value;
  };
  const auto least = stored(DCM_SmallestImagePixelValue), greatest = stored(DCM_LargestImagePixelValue);
  if (!least || !greatest || *least >= *greatest) return std::nullopt;
  ValueLimits limits{*least, *greatest};
  if (const auto padding = stored(DCM_PixelPaddingValue)) {
    const std::int64_t other = stored(DCM_PixelPaddingRangeLimit).value_or(*padding);
    limits.leastPadding = std::min(*padding, other);
    limits.greatestPadding = std::max(*padding, other);
  }
  return limits;
}

/// Elscint's scanners, later Philips', keep pixels in an element of their own. Throws Error where that is compressed in
/// another way than DicomCodecs.h decodes.
void checkPrivatePixels(DcmItem& dataset, const fs::path& path) {
  const auto tag = privateTag(dataset, privatePixelGroup, privatePixelCreator, 0x11);
  const std::string compression = tag ? textOf(dataset, *tag) : std::string();
  if (compression == "PMSCT_RLE1") return;
  throw Error(path,
              "its pixels stand in a private element of Elscint (07a1,100a), compressed as " +
                  (compression.empty() ? "it does not say" : compression),
              "convert the file to a standard transfer syntax with the maker's software");
}

/// Bits of DicomFrame::assumed that all frames of a file share.
unsigned assumedOf(DcmItem& dataset, const DicomFile& file) {
  unsigned bits = 0;
  if (file.format.sample == Sample::Integer) {
    const auto representation = integerOf(dataset, DCM_PixelRepresentation);
    if (!representation || *representation < 0 || *representation > 1) bits |= assumed::representation;
  } else {
    DcmItem* shared = firstItem(&dataset, DCM_SharedFunctionalGroupsSequence);
    DcmItem* mapping = firstItem(shared ? shared : &dataset, DCM_RealWorldValueMappingSequence);
    if (mapping && (numberOf(*mapping, DCM_RealWorldValueSlope).value_or(1.0) != 1.0 ||
                    numberOf(*mapping, DCM_RealWorldValueIntercept).value_or(0.0) != 0.0))
      bits |= assumed::realWorldValues;
  }
  if (codeOf(dataset, DCM_PhotometricInterpretation).empty()) bits |= assumed::photometric;
  if (firstItem(&dataset, DCM_ModalityLUTSequence) && !file.lut) bits |= assumed::lut;
  if (usesDecimalCommas(dataset)) bits |= assumed::decimalCommas;
  if (integerOf(dataset, DCM_NumberOfFrames) == 0) bits |= assumed::noFrames;
  if (file.acrNema) bits |= assumed::acrNema;
  return bits;
}

/// What the image says about the series and the patient that it belongs to.
void describeSeries(DcmItem& dataset, DicomFile& file) {
  file.series = textOf(dataset, DCM_SeriesInstanceUID);
  file.studyUid = textOf(dataset, DCM_StudyInstanceUID);
  file.modality = codeOf(dataset, DCM_Modality);
  file.description = typedTextOf(dataset, DCM_SeriesDescription);
  file.study = typedTextOf(dataset, DCM_StudyDescription);
  file.date = textOf(dataset, DCM_SeriesDate);
  if (file.date.empty()) file.date = textOf(dataset, DCM_StudyDate);
  file.seriesNumber = integerOf(dataset, DCM_SeriesNumber);
  file.imageType = codeOf(dataset, DCM_ImageType);
  file.patient = {typedTextOf(dataset, DCM_PatientName), typedTextOf(dataset, DCM_PatientID),
                  textOf(dataset, DCM_PatientSex), textOf(dataset, DCM_PatientBirthDate)};
}

}  // namespace

DicomFile readDicomHeader(const fs::path& path) {
  DcmFileFormat fileFormat;
  loadHeader(path, fileFormat);
  DcmDataset& dataset = *fileFormat.getDataset();
  DicomFile file;
  file.path = path;
  const std::string sopClass = textOf(dataset, DCM_SOPClassUID);
  if (sopClass.empty() && !dataset.tagExists(DCM_Rows))
    throw Error(path, "its DICOM header names no object", "the file is truncated or damaged");
  file.sopClass = sopClass;
  file.instance = textOf(dataset, DCM_SOPInstanceUID);
  file.acrNema = textOf(dataset, DCM_RETIRED_RecognitionCode).starts_with("ACR-NEMA");
  describeSeries(dataset, file);

  file.transferSyntax = dataset.getOriginalXfer();
  file.syntaxUid = textOf(*fileFormat.getMetaInfo(), DCM_TransferSyntaxUID);
  const auto pixels = pixelsOf(dataset, path);
  file.pixels = pixels.value_or(PixelPlace{});
  file.format = pixelFormatOf(dataset, file.pixels);
  file.refusal = refusalOf(dataset, file.format, sopClass);
  if (isLabelClass(sopClass)) file.labels = std::make_shared<DicomLabelObject>(labelObjectIn(dataset, path));
  if (!file.refusal.empty()) return file;
  if (!pixels) throw Error(path, "its pixels cannot be read (there are none)", "the file is truncated or damaged");
  if (file.pixels.isPrivate) checkPrivatePixels(dataset, path);

  file.monochrome1 = codeOf(dataset, DCM_PhotometricInterpretation) == "MONOCHROME1";
  file.lut = modalityLut(dataset, file.format);
  file.limits = limitsOf(dataset, file.format);
  const std::string rescaleType = textOf(dataset, DCM_RescaleType);
  if (file.modality == "CT") file.unit = rescaleType.empty() || rescaleType == "US" ? "HU" : rescaleType;
  if (file.modality == "PT") file.unit = codeOf(dataset, DCM_Units);

  const std::int64_t frames = countFrames(dataset, file);
  const unsigned assumed = assumedOf(dataset, file);

  DcmSequenceOfItems* perFrame = nullptr;
  dataset.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, perFrame);
  DcmItem* shared = firstItem(&dataset, DCM_SharedFunctionalGroupsSequence);
  DcmObject* next = nullptr;
  for (std::int64_t index = 0; index < frames; ++index) {
    if (perFrame) next = perFrame->nextInContainer(next);
    if (!next) perFrame = nullptr;  // fewer items than frames
    file.frames.push_back(readFrame({dynamic_cast<DcmItem*>(next), shared, dataset}, file, static_cast<int>(index)));
    file.frames.back().assumed |= assumed;
  }
  placeFrames(dataset, file);
  if (frames == 1) splitMosaic(dataset, file);
  return file;
}

}  // namespace fenestra::io
