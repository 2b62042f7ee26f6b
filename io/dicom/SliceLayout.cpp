#include "io/dicom/SliceLayout.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <set>

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Slices missing where every gap is a multiple of `unit`, to a twentieth of it; empty where some gap is not, or where
/// more would be missing than half of what is there.
std::optional<std::size_t> missingAt(const std::vector<double>& gaps, double unit) {
  std::size_t missing = 0;
  for (const double gap : gaps) {
    const double times = std::round(gap / unit);
    if (times < 1.0 || std::abs(gap - times * unit) >= 0.05 * unit) return std::nullopt;
    missing += static_cast<std::size_t>(times) - 1;
  }
  if (2 * missing > gaps.size() + 1) return std::nullopt;
  return missing;
}

double ownStepOf(const std::vector<double>& gaps, std::size_t& missing) {
  const double usual = median(gaps), least = *std::min_element(gaps.begin(), gaps.end());
  for (const double unit : {usual, least})
    if (const auto count = missingAt(gaps, unit); count && *count > 0) {
      missing = *count;
      return unit;
    }
  std::vector<double> sorted = gaps;
  std::sort(sorted.begin(), sorted.end());
  // Where a part of the series is much denser than the rest (below three quarters), its detail is kept.
  const double dense = sorted[std::min((sorted.size() + 9) / 10, sorted.size() - 1)];
  return dense < 0.75 * usual ? dense : usual;
}

glm::dvec3 cornerOf(const DicomFrame& frame, const DicomFrame& like, int corner) {
  const double x = (corner & 1) ? frame.size.x - 1 : 0, y = (corner & 2) ? frame.size.y - 1 : 0;
  return frame.position + like.axes[0] * (like.spacing.x * x) + like.axes[1] * (like.spacing.y * y);
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

/// Slices shifted sideways from the line between the first and the last one, mm each.
std::vector<double> sidewaysOf(const SliceLayout& layout, glm::dvec2 spacing) {
  std::vector<double> shifts;
  const glm::dvec3 whole = layout.offsets.back();
  for (const glm::dvec3& offset : layout.offsets)
    shifts.push_back(glm::length((glm::dvec2(offset) - glm::dvec2(whole) * (offset.z / whole.z)) * spacing));
  return shifts;
}

void addTilt(const DicomStack& stack, const SliceLayout& layout, std::vector<Warning>& findings) {
  const glm::dvec3 across = stack.frames.back().position - stack.frames.front().position;
  const double along = layout.offsets.back().z, sideways = glm::length(across - along * layout.normal);
  if (sideways <= positionTolerance) return;
  findings.push_back({Warning::Kind::GantryTilt,
                      "the slices are tilted by " + text(degrees(std::atan2(sideways, along))) +
                          " degrees against the direction they are stacked in (" +
                          millimetres(sideways / static_cast<double>(layout.offsets.size() - 1)) +
                          " sideways from slice to slice)",
                      {}});
}

void addGaps(const DicomStack& stack, const SliceLayout& layout, const std::vector<DicomFile>& files,
             std::vector<Warning>& findings) {
  const std::vector<double> gaps = gapsOf(layout);
  double uneven = 0.0;
  for (std::size_t i = 0; i < layout.offsets.size(); ++i)
    uneven = std::max(uneven, std::abs(layout.offsets[i].z - layout.offsets.back().z * static_cast<double>(i) /
                                                                 static_cast<double>(gaps.size())));
  if (uneven <= positionTolerance) return;
  const auto [least, greatest] = std::minmax_element(gaps.begin(), gaps.end());
  std::vector<DicomFrame> beside;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const bool odd =
        layout.missing > 0 ? gaps[i] > 1.5 * layout.ownStep : std::abs(gaps[i] - layout.ownStep) > positionTolerance;
    if (odd) beside.insert(beside.end(), {stack.frames[i], stack.frames[i + 1]});
  }
  if (layout.missing > 0)
    findings.push_back({Warning::Kind::MissingSlices,
                        counted(layout.missing, "slice") + " missing: neighbours lie " + millimetres(layout.ownStep) +
                            " apart, but up to " + millimetres(*greatest) + " between the files named",
                        pathsOf(beside, files)});
  else
    findings.push_back({Warning::Kind::UnevenSpacing,
                        "the slices lie between " + millimetres(*least) + " and " + millimetres(*greatest) + " apart",
                        pathsOf(beside, files)});
}

void addShifts(const DicomStack& stack, const SliceLayout& layout, const std::vector<DicomFile>& files,
               std::vector<Warning>& findings) {
  const std::vector<double> shifts = sidewaysOf(layout, stack.frames.front().spacing);
  std::vector<DicomFrame> shifted;
  for (std::size_t i = 0; i < shifts.size(); ++i)
    if (shifts[i] > positionTolerance) shifted.push_back(stack.frames[i]);
  if (shifted.empty()) return;
  findings.push_back({Warning::Kind::UnevenSpacing,
                      counted(shifted.size(), "slice") + " shifted sideways by up to " +
                          millimetres(*std::max_element(shifts.begin(), shifts.end())) +
                          " from the line that the first and the last one lie on",
                      pathsOf(shifted, files)});
}

void addTurns(const DicomStack& stack, const SliceLayout& layout, const std::vector<DicomFile>& files,
              std::vector<Warning>& findings) {
  if (layout.turned <= positionTolerance) return;
  std::vector<DicomFrame> turned;
  for (const DicomFrame& frame : stack.frames)
    for (int corner = 0; corner < 4; ++corner)
      if (glm::distance(cornerOf(frame, frame, corner), cornerOf(frame, stack.frames.front(), corner)) >
          positionTolerance) {
        turned.push_back(frame);
        break;
      }
  findings.push_back({Warning::Kind::Other,
                      counted(turned.size(), "slice") +
                          " with other directions or pixel spacing than the first; shown with those of the first, " +
                          "pixels lie up to " + millimetres(layout.turned) + " from their places",
                      pathsOf(turned, files)});
}

}  // namespace

std::string millimetres(double value) { return text(value) + " mm"; }

std::string counted(std::size_t count, const char* noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::vector<fs::path> pathsOf(const std::vector<DicomFrame>& frames, const std::vector<DicomFile>& files) {
  std::vector<fs::path> paths;
  std::set<std::size_t> listed;
  for (const DicomFrame& frame : frames)
    if (listed.insert(frame.file).second) paths.push_back(files[frame.file].path);
  return paths;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> gapsOf(const SliceLayout& layout) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < layout.offsets.size(); ++i) gaps.push_back(layout.offsets[i].z - layout.offsets[i - 1].z);
  return gaps;
}

SliceLayout layoutOf(const DicomStack& stack) {
  const DicomFrame& first = stack.frames.front();
  SliceLayout layout;
  layout.normal = glm::normalize(glm::cross(first.axes[0], first.axes[1]));
  const glm::dmat3 offsetFromWorld =
      glm::inverse(glm::dmat3(first.axes[0] * first.spacing.x, first.axes[1] * first.spacing.y, layout.normal));
  const glm::dvec3 step = stack.grid.direction[2] * stack.grid.spacing.z;
  for (std::size_t i = 0; i < stack.frames.size(); ++i) {
    const DicomFrame& frame = stack.frames[i];
    layout.offsets.push_back(offsetFromWorld * (frame.position - first.position));
    layout.displacement =
        std::max(layout.displacement, glm::distance(frame.position, first.position + static_cast<double>(i) * step));
    for (int corner = 0; corner < 4; ++corner)
      layout.turned =
          std::max(layout.turned, glm::distance(cornerOf(frame, frame, corner), cornerOf(frame, first, corner)));
  }
  layout.ownStep = ownStepOf(gapsOf(layout), layout.missing);
  return layout;
}

std::vector<Warning> findingsOf(const DicomStack& stack, const SliceLayout& layout,
                                const std::vector<DicomFile>& files) {
  std::vector<Warning> findings;
  addTilt(stack, layout, findings);
  addGaps(stack, layout, files, findings);
  addShifts(stack, layout, files, findings);
  addTurns(stack, layout, files, findings);
  return findings;
}

}  // namespace fenestra::io
