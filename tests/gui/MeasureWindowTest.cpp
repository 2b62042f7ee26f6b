// Measures on the slices, drawn, moved, copied and deleted with mouse and keys.

#include <fstream>
#include <iterator>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QInputDialog>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QTest>

#include "io/session/SessionFile.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/actions/MeasureMenu.h"
#include "viewer/exports/Exports.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/MeasureText.h"

namespace fenestra::viewer::measureWindowTest {
namespace {

class MeasureWindow : public Window {
 protected:
  SliceView* axial() { return slice(SlicePlane::Axial); }
  MeasureMode& measuring() { return window_->workspace().measuring; }
  /// A mouse position over a world point, and the point that it stands for.
  QPoint at(glm::dvec3 world) { return axial()->widgetFromWorld(world).toPoint(); }
  glm::dvec3 pointed(QPoint position) { return axial()->worldFromWidget(position); }
  QPoint from_, to_;
  /// The question for a mark's text that is open; one that was answered is deleted later.
  QInputDialog* question() {
    for (QInputDialog* each : window_->findChildren<QInputDialog*>(QStringLiteral("markText")))
      if (each->isVisible()) return each;
    return nullptr;
  }
  void type(const QString& text) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return question() != nullptr; }, patience));
    question()->setTextValue(text);
    question()->accept();
  }
  /// Draws a distance of 30 mm with the mouse.
  void drawDistance() {
    from_ = at({-20.0, 5.0, cursor().position().z});
    to_ = at({10.0, 5.0, cursor().position().z});
    QTest::keyClick(axial(), Qt::Key_D);
    drag(axial(), from_, to_);
  }
};

TEST_F(MeasureWindow, ADragDrawsADistanceInMillimetres) {
  const Focus focus = document().focus();
  const WindowLevel window = document().window();
  drawDistance();
  ASSERT_EQ(document().measures().size(), 1u);
  const Measure& drawn = document().measures()[0];
  EXPECT_EQ(drawn.kind, MeasureKind::Distance);
  EXPECT_LT(glm::distance(drawn.points[0], pointed(from_)), 1e-9);
  EXPECT_LT(glm::distance(drawn.points[1], pointed(to_)), 1e-9);
  // The mouse stands on whole device-independent pixels of about 0.3 mm.
  EXPECT_NEAR(document().measured(0).length.value(), 30.0, 1.0);
  EXPECT_EQ(document().focus(), focus) << "a measure is no click";
  EXPECT_EQ(document().window(), window) << "nor a drag of the window";
  EXPECT_EQ(measuring().selected(), 0u);

  QTest::keyClick(axial(), Qt::Key_Escape);
  EXPECT_FALSE(measuring().kind());
  QTest::keyClick(axial(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document().measures().empty());
  QTest::keyClick(axial(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().measures().size(), 1u);
}

TEST_F(MeasureWindow, ClicksDrawAnAngle) {
  QTest::keyClick(axial(), Qt::Key_A);
  const double z = cursor().position().z;
  for (const glm::dvec3 world : {glm::dvec3(20, 0, z), glm::dvec3(-10, 0, z), glm::dvec3(-10, -25, z)}) {
    QTest::mouseMove(axial(), at(world) + QPoint(1, 0));
    QTest::mouseClick(axial(), Qt::LeftButton, {}, at(world));
  }
  ASSERT_EQ(document().measures().size(), 1u);
  // Three places on whole pixels: each is off by 0.2 mm at most, of arms of 25 mm and more.
  EXPECT_NEAR(document().measured(0).angle.value(), 90.0, 1.0);
  EXPECT_EQ(document().undoStack().count(), 1);
}

TEST_F(MeasureWindow, ADraggedEllipseGivesTheValuesInside) {
  cursor().moveTo(markerCentre);
  QTest::keyClick(axial(), Qt::Key_Q);
  drag(axial(), at(markerCentre - glm::dvec3(4, 4, 0)), at(markerCentre + glm::dvec3(4, 4, 0)));
  ASSERT_EQ(document().measures().size(), 1u);
  const MeasureValues& values = document().measured(0);
  ASSERT_TRUE(values.region);
  EXPECT_EQ(values.region->mean, 900.0) << "the marker's value, exactly";
  EXPECT_EQ(values.region->deviation, 0.0);
  // Voxels of 2 mm whose centres are within 4 mm of one.
  EXPECT_NEAR(static_cast<double>(values.region->count), 13.0, 4.0);
  QTest::keyClick(axial(), Qt::Key_B);
  EXPECT_EQ(measuring().kind(), MeasureKind::Rectangle);
}

TEST_F(MeasureWindow, EscapeGivesUpAMeasureAndThenTheTool) {
  QTest::keyClick(axial(), Qt::Key_D);
  QTest::mouseClick(axial(), Qt::LeftButton, {}, at({0, 0, cursor().position().z}));
  EXPECT_TRUE(measuring().draft());
  QTest::keyClick(axial(), Qt::Key_Escape);
  EXPECT_FALSE(measuring().draft());
  EXPECT_EQ(measuring().kind(), MeasureKind::Distance);
  QTest::keyClick(axial(), Qt::Key_Escape);
  EXPECT_FALSE(measuring().kind());
  EXPECT_EQ(document().undoStack().count(), 0);
}

TEST_F(MeasureWindow, HandlesAndLinesAreDraggedInOneStep) {
  drawDistance();
  QTest::keyClick(axial(), Qt::Key_Escape);
  const Measure before = document().measures()[0];
  drag(axial(), to_, to_ + QPoint(0, 40));
  const Measure turned = document().measures()[0];
  EXPECT_EQ(turned.points[0], before.points[0]);
  EXPECT_LT(glm::distance(turned.points[1], pointed(to_ + QPoint(0, 40))), 1e-9);
  EXPECT_EQ(document().undoStack().count(), 2);
  document().undoStack().undo();
  EXPECT_EQ(document().measures()[0], before);

  const QPoint middle = (from_ + to_) / 2;
  drag(axial(), middle, middle + QPoint(12, -18));
  const glm::dvec3 moved = pointed(middle + QPoint(12, -18)) - pointed(middle);
  for (int end : {0, 1})
    EXPECT_LT(glm::distance(document().measures()[0].points[static_cast<std::size_t>(end)],
                            before.points[static_cast<std::size_t>(end)] + moved),
              1e-9);
  EXPECT_EQ(document().undoStack().count(), 2);
}

TEST_F(MeasureWindow, UndoWhileAMeasureIsDraggedEndsTheDrag) {
  drawDistance();
  QTest::keyClick(axial(), Qt::Key_Escape);
  const auto moveTo = [&](QPoint at) {
    QMouseEvent move(QEvent::MouseMove, at, axial()->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(axial(), &move);
  };
  const glm::dvec3 cross = cursor().position();
  QTest::mousePress(axial(), Qt::LeftButton, Qt::NoModifier, to_);
  moveTo(to_ + QPoint(0, 20));
  QTest::keyClick(axial(), Qt::Key_Z, Qt::ControlModifier);
  QTest::keyClick(axial(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(document().measures().empty());
  moveTo(to_ + QPoint(0, 40));
  QTest::mouseRelease(axial(), Qt::LeftButton, Qt::NoModifier, to_ + QPoint(0, 40));
  EXPECT_TRUE(document().measures().empty());
  EXPECT_EQ(cursor().position(), cross) << "the drag has become one of the crosshair";
  drawDistance();
  EXPECT_EQ(document().measures().size(), 1u);
}

TEST_F(MeasureWindow, DeleteKeyAndMenuRemove) {
  drawDistance();
  QTest::keyClick(axial(), Qt::Key_Delete);
  EXPECT_TRUE(document().measures().empty());
  QTest::keyClick(axial(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_EQ(document().measures().size(), 1u);
  QTest::keyClick(axial(), Qt::Key_Delete);
  EXPECT_EQ(document().measures().size(), 1u) << "none is selected";
  QMenu menu;
  fillMeasureMenu(menu, window_->workspace(), 0);
  EXPECT_EQ(measuring().selected(), 0u);
  for (QAction* action : menu.actions())
    if (action->text() == QStringLiteral("Delete this measure")) action->trigger();
  EXPECT_TRUE(document().measures().empty());
}

TEST_F(MeasureWindow, ARightClickOnAMeasureOpensItsMenu) {
  drawDistance();
  QTest::keyClick(axial(), Qt::Key_Escape);
  std::optional<std::size_t> asked;
  bool structure = false;
  QObject::disconnect(&views(), &ViewArea::measureMenuRequested, nullptr, nullptr);
  QObject::disconnect(&views(), &ViewArea::sliceMenuRequested, nullptr, nullptr);
  QObject::connect(&views(), &ViewArea::measureMenuRequested, [&](std::size_t measure, QPoint) { asked = measure; });
  QObject::connect(&views(), &ViewArea::sliceMenuRequested, [&] { structure = true; });
  QTest::mouseClick(axial(), Qt::RightButton, {}, (from_ + to_) / 2);
  EXPECT_EQ(asked, 0u);
  EXPECT_FALSE(structure);
  QTest::mouseClick(axial(), Qt::RightButton, {}, (from_ + to_) / 2 + QPoint(0, 40));
  EXPECT_TRUE(structure);
}

TEST_F(MeasureWindow, IsShownOnItsSliceOnly) {
  drawDistance();
  QTest::keyClick(axial(), Qt::Key_Escape);
  const QImage with = picture(axial());
  const MeasureTool& tool = axial()->measureTool();
  EXPECT_TRUE(tool.shown(document().measures()[0], document().measured(0)));
  EXPECT_FALSE(slice(SlicePlane::Coronal)->measureTool().shown(document().measures()[0], document().measured(0)));
  document().setMeasures({}, {});
  EXPECT_NE(picture(axial()), with);
  document().undoStack().undo();
  wheel(axial(), 1);
  EXPECT_FALSE(tool.shown(document().measures()[0], document().measured(0)));
  EXPECT_FALSE(tool.measureAt((from_ + to_) / 2));
}

TEST_F(MeasureWindow, HiddenMeasuresAreNeitherDrawnNorTouched) {
  const QImage without = picture(axial());
  drawDistance();
  QTest::keyClick(axial(), Qt::Key_Escape);
  QTest::keyClick(axial(), Qt::Key_Escape);
  auto* shown = window_->findChild<QAction*>(QStringLiteral("showMeasures"));
  ASSERT_TRUE(shown && shown->isChecked());
  const QImage with = picture(axial());
  shown->trigger();
  EXPECT_FALSE(options().measures());
  EXPECT_NE(picture(axial()), with);
  EXPECT_FALSE(axial()->measureTool().measureAt((from_ + to_) / 2));
  EXPECT_EQ(document().measures().size(), 1u);
  QTest::keyClick(axial(), Qt::Key_D);
  EXPECT_TRUE(options().measures() && shown->isChecked()) << "what is drawn shows";
}

TEST_F(MeasureWindow, TheTableOfAllIsExported) {
  auto* entry = window_->findChild<QAction*>(QStringLiteral("exportMeasures"));
  ASSERT_TRUE(entry);
  EXPECT_FALSE(entry->isEnabled());
  drawDistance();
  EXPECT_TRUE(entry->isEnabled());
  const std::filesystem::path file = tests::scratchFolder() / "measures.csv";
  auto* exports = window_->findChild<Exports*>();
  exports->writeMeasures(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !exports->job().isRunning(); }, patience));
  std::ifstream stream(file, std::ios::binary);
  const std::string written(std::istreambuf_iterator<char>(stream), {});
  EXPECT_EQ(written, measuresCsv(document()).toStdString());
  EXPECT_GT(written.size(), 40u);
}

TEST_F(MeasureWindow, CopiesTextOfOneAndTheTableOfAll) {
  drawDistance();
  QTest::keyClick(axial(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  const double length = document().measured(0).length.value();
  const QClipboard* clipboard = QGuiApplication::clipboard();
  EXPECT_EQ(clipboard->text(), QStringLiteral("%1 mm").arg(length, 0, 'f', 1));
  QTest::keyClick(axial(), Qt::Key_Escape);
  QTest::keyClick(axial(), Qt::Key_Escape);
  QTest::keyClick(axial(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  const QStringList rows = clipboard->text().split(QStringLiteral("\r\n"));
  ASSERT_EQ(rows.size(), 3);
  EXPECT_TRUE(rows[0].startsWith(QStringLiteral("kind,length_mm,")));
  EXPECT_EQ(rows[1].split(QLatin1Char(',')).size(), rows[0].split(QLatin1Char(',')).size());
  EXPECT_EQ(rows[1].split(QLatin1Char(','))[1].toDouble(), length) << "all digits";
}

TEST_F(MeasureWindow, ComesBackWithASession) {
  drawDistance();
  const std::vector<Measure> drawn = document().measures();
  EXPECT_EQ(window_->sessions().controller().session().measures, drawn);
  EXPECT_TRUE(window_->sessions().controller().isModified());
  io::Study study = markedBall();
  study.session.measures = drawn;
  document().setMeasures({}, {});
  open(study);
  EXPECT_EQ(document().measures(), drawn);
  EXPECT_TRUE(axial()->measureTool().measureAt((from_ + to_) / 2));
  open(markedBall());
  EXPECT_TRUE(document().measures().empty());
}

TEST_F(MeasureWindow, AnArrowAsksForItsTextAndIsOneStep) {
  const double z = cursor().position().z;
  QTest::keyClick(axial(), Qt::Key_D, Qt::ShiftModifier);
  drag(axial(), at({-20, 5, z}), at({10, 15, z}));
  type(QStringLiteral("  Läsion,\t\"neu\" "));
  ASSERT_EQ(document().measures().size(), 1u);
  EXPECT_EQ(document().measures()[0].kind, MeasureKind::Arrow);
  EXPECT_EQ(document().measures()[0].text, "Läsion, \"neu\"");
  EXPECT_LT(glm::distance(document().measures()[0].points[0], pointed(at({-20, 5, z}))), 1e-9) << "its tip";
  EXPECT_EQ(document().undoStack().count(), 1);
  // Moved by its line, and by its end, as a measure is.
  QTest::keyClick(axial(), Qt::Key_Escape);
  const Measure before = document().measures()[0];
  drag(axial(), at({-5, 10, z}), at({-5, 10, z}) + QPoint(0, 25));
  EXPECT_NE(document().measures()[0].points[0], before.points[0]);
  EXPECT_EQ(document().measures()[0].text, before.text);
  const QString table = measuresCsv(document());
  EXPECT_TRUE(table.contains(QStringLiteral(",text\r\narrow,,"))) << table.toStdString();
  EXPECT_TRUE(table.endsWith(QStringLiteral(",\"Läsion, \"\"neu\"\"\"\r\n"))) << table.toStdString();
  // Drawn over the slice, and hidden with the measures.
  QImage with(axial()->size(), QImage::Format_RGB32), without = with;
  const auto draw = [this](QImage& picture) {
    picture.fill(Qt::black);
    QPainter painter(&picture);
    axial()->draw(painter, true);
  };
  draw(with);
  options().setMeasures(false);
  draw(without);
  EXPECT_NE(with, without);
  // Another text is another step; an empty one leaves the arrow.
  options().setMeasures(true);
  measuring().setText(0, QStringLiteral("="));
  EXPECT_TRUE(measuresCsv(document()).endsWith(QStringLiteral(",'=\r\n"))) << "no formula for a spreadsheet";
  measuring().setText(0, {});
  EXPECT_EQ(document().measures().size(), 1u);
  document().undoStack().undo();
  document().undoStack().undo();
  EXPECT_EQ(document().measures()[0].text, before.text);
}

TEST_F(MeasureWindow, ATextIsPlacedByAClickAndNothingWithoutWords) {
  const double z = cursor().position().z;
  QTest::keyClick(axial(), Qt::Key_T, Qt::ShiftModifier);
  QTest::mouseClick(axial(), Qt::LeftButton, {}, at({5, 5, z}));
  type({});
  EXPECT_TRUE(document().measures().empty()) << "no words";
  EXPECT_FALSE(measuring().draft());
  QTest::mouseClick(axial(), Qt::LeftButton, {}, at({5, 5, z}));
  type(QStringLiteral("%1").arg(QString(1000, QLatin1Char('a'))));
  ASSERT_EQ(document().measures().size(), 1u);
  EXPECT_EQ(document().measures()[0].text.size(), Measure::longestText) << "cut";
  EXPECT_TRUE(isWellFormed(document().measures()[0]));
  QTest::mouseClick(axial(), Qt::LeftButton, {}, at({-15, 5, z}));
  ASSERT_TRUE(QTest::qWaitFor([&] { return question() != nullptr; }, patience));
  question()->reject();
  EXPECT_EQ(document().measures().size(), 1u) << "cancelled";
  EXPECT_FALSE(measuring().draft());
  QApplication::setActiveWindow(window_.get());  // the question was it
  QTest::keyClick(axial(), Qt::Key_Escape);
  ASSERT_FALSE(measuring().kind());
  // Changed by the menu, and gone without words.
  measuring().select(0);
  auto* change = window_->findChild<QAction*>(QStringLiteral("changeMarkText"));
  ASSERT_TRUE(change->isEnabled());
  change->trigger();
  type(QStringLiteral("links"));
  EXPECT_EQ(document().measures()[0].text, "links");
  // Grabbed by its words, right of its point, it moves as a whole.
  const QPoint words = at({5, 5, z}) + QPoint(20, 0);
  ASSERT_EQ(axial()->measureTool().measureAt(words), 0u);
  drag(axial(), words, words + QPoint(0, 40));
  EXPECT_GT(document().measures()[0].points[0].y, 6.0);
  document().undoStack().undo();
  document().setMeasures({document().measures()[0]}, {});
  change->trigger();
  type({});
  EXPECT_TRUE(document().measures().empty());
  EXPECT_FALSE(change->isEnabled());
}

TEST(MeasureDrawing, TextStaysOffTheLineWhereverItPoints) {
  const QRectF view(0, 0, 400, 300);
  const QSizeF text(90, 18);
  for (const MeasureKind kind :
       {MeasureKind::Distance, MeasureKind::Angle, MeasureKind::Rectangle, MeasureKind::Ellipse, MeasureKind::Arrow})
    for (int turn = 0; turn < 360; turn += 15)
      for (const QPointF middle : {QPointF(200, 150), QPointF(60, 60), QPointF(350, 250)}) {
        const double angle = turn * 3.14159265 / 180.0;
        const QPointF way(50.0 * std::cos(angle), 40.0 * std::sin(angle));
        ShownMeasure measure{kind, {}, {}, false};
        const QRectF box = QRectF(middle - way, middle + way).normalized();
        if (kind == MeasureKind::Distance || kind == MeasureKind::Arrow) measure.handles = {middle - way, middle + way};
        if (kind == MeasureKind::Angle) measure.handles = {middle - way, middle, middle + QPointF(30, 5)};
        if (kind == MeasureKind::Rectangle)
          measure.handles = {box.topLeft(), box.topRight(), box.bottomRight(), box.bottomLeft()};
        if (kind == MeasureKind::Ellipse)
          measure.handles = {{box.center().x(), box.top()},
                             {box.right(), box.center().y()},
                             {box.center().x(), box.bottom()},
                             {box.left(), box.center().y()}};
        const QRectF place = textBoxOf(measure, text, view);
        EXPECT_TRUE(view.contains(place)) << turn;
        const QPolygonF line = outlineOf(measure);
        for (qsizetype corner = 1; corner < line.size(); ++corner)
          for (double share = 0.0; share <= 1.0; share += 0.02)
            ASSERT_FALSE(place.contains(line[corner - 1] + share * (line[corner] - line[corner - 1])))
                << static_cast<int>(kind) << " at " << turn << "°";
      }
}

}  // namespace
}  // namespace fenestra::viewer::measureWindowTest
