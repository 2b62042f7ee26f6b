#include "viewer/model/DocumentChanges.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "viewer/model/HeldBytes.h"

namespace fenestra::viewer {

Document::LookChange::LookChange(Document& document, Look before, Look after)
    : document_(document), before_(std::move(before)), after_(std::move(after)) {
  BrushStrokes &old = before_.strokes, &now = after_.strokes;
  const auto [oldEnd, nowEnd] = std::mismatch(old.begin(), old.end(), now.begin(), now.end());
  firstStroke_ = static_cast<std::size_t>(oldEnd - old.begin());
  const auto last =
      std::mismatch(old.rbegin(), std::reverse_iterator(oldEnd), now.rbegin(), std::reverse_iterator(nowEnd));
  old = {oldEnd, last.first.base()};
  now = {nowEnd, last.second.base()};
}

void Document::LookChange::undo() { document_.show(replaced(document_.look(), after_, before_)); }

void Document::LookChange::redo() { document_.show(replaced(document_.look(), before_, after_)); }

bool Document::LookChange::absorb(const Change& next) {
  const auto& later = static_cast<const LookChange&>(next);
  const Look& now = document_.look();
  // Each finds its strokes at its own place.
  const Look between = later.replaced(now, later.after_, later.before_);
  *this = LookChange(document_, replaced(between, after_, before_), now);
  return true;
}

std::size_t Document::LookChange::bytes() const { return sizeof(*this) + heldBy(before_) + heldBy(after_); }

Document::LookChange& Document::LookChange::operator=(LookChange&& other) noexcept {
  before_ = std::move(other.before_);
  after_ = std::move(other.after_);
  firstStroke_ = other.firstStroke_;
  return *this;
}

Look Document::LookChange::replaced(const Look& whole, const Look& from, const Look& to) const {
  Look result = to;
  const auto begin = whole.strokes.begin() + static_cast<std::ptrdiff_t>(firstStroke_);
  result.strokes.insert(result.strokes.begin(), whole.strokes.begin(), begin);
  result.strokes.insert(result.strokes.end(), begin + static_cast<std::ptrdiff_t>(from.strokes.size()),
                        whole.strokes.end());
  return result;
}

Document::LabelsChange::LabelsChange(Document& document, segmentation::LabelEdit edit, State before, State after)
    : document_(document), edit_(std::move(edit)), before_(std::move(before)), after_(std::move(after)) {}

void Document::LabelsChange::undo() {
  document_.showLabels(edit_.reverted(document_.labels().get()), before_.revision, before_.focus);
}

void Document::LabelsChange::redo() {
  document_.showLabels(edit_.applied(document_.labels().get()), after_.revision, after_.focus);
}

bool Document::LabelsChange::isNothing() const {
  return edit_.runs.empty() && edit_.before.labels == edit_.after.labels;
}

std::size_t Document::LabelsChange::bytes() const {
  return sizeof(*this) + edit_.bytes() + heldBy(before_.focus) + heldBy(after_.focus);
}

Document::MeasuresChange::MeasuresChange(Document& document, std::vector<Measure> before, std::vector<Measure> after)
    : document_(document), before_(std::move(before)), after_(std::move(after)) {}

void Document::MeasuresChange::undo() { document_.showMeasures(before_); }

void Document::MeasuresChange::redo() { document_.showMeasures(after_); }

bool Document::MeasuresChange::absorb(const Change& next) {
  after_ = static_cast<const MeasuresChange&>(next).after_;
  return true;
}

std::size_t Document::MeasuresChange::bytes() const { return sizeof(*this) + heldBy(before_) + heldBy(after_); }

}  // namespace fenestra::viewer
