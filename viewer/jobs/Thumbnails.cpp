#include "viewer/jobs/Thumbnails.h"

#include <algorithm>
#include <new>

#include <QPromise>
#include <QtConcurrentRun>

#include "io/Thumbnail.h"
#include "viewer/jobs/BackgroundThreads.h"

namespace fenestra::viewer {
namespace {

/// Empty when the series cannot be read: the chooser lists it all the same, and opening it says why. Throws
/// io::Cancelled.
QImage pictureOf(const io::SeriesInfo& series, int side, const io::Progress& progress) {
  try {
    const io::Thumbnail thumbnail = io::makeThumbnail(series, side, progress);
    QImage picture(thumbnail.size.x, thumbnail.size.y, QImage::Format_Grayscale8);
    for (int y = 0; y < thumbnail.size.y; ++y)
      std::copy_n(thumbnail.grey.data() + static_cast<std::ptrdiff_t>(y) * thumbnail.size.x, thumbnail.size.x,
                  picture.scanLine(y));
    return picture;
  } catch (const io::Error&) {
    return {};
  } catch (const std::bad_alloc&) {
    return {};
  }
}

}  // namespace

Thumbnails::Thumbnails(std::vector<io::SeriesInfo> series, int side, QObject* parent) : QObject(parent) {
  connect(&watcher_, &QFutureWatcherBase::resultReadyAt, this, [this](int result) {
    const Made ready = watcher_.resultAt(result);
    Q_EMIT made(ready.index, ready.picture);
  });
  watcher_.setFuture(
      QtConcurrent::run(&backgroundThreads(), [series = std::move(series), side](QPromise<Made>& promise) {
        giveWayToTheWindow();
        const io::Progress progress = [&promise](double, std::string_view) { return !promise.isCanceled(); };
        try {
          for (std::size_t i = 0; i < series.size() && !promise.isCanceled(); ++i)
            if (QImage picture = pictureOf(series[i], side, progress); !picture.isNull())
              promise.addResult(Made{static_cast<int>(i), std::move(picture)});
        } catch (const io::Cancelled&) {
        }
      }));
}

Thumbnails::~Thumbnails() {
  watcher_.disconnect(this);
  watcher_.cancel();
  watcher_.waitForFinished();
}

}  // namespace fenestra::viewer
