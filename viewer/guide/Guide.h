#pragma once
// Opens the user guide at the page on the view or panel that has the keyboard's focus, or on the tab that was brought
// to the front last.

#include <QObject>
#include <QPointer>

class QDockWidget;
class QMainWindow;

namespace fenestra::viewer {

class GuideWindow;

class Guide : public QObject {
  Q_OBJECT
 public:
  /// `window` owns this; it has its menus when the guide is opened, and its docks now.
  explicit Guide(QMainWindow& window);
  /// The user has opened a dock that was folded: its page is the one to show.
  void opened(const QDockWidget* dock);

  /// The page that open() would show, with a heading after a #.
  const QString& place() const { return place_; }
  void open() { open(place_); }
  void open(const QString& place);
  /// Null until the guide was opened.
  GuideWindow* window();

 private:
  void follow(const QWidget* focused);

  QMainWindow& window_;
  QPointer<GuideWindow> shown_;
  QString place_;
};

}  // namespace fenestra::viewer
