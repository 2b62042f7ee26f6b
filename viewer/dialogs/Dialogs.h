#pragma once
// The list of keys and mouse actions, and the dialog about the program.

#include <optional>

#include <QList>
#include <QString>

#include "rendering/gpu/Schedule.h"
#include "viewer/views/GlSupport.h"

class QMenuBar;
class QWidget;

namespace fenestra::viewer {

/// A menu entry with a key.
struct MenuKey {
  QString menu, keys, text;
};
QList<MenuKey> menuKeys(const QMenuBar& menus);
/// What the mouse does (viewer/dialogs/Gestures.h) and the keys of the menus, as a table.
QString keysHtml(const QMenuBar& menus);
/// As keysHtml(), as a page of the user guide.
QString keysPageHtml(const QMenuBar& menus);
void showKeys(const QMenuBar& menus, QWidget* parent);
void showAbout(const GlSupport& gl, std::optional<Schedule> schedule, QWidget* parent);

}  // namespace fenestra::viewer
