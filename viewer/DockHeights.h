#pragma once
// Shares the height of the docks' column. From the lowest group of docks to the second, each gets the height that its
// contents want, but at most an even share of the height that remains; the first one gets the rest. Once the user has
// moved a border between docks, nothing is shared any more.

#include <vector>

#include <QDockWidget>
#include <QMainWindow>

namespace fenestra::viewer {

class DockHeights : public QObject {
 public:
  /// `column` holds a dock of each group from top to bottom. The window owns this.
  DockHeights(QMainWindow& window, std::vector<QDockWidget*> column);

  /// To be called after a layout was restored: heights other than the shared ones count as chosen by the user.
  void keepWhatTheUserChose() { checks_ = true; }
  /// Shares the height anew, also where the user has moved a border.
  void reset();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// The visible dock of each group; empty once the user has arranged the docks in another way.
  std::vector<QDockWidget*> shown() const;
  static std::vector<int> heightsOf(const std::vector<QDockWidget*>& docks);
  /// How the height of all docks is to be shared among them.
  std::vector<int> wanted(const std::vector<QDockWidget*>& docks) const;
  void share();

  QMainWindow& window_;
  std::vector<QDockWidget*> column_;
  std::vector<int> shared_;  ///< heights after the last share
  bool checks_ = false;      ///< heights that differ from shared_ are the user's; off until a layout is restored
  bool isUsers_ = false;     ///< the user has moved a border
  bool isDue_ = false;       ///< share() runs soon
};

}  // namespace fenestra::viewer
