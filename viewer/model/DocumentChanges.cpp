#include "viewer/model/DocumentChanges.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "viewer/model/HeldBytes.h"

namespace fenestra::viewer {

LookChange::LookChange(DocumentParts& parts, Look before, Look after)
    : parts_(parts), before_(std::move(before)), after_(std::move(after)) {
  BrushStrokes &old = before_.strokes, &now = after_.strokes;
  const auto [oldEnd, nowEnd] = std::mismatch(old.begin(), old.end(), now.begin(), now.end());
  firstStroke_ = static_cast<std::size_t>(oldEnd - old.begin());
  const auto last =
      std::mismatch(old.rbegin(), std::reverse_iterator(oldEnd), now.rbegin(), std::reverse_iterator(nowEnd));
  old = {oldEnd, last.first.base()};
  now = {nowEnd, last.second.base()};
}

void LookChange::undo() { parts_.show(replaced(parts_.look(), after_, before_)); }

void LookChange::redo() { parts_.show(replaced(parts_.look(), before_, after_)); }

bool LookChange::absorb(const Change& next) {
  const auto& later = static_cast<const LookChange&>(next);
  const Look& now = parts_.look();
  // Each finds its strokes at its own place.
  const Look between = later.replaced(now, later.after_, later.before_);
  *this = LookChange(parts_, replaced(between, after_, before_), now);
  return true;
}

std::size_t LookChange::bytes() const { return sizeof(*this) + heldBy(before_) + heldBy(after_); }

LookChange& LookChange::operator=(LookChange&& other) noexcept {
  before_ = std::move(other.before_);
  after_ = std::move(other.after_);
  firstStroke_ = other.firstStroke_;
  return *this;
}

Look LookChange::replaced(const Look& whole, const Look& from, const Look& to) const {
  Look result = to;
  const auto begin = whole.strokes.begin() + static_cast<std::ptrdiff_t>(firstStroke_);
  result.strokes.insert(result.strokes.begin(), whole.strokes.begin(), begin);
  result.strokes.insert(result.strokes.end(), begin + static_cast<std::ptrdiff_t>(from.strokes.size()),
                        whole.strokes.end());
  return result;
}

LabelsChange::LabelsChange(DocumentParts& parts, segmentation::LabelEdit edit, State before, State after)
    : parts_(parts), edit_(std::move(edit)), before_(std::move(before)), after_(std::move(after)) {}

void LabelsChange::undo() { parts_.showLabels(edit_.reverted(parts_.labels().get()), before_.revision, before_.focus); }

void LabelsChange::redo() { parts_.showLabels(edit_.applied(parts_.labels().get()), after_.revision, after_.focus); }

bool LabelsChange::isNothing() const { return edit_.runs.empty() && edit_.before.labels == edit_.after.labels; }

std::size_t LabelsChange::bytes() const {
  return sizeof(*this) + edit_.bytes() + heldBy(before_.focus) + heldBy(after_.focus);
}

MeasuresChange::MeasuresChange(DocumentParts& parts, std::vector<Measure> before, std::vector<Measure> after)
    : parts_(parts), before_(std::move(before)), after_(std::move(after)) {}

void MeasuresChange::undo() { parts_.showMeasures(before_); }

void MeasuresChange::redo() { parts_.showMeasures(after_); }

bool MeasuresChange::absorb(const Change& next) {
  after_ = static_cast<const MeasuresChange&>(next).after_;
  return true;
}

std::size_t MeasuresChange::bytes() const { return sizeof(*this) + heldBy(before_) + heldBy(after_); }

void PathChange::show(const State& state) {
  parts_.showPath(state.path);
  if (!state.focus) return;
  Look look = parts_.look();
  look.focus = *state.focus;
  parts_.show(std::move(look));
}

bool PathChange::absorb(const Change& next) {
  const State& later = static_cast<const PathChange&>(next).after_;
  if (later.focus.has_value() != after_.focus.has_value()) return false;
  after_ = later;
  return true;
}

std::size_t PathChange::bytes() const {
  std::size_t bytes = sizeof(*this);
  for (const State* state : {&before_, &after_}) {
    bytes += state->path.capacity() * sizeof(glm::dvec3);
    if (state->focus) bytes += heldBy(*state->focus);
  }
  return bytes;
}

std::size_t KeyImagesChange::bytes() const {
  std::size_t bytes = sizeof(*this);
  for (const std::vector<io::KeyImage>* images : {&before_, &after_})
    for (const io::KeyImage& image : *images)
      bytes += sizeof(image) + heldBy(image.look) + image.name.capacity() + image.picture.capacity();
  return bytes;
}

}  // namespace fenestra::viewer
