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
  const Measure finished = *std::exchange(draft_, std::nullopt);
  std::vector<Measure> measures = document_.measures();
  measures.push_back(finished);
  selected_ = measures.size() - 1;
  document_.setMeasures(std::move(measures), nameOf(finished.kind));
  Q_EMIT changed();
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
