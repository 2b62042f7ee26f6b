// Every key of the menus, pressed as a user does. The list comes from the program: a key without a case here fails.

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include "tests/gui/Conventions.h"
#include "tests/support/TestData.h"
#include "viewer/dialogs/Dialogs.h"
#include "viewer/dialogs/WindowLevelDialog.h"
#include "viewer/files/Sessions.h"
#include "viewer/guide/Guide.h"
#include "viewer/guide/GuideWindow.h"

namespace fenestra::viewer {

void Conventions::addFileAndEditCases(Cases& cases) {
  for (const char* keys : {"Ctrl+Shift+O", "Ctrl+O", "Ctrl+L", "Ctrl+E", "?"})
    cases[keys] = [this, keys] { expectDialog(keys); };
  for (const char* keys : {"Ctrl+S", "Ctrl+Shift+S"})
    cases[keys] = [this, keys] {
      int asked = 0;
      window_->sessions().questions().saveWhere = [&](const std::filesystem::path&) {
        ++asked;
        return std::optional<std::filesystem::path>();
      };
      press(keys);
      EXPECT_EQ(asked, 1);
    };
  cases["F1"] = [this] {
    press("F1");
    ASSERT_NE(window_->guide().window(), nullptr);
    EXPECT_TRUE(window_->guide().window()->isVisible());
    window_->guide().window()->close();
    QApplication::setActiveWindow(window_.get());
  };
  cases["Ctrl+C"] = [this] {
    QGuiApplication::clipboard()->clear();
    press("Ctrl+C");
    EXPECT_TRUE(QTest::qWaitFor([] { return !QGuiApplication::clipboard()->image().isNull(); }, patience));
  };
  cases["Ctrl+Q"] = [this] {
    window_->sessions().questions().saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Discard; };
    press("Ctrl+Q");
    EXPECT_FALSE(window_->isVisible());
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());
  };
  const auto undoAndRedo = [this] {
    document().focusOn(marker);
    document().focusOn(body);
    press("Ctrl+Z");
    EXPECT_TRUE(document().isFocused(marker));
    press("Ctrl+Shift+Z");
    EXPECT_TRUE(document().isFocused(body));
  };
  cases["Ctrl+Z"] = cases["Ctrl+Shift+Z"] = undoAndRedo;
  cases["P"] = [this] { expectToggle("P", [this] { return brush().isActive(); }); };
  cases["E"] = [this] {
    press("P");
    const BrushMode mode = brush().settings().mode;
    press("E");
    EXPECT_NE(brush().settings().mode, mode);
    press("Esc");
    EXPECT_FALSE(brush().isActive());
  };
  for (const char* keys : {"[", "]"})
    cases[keys] = [this, keys] {
      const double radius = brush().settings().radius;
      press(keys);
      EXPECT_EQ(*keys == '[', brush().settings().radius < radius);
      EXPECT_NE(brush().settings().radius, radius);
    };
}

void Conventions::addViewCases(Cases& cases) {
  cases["Shift+A"] = [this] { expectLook("Shift+A", {0, 1, 0}); };
  cases["Shift+P"] = [this] { expectLook("Shift+P", {0, -1, 0}); };
  cases["Shift+L"] = [this] { expectLook("Shift+L", {-1, 0, 0}); };
  cases["Shift+R"] = [this] { expectLook("Shift+R", {1, 0, 0}); };
  cases["Shift+S"] = [this] { expectLook("Shift+S", {0, 0, -1}); };
  cases["Shift+I"] = [this] { expectLook("Shift+I", {0, 0, 1}); };
  cases["F5"] = [this] {
    document().focusOn(marker);
    const ViewLink::Pose before = cameras().pose();
    press("F5");
    waitUntilDrawn();
    EXPECT_NE(cameras().pose(), before);
  };
  for (const char* keys : {"R", "Ctrl+R"})
    cases[keys] = [this, keys] {
      volume(0)->setFocus();
      press("Ctrl+R");
      const ViewLink::Pose reset = cameras().pose();
      cameras().orbit(0, 0.3, 0.2);
      press(keys);
      EXPECT_EQ(cameras().pose().cameras, reset.cameras);
    };
  cases["L"] = [this] { expectToggle("L", [this] { return cameras().isLinked(); }); };
  cases["F"] = [this] { expectToggle("F", [this] { return cameras().isFrozen(); }); };
  cases["Ctrl+P"] = [this] {
    expectToggle("Ctrl+P", [this] { return cameras().projection() == Projection::Orthographic; });
  };
  cases["C"] = [this] { expectToggle("C", [this] { return options().crosshair(); }); };
  cases["O"] = [this] { expectToggle("O", [this] { return options().labels(); }); };
  cases["T"] = [this] { expectToggle("T", [this] { return options().text(); }); };
  cases["H"] = [this] { expectToggle("H", [this] { return options().hidesPatient(); }); };
  cases["Shift+O"] = [this] { expectToggle("Shift+O", [this] { return options().planes(); }); };
  for (const char* keys : {"Shift+F", "N", "Shift+N"})
    cases[keys] = [this, keys] {
      axial()->setFocus();
      press("Shift+F");
      EXPECT_EQ(planes().pose(SlicePlane::Axial).follow, PlaneFollow::C1);
      planes().setFollow(SlicePlane::Coronal, PlaneFollow::C2);
      press(keys);
      EXPECT_EQ(planes().pose(SlicePlane::Axial).follow, PlaneFollow::None);
      EXPECT_EQ(planes().isTurned(SlicePlane::Axial), std::string(keys) == "Shift+F");
      EXPECT_EQ(planes().isTurned(SlicePlane::Coronal), std::string(keys) != "Shift+N");
      planes().resetAll();
    };
  cases["F11"] = [this] { expectToggle("F11", [this] { return window_->isFullScreen(); }); };
  cases["Esc"] = [this] {
    views().toggleMaximised(axial());
    press("Esc");
    EXPECT_FALSE(views().isMaximised());
  };
}

Conventions::Cases Conventions::menuCases() {
  Cases cases;
  addFileAndEditCases(cases);
  addViewCases(cases);
  // The windows of product conventions, width and level.
  cases["1"] = [this] { expectWindow("1", {400.0, 40.0}); };
  cases["3"] = [this] { expectWindow("3", {110.0, 35.0}); };
  cases["4"] = [this] { expectWindow("4", {320.0, 50.0}); };
  cases["5"] = [this] { expectWindow("5", {400.0, 80.0}); };
  cases["6"] = [this] { expectWindow("6", {2000.0, 350.0}); };
  cases["7"] = [this] { expectWindow("7", {1500.0, -500.0}); };
  cases["I"] = [this] { expectToggle("I", [this] { return document().isInverted(); }); };
  cases["W"] = [this] {
    press("W");
    auto* dialog = window_->findChild<WindowLevelDialog*>();
    ASSERT_TRUE(dialog);
    dialog->close();
    QApplication::setActiveWindow(window_.get());
  };
  const std::pair<const char*, MeasureKind> tools[] = {{"D", MeasureKind::Distance},
                                                       {"A", MeasureKind::Angle},
                                                       {"Q", MeasureKind::Ellipse},
                                                       {"B", MeasureKind::Rectangle}};
  for (const auto& tool : tools)
    cases[tool.first] = [this, tool] {
      press(tool.first);
      EXPECT_EQ(measuring().kind(), tool.second);
      press("Esc");
      EXPECT_FALSE(measuring().kind());
    };
  cases["Ctrl+Shift+C"] = cases["Del"] = [this] {
    document().setMeasures({{MeasureKind::Distance, {{0, 0, 1}, {9, 0, 1}}, {1, 0, 0}, {0, 1, 0}}}, {});
    measuring().select(0);
    press("Ctrl+Shift+C");
    press("Del");
    EXPECT_TRUE(document().measures().empty());
  };
  cases["G"] = [this] { expectToggle("G", [this] { return options().grows(); }); };
  cases[","] = cases["."] = [this] {
    document().growFrom(markerCentre);
    ASSERT_TRUE(QTest::qWaitFor([this] { return document().isWhole(); }, patience));
    const int step = document().regionStep();
    press(".");
    EXPECT_GT(document().regionStep(), step);
    press(",");
    EXPECT_EQ(document().regionStep(), step);
  };
  cases["Ctrl+Backspace"] = [this] {
    document().focusOn(marker);
    press("Ctrl+Backspace");
    EXPECT_TRUE(std::holds_alternative<std::monostate>(document().focus()));
  };
  return cases;
}

TEST_F(Conventions, EveryKeyOfTheMenusDoesWhatItSays) {
  std::set<std::string> keys;
  for (const MenuKey& each : menuKeys(*qobject_cast<QMainWindow*>(window_.get())->menuBar())) {
    EXPECT_TRUE(keys.insert(each.keys.toStdString()).second) << each.keys.toStdString() << " twice";
    EXPECT_TRUE(keysHtml(*qobject_cast<QMainWindow*>(window_.get())->menuBar()).contains(each.text.toHtmlEscaped()));
  }
  run(menuCases(), keys);
}

}  // namespace fenestra::viewer
