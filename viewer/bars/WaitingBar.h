#pragma once
// Says that 3-D pictures are being prepared and do not show yet what was asked for, for how long by now, and takes it
// back. Hidden while they show it.

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

namespace fenestra::viewer {

class ViewArea;

class WaitingBar : public QWidget {
  Q_OBJECT
 public:
  /// `views` outlives this.
  explicit WaitingBar(ViewArea& views, QWidget* parent = nullptr);

 private:
  QElapsedTimer since_;
  QTimer second_;  ///< fires each second
};

}  // namespace fenestra::viewer
