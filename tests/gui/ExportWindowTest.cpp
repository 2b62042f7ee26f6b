// Segmentations beside a series, offered by name, and what the window writes.

#include <fstream>

#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTest>

#include "io/LabelReader.h"
#include "io/study/ReadStudy.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/exports/Exports.h"

namespace fenestra::viewer::exportWindowTest {
namespace {

namespace fs = std::filesystem;

/// The entry of the menu bar's File menu, or of a menu in it.
QAction* fileEntry(MainWindow& window, const QString& text, const QString& submenu = {}) {
  QMenu* menu = window.menuBar()->actions().front()->menu();
  for (QAction* each : menu->actions())
    if (!submenu.isEmpty() && each->menu() && each->text().remove(QLatin1Char('&')) == submenu) menu = each->menu();
  for (QAction* each : menu->actions())
    if (each->text().remove(QLatin1Char('&')).startsWith(text)) return each;
  return nullptr;
}

/// Three slices of 5 x 3 pixels and a segmentation of them.
fs::path seriesWithSegmentation() {
  const fs::path folder = tests::scratchFolder() / "series";
  fs::create_directory(folder);
  for (int i = 0; i < 3; ++i) {
    tests::DicomSpec slice;
    slice.columns = 5;
    slice.rows = 3;
    slice.instance = "1.2.3.4." + std::to_string(i);
    slice.position = glm::dvec3(0, 0, i);
    tests::writeDicom(folder / ("slice" + std::to_string(i)), slice);
  }
  tests::SegSpec spec;
  spec.segments = {{1, "Leber", {}}, {2, "Niere", {}}};
  spec.frames = {{1, glm::dvec3(0, 0, 1), {0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
                 {2, glm::dvec3(0, 0, 2), {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0}}};
  tests::writeSeg(folder / "seg.dcm", spec);
  return folder;
}

TEST_F(Window, SegmentationsOfTheSeriesAreOfferedByName) {
  QAction* menu = fileEntry(*window_, QStringLiteral("Segmentations"));
  ASSERT_TRUE(menu);
  EXPECT_FALSE(menu->isVisible());
  const fs::path folder = seriesWithSegmentation();
  io::StudyRequest request;
  request.path = folder;
  open(io::readStudy(request));
  EXPECT_TRUE(menu->isVisible());
  ASSERT_EQ(menu->menu()->actions().size(), 1);
  EXPECT_EQ(menu->menu()->actions().front()->text(), QStringLiteral("made up (SEG): Leber, Niere"));
  const QStringList notices = window_->notices().texts();
  EXPECT_TRUE(std::any_of(notices.begin(), notices.end(),
                          [](const QString& text) { return text.contains(QStringLiteral("Leber, Niere")); }));
  ASSERT_FALSE(document().scene().labels);
  menu->menu()->actions().front()->trigger();
  ASSERT_TRUE(QTest::qWaitFor([&] { return document().scene().labels != nullptr; }, patience))
      << window_->notices().texts().join(QLatin1Char('\n')).toStdString();
  EXPECT_EQ(document().scene().labels->value({1, 0, 1}), 1);
  EXPECT_EQ(document().scene().labels->find(2)->name, "Niere");
}

TEST_F(Window, ExportsWhatIsShown) {
  setAutomatic(false);
  open(markedBall());
  Exports& exports = window_->exports();
  QAction* surface = fileEntry(*window_, QStringLiteral("The focus as a surface"), QStringLiteral("Export"));
  ASSERT_TRUE(surface);
  document().setFocus(std::monostate{});
  EXPECT_FALSE(surface->isEnabled());
  EXPECT_FALSE(exports.canWriteLabels(Exports::Labels::Focus));
  EXPECT_TRUE(exports.canWriteLabels(Exports::Labels::All));
  document().focusOn(marker);
  EXPECT_TRUE(surface->isEnabled());

  const fs::path folder = tests::scratchFolder();
  const auto finished = [&] { return QTest::qWaitFor([&] { return !exports.job().isRunning(); }, patience); };
  exports.writeSurface(folder / "marker.stl", io::SurfaceFrame::Lps);
  ASSERT_TRUE(finished());
  EXPECT_GT(fs::file_size(folder / "marker.stl"), 84u);
  exports.writeLabels(folder / "marker.nrrd", Exports::Labels::Focus);
  ASSERT_TRUE(finished());
  const Grid& grid = document().scene().volume->grid;
  const auto focus = io::openLabels(folder / "marker.nrrd", grid).labels;
  ASSERT_EQ(focus->labels.size(), 1u);
  EXPECT_EQ(focus->labels[0].value, marker);
  exports.writeLabels(folder / "all.dcm", Exports::Labels::All);
  ASSERT_TRUE(finished());
  EXPECT_EQ(io::openLabels(folder / "all.dcm", grid).labels->labels.size(), 2u);

  exports.writeSurface(folder / "no" / "marker.stl", io::SurfaceFrame::Lps);
  ASSERT_TRUE(finished());
  const QStringList notices = window_->notices().texts();
  EXPECT_TRUE(std::any_of(notices.begin(), notices.end(),
                          [](const QString& text) { return text.contains(QStringLiteral("cannot be written")); }));
}

}  // namespace
}  // namespace fenestra::viewer::exportWindowTest
