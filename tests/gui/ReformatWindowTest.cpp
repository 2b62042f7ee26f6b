// The curved reformat in the window: a path clicked on slices or taken from the focus, its pictures, its place, undo,
// and that sessions keep it.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "io/session/SessionFile.h"
#include "rendering/reformat/Straighten.h"
#include "tests/gui/Conventions.h"
#include "tests/support/TestData.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/PathTube.h"
#include "viewer/model/SessionController.h"
#include "viewer/panels/ReformatPanel.h"
#include "viewer/panels/ReformatPicture.h"

namespace fenestra::viewer {

void Conventions::addReformatGestures(Cases& cases) {
  const std::string path = "The path of the curved reformat, on the slices: ";
  const std::string pictures = "The pictures of the curved reformat: ";
  cases[path + "Clicks, as it is being drawn"] = cases[path + "Backspace"] = cases[path + "Drag a point"] =
      cases[pictures + "Click"] = cases[pictures + "Drag"] =
          cases[pictures + "Wheel, arrows, Page, Home and End keys"] = [this] {
            PathMode& mode = window_->workspace().path;
            const double z = cursor().position().z;
            press("S");
            waitUntilDrawn();
            for (const glm::dvec3 point : {glm::dvec3(-30, 0, z), {30, 0, z}, {0, 20, z}})
              QTest::mouseClick(axial(), Qt::LeftButton, {}, at(point));
            QTest::keyClick(axial(), Qt::Key_Backspace);
            QTest::keyClick(axial(), Qt::Key_Return);
            ASSERT_EQ(document().path().size(), 2u);
            waitUntilDrawn();
            const glm::dvec3 end = document().path()[1];
            drag(axial(), at(end), at(end + glm::dvec3(0, 10, 0)));
            EXPECT_LT(glm::distance(document().path()[1], end + glm::dvec3(0, 10, 0)), 1.5) << "to a pixel";
            document().undoStack().undo();
            EXPECT_EQ(document().path()[1], end) << "one step";
            ReformatPicture& picture = panel<ReformatPanel>().straight();
            const double all = mode.curve().length();
            for (const auto& [key, place] : {std::pair(Qt::Key_Home, 0.0),
                                             {Qt::Key_Right, 2.0},
                                             {Qt::Key_PageDown, 22.0},
                                             {Qt::Key_Left, 20.0},
                                             {Qt::Key_PageUp, 0.0},
                                             {Qt::Key_End, all}}) {
              QTest::keyClick(&picture, key);
              EXPECT_NEAR(mode.place(), place, 1e-9);
            }
            wheel(&picture, 1);
            EXPECT_NEAR(mode.place(), all - 2.0, 1e-9) << "up the picture";
            const QPoint middle = picture.shownIn().center().toPoint();
            QTest::mouseClick(&picture, Qt::LeftButton, {}, middle);
            EXPECT_NEAR(mode.place(), 0.5 * all, 3.0) << "to a voxel and a pixel";
            const WindowLevel before = document().window();
            drag(&picture, middle, middle + QPoint(20, 20));
            EXPECT_GT(document().window().width, before.width);
            EXPECT_GT(document().window().level, before.level);
            document().setPath({}, {});
            document().setWindow(before);
            window_->findChild<QWidget*>(QStringLiteral("reformatDock"))->hide();
            waitUntilDrawn();
          };
}

}  // namespace fenestra::viewer

namespace fenestra::viewer::reformatWindowTest {
namespace {

constexpr std::uint16_t tube = 3;
constexpr double tubeRadius = 7.0;  // mm

/// A study with a straight tube along z, beside the middle.
io::Study tubeStudy() {
  io::Study study = markedBall();
  auto labels = std::make_shared<LabelMap>();
  labels->grid = study.scene.labels->grid;
  labels->labels = study.scene.labels->labels;
  labels->voxels = Voxels(ScalarType::UInt8, labels->grid.voxelCount());
  auto marks = labels->voxels.as<std::uint8_t>();
  std::fill(marks.begin(), marks.end(), std::uint8_t{0});  // new voxels hold anything
  for (int z = 6; z < 42; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) {
        const glm::dvec3 world = labels->grid.origin + 2.0 * glm::dvec3(x, y, z);
        if (std::hypot(world.x - 5.0, world.y + 5.0) < tubeRadius)
          marks[labels->grid.offset({x, y, z})] = static_cast<std::uint8_t>(tube);
      }
  labels->labels.push_back({tube, "tube", {1.0, 0.2, 0.2}});
  study.scene.labels = labels;
  return study;
}

class ReformatWindow : public Conventions {
 protected:
  PathMode& path() { return window_->workspace().path; }
  ReformatPanel& reformat() { return panel<ReformatPanel>(); }
  void click(glm::dvec3 world) { QTest::mouseClick(axial(), Qt::LeftButton, {}, at(world)); }
  void expectCamerasFollow(double half) {
    // The cameras go along when they are asked to, which is one step; moves along the path are none.
    const ViewLink::Pose pose = cameras().pose();
    QTest::keyClick(&reformat().straight(), Qt::Key_Home);
    EXPECT_EQ(cameras().pose(), pose);
    reformat().camerasFollow()->click();
    const int steps = document().undoStack().index();
    path().setPlace(half);
    for (int view = 0; view < ViewLink::count; ++view) {
      EXPECT_LT(glm::distance(cameras().camera(view).target, path().curve().place(half).point), 1e-9);
      EXPECT_LT(
          glm::distance(directionOf(cameras().camera(view)), directionOf(pose.cameras[static_cast<std::size_t>(view)])),
          1e-9);
    }
    EXPECT_EQ(document().undoStack().index(), steps);
    EXPECT_EQ(window_->sessions().controller().session().followsPath, true);
    document().undoStack().undo();
    EXPECT_EQ(cameras().pose(), pose);
    reformat().camerasFollow()->click();
    EXPECT_FALSE(options().followsPath());
  }
  void expectNeighboursGoAlong(double z) {
    // In a line of many points, those near to the one that is dragged go along.
    std::vector<glm::dvec3> line;
    for (int x = -20; x <= 20; x += 2) line.push_back({x, 0, z});
    path().movePoint(line, 10, {0, 8, 0});
    const std::vector<glm::dvec3>& moved = document().path();
    EXPECT_EQ(moved[10], glm::dvec3(0, 8, z));
    EXPECT_NEAR(moved[11].y, 8.0 * 0.75, 1e-9) << "cos² of a third of a right angle";
    EXPECT_NEAR(moved[9].y, moved[11].y, 1e-9);
    EXPECT_EQ(moved[13], line[13]);
    EXPECT_EQ(moved[0], line[0]);
  }
  /// Once it is grown. `middle` and `length` are those of a straight path along an axis.
  void expectTubeInFocus(glm::dvec3 middle, double length, double radius) {
    ASSERT_TRUE(QTest::qWaitFor([this] { return document().isWhole(); }, patience));
    EXPECT_TRUE(document().showsGrowth());
    // A cylinder with half a ball at each end. Voxels of 2 mm hold the volume of a tube of 14 mm to some percent.
    const double wanted = std::numbers::pi * radius * radius * (length + 4.0 / 3.0 * radius);
    EXPECT_NEAR(document().regionVolume(), wanted, 0.05 * wanted);
    const LabelMap& steps = *document().growth()->steps;
    glm::dvec3 sum(0.0);
    double count = 0.0;
    const auto voxels = steps.voxels.as<std::uint8_t>();
    const glm::ivec3 dims = steps.grid.dims;
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x)
          if (voxels[steps.grid.offset({x, y, z})] > 0) {
            sum += glm::dvec3(steps.grid.worldFromIndex() * glm::dvec4(x, y, z, 1.0));
            ++count;
          }
    ASSERT_GT(count, 0.0);
    EXPECT_LT(glm::distance(sum / count, middle), 0.5) << "a quarter of a voxel";
  }
  void waitForPictures() {
    ASSERT_TRUE(QTest::qWaitFor([this] { return reformat().isVisible() && !reformat().isBusy(); }, patience));
  }
};

TEST_F(ReformatWindow, APathIsClickedStraightenedMovedAlongAndUndone) {
  const double z = cursor().position().z;
  press("S");
  ASSERT_TRUE(path().isDrawing());
  EXPECT_TRUE(reformat().findChild<QToolButton*>(QStringLiteral("choice"))->isChecked());
  ASSERT_TRUE(QTest::qWaitFor([this] { return reformat().isVisible(); }, patience));
  waitUntilDrawn();  // the dock has taken its room from the views
  const Focus focus = document().focus();
  for (const glm::dvec3 point : {glm::dvec3(-30, 0, z), {0, 10, z}, {20, 30, z}}) click(point);
  ASSERT_EQ(path().draft().size(), 3u);
  EXPECT_EQ(document().focus(), focus) << "a click draws, and chooses no focus";
  EXPECT_TRUE(document().path().empty());
  QTest::keyClick(axial(), Qt::Key_Backspace);
  EXPECT_EQ(path().draft().size(), 2u);
  click({30, 0, z});
  QTest::keyClick(axial(), Qt::Key_Return);
  EXPECT_FALSE(path().isDrawing());
  ASSERT_EQ(document().path().size(), 3u);
  // A click hits a pixel of the view, and a slice, which lies up to half its 2 mm from the crosshair.
  EXPECT_LT(glm::distance(document().path()[1], glm::dvec3(0, 10, z)), 1.5);
  waitForPictures();

  // The picture is that of the library, which the command line writes.
  const auto& shown = reformat().straight().pixels();
  const reformat::StraightPicture wanted =
      reformat::straightened(*document().scene().volume, path().curve(), 2.0, 50.0, 0.0);
  ASSERT_EQ(shown.width, wanted.width);
  ASSERT_EQ(shown.height, wanted.height);
  EXPECT_EQ(shown.values, wanted.values);
  EXPECT_FALSE(reformat().across().pixels().values.empty());

  // A click in the middle of the picture takes the crosshair to the middle of the path, and a crosshair moves the
  // place.
  const QRectF inside = reformat().straight().shownIn();
  QTest::mouseClick(&reformat().straight(), Qt::LeftButton, {}, inside.center().toPoint());
  const double half = 0.5 * path().curve().length();
  // A pixel of the widget, and a voxel that the last row may lack.
  const double slack = 2.0 + path().curve().length() / inside.height();
  EXPECT_NEAR(path().place(), half, slack);
  EXPECT_LT(glm::distance(cursor().position(), path().curve().place(path().place()).point), 1e-6);
  cursor().moveTo(document().path()[0]);
  EXPECT_NEAR(path().place(), 0.0, 1e-6);
  QTest::keyClick(&reformat().straight(), Qt::Key_Down);
  EXPECT_NEAR(path().place(), 2.0, 1e-9) << "a voxel";
  const WindowLevel window = document().window();
  drag(&reformat().straight(), inside.center().toPoint(), inside.center().toPoint() + QPoint(30, 0));
  EXPECT_GT(document().window().width, window.width);

  expectCamerasFollow(half);
  expectNeighboursGoAlong(z);
  document().undoStack().undo();
  document().undoStack().undo();
  EXPECT_TRUE(document().path().empty());
  EXPECT_FALSE(path().hasPath());
  document().undoStack().redo();
  EXPECT_EQ(document().path().size(), 3u);
}

TEST_F(ReformatWindow, ADoubleClickEndsAPathAndEscDropsIt) {
  const double z = cursor().position().z;
  press("S");
  ASSERT_TRUE(QTest::qWaitFor([this] { return reformat().isVisible(); }, patience));
  waitUntilDrawn();
  click({-30, 0, z});
  press("Esc");
  EXPECT_FALSE(path().isDrawing());
  EXPECT_TRUE(document().path().empty());
  press("S");
  click({-30, 0, z});
  click({30, 0, z});
  QTest::mouseDClick(axial(), Qt::LeftButton, {}, at({30, 0, z}));
  EXPECT_FALSE(path().isDrawing());
  EXPECT_EQ(document().path().size(), 2u);
  EXPECT_FALSE(views().isMaximised());
  press("S");
  press("D");
  EXPECT_FALSE(path().isDrawing()) << "a measure takes the mouse";
  press("S");
  EXPECT_FALSE(measuring().kind());
}

TEST_F(ReformatWindow, TheFocusGivesItsCentreLineWithAreas) {
  open(tubeStudy());
  document().focusOn(tube);
  const auto follow = [this] {
    window_->findChild<QAction*>(QStringLiteral("followFocus"))->trigger();
    ASSERT_TRUE(QTest::qWaitFor([this] { return reformat().isVisible() && !reformat().isBusy(); }, patience));
  };
  follow();
  ASSERT_TRUE(path().hasPath());
  // 36 slices of 2 mm; the ends lie on the surface, to a voxel each.
  EXPECT_NEAR(path().curve().length(), 72.0, 4.0);
  path().setPlace(0.5 * path().curve().length());
  ASSERT_TRUE(QTest::qWaitFor([this] { return !reformat().isBusy() && reformat().section(); }, patience));
  // Half a voxel.
  EXPECT_NEAR(reformat().section()->radius(), tubeRadius, 1.0);
  EXPECT_NEAR(reformat().section()->centre.x, 5.0, 1.0);
  EXPECT_NEAR(reformat().section()->centre.y, -5.0, 1.0);
  // A ball with a cube taken out of it is no tube.
  open(markedBall());
  EXPECT_FALSE(path().hasPath()) << "it belongs to the study";
  document().focusOn(body);
  follow();
  EXPECT_FALSE(path().hasPath());
  EXPECT_TRUE(reformat().text().contains(QStringLiteral("no tube"))) << reformat().text().toStdString();
  document().setFocus(std::monostate{});
  follow();
  EXPECT_TRUE(reformat().text().contains(QStringLiteral("into focus first"))) << reformat().text().toStdString();
}

TEST_F(ReformatWindow, TheViewOpensAlongThePathAndGoesWithIt) {
  open(tubeStudy());
  document().focusOn(tube);
  const std::vector<glm::dvec3> line{{5, -5, -30}, {5, -5, 30}};
  document().setPath(line, QStringLiteral("Path"));
  window_->findChild<QDockWidget*>(QStringLiteral("reformatDock"))->show();
  path().setPlace(30.0);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !reformat().isBusy() && reformat().section(); }, patience));
  const int steps = document().undoStack().index();
  reformat().opensAlong()->click();
  EXPECT_EQ(document().undoStack().index(), steps + 1);
  expectTubeInFocus({5, -5, 0}, 60.0, reformat().tubeRadius()->value());
  EXPECT_TRUE(reformat().opensAlong()->isChecked());
  // The area stays that of the vessel: the tube's own says nothing.
  path().setPlace(20.0);
  ASSERT_TRUE(QTest::qWaitFor([this] { return !reformat().isBusy() && reformat().section(); }, patience));
  EXPECT_NEAR(reformat().section()->radius(), tubeRadius, 1.0);
  reformat().followFocus();
  EXPECT_EQ(document().path(), line);
  EXPECT_TRUE(reformat().text().contains(QStringLiteral("untick"))) << reformat().text().toStdString();

  reformat().tubeRadius()->setValue(14.0);
  expectTubeInFocus({5, -5, 0}, 60.0, 14.0);
  // Another path takes the tube along, in one step.
  document().setPath({{-10, -20, 0}, {-10, 20, 0}}, QStringLiteral("Path"));
  EXPECT_EQ(document().undoStack().index(), steps + 3);
  expectTubeInFocus({-10, 0, 0}, 40.0, 14.0);
  document().undoStack().undo();
  EXPECT_EQ(document().path(), line);
  expectTubeInFocus({5, -5, 0}, 60.0, 14.0);

  // A session knows by the focus alone that it is the tube.
  io::Session session = window_->sessions().controller().session();
  session.phantom = {"head", 32};
  const std::filesystem::path file = tests::scratchFolder() / "tube.fenestra";
  io::writeSession(file, session);
  const io::Session read = io::readSession(file);
  EXPECT_EQ(viewer::tubeRadius(read.look.focus, read.path), std::optional(14.0));
  EXPECT_EQ(viewer::tubeRadius(read.look.focus, {{5, -5, -30}, {5, -5, 31}}), std::nullopt);

  reformat().opensAlong()->click();
  EXPECT_EQ(document().focus(), Focus(LabelFocus{{tube}})) << "what was in focus before";
  document().undoStack().undo();
  EXPECT_TRUE(reformat().opensAlong()->isChecked());
  document().setPath({}, QStringLiteral("Delete"));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(document().focus()));
  EXPECT_FALSE(reformat().opensAlong()->isEnabled());
  document().undoStack().undo();
  expectTubeInFocus({5, -5, 0}, 60.0, 14.0);
}

TEST_F(ReformatWindow, SessionsKeepThePath) {
  document().setPath({{0, 0, 0}, {10, 0, 5}, {20, 1, 9}}, QStringLiteral("Path"));
  io::Session session = window_->sessions().controller().session();
  session.phantom = {"head", 32};
  const std::filesystem::path file = tests::scratchFolder() / "path.fenestra";
  io::writeSession(file, session);
  io::Study again = markedBall();
  again.session = io::readSession(file);
  const std::vector<glm::dvec3> kept = document().path();
  open(markedBall());
  EXPECT_TRUE(document().path().empty());
  open(again);
  EXPECT_EQ(document().path(), kept);
  EXPECT_TRUE(path().hasPath());
}

}  // namespace
}  // namespace fenestra::viewer::reformatWindowTest
