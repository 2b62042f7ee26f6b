#include <map>
#include <optional>
#include <set>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmsr/codes/dcm.h>
#include <dcmtk/dcmsr/dsrdoc.h>

#include "io/dicom/DicomHeader.h"
#include "io/report/Origin.h"
#include "io/report/Results.h"
#include "io/report/SrDocument.h"

namespace fenestra::io::report {
namespace fs = std::filesystem;
namespace {

/// The frames of each file, from 1; empty for a file that is one image.
std::map<std::uint32_t, std::set<int>> framesOfFiles(const KeyObjects& objects, const std::vector<DicomFile>& files) {
  std::map<std::uint32_t, std::set<int>> chosen;
  for (const SliceSource& image : objects.images) {
    auto& frames = chosen[image.file];
    if (files.at(image.file).frames.size() > 1) frames.insert(static_cast<int>(image.frame) + 1);
  }
  return chosen;
}

}  // namespace

void writeKeyObjects(const KeyObjects& objects, const std::vector<fs::path>& series, const fs::path& file) {
  if (series.empty() || objects.images.empty())
    throw Error(file, "would name no image", "choose slices of a DICOM series");
  std::vector<DicomFile> files(series.size());
  for (const SliceSource& image : objects.images)
    if (DicomFile& at = files.at(image.file); at.path.empty()) at = readDicomHeader(series[image.file]);
  Origin origin;
  readOrigin(series[objects.images.front().file], origin);

  DSRDocument document(DSRTypes::DT_KeyObjectSelectionDocument);
  beginDocument(document, origin, objects.series.empty() ? "Key objects" : objects.series, "1002", file);
  DSRDocumentTree& tree = document.getTree();
  tree.addContentItem(DSRTypes::RT_isRoot, DSRTypes::VT_Container);
  require(tree.getCurrentContentItem().setConceptName(CODE_DCM_OfInterest), file, "its title");
  require(tree.setTemplateIdentification("2010", "DCMR"), file, "its template");
  DSRTypes::E_AddMode mode = DSRTypes::AM_belowCurrent;
  if (!objects.description.empty()) {
    tree.addContentItem(DSRTypes::RT_contains, DSRTypes::VT_Text, mode);
    mode = DSRTypes::AM_afterCurrent;
    require(tree.getCurrentContentItem().setConceptName(CODE_DCM_KeyObjectDescription), file, "its description");
    // Unchecked: DCMTK's check knows no characters beyond ASCII.
    const std::string description = bounded(objects.description, 1024);
    require(tree.getCurrentContentItem().setStringValue(description.c_str(), OFFalse), file, "its description");
  }
  for (const auto& [index, frames] : framesOfFiles(objects, files)) {
    const DicomFile& image = files[index];
    if (image.instance.empty() || image.studyUid.empty() || image.series.empty())
      throw Error(series[index], "does not say which object it is, so that nothing can refer to it",
                  "choose images of another series");
    tree.addContentItem(DSRTypes::RT_contains, DSRTypes::VT_Image, mode);
    mode = DSRTypes::AM_afterCurrent;
    DSRImageReferenceValue reference(image.sopClass.c_str(), image.instance.c_str());
    for (const int frame : frames) reference.getFrameList().addItem(frame);
    require(tree.getCurrentContentItem().setImageReference(reference), file, "an image");
    require(document.getCurrentRequestedProcedureEvidence().addItem(image.studyUid.c_str(), image.series.c_str(),
                                                                    image.sopClass.c_str(), image.instance.c_str()),
            file, "an image");
  }
  saveDocument(document, file);
}

}  // namespace fenestra::io::report
