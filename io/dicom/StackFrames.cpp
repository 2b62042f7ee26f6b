#include "io/dicom/StackFrames.h"

#include <algorithm>
#include <map>
#include <tuple>

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

bool belongTogether(const DicomFrame& a, const DicomFrame& b) {
  return a.size == b.size && a.hasGeometry == b.hasGeometry && sameSpacing(a, b) &&
         (!a.hasGeometry || sameAxes(a, b)) && a.frameOfReference == b.frameOfReference && a.frameType == b.frameType &&
         a.stack == b.stack;
}

/// Among frames at one position: by time, then as acquired, then as stored.
bool earlier(const DicomFrame& a, const DicomFrame& b) {
  return std::tie(a.temporal, a.acquisition, a.instance, a.file, a.number) <
         std::tie(b.temporal, b.acquisition, b.instance, b.file, b.number);
}

class Stacker {
 public:
  explicit Stacker(const std::vector<DicomFile>& files) : files_(files) {}

  std::vector<DicomStack> stack(std::vector<DicomFrame> frames) {
    dropReferencesOfSingleSlices(frames);
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
    std::sort(group.begin(), group.end(), [&](const DicomFrame& a, const DicomFrame& b) {
      const double along = alongNormal(a, normal), alongB = alongNormal(b, normal);
      return along != alongB ? along < alongB : earlier(a, b);
    });
    std::vector<std::vector<DicomFrame>> places;
    for (const DicomFrame& frame : group) {
      if (places.empty() || alongNormal(frame, normal) - alongNormal(places.back().front(), normal) > positionTolerance)
        places.emplace_back();
      places.back().push_back(frame);
    }
    for (auto& place : places) std::sort(place.begin(), place.end(), earlier);

    const std::size_t times = places.front().size();
    const bool everywhere =
        std::all_of(places.begin(), places.end(), [&](const auto& place) { return place.size() == times; });
    if (times > 1 && everywhere) {
      for (std::size_t time = 0; time < times; ++time) {
        std::vector<DicomFrame> volume;
        for (const auto& place : places) volume.push_back(place[time]);
        const std::size_t before = stacks_.size();
        splitAtFarGaps(std::move(volume), normal);
        for (std::size_t i = before; i < stacks_.size(); ++i) {
          stacks_[i].time = static_cast<int>(time) + 1;
          stacks_[i].times = static_cast<int>(times);
        }
        stacks_.back().warnings.push_back(
            {Warning::Kind::TimePoints,
             (places.size() == 1 ? "all " + std::to_string(times) + " frames lie at one position"
                                 : std::to_string(times) + " frames lie at each position") +
                 " (time points or repeats, no deeper volume); each forms a volume of its own: number " +
                 std::to_string(time + 1) + " is shown, --time N chooses another",
             pathsOf(group)});
      }
      return;
    }
    std::vector<DicomFrame> volume, dropped;
    for (const auto& place : places) {
      volume.push_back(place.front());
      dropped.insert(dropped.end(), place.begin() + 1, place.end());
    }
    splitAtFarGaps(std::move(volume), normal);
    if (!dropped.empty())
      stacks_.back().warnings.push_back(
          {Warning::Kind::DuplicateSlices,
           counted(dropped.size(), "slice") + " left out, at positions that other slices have already",
           pathsOf(dropped)});
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
    const double thickness = first.thickness > 0.0 ? first.thickness : 1.0;
    const glm::dvec3 step =
        count > 1 ? (frames.back().position - first.position) / static_cast<double>(count - 1) : normal * thickness;
    stack.grid.dims = {first.size.x, first.size.y, count};
    stack.grid.origin = first.position;
    stack.grid.spacing = {first.spacing.x, first.spacing.y, glm::length(step)};
    stack.grid.direction = {first.axes[0], first.axes[1], glm::normalize(step)};
    stacks_.push_back(std::move(stack));
  }

  void stackWithoutGeometry(std::vector<DicomFrame> frames) {
    std::sort(frames.begin(), frames.end(), [](const DicomFrame& a, const DicomFrame& b) {
      return std::tie(a.instance, a.file, a.number) < std::tie(b.instance, b.file, b.number);
    });
    DicomStack stack;
    stack.group = group_;
    const DicomFrame& first = frames.front();
    stack.grid.dims = {first.size.x, first.size.y, static_cast<int>(frames.size())};
    stack.grid.spacing = {first.spacing.x, first.spacing.y, first.thickness > 0.0 ? first.thickness : 1.0};
    stack.warnings.push_back({Warning::Kind::NoGeometry,
                              frames.size() > 1
                                  ? "the file does not say where its slices lie in the patient; they are shown in "
                                    "their stored order, at a distance that is a guess"
                                  : "the file does not say where the slice lies in the patient",
                              pathsOf(frames)});
    stack.frames = std::move(frames);
    stacks_.push_back(std::move(stack));
  }

  void warnOfMixture() {
    if (stacks_.size() < 2) return;
    DicomStack& main = stacks_.front();
    const DicomFrame& chosen = main.frames.front();
    std::vector<DicomFrame> sizes, orientations, others;
    for (std::size_t i = 1; i < stacks_.size(); ++i) {
      const DicomFrame& frame = stacks_[i].frames.front();
      if (belongTogether(chosen, frame)) continue;  // time points and outliers have warnings of their own
      const bool turned = frame.hasGeometry && chosen.hasGeometry && !sameAxes(chosen, frame);
      auto& list = frame.size != chosen.size || !sameSpacing(chosen, frame) ? sizes : turned ? orientations : others;
      list.insert(list.end(), stacks_[i].frames.begin(), stacks_[i].frames.end());
    }
    const auto warn = [&](Warning::Kind kind, const std::vector<DicomFrame>& frames, const char* how) {
      if (!frames.empty())
        main.warnings.push_back(
            {kind, counted(frames.size(), "slice") + " of the series put into volumes of their own: " + how,
             pathsOf(frames)});
    };
    warn(Warning::Kind::MixedSizes, sizes, "another size or pixel spacing");
    warn(Warning::Kind::MixedOrientations, orientations, "another orientation");
    warn(Warning::Kind::Other, others, "another frame of reference, frame type or stack");
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
