#pragma once
// Where objects of archives are kept, how much room they take, and buttons to choose another place and to clear it. A
// row of the settings.

#include <cstdint>

#include <QWidget>

#include "viewer/archive/Archives.h"
#include "viewer/jobs/LoadJob.h"

class QLabel;
class QToolButton;

namespace fenestra::viewer {

class Retrievals;

class CacheRow : public QWidget {
  Q_OBJECT
 public:
  /// Both outlive this.
  CacheRow(Archives& archives, const Retrievals& retrievals, QWidget* parent = nullptr);

  /// Keeps objects in a folder of its own within `folder` from now on: all that is in it is the cache's to remove.
  void choose(const std::filesystem::path& folder);
  /// Removes all objects, without a question.
  void clear();
  bool isBusy() const { return job_.isRunning(); }

 private:
  /// Counts in the background.
  void measure();
  void show(std::uint64_t bytes);

  Archives& archives_;
  const Retrievals& retrievals_;
  LoadJob job_{archiveThreads()};
  QLabel* text_;
  QToolButton* clear_;
};

}  // namespace fenestra::viewer
