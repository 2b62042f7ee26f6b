#include <algorithm>
#include <cmath>
#include <optional>

#include "io/base/Error.h"
#include "io/base/FileStart.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomStart.h"
#include "io/dicom/DicomValues.h"
#include "io/dicom/LabelObject.h"
#include "io/report/Results.h"

namespace fenestra::io::report {
namespace fs = std::filesystem;
namespace {

// Concepts of PS3.16 by their code of the scheme DCM, under which every program writes them.
constexpr const char *measurementGroup = "125007", *trackingIdentifier = "112039", *referencedSegment = "121191",
                     *derivationCode = "121401";

std::string codeIn(DcmItem& item, const DcmTagKey& sequence) {
  DcmItem* code = firstItem(&item, sequence);
  return code ? textOf(*code, DCM_CodeValue) : std::string();
}

/// Reads content items (PS3.3 C.17.3.2). loadHeader() bounds how deep they nest.
class ContentReader {
 public:
  ContentReader(DcmDataset& dataset, ResultObject& result) : dataset_(dataset), result_(result) {}

  void read() { readChildren(dataset_, {}); }

 private:
  /// The group of measurements that an item stands in.
  struct Group {
    std::string name;
    int segment = 0;
  };

  void readChildren(DcmItem& parent, const Group& group) {
    forEachItem(parent, DCM_ContentSequence, [&](DcmItem& item) {
      const std::string type = codeOf(item, DCM_ValueType);
      if (type == "NUM") {
        readNumber(item, group);
      } else if (type == "CONTAINER" && codeIn(item, DCM_ConceptNameCodeSequence) == measurementGroup) {
        readChildren(item, groupOf(item));
      } else {
        if (result_.kind == "keys") readKey(item, type);
        readChildren(item, group);
      }
    });
  }

  Group groupOf(DcmItem& container) {
    Group group;
    forEachItem(container, DCM_ContentSequence, [&](DcmItem& item) {
      const std::string term = codeIn(item, DCM_ConceptNameCodeSequence);
      if (term == trackingIdentifier) group.name = typedTextOf(item, DCM_TextValue, &dataset_);
      DcmItem* reference = term == referencedSegment ? firstItem(&item, DCM_ReferencedSOPSequence) : nullptr;
      if (reference) group.segment = static_cast<int>(integerOf(*reference, DCM_ReferencedSegmentNumber).value_or(0));
    });
    return group;
  }

  std::string meaningIn(DcmItem& item, const DcmTagKey& sequence) {
    DcmItem* code = firstItem(&item, sequence);
    return code ? typedTextOf(*code, DCM_CodeMeaning, &dataset_) : std::string();
  }

  void readNumber(DcmItem& item, const Group& group) {
    DcmItem* measured = firstItem(&item, DCM_MeasuredValueSequence);
    if (!measured) return;  // why there is no value stands in a qualifier
    std::optional<double> number = numberOf(*measured, DCM_NumericValue);
    Float64 precise = 0.0;
    if (measured->findAndGetFloat64(DCM_FloatingPointValue, precise).good() && std::isfinite(precise)) number = precise;
    if (!number) return;
    ResultObject::Value value;
    value.group = group.name;
    value.segment = group.segment;
    value.name = meaningIn(item, DCM_ConceptNameCodeSequence);
    value.value = *number;
    value.unit = codeIn(*measured, DCM_MeasurementUnitsCodeSequence);
    forEachItem(item, DCM_ContentSequence, [&](DcmItem& child) {
      if (codeIn(child, DCM_ConceptNameCodeSequence) == derivationCode)
        value.derivation = meaningIn(child, DCM_ConceptCodeSequence);
      if (codeOf(child, DCM_ValueType) == "SCOORD3D") readPoints(child, value);
    });
    result_.values.push_back(std::move(value));
  }

  void readPoints(DcmItem& item, ResultObject::Value& value) {
    const Float32* data = nullptr;
    unsigned long count = 0;
    if (item.findAndGetFloat32Array(DCM_GraphicData, data, &count).bad() || !data) return;
    for (unsigned long at = 0; at + 2 < count; at += 3) value.points.emplace_back(data[at], data[at + 1], data[at + 2]);
    result_.frameOfReference = textOf(item, DCM_ReferencedFrameOfReferenceUID);
  }

  void readKey(DcmItem& item, const std::string& type) {
    if (type == "TEXT") result_.texts.push_back(typedTextOf(item, DCM_TextValue, &dataset_));
    DcmItem* reference = type == "IMAGE" ? firstItem(&item, DCM_ReferencedSOPSequence) : nullptr;
    if (!reference) return;
    ResultObject::Image image{textOf(*reference, DCM_ReferencedSOPInstanceUID), {}};
    const unsigned long frames = [&] {
      DcmElement* element = nullptr;
      return reference->findAndGetElement(DCM_ReferencedFrameNumber, element).good() ? element->getVM() : 0ul;
    }();
    for (unsigned long at = 0; at < frames; ++at)
      if (const auto frame = numberOf(*reference, DCM_ReferencedFrameNumber, at))
        image.frames.push_back(static_cast<int>(std::clamp(*frame, 0.0, 1e9)));
    result_.images.push_back(std::move(image));
  }

  DcmDataset& dataset_;
  ResultObject& result_;
};

/// "segmentation", "measures", "keys" or "capture"; empty: none of them.
std::string kindOf(DcmDataset& dataset, const std::string& sopClass) {
  if (isLabelClass(sopClass)) return "segmentation";
  if (sopClass == UID_KeyObjectSelectionDocumentStorage) return "keys";
  if (codeOf(dataset, DCM_Modality) == "SR") return "measures";
  // One in grey opens as an image, as any other does.
  const bool isCapture =
      sopClass == UID_SecondaryCaptureImageStorage || sopClass == UID_MultiframeTrueColorSecondaryCaptureImageStorage;
  return isCapture && !codeOf(dataset, DCM_PhotometricInterpretation).starts_with("MONOCHROME") ? "capture" : "";
}

}  // namespace

std::optional<ResultObject> readResult(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored) || !looksLikeDicom(FileStart(file))) return std::nullopt;
  DcmFileFormat whole;
  loadHeader(file, whole);
  DcmDataset& dataset = *whole.getDataset();
  ResultObject result;
  result.sopClass = textOf(dataset, DCM_SOPClassUID);
  result.kind = kindOf(dataset, result.sopClass);
  if (result.kind.empty()) return std::nullopt;
  result.instance = textOf(dataset, DCM_SOPInstanceUID);
  result.series = textOf(dataset, DCM_SeriesInstanceUID);
  result.study = textOf(dataset, DCM_StudyInstanceUID);
  result.frameOfReference = textOf(dataset, DCM_FrameOfReferenceUID);
  result.description = typedTextOf(dataset, DCM_SeriesDescription);
  DcmItem* title = firstItem(&dataset, DCM_ConceptNameCodeSequence);
  if (title) result.title = typedTextOf(*title, DCM_CodeMeaning, &dataset);
  if (const char* name = result.title.empty() ? dcmFindNameOfUID(result.sopClass.c_str()) : nullptr)
    result.title = name;
  if (result.kind == "segmentation") result.segments = labelObjectIn(dataset, file).info.structures;
  if (result.kind == "capture")
    for (const DcmTagKey& tag : {DCM_DerivationDescription, DCM_ImageComments})
      if (std::string text = typedTextOf(dataset, tag); !text.empty()) result.texts.push_back(std::move(text));
  if (result.kind == "keys" || result.kind == "measures") ContentReader(dataset, result).read();
  return result;
}

}  // namespace fenestra::io::report
