// Reading in the background: progress, cancel, failure, replacement.

#include <atomic>
#include <chrono>
#include <new>
#include <thread>

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include "tests/gui/Patience.h"
#include "viewer/jobs/LoadJob.h"

namespace fenestra::viewer::loadJobTest {
namespace {

/// Reports progress until it is told to stop.
LoadJob::Show readForever(const io::Progress& progress) {
  while (progress(0.5, "reading")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  throw io::Cancelled();
}

TEST(LoadJob, ReadsOnAnotherThreadAndShowsOnThisOne) {
  LoadJob job;
  QSignalSpy progressed(&job, &LoadJob::progressed), ended(&job, &LoadJob::ended);
  std::atomic<QThread*> reader = nullptr;
  QThread* shower = nullptr;
  job.start([&](const io::Progress& progress) -> LoadJob::Show {
    reader = QThread::currentThread();
    progress(0.25, "a quarter");
    return [&] { shower = QThread::currentThread(); };
  });
  ASSERT_TRUE(ended.wait(patience));
  EXPECT_NE(reader.load(), QThread::currentThread());
  EXPECT_EQ(shower, QThread::currentThread());
  EXPECT_FALSE(job.isRunning());
}

TEST(LoadJob, TellsWhatWentWrong) {
  LoadJob job;
  QSignalSpy failed(&job, &LoadJob::failed), ended(&job, &LoadJob::ended);
  job.start([](const io::Progress&) -> LoadJob::Show { throw io::Error("scan.nii", "is empty", "copy it again"); });
  ASSERT_TRUE(ended.wait(patience));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_EQ(failed.front().front().toString(), QStringLiteral("scan.nii: is empty; copy it again"));
}

TEST(LoadJob, SaysThatMemoryRanOut) {
  LoadJob job;
  QSignalSpy failed(&job, &LoadJob::failed), ended(&job, &LoadJob::ended);
  job.start([](const io::Progress&) -> LoadJob::Show { throw std::bad_alloc(); });
  ASSERT_TRUE(ended.wait(patience));
  ASSERT_EQ(failed.count(), 1);
  EXPECT_TRUE(failed.front().front().toString().contains(QStringLiteral("memory")));
}

TEST(LoadJob, CancelEndsQuietly) {
  LoadJob job;
  QSignalSpy failed(&job, &LoadJob::failed), ended(&job, &LoadJob::ended), progressed(&job, &LoadJob::progressed);
  job.start(readForever);
  // The first signal may be that of the range, with a value of 0.
  const QVariantList reading{0.5, QStringLiteral("reading")};
  ASSERT_TRUE(QTest::qWaitFor([&] { return !progressed.isEmpty() && progressed.back() == reading; }, patience));
  job.cancel();
  ASSERT_TRUE(ended.wait(patience));
  EXPECT_EQ(failed.count(), 0);
}

TEST(LoadJob, ANewStartReplacesWhatWasRunning) {
  LoadJob job;
  QSignalSpy progressed(&job, &LoadJob::progressed);
  job.start(readForever);
  ASSERT_TRUE(progressed.wait(patience));
  QSignalSpy ended(&job, &LoadJob::ended), failed(&job, &LoadJob::failed);
  int shown = 0;
  job.start([&](const io::Progress&) -> LoadJob::Show { return [&] { ++shown; }; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return shown == 1; }, patience));
  EXPECT_EQ(ended.count(), 1);
  EXPECT_EQ(failed.count(), 0);
}

TEST(LoadJob, StopsItsReaderWhenItGoes) {
  std::atomic<bool> reading = false, stopped = false;
  {
    LoadJob job;
    job.start([&](const io::Progress& progress) -> LoadJob::Show {
      struct AtEnd {
        std::atomic<bool>& flag;
        ~AtEnd() { flag = true; }
      } atEnd{stopped};
      reading = true;
      return readForever(progress);
    });
    ASSERT_TRUE(QTest::qWaitFor([&] { return reading.load(); }, patience));
  }
  EXPECT_TRUE(stopped);
}

TEST(LoadJob, AHeldOutcomeWaitsAndAnotherJobTakesItsPlace) {
  LoadJob job;
  int shown = 0;
  const auto read = [&](int what) {
    return [&shown, what](const io::Progress&) -> LoadJob::Show { return [&shown, what] { shown = what; }; };
  };
  job.hold();
  job.start(read(1));
  QTest::qWait(100);
  EXPECT_EQ(shown, 0);
  EXPECT_TRUE(job.isRunning());
  job.release();
  EXPECT_EQ(shown, 0) << "whoever asked goes on first";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !job.isRunning(); }, patience));
  EXPECT_EQ(shown, 1);
  job.hold();
  job.start(read(2));
  QTest::qWait(100);
  job.release();
  job.start(read(3));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !job.isRunning(); }, patience));
  EXPECT_EQ(shown, 3);
}

}  // namespace
}  // namespace fenestra::viewer::loadJobTest
