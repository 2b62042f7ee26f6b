// Nothing of a study outlives it on screen: another study, a session or a failing path over it, with readers and
// drivers as slow as they come.

#include <thread>

#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QScreen>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>

#include "io/VolumeWriter.h"
#include "io/session/SessionFile.h"
#include "tests/gui/FailingDriver.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/bars/StudyDialogs.h"
#include "viewer/files/Sessions.h"
#include "viewer/panels/CamerasPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/LabelList.h"

namespace fenestra::viewer::studyChangeTest {
namespace {

/// A study whose pictures, in all five views, show much of one pure colour: red, green or blue.
enum class Paint { Red, Blue };

io::Study painted(Paint paint) {
  io::Study study = markedBall();
  const glm::dvec3 colour = paint == Paint::Red ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
  auto labels = std::make_shared<LabelMap>();
  labels->grid = study.scene.labels->grid;
  labels->voxels = Voxels(ScalarType::UInt8, labels->grid.voxelCount());
  std::copy_n(study.scene.labels->voxels.data(), labels->voxels.byteCount(), labels->voxels.data());
  labels->labels = {{body, paint == Paint::Red ? "red body" : "blue body", colour}, {marker, "marker", colour}};
  study.scene.labels = labels;
  study.scene.look.context.function.nodes = {{-200.0, {colour, 0.0}}, {0.0, {colour, 1.0}}};
  study.scene.look.shading.specular = 0.0;
  study.scene.look.focus = LabelFocus{{body}};
  study.scene.look.cutaway.enabled = false;
  return study;
}

struct Seen {
  int red = 0, blue = 0;
};

/// Pixels of a study's colour: tinted slices are dark, so the hue counts, and the pens of the marks are left out.
Seen seenIn(const QImage& image) {
  Seen seen;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const QRgb pixel = image.pixel(x, y);
      const int red = qRed(pixel), green = qGreen(pixel), blue = qBlue(pixel);
      seen.red += red > green + 40 && red > blue + 40 && std::abs(green - blue) < 12;
      seen.blue += blue > green + 40 && blue > red + 40 && std::abs(green - red) < 12;
    }
  return seen;
}

class StudyChange : public Window {
 protected:
  static constexpr int many = 1500;  ///< pixels; crosshair and letters have fewer

  void SetUp() override {
    makeWindow();
    if (HasFatalFailure()) return;
    options().setCrosshair(false);
    open(painted(Paint::Red));
    for (QWidget* view : allViews()) ASSERT_GT(seenIn(picture(view)).red, many) << view->objectName().toStdString();
  }

  std::vector<QWidget*> allViews() {
    std::vector<QWidget*> all;
    for (VolumeView* view : views().volumeViews()) all.push_back(view);
    for (SliceView* view : views().sliceViews()) all.push_back(view);
    return all;
  }

  /// What the screen shows of the window: its own pixels, whatever the widgets would paint now.
  QImage onScreen() {
    const QPoint at = window_->mapToGlobal(QPoint(0, 0));
    return window_->screen()->grabWindow(0, at.x(), at.y(), window_->width(), window_->height()).toImage();
  }

  /// Runs the event loop until all is drawn. At each step the screen shows nothing of A in any view as soon as it shows
  /// something of B in one, and a view that would be painted now shows nothing of A once B is open.
  void watch(const std::function<bool()>& isDone) {
    bool drawn = false, asked = false;
    QElapsedTimer time;
    time.start();
    while (!drawn && time.elapsed() < patience) {
      QCoreApplication::processEvents(QEventLoop::AllEvents, 1);
      if (isOpen_) {
        const QImage now = window_->picture(), shown = onScreen();
        bool showsB = false;
        int red = 0;
        for (QWidget* view : allViews()) {
          ASSERT_LT(seenIn(partOf(now, view)).red, many) << view->objectName().toStdString() << " would show A";
          const Seen seen = seenIn(partOf(shown, view));
          showsB |= seen.blue > many;
          red = std::max(red, seen.red);
        }
        ASSERT_FALSE(showsB && red > many) << "A beside B";
        ++looks_;
      }
      if (isDone() && !asked) {
        asked = true;
        window_->whenDrawn([&] { drawn = true; });
      }
    }
    ASSERT_TRUE(drawn);
  }

  void follow(std::function<void()> begin) {
    const auto seen =
        QObject::connect(&document(), &Document::volumeChanged, window_.get(), [this] { isOpen_ = true; });
    begin();
    watch([this] { return isOpen_; });
    QObject::disconnect(seen);
    for (QWidget* view : allViews()) EXPECT_GT(seenIn(picture(view)).blue, many) << view->objectName().toStdString();
    EXPECT_GT(looks_, 3);
  }
  /// A session of a blue study, with its volume beside it.
  static std::filesystem::path writeBlueSession() {
    const std::filesystem::path folder = tests::scratchFolder(), file = folder / "blue.fenestra";
    const io::Study blue = painted(Paint::Blue);
    io::writeVolume(*blue.scene.volume, folder / "ball.nii.gz");
    io::Session session = blue.session;
    session.volume.path = folder / "ball.nii.gz";
    session.look = blue.scene.look;
    session.look.focus = ValueFocus{{-100.0, 2000.0}, 0.0};
    session.look.focusAppearance.colour = {0.0, 0.0, 1.0};
    io::writeSession(file, session);
    return file;
  }
  StudyLoader::Reader slowly(const io::Study& study) {
    return [study](const io::Progress& progress) {
      for (int step = 0; step < 40 && progress(step / 40.0, "reading slowly"); ++step)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      return study;
    };
  }

  bool isOpen_ = false;
  int looks_ = 0;
};

TEST_F(StudyChange, AStudyOverAStudy) {
  follow([this] { window_->open([](const io::Progress&) { return painted(Paint::Blue); }); });
}

TEST_F(StudyChange, AStudyByASlowReader) {
  follow([this] { window_->open(slowly(painted(Paint::Blue))); });
}

TEST_F(StudyChange, AStudyByASlowDriver) {
  const SlowDriver driver;
  int blank = 0;
  const auto seen = QObject::connect(&document(), &Document::volumeChanged, window_.get(), [&] {
    for (VolumeView* view : views().volumeViews()) blank += view->hasPicture() ? 0 : 1;
  });
  follow([this] { window_->open([](const io::Progress&) { return painted(Paint::Blue); }); });
  QObject::disconnect(seen);
  EXPECT_EQ(blank, 2) << "both views are blank from the first moment on";
}

TEST_F(StudyChange, Thorough_ASessionOverAStudy) {
  follow([&] { window_->open(std::vector{writeBlueSession()}); });
}

TEST_F(StudyChange, Thorough_ASessionByASlowReaderAndASlowDriver) {
  const std::filesystem::path file = writeBlueSession();
  const SlowDriver driver;
  follow([&] {
    window_->sessions().open([file] {
      std::this_thread::sleep_for(std::chrono::milliseconds(800));
      return io::requestOfSession(file);
    });
  });
}

TEST_F(StudyChange, AFailingPathLeavesAllOfItAndSaysSo) {
  std::vector<QImage> before;
  for (QWidget* view : allViews()) before.push_back(picture(view));
  const auto volume = document().scene().volume;
  const std::filesystem::path folder = tests::scratchFolder() / "empty";
  std::filesystem::create_directories(folder);
  QSignalSpy failed(window_.get(), &MainWindow::failed);
  for (int notice = 0; notice < 5; ++notice)
    window_->notices().add(NoticeBar::Kind::Warning, NoticeBar::Subject::Study, QString::number(notice));
  window_->open(std::vector{folder});
  ASSERT_TRUE(failed.wait(patience));
  waitUntilDrawn();
  const QString error = window_->notices().texts().front();
  EXPECT_TRUE(error.contains(QStringLiteral("empty"))) << error.toStdString();
  const auto labels = window_->notices().findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(),
                          [&](const QLabel* label) { return label->isVisible() && label->text() == error; }));
  EXPECT_EQ(document().scene().volume, volume);
  for (QWidget* view : allViews()) EXPECT_GT(seenIn(picture(view)).red, many) << view->objectName().toStdString();
  open(painted(Paint::Blue));
  EXPECT_TRUE(window_->notices().texts().isEmpty()) << "what failed has succeeded";
}

TEST_F(StudyChange, WhatSaysSomethingOfTheStudyGoesWithIt) {
  document().setMeasures(
      {Measure{.kind = MeasureKind::Distance, .points = {glm::dvec3(0.0), glm::dvec3(10.0, 0.0, 0.0)}}},
      QStringLiteral("Distance"));
  document().setFocus(LabelFocus{{marker}});
  ASSERT_TRUE(document().undoStack().canUndo());
  placement().placeAutomatically();
  waitUntilDrawn();
  ASSERT_NE(placement().measured(), nullptr);
  views().pointed(markerCentre);
  window_->statusBar()->showMessage(QStringLiteral("of A"), 100000);
  auto* filter = panel<FocusPanel>().findChild<QLineEdit*>();
  ASSERT_NE(filter, nullptr);
  filter->setText(QStringLiteral("mark"));
  QDialog dialog(window_.get());
  markAsStudyDialog(dialog);
  dialog.show();
  const QString red = QStringLiteral("red");

  bool isOpen = false;
  const auto seen = QObject::connect(window_.get(), &MainWindow::opened, window_.get(), [&] {
    isOpen = true;  // within the event that opened it
    EXPECT_TRUE(document().measures().empty());
    EXPECT_FALSE(document().undoStack().canUndo());
    EXPECT_EQ(placement().measured(), nullptr);
    EXPECT_TRUE(placement().best(4).empty());
    EXPECT_TRUE(window_->statusBar()->currentMessage().isEmpty());
    EXPECT_TRUE(filter->text().isEmpty());
    EXPECT_FALSE(dialog.isVisible());
    for (const QLabel* label : window_->statusBar()->findChildren<QLabel*>())
      EXPECT_FALSE(label->text().contains(red)) << label->text().toStdString();
    for (int row = 0; row < panel<FocusPanel>().list()->model()->rowCount(); ++row)
      EXPECT_FALSE(panel<FocusPanel>().list()->model()->index(row, 0).data().toString().contains(red));
    for (QToolButton* thumbnail : window_->findChildren<QToolButton*>(QStringLiteral("thumbnail")))
      EXPECT_TRUE(thumbnail->icon().isNull());
  });
  open(painted(Paint::Blue));
  QObject::disconnect(seen);
  EXPECT_TRUE(isOpen);
}

TEST_F(StudyChange, ADoubleClickBringsBackNothingOfTheStudyBefore) {
  SliceView* axial = slice(SlicePlane::Axial);
  QTest::mouseClick(axial, Qt::LeftButton, {}, axial->rect().center());
  open(painted(Paint::Blue));
  const Focus focus = document().focus();
  const glm::dvec3 at = cursor().position();
  QTest::mouseDClick(axial, Qt::LeftButton, {}, axial->rect().center());
  EXPECT_EQ(document().focus(), focus);
  EXPECT_EQ(cursor().position(), at);
}

TEST_F(StudyChange, AStudyWithARegionOpensAtItsSeed) {
  const glm::dvec3 seed = markerCentre + glm::dvec3(4.0, -2.0, 0.0);
  io::Study study = markedBall();
  study.scene.labels = nullptr;
  study.scene.look.focus = RegionFocus{{seed}, {}, {}};
  open(study);
  EXPECT_EQ(cursor().position(), seed);
}

}  // namespace
}  // namespace fenestra::viewer::studyChangeTest
