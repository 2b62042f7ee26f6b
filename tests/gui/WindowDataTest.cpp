// Opening data in the window: its notices, and what it remembers.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>
#include <QUrl>

#include "io/TransferFunctionFile.h"
#include "io/VolumeWriter.h"
#include "io/study/ReadStudy.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/CamerasPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/LabelList.h"
#include "viewer/panels/SeriesPanel.h"

namespace fenestra::viewer::windowDataTest {
namespace {

TEST_F(Window, ABrokenFileIsToldAndTheOldStudyStays) {
  const std::filesystem::path broken = tests::scratchFolder() / "broken.nii";
  std::ofstream(broken) << "not a volume";
  document().focusOn(marker);
  document().undoStack().setClean();  // nothing unsaved to ask about
  const auto volumeBefore = document().scene().volume;
  QSignalSpy failed(window_.get(), &MainWindow::failed);
  window_->open(std::vector{broken});
  ASSERT_TRUE(failed.wait(patience));
  ASSERT_EQ(window_->notices().texts().size(), 1);
  EXPECT_TRUE(window_->notices().texts().front().contains(QStringLiteral("broken.nii")));
  EXPECT_EQ(document().scene().volume, volumeBefore);
  EXPECT_TRUE(document().isFocused(marker));
  waitUntilDrawn();
}

TEST_F(Window, DroppedFilesAreOpened) {
  auto half = std::make_shared<Volume>();
  half->grid = {.dims = {12, 10, 8}, .spacing = glm::dvec3(3.0)};
  half->voxels = Voxels(ScalarType::UInt8, half->grid.voxelCount());
  for (std::size_t i = 0; i < half->voxels.count(); ++i) half->voxels.as<std::uint8_t>()[i] = i % 12 < 6 ? 0 : 5;
  half->computeRange();
  const std::filesystem::path file = tests::scratchFolder() / "Größe 頭部.mha";
  io::writeVolume(*half, file);

  QMimeData files;
  files.setUrls({QUrl::fromLocalFile(toQString(file)), QUrl::fromLocalFile(toQString(file))});
  QDragEnterEvent enter(QPoint(400, 300), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(400, 300), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  QApplication::sendEvent(window_.get(), &drop);
  ASSERT_TRUE(opened.wait(patience));
  const Scene& scene = document().scene();
  EXPECT_EQ(scene.volume->grid.dims, half->grid.dims);
  ASSERT_NE(scene.labels, nullptr) << "the second file is the first one's label map";
  ASSERT_EQ(scene.labels->labels.size(), 1u);
  EXPECT_EQ(scene.labels->labels[0].value, 5);
  waitUntilDrawn();
}

TEST_F(Window, LabelsAreOpenedOverTheStudy) {
  auto marks = std::make_shared<Volume>();
  marks->grid = document().scene().volume->grid;
  marks->voxels = Voxels(ScalarType::UInt8, marks->grid.voxelCount());
  for (std::size_t i = 0; i < marks->voxels.count(); ++i) marks->voxels.as<std::uint8_t>()[i] = i % 48 < 24 ? 3 : 0;
  marks->computeRange();
  const std::filesystem::path file = tests::scratchFolder() / "labels.nrrd";
  io::writeVolume(*marks, file);
  document().focusOn(marker);
  QSignalSpy changed(&document(), &Document::labelsChanged);
  window_->openLabels(file);
  ASSERT_TRUE(changed.wait(patience));
  EXPECT_EQ(panel<FocusPanel>().list()->model()->rowCount(), 1);
  EXPECT_EQ(document().focus(), Focus()) << "the old labels are gone";
  waitUntilDrawn();
}

/// Triggers a menu's entry and chooses `path` in the dialog that it opens.
void chooseBy(const MainWindow& window, const char* text, const std::filesystem::path& path) {
  QAction* entry = nullptr;
  for (QAction* each : window.findChildren<QAction*>())
    if (each->text() == QString::fromUtf8(text)) entry = each;
  ASSERT_NE(entry, nullptr) << text;
  ASSERT_TRUE(entry->isEnabled()) << text;
  QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QTimer choose;
  QObject::connect(&choose, &QTimer::timeout, [&] {
    QWidget* modal = QApplication::activeModalWidget();
    if (auto* box = qobject_cast<QMessageBox*>(modal)) {
      ADD_FAILURE() << box->text().toStdString();
      box->reject();
    }
    auto* dialog = qobject_cast<QFileDialog*>(modal);
    if (!dialog) return;
    if (std::filesystem::is_directory(path))
      dialog->setDirectory(toQString(path));
    else  // selectFile() leaves the name alone while the user may be typing it
      dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(toQString(path));
    QMetaObject::invokeMethod(dialog, "accept");
  });
  choose.start(20);
  entry->trigger();
}

TEST_F(Window, TheFileMenuOpensAFolderOfMasksAndATableOfLabels) {
  const std::filesystem::path folder = tests::scratchFolder() / "masks", table = tests::scratchFolder() / "names.txt";
  std::filesystem::create_directories(folder);
  for (const char* name : {"liver.nii.gz", "spleen.nii.gz"}) {
    Volume mask;
    mask.grid = document().scene().volume->grid;
    mask.voxels = Voxels(ScalarType::UInt8, mask.grid.voxelCount());
    std::ranges::fill(mask.voxels.as<std::uint8_t>(), std::uint8_t{0});
    mask.voxels.as<std::uint8_t>()[name[0] == 'l' ? 0 : 1] = 1;
    io::writeVolume(mask, folder / name);
  }
  std::ofstream(table) << "1 Left lobe of the liver 200 100 50 0\n";
  const auto namesOf = [&] {
    std::vector<std::string> names;
    if (document().labels())
      for (const Label& label : document().labels()->labels) names.push_back(label.name);
    return names;
  };
  const auto become = [&](const std::vector<std::string>& names) {
    EXPECT_TRUE(QTest::qWaitFor([&] { return namesOf() == names; }, patience))
        << testing::PrintToString(namesOf()) << window_->notices().texts().join(QLatin1Char('|')).toStdString();
  };
  chooseBy(*window_, "Open a folder of &masks…", folder);
  become({"liver", "spleen"});
  chooseBy(*window_, "Open a &table of labels…", table);
  become({"Left lobe of the liver", "spleen"});
  EXPECT_EQ(document().study().session.labels.table, table) << "a session keeps it";
}

TEST_F(Window, RemembersLayoutAndRecentFilesOnlyWhenAsked) {
  useScratchSettings();
  const auto cutawayDock = [](MainWindow& window) {
    return window.findChild<QDockWidget*>(QStringLiteral("cutawayDock"));
  };
  MainWindow::Setup setup{.gl = {.problem = QStringLiteral("slices are enough here")}};
  const auto closeWithoutDock = [&] {
    MainWindow window(setup);
    window.show();
    cutawayDock(window)->hide();
    QSignalSpy opened(&window, &MainWindow::opened);
    window.open([](const io::Progress&) {
      io::Study study = markedBall();
      study.session.volume.path = "/data/scan.nii";
      return study;
    });
    EXPECT_TRUE(opened.wait(patience));
    window.close();
  };
  setup.remember = false;
  closeWithoutDock();
  EXPECT_TRUE(Preferences().recent().empty());
  setup.remember = true;
  closeWithoutDock();
  EXPECT_EQ(Preferences().recent(), std::vector<std::filesystem::path>{"/data/scan.nii"});
  MainWindow again(setup);
  again.show();
  EXPECT_FALSE(cutawayDock(again)->isVisible());
}

TEST_F(Window, RemembersHowTheUserPlacesCamerasNotHowASessionDoes) {
  useScratchSettings();
  QSettings().remove(QStringLiteral("placement"));
  MainWindow window({.gl = {.problem = QStringLiteral("slices are enough here")}});
  PlacementSettings settings;
  settings.options.weights.coverage = 3.0;
  window.workspace().placement.setSettings(settings);
  EXPECT_EQ(Preferences().placement(), PlacementSettings());
  window.findChild<PlacementForm*>()->joint()->click();
  PlacementSettings expected;
  expected.joint = settings.joint = false;
  EXPECT_EQ(Preferences().placement(), expected);
  EXPECT_EQ(window.workspace().placement.settings(), settings);
}

TEST_F(Window, WarningsAreShownOnceEach) {
  io::Study study = markedBall();
  study.warnings = {{io::Warning::Kind::UnevenSpacing, "slices are uneven", {"a.dcm", "b.dcm"}},
                    {io::Warning::Kind::UnevenSpacing, "slices are uneven", {"a.dcm", "b.dcm"}},
                    {io::Warning::Kind::GantryTilt, "the gantry was tilted", {}}};
  open(study);
  EXPECT_EQ(window_->notices().texts(),
            (QStringList{QStringLiteral("Slices are uneven."), QStringLiteral("The gantry was tilted.")}));
  open(markedBall());
  EXPECT_TRUE(window_->notices().texts().isEmpty());
}

TEST_F(Window, NoticesSpeakOfTheWindowAndNotOfTheCommandLine) {
  io::Study study = markedBall();
  study.warnings = {{io::Warning::Kind::TimePoints, "number 1 is shown", {}, io::WayOut::ChooseTime},
                    io::tableWarning()};
  open(study);
  const QString all = window_->notices().texts().join(QLatin1Char('\n'));
  EXPECT_FALSE(all.contains(QStringLiteral("--"))) << all.toStdString();
  EXPECT_TRUE(all.contains(QStringLiteral("Choose series")));
  EXPECT_TRUE(all.contains(QStringLiteral("Hide the table")));
}

TEST_F(Window, TheNoteOnSeriesIsTrueOfEachOfThem) {
  const std::filesystem::path folder = tests::scratchFolder() / "two";
  std::filesystem::create_directories(folder);
  for (const int step : {1, 3})
    for (int slice = 0; slice < 20; ++slice) {
      tests::DicomSpec spec;
      spec.series = "1.2.3." + std::to_string(step);
      spec.instance = spec.series + "." + std::to_string(slice);
      spec.imageType = "ORIGINAL\\PRIMARY\\AXIAL";
      spec.columns = spec.rows = step == 1 ? 16 : 24;
      spec.position = glm::dvec3(0, 0, slice * step);
      tests::writeDicom(folder / (std::to_string(step) + "-" + std::to_string(slice)), spec);
    }
  const auto notesOf = [&](const std::string& series) {
    io::DataRequest request;
    request.path = folder;
    request.series = series;
    open(io::openData(request));
    return window_->notices().texts().join(QLatin1Char('\n'));
  };
  const QString two = QStringLiteral("There are 2 series"),
                reason = QStringLiteral("the thinnest acquired volume, 1.0 mm");
  const QString first = notesOf({});
  EXPECT_TRUE(first.contains(two) && first.contains(reason)) << first.toStdString();
  const QString other = notesOf("1.2.3.3");
  EXPECT_TRUE(other.contains(two)) << other.toStdString();
  EXPECT_FALSE(other.contains(QStringLiteral("thinnest"))) << other.toStdString();
}

TEST_F(Window, TheListOfSeriesOpensAnother) {
  const std::filesystem::path folder = tests::scratchFolder() / "two";
  std::filesystem::create_directories(folder);
  for (const int step : {1, 3})
    for (int slice = 0; slice < 20; ++slice) {
      tests::DicomSpec spec;
      spec.series = "1.2.3." + std::to_string(step);
      spec.instance = spec.series + "." + std::to_string(slice);
      spec.columns = spec.rows = 16;
      spec.position = glm::dvec3(0, 0, slice * step);
      tests::writeDicom(folder / (std::to_string(step) + "-" + std::to_string(slice)), spec);
    }
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  window_->open(std::vector{folder});
  ASSERT_TRUE(opened.wait(patience));
  auto* dock = window_->findChild<QDockWidget*>(QStringLiteral("seriesDock"));
  auto* panel = window_->findChild<SeriesPanel*>();
  EXPECT_FALSE(dock->isVisible()) << "nobody has asked for it";
  for (QAction* action : window_->findChildren<QAction*>())
    if (action->text() == QStringLiteral("Choose series…")) action->trigger();
  ASSERT_TRUE(dock->isVisible());
  ASSERT_EQ(panel->rows().size(), 2);

  panel->list()->setCurrentItem(panel->rows()[1]);
  QTest::keyClick(panel->list(), Qt::Key_Return);
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(document().study().series.id, "1.2.3.3");
  EXPECT_TRUE(panel->rows()[1]->font(0).bold());

  const std::unique_ptr<QMimeData> drag(
      panel->list()->model()->mimeData({panel->list()->indexFromItem(panel->rows()[0])}));
  QDragEnterEvent enter(QPoint(600, 300), Qt::CopyAction, drag.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(600, 300), Qt::CopyAction, drag.get(), Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &drop);
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(document().study().series.id, "1.2.3.1");
  waitUntilDrawn();
}

TEST_F(Window, TheMenuSaysWhatTheValuesAre) {
  const std::filesystem::path file = tests::scratchFolder() / "ball.nii.gz";
  io::writeVolume(*markedBall().scene.volume, file);
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  window_->open(std::vector{file});
  ASSERT_TRUE(opened.wait(patience));
  const auto entry = [&](const QString& name) -> QAction* {
    for (QAction* each : window_->findChildren<QAction*>())
      if (each->text() == name) return each;
    return nullptr;
  };
  ASSERT_NE(entry(QStringLiteral("&MR")), nullptr);
  entry(QStringLiteral("&MR"))->trigger();
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(document().scene().volume->modality, Modality::MR);
  EXPECT_TRUE(entry(QStringLiteral("&MR"))->isChecked());
  waitUntilDrawn();
}

TEST_F(Window, ALookThatNobodyChoseFollowsTheKindOfTheValues) {
  const std::filesystem::path file = tests::scratchFolder() / "ball.nii.gz";
  io::writeVolume(*markedBall().scene.volume, file);
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  const auto setKind = [&](Modality kind) {
    window_->sessions().setModality(kind);
    ASSERT_TRUE(opened.wait(patience));
  };
  window_->open(std::vector{file});
  ASSERT_TRUE(opened.wait(patience));
  setKind(Modality::CT);
  ASSERT_EQ(document().look().context.preset, "ct-soft-tissue");
  setKind(Modality::MR);
  EXPECT_EQ(document().look().context.preset.substr(0, 3), "mr-");
  EXPECT_EQ(document().window(), document().scene().volume->defaultWindow());

  Look chosen = document().look();
  chosen.context = io::loadContextFunction("mr-bright", *document().scene().volume);
  document().edit(QStringLiteral("Preset"), chosen);
  document().setWindow({123.0, 45.0});
  setKind(Modality::CT);
  EXPECT_EQ(document().look().context.preset, "mr-bright") << "the user chose it";
  EXPECT_EQ(document().window(), (WindowLevel{123.0, 45.0}));
}

TEST_F(Window, OtherDataKeepNothingOfTheLookBefore) {
  io::Study study = markedBall();
  Look& look = study.scene.look;
  look.focus = LabelFocus{{1}};
  look.labels = {{.label = 2, .role = LabelRole::Hidden}};
  Removal removal;
  removal.points = {glm::dvec3(0.0)};
  look.removals = {removal};
  look.cutaway.openWidth = 33.0;
  open(study);
  const std::filesystem::path other = tests::scratchFolder() / "other.nrrd";
  io::writeVolume(*study.scene.volume, other);
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  window_->open(std::vector{other});
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(document().look().cutaway.openWidth, Cutaway().openWidth);
  EXPECT_EQ(document().look().focus, Focus());
  EXPECT_TRUE(document().look().labels.empty());
  EXPECT_TRUE(document().removals().empty());
}

/// A series of four slices of which the third one of five is missing.
std::filesystem::path writeGap() {
  const std::filesystem::path folder = tests::scratchFolder() / "gap";
  std::filesystem::create_directories(folder);
  for (const int slice : {0, 1, 3, 4}) {
    tests::DicomSpec spec;
    spec.instance = "1.2." + std::to_string(slice + 1);
    spec.columns = spec.rows = 32;
    spec.position = glm::dvec3(0.0, 0.0, 3.0 * slice);
    writeDicom(folder / std::to_string(slice), spec);
  }
  return folder;
}

TEST_F(Window, Thorough_SlicesThatLieUnevenlyCanBePlacedInEitherWay) {
  window_->open(std::vector{writeGap()});
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(document().scene().volume->grid.dims.z, 5);
  document().setFocus(ValueFocus{{100.0, 500.0}, 0.0});
  cursor().moveTo({3.0, 4.0, 9.0});
  const auto button = [&](const QString& name) -> QPushButton* {
    for (QPushButton* each : window_->notices().findChildren<QPushButton*>())
      if (each->isVisible() && each->text() == name) return each;
    return nullptr;
  };
  ASSERT_EQ(window_->notices().texts().size(), 1) << "one notice for all of the geometry";
  EXPECT_TRUE(window_->notices().texts().front().contains(QStringLiteral("1 slice missing")));
  EXPECT_NE(button(QStringLiteral("Report…")), nullptr);
  ASSERT_NE(button(QStringLiteral("Load as is")), nullptr);
  QTest::mouseClick(button(QStringLiteral("Load as is")), Qt::LeftButton);
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(document().scene().volume->grid.dims.z, 4);
  EXPECT_EQ(document().focus(), Focus(ValueFocus{{100.0, 500.0}, 0.0})) << "everything else stays";
  EXPECT_EQ(cursor().position(), glm::dvec3(3.0, 4.0, 9.0));
  EXPECT_EQ(window_->sessions().controller().session().volume.regularise, io::Regularise::Off);
  // A dismissed notice goes with the next events.
  EXPECT_TRUE(QTest::qWaitFor([&] { return button(QStringLiteral("Load as is")) == nullptr; }, patience));
  ASSERT_NE(button(QStringLiteral("Regularise")), nullptr);
  QTest::mouseClick(button(QStringLiteral("Regularise")), Qt::LeftButton);
  ASSERT_TRUE(opened.wait(patience));
  EXPECT_EQ(document().scene().volume->grid.dims.z, 5);
  waitUntilDrawn();
}

TEST_F(Window, MarksPlanesThatWereNotScanned) {
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  window_->open(std::vector{writeGap()});
  ASSERT_TRUE(opened.wait(patience));
  const auto& report = document().study().geometry;
  ASSERT_TRUE(report);
  ASSERT_EQ(report->interpolatedPlanes, std::vector<int>{2});
  waitUntilDrawn();

  const auto isAmber = [](QColor colour) { return colour == QColor(255, 176, 32); };
  // At the left edge of the coronal picture, on the row of the plane and on no other.
  SliceView* const coronal = slice(SlicePlane::Coronal);
  const Grid& grid = document().scene().volume->grid;
  const auto besideEdge = [&](double plane) {
    const glm::dvec3 index(-0.5, 0.5 * (grid.dims.y - 1), plane);
    const glm::dvec3 world(grid.worldFromIndex() * glm::dvec4(index, 1.0));
    return (coronal->widgetFromWorld(world) + QPointF(2.0, 0.0)).toPoint();
  };
  const auto colourAt = [&](QPoint at) {
    const QImage image = coronal->grab().toImage();
    return image.pixelColor(at * image.devicePixelRatio());
  };
  EXPECT_TRUE(isAmber(colourAt(besideEdge(2.3))));  // beside the crosshair's line
  for (const double plane : {0.0, 1.0, 3.0, 4.0}) EXPECT_FALSE(isAmber(colourAt(besideEdge(plane)))) << plane;

  // A frame around the whole plane, and nothing around its neighbour.
  SliceView* const axial = slice(SlicePlane::Axial);
  const auto amberPixels = [&] {
    const QImage image = axial->grab().toImage();
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) count += isAmber(image.pixelColor(x, y)) ? 1 : 0;
    return count;
  };
  const auto showPlane = [&](int plane) {
    cursor().moveTo(glm::dvec3(grid.worldFromIndex() * glm::dvec4(1.0, 1.0, plane, 1.0)));
  };
  showPlane(2);
  EXPECT_GT(amberPixels(), 0);
  showPlane(1);
  EXPECT_EQ(amberPixels(), 0);
}

TEST_F(Window, ReadingCanBeCancelled) {
  const auto volumeBefore = document().scene().volume;
  window_->open([](const io::Progress& progress) -> io::Study {
    while (progress(0.5, "reading slices")) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    throw io::Cancelled();
  });
  const auto cancel = [&]() -> QPushButton* {
    for (QPushButton* button : window_->findChildren<QPushButton*>())
      if (button->isVisible() && button->text() == QStringLiteral("Cancel")) return button;
    return nullptr;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return cancel() != nullptr; }, patience));
  QTest::mouseClick(cancel(), Qt::LeftButton);
  EXPECT_TRUE(QTest::qWaitFor([&] { return cancel() == nullptr; }, patience));
  EXPECT_TRUE(window_->notices().texts().isEmpty());
  EXPECT_EQ(document().scene().volume, volumeBefore);
}

TEST_F(Window, TitleAndPanelsNameNoFile) {
  io::Study study = markedBall();
  study.session.volume.path = "/data/Doe^Jane/scan.nii";
  study.series.description = "Jane Doe, head";
  open(study);
  EXPECT_FALSE(window_->windowTitle().contains(QStringLiteral("Doe")));
  for (const QLabel* label : window_->findChildren<QLabel*>())
    EXPECT_FALSE(label->text().contains(QStringLiteral("Doe"))) << label->text().toStdString();
}

TEST(WindowWithoutOpenGl, ExplainsItselfAndKeepsTheSlices) {
  MainWindow window({.gl = {.problem = QStringLiteral("No driver here.")}, .remember = false});
  window.resize(1280, 800);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, patience));
  QSignalSpy opened(&window, &MainWindow::opened);
  window.open([](const io::Progress&) { return markedBall(); });
  ASSERT_TRUE(opened.wait(patience));
  const auto* reason = window.findChild<QLabel*>(QStringLiteral("noOpenGl"));
  ASSERT_NE(reason, nullptr);
  EXPECT_TRUE(reason->isVisible());
  EXPECT_TRUE(reason->text().contains(QStringLiteral("No driver here.")));
  EXPECT_FALSE(window.findChild<CamerasPanel*>()->placeButton()->isEnabled());
  SliceView* axial = window.views().sliceViews().front();
  window.workspace().cursor.moveTo(markerCentre);
  QTest::mouseClick(axial, Qt::LeftButton, {}, axial->widgetFromWorld(markerCentre).toPoint());
  EXPECT_EQ(window.workspace().document.focus(), Focus(LabelFocus{{marker}}));
  EXPECT_FALSE(window.picture().isNull());
}

}  // namespace
}  // namespace fenestra::viewer::windowDataTest
