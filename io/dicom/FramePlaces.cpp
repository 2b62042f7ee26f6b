#include "io/dicom/FramePlaces.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/base/Text.h"
#include "io/dicom/DicomValues.h"

namespace fenestra::io {
namespace {

/// Where an object keeps a position and an orientation: sequences, or the dataset itself (0,0).
struct PlaceSource {
  DcmTagKey positionSequence, position, orientationSequence, orientation;
  unsigned bit;  ///< of DicomFrame::assumed
  bool grouped;  ///< in functional groups, so that each frame has a place of its own
};

const std::array<PlaceSource, 5>& placeSources() {
  static const DcmTagKey itself(0, 0);
  static const std::array<PlaceSource, 5> sources = {
      {{DCM_PlanePositionSequence, DCM_ImagePositionPatient, DCM_PlaneOrientationSequence, DCM_ImageOrientationPatient,
        0, true},
       {DCM_PlanePositionVolumeSequence, DCM_ImagePositionVolume, DCM_PlaneOrientationVolumeSequence,
        DCM_ImageOrientationVolume, assumed::volumePlace, true},
       {itself, DCM_ImagePositionPatient, itself, DCM_ImageOrientationPatient, 0, false},
       {DCM_DetectorInformationSequence, DCM_ImagePositionPatient, DCM_DetectorInformationSequence,
        DCM_ImageOrientationPatient, 0, false},
       {itself, DCM_RETIRED_ImagePosition, itself, DCM_RETIRED_ImageOrientation, 0, false}}};
  return sources;
}

DcmItem* itemIn(const Scopes& scopes, const PlaceSource& source, const DcmTagKey& sequence) {
  if (!source.grouped) return sequence == DcmTagKey(0, 0) ? &scopes.dataset : firstItem(&scopes.dataset, sequence);
  DcmItem* own = firstItem(scopes.perFrame, sequence);
  return own ? own : firstItem(scopes.shared, sequence);
}

/// Pixel Spacing, else that of the detector, else that of an ultrasound region, else 1 mm.
void readSpacing(DcmItem& measures, DcmItem& dataset, DicomFrame& frame) {
  const auto positive = [](const std::optional<glm::dvec2>& spacing) {
    return spacing && spacing->x > 0.0 && spacing->y > 0.0;
  };
  // Both are (between rows, between columns).
  for (const DcmTagKey& tag : {DCM_PixelSpacing, DCM_ImagerPixelSpacing}) {
    const auto spacing = numbersOf<2>(measures, tag);
    if (!positive(spacing)) continue;
    frame.spacing = {spacing->y, spacing->x};
    if (tag == DCM_ImagerPixelSpacing) frame.assumed |= assumed::detectorSpacing;
    return;
  }
  if (DcmItem* region = firstItem(&dataset, DCM_SequenceOfUltrasoundRegions)) {
    constexpr std::int64_t centimetres = 3;
    const auto x = numberOf(*region, DCM_PhysicalDeltaX), y = numberOf(*region, DCM_PhysicalDeltaY);
    const bool lengths = integerOf(*region, DCM_PhysicalUnitsXDirection) == centimetres &&
                         integerOf(*region, DCM_PhysicalUnitsYDirection) == centimetres;
    if (lengths && x && y && *x != 0.0 && *y != 0.0) {
      frame.spacing = 10.0 * glm::dvec2(std::abs(*x), std::abs(*y));
      return;
    }
  }
  frame.assumed |= textOf(measures, DCM_PixelSpacing).empty() ? assumed::spacing : assumed::garbledSpacing;
}

/// The directions of rows and columns; false where the item gives no two unit vectors at right angles.
bool readAxes(DcmItem& item, const DcmTagKey& tag, glm::dmat2x3& axes) {
  glm::dvec3 row(0.0), column(0.0);
  for (unsigned i = 0; i < 3; ++i) {
    row[static_cast<int>(i)] = numberOf(item, tag, i).value_or(0.0);
    column[static_cast<int>(i)] = numberOf(item, tag, i + 3).value_or(0.0);
  }
  // Direction cosines are unit vectors at right angles; a damaged pair cannot place the image.
  if (std::abs(glm::length(row) - 1.0) >= 0.1 || std::abs(glm::length(column) - 1.0) >= 0.1 ||
      std::abs(glm::dot(row, column)) >= 0.1)
    return false;
  axes = glm::dmat2x3(glm::normalize(row), glm::normalize(column));
  return true;
}

glm::dvec3 normalOf(const DicomFrame& frame) { return glm::cross(frame.axes[0], frame.axes[1]); }

/// Frames along the normal at the offsets that an attribute gives, from the first one's. Empty where it lacks some.
std::vector<double> offsetsIn(DcmItem& dataset, const DcmTagKey& tag, std::size_t frames) {
  std::vector<double> offsets;
  const auto first = numberOf(dataset, tag);
  for (std::size_t i = 0; first && i < frames; ++i) {
    const auto offset = numberOf(dataset, tag, i);
    if (!offset) return {};
    offsets.push_back(*offset - *first);
  }
  return offsets;
}

/// RT dose. Offsets start at 0, or are the slices' own z (C.8.8.3.2): both give distances from the first.
void scaleDoses(DcmItem& dataset, DicomFile& file) {
  for (DicomFrame& frame : file.frames) {
    frame.slope = numberOf(dataset, DCM_DoseGridScaling).value_or(0.0);
    // 1e30: beyond it the values of an image would fit no float.
    if (frame.slope != 0.0 && std::abs(frame.slope) < 1e30) continue;
    frame.slope = 1.0;
    frame.assumed |= assumed::doseScaling;
  }
  const std::string units = codeOf(dataset, DCM_DoseUnits);
  file.unit = units == "GY" ? "Gy" : lowered(units);
}

bool pointsTo(DcmItem& dataset, const char* tag) {
  return textOf(dataset, DCM_FrameIncrementPointer).find(tag) != std::string::npos;
}

/// The distances of the frames from the first one, along the normal; empty where the header does not give them.
std::vector<double> frameOffsets(DcmItem& dataset, DicomFile& file) {
  const std::size_t count = file.frames.size();
  if (file.sopClass == UID_RTDoseStorage) return offsetsIn(dataset, DCM_GridFrameOffsetVector, count);
  if (pointsTo(dataset, "0018,2005")) return offsetsIn(dataset, DCM_SliceLocationVector, count);
  const auto between = numberOf(dataset, DCM_SpacingBetweenSlices);
  const bool inTime = pointsTo(dataset, "0018,1063") || pointsTo(dataset, "0018,1065");
  if (!between || *between == 0.0 || inTime) return {};
  std::vector<double> offsets;
  if (file.sopClass == UID_NuclearMedicineImageStorage) {
    // Projections follow in angle, not along the normal.
    const bool slices =
        pointsTo(dataset, "0054,0080") || codeOf(dataset, DCM_ImageType).find("RECON") != std::string::npos;
    if (!slices) return {};
    for (std::size_t i = 0; i < count; ++i)
      offsets.push_back(*between * (numberOf(dataset, DCM_SliceVector, i).value_or(static_cast<double>(i + 1)) - 1.0));
    return offsets;
  }
  for (DicomFrame& frame : file.frames) frame.assumed |= assumed::followingFrames;
  for (std::size_t i = 0; i < count; ++i) offsets.push_back(std::abs(*between) * static_cast<double>(i));
  return offsets;
}

}  // namespace

void readGeometry(const Scopes& scopes, DicomFrame& frame) {
  DcmItem* measures = scopes.group(DCM_PixelMeasuresSequence);
  if (!measures) measures = &scopes.dataset;
  readSpacing(*measures, scopes.dataset, frame);
  frame.thickness = std::max(0.0, numberOf(*measures, DCM_SliceThickness).value_or(0.0));
  frame.step = std::abs(numberOf(*measures, DCM_SpacingBetweenSlices).value_or(0.0));
  for (const PlaceSource& source : placeSources()) {
    DcmItem* place = itemIn(scopes, source, source.positionSequence);
    DcmItem* plane = itemIn(scopes, source, source.orientationSequence);
    if (!plane || !readAxes(*plane, source.orientation, frame.axes)) continue;
    frame.hasAxes = true;
    const auto position = place ? numbersOf<3>(*place, source.position) : std::nullopt;
    if (!position) continue;
    frame.hasGeometry = true;
    frame.position = *position;
    frame.ownPlace = source.grouped;
    frame.assumed |= source.bit;
    return;
  }
  for (const DcmTagKey& tag : {DCM_SliceLocation, DCM_RETIRED_Location})
    if (!frame.location) frame.location = numberOf(scopes.dataset, tag);
}

void placeFrames(DcmItem& dataset, DicomFile& file) {
  if (file.sopClass == UID_RTDoseStorage) scaleDoses(dataset, file);
  const bool placed = std::all_of(file.frames.begin(), file.frames.end(),
                                  [](const DicomFrame& frame) { return frame.ownPlace || !frame.hasGeometry; });
  if (file.frames.size() < 2 || placed) return;
  const std::vector<double> offsets = frameOffsets(dataset, file);
  for (std::size_t i = 0; i < file.frames.size(); ++i) {
    DicomFrame& frame = file.frames[i];
    if (frame.ownPlace) continue;
    frame.hasGeometry = frame.hasGeometry && !offsets.empty();
    if (frame.hasGeometry) frame.position += normalOf(frame) * offsets[i];
  }
}

}  // namespace fenestra::io
