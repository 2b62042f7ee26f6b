#pragma once
// Shows what is being read and how far, with a button to cancel. Hidden while nothing is being read.

#include <QWidget>

namespace fenestra::viewer {

class LoadJob;

class LoadingBar : public QWidget {
  Q_OBJECT
 public:
  /// The job outlives this.
  explicit LoadingBar(LoadJob& job, QWidget* parent = nullptr);
};

}  // namespace fenestra::viewer
