#pragma once
// Shows what is being read or written and how far, with a button to cancel. Hidden while nothing is.

#include <QWidget>

namespace fenestra::viewer {

class LoadJob;

class LoadingBar : public QWidget {
  Q_OBJECT
 public:
  /// `title` shows until the job says what it is doing. The job outlives this.
  LoadingBar(LoadJob& job, const QString& title, QWidget* parent = nullptr);
};

}  // namespace fenestra::viewer
