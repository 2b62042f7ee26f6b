#pragma once
// Folds panels to their titles, by a button in the title: others get the room. Panels that share a place by
// tabs fold together.

#include <vector>

#include <QDockWidget>
#include <QMainWindow>
#include <QStringList>

class QToolButton;

namespace fenestra::viewer {

class DockFolding : public QObject {
  Q_OBJECT
 public:
  /// `docks`: all of the window's, which have their widgets. The window owns this.
  DockFolding(QMainWindow& window, std::vector<QDockWidget*> docks);

  bool isFolded(const QDockWidget& dock) const;
  /// Folds a dock, and those behind and before it.
  void setFolded(QDockWidget& dock, bool folded);
  /// Names of the folded docks' objects; others are ignored.
  QStringList folded() const;
  void restore(const QStringList& folded);

 Q_SIGNALS:
  void changed();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Fold {
    QDockWidget* dock;
    QToolButton* button;
  };
  /// Puts the button into the title, to the left of the one that closes.
  static void place(const Fold& fold);

  QMainWindow& window_;
  std::vector<Fold> folds_;
};

}  // namespace fenestra::viewer
