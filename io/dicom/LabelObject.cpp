#include "io/dicom/LabelObject.h"

#include <utility>

#include "io/dicom/DicomValues.h"
#include "io/dicom/Segmentation.h"

namespace fenestra::io {
namespace {

void addText(DcmItem& item, const DcmTagKey& tag, std::set<std::string>& texts) {
  if (std::string value = textOf(item, tag); !value.empty()) texts.insert(std::move(value));
}

}  // namespace

bool DicomLabelObject::belongsTo(const std::string& seriesUid, const std::string& frame) const {
  if (!series.empty()) return series.contains(seriesUid);
  return !frame.empty() && frame == frameOfReference;
}

bool isLabelClass(const std::string& sopClass) {
  return sopClass == UID_SegmentationStorage || sopClass == labelMapSegmentationClass ||
         sopClass == UID_RTStructureSetStorage;
}

DicomLabelObject labelObjectIn(DcmDataset& dataset, const std::filesystem::path& path) {
  DicomLabelObject object;
  object.info.file = path;
  object.info.description = typedTextOf(dataset, DCM_SeriesDescription);
  object.frameOfReference = textOf(dataset, DCM_FrameOfReferenceUID);
  const bool structureSet = textOf(dataset, DCM_SOPClassUID) == UID_RTStructureSetStorage;
  object.info.kind = structureSet ? "RTSTRUCT" : "SEG";
  if (structureSet) {
    if (std::string label = typedTextOf(dataset, DCM_StructureSetLabel); !label.empty())
      object.info.description = label;
    forEachItem(dataset, DCM_StructureSetROISequence,
                [&](DcmItem& roi) { object.info.structures.push_back(typedTextOf(roi, DCM_ROIName, &dataset)); });
    forEachItem(dataset, DCM_ReferencedFrameOfReferenceSequence, [&](DcmItem& frame) {
      if (object.frameOfReference.empty()) object.frameOfReference = textOf(frame, DCM_FrameOfReferenceUID);
      forEachItem(frame, DCM_RTReferencedStudySequence, [&](DcmItem& study) {
        forEachItem(study, DCM_RTReferencedSeriesSequence,
                    [&](DcmItem& series) { addText(series, DCM_SeriesInstanceUID, object.series); });
      });
    });
    return object;
  }
  forEachItem(dataset, DCM_SegmentSequence,
              [&](DcmItem& segment) { object.info.structures.push_back(segmentName(segment, dataset)); });
  forEachItem(dataset, DCM_ReferencedSeriesSequence,
              [&](DcmItem& series) { addText(series, DCM_SeriesInstanceUID, object.series); });
  return object;
}

}  // namespace fenestra::io
