// Work is not lost: the window asks before it drops unsaved work, keeps labels beside the session, finds data that
// moved, and offers to restore what a crash left.

#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <fstream>

#include <QApplication>
#include <QDropEvent>
#include <QLockFile>
#include <QMimeData>
#include <QUrl>

#include "tests/gui/SessionWindowFixture.h"
#include "viewer/panels/LabelEditPanel.h"

namespace fenestra::viewer::sessionSafetyTest {
namespace {

TEST_F(SessionWindow, AsksBeforeWorkIsLost) {
  using Answer = SessionQuestions::Answer;
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_TRUE(window_->sessions().mayGo());
  document().setRole(marker, LabelRole::Hidden);
  EXPECT_TRUE(window_->isWindowModified());
  document().undoStack().undo();
  EXPECT_FALSE(window_->isWindowModified()) << "undone, there is nothing to lose";
  document().focusOn(body);
  document().setRole(marker, LabelRole::Hidden);

  int asked = 0;
  Answer answer = Answer::Cancel;
  window_->sessions().questions().saveChanges = [&](const QStringList&) { return ++asked, answer; };
  EXPECT_FALSE(window_->close());
  window_->open({folder_ / "data" / "ball.nii.gz"});
  QTest::qWait(50);
  EXPECT_TRUE(document().isFocused(body)) << "what was open stays";
  EXPECT_EQ(asked, 2);

  answer = Answer::Save;
  std::optional<fs::path> where;
  window_->sessions().questions().saveWhere = [&](const fs::path&) { return where; };
  EXPECT_FALSE(window_->close()) << "no file was chosen";
  where = folder_ / "no such folder" / "a";
  EXPECT_FALSE(window_->close()) << "it could not be saved";
  EXPECT_TRUE(window_->isWindowModified());
  EXPECT_FALSE(window_->notices().texts().isEmpty());
  where = folder_ / "kept";
  EXPECT_TRUE(window_->close());
  EXPECT_EQ(io::readSession(folder_ / "kept.fenestra").look.focus, Focus(LabelFocus{{body}})) << "the ending is added";
  EXPECT_FALSE(window_->isWindowModified());
  document().focusOn(marker);
  document().setRole(body, LabelRole::Hidden);
  answer = Answer::Discard;
  window_->show();
  EXPECT_TRUE(window_->close());
  EXPECT_EQ(io::readSession(folder_ / "kept.fenestra").look.focus, Focus(LabelFocus{{body}}));
}

TEST_F(SessionWindow, SavesByItsKeysAndOpensWhatIsDropped) {
  document().focusOn(marker);
  window_->sessions().questions().saveWhere = [&](const fs::path& suggested) {
    EXPECT_EQ(suggested, folder_ / "data" / "session.fenestra");
    return std::optional(file_);
  };
  QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(controller().waitUntilSaved());
  EXPECT_TRUE(fs::exists(file_));
  document().focusOn(body);
  QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(controller().waitUntilSaved());
  EXPECT_EQ(io::readSession(file_).look.focus, Focus(LabelFocus{{body}}));

  document().setFocus(std::monostate{});
  document().undoStack().undo();
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(toQString(file_))});
  QDragEnterEvent enter(QPoint(200, 200), Qt::CopyAction, &data, Qt::LeftButton, {});
  QApplication::sendEvent(window_.get(), &enter);
  QDropEvent drop(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, {});
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  QApplication::sendEvent(window_.get(), &drop);
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{body}}));
  EXPECT_EQ(controller().file(), file_);
}

TEST_F(SessionWindow, AsksWhereMovedDataIs) {
  document().focusOn(marker);
  save(file_);
  fs::create_directory(folder_ / "sessions");
  fs::rename(file_, folder_ / "sessions" / "a.fenestra");
  int asked = 0;
  window_->sessions().questions().dataWhere = [&](const io::DataMissing& missing) {
    ++asked;
    return std::optional(folder_ / "data" /
                         (missing.data() == io::DataMissing::Data::Labels ? "labels.nii.gz" : "ball.nii.gz"));
  };
  open(folder_ / "sessions" / "a.fenestra");
  EXPECT_EQ(asked, 2);
  EXPECT_TRUE(document().isFocused(marker));
  EXPECT_TRUE(window_->notices().texts().isEmpty()) << "the contents are unchanged";
  save(folder_ / "sessions" / "a.fenestra");
  open(folder_ / "sessions" / "a.fenestra");
  EXPECT_EQ(asked, 2) << "saving again has stored the new place";
}

TEST_F(SessionWindow, DataThatNobodyFindsIsNamed) {
  document().focusOn(marker);
  save(file_);
  fs::remove(folder_ / "data" / "ball.nii.gz");
  window_->sessions().questions().dataWhere = [](const io::DataMissing&) { return std::nullopt; };
  window_->open({file_});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_->notices().texts().isEmpty(); }, patience));
  EXPECT_TRUE(window_->notices().texts().front().contains(QStringLiteral("ball.nii.gz")));
  EXPECT_TRUE(document().isFocused(marker)) << "what was open stays";
}

TEST_F(SessionWindow, KeptLabelsAreWrittenBesideTheSession) {
  // A file of the user's own of the name that the labels would get.
  std::ofstream(folder_ / "work.labels.nrrd") << "mine";
  grow();
  keepRegion(QStringLiteral("Nodule ä"));
  const std::vector<std::uint16_t> kept = labelValues();
  const std::vector<QImage> before = pictures();
  save(file_);
  EXPECT_TRUE(document().labelsAreInFile());
  EXPECT_EQ(readFile(folder_ / "work.labels.nrrd"), "mine");
  EXPECT_EQ(io::readSession(file_).labels.path, folder_ / "work-2.labels.nrrd");
  expectCommandLineAgrees();
  restart();
  open(file_);
  EXPECT_EQ(labelValues(), kept);
  EXPECT_EQ(document().labels()->labels.at(0).name, "Nodule ä");
  EXPECT_EQ(pictures(), before);

  // An edit after that goes into the session's own file, and its undo is no edit.
  panel<FocusPanel>().labelEdits()->button(LabelOperation::Grow)->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().undoStack().count() == 1; }, patience));
  EXPECT_FALSE(document().labelsAreInFile());
  const std::vector<std::uint16_t> larger = labelValues();
  EXPECT_NE(larger, kept);
  document().undoStack().undo();
  EXPECT_TRUE(document().labelsAreInFile());
  document().undoStack().redo();
  save(file_);
  restart();
  open(file_);
  EXPECT_EQ(labelValues(), larger);
}

TEST_F(SessionWindow, KeptLabelsSurviveACrash) {
  const fs::path kept = folder_ / "state";
  controller().startAutosave(kept, 3600000);
  grow();
  keepRegion(QStringLiteral("kept"));
  const std::vector<std::uint16_t> labels = labelValues();
  controller().autosave();
  controller().waitUntilSaved();
  EXPECT_FALSE(document().labelsAreInFile()) << "a copy is no save";
  // The files after a crash: both, without a lock.
  const fs::path left = folder_ / "left";
  fs::create_directory(left);
  for (const auto& entry : fs::directory_iterator(kept))
    if (entry.path().extension() != ".lock") fs::copy_file(entry.path(), left / entry.path().filename());
  restart();
  EXPECT_TRUE(fs::is_empty(kept)) << "a run that ends normally removes its copy and the labels";
  window_->sessions().questions().restoreWork = [](const QDateTime&, const QString&) {
    return SessionQuestions::Answer::Save;
  };
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  ASSERT_TRUE(window_->sessions().startRecovery(left));
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(labelValues(), labels);
  EXPECT_FALSE(document().labelsAreInFile()) << "the copy's labels go with the copy";
  save(file_);
  EXPECT_EQ(io::readSession(file_).labels.path, folder_ / "work.labels.nrrd");
  EXPECT_TRUE(fs::is_empty(left));
  restart();
  open(file_);
  EXPECT_EQ(labelValues(), labels);
}

TEST_F(SessionWindow, KeptLabelsAreNotReplacedUnasked) {
  grow();
  keepRegion(QStringLiteral("kept"));
  const std::vector<std::uint16_t> kept = labelValues();
  int asked = 0;
  window_->sessions().questions().saveChanges = [&](const QStringList&) {
    return ++asked, SessionQuestions::Answer::Cancel;
  };
  window_->openLabels(folder_ / "data" / "labels.nii.gz");
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(labelValues(), kept);
  window_->sessions().questions().saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Discard; };
}

TEST_F(SessionWindow, OffersWhatACrashLeft) {
  const fs::path kept = folder_ / "state";
  const auto copies = [&] {
    int found = 0;
    for (const auto& entry : fs::directory_iterator(kept)) found += io::isSession(entry.path());
    return found;
  };
  controller().startAutosave(kept, 3600000);
  controller().autosave();
  controller().waitUntilSaved();
  EXPECT_EQ(copies(), 0) << "nothing was done yet";
  save(file_);
  work();
  controller().autosave();
  controller().waitUntilSaved();
  ASSERT_EQ(copies(), 1);
  EXPECT_TRUE(window_->isWindowModified()) << "a copy is no save";
  EXPECT_TRUE(SessionController::abandonedIn(kept).empty()) << "its run is alive";
  EXPECT_EQ(io::readSession(file_).look.focus, Focus()) << "autosave leaves the user's file alone";

  // A crash leaves the copy, and the lock of a process that has ended.
  const fs::path copy = fs::directory_iterator(kept)->path().parent_path() / "crashed.fenestra";
  for (const auto& entry : fs::directory_iterator(kept))
    if (io::isSession(entry.path())) fs::copy_file(entry.path(), copy);
  const pid_t child = ::fork();
  if (child == 0) {
    QLockFile lock(toQString(copy) + QStringLiteral(".lock"));
    ::_exit(lock.tryLock(0) ? 0 : 1);  // without unlocking
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
  ASSERT_TRUE(fs::exists(copy.string() + ".lock"));
  const Look look = document().look();
  const ViewLink::Pose pose = cameras().pose();
  restart();
  EXPECT_EQ(copies(), 1) << "a run that ends normally removes its copy";

  int asked = 0;
  window_->sessions().questions().restoreWork = [&](const QDateTime& saved, const QString& study) {
    ++asked;
    EXPECT_LT(std::abs(saved.secsTo(QDateTime::currentDateTime())), 600);
    EXPECT_EQ(study, QStringLiteral("work.fenestra"));
    return SessionQuestions::Answer::Save;
  };
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  ASSERT_TRUE(window_->sessions().startRecovery(kept));
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(document().look(), look);
  EXPECT_EQ(cameras().pose(), pose);
  EXPECT_EQ(controller().file(), file_) << "the restored work belongs to that file";
  EXPECT_TRUE(window_->isWindowModified());
  EXPECT_EQ(copies(), 1) << "until it is saved";
  save(controller().file());
  EXPECT_EQ(copies(), 0);
  EXPECT_EQ(io::readSession(file_).look.focus, look.focus);
  EXPECT_TRUE(io::readSession(file_).autosaveOf.empty());
}

TEST_F(SessionWindow, ACopyDoesNotStopTheWindow) {
  BrushStrokes strokes(2000);
  for (BrushStroke& stroke : strokes) stroke.anchors.assign(50, markerCentre);
  document().setStrokes(strokes, QStringLiteral("Brush"));
  controller().startAutosave(folder_ / "state", 3600000);
  const auto cpu = [] {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
  };
  const double before = cpu();
  controller().autosave();
  const double milliseconds = cpu() - before;
  controller().waitUntilSaved();
  RecordProperty("gather_ms", std::to_string(milliseconds));
  // 2000 strokes of 50 points are hours of painting; a frame at 60 Hz is 16 ms.
  EXPECT_LT(milliseconds, 16.0);
}

TEST_F(SessionWindow, ABrokenSessionIsOneNoticeAndNothingElse) {
  cameras().orbit(0, 0.1, 0.0);
  tests::writeFile(file_, "{\"format\": \"fenestra-session\", ");
  QSignalSpy failed(window_.get(), &MainWindow::failed);
  window_->open({file_});
  ASSERT_TRUE(failed.wait(patience));
  EXPECT_EQ(window_->notices().texts().size(), 1);
  EXPECT_TRUE(document().hasVolume());
  EXPECT_TRUE(controller().file().empty());
}

}  // namespace
}  // namespace fenestra::viewer::sessionSafetyTest
