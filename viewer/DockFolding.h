#pragma once
// Folds panels to their titles, by a click on the title or the button in it: others get the room. Panels that share a
// place by tabs fold together, and choosing one of the tabs unfolds them. A panel may also be folded for want of room,
// which is not remembered.

#include <optional>
#include <vector>

#include <QDockWidget>
#include <QMainWindow>
#include <QPoint>
#include <QStringList>

class QMouseEvent;
class QToolButton;

namespace fenestra::viewer {

class DockFolding : public QObject {
  Q_OBJECT
 public:
  /// `docks`: all of the window's, which have their widgets. The window owns this.
  DockFolding(QMainWindow& window, std::vector<QDockWidget*> docks);

  bool isFolded(const QDockWidget& dock) const;
  /// Whether it is folded because the user wanted so.
  bool isFoldedByUser(const QDockWidget& dock) const;
  /// Folds a dock, and those behind and before it, for the user.
  void setFolded(QDockWidget& dock, bool folded);
  /// Folds or unfolds a dock for want of room; neither opened() nor changed() follows. Those that the user folded stay
  /// so.
  void setCrowded(QDockWidget& dock, bool crowded);
  /// Names of the objects of the docks that the user has folded; others are ignored.
  QStringList folded() const;
  void restore(const QStringList& folded);

 Q_SIGNALS:
  /// The user has opened a dock that was folded; comes before changed().
  void opened(QDockWidget* dock);
  void changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Fold {
    QDockWidget* dock;
    QToolButton* button;
    bool byUser = false, crowded = false;
  };
  /// Puts the button into the title, to the left of the one that closes.
  static void place(const Fold& fold);
  /// Shows or hides the contents as the reasons to fold say.
  static void apply(const Fold& fold);
  /// A press and release in a title, without a drag between them, folds or unfolds.
  void clickTitle(QDockWidget& dock, const QMouseEvent& event);

  QMainWindow& window_;
  std::vector<Fold> folds_;
  std::optional<QPoint> pressed_;  ///< where the mouse is down in a title, on the screen
};

}  // namespace fenestra::viewer
