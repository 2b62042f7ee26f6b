// Sessions in the window: a saved session comes back bit for bit, including its pictures, and the command line draws
// the same; the window asks before it drops unsaved work and offers to restore it after a crash.

#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#include <fstream>

#include <QApplication>
#include <QDropEvent>
#include <QLockFile>
#include <QMimeData>
#include <QProcess>
#include <QSignalSpy>
#include <QTest>
#include <QUrl>

#include "io/VolumeWriter.h"
#include "io/session/SessionFile.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/LabelEditPanel.h"
#include "viewer/panels/RegionPanel.h"

namespace fenestra::viewer {
namespace {

namespace fs = std::filesystem;
using tests::readFile;

/// A window on the marked ball from files, in a folder of its own.
class SessionWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    if (HasFatalFailure()) return;
    folder_ = tests::scratchFolder();
    file_ = folder_ / "work.fenestra";
    fs::create_directory(folder_ / "data");
    const io::Study ball = markedBall();
    io::writeVolume(*ball.scene.volume, folder_ / "data" / "ball.nii.gz");
    Volume labels;
    labels.grid = ball.scene.labels->grid;
    labels.voxels = Voxels(ScalarType::UInt8, labels.grid.voxelCount());
    std::copy_n(ball.scene.labels->voxels.data(), labels.voxels.byteCount(), labels.voxels.data());
    io::writeVolume(labels, folder_ / "data" / "labels.nii.gz");
    failOnQuestions();
    open(folder_ / "data" / "ball.nii.gz", folder_ / "data" / "labels.nii.gz");
  }

  /// A question that a test does not expect fails the test instead of showing a dialog that waits for ever.
  void failOnQuestions() {
    SessionQuestions& questions = window_->sessions().questions();
    questions.saveChanges = [](const QStringList&) {
      return ADD_FAILURE() << "asked to save", SessionQuestions::Answer::Discard;
    };
    questions.saveWhere = [](const fs::path&) { return ADD_FAILURE() << "asked where", std::nullopt; };
    questions.dataWhere = [](const io::DataMissing& missing) { return ADD_FAILURE() << missing.what(), std::nullopt; };
    questions.restoreWork = [](const QDateTime&, const QString&) {
      return ADD_FAILURE() << "asked to restore", SessionQuestions::Answer::Cancel;
    };
  }

  void open(const fs::path& path, const fs::path& labels = {}) {
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    window_->open(labels.empty() ? std::vector{path} : std::vector{path, labels});
    ASSERT_TRUE(opened.count() > 0 || opened.wait(patience))
        << window_->notices().texts().join(QStringLiteral("; ")).toStdString();
    waitUntilDrawn();
  }

  /// Another window of the same size, as after a restart.
  void restart() {
    const QSize size = window_->size();
    window_.reset();
    window_ = std::make_unique<MainWindow>(MainWindow::Setup{.gl = gl_, .atRest = Effort{}, .remember = false});
    window_->resize(size);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    failOnQuestions();
  }

  SessionController& controller() { return window_->sessions().controller(); }
  void save(const fs::path& file) {
    controller().save(file);
    ASSERT_TRUE(controller().waitUntilSaved());
  }

  /// Changes every kind of thing that a session keeps.
  void work() {
    document().focusOn(marker);
    document().setPreset("ct-soft-tissue");
    document().setShift(-31.7);
    Look look = document().look();
    look.cutaway.openWidth = 17.3;
    look.cutaway.unit = WidthUnit::Millimetre;
    look.contextLayer.strength = 0.9;
    document().edit(QStringLiteral("Look"), look);
    BrushStroke stroke;
    stroke.anchors = {{10.0, -40.0, 10.0}, {20.0, -36.0, 10.1}};
    stroke.radius = 9.1;
    document().setStrokes({stroke}, QStringLiteral("Brush"));
    document().setWindow({333.0, 22.0});
    cursor().moveTo({3.25, -7.5, 11.125});
    cameras().orbit(0, 0.4, 0.2);
    cameras().zoom(1, 1.3);
    waitUntilDrawn();
  }

  std::vector<QImage> pictures() {
    std::vector<QImage> made;
    for (VolumeView* view : views().volumeViews()) made.push_back(picture(view));
    for (SliceView* view : views().sliceViews()) made.push_back(picture(view));
    return made;
  }

  /// The saved session gives the window's pictures on the command line.
  void expectCommandLineAgrees() {
    for (int index = 0; index < 2; ++index) {
      const QString png = toQString(folder_ / "cli.png");
      ASSERT_EQ(QProcess::execute(QStringLiteral(FENESTRA_CLI),
                                  {QStringLiteral("render"), toQString(file_), QStringLiteral("--view"),
                                   QStringLiteral("C%1").arg(index + 1), QStringLiteral("-o"), png}),
                0);
      const QImage cli = QImage(png).convertToFormat(QImage::Format_RGB32);
      options().setText(false);
      options().setCrosshair(false);
      waitUntilDrawn();
      VolumeView* view = volume(static_cast<std::size_t>(index));
      const QImage window = view->grabSurface().convertToFormat(QImage::Format_RGB32);
      ASSERT_EQ(cli.size(), window.size());
      const double ratio = window_->devicePixelRatioF();
      int greatest = 0;
      for (int y = 0; y < cli.height(); ++y)
        for (int x = 0; x < cli.width(); ++x) {
          // What the window draws over the picture: the orientation cube, the chip, and a frame around the view in use.
          const double fromLeft = x / ratio, fromTop = y / ratio, fromBottom = (cli.height() - y) / ratio;
          if (fromLeft < 80 && fromBottom < 80) continue;
          if (fromLeft < 28 && fromTop < 28) continue;
          if (std::min({x, y, cli.width() - 1 - x, cli.height() - 1 - y}) < 2 * ratio) continue;
          const QColor a = cli.pixelColor(x, y), b = window.pixelColor(x, y);
          greatest = std::max(
              {greatest, std::abs(a.red() - b.red()), std::abs(a.green() - b.green()), std::abs(a.blue() - b.blue())});
        }
      // The command line rounds once more when it puts the picture over the background.
      EXPECT_LE(greatest, 1) << "C" << index + 1;
    }
  }

  /// A region grown from the marker on the axial slice, by mouse.
  void grow() {
    options().setGrows(true);
    document().setLabels(nullptr);
    cursor().moveTo(markerCentre);
    SliceView* axial = slice(SlicePlane::Axial);
    QTest::mouseClick(axial, Qt::LeftButton, {}, axial->widgetFromWorld(markerCentre).toPoint());
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
    waitUntilDrawn();
  }
  std::vector<std::uint16_t> labelValues() {
    std::vector<std::uint16_t> all;
    if (document().labels())
      document().labels()->voxels.visit([&](auto values) { all.assign(values.begin(), values.end()); });
    return all;
  }
  void keepRegion(const QString& name) {
    auto& region = *panel<FocusPanel>().region();
    region.name()->setText(name);
    QTest::mouseClick(region.keep(), Qt::LeftButton);
    ASSERT_TRUE(QTest::qWaitFor([&] { return document().labels() != nullptr; }, patience));
    waitUntilDrawn();
  }

  fs::path folder_, file_;
};

TEST_F(SessionWindow, SavedAndReopenedShowsTheSamePictures) {
  work();
  const std::vector<QImage> before = pictures();
  save(file_);
  const Look look = document().look();
  restart();
  open(file_);
  EXPECT_EQ(document().look(), look);
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_TRUE(window_->notices().texts().isEmpty())
      << window_->notices().texts().join(QStringLiteral("; ")).toStdString();
  const std::vector<QImage> after = pictures();
  for (std::size_t view = 0; view < before.size(); ++view) EXPECT_EQ(before[view], after[view]) << "view " << view;
  save(folder_ / "again.fenestra");
  EXPECT_EQ(readFile(file_), readFile(folder_ / "again.fenestra"));
}

TEST_F(SessionWindow, KeepsAPaintedRegion) {
  Look look = document().look();
  look.method.kind = kindOf<methods::Selection>;
  document().edit(QStringLiteral("method"), std::move(look));
  cursor().moveTo(glm::dvec3(0.0));
  SelectionBrush& brush = window_->workspace().selection;
  brush.setSettings({.radius = 7.5, .softness = 0.4});
  brush.setActive(true);
  SliceView* axial = slice(SlicePlane::Axial);
  const auto at = [&](double x) { return axial->widgetFromWorld({x, 0.0, 0.0}).toPoint(); };
  drag(axial, at(-15.0), at(15.0));
  drag(axial, at(0.0), at(1.0), Qt::LeftButton, Qt::ShiftModifier);
  brush.setActive(false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  waitUntilDrawn();
  ASSERT_EQ(document().region()->painted.size(), 2u);
  const RegionFocus painted = *document().region();
  EXPECT_EQ(painted.painted.front().softness, 0.4);
  const std::vector<QImage> before = pictures();
  save(file_);
  restart();
  open(file_);
  ASSERT_TRUE(document().region());
  EXPECT_EQ(*document().region(), painted);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  waitUntilDrawn();
  const std::vector<QImage> after = pictures();
  for (std::size_t view = 0; view < before.size(); ++view) EXPECT_EQ(before[view], after[view]) << "view " << view;
}

TEST_F(SessionWindow, ASessionEntersTheDocumentOnce) {
  work();
  save(file_);
  restart();
  std::vector<std::unique_ptr<QSignalSpy>> spies;
  for (const auto signal : {&Document::volumeChanged, &Document::focusChanged, &Document::transferFunctionChanged,
                            &Document::cutawayChanged, &Document::shadingChanged, &Document::strokesChanged,
                            &Document::windowChanged, &Document::sceneChanged})
    spies.push_back(std::make_unique<QSignalSpy>(&document(), signal));
  open(file_);
  for (const auto& spy : spies) EXPECT_EQ(spy->count(), 1) << spy->signal().toStdString();
}

TEST_F(SessionWindow, TheCommandLineAgreesWithTheWindow) {
  work();
  save(file_);
  expectCommandLineAgrees();
}

TEST_F(SessionWindow, AFrozenOpeningStaysFrozenOnTheCommandLineToo) {
  work();
  QTest::keyClick(window_.get(), Qt::Key_F);
  cameras().orbit(0, 0.4, 0.1);
  waitUntilDrawn();
  ASSERT_TRUE(cameras().isFrozen());
  const ViewLink::Frozen frozen = cameras().frozen();
  save(file_);
  expectCommandLineAgrees();
  restart();
  open(file_);
  EXPECT_EQ(cameras().frozen(), frozen);
}

TEST_F(SessionWindow, TheQualitySphereIsFilledAndTheCamerasStay) {
  setAutomatic(true);
  document().focusOn(marker);
  ASSERT_TRUE(QTest::qWaitFor([&] { return placement().measured() && !cameras().isFlying(); }, patience));
  waitUntilDrawn();
  const ViewLink::Pair where = cameras().pose().cameras;
  save(file_);
  restart();
  open(file_);
  ASSERT_TRUE(QTest::qWaitFor([&] { return placement().measured() != nullptr; }, patience));
  EXPECT_EQ(cameras().pose().cameras, where);
  EXPECT_FALSE(window_->isWindowModified());
}

TEST_F(SessionWindow, LinkedCamerasStayLinkedAndUnlinkedOnesDoNot) {
  for (const bool linked : {false, true}) {
    cameras().setLinked(linked);
    cameras().orbit(0, 0.3, 0.1);
    save(file_);
    cameras().setLinked(!linked);
    open(file_);
    EXPECT_EQ(cameras().isLinked(), linked);
    EXPECT_EQ(window_->findChild<QAction*>(QStringLiteral("link"))->isChecked(), linked);
    PlacementSettings settings = placement().settings();
    settings.follow = false;
    placement().setSettings(settings);
    const Camera partner = cameras().camera(1);
    drag(volume(0), {200, 150}, {260, 150});
    EXPECT_EQ(cameras().camera(1) != partner, linked);
  }
}

TEST_F(SessionWindow, CamerasStandWhereTheyStood) {
  cameras().setProjection(Projection::Orthographic);
  cameras().orbit(0, 1.1, -0.6);
  cameras().pan(1, 13.7, -4.2);
  cameras().zoom(0, 1.7);
  const ViewLink::Pose pose = cameras().pose();
  save(file_);
  cameras().place(Camera::standard(StandardView::Posterior, document().scene().volume->grid));
  ASSERT_NE(cameras().pose(), pose);
  open(file_);
  EXPECT_EQ(cameras().pose(), pose);
  cameras().reset();
  EXPECT_EQ(cameras().pose().cameras, pose.home);
}

TEST_F(SessionWindow, KeepsTheLayoutAndWhatIsDrawnOverThePictures) {
  views().toggleMaximised(slice(SlicePlane::Coronal));
  options().setText(false);
  options().setLabels(false);
  PlacementSettings settings = placement().settings();
  settings.sampling.count = 48;
  settings.options.weights.coverage = 2.5;
  settings.options.region = placement::Region::Stream;
  placement().setSettings(settings);
  save(file_);
  views().showAll();
  options().setText(true);
  placement().setSettings({});
  open(file_);
  EXPECT_TRUE(views().isMaximised());
  EXPECT_TRUE(slice(SlicePlane::Coronal)->isVisible());
  EXPECT_FALSE(volume(0)->isVisible());
  EXPECT_FALSE(options().text());
  EXPECT_TRUE(options().crosshair());
  EXPECT_EQ(placement().settings(), settings);
}

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

TEST_F(SessionWindow, AGrownRegionIsGrownAgain) {
  grow();
  document().addSeed({-20.0, 10.0, 17.0}, false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  document().setTolerance(77.7);
  waitUntilDrawn();
  const std::vector<QImage> before = pictures();
  const Look look = document().look();
  save(file_);
  expectCommandLineAgrees();
  restart();
  open(file_);
  EXPECT_EQ(document().look(), look);
  EXPECT_TRUE(document().isWhole()) << "it is grown before it shows";
  EXPECT_EQ(pictures(), before);
  EXPECT_FALSE(window_->isWindowModified());
}

TEST_F(SessionWindow, ARegionWithinABallIsGrownAgain) {
  options().setGrows(true);
  document().setLabels(nullptr);
  cursor().moveTo(markerCentre);
  SliceView* axial = slice(SlicePlane::Axial);
  const auto at = [&](double x) { return axial->widgetFromWorld(markerCentre + glm::dvec3(x, 0.0, 0.0)).toPoint(); };
  drag(axial, at(0.0), at(5.0), Qt::LeftButton, Qt::ShiftModifier);
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().isWhole(); }, patience));
  waitUntilDrawn();
  const RegionFocus region = *document().region();
  EXPECT_NEAR(region.ball, 5.0, 1.0);
  EXPECT_EQ(region.rule, RegionRule::Tissues);
  const double volume = document().regionVolume();
  const std::vector<QImage> before = pictures();
  save(file_);
  expectCommandLineAgrees();
  restart();
  open(file_);
  ASSERT_TRUE(document().region());
  EXPECT_EQ(*document().region(), region);
  EXPECT_EQ(document().regionVolume(), volume);
  EXPECT_EQ(pictures(), before);
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
}  // namespace fenestra::viewer
