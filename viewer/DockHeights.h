#pragma once
// Shares the height of the docks' column. From the lowest group of docks to the second, each gets the height that its
// contents want, but at most an even share of what is left; the first one gets the remainder. Once the user has moved a
// border between docks, heights are the user's.

#include <vector>

#include <QDockWidget>
#include <QMainWindow>

namespace fenestra::viewer {

class DockHeights : public QObject {
 public:
  /// `column` holds a dock of each group from top to bottom. The window owns this.
  DockHeights(QMainWindow& window, std::vector<QDockWidget*> column);

  /// From now on, heights that this did not share are the user's: after a layout was restored.
  void keepWhatTheUserChose() { checks_ = true; }
  /// Shares the height anew, whatever the user did.
  void reset();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// The visible dock of each group; empty where the docks are no longer a column of those groups.
  std::vector<QDockWidget*> shown() const;
  static std::vector<int> heightsOf(const std::vector<QDockWidget*>& docks);
  /// What each of shown() gets of the height that they have together.
  std::vector<int> wanted(const std::vector<QDockWidget*>& docks) const;
  void share();

  QMainWindow& window_;
  std::vector<QDockWidget*> column_;
  std::vector<int> shared_;  ///< heights after the last share
  bool checks_ = false;      ///< the heights that the window begins with may be the user's
  bool isUsers_ = false;     ///< the user has moved a border
  bool isDue_ = false;       ///< share() runs soon
};

}  // namespace fenestra::viewer
