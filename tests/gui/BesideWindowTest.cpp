// Two studies side by side, as a user opens, links, matches and closes them.

#include <filesystem>
#include <memory>
#include <string>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QMenu>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "io/study/ReadStudy.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/bars/StudyLinkBar.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/StudyLink.h"
#include "viewer/panels/SeriesPanel.h"

namespace fenestra::viewer::besideWindowTest {
namespace {

class Beside : public Window {
 protected:
  /// Opens the marked ball beside itself.
  MainWindow& openBeside() {
    MainWindow& beside = window_->showBeside();
    PlacementSettings settings = beside.workspace().placement.settings();
    settings.automatic = false;
    beside.workspace().placement.setSettings(settings);
    QSignalSpy opened(&beside, &MainWindow::opened);
    beside.open([](const io::Progress&) { return markedBall(); });
    EXPECT_TRUE(opened.count() > 0 || opened.wait(patience));
    return beside;
  }
  static void click(MainWindow& window, const char* button) {
    auto* bar = window.findChild<StudyLinkBar*>();
    QTest::mouseClick(bar->findChild<QToolButton*>(QLatin1String(button)), Qt::LeftButton);
  }
  static SliceView* axial(MainWindow& window) { return window.views().sliceViews().at(0); }
  static void clickAt(MainWindow& window, glm::dvec3 world) {
    QTest::mouseClick(axial(window), Qt::LeftButton, {}, axial(window)->widgetFromWorld(world).toPoint());
  }
  static glm::dvec3 crosshair(MainWindow& window) { return window.workspace().cursor.position(); }
};

/// Two series of one patient, three slices each; one of them is open.
io::Study twoSeries() {
  const std::filesystem::path folder = tests::scratchFolder() / "series";
  std::filesystem::create_directories(folder);
  for (int image = 0; image < 6; ++image) {
    tests::DicomSpec spec;
    spec.series = image < 3 ? "1.2.1" : "1.2.2";
    spec.seriesNumber = image < 3 ? "1" : "2";
    spec.instance = "1.2.9." + std::to_string(image);
    spec.columns = spec.rows = 16;
    spec.position = glm::dvec3(0, 0, (image < 3 ? 2.0 : 1.0) * image);
    tests::writeDicom(folder / std::to_string(image), spec);
  }
  io::DataRequest request;
  request.path = folder;
  return io::openData(request);
}

std::string seriesOf(MainWindow& window) { return window.workspace().document.study().series.id; }

/// The row of a series in a window's list.
QTreeWidgetItem* rowOf(MainWindow& window, const std::string& id) {
  for (QTreeWidgetItem* row : window.findChild<SeriesPanel*>()->rows())
    if (row->data(0, Qt::UserRole).toString().toStdString() == id) return row;
  return nullptr;
}

// Indices there and back round in the last digits; mm.
constexpr double rounding = 1e-9;

}  // namespace

TEST_F(Beside, LinksAndMatchesTwoStudiesAndGoesBackToOne) {
  EXPECT_FALSE(window_->findChild<StudyLinkBar*>()->isVisible());
  const QSize alone = window_->size();
  MainWindow& beside = openBeside();
  ASSERT_TRUE(beside.isVisible());
  EXPECT_FALSE(window_->geometry().intersects(beside.geometry()));
  for (MainWindow* each : {window_.get(), &beside})
    for (QWidget* view : each->views().findChildren<QWidget*>())
      if (qobject_cast<SliceView*>(view) || qobject_cast<VolumeView*>(view)) {
        EXPECT_TRUE(view->isVisible());
      }

  clickAt(*window_, {10, -10, 1});
  EXPECT_GT(glm::distance(crosshair(*window_), crosshair(beside)), 1.0) << "not linked";
  click(*window_, "linkStudies");
  EXPECT_EQ(window_->notices().texts().size(), 1) << "whether their coordinates agree is not known";
  clickAt(*window_, {20, -5, 1});
  EXPECT_LT(glm::distance(crosshair(*window_), crosshair(beside)), rounding);
  const std::size_t steps = static_cast<std::size_t>(beside.workspace().document.undoStack().count());
  wheel(axial(beside), 2);
  EXPECT_LT(glm::distance(crosshair(*window_), crosshair(beside)), rounding) << "scrolled on the right";
  wheel(axial(*window_), 2, Qt::ControlModifier);
  EXPECT_NEAR(axial(beside)->scale(), axial(*window_)->scale(), rounding);
  cameras().orbit(0, 0.3, 0.1);
  EXPECT_LT(glm::distance(directionOf(cameras().camera(1)), directionOf(beside.workspace().cameras.camera(1))), 1e-12);
  EXPECT_EQ(static_cast<std::size_t>(beside.workspace().document.undoStack().count()), steps) << "nothing to undo";

  click(*window_, "linkStudies");
  window_->workspace().cursor.moveTo({0, 0, 0});
  beside.workspace().cursor.moveTo({6, -4, 2});
  click(beside, "matchPoints");
  window_->workspace().cursor.moveTo({10, 10, 10});
  EXPECT_LT(glm::distance(crosshair(beside), glm::dvec3(16, 6, 12)), rounding);
  click(beside, "forgetPair");
  EXPECT_LT(glm::distance(crosshair(*window_), crosshair(beside)), rounding);

  const std::weak_ptr<const Volume> volume = beside.workspace().document.scene().volume;
  beside.sessions().questions().saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Discard; };
  beside.findChild<QAction*>(QStringLiteral("closeStudy"))->trigger();
  EXPECT_FALSE(beside.isVisible());
  EXPECT_TRUE(window_->isVisible());
  EXPECT_EQ(window_->size(), alone);
  EXPECT_FALSE(window_->findChild<StudyLinkBar*>()->isVisible());
  EXPECT_TRUE(QTest::qWaitFor([&] { return volume.expired(); }, patience)) << volume.use_count() << " still hold it";
  EXPECT_TRUE(document().hasVolume());
}

TEST_F(Beside, SharesWhatAUserSetsAndAsksBothForUnsavedWork) {
  MainWindow& beside = openBeside();
  beside.workspace().preferences.set(Preference::HidesPatient, 1);
  EXPECT_TRUE(options().hidesPatient()) << "hidden in one is hidden in both";
  window_->workspace().preferences.set(Preference::HidesPatient, 0);
  EXPECT_FALSE(beside.workspace().options.hidesPatient());

  int asked = 0;
  auto answer = SessionQuestions::Answer::Cancel;
  beside.workspace().document.setMeasures({{MeasureKind::Distance, {{0, 0, 1}, {9, 0, 1}}, {1, 0, 0}, {0, 1, 0}}},
                                          QStringLiteral("Distance"));
  beside.sessions().questions().saveChanges = [&](const QStringList&) {
    ++asked;
    return answer;
  };
  window_->quit();
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(window_->isVisible()) << "cancelled";
  EXPECT_TRUE(beside.isVisible());

  // The left study closes, and the right one stays.
  window_->close();
  EXPECT_FALSE(window_->isVisible());
  EXPECT_FALSE(document().hasVolume());
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(beside.workspace().document.hasVolume());
  MainWindow& again = beside.showBeside();
  EXPECT_EQ(&again, window_.get());
  EXPECT_TRUE(window_->isVisible());
  answer = SessionQuestions::Answer::Discard;
  window_->quit();
  EXPECT_EQ(asked, 2);
  EXPECT_FALSE(window_->isVisible());
  EXPECT_FALSE(beside.isVisible());
}

TEST_F(Beside, ASeriesOpensBesideByItsMenuAndByADragFromTheOtherWindow) {
  open(twoSeries());
  const std::string left = seriesOf(*window_), other = left == "1.2.1" ? "1.2.2" : "1.2.1";
  window_->findChild<QDockWidget*>(QStringLiteral("seriesDock"))->show();
  SeriesPanel& list = *window_->findChild<SeriesPanel*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return rowOf(*window_, other) != nullptr; }, patience));

  // By the menu of its row.
  Q_EMIT list.list()->customContextMenuRequested(list.list()->visualItemRect(rowOf(*window_, other)).center());
  auto* menu = list.findChild<QMenu*>();
  ASSERT_TRUE(menu);
  ASSERT_EQ(menu->actions().size(), 2);
  EXPECT_EQ(menu->actions()[1]->text(), QStringLiteral("Open beside"));
  menu->actions()[1]->trigger();
  menu->close();
  MainWindow& beside = window_->showBeside();
  ASSERT_TRUE(QTest::qWaitFor([&] { return seriesOf(beside) == other; }, patience));
  EXPECT_EQ(seriesOf(*window_), left);

  // A drag of what is open on the left, onto a view on the right, whose study knows nothing of that series.
  QSignalSpy opened(&beside, &MainWindow::opened);
  beside.open([](const io::Progress&) { return markedBall(); });
  ASSERT_TRUE(opened.count() > 0 || opened.wait(patience));
  const auto drop = [&](MainWindow& onto, const QMimeData& data) {
    const QPoint at = axial(onto)->mapTo(&onto, axial(onto)->rect().center());
    QDragEnterEvent enters(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&onto, &enters);
    EXPECT_TRUE(enters.isAccepted());
    QDropEvent drops(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&onto, &drops);
  };
  QTreeWidget& rows = *list.list();
  const auto dragged = [&](const std::string& id) {
    return std::unique_ptr<QMimeData>(rows.model()->mimeData({rows.indexFromItem(rowOf(*window_, id))}));
  };
  drop(beside, *dragged(left));
  ASSERT_TRUE(QTest::qWaitFor([&] { return seriesOf(beside) == left; }, patience));
  EXPECT_EQ(seriesOf(*window_), left);
  // On its own window it opens there.
  drop(*window_, *dragged(other));
  ASSERT_TRUE(QTest::qWaitFor([&] { return seriesOf(*window_) == other; }, patience));
  EXPECT_EQ(seriesOf(beside), left);
}

}  // namespace fenestra::viewer::besideWindowTest
