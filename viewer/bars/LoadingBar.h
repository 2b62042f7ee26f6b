#pragma once
// Shows what is being read or written and how far, with a button to cancel. Hidden while nothing is.

#include <functional>

#include <QWidget>

namespace fenestra::viewer {

class LoadJob;

class LoadingBar : public QWidget {
  Q_OBJECT
 public:
  /// `title` shows until the job says what it is doing. `cancel` is what the button does; unset, it cancels the job.
  /// The job outlives this.
  LoadingBar(LoadJob& job, const QString& title, std::function<void()> cancel = {}, QWidget* parent = nullptr);
};

}  // namespace fenestra::viewer
