// Every gesture of the list of keys, performed as a user does. The list comes from the program: a gesture without a
// case here fails.

#include <QAction>
#include <QGuiApplication>
#include <QInputDialog>
#include <QMenu>

#include "tests/gui/Conventions.h"
#include "tests/support/TestData.h"
#include "viewer/dialogs/Dialogs.h"
#include "viewer/dialogs/Gestures.h"
#include "viewer/files/Sessions.h"

namespace fenestra::viewer {

Conventions::Cases Conventions::sliceGestures() {
  Cases cases;
  cases["Slices: Click"] = cases["Slices: Ctrl+click"] = [this] {
    cursor().moveTo(markerCentre);
    QTest::mouseClick(axial(), Qt::LeftButton, {}, at(markerCentre));
    EXPECT_EQ(document().focus(), Focus(LabelFocus{{marker}}));
    QTest::mouseClick(axial(), Qt::LeftButton, Qt::ControlModifier, at({-10, 10, markerCentre.z}));
    EXPECT_EQ(document().focus(), Focus(LabelFocus{{body, marker}}));
  };
  cases["Slices: Drag"] = cases["Slices: Ctrl+double-click"] = [this] {
    const WindowLevel before = document().window();
    drag(axial(), {100, 100}, {150, 100});
    EXPECT_GT(document().window().width, before.width);
    EXPECT_EQ(document().window().level, before.level) << "across is the width alone";
    drag(axial(), {100, 100}, {100, 130});
    EXPECT_GT(document().window().level, before.level) << "down is the level";
    QTest::mouseDClick(axial(), Qt::LeftButton, Qt::ControlModifier, {100, 100});
    EXPECT_EQ(document().window(), document().scene().volume->defaultWindow());
  };
  cases["Slices: Home, End"] = [this] {
    for (SliceView* view : views().sliceViews()) {
      QTest::keyClick(view, Qt::Key_Home);
      EXPECT_EQ(view->slice(), 0);
      QTest::keyClick(view, Qt::Key_End);
      EXPECT_EQ(view->slice(), view->sliceGeometry().count - 1);
    }
    cursor().moveTo({0, 0, 0});
  };
  cases["Slices: Wheel, arrows"] = cases["Slices: Page up, Page down"] = [this] {
    for (SliceView* view : views().sliceViews()) {
      cursor().moveTo({0, 0, 0});
      const int first = view->slice();
      wheel(view, 1);
      EXPECT_EQ(view->slice(), first + 1);
      const std::pair<Qt::Key, int> keys[] = {{Qt::Key_Up, 1},    {Qt::Key_Right, 1},   {Qt::Key_Down, -1},
                                              {Qt::Key_Left, -1}, {Qt::Key_PageUp, 10}, {Qt::Key_PageDown, -10}};
      for (const auto& [key, steps] : keys) {
        const int before = view->slice();
        QTest::keyClick(view, key);
        EXPECT_EQ(view->slice(), before + steps) << key;
      }
    }
  };
  cases["Slices: Shift+wheel"] = [this] {
    wheel(axial(), 2, Qt::ShiftModifier);
    EXPECT_EQ(planes().pose(SlicePlane::Axial).slab.thickness, 2.0);
    wheel(axial(), -2, Qt::ShiftModifier);
    EXPECT_EQ(planes().pose(SlicePlane::Axial).slab.thickness, 0.0);
  };
  cases["The crosshair's lines, on the slices: Drag a ball"] =
      cases["The crosshair's lines, on the slices: Shift+drag"] =
          cases["The crosshair's lines, on the slices: Ctrl+drag"] = [this] {
            for (const Qt::KeyboardModifiers modifiers : {Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier}) {
              cursor().moveTo({0, 0, 0});
              const PlaneTool::Handle handle = axial()->planeTool().handles().at(0);
              drag(axial(), handle.at.toPoint(), handle.at.toPoint() + QPoint(60, 60), Qt::LeftButton, modifiers);
              for (const SlicePlane plane : {SlicePlane::Sagittal, SlicePlane::Coronal}) {
                const double angle = axial()->planeTool().angle(plane);
                EXPECT_EQ(planes().isTurned(plane), plane == handle.plane || modifiers == Qt::ControlModifier);
                if (modifiers == Qt::ShiftModifier) {
                  EXPECT_NEAR(std::remainder(angle, 45.0), 0.0, 1e-9);
                }
              }
              planes().resetAll();
            }
          };
  cases["Measures, on the slices: Drag, or clicks"] = cases["Measures, on the slices: Drag a handle or line"] =
      cases["Measures, on the slices: Right click on it"] = [this] {
        press("D");
        const QPoint from = at({-20, 5, cursor().position().z}), to = at({10, 5, cursor().position().z});
        drag(axial(), from, to);
        QTest::mouseClick(axial(), Qt::LeftButton, {}, from + QPoint(0, 30));
        move(axial(), to + QPoint(0, 30));
        QTest::mouseClick(axial(), Qt::LeftButton, {}, to + QPoint(0, 30));
        press("Esc");
        ASSERT_EQ(document().measures().size(), 2u);
        const Measure before = document().measures()[0];
        drag(axial(), to, to + QPoint(0, -20));
        EXPECT_NE(document().measures()[0], before);
        EXPECT_EQ(axial()->measureTool().measureAt(from), 0u) << "which a right click asks for";
        document().setMeasures({}, {});
      };
  cases["Measures, on the slices: Click, as a text's tool is chosen"] = [this] {
    press("Shift+T");
    QTest::mouseClick(axial(), Qt::LeftButton, {}, at({5, 5, cursor().position().z}));
    QInputDialog* question = nullptr;
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return (question = window_->findChild<QInputDialog*>(QStringLiteral("markText"))) != nullptr; },
        patience));
    question->setTextValue(QStringLiteral("here"));
    question->accept();
    press("Esc");
    ASSERT_EQ(document().measures().size(), 1u);
    EXPECT_EQ(document().measures()[0].text, "here");
    document().setMeasures({}, {});
  };
  cases["Clipping, while its tab is in sight: Drag a square"] =
      cases["Clipping, while its tab is in sight: Drag the ball at an arrow"] = [this] {
        options().setClipHandles(true);
        Clipping clipping;
        clipping.planes = {{{0.0, 1.0, 0.0}, 0.0}};
        document().setClipping(clipping, {});
        // The square of the only plane, and then the ball at its arrow.
        for (const std::size_t handle : {0u, 1u}) {
          const HalfSpace before = document().clipping().planes[0];
          const QPoint from = at(axial()->clipTool().handles().at(handle).at);
          drag(axial(), from, from + QPoint(25, 10));
          EXPECT_EQ(document().clipping().planes[0].normal == before.normal, handle == 0);
          EXPECT_NE(document().clipping().planes[0], before);
        }
        document().setClipping({}, {});
        options().setClipHandles(false);
      };
  return cases;
}

void Conventions::addVolumeGestures(Cases& cases) {
  cases["Walls of slices, in the 3-D views: Drag a square"] = [this] {
    Look look = document().look();
    look.method.kind = kindOf<methods::Walls>;
    document().edit({}, look);
    waitUntilDrawn();
    const WallTool::Handle handle = volume(0)->wallTool().handles().at(0);
    ASSERT_EQ(handle.plane, SlicePlane::Axial);
    const glm::dvec3 before = cursor().position();
    const QPoint from = volume(0)->widgetFromWorld(handle.at)->toPoint();
    drag(volume(0), from, from + QPoint(0, 20));
    const glm::dvec3 moved = cursor().position() - before;
    EXPECT_LT(moved.z, -1.0) << "down";
    EXPECT_EQ(glm::dvec2(moved), glm::dvec2(0.0));
    look.method = {};
    document().edit({}, look);
    cursor().moveTo(before);
    waitUntilDrawn();
  };
  cases["Outlines of the slices, in the 3-D views: Drag a ball"] = [this] {
    options().setPlanes(true);
    const PlaneBallTool::Handle handle = volume(0)->planeTool().handles().at(0);
    const QPoint from = volume(0)->widgetFromWorld(handle.at)->toPoint();
    drag(volume(0), from, from + QPoint(20, 10));
    EXPECT_TRUE(planes().isTurned(handle.plane));
    planes().resetAll();
    options().setPlanes(false);
    waitUntilDrawn();
  };
  cases["3-D views: Drag, arrows"] = [this] {
    const Camera before = cameras().camera(0);
    drag(volume(0), {200, 150}, {240, 150});
    EXPECT_NE(cameras().camera(0), before);
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Right, Qt::Key_Down}) {
      const Camera last = cameras().camera(0);
      QTest::keyClick(volume(0), key);
      EXPECT_NE(cameras().camera(0), last) << key;
    }
    press("Ctrl+R");
    waitUntilDrawn();
  };
  cases["3-D views: Shift+drag"] = [this] {
    options().setGrows(false);  // or a ball is drawn on the body
    const Camera before = cameras().camera(0);
    drag(volume(0), {200, 150}, {240, 150}, Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NE(cameras().camera(0).target, before.target);
    EXPECT_EQ(cameras().camera(0).axes().forward, before.axes().forward);
    options().setGrows(true);
    const Camera moved = cameras().camera(0);
    drag(volume(0), {4, 4}, {44, 4}, Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NE(cameras().camera(0).target, moved.target) << "beside the body";
    EXPECT_EQ(cameras().camera(0).axes().forward, moved.axes().forward);
    press("Ctrl+R");
    waitUntilDrawn();
  };
  cases["3-D views: Click"] = cases["3-D views: Ctrl+click"] = [this] {
    document().setFocus(std::monostate{});
    press("Ctrl+R");
    waitUntilDrawn();
    const QPoint middle = volume(0)->widgetFromWorld({-5.0, -44.0, -5.0}).value().toPoint();
    QTest::mouseClick(volume(0), Qt::LeftButton, {}, middle);
    EXPECT_EQ(document().focus(), Focus(LabelFocus{{body}}));
    EXPECT_LT(cursor().position().y, -35.0);
    waitUntilDrawn();
    QTest::mouseClick(volume(0), Qt::LeftButton, Qt::ControlModifier, middle);
    EXPECT_NE(document().focus(), Focus(LabelFocus{{body}}));
    document().setFocus(std::monostate{});
    waitUntilDrawn();
  };
  cases["3-D views: Wheel"] = [this] {
    const Camera before = cameras().camera(0);
    wheel(volume(0), 2);
    EXPECT_LT(glm::distance(cameras().camera(0).eye, cameras().camera(0).target),
              glm::distance(before.eye, before.target));
  };
  cases["Carving, in all views: Drag"] = cases["Carving, in all views: Ctrl+drag"] =
      cases["Carving, in all views: Shift+drag"] = [this] {
        const Look before = document().look();
        Look bends = before;
        bends.method.kind = kindOf<methods::Bend>;
        document().edit(QStringLiteral("method"), std::move(bends));
        Carving& carving = window_->workspace().carving;
        carving.setActive(true);
        waitUntilDrawn();
        const QPoint middle = volume(0)->rect().center();
        const Camera camera = cameras().camera(0);
        drag(volume(0), middle + QPoint(0, 20), middle - QPoint(0, 20));  // what is gone lies to the right
        ASSERT_EQ(document().removals().size(), 1u);
        EXPECT_EQ(cameras().camera(0), camera);
        waitUntilDrawn();
        const QPoint kept = middle - QPoint(12, 0);
        drag(volume(0), kept, kept - QPoint(20, 0), Qt::LeftButton, Qt::ShiftModifier);
        EXPECT_EQ(document().removals().front().bends.size(), 1u);
        waitUntilDrawn();
        drag(volume(0), kept, kept + QPoint(30, 0), Qt::LeftButton, Qt::ControlModifier);
        EXPECT_NE(cameras().camera(0), camera);
        carving.setActive(false);
        document().edit(QStringLiteral("as before"), before);
        waitUntilDrawn();
      };
  cases["Brush, in the 3-D views: Drag"] = cases["Brush, in the 3-D views: Ctrl+drag"] =
      cases["Brush, in the 3-D views: Shift+wheel, Shift+drag"] = [this] {
        document().focusOn(marker);
        BrushSettings open = brush().settings();
        open.mode = BrushMode::Open;
        brush().setSettings(open);
        brush().setActive(true);
        waitUntilDrawn();
        const QPoint middle = volume(0)->widgetFromWorld({-8.0, -40.0, -8.0}).value().toPoint();
        const Camera before = cameras().camera(0);
        drag(volume(0), middle, middle + QPoint(30, 0));
        EXPECT_EQ(document().strokes().size(), 1u);
        EXPECT_EQ(cameras().camera(0), before);
        drag(volume(0), middle, middle + QPoint(30, 0), Qt::LeftButton, Qt::ControlModifier);
        EXPECT_NE(cameras().camera(0), before);
        const double depth = brush().settings().depth;
        wheel(volume(0), 1, Qt::ShiftModifier);
        EXPECT_NE(brush().settings().depth, depth);
        const double deeper = brush().settings().depth;
        drag(volume(0), middle, middle + QPoint(0, 30), Qt::LeftButton, Qt::ShiftModifier);
        EXPECT_NE(brush().settings().depth, deeper);
        brush().setActive(false);
        document().setStrokes({}, {});
      };
}

void Conventions::addEditorGestures(Cases& cases) {
  // EditorWindowTest.cpp has each of these in full.
  const std::string where = "A transfer function: ";
  const auto nodes = [this] { return document().look().context.function.nodes; };
  const auto nodeAt = [this](std::size_t node) {
    const TransferFunction::Node& each = document().look().context.function.nodes.at(node);
    return plot().place(each.value, opacityFromExtinction(each.properties.extinction)).toPoint();
  };
  cases[where + "Drag a point, or a trapezoid's edge, top or inside"] = [=, this] {
    const auto before = nodes();
    drag(&plot(), nodeAt(1), nodeAt(1) + QPoint(20, 20));
    EXPECT_NE(nodes(), before);
    document().undoStack().undo();
    drag(&plot(), nodeAt(1), nodeAt(1) + QPoint(20, 10), Qt::LeftButton, Qt::ShiftModifier);
    EXPECT_NE(nodes()[1].value, before[1].value);
    EXPECT_EQ(nodes()[1].properties, before[1].properties);
    document().undoStack().undo();
  };
  cases[where + "Double-click"] = [=, this] {
    QTest::mouseDClick(&plot(), Qt::LeftButton, {}, plot().place(400.0, 0.5).toPoint());
    EXPECT_EQ(nodes().size(), 3u);
    document().undoStack().undo();
  };
  cases[where + "Right click"] = [=, this] {
    QMenu menu;
    plot().fillMenu(menu, nodeAt(1));
    EXPECT_EQ(menu.actions().size(), 4);
  };
  cases[where + "Wheel, middle drag"] = [this] {
    const ValueRange all = plot().shown();
    wheel(&plot(), 3, Qt::ControlModifier);
    const ValueRange enlarged = plot().shown();
    EXPECT_LT(enlarged.high - enlarged.low, all.high - all.low);
    drag(&plot(), plot().rect().center(), plot().rect().center() + QPoint(15, 0), Qt::MiddleButton);
    EXPECT_LT(plot().shown().low, enlarged.low);
    wheel(&plot(), -20, Qt::ControlModifier);
    EXPECT_EQ(plot().shown(), all);
  };
  cases[where + "Arrows"] = [=, this] {
    plot().select(1);
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Down, Qt::Key_Right, Qt::Key_Up}) {
      const auto before = nodes();
      QTest::keyClick(&plot(), key);
      EXPECT_NE(nodes(), before) << key;
    }
  };
  cases[where + "Page up, Page down, Home, End"] = [this] {
    const std::pair<Qt::Key, std::size_t> keys[] = {
        {Qt::Key_Home, 0}, {Qt::Key_PageDown, 1}, {Qt::Key_PageUp, 0}, {Qt::Key_End, 1}};
    for (const auto& [key, node] : keys) {
      QTest::keyClick(&plot(), key);
      EXPECT_EQ(plot().selected(), node) << key;
    }
  };
  cases[where + "Ins, Del, Return"] = [=, this] {
    QTest::keyClick(&plot(), Qt::Key_Insert);
    EXPECT_EQ(nodes().size(), 3u);
    QTest::keyClick(&plot(), Qt::Key_Delete);
    EXPECT_EQ(nodes().size(), 2u);
    expectDialogOf([this] { QTest::keyClick(&plot(), Qt::Key_Return); });
  };
}

void Conventions::addGesturesOfAllViews(Cases& cases) {
  const std::string region = "A grown region, in all views: ";
  cases[region + "Shift+drag"] = [this] {
    cursor().moveTo(markerCentre);
    const WindowLevel window = document().window();
    drag(axial(), at(markerCentre), at(markerCentre + glm::dvec3(12, 0, 0)), Qt::LeftButton, Qt::ShiftModifier);
    ASSERT_TRUE(document().region());
    EXPECT_NEAR(document().region()->ball, 12.0, 1.0);
    EXPECT_EQ(document().window(), window);
    document().setFocus(std::monostate{});
    waitUntilDrawn();
  };
  cases[region + "Shift+click"] = cases[region + "Ctrl+click"] = cases[region + "Alt+wheel"] = [this] {
    cursor().moveTo(markerCentre);
    document().growFrom(markerCentre);
    ASSERT_TRUE(QTest::qWaitFor([this] { return document().isWhole(); }, patience));
    const int step = document().regionStep();
    wheel(axial(), 1, Qt::AltModifier);
    EXPECT_NE(document().regionStep(), step);
    QTest::mouseClick(axial(), Qt::LeftButton, Qt::ShiftModifier, at(markerCentre + glm::dvec3(3, 0, 0)));
    ASSERT_TRUE(document().region());
    EXPECT_EQ(document().region()->inside.size(), 2u);
    QTest::mouseClick(axial(), Qt::LeftButton, Qt::ControlModifier, at({-10, 10, markerCentre.z}));
    ASSERT_TRUE(document().region());
    EXPECT_EQ(document().region()->outside.size(), 1u);
    document().setFocus(std::monostate{});
    waitUntilDrawn();  // Esc would end the growing
  };
  cases[region + "Enter"] = [this] {
    for (QWidget* view : {static_cast<QWidget*>(axial()), static_cast<QWidget*>(volume(0))}) {
      document().growFrom({view == axial() ? -10.0 : -8.0, 10.0, markerCentre.z});
      ASSERT_TRUE(QTest::qWaitFor([this] { return document().isWhole(); }, patience));
      ASSERT_TRUE(document().asksToOpen()) << "the ball is the body";
      QTest::keyClick(view, Qt::Key_Return);
      EXPECT_TRUE(document().showsGrowth());
      document().setFocus(std::monostate{});
      waitUntilDrawn();
    }
  };
  const std::string painting = "Painting the region, in all views: ";
  cases[painting + "Drag"] = cases[painting + "Shift+drag"] = [this] {
    cursor().moveTo(markerCentre);
    window_->workspace().selection.setActive(true);
    const auto painted = [this] {
      return document().region() ? document().region()->painted : std::vector<SelectionStroke>();
    };
    drag(axial(), at(markerCentre), at(markerCentre + glm::dvec3(12, 0, 0)));
    ASSERT_EQ(painted().size(), 1u);
    EXPECT_TRUE(painted().front().adds);
    ASSERT_TRUE(QTest::qWaitFor([this] { return document().isWhole(); }, patience));
    QTest::mouseClick(axial(), Qt::LeftButton, Qt::ShiftModifier, at(markerCentre + glm::dvec3(12, 0, 0)));
    ASSERT_EQ(painted().size(), 2u);
    EXPECT_FALSE(painted().back().adds);
    window_->workspace().selection.setActive(false);
    document().setFocus(std::monostate{});
    waitUntilDrawn();
  };
  cases["All views: Middle drag"] = [this] {
    const glm::dvec3 before = axial()->worldFromWidget({100, 100});
    drag(axial(), {100, 100}, {140, 80}, Qt::MiddleButton);
    EXPECT_LT(glm::distance(axial()->worldFromWidget({140, 80}), before), 1e-6);
    const Camera camera = cameras().camera(0);
    drag(volume(0), {200, 150}, {240, 150}, Qt::MiddleButton);
    EXPECT_NE(cameras().camera(0).target, camera.target);
    EXPECT_EQ(cameras().camera(0).axes().forward, camera.axes().forward);
  };
  cases["All views: Right drag, Ctrl+wheel"] = [this] {
    const auto width = [this] {
      return glm::distance(axial()->worldFromWidget({100, 100}), axial()->worldFromWidget({200, 100}));
    };
    const double before = width();
    drag(axial(), {100, 100}, {100, 60}, Qt::RightButton);
    EXPECT_LT(width(), before);
    const double zoomed = width();
    wheel(axial(), -2, Qt::ControlModifier);
    EXPECT_GT(width(), zoomed);
    for (const bool byWheel : {false, true}) {
      const Camera camera = cameras().camera(0);
      if (byWheel)
        wheel(volume(0), 2, Qt::ControlModifier);
      else
        drag(volume(0), {200, 150}, {200, 110}, Qt::RightButton);
      EXPECT_LT(glm::distance(cameras().camera(0).eye, cameras().camera(0).target),
                glm::distance(camera.eye, camera.target));
    }
  };
  cases["All views: Right click"] = [this] {
    int asked = 0;
    QObject::disconnect(&views(), &ViewArea::menuRequested, nullptr, nullptr);
    QObject::disconnect(&views(), &ViewArea::sliceMenuRequested, nullptr, nullptr);
    QObject::connect(&views(), &ViewArea::menuRequested, [&] { ++asked; });
    QObject::connect(&views(), &ViewArea::sliceMenuRequested, [&] { ++asked; });
    QTest::mouseClick(axial(), Qt::RightButton, {}, at({-10, 10, cursor().position().z}));
    EXPECT_EQ(asked, 1);
    press("Ctrl+R");
    waitUntilDrawn();
    QTest::mouseClick(volume(0), Qt::RightButton, {}, volume(0)->widgetFromWorld({0, -40, 0}).value().toPoint());
    EXPECT_EQ(asked, 2);
    QObject::disconnect(&views(), &ViewArea::menuRequested, nullptr, nullptr);
    QObject::disconnect(&views(), &ViewArea::sliceMenuRequested, nullptr, nullptr);
  };
  cases["All views: Shift+move"] = [this] {
    press("Ctrl+R");
    waitUntilDrawn();
    const double z = cursor().position().z;
    const QPoint place = at({-12, 8, z});
    move(axial(), place, Qt::ShiftModifier);
    EXPECT_LT(glm::distance(cursor().position(), axial()->worldFromWidget(place)), 1e-6);
    move(volume(0), volume(0)->widgetFromWorld({0, -44, 0}).value().toPoint(), Qt::ShiftModifier);
    EXPECT_LT(cursor().position().y, -35.0);
  };
  cases["All views: Double-click"] = [this] {
    for (QWidget* view : {static_cast<QWidget*>(axial()), static_cast<QWidget*>(volume(0))}) {
      // A double-click comes after a click; QTest sends the second alone.
      QTest::mouseClick(view, Qt::LeftButton, {}, view->rect().center() + QPoint(20, 10));
      QTest::mouseDClick(view, Qt::LeftButton, {}, view->rect().center() + QPoint(20, 10));
      EXPECT_TRUE(views().isMaximised());
      views().showAll();
    }
    waitUntilDrawn();
  };
}

TEST_F(Conventions, Thorough_EveryGestureDoesWhatItSays) {
  std::set<std::string> wanted;
  for (const Gesture& each : gestures) wanted.insert(std::string(each.where) + ": " + each.gesture);
  Cases cases = sliceGestures();
  addVolumeGestures(cases);
  addEditorGestures(cases);
  addGesturesOfAllViews(cases);
  addArchiveGestures(cases);
  addListGestures(cases);
  addKeyImageGestures(cases);
  addReformatGestures(cases);
  run(cases, wanted);
}

}  // namespace fenestra::viewer
