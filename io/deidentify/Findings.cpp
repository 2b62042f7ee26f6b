#include "io/deidentify/Findings.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "io/deidentify/FaceRemoval.h"
#include "io/dicom/DicomValues.h"
#include "io/dicom/LabelObject.h"

namespace fenestra::io::deidentify {
namespace {

/// Whether an overlay lies in the unused bits of the pixels, as old scanners wrote it (PS3.3 C.9.2, retired).
bool hasOverlayInPixels(DcmItem& object) {
  for (Uint16 group = 0x6000; group <= 0x601e; group = static_cast<Uint16>(group + 2))
    if (integerOf(object, DcmTagKey(group, 0x0102)).value_or(0) != 0) return true;
  return false;
}

/// Kinds of pictures on which machines write names: ultrasound, secondary capture, and what is scanned or filmed.
bool oftenShowsNames(DcmItem& object) {
  constexpr std::array modalities{"US", "OT", "SC", "XC", "ES", "GM", "DOC", "SR", "IVUS"};
  const std::string modality = codeOf(object, DCM_Modality), kind = textOf(object, DCM_SOPClassUID);
  constexpr std::string_view secondaryCapture = "1.2.840.10008.5.1.4.1.1.7";
  return object.tagExists(DCM_Rows) && (kind.starts_with(secondaryCapture) ||
                                        std::find(modalities.begin(), modalities.end(), modality) != modalities.end());
}

bool mayShowFace(DcmItem& object) {
  const std::string modality = codeOf(object, DCM_Modality), part = codeOf(object, DCM_BodyPartExamined);
  constexpr std::array parts{"HEAD", "BRAIN", "SKULL", "FACE", "HEADNECK", "EAR", "EYE", "ORBIT", "SINUS"};
  return (modality == "CT" || modality == "MR" || modality == "PT") &&
         std::find(parts.begin(), parts.end(), part) != parts.end();
}

}  // namespace

std::string refusalOf(DcmFileFormat& object) {
  DcmDataset& dataset = *object.getDataset();
  if (dataset.tagExists(DCM_EncapsulatedDocument)) return "a document, which nobody here can examine";
  if (dataset.tagExists(DcmTagKey(0x07a1, 0x100a)) && !dataset.tagExists(DCM_PixelData))
    return "its pixels stand in a private attribute, which the profile removes";
  if (textOf(dataset, DCM_SOPClassUID).empty() || textOf(dataset, DCM_SOPInstanceUID).empty())
    return "it does not say which object it is (its SOP Class or Instance UID is missing)";
  const DcmXfer syntax(dataset.getOriginalXfer());
  const std::string named = textOf(*object.getMetaInfo(), DCM_TransferSyntaxUID);
  if (!named.empty() && named != syntax.getXferID()) return "its transfer syntax (" + named + ") is not known";
  return {};
}

void Findings::leaveOut(const std::string& reason, const std::vector<std::filesystem::path>& files) {
  if (files.empty()) return;
  auto& list = leftOut_[reason];
  list.insert(list.end(), files.begin(), files.end());
}

void Findings::notice(DcmItem& object, const std::filesystem::path& file, bool facesGo) {
  const std::string burnedIn = codeOf(object, DCM_BurnedInAnnotation);
  if (burnedIn == "YES")
    noticed_
        ["with names burned into the pixels (Burned In Annotation), which stay as they are; look at each before you "
         "give it away"]
            .push_back(file);
  else if (burnedIn != "NO" && oftenShowsNames(object))
    noticed_
        ["of a kind that often shows names in the pixels, which stay as they are; look at each before you give it away"]
            .push_back(file);
  if (hasOverlayInPixels(object))
    noticed_["with an overlay in unused bits of the pixels, which stay as they are"].push_back(file);
  if (privateTag(object, 0x0065, "Image Private Header", 0x50))
    noticed_["of United Imaging, where private attributes place the slices of a mosaic; the profile removes them"]
        .push_back(file);
  const bool isImage = FaceRemoval::concerns(object);
  if (facesGo && isImage)
    noticed_
        ["in which all in front of a plane was blanked, from the brow to the chin; look at each, as slices and in 3-D, "
         "before you give it away: a nodded or turned head may keep a part of its face, or lose some brain"]
            .push_back(file);
  if (facesGo && isLabelClass(textOf(object, DCM_SOPClassUID)))
    noticed_["with labels or contours, whose shapes stay, a face's outline among them"].push_back(file);
  if (!facesGo && mayShowFace(object))
    noticed_["of a head, from which a face can be reconstructed; it stays"].push_back(file);
}

std::size_t Findings::leftOut() const {
  std::size_t count = 0;
  for (const auto& [reason, files] : leftOut_) count += files.size();
  return count;
}

std::string Findings::firstReason() const { return leftOut_.empty() ? "" : leftOut_.begin()->first; }

std::vector<Warning> Findings::warnings() const {
  std::vector<Warning> warnings;
  const auto count = [](std::size_t files, const char* one, const char* many) {
    return std::to_string(files) + (files == 1 ? one : many);
  };
  for (const auto& [reason, files] : leftOut_)
    warnings.push_back({Warning::Kind::Other, count(files.size(), " file", " files") + " left out: " + reason, files});
  for (const auto& [remark, files] : noticed_)
    warnings.push_back({Warning::Kind::Other, count(files.size(), " object", " objects") + " " + remark, files});
  return warnings;
}

}  // namespace fenestra::io::deidentify
