#include "tests/io/DicomWriter.h"

#include <mutex>
#include <numeric>

#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dcrlerp.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpeg/djrplol.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <dcmtk/dcmjpls/djrparam.h>
#include <dcmtk/oflog/oflog.h>

#include "tests/io/DicomItems.h"
namespace fenestra::tests {
namespace {

void putFunctionalGroups(DcmItem& dataset, const DicomSpec& spec) {
  DcmItem& shared = itemOf(dataset, DCM_SharedFunctionalGroupsSequence);
  put(itemOf(shared, DCM_PixelMeasuresSequence), DCM_PixelSpacing, spec.pixelSpacing);
  put(itemOf(shared, DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient,
      vectorText(spec.row) + "\\" + vectorText(spec.column));
  for (std::size_t i = 0; i < spec.frames.size(); ++i) {
    DcmItem& frame = itemOf(dataset, DCM_PerFrameFunctionalGroupsSequence, static_cast<long>(i));
    put(itemOf(frame, DCM_PlanePositionSequence), DCM_ImagePositionPatient, vectorText(spec.frames[i].position));
    put(itemOf(frame, DCM_CTImageFrameTypeSequence), DCM_FrameType, spec.frames[i].type);
    DcmItem& transform = itemOf(frame, DCM_PixelValueTransformationSequence);
    put(transform, DCM_RescaleSlope, numberText(spec.frames[i].slope));
    put(transform, DCM_RescaleIntercept, numberText(spec.frames[i].intercept));
  }
}

void putPixels(DcmItem& dataset, const DicomSpec& spec, std::size_t frames) {
  const std::size_t count = static_cast<std::size_t>(spec.rows * spec.columns * spec.samplesPerPixel) * frames;
  std::vector<std::uint32_t> words = spec.words;
  if (words.empty()) {
    words.resize(count);
    std::iota(words.begin(), words.end(), 0u);
  }
  ASSERT_EQ(words.size(), count);
  if (spec.bitsAllocated == 8) {
    const std::vector<Uint8> bytes(words.begin(), words.end());
    ASSERT_TRUE(dataset.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size()).good());
  } else {
    std::vector<Uint16> halves;
    for (const std::uint32_t word : words) {
      halves.push_back(static_cast<Uint16>(word & 0xffff));
      if (spec.bitsAllocated == 32) halves.push_back(static_cast<Uint16>(word >> 16));
    }
    ASSERT_TRUE(dataset.putAndInsertUint16Array(DCM_PixelData, halves.data(), halves.size()).good());
  }
}

E_TransferSyntax transferSyntax(Syntax syntax) {
  switch (syntax) {
    case Syntax::ImplicitLittle:
      return EXS_LittleEndianImplicit;
    case Syntax::ExplicitLittle:
      return EXS_LittleEndianExplicit;
    case Syntax::ExplicitBig:
      return EXS_BigEndianExplicit;
    case Syntax::Deflated:
      return EXS_DeflatedLittleEndianExplicit;
    case Syntax::Rle:
      return EXS_RLELossless;
    case Syntax::JpegLossless:
      return EXS_JPEGProcess14SV1;
    case Syntax::JpegLs:
      break;
  }
  return EXS_JPEGLSLossless;
}

}  // namespace

DicomSpec pictureSpec(Syntax syntax) {
  DicomSpec spec;
  spec.syntax = syntax;
  spec.columns = 40;
  spec.rows = 30;
  spec.bitsStored = 12;
  spec.highBit = 11;
  spec.isSigned = false;
  for (int i = 0; i < 1200; ++i) spec.words.push_back(static_cast<std::uint32_t>(i * i % 3001));
  return spec;
}

void writeDicom(const std::filesystem::path& path, const DicomSpec& spec) {
  static std::once_flag once;
  std::call_once(once, [] {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    DcmRLEEncoderRegistration::registerCodecs();
    DJEncoderRegistration::registerCodecs();
    // Frames are encoded as they are stored: DCMTK 3.6.7's encoder of "cooked" frames writes its padding byte past the
    // end of the frame (DCMTK pull request 111, "Properly pass the compressed buffer to fixPaddingIfNecessary").
    constexpr Uint16 standard = 0;
    DJLSEncoderRegistration::registerCodecs(standard, standard, standard, standard, OFFalse);
  });
  DcmFileFormat file;
  DcmDataset& dataset = *file.getDataset();
  put(dataset, DCM_SpecificCharacterSet, std::string("ISO_IR 192"));
  put(dataset, DCM_SOPClassUID, spec.sopClass);
  put(dataset, DCM_SOPInstanceUID, spec.instance);
  put(dataset, DCM_SeriesInstanceUID, spec.series);
  put(dataset, DCM_StudyInstanceUID, std::string("1.2"));
  put(dataset, DCM_Modality, spec.modality);
  if (!spec.description.empty()) put(dataset, DCM_SeriesDescription, spec.description);
  if (!spec.patientName.empty()) put(dataset, DCM_PatientName, spec.patientName);
  if (!spec.patientId.empty()) put(dataset, DCM_PatientID, spec.patientId);
  if (!spec.birthDate.empty()) put(dataset, DCM_PatientBirthDate, spec.birthDate);
  if (!spec.sex.empty()) put(dataset, DCM_PatientSex, spec.sex);
  if (!spec.study.empty()) put(dataset, DCM_StudyDescription, spec.study);
  if (!spec.date.empty()) put(dataset, DCM_SeriesDate, spec.date);
  if (!spec.accessionNumber.empty()) put(dataset, DCM_AccessionNumber, spec.accessionNumber);
  if (!spec.seriesNumber.empty()) put(dataset, DCM_SeriesNumber, spec.seriesNumber);
  if (!spec.imageType.empty()) put(dataset, DCM_ImageType, spec.imageType);
  if (!spec.thickness.empty()) put(dataset, DCM_SliceThickness, spec.thickness);
  if (!spec.kernel.empty()) put(dataset, DCM_ConvolutionKernel, spec.kernel);
  put(dataset, DCM_FrameOfReferenceUID, spec.frameOfReference);
  put(dataset, DCM_InstanceNumber, std::to_string(spec.instanceNumber));
  put(dataset, DCM_AcquisitionNumber, std::to_string(spec.acquisitionNumber));
  put(dataset, DCM_SamplesPerPixel, spec.samplesPerPixel);
  if (spec.samplesPerPixel > 1) put(dataset, DCM_PlanarConfiguration, 0);
  put(dataset, DCM_PhotometricInterpretation, spec.photometric);
  put(dataset, DCM_Rows, spec.rows);
  put(dataset, DCM_Columns, spec.columns);
  put(dataset, DCM_BitsAllocated, spec.bitsAllocated);
  put(dataset, DCM_BitsStored, spec.bitsStored);
  put(dataset, DCM_HighBit, spec.highBit);
  put(dataset, DCM_PixelRepresentation, spec.isSigned ? 1 : 0);
  if (spec.slope) put(dataset, DCM_RescaleSlope, *spec.slope);
  if (spec.intercept) put(dataset, DCM_RescaleIntercept, *spec.intercept);
  if (!spec.window.empty()) {
    const std::size_t blank = spec.window.find(' ');
    put(dataset, DCM_WindowCenter, spec.window.substr(0, blank));
    put(dataset, DCM_WindowWidth, spec.window.substr(blank + 1));
  }
  std::size_t frames = static_cast<std::size_t>(spec.numberOfFrames);
  if (!spec.frames.empty()) {
    frames = spec.frames.size();
    putFunctionalGroups(dataset, spec);
  } else if (spec.position) {
    put(dataset, DCM_ImagePositionPatient, vectorText(*spec.position));
    put(dataset, DCM_ImageOrientationPatient, vectorText(spec.row) + "\\" + vectorText(spec.column));
    put(dataset, DCM_PixelSpacing, spec.pixelSpacing);
  }
  if (frames > 1 || !spec.frames.empty()) put(dataset, DCM_NumberOfFrames, std::to_string(frames));
  if (!spec.doseScaling.empty()) put(dataset, DCM_DoseGridScaling, spec.doseScaling);
  if (!spec.frameOffsets.empty()) put(dataset, DCM_GridFrameOffsetVector, spec.frameOffsets);
  putPixels(dataset, spec, frames);

  const E_TransferSyntax syntax = transferSyntax(spec.syntax);
  const DJ_RPLossless jpegLossless;
  const DJLSRepresentationParameter jpegLs(0, OFTrue);
  const DcmRLERepresentationParameter rle;
  const DcmRepresentationParameter* parameter = nullptr;
  if (spec.syntax == Syntax::JpegLossless) parameter = &jpegLossless;
  if (spec.syntax == Syntax::JpegLs) parameter = &jpegLs;
  if (spec.syntax == Syntax::Rle) parameter = &rle;
  ASSERT_TRUE(dataset.chooseRepresentation(syntax, parameter).good());
  const OFCondition saved =
      file.saveFile(OFFilename(path.c_str()), syntax, spec.explicitLengths ? EET_ExplicitLength : EET_UndefinedLength);
  ASSERT_TRUE(saved.good()) << saved.text();
}

void writeDicomDir(const std::filesystem::path& path, const std::vector<DirectoryRecord>& records) {
  DcmDataset dataset;
  for (const DirectoryRecord& record : records) {
    auto* item = new DcmItem;
    item->putAndInsertUint16(DCM_RecordInUseFlag, record.inUse ? 0xFFFF : 0);
    item->putAndInsertString(DCM_DirectoryRecordType, "IMAGE");
    item->putAndInsertString(DCM_ReferencedFileID, record.fileId.c_str());
    dataset.insertSequenceItem(DCM_DirectoryRecordSequence, item);
  }
  DcmFileFormat file(&dataset);
  const OFCondition saved = file.saveFile(path.c_str(), EXS_LittleEndianExplicit);
  ASSERT_TRUE(saved.good()) << saved.text();
}

}  // namespace fenestra::tests
