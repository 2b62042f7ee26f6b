#include "io/dicom/PlaceSlices.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/base/Memory.h"
#include "io/dicom/Regular.h"

namespace fenestra::io {
namespace {

/// A regular grid may hold this many times the voxels that were scanned: unevenly dense slices take up to four times as
/// many planes, and a strong tilt widens them.
constexpr std::size_t mostGrowth = 8;

std::string percent(std::size_t part, std::size_t whole) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
  return text;
}

/// "HU" after the number, where that is known.
std::string valueText(double value, const std::string& unit) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return unit.empty() ? text : std::string(text) + " " + unit;
}

/// Says where the slices are shown; the report's figures are complete.
Warning placementOf(const GeometryReport& report, const Volume& volume) {
  std::string text;
  if (report.applied == Regularise::Off) {
    text = report.displacement <= positionTolerance
               ? "the volume is sheared, so that every slice lies where it was scanned"
               : "all slices are shown " + millimetres(report.step) + " apart, up to " +
                     millimetres(report.displacement) + " from where they were scanned";
    return {Warning::Kind::SlicePlacement, std::move(text), {}};
  }
  text = std::string(report.applied == Regularise::Cubic ? "cubic" : "linear") +
         " interpolation places the slices on " + std::to_string(report.planes) + " planes " +
         millimetres(report.step) + " apart" + (report.sheared ? ", sheared as they were scanned" : "");
  text += report.displacement <= positionTolerance ? ", with nothing displaced"
                                                   : ", displaced by up to " + millimetres(report.displacement);
  if (report.displacementAsIs > positionTolerance)
    text += " (evenly spread they would lie up to " + millimetres(report.displacementAsIs) + " from their places)";
  if (const std::size_t planes = report.interpolatedPlanes.size())
    text += "; " + counted(planes, "plane") + " in gaps wider than " + millimetres(1.5 * report.scannedStep) +
            (planes == 1 ? " is" : " are") + " interpolated across the gap";
  if (report.emptyVoxels > 0)
    text += "; " + percent(report.emptyVoxels, volume.grid.voxelCount()) +
            " of the voxels lie outside of what was scanned and hold the least value, " +
            valueText(volume.range.low, volume.unit);
  return {Warning::Kind::SlicePlacement, std::move(text), {}};
}

/// The regular grid to use; empty keeps the stack's.
std::optional<RegularStack> choose(Regularise wanted, const SliceLayout& layout, const DicomStack& stack,
                                   const std::filesystem::path& path) {
  const bool automatic = wanted == Regularise::Automatic;
  if (wanted == Regularise::Off || (automatic && layout.displacement <= positionTolerance)) return std::nullopt;
  RegularStack regular(
      stack, layout, automatic ? RegularStack::Shape::Sheared : RegularStack::Shape::Straight,
      wanted == Regularise::Cubic ? RegularStack::Interpolation::Cubic : RegularStack::Interpolation::Linear);
  const std::size_t scanned = stack.grid.voxelCount();
  if (regular.grid().voxelCount() / mostGrowth <= scanned) return regular;
  if (automatic) return std::nullopt;
  throw Error(path,
              "its slices would fill only " + percent(scanned, regular.grid().voxelCount()) + " of a regular volume",
              WayOut::KeepSlices);
}

}  // namespace

std::optional<GeometryReport> placeSlices(const DicomStack& stack, const std::vector<DicomFile>& files,
                                          Regularise wanted, const ProgressPart& progress, Volume& volume) {
  volume.grid = stack.grid;
  volume.computeRange();
  if (stack.frames.size() < 2 || !stack.frames.front().hasGeometry) return std::nullopt;
  const SliceLayout layout = layoutOf(stack);
  GeometryReport report;
  report.findings = findingsOf(stack, layout, files);
  if (report.findings.empty()) return std::nullopt;

  const std::filesystem::path& path = files[stack.frames.front().file].path;
  const std::optional<RegularStack> regular = choose(wanted, layout, stack, path);
  if (regular) report.applied = wanted == Regularise::Cubic ? Regularise::Cubic : Regularise::Linear;
  report.slices = stack.grid.dims.z;
  report.scannedStep = layout.ownStep;
  report.displacementAsIs = layout.displacement + layout.turned;
  report.displacement = regular ? layout.turned : report.displacementAsIs;
  if (regular) {
    checkMemory(path, saturatingProduct(regular->grid().voxelCount(), sizeOf(volume.voxels.type())));
    SharedProgress shared(progress, static_cast<std::size_t>(regular->grid().dims.z), "placing slices");
    RegularStack::Result placed = regular->resample(volume.voxels, volume.slope > 0.0, [&] { shared.step(); });
    volume.voxels = std::move(placed.voxels);
    volume.grid = regular->grid();
    volume.computeRange();
    report.interpolatedPlanes = regular->interpolatedPlanes();
    report.emptyVoxels = placed.empty;
  }
  report.planes = volume.grid.dims.z;
  // The shear of the whole stack, as for the tilt.
  const glm::dvec3 axis = volume.grid.direction[2];
  report.sheared =
      glm::length(axis - glm::dot(axis, layout.normal) * layout.normal) * volume.grid.spacing.z * (report.planes - 1) >
      positionTolerance;
  report.step = std::abs(glm::dot(volume.grid.direction[2], layout.normal)) * volume.grid.spacing.z;
  report.findings.push_back(placementOf(report, volume));
  return report;
}

}  // namespace fenestra::io
