#include <stdexcept>

#include "io/dicom/DicomValues.h"
#include "io/report/Origin.h"
#include "io/report/Results.h"

namespace fenestra::io::report {
namespace fs = std::filesystem;
namespace {

/// Patient and study of the origin: the modules that all objects of a study share (PS3.3 C.7.1.1, C.7.2.1, C.7.2.2).
void copyStudy(DcmDataset& from, DcmDataset& to) {
  // Type 2: there, if empty.
  for (const DcmTagKey& tag : {DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_PatientSex, DCM_StudyDate,
                               DCM_StudyTime, DCM_ReferringPhysicianName, DCM_StudyID, DCM_AccessionNumber})
    if (from.findAndInsertCopyOfElement(tag, &to).bad()) to.insertEmptyElement(tag);
  for (const DcmTagKey& tag :
       {DCM_StudyInstanceUID, DCM_IssuerOfPatientID, DCM_StudyDescription, DCM_PatientIdentityRemoved,
        DCM_DeidentificationMethod, DCM_DeidentificationMethodCodeSequence})
    from.findAndInsertCopyOfElement(tag, &to);
}

void describeImage(const Capture& capture, DcmDataset& dataset, const fs::path& file) {
  const auto put = [&](const DcmTagKey& tag, int value) {
    require(dataset.putAndInsertUint16(tag, static_cast<Uint16>(value)), file, "the picture");
  };
  // In colours even where it is grey: the grey of a picture is no value of the volume.
  put(DCM_SamplesPerPixel, 3);
  dataset.putAndInsertString(DCM_PhotometricInterpretation, "RGB");
  put(DCM_PlanarConfiguration, 0);
  put(DCM_Rows, capture.size.y);
  put(DCM_Columns, capture.size.x);
  put(DCM_BitsAllocated, 8);
  put(DCM_BitsStored, 8);
  put(DCM_HighBit, 7);
  put(DCM_PixelRepresentation, 0);
  std::vector<std::uint8_t> pixels = capture.pixels;
  if (pixels.size() % 2) pixels.push_back(0);  // pixel data has an even length
  require(dataset.putAndInsertUint8Array(DCM_PixelData, pixels.data(), pixels.size()), file, "the pixels");
}

/// Now, as a date and a time of day.
void putTime(DcmDataset& dataset) {
  OFString date, time;
  DcmDate::getCurrentDate(date);
  DcmTime::getCurrentTime(time);
  for (const DcmTagKey& tag : {DCM_InstanceCreationDate, DCM_SeriesDate, DCM_ContentDate, DCM_DateOfSecondaryCapture})
    dataset.putAndInsertOFStringArray(tag, date);
  for (const DcmTagKey& tag : {DCM_InstanceCreationTime, DCM_SeriesTime, DCM_ContentTime, DCM_TimeOfSecondaryCapture})
    dataset.putAndInsertOFStringArray(tag, time);
}

std::string derivation(const Capture& capture) {
  std::string text = "A picture of the volume, made by Fenestra.";
  for (const std::string& sentence : capture.alters) text += " " + sentence + (sentence.ends_with('.') ? "" : ".");
  constexpr std::size_t shortText = 1024;
  return bounded(text, shortText);
}

}  // namespace

void writeCapture(const Capture& capture, const std::vector<fs::path>& series, const fs::path& file) {
  const auto count = static_cast<std::size_t>(capture.size.x) * static_cast<std::size_t>(capture.size.y) * 3;
  if (capture.size.x < 1 || capture.size.y < 1 || capture.size.x > 65535 || capture.size.y > 65535)
    throw Error(file, "cannot be DICOM: the picture has no pixels, or more than 65535 a side", "make it smaller");
  if (capture.pixels.size() != count) throw std::invalid_argument("writeCapture: pixels do not fill the picture");
  Origin origin;
  readOrigin(series.empty() ? fs::path() : series.front(), origin);
  DcmFileFormat whole;
  DcmDataset& dataset = *whole.getDataset();
  const auto put = [&](const DcmTagKey& tag, const std::string& value) {
    require(dataset.putAndInsertString(tag, value.c_str()), file, "an attribute");
  };
  put(DCM_SpecificCharacterSet, "ISO_IR 192");
  copyStudy(origin.dataset(), dataset);
  put(DCM_SOPClassUID, UID_SecondaryCaptureImageStorage);
  put(DCM_SOPInstanceUID, newUid());
  put(DCM_SeriesInstanceUID, newUid());
  put(DCM_Modality, "OT");
  put(DCM_ConversionType, "WSD");  // of a workstation
  put(DCM_Laterality, "");         // unknown, and required where the body part may be one of a pair
  put(DCM_SeriesNumber, "1003");
  put(DCM_InstanceNumber, "1");
  put(DCM_SeriesDescription, longString(capture.description.empty() ? "Picture" : capture.description));
  put(DCM_ImageType, "DERIVED\\SECONDARY");
  put(DCM_Manufacturer, "Fenestra");
  put(DCM_SecondaryCaptureDeviceManufacturer, "Fenestra");
  put(DCM_SecondaryCaptureDeviceManufacturerModelName, "Fenestra");
  dataset.insertEmptyElement(DCM_PatientOrientation);  // a view in perspective has none
  putTime(dataset);
  put(DCM_DerivationDescription, derivation(capture));
  constexpr std::size_t longText = 10240;
  // PS3.3 C.7.6.1.1.1: whether the pixels identify the patient.
  if (capture.namesPatient) put(DCM_BurnedInAnnotation, *capture.namesPatient ? "YES" : "NO");
  if (!capture.comments.empty()) put(DCM_ImageComments, bounded(capture.comments, longText));
  describeImage(capture, dataset, file);
  save(whole, file);
}

}  // namespace fenestra::io::report
