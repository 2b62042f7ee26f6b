#include <cmath>
#include <map>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmsr/cmr/tid1500.h>
#include <dcmtk/dcmsr/dsrdoc.h>

#include "io/dicom/Dataset.h"
#include "io/dicom/DicomHeader.h"
#include "io/dicom/DicomValues.h"
#include "io/report/Origin.h"
#include "io/report/Results.h"
#include "io/report/SrDocument.h"
#include "io/report/Units.h"

namespace fenestra::io::report {
namespace fs = std::filesystem;
namespace {

using Report = TID1500_MeasurementReport;
using Quantity = CID7469_GenericIntensityAndSizeMeasurements;
using Unit = CID7181_AbstractMultiDimensionalImageModelComponentUnits;
using Derivation = CID7464_GeneralRegionOfInterestMeasurementModifiers;

/// A group of measurements of TID 1411 or 1501, to which values are added.
template <class Group>
class Values {
 public:
  Values(Group& group, fs::path file) : group_(group), file_(std::move(file)) {}

  void add(const Quantity& quantity, double value, const Unit& unit) {
    typename Group::MeasurementValue number(decimalText(value).c_str(), unit);
    // The decimal string has 16 characters, which a double may exceed.
    require(number.setFloatingPointRepresentation(value), file_, "a value");
    require(group_.addMeasurement(quantity, number), file_, "a value");
  }
  void add(const Quantity& quantity, double value, const Unit& unit, const Derivation& derivation) {
    add(quantity, value, unit);
    require(group_.getMeasurement().setDerivation(derivation), file_, "a value");
  }
  /// Mean, standard deviation, least and greatest of Volume's values.
  template <class Statistics>
  void addStatistics(const Statistics& of, const Measures& measures) {
    const Quantity quantity(valueCode(measures.modality, measures.unit));
    const Unit unit(unitCode(measures.unit));
    add(quantity, of.mean, unit, Derivation::Mean);
    add(quantity, of.deviation, unit, Derivation::StandardDeviation);
    add(quantity, of.least, unit, Derivation::Minimum);
    add(quantity, of.greatest, unit, Derivation::Maximum);
  }

 private:
  Group& group_;
  fs::path file_;
};

void addLabels(Report& report, const Measures& measures, DcmDataset& segmentation, const std::string& series,
               const fs::path& file) {
  for (std::size_t i = 0; i < measures.labels.size(); ++i) {
    const MeasuredLabel& label = measures.labels[i];
    require(report.addVolumetricROIMeasurements(), file, "a group of measurements");
    auto& group = report.getVolumetricROIMeasurements();
    const std::string name =
        label.name.empty() ? "label " + std::to_string(label.statistics.label) : longString(label.name);
    // Unchecked: DCMTK's check knows no characters beyond ASCII.
    require(group.setTrackingIdentifier(name.c_str(), OFFalse), file, "a label's name");
    require(group.setTrackingUniqueIdentifier(newUid().c_str()), file, "a label's identifier");
    require(group.setReferencedSegment(segmentation, static_cast<Uint16>(i + 1), OFFalse), file, "a segment");
    require(group.setSourceSeriesForSegmentation(series.c_str()), file, "the series");
    Values values(group, file);
    // A millilitre is a cubic centimetre, which alone the context group of units has.
    values.add(Quantity::Volume, label.statistics.millilitres, Unit::CubicCentimeter);
    if (label.statistics.valued > 0) values.addStatistics(label.statistics, measures);
  }
}

/// What a drawn measure is called, and its points as a graphic of PS3.3 C.18.9.
struct Drawn {
  const char* word;
  DSRBasicCodedEntry quantity;
  DSRTypes::E_GraphicType3D graphic;
};
Drawn drawnAs(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::Distance:
      return {"distance", DSRBasicCodedEntry("410668003", "SCT", "Length"), DSRTypes::GT3_Polyline};
    case MeasureKind::Angle:
      return {"angle", DSRBasicCodedEntry("1483009", "SCT", "Angle"), DSRTypes::GT3_Polyline};
    case MeasureKind::Ellipse:
      return {"ellipse", DSRBasicCodedEntry("42798000", "SCT", "Area"), DSRTypes::GT3_Ellipse};
    case MeasureKind::Rectangle:
    case MeasureKind::Arrow:  // marks measure nothing, and are left out before
    case MeasureKind::Text:
      break;
  }
  return {"rectangle", DSRBasicCodedEntry("42798000", "SCT", "Area"), DSRTypes::GT3_Polygon};
}

std::vector<glm::dvec3> graphicPoints(const Measure& measure) {
  if (!isRegion(measure.kind)) return measure.points;
  const glm::dvec3 a = measure.points[0], across = measure.points[1] - a;
  const glm::dvec3 right = measure.right * glm::dot(across, measure.right);
  const glm::dvec3 down = measure.down * glm::dot(across, measure.down);
  // A polygon ends where it began.
  if (measure.kind == MeasureKind::Rectangle) return {a, a + right, a + right + down, a + down, a};
  // The ends of the major axis, then of the minor one.
  const glm::dvec3 centre = a + 0.5 * (right + down);
  const bool isWide = glm::length(right) >= glm::length(down);
  const glm::dvec3 major = 0.5 * (isWide ? right : down), minor = 0.5 * (isWide ? down : right);
  return {centre - major, centre + major, centre - minor, centre + minor};
}

void addDrawn(Report& report, const Measures& measures, const fs::path& file) {
  std::map<MeasureKind, int> count;
  for (const DrawnMeasure& drawn : measures.drawn) {
    const Drawn as = drawnAs(drawn.measure.kind);
    require(report.addIndividualMeasurements(), file, "a group of measurements");
    auto& group = report.getIndividualMeasurements();
    const std::string name = std::string(as.word) + " " + std::to_string(++count[drawn.measure.kind]);
    require(group.setTrackingIdentifier(name.c_str()), file, "a measure's name");
    require(group.setTrackingUniqueIdentifier(newUid().c_str()), file, "a measure's identifier");
    Values values(group, file);
    if (drawn.values.length) values.add(Quantity(as.quantity), *drawn.values.length, Unit::Millimeter);
    if (drawn.values.angle)
      values.add(Quantity(as.quantity), *drawn.values.angle, Unit(DSRCodedEntryValue("deg", "UCUM", "degree")));
    if (drawn.values.area) values.add(Quantity(as.quantity), *drawn.values.area, Unit::SquareMillimeter);
    if (drawn.values.region) values.addStatistics(*drawn.values.region, measures);
  }
}

/// Puts the points of each drawn measure below the value that was inferred from them, which TID 300 allows, but which
/// DCMTK has no function for. The groups are in the order of the measures, and each has one such value.
void addPoints(DSRDocumentTree& tree, const Measures& measures, const std::string& frame, const fs::path& file) {
  if (measures.drawn.empty()) return;
  std::size_t next = 0;
  for (std::size_t node = tree.gotoRoot(); node != 0 && next < measures.drawn.size(); node = tree.iterate()) {
    const Measure& measure = measures.drawn[next].measure;
    const Drawn as = drawnAs(measure.kind);
    const DSRContentItem& item = tree.getCurrentContentItem();
    if (item.getValueType() != DSRTypes::VT_Num || item.getConceptName() != DSRCodedEntryValue(as.quantity)) continue;
    DSRSpatialCoordinates3DValue points(as.graphic);
    for (const glm::vec3 point : graphicPoints(measure)) points.getGraphicDataList().addItem(point.x, point.y, point.z);
    require(points.setFrameOfReferenceUID(frame.c_str()), file, "the frame of reference");
    require(tree.addChildContentItem(DSRTypes::RT_inferredFrom, DSRTypes::VT_SCoord3D,
                                     DSRCodedEntryValue("121055", "DCM", "Path")),
            file, "points");
    require(tree.getCurrentContentItem().setSpatialCoordinates3D(points), file, "points");
    tree.goUp();
    ++next;
  }
  if (next != measures.drawn.size()) throw Error(file, "cannot be made: a measure has no value", "remove the measure");
}

CID100_QuantitativeDiagnosticImagingProcedures procedureOf(Modality modality) {
  using Procedure = CID100_QuantitativeDiagnosticImagingProcedures;
  if (modality == Modality::CT) return Procedure::CTUnspecifiedBodyRegion;
  if (modality == Modality::MR) return Procedure::MRIUnspecifiedBodyRegion;
  if (modality == Modality::PT) return Procedure::PETUnspecifiedBodyRegion;
  return Procedure::ImagingProcedure;
}

/// Patient and study are those of the segmentation, where there is one: it has the identifiers that the series lacks.
void readOriginOf(const Measures& measures, const std::vector<fs::path>& series, Origin& origin, const fs::path& file) {
  if (measures.labels.empty() && measures.drawn.empty())
    throw Error(file, "would be empty: there is no label with voxels, and no measure",
                "open a label map with it, or a session with measures");
  if (series.empty()) throw Error(file, "would be about no DICOM series", "measure a DICOM series");
  readOrigin(measures.labels.empty() ? series.front() : measures.segmentation, origin);
  if (!measures.drawn.empty() && origin.frameOfReference.empty())
    throw Error(series.front(), "names no frame of reference, in which measures could be told",
                "report labels alone, from a session without measures");
  std::size_t segments = 0;
  if (!measures.labels.empty()) forEachItem(origin.dataset(), DCM_SegmentSequence, [&](DcmItem&) { ++segments; });
  if (segments != measures.labels.size())
    throw Error(measures.segmentation, "has other segments than the labels to report", "write it anew");
}

}  // namespace

void writeMeasures(const Measures& measures, const std::vector<fs::path>& series, const fs::path& file) {
  Origin origin;
  readOriginOf(measures, series, origin, file);
  const DicomFile source = readDicomHeader(series.front());
  if (source.series.empty())
    throw Error(series.front(), "does not say which series it belongs to, so that nothing can refer to it",
                "measure another series");
  Report report(CID7021_MeasurementReportDocumentTitles::ImagingMeasurementReport);
  require(report.setLanguage(CID5000_Languages::English), file, "its language");
  require(report.getObservationContext().addDeviceObserver(newUid().c_str(), "Fenestra", "Fenestra", "Fenestra"), file,
          "its observer");
  require(report.addProcedureReported(procedureOf(measures.modality)), file, "its procedure");
  addLabels(report, measures, origin.dataset(), source.series, file);
  addDrawn(report, measures, file);
  if (!report.isValid())
    throw Error(file, "cannot be made: it breaks the template of measurement reports", "please report it");
  DSRDocument document;
  require(document.setTreeFromRootTemplate(report), file, "its tree");
  // The template makes it an Enhanced SR, which has no points in space.
  require(document.changeDocumentType(DSRTypes::DT_Comprehensive3DSR), file, "its kind");
  beginDocument(document, origin, measures.description.empty() ? "Measurements" : measures.description, "1001", file);
  addPoints(document.getTree(), measures, origin.frameOfReference, file);
  if (!measures.labels.empty())
    require(document.getCurrentRequestedProcedureEvidence().addItem(origin.dataset()), file, "its segmentation");
  saveDocument(document, file);
}

}  // namespace fenestra::io::report
