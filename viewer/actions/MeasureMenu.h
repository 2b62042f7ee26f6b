#pragma once
// Commands for a measure: the menu of a right click on it, and entries of the menu bar.

#include <optional>

#include <QPoint>

class QMenu;

namespace fenestra::viewer {

struct Workspace;

/// Puts a measure's text and its table row onto the clipboard; without `measure`, the table of all.
void copyMeasures(const Workspace& workspace, std::optional<std::size_t> measure = {});
void fillMeasureMenu(QMenu& menu, Workspace& workspace, std::size_t measure);
void showMeasureMenu(Workspace& workspace, std::size_t measure, QPoint at);

}  // namespace fenestra::viewer
