#include "viewer/jobs/LoadJob.h"

#include <new>
#include <utility>

#include <QPromise>
#include <QtConcurrentRun>

#include "viewer/jobs/BackgroundThreads.h"
#include "viewer/model/Translation.h"
#include "viewer/model/WayOutText.h"

namespace fenestra::viewer {
namespace {

constexpr int progressSteps = 1000;

}  // namespace

LoadJob::LoadJob(QObject* parent) : LoadJob(backgroundThreads(), parent) {}

LoadJob::LoadJob(QThreadPool& threads, QObject* parent) : QObject(parent), threads_(threads) {
  connect(&watcher_, &QFutureWatcherBase::finished, this, &LoadJob::finish);
  connect(&watcher_, &QFutureWatcherBase::progressValueChanged, this, [this](int value) {
    Q_EMIT progressed(static_cast<double>(value) / progressSteps, watcher_.progressText());
  });
}

LoadJob::~LoadJob() {
  watcher_.disconnect(this);
  watcher_.cancel();
  watcher_.waitForFinished();
}

void LoadJob::start(Read read) {
  watcher_.cancel();
  waits_ = false;
  running_ = true;
  Q_EMIT started();
  watcher_.setFuture(QtConcurrent::run(&threads_, [read = std::move(read)](QPromise<Outcome>& promise) {
    giveWayToTheWindow();
    promise.setProgressRange(0, progressSteps);
    const io::Progress progress = [&promise](double fraction, std::string_view doing) {
      promise.setProgressValueAndText(static_cast<int>(fraction * progressSteps), translated(doing));
      return !promise.isCanceled();
    };
    Outcome outcome;
    try {
      outcome.show = read(progress);
    } catch (const io::Cancelled&) {
      return;
    } catch (const VoxelAllocationError& error) {
      outcome.error = std::string("There is ") + error.what() + "; close other programs or open a smaller series";
    } catch (const std::bad_alloc&) {
      outcome.error = "There is not enough memory for this data set; close other programs or open a smaller series";
    } catch (const std::exception& error) {
      outcome.error = windowText(error).toStdString();
    }
    promise.addResult(std::move(outcome));
  }));
}

void LoadJob::cancel() { watcher_.cancel(); }

void LoadJob::release() {
  isHeld_ = false;
  // From the event loop: whoever asked goes on first, and may start another job instead.
  QMetaObject::invokeMethod(
      this,
      [this] {
        if (!isHeld_ && std::exchange(waits_, false)) finish();
      },
      Qt::QueuedConnection);
}

void LoadJob::finish() {
  if (isHeld_) {
    waits_ = true;
    return;
  }
  const QFuture<Outcome> future = watcher_.future();
  if (!future.isCanceled() && future.resultCount() > 0) {
    const Outcome outcome = future.result();
    if (outcome.show)
      outcome.show();
    else
      Q_EMIT failed(QString::fromStdString(outcome.error));
  }
  running_ = watcher_.isRunning();  // showing the result may have started another read
  Q_EMIT ended();
}

}  // namespace fenestra::viewer
