#include "viewer/model/MeasureMode.h"

#include <utility>
#include <vector>

#include "viewer/model/Document.h"
#include "viewer/model/MeasureText.h"

namespace fenestra::viewer {

MeasureMode::MeasureMode(Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document, &Document::volumeChanged, this, [this] {
    draft_.reset();
    selected_.reset();
    Q_EMIT changed();
  });
  // Undo may have taken the selected one away.
  connect(&document, &Document::measuresChanged, this, [this] {
    if (selected_ && *selected_ >= document_.measures().size()) select(std::nullopt);
  });
}

void MeasureMode::toggle(MeasureKind kind) {
  draft_.reset();
  kind_ = kind_ == kind ? std::nullopt : std::optional(kind);
  Q_EMIT changed();
}

void MeasureMode::setDraft(std::optional<Measure> draft) {
  draft_ = std::move(draft);
  Q_EMIT changed();
}

void MeasureMode::finishDraft() {
  if (!draft_) return;
  if (isMark(draft_->kind)) return Q_EMIT markWanted();
  add(*std::exchange(draft_, std::nullopt));
}

void MeasureMode::finishMark(const QString& text) {
  if (!draft_ || !isMark(draft_->kind)) return;
  Measure mark = *std::exchange(draft_, std::nullopt);
  mark.text = markText(text);
  if (mark.kind == MeasureKind::Arrow || !mark.text.empty()) return add(std::move(mark));
  Q_EMIT changed();
}

void MeasureMode::add(Measure measure) {
  std::vector<Measure> measures = document_.measures();
  const MeasureKind kind = measure.kind;
  measures.push_back(std::move(measure));
  selected_ = measures.size() - 1;
  document_.setMeasures(std::move(measures), nameOf(kind));
  Q_EMIT changed();
}

void MeasureMode::setText(std::size_t index, const QString& text) {
  std::vector<Measure> measures = document_.measures();
  if (index >= measures.size() || !isMark(measures[index].kind)) return;
  const std::string wanted = markText(text);
  if (wanted == measures[index].text) return;
  if (wanted.empty() && measures[index].kind == MeasureKind::Text) {
    select(index);
    return removeSelected();
  }
  measures[index].text = wanted;
  document_.setMeasures(std::move(measures), tr("Change text"));
}

void MeasureMode::select(std::optional<std::size_t> index) {
  if (selected_ == index) return;
  selected_ = index;
  Q_EMIT changed();
}

void MeasureMode::removeSelected() {
  if (!selected_) return;
  std::vector<Measure> measures = document_.measures();
  measures.erase(measures.begin() + static_cast<std::ptrdiff_t>(*std::exchange(selected_, std::nullopt)));
  document_.setMeasures(std::move(measures), tr("Delete measure"));
  Q_EMIT changed();
}

void MeasureMode::removeAll() {
  selected_.reset();
  if (!document_.measures().empty()) document_.setMeasures({}, tr("Delete all measures"));
  Q_EMIT changed();
}

bool MeasureMode::stop() {
  if (draft_)
    draft_.reset();
  else if (kind_)
    kind_.reset();
  else if (selected_)
    selected_.reset();
  else
    return false;
  Q_EMIT changed();
  return true;
}

}  // namespace fenestra::viewer
