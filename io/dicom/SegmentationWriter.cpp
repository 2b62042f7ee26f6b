#include "io/dicom/SegmentationWriter.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmiod/cielabutil.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include "io/base/AtomicFile.h"
#include "io/dicom/Dataset.h"
#include "io/dicom/DicomHeader.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Where one slice of the labels comes from.
struct SourceFrame {
  std::string sopClass, instance;
  int number = 0;  ///< of the frame in a multi-frame file, from 1; 0 in others
};

struct Source {
  std::vector<std::optional<SourceFrame>> slices;           ///< one a slice of the grid
  std::set<std::pair<std::string, std::string>> instances;  ///< SOP class and instance UIDs
  std::string series;
};

/// Throws Error naming `file` when DCMTK refused.
void require(const OFCondition& condition, const fs::path& file, const char* what) {
  if (condition.bad())
    throw Error(file, std::string("cannot be made: ") + what + " (" + condition.text() + ")",
                "write the labels as .nrrd or .nii.gz instead");
}

OFString decimal(double value) { return decimalText(value).c_str(); }

Source sourceOf(const std::vector<fs::path>& series, const Grid& grid) {
  Source source;
  source.slices.resize(static_cast<std::size_t>(grid.dims.z));
  const glm::dmat4 indexFromWorld = grid.indexFromWorld();
  for (const fs::path& path : series) {
    const DicomFile file = readDicomHeader(path);
    source.series = file.series;
    for (const DicomFrame& frame : file.frames) {
      const glm::dvec3 index(indexFromWorld * glm::dvec4(frame.position, 1.0));
      const double slice = std::round(index.z);
      // A tenth of a slice: another slice of the same place is further away.
      if (!frame.hasGeometry || !(std::abs(index.z - slice) < 0.1) || slice < 0.0 || slice >= grid.dims.z) continue;
      source.slices[static_cast<std::size_t>(slice)] =
          SourceFrame{file.sopClass, file.instance, file.frames.size() > 1 ? frame.number + 1 : 0};
      source.instances.insert({file.sopClass, file.instance});
    }
  }
  return source;
}

/// At most 64 characters without a backslash, as a long string (LO) may hold.
std::string longText(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  std::erase_if(name, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  std::size_t characters = 0, end = 0;
  for (; end < name.size(); ++end)
    if ((static_cast<unsigned char>(name[end]) & 0xc0) != 0x80 && ++characters > 64) break;
  return name.substr(0, end);
}

std::string segmentLabel(const Label& label) {
  return longText(label.name.empty() ? "label " + std::to_string(label.value) : label.name);
}

Label describedBy(const LabelMap& labels, std::uint16_t value) {
  const Label* label = labels.find(value);
  return label ? *label : Label{value, {}, defaultLabelColour(value)};
}

void addSegment(DcmSegmentation& document, const Label& label, const fs::path& file) {
  // The most general codes (SNOMED CT): what a structure is stands in its name alone.
  const CodeSequenceMacro tissue("85756007", "SCT", "Tissue");
  DcmSegment* made = nullptr;
  // Named in the dataset: DCMTK's check of a segment knows no characters beyond ASCII.
  require(DcmSegment::create(made, "segment", tissue, tissue, DcmSegTypes::SAT_SEMIAUTOMATIC, "Fenestra"), file,
          "a segment");
  double lightness = 0.0, a = 0.0, b = 0.0;
  IODCIELabUtil::rgb2DicomLab(lightness, a, b, label.colour.r, label.colour.g, label.colour.b);
  const auto word = [](double value) { return static_cast<Uint16>(std::clamp(std::round(value), 0.0, 65535.0)); };
  made->setRecommendedDisplayCIELabValue(word(lightness), word(a), word(b));
  Uint16 number = 0;
  require(document.addSegment(made, number), file, "a segment");
}

/// Empties what describes the patient and the study; identifiers of study, series and frame of reference stay.
void removePatient(DcmDataset& dataset) {
  constexpr Uint16 patientGroup = 0x0010;  // PS3.6: everything about the patient
  for (unsigned long at = dataset.card(); at-- > 0;)
    if (dataset.getElement(at)->getGTag() == patientGroup) delete dataset.remove(at);
  for (const DcmTagKey& tag : {DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_PatientSex, DCM_StudyDate,
                               DCM_StudyTime, DCM_StudyID, DCM_AccessionNumber, DCM_ReferringPhysicianName})
    dataset.putAndInsertString(tag, "");  // the standard wants them, if empty
  for (const DcmTagKey& tag :
       {DCM_StudyDescription, DCM_ConsultingPhysicianName, DCM_PhysiciansOfRecord, DCM_NameOfPhysiciansReadingStudy,
        DCM_AdmittingDiagnosesDescription, DCM_InstitutionName, DCM_InstitutionAddress})
    dataset.findAndDeleteElement(tag);
}

/// Removes dates, ages, numbers and codes that break their VR, such as an age of "0Y": DCMTK would refuse the copy, and
/// so might a reader.
void removeIllFormed(DcmDataset& dataset) {
  std::vector<DcmTagKey> illFormed;
  for (unsigned long i = 0; i < dataset.card(); ++i) {
    DcmElement* element = dataset.getElement(i);
    const DcmEVR vr = element->getVR();
    if (vr != EVR_AS && vr != EVR_DA && vr != EVR_TM && vr != EVR_DT && vr != EVR_DS && vr != EVR_IS && vr != EVR_CS)
      continue;
    if (element->checkValue("1-n") == EC_ValueRepresentationViolated) illFormed.push_back(element->getTag());
  }
  for (const DcmTagKey& tag : illFormed) dataset.findAndDeleteElement(tag);
}

/// Patient, study and frame of reference, of the first file of the series or new.
void describeOrigin(DcmSegmentation& document, const SegmentationOrigin& origin, const fs::path& file) {
  if (!origin.series.empty()) {
    DcmFileFormat first;
    loadHeader(origin.series.front(), first);
    DcmDataset& dataset = *first.getDataset();
    // Names of segments are UTF-8, so everything is.
    dataset.convertToUTF8();
    if (!origin.namesPatient) removePatient(dataset);
    removeIllFormed(dataset);
    require(document.importFromSourceImage(dataset), file, "patient and study");
    if (textOf(dataset, DCM_LossyImageCompression) == "01")
      document.setLossyImageCompressionFlag(textOf(dataset, DCM_LossyImageCompressionRatio).c_str(),
                                            textOf(dataset, DCM_LossyImageCompressionMethod).c_str(), OFFalse);
  }
  char uid[100];
  OFString present;
  if (document.getStudy().getStudyInstanceUID(present).bad() || present.empty())
    document.getStudy().setStudyInstanceUID(dcmGenerateUniqueIdentifier(uid, SITE_STUDY_UID_ROOT));
  if (document.getFrameOfReference().getFrameOfReferenceUID(present).bad() || present.empty())
    document.getFrameOfReference().setFrameOfReferenceUID(dcmGenerateUniqueIdentifier(uid, SITE_UID_ROOT));
  document.getSOPCommon().setSpecificCharacterSet("ISO_IR 192");
  document.getSeries().setSeriesDescription(
      origin.description.empty() ? "Segmentation" : longText(origin.description).c_str(), OFFalse);
  document.getSeries().setSeriesNumber("1000");
}

void describeGrid(DcmSegmentation& document, const Grid& grid, const fs::path& file) {
  FGPixelMeasures measures;
  measures.setPixelSpacing(decimal(grid.spacing.y) + "\\" + decimal(grid.spacing.x));
  const glm::dvec3 normal = glm::normalize(glm::cross(grid.direction[0], grid.direction[1]));
  const double step = std::abs(glm::dot(grid.direction[2], normal)) * grid.spacing.z;
  measures.setSliceThickness(decimal(step));
  measures.setSpacingBetweenSlices(decimal(step));
  require(document.addForAllFrames(measures), file, "its spacing");
  FGPlaneOrientationPatient orientation;
  const glm::dvec3 &row = grid.direction[0], &column = grid.direction[1];
  orientation.setImageOrientationPatient(decimal(row.x), decimal(row.y), decimal(row.z), decimal(column.x),
                                         decimal(column.y), decimal(column.z));
  require(document.addForAllFrames(orientation), file, "its orientation");
  char uid[100];
  const OFString organisation = dcmGenerateUniqueIdentifier(uid, SITE_UID_ROOT);
  IODMultiframeDimensionModule& dimensions = document.getDimensions();
  require(dimensions.addDimensionIndex(DCM_ReferencedSegmentNumber, organisation, DCM_SegmentIdentificationSequence,
                                       "segment"),
          file, "its dimensions");
  require(dimensions.addDimensionIndex(DCM_ImagePositionPatient, organisation, DCM_PlanePositionSequence, "position"),
          file, "its dimensions");
}

/// One frame: which segment, which slice, and what it was made from.
void addFrame(DcmSegmentation& document, std::vector<Uint8>& pixels, std::size_t segment, int slice, const Grid& grid,
              const Source& source, const fs::path& file) {
  FGPlanePosPatient place;
  const glm::dvec3 position(grid.worldFromIndex() * glm::dvec4(0, 0, slice, 1.0));
  place.setImagePositionPatient(decimal(position.x), decimal(position.y), decimal(position.z));
  FGFrameContent content;
  content.setStackID("1");
  content.setInStackPositionNumber(static_cast<Uint32>(slice) + 1);
  content.setDimensionIndexValues(static_cast<Uint32>(segment), 0);
  content.setDimensionIndexValues(static_cast<Uint32>(slice) + 1, 1);
  OFVector<FGBase*> groups;
  groups.push_back(&place);
  groups.push_back(&content);
  std::unique_ptr<FGDerivationImage> derivation;
  if (const auto& from = source.slices[static_cast<std::size_t>(slice)]; from && !from->instance.empty()) {
    ImageSOPInstanceReferenceMacro* reference = nullptr;
    if (ImageSOPInstanceReferenceMacro::create(from->sopClass.c_str(), from->instance.c_str(), reference).good()) {
      const std::unique_ptr<ImageSOPInstanceReferenceMacro> owned(reference);
      if (from->number > 0) reference->addReferencedFrameNumber(static_cast<Uint16>(from->number));
      OFVector<ImageSOPInstanceReferenceMacro> references;
      references.push_back(*reference);
      derivation.reset(DcmSegmentation::createDerivationImageFG(references, "Segmentation"));
    }
  } else if (!source.series.empty()) {
    // Interpolated between the slices: the group, which the other frames have, is there and empty.
    derivation = std::make_unique<FGDerivationImage>();
  }
  if (derivation) groups.push_back(derivation.get());
  require(document.addFrame(pixels.data(), static_cast<Uint16>(segment), groups), file, "a frame");
}

/// Frames of one bit a pixel after each other without padding, the lowest bit first (PS3.5 8.1.1).
class PackedFrames {
 public:
  void append(const std::vector<Uint8>& pixels) {
    for (const Uint8 pixel : pixels) {
      if (bits_ % 8 == 0) bytes_.push_back(0);
      bytes_.back() = static_cast<Uint8>(bytes_.back() | pixel << (bits_ % 8));
      ++bits_;
    }
  }
  /// Pixel data has an even length.
  const std::vector<Uint8>& bytes() {
    if (bytes_.size() % 2) bytes_.push_back(0);
    return bytes_;
  }

 private:
  std::vector<Uint8> bytes_;
  std::uint64_t bits_ = 0;
};

/// Returns the pixels of all frames.
PackedFrames addFrames(DcmSegmentation& document, const LabelMap& labels, const std::vector<std::uint16_t>& wanted,
                       const Source& source, const fs::path& file, const Progress& progress) {
  PackedFrames packed;
  const Grid& grid = labels.grid;
  const std::size_t count = static_cast<std::size_t>(grid.dims.x) * static_cast<std::size_t>(grid.dims.y);
  std::vector<Uint8> pixels(count);
  labels.voxels.visit([&](auto voxels) {
    for (int slice = 0; slice < grid.dims.z; ++slice) {
      if (progress && !progress(static_cast<double>(slice) / grid.dims.z, "writing segments")) throw Cancelled();
      const auto values = voxels.subspan(static_cast<std::size_t>(slice) * count, count);
      std::vector<bool> present(65536, false);
      for (const auto value : values) present[static_cast<std::uint16_t>(value)] = true;
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        if (!present[wanted[i]]) continue;
        for (std::size_t at = 0; at < count; ++at) pixels[at] = static_cast<std::uint16_t>(values[at]) == wanted[i];
        addFrame(document, pixels, i + 1, slice, grid, source, file);
        packed.append(pixels);
      }
    }
  });
  return packed;
}

/// Common Instance Reference (PS3.3 C.12.2): the images that the labels were drawn on.
void addReferences(DcmDataset& dataset, const Source& source) {
  if (source.series.empty() || source.instances.empty()) return;
  DcmItem* series = nullptr;
  dataset.findAndDeleteElement(DCM_ReferencedSeriesSequence);
  dataset.findOrCreateSequenceItem(DCM_ReferencedSeriesSequence, series, 0);
  series->putAndInsertString(DCM_SeriesInstanceUID, source.series.c_str());
  for (const auto& [sopClass, instance] : source.instances) {
    DcmItem* item = nullptr;
    series->findOrCreateSequenceItem(DCM_ReferencedInstanceSequence, item, -2);
    item->putAndInsertString(DCM_ReferencedSOPClassUID, sopClass.c_str());
    item->putAndInsertString(DCM_ReferencedSOPInstanceUID, instance.c_str());
  }
}

/// The labels that have voxels, and that segments can hold.
std::vector<std::uint16_t> presentLabels(const LabelMap& labels, const std::vector<std::uint16_t>& wanted,
                                         const fs::path& file) {
  const Grid& grid = labels.grid;
  if (std::abs(glm::dot(grid.direction[0], grid.direction[1])) > 1e-4 || grid.dims.x > 65535 || grid.dims.y > 65535)
    throw Error(file, "cannot be DICOM: the volume's rows and columns are not at right angles, or too many",
                "write the labels as .nrrd or .nii.gz instead");
  std::vector<bool> present(65536, false);
  labels.voxels.visit([&](auto voxels) {
    for (const auto value : voxels) present[static_cast<std::uint16_t>(value)] = true;
  });
  std::vector<std::uint16_t> result;
  for (const std::uint16_t value : wanted)
    if (present[value] && value != 0) result.push_back(value);
  if (result.empty()) throw Error(file, "would be empty: no voxel has any of the labels", "choose other labels");
  return result;
}

}  // namespace

void writeSegmentation(const LabelMap& labels, const std::vector<std::uint16_t>& wanted,
                       const SegmentationOrigin& origin, const fs::path& file, const Progress& progress) {
  prepareDcmtk();
  const std::vector<std::uint16_t> present = presentLabels(labels, wanted, file);
  const Source source = sourceOf(origin.series, labels.grid);
  const IODGeneralEquipmentModule::EquipmentInfo equipment("Fenestra", "Fenestra", "0", "1");
  const ContentIdentificationMacro content("1", "SEGMENTATION", "", "");
  DcmSegmentation* made = nullptr;
  require(DcmSegmentation::createBinarySegmentation(made, static_cast<Uint16>(labels.grid.dims.y),
                                                    static_cast<Uint16>(labels.grid.dims.x), equipment, content),
          file, "the document");
  const std::unique_ptr<DcmSegmentation> document(made);
  describeOrigin(*document, origin, file);
  describeGrid(*document, labels.grid, file);
  for (const std::uint16_t value : present) addSegment(*document, describedBy(labels, value), file);
  PackedFrames pixels = addFrames(*document, labels, present, source, file, progress);
  DcmFileFormat whole;
  require(document->writeDataset(*whole.getDataset()), file, "the dataset");
  std::size_t segment = 0;
  forEachItem(*whole.getDataset(), DCM_SegmentSequence, [&](DcmItem& item) {
    item.putAndInsertString(DCM_SegmentLabel, segmentLabel(describedBy(labels, present[segment++])).c_str());
  });
  // DCMTK 3.6.7 packs frames wrongly whose number of pixels is no multiple of eight.
  const std::vector<Uint8>& bytes = pixels.bytes();
  require(whole.getDataset()->putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size()), file, "the pixels");
  addReferences(*whole.getDataset(), source);
  writeAtomically(file, [&](const fs::path& temporary) {
    const OFCondition saved = whole.saveFile(OFFilename(temporary.c_str()), EXS_LittleEndianExplicit);
    if (saved.bad())
      throw Error(file, std::string("cannot be written: ") + saved.text(),
                  "check the folder, its permissions and the free space");
  });
}

}  // namespace fenestra::io
