// The window answers while it reads a long series, makes thumbnails and exports a turntable, which can be cancelled,
// and while a transfer function is dragged and presets are shown.

#include <QDockWidget>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include "io/VolumeReader.h"
#include "tests/gui/TimedApplication.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/exports/PictureExports.h"
#include "viewer/files/FileOpener.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/SeriesPanel.h"

namespace fenestra::viewer::longTasksTest {
namespace {

namespace fs = std::filesystem;

/// A ball of soft tissue in air, `slices` files of side² pixels, 300 mm wide.
void writeBall(const fs::path& folder, int side, int slices, const std::string& series) {
  fs::create_directories(folder);
  tests::DicomSpec spec;
  spec.series = series;
  spec.columns = spec.rows = side;
  const double spacing = 300.0 / side, between = 300.0 / slices;
  spec.pixelSpacing = std::to_string(spacing) + "\\" + std::to_string(spacing);
  for (int k = 0; k < slices; ++k) {
    spec.instance = series + "." + std::to_string(k + 1);
    spec.instanceNumber = k + 1;
    spec.position = glm::dvec3(0, 0, between * k);
    spec.words.clear();
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        const glm::dvec3 at = glm::dvec3(i * spacing, j * spacing, k * between) - 150.0;
        const int value = glm::length(at) < 110.0 ? 40 + (i * 7 + j * 13 + k * 5) % 17 : -1000;
        spec.words.push_back(static_cast<std::uint32_t>(value) & 0xFFFFU);
      }
    tests::writeDicom(folder / (std::to_string(k) + ".dcm"), spec);
  }
}

TimedApplication& application() { return static_cast<TimedApplication&>(*qApp); }

}  // namespace

class LongTasks : public Window {
 protected:
  /// The longest block of the GUI thread while `task` runs, in ms: the least of up to three runs, because another
  /// program may hold a processor for longer than any event takes. A task that really blocks does so in every run.
  template <class Task>
  double longestBlock(const Task& task) {
    constexpr int runs = 3;
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs && least > allowed; ++run) {
      application().takeBlocks();
      task();
      const TimedApplication::Blocks blocks = application().takeBlocks();
      least = std::min(least, blocks.longest);
      if (blocks.longest > allowed)
        std::cout << blocks.event << ": " << blocks.longest << " ms, " << blocks.ownTime << " of them at work\n";
    }
    return least;
  }

  void openFolder(const fs::path& folder) {
    QSignalSpy opened(window_.get(), &MainWindow::opened);
    window_->findChild<FileOpener*>()->open({folder});
    ASSERT_TRUE(opened.wait(patience)) << window_->notices().texts().join(QLatin1Char('\n')).toStdString();
    waitUntilDrawn();
  }

  static constexpr double allowed = 100.0;  ///< ms
  const fs::path folder_ = tests::scratchFolder();
};

TEST_F(LongTasks, ThreeHundredSlicesAreReadWhileTheWindowAnswers) {
  for (int run = 0; run < 3; ++run)  // a folder for each run: what is open would not be read again
    writeBall(folder_ / std::to_string(run), 256, 300, "1.2.3." + std::to_string(run + 1));
  int next = 0;
  EXPECT_LE(longestBlock([&] { openFolder(folder_ / std::to_string(next++)); }), allowed);
  EXPECT_EQ(document().scene().volume->grid.dims, glm::ivec3(256, 256, 300));
}

TEST_F(LongTasks, ThumbnailsAreMadeWhileTheWindowAnswers) {
  for (int series = 0; series < 6; ++series)
    writeBall(folder_ / std::to_string(series), 256, 40, "1.2.4." + std::to_string(series + 1));
  openFolder(folder_);
  ASSERT_EQ(document().study().otherSeries.size(), 5);
  auto* panel = window_->findChild<SeriesPanel*>();
  EXPECT_LE(longestBlock([&] {
              window_->findChild<QDockWidget*>(QStringLiteral("seriesDock"))->show();
              const auto hasPicture = [&](std::size_t row) {  // the place is held by a transparent one
                const QIcon icon = panel->rows()[row]->icon(0);
                const QImage picture = icon.pixmap(panel->list()->iconSize()).toImage();
                return picture.pixelColor(picture.rect().center()).alpha() > 0;
              };
              ASSERT_EQ(panel->rows().size(), 6);
              for (std::size_t row = 0; row < 6; ++row)
                ASSERT_TRUE(QTest::qWaitFor([&] { return hasPicture(row); }, patience)) << row;
            }),
            allowed);
}

TEST_F(LongTasks, ATurntableIsExportedWhileTheWindowAnswers) {
  document().focusOn(marker);
  waitUntilDrawn();
  window_->pictures().writeTurntable(folder_ / "first.png", {.volumes = views().volumeViews()}, 1, 24);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window_->pictures().isBusy(); }, patience));  // shaders are compiled now
  EXPECT_LE(longestBlock([&] {
              window_->pictures().writeTurntable(folder_ / "turn.png", {.volumes = views().volumeViews(), .scale = 2.0},
                                                 6, 24);
              ASSERT_TRUE(QTest::qWaitFor([&] { return !window_->pictures().isBusy(); }, 3 * patience));
            }),
            allowed);
}

/// Time in the events of a drag themselves. The pictures that follow are paced by FramePacer; window-bench measures
/// them.
TEST_F(LongTasks, ATransferFunctionIsDraggedWhileTheWindowAnswers) {
  writeBall(folder_ / "a", 256, 300, "1.2.5.1");
  openFolder(folder_ / "a");
  TransferFunctionPlot& plot = panel<AppearancePanel>().editor().plot();
  const TransferFunction::Node node = plot.function().nodes.at(0);
  const QPoint from = plot.place(node.value, opacityFromExtinction(node.properties.extinction)).toPoint();
  const TransferFunction before = plot.function();
  EXPECT_LE(longestBlock([&] {
              drag(&plot, from, from + QPoint(-30, -30));
              EXPECT_NE(plot.function(), before);
              document().undoStack().undo();
            }),
            allowed);
}

TEST_F(LongTasks, PicturesOfPresetsAreDrawnWhileTheWindowAnswers) {
  for (int run = 0; run < 3; ++run)  // a volume for each run: its pictures are kept
    writeBall(folder_ / std::to_string(run), 256, 300, "1.2.6." + std::to_string(run + 1));
  PresetPicker& presets = panel<AppearancePanel>().presets();
  int next = 0;
  openFolder(folder_ / std::to_string(next++));
  EXPECT_LE(longestBlock([&] {
              presets.box()->showPopup();
              ASSERT_TRUE(QTest::qWaitFor([&] { return presets.hasAllPictures(); }, patience));
              presets.box()->hidePopup();
              if (next < 3) openFolder(folder_ / std::to_string(next++));
            }),
            allowed);
}

}  // namespace fenestra::viewer::longTasksTest
