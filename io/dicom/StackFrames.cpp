#include "io/dicom/StackFrames.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "io/dicom/ImageParts.h"
#include "io/dicom/Repeats.h"
#include "io/dicom/SliceLayout.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

constexpr double outlierGaps = 10.0;

glm::dvec3 normalOf(const DicomFrame& frame) { return glm::normalize(glm::cross(frame.axes[0], frame.axes[1])); }
double alongNormal(const DicomFrame& frame, const glm::dvec3& normal) { return glm::dot(frame.position, normal); }

bool sameAxes(const DicomFrame& a, const DicomFrame& b) {
  // A thousandth of a radian: rounded direction cosines of one stack differ by less.
  return glm::distance(a.axes[0], b.axes[0]) < 1e-3 && glm::distance(a.axes[1], b.axes[1]) < 1e-3;
}

bool sameSpacing(const DicomFrame& a, const DicomFrame& b) {
  return glm::all(glm::lessThan(glm::abs(a.spacing - b.spacing), 1e-3 * a.spacing));
}

/// The attribute of Parting::Always in which two frames differ; empty where they differ in none.
std::optional<std::size_t> partingOf(const DicomFrame& a, const DicomFrame& b) {
  const std::vector<PartingAttribute>& attributes = partingAttributes();
  for (std::size_t i = 0; i < std::min(a.parts.size(), b.parts.size()); ++i)
    if (attributes[i].parting == Parting::Always && a.parts[i] != b.parts[i]) return i;
  return std::nullopt;
}

/// Same grid, as far as single frames tell.
bool lieAlike(const DicomFrame& a, const DicomFrame& b) {
  return a.size == b.size && a.hasGeometry == b.hasGeometry && sameSpacing(a, b) &&
         (!a.hasGeometry || sameAxes(a, b)) && a.frameOfReference == b.frameOfReference && a.frameType == b.frameType &&
         a.stack == b.stack;
}

bool belongTogether(const DicomFrame& a, const DicomFrame& b) { return lieAlike(a, b) && !partingOf(a, b); }

/// Joined by commas, in their order.
std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

class Stacker {
 public:
  explicit Stacker(const std::vector<DicomFile>& files) : files_(files) {}

  std::vector<DicomStack> stack(std::vector<DicomFrame> frames) {
    dropReferencesOfSingleSlices(frames);
    dropPartsOfSingleSlices(frames);
    std::vector<std::vector<DicomFrame>> groups;
    for (const DicomFrame& frame : frames) {
      const auto group = std::find_if(groups.begin(), groups.end(),
                                      [&](const auto& members) { return belongTogether(members.front(), frame); });
      if (group != groups.end())
        group->push_back(frame);
      else
        groups.push_back({frame});
    }
    for (auto& group : groups) {
      ++group_;
      if (group.front().hasGeometry)
        placeGroup(std::move(group));
      else
        stackWithoutGeometry(std::move(group));
    }
    std::stable_sort(stacks_.begin(), stacks_.end(), [](const DicomStack& a, const DicomStack& b) {
      return a.grid.voxelCount() > b.grid.voxelCount();
    });
    labelParts();
    warnOfMixture();
    warnOfReferences();
    return std::move(stacks_);
  }

 private:
  std::vector<fs::path> pathsOf(const std::vector<DicomFrame>& frames) const { return io::pathsOf(frames, files_); }

  /// A frame of reference is the coordinate system that the slices of a scan share. Some anonymisers give every slice
  /// one of its own: where more than half hold a single slice, they are dropped, and positions are taken to be in one
  /// system.
  void dropReferencesOfSingleSlices(std::vector<DicomFrame>& frames) {
    const auto grouped = [](const DicomFrame& frame) { return frame.hasGeometry && !frame.frameOfReference.empty(); };
    std::map<std::string, std::size_t> slices;
    for (const DicomFrame& frame : frames)
      if (grouped(frame)) ++slices[frame.frameOfReference];
    const auto single = static_cast<std::size_t>(
        std::count_if(slices.begin(), slices.end(), [](const auto& reference) { return reference.second == 1; }));
    if (slices.size() < 2 || 2 * single <= slices.size()) return;
    for (DicomFrame& frame : frames)
      if (grouped(frame)) frame.frameOfReference.clear();
    droppedReferences_ = slices.size();
  }

  /// An attribute whose values differ from slice to slice of one place each says nothing about volumes: it varies
  /// within one, as flip angles may. Values are dropped where more than half of them stand for a single slice, and no
  /// place repeats.
  static void dropPartsOfSingleSlices(std::vector<DicomFrame>& frames) {
    std::set<std::tuple<double, double, double>> places;
    for (const DicomFrame& frame : frames)
      if (!frame.hasGeometry || !places.insert({frame.position.x, frame.position.y, frame.position.z}).second) return;
    for (std::size_t i = 0; i < partingAttributes().size(); ++i) {
      std::map<std::string, std::size_t> slices;
      for (const DicomFrame& frame : frames)
        if (i < frame.parts.size()) ++slices[frame.parts[i]];
      const auto single = static_cast<std::size_t>(
          std::count_if(slices.begin(), slices.end(), [](const auto& value) { return value.second == 1; }));
      if (slices.size() < 3 || 2 * single <= slices.size()) continue;
      for (DicomFrame& frame : frames)
        if (i < frame.parts.size()) frame.parts[i].clear();
    }
  }

  /// Names each volume after the attributes that tell it from the others.
  void labelParts() {
    for (std::size_t i = 0; i < partingAttributes().size(); ++i) {
      if (partingAttributes()[i].parting != Parting::Always) continue;
      std::set<std::string> values;
      for (const DicomStack& stack : stacks_)
        if (i < stack.frames.front().parts.size()) values.insert(stack.frames.front().parts[i]);
      if (values.size() < 2) continue;
      for (DicomStack& stack : stacks_)
        if (i < stack.frames.front().parts.size())
          stack.part += (stack.part.empty() ? "" : ", ") + partText(i, stack.frames.front().parts[i]);
    }
  }

  void warnOfReferences() {
    if (droppedReferences_ == 0) return;
    for (DicomStack& stack : stacks_)
      if (stack.frames.size() > 1)
        stack.warnings.push_back({Warning::Kind::Other,
                                  "the series names " + std::to_string(droppedReferences_) +
                                      " frames of reference, most for a single slice; its slices are taken to lie in "
                                      "one coordinate system",
                                  {}});
  }

  /// Splits a group into volumes with one frame at each position and no far gaps.
  void placeGroup(std::vector<DicomFrame> group) {
    const glm::dvec3 normal = normalOf(group.front());
    const std::vector<fs::path> paths = pathsOf(group);
    const PartedFrames parted = partRepeats(std::move(group), normal);
    const std::size_t times = parted.volumes.size();
    const std::string incomplete = incompleteOf(parted);
    for (std::size_t time = 0; time < times; ++time) {
      const std::size_t before = stacks_.size();
      splitAtFarGaps(parted.volumes[time], normal);
      std::vector<Warning>& warnings = stacks_.back().warnings;
      if (times > 1 && parted.interleaved)
        warnings.push_back({Warning::Kind::Other,
                            std::to_string(times) + " interleaved volumes, told apart by " + parted.by +
                                "; each is evenly spaced and stands for itself",
                            paths});
      if (times < 2 || parted.interleaved) continue;
      for (std::size_t i = before; i < stacks_.size(); ++i) {
        stacks_[i].time = static_cast<int>(time) + 1;
        stacks_[i].times = static_cast<int>(times);
      }
      warnings.push_back({Warning::Kind::TimePoints, timesText(parted, time + 1), paths, WayOut::ChooseTime});
      if (!incomplete.empty()) warnings.push_back({Warning::Kind::MissingSlices, incomplete, {}});
    }
    if (!parted.dropped.empty())
      stacks_.back().warnings.push_back(
          {Warning::Kind::DuplicateSlices,
           counted(parted.dropped.size(), "slice") + " left out, at positions that other slices have already",
           pathsOf(parted.dropped)});
  }

  static std::string timesText(const PartedFrames& parted, std::size_t shown) {
    const std::string times = std::to_string(parted.volumes.size());
    return (parted.places == 1 ? "all " + times + " frames lie at one position"
                               : times + " frames lie at each position") +
           " (time points or repeats, no deeper volume" + (parted.by.empty() ? "" : "; told apart by " + parted.by) +
           "); each forms a volume of its own: number " + std::to_string(shown) + " is shown";
  }

  /// How many slices a whole volume has that is like volume `i`. Thicker slices are fewer, at places of their own.
  static std::size_t wholeLike(std::size_t i, const PartedFrames& parted) {
    const auto thickness = [&](const std::vector<DicomFrame>& volume) { return volume.front().thickness; };
    std::size_t most = 0, alike = 0;
    for (const std::vector<DicomFrame>& volume : parted.volumes) {
      if (thickness(volume) != thickness(parted.volumes[i])) continue;
      most = std::max(most, volume.size());
      ++alike;
    }
    return alike == parted.volumes.size() ? parted.places : most;
  }

  /// Which time points lack slices; empty where none does.
  static std::string incompleteOf(const PartedFrames& parted) {
    if (parted.interleaved) return {};
    std::vector<std::string> lacking;
    for (std::size_t i = 0; i < parted.volumes.size(); ++i)
      if (const std::size_t slices = parted.volumes[i].size(), whole = wholeLike(i, parted); slices < whole)
        lacking.push_back("number " + std::to_string(i + 1) + " has " + std::to_string(slices) + " of " +
                          std::to_string(whole) + " slices");
    if (lacking.empty() || parted.volumes.size() < 2) return {};
    const std::size_t count = lacking.size();
    constexpr std::size_t mostNamed = 3;
    lacking.resize(std::min(count, mostNamed));
    return std::to_string(count) + " of " + std::to_string(parted.volumes.size()) +
           (count == 1 ? " volumes lacks slices: " : " volumes lack slices: ") + joined(lacking) +
           (count > mostNamed ? ", …" : "");
  }

  /// The longest piece is added last, so that the warnings about the group become its own.
  void splitAtFarGaps(std::vector<DicomFrame> volume, const glm::dvec3& normal) {
    std::vector<double> gaps;
    for (std::size_t i = 1; i < volume.size(); ++i)
      gaps.push_back(alongNormal(volume[i], normal) - alongNormal(volume[i - 1], normal));
    std::vector<std::vector<DicomFrame>> pieces(1);
    const double usual = gaps.size() < 2 ? 0.0 : median(gaps);
    for (std::size_t i = 0; i < volume.size(); ++i) {
      if (i > 0 && gaps.size() >= 2 && gaps[i - 1] > outlierGaps * usual) pieces.emplace_back();
      pieces.back().push_back(volume[i]);
    }
    std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    std::vector<DicomFrame> others;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (i + 1 < pieces.size()) others.insert(others.end(), pieces[i].begin(), pieces[i].end());
      addStack(pieces[i], normal);
    }
    if (!others.empty())
      stacks_.back().warnings.push_back(
          {Warning::Kind::MissingSlices,
           counted(others.size(), "slice") +
               " put into volumes of their own, further from the others than ten times the "
               "usual distance of " +
               millimetres(usual),
           pathsOf(others)});
  }

  void addStack(const std::vector<DicomFrame>& frames, const glm::dvec3& normal) {
    DicomStack stack;
    stack.group = group_;
    stack.frames = frames;
    const DicomFrame& first = frames.front();
    const int count = static_cast<int>(frames.size());
    const double thickness = first.thickness > 0.0 ? first.thickness : first.step > 0.0 ? first.step : 1.0;
    const glm::dvec3 step =
        count > 1 ? (frames.back().position - first.position) / static_cast<double>(count - 1) : normal * thickness;
    stack.grid.dims = {first.size.x, first.size.y, count};
    stack.grid.origin = first.position;
    stack.grid.spacing = {first.spacing.x, first.spacing.y, glm::length(step)};
    stack.grid.direction = {first.axes[0], first.axes[1], glm::normalize(step)};
    stacks_.push_back(std::move(stack));
  }

  /// In the order of their Slice Locations where each has one of its own, else in stored order.
  void stackWithoutGeometry(std::vector<DicomFrame> frames) {
    const bool located = byLocation(frames);
    if (!located)
      std::sort(frames.begin(), frames.end(), [](const DicomFrame& a, const DicomFrame& b) {
        return std::tie(a.instance, a.file, a.number) < std::tie(b.instance, b.file, b.number);
      });
    DicomStack stack;
    stack.group = group_;
    const DicomFrame& first = frames.front();
    const double declared = first.step > 0.0 ? first.step : first.thickness;
    double step = declared > 0.0 ? declared : 1.0;
    if (located) {
      step = (*frames.back().location - *first.location) / static_cast<double>(frames.size() - 1);
      if (first.hasAxes) stack.grid.direction = {first.axes[0], first.axes[1], normalOf(first)};
    }
    stack.grid.dims = {first.size.x, first.size.y, static_cast<int>(frames.size())};
    stack.grid.spacing = {first.spacing.x, first.spacing.y, step};
    const char* source = first.step > 0.0        ? "their Spacing Between Slices"
                         : first.thickness > 0.0 ? "their Slice Thickness"
                                                 : "none is given";
    std::string text = "the file does not say where the slice lies in the patient";
    if (located)
      text =
          "the file does not say where its slices lie in the patient; their Slice Location gives their order and a "
          "distance of " +
          millimetres(step) + ", the place is a guess";
    else if (frames.size() > 1)
      text =
          "the file does not say where its slices lie in the patient; they are shown in their stored order, at a "
          "distance that is a guess (" +
          millimetres(step) + ", " + source + ")";
    stack.warnings.push_back({Warning::Kind::NoGeometry, std::move(text), pathsOf(frames)});
    stack.frames = std::move(frames);
    stacks_.push_back(std::move(stack));
  }

  /// Sorts frames by Slice Location; false where two share one, or one has none.
  static bool byLocation(std::vector<DicomFrame>& frames) {
    if (frames.size() < 2 ||
        !std::all_of(frames.begin(), frames.end(), [](const DicomFrame& frame) { return frame.location.has_value(); }))
      return false;
    std::vector<DicomFrame> sorted = frames;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const DicomFrame& a, const DicomFrame& b) { return *a.location < *b.location; });
    for (std::size_t i = 1; i < sorted.size(); ++i)
      if (*sorted[i].location - *sorted[i - 1].location <= positionTolerance) return false;
    frames = std::move(sorted);
    return true;
  }

  void warnOfMixture() {
    if (stacks_.size() < 2) return;
    DicomStack& main = stacks_.front();
    const DicomFrame& chosen = main.frames.front();
    std::vector<DicomFrame> sizes, orientations, others;
    std::map<std::size_t, std::vector<DicomFrame>> parts;  // by the attribute that parts them
    for (std::size_t i = 1; i < stacks_.size(); ++i) {
      const DicomFrame& frame = stacks_[i].frames.front();
      if (belongTogether(chosen, frame)) continue;  // time points and outliers have warnings of their own
      if (lieAlike(chosen, frame)) {
        std::vector<DicomFrame>& list = parts[*partingOf(chosen, frame)];
        list.insert(list.end(), stacks_[i].frames.begin(), stacks_[i].frames.end());
        continue;
      }
      const bool turned = frame.hasGeometry && chosen.hasGeometry && !sameAxes(chosen, frame);
      auto& list = frame.size != chosen.size || !sameSpacing(chosen, frame) ? sizes : turned ? orientations : others;
      list.insert(list.end(), stacks_[i].frames.begin(), stacks_[i].frames.end());
    }
    const auto warn = [&](Warning::Kind kind, const std::vector<DicomFrame>& frames, const std::string& how) {
      if (!frames.empty())
        main.warnings.push_back(
            {kind, counted(frames.size(), "slice") + " of the series put into volumes of their own: " + how,
             pathsOf(frames)});
    };
    warn(Warning::Kind::MixedSizes, sizes, "another size or pixel spacing");
    warn(Warning::Kind::MixedOrientations, orientations, "another orientation");
    warn(Warning::Kind::Other, others, "another frame of reference, frame type or stack");
    for (const auto& [attribute, frames] : parts) {
      std::set<std::string> values;
      for (const DicomFrame& frame : frames) values.insert(partText(attribute, frame.parts[attribute]));
      warn(Warning::Kind::Other, frames,
           joined({values.begin(), values.end()}) + "; this volume: " + partText(attribute, chosen.parts[attribute]));
    }
  }

  const std::vector<DicomFile>& files_;
  std::vector<DicomStack> stacks_;
  int group_ = 0;                      ///< of slices that belong together, from 1
  std::size_t droppedReferences_ = 0;  ///< frames of reference that were ignored
};

}  // namespace

std::vector<DicomStack> stackFrames(const std::vector<DicomFrame>& frames, const std::vector<DicomFile>& files) {
  return Stacker(files).stack(frames);
}

}  // namespace fenestra::io
