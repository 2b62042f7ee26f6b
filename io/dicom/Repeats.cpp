#include "io/dicom/Repeats.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "io/dicom/ImageParts.h"
#include "io/dicom/SliceLayout.h"

namespace fenestra::io {
namespace {

/// A frame and the number of its place along the normal.
struct Placed {
  DicomFrame frame;
  std::size_t place = 0;
  double height = 0.0;  ///< mm along the normal
};
using Frames = std::vector<Placed>;

/// How many frames each place has.
std::map<std::size_t, std::size_t> countsOf(const Frames& frames) {
  std::map<std::size_t, std::size_t> counts;
  for (const Placed& each : frames) ++counts[each.place];
  return counts;
}

std::size_t mostAtOnePlace(const Frames& frames) {
  std::size_t most = 0;
  for (const auto& [place, count] : countsOf(frames)) most = std::max(most, count);
  return most;
}

std::vector<Frames> classesOf(const Frames& frames, std::size_t attribute) {
  std::map<std::string, Frames> classes;
  for (const Placed& each : frames)
    classes[attribute < each.frame.parts.size() ? each.frame.parts[attribute] : std::string()].push_back(each);
  std::vector<Frames> all;
  for (auto& [value, members] : classes) all.push_back(std::move(members));
  return all;
}

/// Slices at heights that ascend by one step, to a twentieth of it.
bool isEven(const Frames& frames) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < frames.size(); ++i) gaps.push_back(frames[i].height - frames[i - 1].height);
  if (gaps.empty()) return true;
  const auto [least, greatest] = std::minmax_element(gaps.begin(), gaps.end());
  return *greatest - *least <= std::max(0.05 * *greatest, positionTolerance);
}

bool overlap(const std::vector<Frames>& classes) {
  for (std::size_t i = 0; i < classes.size(); ++i)
    for (std::size_t j = i + 1; j < classes.size(); ++j)
      if (classes[i].front().height < classes[j].back().height && classes[j].front().height < classes[i].back().height)
        return true;
  return false;
}

class Parter {
 public:
  explicit Parter(std::vector<DicomFrame> frames, const glm::dvec3& normal) {
    std::sort(frames.begin(), frames.end(), [&](const DicomFrame& a, const DicomFrame& b) {
      const double along = glm::dot(a.position, normal), alongB = glm::dot(b.position, normal);
      return along != alongB ? along < alongB : earlier(a, b);
    });
    double start = 0.0;  // of the last place
    for (DicomFrame& frame : frames) {
      const double height = glm::dot(frame.position, normal);
      if (all_.empty() || height - start > positionTolerance) {
        start = height;
        ++parted_.places;
      }
      all_.push_back({std::move(frame), parted_.places - 1, height});
    }
  }

  PartedFrames part() {
    if (mostAtOnePlace(all_) > 1)
      partRepeated(std::move(all_));
    else
      partInterleaved(std::move(all_));
    std::stable_sort(parted_.volumes.begin(), parted_.volumes.end(),
                     [](const auto& a, const auto& b) { return earlier(a.front(), b.front()); });
    return std::move(parted_);
  }

 private:
  void add(const Frames& volume) {
    std::vector<DicomFrame> frames;
    for (const Placed& each : volume) frames.push_back(each.frame);
    parted_.volumes.push_back(std::move(frames));
  }

  void name(std::size_t attribute) {
    const std::string text = partingAttributes()[attribute].name;
    if (parted_.by.find(text) == std::string::npos) parted_.by += (parted_.by.empty() ? "" : ", ") + text;
  }

  void partRepeated(Frames frames) {
    const std::size_t most = mostAtOnePlace(frames), places = countsOf(frames).size();
    if (most < 2) return add(frames);
    for (std::size_t attribute = 0; attribute < partingAttributes().size(); ++attribute) {
      if (partingAttributes()[attribute].parting == Parting::Always) continue;
      std::vector<Frames> classes = classesOf(frames, attribute);
      if (classes.size() < 2 || classes.size() > most) continue;
      std::size_t together = 0;
      bool whole = false;
      for (const Frames& members : classes) {
        together += mostAtOnePlace(members);
        whole = whole || countsOf(members).size() == places;
      }
      if (together != most || !whole) continue;
      name(attribute);
      for (Frames& members : classes) partRepeated(std::move(members));
      return;
    }
    number(std::move(frames), most, places);
  }

  /// Frames that no attribute parts.
  void number(Frames frames, std::size_t most, std::size_t places) {
    std::vector<Frames> volumes;
    if (frames.size() == most * places) {
      std::stable_sort(frames.begin(), frames.end(), [](const Placed& a, const Placed& b) {
        return a.place != b.place ? a.place < b.place : earlier(a.frame, b.frame);
      });
      volumes.resize(most);
      for (std::size_t i = 0; i < frames.size(); ++i) volumes[i % most].push_back(frames[i]);
    } else if (volumes = runsOf(frames); !isWhole(volumes, most, places)) {
      return dropRepeats(std::move(frames));
    }
    for (const Frames& volume : volumes) add(volume);
  }

  /// Volumes that begin each time that a place comes again in stored order.
  static std::vector<Frames> runsOf(Frames frames) {
    std::stable_sort(frames.begin(), frames.end(),
                     [](const Placed& a, const Placed& b) { return earlier(a.frame, b.frame); });
    std::vector<Frames> runs(1);
    for (Placed& each : frames) {
      const bool again =
          std::any_of(runs.back().begin(), runs.back().end(), [&](const Placed& p) { return p.place == each.place; });
      if (again) runs.emplace_back();
      runs.back().push_back(std::move(each));
    }
    for (Frames& run : runs)
      std::sort(run.begin(), run.end(), [](const Placed& a, const Placed& b) { return a.place < b.place; });
    return runs;
  }

  /// Whether all volumes but the last, which may have been broken off, hold a frame at every place.
  static bool isWhole(const std::vector<Frames>& volumes, std::size_t most, std::size_t places) {
    return volumes.size() == most && std::all_of(volumes.begin(), volumes.end() - 1,
                                                 [&](const Frames& volume) { return volume.size() == places; });
  }

  void dropRepeats(Frames frames) {
    std::stable_sort(frames.begin(), frames.end(), [](const Placed& a, const Placed& b) {
      return a.place != b.place ? a.place < b.place : earlier(a.frame, b.frame);
    });
    Frames kept;
    for (Placed& each : frames)
      if (kept.empty() || kept.back().place != each.place)
        kept.push_back(std::move(each));
      else
        parted_.dropped.push_back(std::move(each.frame));
    add(kept);
  }

  void partInterleaved(Frames frames) {
    // Three slices are the fewest whose steps can be compared.
    constexpr std::size_t fewest = 3;
    if (isEven(frames)) return add(frames);
    for (std::size_t attribute = 0; attribute < partingAttributes().size(); ++attribute) {
      if (partingAttributes()[attribute].parting == Parting::Always) continue;
      const std::vector<Frames> classes = classesOf(frames, attribute);
      const bool even = std::all_of(classes.begin(), classes.end(),
                                    [](const Frames& members) { return members.size() >= fewest && isEven(members); });
      if (classes.size() < 2 || !even || !overlap(classes)) continue;
      name(attribute);
      parted_.interleaved = true;
      for (const Frames& members : classes) add(members);
      return;
    }
    add(frames);
  }

  Frames all_;
  PartedFrames parted_;
};

}  // namespace

bool earlier(const DicomFrame& a, const DicomFrame& b) {
  return std::tie(a.temporal, a.trigger, a.acquisition, a.instance, a.file, a.number) <
         std::tie(b.temporal, b.trigger, b.acquisition, b.instance, b.file, b.number);
}

PartedFrames partRepeats(std::vector<DicomFrame> frames, const glm::dvec3& normal) {
  return Parter(std::move(frames), normal).part();
}

}  // namespace fenestra::io
