#pragma once
// Shares the height of the docks' column. Each group of docks, a section, gets the height below which it is of no use
// (panels/ScrollingPanel.h); sections for which there is no room are folded. The first section is always open; of the
// others, those that were opened last come first. What height remains goes to the contents that want it, and then to
// the first section. Once the user has moved a border between docks, nothing is shared any more until a section is
// folded or opened.

#include <vector>

#include <QDockWidget>
#include <QMainWindow>
#include <QStringList>

namespace fenestra::viewer {

class DockFolding;

class DockHeights : public QObject {
 public:
  /// `column` holds a dock of each group from top to bottom; its contents stand for those of the others behind it, so
  /// that nothing moves when another tab is chosen. The window owns this.
  DockHeights(QMainWindow& window, DockFolding& folding, std::vector<QDockWidget*> column);

  /// To be called after a layout was restored: heights other than those that would be shared count as chosen by
  /// the user.
  void keepWhatTheUserChose() { checks_ = true; }
  /// Shares the height anew, also where the user has moved a border.
  void reset();
  /// Names of the sections' objects, those that the user opened last first.
  QStringList openedLast() const;
  /// Brings them into that order at the next share; names that are not there are ignored, and sections that are not
  /// named follow as in the column.
  void restore(const QStringList& openedLast);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Section {
    QDockWidget* dock;   ///< the visible one of its group
    QDockWidget* first;  ///< the one that the column names
  };
  /// The sections in sight; empty once the user has arranged the docks in another way.
  std::vector<Section> shown() const;
  static std::vector<int> heightsOf(const std::vector<Section>& sections);
  /// The height of a section's title, and the least one of its contents, from which on it is of use.
  int titleOf(const Section& section) const;
  static int usefulHeightOf(const Section& section);
  /// Folds those for which there is no room, and opens the others but those that the user folded.
  void fold(const std::vector<Section>& sections);
  /// How the height of all sections is to be shared among them.
  std::vector<int> wanted(const std::vector<Section>& sections) const;
  void share();

  QMainWindow& window_;
  DockFolding& folding_;
  std::vector<QDockWidget*> column_;
  std::vector<QDockWidget*> order_;  ///< docks of the column: the first one, then those that the user opened last
  std::vector<int> pressed_;         ///< heights when the mouse was pressed on a border
  bool checks_ = false;   ///< heights that share() would not give are the user's; after a layout was restored
  bool isUsers_ = false;  ///< the user has moved a border
  bool isDue_ = false;    ///< share() runs soon
};

}  // namespace fenestra::viewer
