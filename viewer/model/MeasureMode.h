#pragma once
// Which kind of measure the mouse draws on the slices, the measure being drawn, and the selected one, in all views
// alike.

#include <optional>

#include <QObject>

#include "rendering/volume/SliceMeasure.h"

namespace fenestra::viewer {

class Document;

class MeasureMode : public QObject {
  Q_OBJECT
 public:
  /// `document` outlives this.
  explicit MeasureMode(Document& document, QObject* parent = nullptr);

  /// The kind that the mouse draws; unset: none.
  std::optional<MeasureKind> kind() const { return kind_; }
  /// Starts drawing that kind, or ends drawing where it is drawn already. An unfinished measure is dropped.
  void toggle(MeasureKind kind);

  /// The measure being drawn: its last point follows the mouse.
  const std::optional<Measure>& draft() const { return draft_; }
  void setDraft(std::optional<Measure> draft);
  /// Adds the draft to the document and selects it. A mark first needs its text: it stays, and markWanted() asks.
  void finishDraft();
  /// Adds the draft, a mark, with that text, or drops it where it is a text that is empty.
  void finishMark(const QString& text);
  /// Sets a mark's text as one step; an empty one removes a text, and leaves an arrow.
  void setText(std::size_t index, const QString& text);

  /// Place in Document::measures(); unset: none.
  std::optional<std::size_t> selected() const { return selected_; }
  void select(std::optional<std::size_t> index);
  void removeSelected();
  void removeAll();

  /// Drops the draft; without one, ends drawing; else deselects. False when there was nothing to end.
  bool stop();

 Q_SIGNALS:
  void changed();
  /// The draft is a mark that lacks its text alone: see finishMark(), and setDraft() to drop it.
  void markWanted();

 private:
  void add(Measure measure);
  Document& document_;
  std::optional<MeasureKind> kind_;
  std::optional<Measure> draft_;
  std::optional<std::size_t> selected_;
};

}  // namespace fenestra::viewer
