#pragma once
// Small pictures of series, made one after the other in the background and kept by whoever shows them.

#include <vector>

#include <QFutureWatcher>
#include <QImage>
#include <QObject>

#include "io/base/Reading.h"

namespace fenestra::viewer {

class Thumbnails : public QObject {
  Q_OBJECT
 public:
  /// Starts at once; pictures are at most `side` pixels wide and high.
  Thumbnails(std::vector<io::SeriesInfo> series, int side, QObject* parent = nullptr);
  /// Cancels and waits until the reader has stopped.
  ~Thumbnails() override;

 Q_SIGNALS:
  /// On the GUI thread; a series that cannot be read has no picture.
  void made(int index, const QImage& picture);

 private:
  struct Made {
    int index = 0;
    QImage picture;
  };
  QFutureWatcher<Made> watcher_;
};

}  // namespace fenestra::viewer
