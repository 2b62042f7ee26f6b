#pragma once
// Commands for a measure: the menu of a right click on it, and entries of the menu bar.

#include <optional>

#include <QPoint>

class QMenu;
class QWidget;

namespace fenestra::viewer {

struct Workspace;

/// Puts a measure's text and its table row onto the clipboard; without `measure`, the table of all.
void copyMeasures(const Workspace& workspace, std::optional<std::size_t> measure = {});
/// Asks for a mark's text: of that measure, or of the draft where none is named. The question does not block the
/// window; without an answer the draft is dropped, and a measure stays.
void askForMarkText(Workspace& workspace, std::optional<std::size_t> measure, QWidget* parent);

void fillMeasureMenu(QMenu& menu, Workspace& workspace, std::size_t measure);
void showMeasureMenu(Workspace& workspace, std::size_t measure, QPoint at, QWidget* parent);

}  // namespace fenestra::viewer
