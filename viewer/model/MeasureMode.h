#pragma once
// Which measure the mouse draws on the slices, the one being drawn, and the one that is selected; the same in all
// views.

#include <optional>

#include <QObject>

#include "rendering/scene/Measure.h"

namespace fenestra::viewer {

class Document;

class MeasureMode : public QObject {
  Q_OBJECT
 public:
  /// `document` outlives this.
  explicit MeasureMode(Document& document, QObject* parent = nullptr);

  /// Unset: the mouse draws none.
  std::optional<MeasureKind> kind() const { return kind_; }
  /// Starts drawing that kind; the kind that is drawn already: ends it. A measure that is not finished goes.
  void toggle(MeasureKind kind);

  /// The measure being drawn: its last point follows the mouse.
  const std::optional<Measure>& draft() const { return draft_; }
  void setDraft(std::optional<Measure> draft);
  /// Adds the draft to the document and selects it.
  void finishDraft();

  /// Place in Document::measures(); unset: none.
  std::optional<std::size_t> selected() const { return selected_; }
  void select(std::optional<std::size_t> index);
  void removeSelected();
  void removeAll();

  /// Gives up the draft; without one ends drawing; without that deselects. False when there was nothing to end.
  bool stop();

 Q_SIGNALS:
  void changed();

 private:
  Document& document_;
  std::optional<MeasureKind> kind_;
  std::optional<Measure> draft_;
  std::optional<std::size_t> selected_;
};

}  // namespace fenestra::viewer
