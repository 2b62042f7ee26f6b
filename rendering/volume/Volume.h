#pragma once
// A scalar volume: stored voxels, the linear map to real values, and where they lie in the patient.

#include <string>
#include <vector>

#include "rendering/volume/Grid.h"
#include "rendering/volume/Voxels.h"

namespace fenestra {

/// A closed interval of real values (HU for CT).
struct ValueRange {
  double low = 0.0;
  double high = 0.0;
  bool operator==(const ValueRange&) const = default;
};

inline constexpr double airValue = -1000.0;  ///< HU

/// Display window: values from level - width/2 (black) to level + width/2 (white).
struct WindowLevel {
  double width = 1.0;
  double level = 0.5;
  bool operator==(const WindowLevel&) const = default;
};

/// PT: emission, of PET or SPECT. US: ultrasound.
enum class Modality : std::uint8_t { Unknown, CT, MR, PT, US };

/// Trilinear between valueAt(voxel), at a continuous index position clamped to the edge.
template <class ValueAt>
double interpolated(const Grid& grid, glm::dvec3 index, const ValueAt& valueAt) {
  const glm::dvec3 clamped = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(grid.dims - 1));
  const glm::ivec3 base = glm::min(glm::ivec3(glm::floor(clamped)), glm::max(grid.dims - 2, 0));
  const glm::dvec3 f = clamped - glm::dvec3(base);
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const double weight = (step.x ? f.x : 1.0 - f.x) * (step.y ? f.y : 1.0 - f.y) * (step.z ? f.z : 1.0 - f.z);
    if (weight != 0.0) sum += weight * valueAt(glm::min(base + step, grid.dims - 1));
  }
  return sum;
}

/// Immutable once built and shared by std::shared_ptr<const Volume>; its address is its identity.
struct Volume {
  Grid grid;
  Voxels voxels;       ///< x fastest, grid.voxelCount() scalars
  double slope = 1.0;  ///< real value = slope · stored + intercept
  double intercept = 0.0;
  ValueRange range;  ///< least and greatest finite real value; {0,0} when there is none
  Modality modality = Modality::Unknown;
  std::string unit;                  ///< "HU", or empty
  bool lowIsWhite = false;           ///< meant to be displayed with low values bright (DICOM MONOCHROME1)
  std::vector<WindowLevel> windows;  ///< the file's own display windows (DICOM VOI), first is the default

  /// Real value of one voxel; NaN and Inf come out as stored.
  double value(glm::ivec3 index) const;
  /// Real value at a continuous index position: trilinear, clamped to the edge.
  double sample(glm::dvec3 index) const;
  /// Fills `range` from the voxels (all cores). Readers call it once.
  void computeRange();
  /// Whether values are Hounsfield units: the file says so and some lie below zero, or their range is one that only CT
  /// has (air is -1000 HU, fat -100, bone above 150). A CT rescaled to 0..1 or offset by 1024 is not in HU.
  bool isInHounsfieldUnits() const;
  /// A sensible first display window: the file's own, soft tissue for CT in HU, or one that spans the
  /// data's 1st to 99th percentile.
  WindowLevel defaultWindow() const;
};

/// Whether the values of a volume without a modality are Hounsfield units beyond reasonable doubt: as
/// isInHounsfieldUnits(), and the voxels are spread as in a patient: air, soft tissue, and next to nothing below air
/// but padding. Fields of signed values (phase, displacement) are not.
bool looksLikeCt(const Volume& volume);

}  // namespace fenestra
