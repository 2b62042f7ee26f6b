#pragma once
// The window's commands: its menus, its toolbar and their keys.

#include <functional>

#include <QList>
#include <QMenu>
#include <QObject>

class QAction;
class QKeySequence;

namespace fenestra::viewer {

class MainWindow;

class Actions : public QObject {
  Q_OBJECT
 public:
  /// Fills the window's menu bar and toolbar. The window owns this and has its docks and views already.
  explicit Actions(MainWindow& window);

  /// An entry in the File menu for data that comes with the program.
  void addSample(const QString& name, std::function<void()> open);

 private:
  QAction* action(const QString& text, const QKeySequence& keys, std::function<void()> does);
  /// Enabled while something is open.
  QAction* volumeAction(const QString& text, const QKeySequence& keys, std::function<void()> does);
  QAction* toggle(const QString& text, const QKeySequence& keys, bool on, std::function<void(bool)> does);

  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  QMenu* makeAtRestMenu();
  void makeWindowLevelMenu();
  void makeFocusMenu();
  void makeHelpMenu();
  void fillRecentMenu();

  MainWindow& window_;
  QMenu *recent_ = nullptr, *samples_ = nullptr;
  QList<QAction*> needVolume_;
  /// Of the toolbar, group by group.
  QList<QList<QAction*>> tools_;
};

}  // namespace fenestra::viewer
