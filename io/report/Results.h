#pragma once
// Results as DICOM objects, in the study that they are about: tables of labels and drawn measures as structured
// reports, pictures as secondary captures, choices of images as key objects. Segmentations: dicom/SegmentationWriter.h.
//
// Every object copies patient and study of its source, and forms a series of its own. All files are written beside and
// renamed; all functions throw Error.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/base/Reading.h"
#include "rendering/volume/LabelStatistics.h"
#include "rendering/volume/SliceMeasure.h"

namespace fenestra::io::report {

/// A row of a table of labels.
struct MeasuredLabel {
  std::string name;
  LabelStatistics statistics;  ///< of at least one voxel
};

struct DrawnMeasure {
  Measure measure;
  MeasureValues values;
};

struct Measures {
  std::vector<MeasuredLabel> labels;
  std::filesystem::path segmentation;  ///< a DICOM segmentation, whose segment i + 1 is labels[i]; empty without labels
  std::vector<DrawnMeasure> drawn;
  Modality modality = Modality::Unknown;
  std::string unit;              ///< of the values, as Volume::unit
  std::string description = {};  ///< of the series; empty: "Measurements"
};

/// Writes measures as a Comprehensive 3D SR by TID 1500 (PS3.16): a group of measurements for each label, which refers
/// to its segment and the series (TID 1411), and one for each drawn measure, inferred from its points in the frame of
/// reference (TID 1501). `series`: the DICOM files of the volume, at least one.
void writeMeasures(const Measures& measures, const std::vector<std::filesystem::path>& series,
                   const std::filesystem::path& file);

/// A picture of a volume.
struct Capture {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> pixels;    ///< RGB, row by row from the top
  std::string description = {};        ///< of the series, one line
  std::vector<std::string> alters{};   ///< what the picture changes of the data, sentences
  std::string comments = {};           ///< about the picture, such as its certificate
  std::optional<bool> namesPatient{};  ///< whether its pixels show what names the patient; unset: unknown
};

/// Writes a secondary capture (PS3.3 A.8.1). The derivation description names what alters the data, and the image
/// comments hold `comments`; both are cut where the standard ends them, at 1024 and 10240 characters. Without `series`
/// the study is a new one of an unnamed patient.
void writeCapture(const Capture& capture, const std::vector<std::filesystem::path>& series,
                  const std::filesystem::path& file);

/// Images that are of interest.
struct KeyObjects {
  std::vector<SliceSource> images;  ///< at least one; files as in the series
  std::string description = {};     ///< why; may be empty
  std::string series = {};          ///< description of the series; empty: "Key objects"
};

/// Writes a key object selection (PS3.3 A.35.4) by TID 2010 with the title "Of Interest".
void writeKeyObjects(const KeyObjects& objects, const std::vector<std::filesystem::path>& series,
                     const std::filesystem::path& file);

/// What a result says that was read again; members of other kinds are empty.
struct ResultObject {
  std::string kind;   ///< "segmentation", "measures", "capture" or "keys"
  std::string title;  ///< of the document, or the kind of object by its SOP class
  std::string sopClass, instance, series, study, frameOfReference;
  std::string description;            ///< of the series; may hold anything typed
  std::vector<std::string> segments;  ///< names
  struct Value {
    std::string group, name, derivation;  ///< what is measured, which quantity of it, and as what: "Mean"
    double value = 0.0;
    std::string unit;                ///< UCUM
    int segment = 0;                 ///< of the group's segmentation; 0: none
    std::vector<glm::dvec3> points;  ///< world (LPS), mm
  };
  std::vector<Value> values;
  struct Image {
    std::string instance;
    std::vector<int> frames;  ///< from 1; empty: all
  };
  std::vector<Image> images;       ///< that key objects name
  std::vector<std::string> texts;  ///< of key objects and captures; may hold anything typed
};

/// What the file holds, where it is a segmentation, a structured report, a key object selection or a secondary capture
/// in colours, of whatever program; empty for other files, DICOM or not.
std::optional<ResultObject> readResult(const std::filesystem::path& file);

}  // namespace fenestra::io::report
