// The editor of transfer functions in the window, with real events of mouse and keys.

#include <cmath>
#include <fstream>

#include <QApplication>
#include <QColorDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>

#include "io/TransferFunctionFile.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/panels/AppearancePanel.h"

namespace fenestra::viewer::editorWindowTest {
namespace {

// A value and an opacity are read off a pixel of the plot, which is over 150 pixels wide and 50 high.
constexpr double valuePerPixel = 2000.0 / 150.0, opacityPerPixel = 1.0 / 50.0;

class EditorWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    QApplication::setActiveWindow(window_.get());
    bringUp("contextDock");
    plot().setFocus();
  }
  TransferFunctionEditor& editor() { return panel<AppearancePanel>().editor(); }
  TransferFunctionPlot& plot() { return editor().plot(); }
  const TransferFunction& function() { return document().look().context.function; }
  double opacity(std::size_t node) { return opacityFromExtinction(function().nodes.at(node).properties.extinction); }
  QPoint at(double value, double opacity) { return plot().place(value, opacity).toPoint(); }
  QPoint nodeAt(std::size_t node) { return at(function().nodes.at(node).value, opacity(node)); }
  int steps() { return document().undoStack().count(); }

  /// Two edges from -100 to 300 HU around a plateau of half opacity.
  void setTrapezoid() {
    Look look = document().look();
    const OpticalProperties none{{1.0, 0.5, 0.2}, 0.0}, half{{1.0, 0.5, 0.2}, extinctionFromOpacity(0.5)};
    look.context.function.nodes = {{-100.0, none}, {0.0, half}, {200.0, half}, {300.0, none}};
    document().edit({}, look);
    document().undoStack().clear();
  }
  /// Expects one step of the history that undo takes back to the bit.
  void expectOneStep(const Look& before) {
    EXPECT_EQ(steps(), 1);
    const Look after = document().look();
    EXPECT_NE(after, before);
    document().undoStack().undo();
    EXPECT_EQ(document().look(), before);
    document().undoStack().redo();
    EXPECT_EQ(document().look(), after);
  }
};

TEST_F(EditorWindow, PointsAreDraggedAsOneStepWhileTheViewsFollow) {
  waitUntilDrawn();
  const QImage first = picture(volume(0));
  const Look before = document().look();
  int changes = 0;
  QObject::connect(&document(), &Document::transferFunctionChanged, &plot(), [&] { ++changes; });
  drag(&plot(), nodeAt(1), at(400.0, 0.25));
  EXPECT_GE(changes, 3) << "the views follow while the mouse moves";
  EXPECT_NEAR(function().nodes[1].value, 400.0, valuePerPixel);
  EXPECT_NEAR(opacity(1), 0.25, opacityPerPixel);
  EXPECT_EQ(function().nodes[0], before.context.function.nodes[0]);
  expectOneStep(before);
  waitUntilDrawn();
  EXPECT_NE(picture(volume(0)), first);
}

TEST_F(EditorWindow, PointsStayBetweenTheirNeighboursAndInTheFrame) {
  drag(&plot(), nodeAt(0), at(0.0, 0.0) + QPoint(500, 900));
  EXPECT_EQ(function().nodes[0].value, function().nodes[1].value);
  EXPECT_EQ(function().nodes[0].properties.extinction, 0.0);
  drag(&plot(), nodeAt(1), nodeAt(1) + QPoint(2000, -900));
  EXPECT_LE(function().nodes[1].value, plot().axis().high);
  EXPECT_NEAR(opacity(1), 1.0, 1e-5) << "the most that an extinction stands for";
}

TEST_F(EditorWindow, ADragThatReturnsOrIsCancelledLeavesNothing) {
  document().setPreset("ct-bone");
  document().undoStack().clear();
  const Look before = document().look();
  const QPoint from = nodeAt(2);
  QTest::mousePress(&plot(), Qt::LeftButton, {}, from);
  QTest::mouseMove(&plot(), from + QPoint(20, 20));
  QMouseEvent move(QEvent::MouseMove, from + QPoint(20, 20), plot().mapToGlobal(from), Qt::NoButton, Qt::LeftButton,
                   {});
  QApplication::sendEvent(&plot(), &move);
  EXPECT_NE(document().look(), before);
  EXPECT_EQ(document().preset(), "");
  QTest::keyClick(&plot(), Qt::Key_Escape);
  EXPECT_EQ(document().look(), before) << "the preset's name, too";
  EXPECT_EQ(steps(), 0);
  QTest::mouseRelease(&plot(), Qt::LeftButton, {}, from);
  EXPECT_EQ(document().look(), before);
  QTest::mouseClick(&plot(), Qt::LeftButton, {}, from);
  EXPECT_EQ(document().look(), before) << "a click only selects";
  EXPECT_EQ(plot().selected(), 2u);
  EXPECT_EQ(steps(), 0);
}

TEST_F(EditorWindow, AStudyThatArrivesDuringADragKeepsItsFunction) {
  document().setPreset("ct-bone");
  const QPoint from = nodeAt(2), to = from + QPoint(20, 20);
  const auto moveTo = [&](QPoint at) {
    QMouseEvent move(QEvent::MouseMove, at, plot().mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&plot(), &move);
  };
  QTest::mousePress(&plot(), Qt::LeftButton, {}, from);
  moveTo(to);
  const io::Study study = markedBall();
  open(study);
  EXPECT_EQ(document().look(), study.scene.look);
  moveTo(from);
  QTest::mouseRelease(&plot(), Qt::LeftButton, {}, from);
  EXPECT_EQ(document().look(), study.scene.look);
  EXPECT_EQ(steps(), 0);
}

TEST_F(EditorWindow, ADoubleClickAddsAPointAndDeleteRemovesIt) {
  const Look before = document().look();
  QTest::mouseDClick(&plot(), Qt::LeftButton, {}, at(500.0, 0.5));
  ASSERT_EQ(function().nodes.size(), 3u);
  EXPECT_EQ(plot().selected(), 2u);
  EXPECT_NEAR(function().nodes[2].value, 500.0, valuePerPixel);
  EXPECT_NEAR(opacity(2), 0.5, opacityPerPixel);
  EXPECT_EQ(function().nodes[2].properties.colour, before.context.function.evaluate(500.0).colour);
  expectOneStep(before);
  QTest::keyClick(&plot(), Qt::Key_Delete);
  EXPECT_EQ(function(), before.context.function);
  QTest::keyClick(&plot(), Qt::Key_Delete);
  QTest::keyClick(&plot(), Qt::Key_Delete);
  EXPECT_EQ(function().nodes.size(), 1u) << "the last point stays";
}

TEST_F(EditorWindow, TrapezoidsMoveByTheirEdgesPlateauAndInside) {
  setTrapezoid();
  const Look before = document().look();
  const auto values = [this] {
    std::vector<double> all;
    for (const auto& node : function().nodes) all.push_back(node.value);
    return all;
  };
  const double oneUp = extinctionFromOpacity(0.5);
  drag(&plot(), at(100.0, 0.5), at(100.0, 0.8));
  EXPECT_NEAR(opacity(1), 0.8, opacityPerPixel);
  EXPECT_EQ(opacity(1), opacity(2));
  EXPECT_EQ(values(), (std::vector<double>{-100.0, 0.0, 200.0, 300.0})) << "up and down alone";
  expectOneStep(before);
  document().undoStack().undo();
  ASSERT_EQ(function().nodes[1].properties.extinction, oneUp);

  drag(&plot(), at(-50.0, 0.25), at(-250.0, 0.25));
  EXPECT_NEAR(function().nodes[0].value, -300.0, 2.0 * valuePerPixel);
  EXPECT_NEAR(function().nodes[1].value - function().nodes[0].value, 100.0, 1e-9) << "the edge keeps its slope";
  EXPECT_EQ(function().nodes[2].value, 200.0);
  EXPECT_EQ(function().nodes[1].properties.extinction, oneUp);
  document().undoStack().undo();

  drag(&plot(), at(250.0, 0.25), at(450.0, 0.25));
  EXPECT_NEAR(function().nodes[3].value, 500.0, 2.0 * valuePerPixel);
  EXPECT_EQ(function().nodes[1].value, 0.0);
  document().undoStack().undo();

  drag(&plot(), at(100.0, 0.2), at(-200.0, 0.4));
  for (std::size_t node = 0; node < 4; ++node)
    EXPECT_NEAR(function().nodes[node].value - before.context.function.nodes[node].value, -300.0, 2.0 * valuePerPixel);
  EXPECT_EQ(function().nodes[1].properties.extinction, oneUp) << "to the side alone";
  document().undoStack().undo();

  drag(&plot(), nodeAt(1), nodeAt(1) + QPoint(0, 20));
  EXPECT_EQ(opacity(1), opacity(2)) << "a corner takes the plateau along";
  EXPECT_LT(opacity(1), 0.5);
}

TEST_F(EditorWindow, ATrapezoidIsColouredAndDeletedAsOne) {
  setTrapezoid();
  QTest::mouseClick(&plot(), Qt::LeftButton, {}, at(100.0, 0.2));
  plot().setColour({0.1, 0.8, 0.4});
  for (const auto& node : function().nodes) EXPECT_EQ(node.properties.colour, glm::dvec3(0.1, 0.8, 0.4));
  QTest::mouseClick(&plot(), Qt::LeftButton, {}, nodeAt(2));
  plot().setColour({0.9, 0.1, 0.1});
  EXPECT_EQ(function().nodes[1].properties.colour, glm::dvec3(0.1, 0.8, 0.4)) << "a point alone";
  QTest::mouseClick(&plot(), Qt::LeftButton, {}, at(100.0, 0.2));
  QTest::keyClick(&plot(), Qt::Key_Delete);
  EXPECT_EQ(function().nodes.size(), 4u) << "there would be nothing left";
  plot().addNode(800.0, 0.3);
  QTest::mouseClick(&plot(), Qt::LeftButton, {}, at(100.0, 0.2));
  const Look before = document().look();
  document().undoStack().clear();
  QTest::keyClick(&plot(), Qt::Key_Delete);
  ASSERT_EQ(function().nodes.size(), 1u);
  EXPECT_EQ(function().nodes[0].value, 800.0);
  expectOneStep(before);
}

TEST_F(EditorWindow, TheMenuAddsATrapezoidThatMovesAsOne) {
  const auto choose = [this](const char* name, QPoint where) {
    QMenu menu;
    plot().fillMenu(menu, where);
    for (QAction* action : menu.actions())
      if (action->text() == QLatin1String(name)) return action->trigger();
    ADD_FAILURE() << name << " is not in the menu";
  };
  const Look before = document().look();
  choose("Add a trapezoid", at(-600.0, 0.5));
  ASSERT_EQ(trapezoidsOf(function()), std::vector<std::size_t>{0});
  EXPECT_EQ(plot().selected(), 1u);
  EXPECT_NEAR(0.5 * (function().nodes[0].value + function().nodes[3].value), -600.0, valuePerPixel);
  expectOneStep(before);
  choose("Delete the point", nodeAt(1));
  EXPECT_EQ(function().nodes.size(), 5u);
  choose("Add a point", at(600.0, 0.3));
  EXPECT_EQ(function().nodes.size(), 6u);
}

TEST_F(EditorWindow, KeysMoveSelectAddAndDelete) {
  setTrapezoid();
  const Look before = document().look();
  ASSERT_TRUE(plot().hasFocus());
  QTest::keyClick(&plot(), Qt::Key_Home);
  QTest::keyClick(&plot(), Qt::Key_PageDown);
  EXPECT_EQ(plot().selected(), 1u);
  QTest::keyClick(&plot(), Qt::Key_End);
  EXPECT_EQ(plot().selected(), 3u);
  QTest::keyClick(&plot(), Qt::Key_PageUp);
  EXPECT_EQ(plot().selected(), 2u);
  EXPECT_EQ(document().look(), before);
  QTest::keyClick(&plot(), Qt::Key_Right);
  const double moved = function().nodes[2].value - 200.0;
  EXPECT_GT(moved, 0.0);
  QTest::keyClick(&plot(), Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(function().nodes[2].value, 200.0 - 9.0 * moved, 1e-6);
  QTest::keyClick(&plot(), Qt::Key_Up);
  EXPECT_NEAR(opacity(2), 0.51, 1e-12);
  EXPECT_EQ(opacity(1), opacity(2));
  QTest::keyClick(&plot(), Qt::Key_Down, Qt::AltModifier);
  EXPECT_NEAR(opacity(1), 0.5, 1e-12);
  const double first = function().nodes[0].value;
  QTest::keyClick(&plot(), Qt::Key_Left, Qt::AltModifier);
  EXPECT_LT(function().nodes[0].value, first) << "the whole trapezoid";
  EXPECT_EQ(steps(), 5);
  QTest::keyClick(&plot(), Qt::Key_Insert);
  EXPECT_EQ(function().nodes.size(), 5u);
  QTest::keyClick(&plot(), Qt::Key_Backspace);
  EXPECT_EQ(function().nodes.size(), 4u);
  while (document().undoStack().canUndo()) document().undoStack().undo();
  EXPECT_EQ(document().look(), before);
}

TEST_F(EditorWindow, AHeldKeyIsOneStep) {
  const Look before = document().look();
  QTest::keyPress(&plot(), Qt::Key_Up);
  for (int times = 0; times < 3; ++times) {
    QKeyEvent again(QEvent::KeyPress, Qt::Key_Up, {}, {}, true);
    QApplication::sendEvent(&plot(), &again);
  }
  QTest::keyRelease(&plot(), Qt::Key_Up);
  expectOneStep(before);
}

TEST_F(EditorWindow, NumbersAndColourAreExact) {
  const auto type = [](QDoubleSpinBox* box, const char* text) {
    box->setFocus();
    box->findChild<QLineEdit*>()->selectAll();
    QTest::keyClicks(box, QLatin1String(text));
    QTest::keyClick(box, Qt::Key_Return);
  };
  plot().select(1);
  type(editor().value(), "123.5");
  EXPECT_EQ(function().nodes[1].value, 123.5);
  type(editor().opacity(), "37.5");
  EXPECT_NEAR(opacity(1), 0.375, 1e-12);
  const int before = steps();
  QTimer::singleShot(0, [] {
    for (int i = 0; i < 100; ++i)
      if (auto* dialog = qobject_cast<QColorDialog*>(QApplication::activeModalWidget())) {
        dialog->setCurrentColor(QColor(10, 200, 30));
        return dialog->accept();
      }
  });
  QTest::mouseDClick(&plot(), Qt::LeftButton, {}, nodeAt(1));
  // QColor gives its 16 bits a channel as float.
  EXPECT_LT(glm::distance(function().nodes[1].properties.colour, glm::dvec3(10.0, 200.0, 30.0) / 255.0), 1e-6);
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(editor().value()->value(), 123.5);
}

TEST_F(EditorWindow, ShiftMovesWhatThePlotShowsAndEditsComeOutRight) {
  document().setShift(250.0);
  EXPECT_EQ(plot().function().nodes[1].value, 250.0);
  EXPECT_EQ(function().nodes[1].value, 0.0);
  const TransferFunction::Node untouched = function().nodes[0];
  plot().select(1);
  plot().setValue(400.0);
  EXPECT_EQ(function().nodes[1].value, 150.0);
  EXPECT_EQ(function().nodes[0], untouched);
}

TEST_F(EditorWindow, TheWheelEnlargesTheValuesUnderTheMouse) {
  const ValueRange all = plot().shown();
  wheel(&plot(), 4);
  const ValueRange near = plot().shown();
  EXPECT_NEAR(near.high - near.low, (all.high - all.low) / std::pow(1.25, 4), 1e-6);
  drag(&plot(), plot().rect().center(), plot().rect().center() + QPoint(10, 0), Qt::MiddleButton);
  EXPECT_LT(plot().shown().low, near.low);
  wheel(&plot(), -20);
  EXPECT_EQ(plot().shown(), all);
  plot().clearFocus();
  wheel(&plot(), 4);
  EXPECT_EQ(plot().shown(), all) << "without the focus it scrolls the panel";
}

TEST_F(EditorWindow, AFocusOnValuesIsABoxToDrag) {
  document().setFocus(ValueFocus{{500.0, 800.0}, 0.0});
  waitUntilDrawn();
  plot().setTarget({FunctionTarget::Kind::Focus});
  document().undoStack().clear();
  const Look before = document().look();
  const auto values = [this] { return std::get<ValueFocus>(document().focus()).values; };
  const double level = opacityFromExtinction(before.focusAppearance.extinction);
  drag(&plot(), at(500.0, 0.4), at(300.0, 0.4));
  EXPECT_NEAR(values().low, 300.0, 2.0 * valuePerPixel);
  EXPECT_EQ(values().high, 800.0);
  expectOneStep(before);
  const double low = values().low;
  drag(&plot(), at(600.0, 0.3), at(650.0, 0.3));
  EXPECT_NEAR(values().low - low, 50.0, 2.0 * valuePerPixel);
  EXPECT_NEAR(values().high, 850.0, 2.0 * valuePerPixel);
  drag(&plot(), at(0.5 * (values().low + values().high), level), at(600.0, 0.3));
  EXPECT_NEAR(opacityFromExtinction(document().look().focusAppearance.extinction), 0.3, opacityPerPixel);
  plot().setColour({0.1, 0.2, 0.9});
  EXPECT_EQ(document().look().focusAppearance.colour, glm::dvec3(0.1, 0.2, 0.9));
}

TEST_F(EditorWindow, EachLabelInFocusHasALevelAndAColour) {
  document().setFocus(LabelFocus{{body, marker}});
  QComboBox* targets = editor().targets();
  ASSERT_EQ(targets->count(), 4);
  EXPECT_EQ(targets->itemText(3), QStringLiteral("Focus: marker"));
  targets->setCurrentIndex(3);
  Q_EMIT targets->activated(3);
  const double level = opacityFromExtinction(document().look().focusAppearance.extinction);
  document().undoStack().clear();
  const Look before = document().look();
  drag(&plot(), at(0.0, level), at(0.0, 0.2));
  Scene scene = document().scene();
  EXPECT_NEAR(opacityFromExtinction(focusMaterial(scene, marker).extinction), 0.2, opacityPerPixel);
  EXPECT_EQ(focusMaterial(scene, body).extinction, before.focusAppearance.extinction);
  expectOneStep(before);
  plot().setColour({0.2, 0.4, 0.6});
  EXPECT_EQ(document().labelSetting(marker).colour, glm::dvec3(0.2, 0.4, 0.6));
  document().focusOn(body);
  EXPECT_EQ(plot().target(), FunctionTarget()) << "its label has left the focus";
}

/// The greatest difference in any channel, 0 to 255; 256 for other sizes.
int greatestDifference(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 256;
  int most = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      most =
          std::max({most, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
    }
  return most;
}

TEST_F(EditorWindow, ALabelInFocusIsShownByValueAndByOneMaterialAgain) {
  document().setFocus(LabelFocus{{marker}});
  waitUntilDrawn();
  EXPECT_FALSE(editor().byValue()->isVisible()) << "the context has a function anyway";
  editor().targets()->setCurrentIndex(2);
  Q_EMIT editor().targets()->activated(2);
  ASSERT_TRUE(editor().byValue()->isVisible());
  EXPECT_FALSE(editor().byValue()->isChecked());
  document().undoStack().clear();
  const Look before = document().look();
  const QImage material = picture(volume(0));
  editor().byValue()->click();
  expectOneStep(before);
  EXPECT_TRUE(editor().byValue()->isChecked());
  EXPECT_EQ(document().labelSetting(body), LabelSetting{.label = body}) << "only the label that was chosen";
  waitUntilDrawn();
  // At first the function is constant and equals the material. By value, normal quality lights a segment in two halves,
  // not in one.
  EXPECT_LE(greatestDifference(picture(volume(0)), material), 8);

  ASSERT_EQ(plot().function().nodes.size(), 2u);
  const Look flat = document().look();
  document().undoStack().clear();
  plot().select(1);
  plot().setColour({1.0, 0.0, 0.2});
  plot().select(0);
  plot().setColour({1.0, 0.0, 0.2});
  waitUntilDrawn();
  EXPECT_GT(greatestDifference(picture(volume(0)), material), 20) << "the views follow";
  plot().addNode(plot().shown().low, 0.25);
  EXPECT_EQ(plot().function().nodes.size(), 3u);
  while (document().undoStack().canUndo()) document().undoStack().undo();
  EXPECT_EQ(document().look(), flat);
  editor().byValue()->click();
  EXPECT_EQ(document().look(), before);
  EXPECT_FALSE(editor().byValue()->isChecked());
}

TEST_F(EditorWindow, AFunctionIsTakenFromAPresetOrAFile) {
  document().setFocus(LabelFocus{{marker}});
  waitUntilDrawn();
  EXPECT_FALSE(editor().presets()->isVisible()) << "the context has a list of its own";
  editor().targets()->setCurrentIndex(2);
  Q_EMIT editor().targets()->activated(2);
  ASSERT_TRUE(editor().presets()->isVisible());
  document().undoStack().clear();
  const Look before = document().look();
  const QImage material = picture(volume(0));
  const auto choose = [&](const QString& name) {
    Q_EMIT editor().presets()->menu()->aboutToShow();
    for (QAction* action : editor().presets()->menu()->actions())
      if (action->text() == name) return action->trigger();
    ADD_FAILURE() << "no entry " << name.toStdString();
  };
  choose(QStringLiteral("CT bone"));
  expectOneStep(before);
  EXPECT_EQ(document().labelSetting(marker).function,
            io::loadContextFunction("ct-bone", *document().scene().volume).function);
  EXPECT_EQ(document().look().context, before.context);
  EXPECT_TRUE(editor().byValue()->isChecked());
  waitUntilDrawn();
  EXPECT_GT(greatestDifference(picture(volume(0)), material), 20);

  const std::filesystem::path file = tests::scratchFolder() / "own.json";
  std::ofstream(file)
      << R"({"name": "own", "domain": "value", "nodes": [{"value": 5, "colour": [1, 0, 0], "opacity": 0.5}]})";
  editor().functionWhich() = [&] { return std::optional(file); };
  choose(QStringLiteral("From a file…"));
  ASSERT_TRUE(document().labelSetting(marker).function);
  EXPECT_EQ(document().labelSetting(marker).function->nodes.size(), 1u);
  const Look own = document().look();
  std::ofstream(file) << "torn";
  choose(QStringLiteral("From a file…"));
  EXPECT_EQ(document().look(), own);
  EXPECT_TRUE(window_->notices().texts().join(QLatin1Char(' ')).contains(QStringLiteral("own.json")));
}

TEST_F(EditorWindow, AFocusOnValuesIsShownByValue) {
  document().setFocus(ValueFocus{{500.0, 800.0}, 0.0});
  waitUntilDrawn();
  plot().setTarget({FunctionTarget::Kind::Focus});
  document().undoStack().clear();
  const Look before = document().look();
  editor().byValue()->click();
  expectOneStep(before);
  const auto& appearance = document().look().focusAppearance;
  ASSERT_TRUE(appearance.function);
  ASSERT_EQ(appearance.function->nodes.size(), 2u);
  EXPECT_EQ(appearance.function->nodes[0].value, 500.0);
  EXPECT_EQ(appearance.function->nodes[1].value, 800.0);
  EXPECT_EQ(appearance.function->nodes[0].properties.colour, appearance.colour);
  document().undoStack().clear();
  const Look flat = document().look();
  const double level = opacityFromExtinction(appearance.extinction);
  drag(&plot(), at(800.0, level), at(700.0, 0.4));
  expectOneStep(flat);
  EXPECT_NEAR(appearance.function->nodes[1].value, 700.0, 2.0 * valuePerPixel);
  EXPECT_EQ(std::get<ValueFocus>(document().focus()).values, std::get<ValueFocus>(before.focus).values)
      << "what is focus stays";
}

}  // namespace
}  // namespace fenestra::viewer::editorWindowTest
