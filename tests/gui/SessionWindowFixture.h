#pragma once
// A window whose study comes from files, for tests of sessions.

#include <QProcess>
#include <QSignalSpy>
#include <QTest>

#include "io/VolumeWriter.h"
#include "io/session/SessionFile.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/RegionPanel.h"

namespace fenestra::viewer {

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
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), patience));
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

}  // namespace fenestra::viewer
