// What counts as work that would be lost, how the window asks about it, and how a run ends in order.

#include <csignal>
#include <fstream>
#include <thread>

#include <QProcess>
#include <QSignalSpy>
#include <QTest>

#include "io/VolumeWriter.h"
#include "io/session/SessionFile.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/UserWork.h"

namespace fenestra::viewer::unsavedWorkTest {
namespace {

namespace fs = std::filesystem;
using Answer = SessionQuestions::Answer;

class UnsavedWork : public Window {
 protected:
  SessionController& controller() { return window_->sessions().controller(); }
  SessionQuestions& questions() { return window_->sessions().questions(); }
  void makeWork() { document().setRole(marker, LabelRole::Hidden); }

  const fs::path folder_ = tests::scratchFolder();
};

TEST_F(UnsavedWork, IsNotWhatOneClickMakesAgain) {
  EXPECT_FALSE(controller().isModified());
  QTest::mouseClick(slice(SlicePlane::Axial), Qt::LeftButton, {}, slice(SlicePlane::Axial)->rect().center());
  EXPECT_TRUE(document().undoStack().canUndo()) << "the click chose a focus";
  EXPECT_FALSE(controller().isModified());
  cameras().orbit(0, 0.3, 0.1);
  QTest::keyClick(volume(0), Qt::Key_R);
  EXPECT_FALSE(controller().isModified());
  document().setFocused(body, true);
  document().setFocused(marker, true);
  EXPECT_TRUE(controller().isModified()) << "a focus of two structures takes more than a click";
  document().undoStack().undo();
  document().undoStack().undo();
  makeWork();
  EXPECT_TRUE(controller().isModified());
  EXPECT_EQ(controller().unsavedWork(), QStringList{QStringLiteral("Role")});
  document().undoStack().undo();
  EXPECT_FALSE(controller().isModified());
}

TEST_F(UnsavedWork, TheQuestionSaysWhatWouldBeLost) {
  makeWork();
  document().setRole(body, LabelRole::Protected);
  document().setShift(12.0);
  QStringList told;
  questions().saveChanges = [&](const QStringList& lost) { return told = lost, Answer::Cancel; };
  EXPECT_FALSE(window_->sessions().mayGo());
  EXPECT_EQ(told, (QStringList{"Role (2)", "Shift"}));
}

/// A reader that goes on until it is told to end.
struct SlowReader {
  std::atomic<bool> ends{false};
  StudyLoader::Reader reader() {
    return [this](const io::Progress& progress) {
      while (!ends && progress(0.5, "reading")) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      return markedBall();
    };
  }
};

TEST_F(UnsavedWork, WhatWasDiscardedIsNotAskedAboutAgainWhileTheNextStudyIsRead) {
  makeWork();
  int asked = 0;
  questions().saveChanges = [&](const QStringList&) { return ++asked, Answer::Discard; };
  ASSERT_TRUE(window_->sessions().mayGo());
  SlowReader slow;
  window_->open(slow.reader());
  EXPECT_TRUE(window_->sessions().mayGo());
  EXPECT_EQ(asked, 1);
  document().setShift(5.0);
  EXPECT_TRUE(window_->sessions().mayGo());
  EXPECT_EQ(asked, 2) << "this is work since then";
  slow.ends = true;
  waitUntilDrawn();
}

TEST_F(UnsavedWork, DiscardedWorkCountsAgainWhereTheNextStudyFails) {
  makeWork();
  int asked = 0;
  questions().saveChanges = [&](const QStringList&) { return ++asked, Answer::Discard; };
  ASSERT_TRUE(window_->sessions().mayGo());
  window_->open([](const io::Progress&) -> io::Study { throw io::Error("a.nii", "is damaged", "get it again"); });
  waitUntilDrawn();
  EXPECT_TRUE(window_->sessions().mayGo());
  EXPECT_EQ(asked, 2);
}

TEST_F(UnsavedWork, SaveNeverWritesTheStudyThatArrivesMeanwhile) {
  io::writeVolume(*markedBall().scene.volume, folder_ / "ball.nii.gz");
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  window_->open(std::vector{folder_ / "ball.nii.gz"});
  ASSERT_TRUE(opened.wait(patience));
  document().setShift(12.0);
  SlowReader slow;
  window_->open(slow.reader());
  questions().saveChanges = [&](const QStringList&) {
    slow.ends = true;
    QTest::qWait(300);  // the new study would be shown while the question is
    return Answer::Save;
  };
  questions().saveWhere = [&](const fs::path&) { return std::optional(folder_ / "kept.fenestra"); };
  EXPECT_TRUE(window_->sessions().mayGo());
  EXPECT_EQ(io::readSession(folder_ / "kept.fenestra").look.context.shift, 12.0);
  waitUntilDrawn();
  EXPECT_EQ(document().shift(), 0.0) << "now the new study is open";
}

TEST_F(UnsavedWork, IsLeftBehindWhereTheProgramIsEnded) {
  controller().startAutosave(folder_ / "state", 3600000);
  window_->sessions().leave();
  const auto copies = [&] { return SessionController::abandonedIn(folder_ / "state").size(); };
  EXPECT_EQ(copies(), 0u) << "there is no work";
  makeWork();
  window_->sessions().leave();
  EXPECT_EQ(copies(), 1u);
  window_.reset();
  EXPECT_EQ(copies(), 1u) << "ending in order does not take it away";
}

TEST_F(UnsavedWork, RestoringNamesTheStudyAndKeepsWhatWasNamedAtTheStart) {
  io::Study study = markedBall();
  io::writeVolume(*study.scene.volume, folder_ / "ball.nii.gz");
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  window_->open(std::vector{folder_ / "ball.nii.gz"});
  ASSERT_TRUE(opened.wait(patience));
  document().setShift(12.0);
  controller().startAutosave(folder_ / "state", 3600000);
  window_->sessions().leave();
  QString name;
  questions().restoreWork = [&](const QDateTime&, const QString& about) { return name = about, Answer::Save; };
  document().undoStack().setClean();
  ASSERT_TRUE(window_->sessions().startRecovery(folder_ / "state"));
  EXPECT_EQ(name, QStringLiteral("ball.nii.gz"));
  window_->offer(QStringLiteral("/data/other"), [&] { return io::StudyRequest{}; });
  ASSERT_TRUE(opened.wait(patience));
  waitUntilDrawn();
  EXPECT_TRUE(window_->notices().texts().join(QLatin1Char('\n')).contains(QStringLiteral("/data/other")))
      << "the restored study does not take the offer away";
  options().setHidesPatient(true);
  EXPECT_FALSE(window_->notices().texts().join(QLatin1Char('\n')).contains(QStringLiteral("/data/other")));
}

/// Whether a process has a handler for a signal, by the mask of those that it catches (proc(5)).
bool handles(qint64 process, int signal) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("SigCgt:")) return std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1;
  return false;
}

/// The program itself, told by the system to end.
TEST(EndingProgram, EndsInOrderByTheSystemsSignals) {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("XDG_STATE_HOME"), QString::fromStdString(tests::scratchFolder().string()));
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), QString::fromStdString(tests::scratchFolder().string()));
    program.setProcessEnvironment(environment);
    program.start(QStringLiteral(FENESTRA_PROGRAM), QStringList());
    ASSERT_TRUE(program.waitForStarted());
    // It sets its handlers when the window is shown, before it handles events.
    ASSERT_TRUE(QTest::qWaitFor([&] { return handles(program.processId(), signal); }, patience));
    ASSERT_EQ(::kill(static_cast<pid_t>(program.processId()), signal), 0);
    ASSERT_TRUE(program.waitForFinished(patience)) << signal;
    EXPECT_EQ(program.exitStatus(), QProcess::NormalExit) << signal;
    EXPECT_EQ(program.exitCode(), 0) << signal;
  }
}

}  // namespace
}  // namespace fenestra::viewer::unsavedWorkTest
