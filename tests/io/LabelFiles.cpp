#include "tests/io/LabelFiles.h"

#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dcrlerp.h>
#include <dcmtk/dcmdata/dctk.h>

#include "tests/io/DicomItems.h"
namespace fenestra::tests {
namespace {

std::vector<Uint8> pixelBytes(const SegSpec& spec) {
  std::vector<Uint8> bytes;
  std::size_t bit = 0;
  for (const SegFrameSpec& frame : spec.frames) {
    if (spec.padsFrames) bit = 8 * bytes.size();
    for (const int value : frame.pixels) {
      if (spec.bits == 1) {
        if (bit % 8 == 0) bytes.push_back(0);
        if (value) bytes.back() = static_cast<Uint8>(bytes.back() | 1u << (bit % 8));
        ++bit;
      } else {
        bytes.push_back(static_cast<Uint8>(value & 0xff));
        if (spec.bits == 16) bytes.push_back(static_cast<Uint8>(value >> 8));
      }
    }
  }
  if (spec.pixelBytes) bytes.resize(*spec.pixelBytes);
  if (bytes.size() % 2) bytes.push_back(0);
  return bytes;
}

E_TransferSyntax syntaxNamed(const std::string& name) {
  if (name == "implicit") return EXS_LittleEndianImplicit;
  if (name == "big") return EXS_BigEndianExplicit;
  if (name == "deflated") return EXS_DeflatedLittleEndianExplicit;
  if (name == "rle") return EXS_RLELossless;
  return EXS_LittleEndianExplicit;
}

void putFrame(DcmItem& frame, const SegSpec& spec, const SegFrameSpec& of) {
  if (of.position) put(itemOf(frame, DCM_PlanePositionSequence), DCM_ImagePositionPatient, vectorText(*of.position));
  if (spec.type != "LABELMAP")
    put(itemOf(frame, DCM_SegmentIdentificationSequence), DCM_ReferencedSegmentNumber, of.segment);
}

}  // namespace

void writeSeg(const std::filesystem::path& path, const SegSpec& spec) {
  DcmRLEEncoderRegistration::registerCodecs();
  DcmFileFormat file;
  DcmDataset& dataset = *file.getDataset();
  put(dataset, DCM_SpecificCharacterSet, std::string("ISO_IR 192"));
  put(dataset, DCM_SOPClassUID, spec.sopClass);
  put(dataset, DCM_SOPInstanceUID, std::string("1.2.9.1"));
  put(dataset, DCM_SeriesInstanceUID, std::string("1.2.9"));
  put(dataset, DCM_StudyInstanceUID, std::string("1.2"));
  put(dataset, DCM_Modality, std::string("SEG"));
  put(dataset, DCM_SeriesDescription, spec.description);
  put(dataset, DCM_FrameOfReferenceUID, spec.frameOfReference);
  put(dataset, DCM_SegmentationType, spec.type);
  if (spec.type == "FRACTIONAL") put(dataset, DCM_MaximumFractionalValue, spec.greatest);
  if (!spec.series.empty()) put(itemOf(dataset, DCM_ReferencedSeriesSequence), DCM_SeriesInstanceUID, spec.series);
  for (std::size_t i = 0; i < spec.segments.size(); ++i) {
    DcmItem& segment = itemOf(dataset, DCM_SegmentSequence, static_cast<long>(i));
    put(segment, DCM_SegmentNumber, spec.segments[i].number);
    put(segment, DCM_SegmentLabel, spec.segments[i].label);
    const std::vector<Uint16> lab(spec.segments[i].cieLab.begin(), spec.segments[i].cieLab.end());
    if (!lab.empty()) {
      ASSERT_TRUE(segment.putAndInsertUint16Array(DCM_RecommendedDisplayCIELabValue, lab.data(), lab.size()).good());
    }
  }
  DcmItem& shared = itemOf(dataset, DCM_SharedFunctionalGroupsSequence);
  DcmItem& measures = itemOf(shared, DCM_PixelMeasuresSequence);
  put(measures, DCM_PixelSpacing, spec.pixelSpacing);
  if (!spec.spacingBetweenSlices.empty()) put(measures, DCM_SpacingBetweenSlices, spec.spacingBetweenSlices);
  put(itemOf(shared, DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient,
      vectorText(spec.row) + "\\" + vectorText(spec.column));
  for (std::size_t i = 0; i < spec.frames.size(); ++i)
    putFrame(itemOf(dataset, DCM_PerFrameFunctionalGroupsSequence, static_cast<long>(i)), spec, spec.frames[i]);
  put(dataset, DCM_NumberOfFrames, std::to_string(spec.numberOfFrames.value_or(static_cast<int>(spec.frames.size()))));
  put(dataset, DCM_SamplesPerPixel, 1);
  put(dataset, DCM_PhotometricInterpretation, std::string("MONOCHROME2"));
  put(dataset, DCM_Rows, spec.rows);
  put(dataset, DCM_Columns, spec.columns);
  put(dataset, DCM_BitsAllocated, spec.bits);
  put(dataset, DCM_BitsStored, spec.bits);
  put(dataset, DCM_HighBit, spec.bits - 1);
  put(dataset, DCM_PixelRepresentation, 0);
  const std::vector<Uint8> bytes = pixelBytes(spec);
  if (spec.bits == 16) {
    std::vector<Uint16> words;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
      words.push_back(static_cast<Uint16>(bytes[i] | bytes[i + 1] << 8));
    ASSERT_TRUE(dataset.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size()).good());
  } else {
    ASSERT_TRUE(dataset.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size()).good());
  }
  const E_TransferSyntax syntax = syntaxNamed(spec.transferSyntax);
  const DcmRLERepresentationParameter rle;
  ASSERT_TRUE(dataset.chooseRepresentation(syntax, syntax == EXS_RLELossless ? &rle : nullptr).good());
  const OFCondition saved = file.saveFile(OFFilename(path.c_str()), syntax);
  ASSERT_TRUE(saved.good()) << saved.text();
}

void writeRtStruct(const std::filesystem::path& path, const RtSpec& spec) {
  DcmFileFormat file;
  DcmDataset& dataset = *file.getDataset();
  put(dataset, DCM_SpecificCharacterSet, std::string("ISO_IR 100"));
  put(dataset, DCM_SOPClassUID, std::string("1.2.840.10008.5.1.4.1.1.481.3"));
  put(dataset, DCM_SOPInstanceUID, std::string("1.2.8.1"));
  put(dataset, DCM_SeriesInstanceUID, std::string("1.2.8"));
  put(dataset, DCM_StudyInstanceUID, std::string("1.2"));
  put(dataset, DCM_Modality, std::string("RTSTRUCT"));
  put(dataset, DCM_StructureSetLabel, std::string("plan"));
  DcmItem& frame = itemOf(dataset, DCM_ReferencedFrameOfReferenceSequence);
  put(frame, DCM_FrameOfReferenceUID, std::string("1.2.3"));
  put(itemOf(itemOf(frame, DCM_RTReferencedStudySequence), DCM_RTReferencedSeriesSequence), DCM_SeriesInstanceUID,
      spec.series);
  for (std::size_t i = 0; i < spec.rois.size(); ++i) {
    const RoiSpec& roi = spec.rois[i];
    if (roi.described) {
      DcmItem& described = itemOf(dataset, DCM_StructureSetROISequence, static_cast<long>(i));
      put(described, DCM_ROINumber, std::to_string(roi.number));
      put(described, DCM_ROIName, roi.name);
    }
    DcmItem& item = itemOf(dataset, DCM_ROIContourSequence, static_cast<long>(i));
    put(item, DCM_ReferencedROINumber, std::to_string(spec.contoursOf.value_or(roi.number)));
    if (!roi.colour.empty()) put(item, DCM_ROIDisplayColor, roi.colour);
    for (std::size_t c = 0; c < roi.contours.size(); ++c) {
      const ContourSpec& contour = roi.contours[c];
      DcmItem& to = itemOf(item, DCM_ContourSequence, static_cast<long>(c));
      put(to, DCM_ContourGeometricType, contour.type);
      put(to, DCM_NumberOfContourPoints,
          std::to_string(contour.count.value_or(static_cast<int>(contour.points.size()))));
      std::string data;
      for (const glm::dvec3& point : contour.points) {
        if (!data.empty()) data += '\\';
        data += vectorText(point);
      }
      put(to, DCM_ContourData, contour.data.value_or(data));
    }
  }
  const OFCondition saved = file.saveFile(OFFilename(path.c_str()), EXS_LittleEndianImplicit);
  ASSERT_TRUE(saved.good()) << saved.text();
}

Grid labelGrid(glm::ivec3 dims, glm::dvec3 origin, glm::dvec3 spacing) {
  Grid grid;
  grid.dims = dims;
  grid.origin = origin;
  grid.spacing = spacing;
  return grid;
}

std::vector<int> valuesOf(const LabelMap& map) {
  return map.voxels.visit([](auto scalars) { return std::vector<int>(scalars.begin(), scalars.end()); });
}

void expectSameLabels(const LabelMap& actual, const LabelMap& expected) {
  const std::vector<int> a = valuesOf(actual), b = valuesOf(expected);
  ASSERT_EQ(a.size(), b.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different += a[i] != b[i];
  EXPECT_EQ(different, 0u) << "of " << a.size() << " voxels";
}

std::vector<glm::dvec3> rectangle(double left, double top, double right, double bottom, double z) {
  return {{left, top, z}, {right, top, z}, {right, bottom, z}, {left, bottom, z}};
}

}  // namespace fenestra::tests
