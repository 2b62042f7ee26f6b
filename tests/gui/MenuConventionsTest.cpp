// Every key of the menus, pressed as a user does. The list comes from the program: a key without a case here fails.

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QSignalSpy>

#include "tests/gui/Conventions.h"
#include "tests/gui/Patience.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/TestData.h"
#include "viewer/dialogs/Dialogs.h"
#include "viewer/dialogs/WindowLevelDialog.h"
#include "viewer/files/Sessions.h"
#include "viewer/guide/Guide.h"
#include "viewer/guide/GuideWindow.h"
#include "viewer/guide/WelcomePage.h"
#include "viewer/model/StudyLink.h"

namespace fenestra::viewer {

void Conventions::addStudyCases(Cases& cases) {
  cases["Ctrl+PgDown"] = cases["Ctrl+PgUp"] = [this] {
    const std::filesystem::path folder = tests::scratchFolder() / "two series";
    std::filesystem::create_directories(folder);
    for (int image = 0; image < 6; ++image) {
      tests::DicomSpec spec;
      spec.series = image < 3 ? "1.2.1" : "1.2.2";
      spec.seriesNumber = image < 3 ? "2" : "1";
      spec.instance = "1.2.9." + std::to_string(image);
      spec.columns = spec.rows = 16;
      spec.position = glm::dvec3(0, 0, image % 3);
      spec.words.assign(256, 100);
      tests::writeDicom(folder / std::to_string(image), spec);
    }
    window_->sessions().questions().saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Discard; };
    drop({folder});
    const std::string first = document().study().series.id, other = first == "1.2.1" ? "1.2.2" : "1.2.1";
    for (const char* keys : {"Ctrl+PgDown", "Ctrl+PgUp"}) {
      const std::string wanted = document().study().series.id == first ? other : first;
      press(keys);
      EXPECT_TRUE(QTest::qWaitFor([&] { return document().study().series.id == wanted; }, patience)) << keys;
      waitUntilDrawn();
    }
    open(markedBall());
  };
  cases["M"] = cases["Shift+M"] = cases["F6"] = cases["F9"] = [this] {
    MainWindow& beside = window_->showBeside();
    QSignalSpy opened(&beside, &MainWindow::opened);
    beside.open([](const io::Progress&) { return markedBall(); });
    ASSERT_TRUE(opened.count() > 0 || opened.wait(patience));
    beside.workspace().cursor.moveTo({4, 4, 4});
    cursor().moveTo({0, 0, 0});
    press("Shift+M");
    EXPECT_TRUE(window_->link().isMatched());
    press("M");
    EXPECT_FALSE(window_->link().isLinked());
    press("M");
    EXPECT_TRUE(window_->link().isLinked());
    const QWidget* focus = window_->findChild<QWidget*>(QStringLiteral("focusDock"));
    expectToggle("F9", [focus] { return focus->isVisible(); });
    press("F6");
    EXPECT_TRUE(QTest::qWaitFor([&] { return QApplication::activeWindow() == &beside; }, patience));
    beside.sessions().questions().saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Discard; };
    beside.close();
    QApplication::setActiveWindow(window_.get());
    window_->resize(1280, 800);
    waitUntilDrawn();
  };
  cases["Ctrl+W"] = [this] {
    window_->sessions().questions().saveChanges = [](const QStringList&) { return SessionQuestions::Answer::Discard; };
    press("Ctrl+W");
    EXPECT_FALSE(document().hasVolume());
    EXPECT_TRUE(window_->findChild<WelcomePage*>()->isVisible());
    open(markedBall());
  };
}

void Conventions::addFileAndEditCases(Cases& cases) {
  for (const char* keys : {"Ctrl+Shift+O", "Ctrl+O", "Ctrl+L", "Ctrl+E", "Ctrl+B", "Ctrl+Shift+B", "?"})
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
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), patience));
    QApplication::setActiveWindow(window_.get());
  };
  const auto undoAndRedo = [this] {
    document().focusOn(marker);
    document().focusOn(body);
    press("Ctrl+Z");
    EXPECT_TRUE(document().isFocused(marker));
    press("Ctrl+Shift+Z");
    EXPECT_TRUE(document().isFocused(body));
    press("Ctrl+Z");
    press("Ctrl+Y");
    EXPECT_TRUE(document().isFocused(body));
  };
  cases["Ctrl+Z"] = cases["Ctrl+Shift+Z"] = cases["Ctrl+Y"] = undoAndRedo;
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

void Conventions::addLayoutCases(Cases& cases) {
  const std::pair<const char*, const char*> layouts[] = {
      {"Ctrl+1", "five"},  {"Ctrl+3", "pair"}, {"Ctrl+4", "large3d"}, {"Ctrl+5", "slices"},
      {"Ctrl+6", "axial"}, {"Ctrl+7", "four"}, {"Ctrl+8", "beside"}};
  for (const auto& layout : layouts)
    cases[layout.first] = [this, layout] {
      press(layout.first);
      EXPECT_EQ(views().arrangement().id, std::string(layout.second));
      press("Ctrl+1");
      waitUntilDrawn();
    };
  cases["Ctrl+2"] = [this] {
    axial()->setFocus();
    press("Ctrl+2");
    EXPECT_TRUE(views().isMaximised());
    EXPECT_TRUE(axial()->isVisible());
    EXPECT_FALSE(volume(0)->isVisible());
    views().showAll();
    waitUntilDrawn();
  };
  cases["X"] = cases["Y"] = cases["Z"] = [this] {
    axial()->setFocus();
    press("X");
    EXPECT_EQ(axial()->turn(), (SliceView::Turn{true, 0}));
    press("Y");
    EXPECT_EQ(axial()->turn(), (SliceView::Turn{false, 2}));
    press("Z");
    EXPECT_EQ(axial()->turn(), (SliceView::Turn{false, 3}));
    EXPECT_EQ(slice(SlicePlane::Coronal)->turn(), SliceView::Turn{});
    press("Z");
  };
  cases["J"] = [this] {
    axial()->setFocus();
    press("J");
    EXPECT_TRUE(axial()->isTrueSize());
    axial()->resetView();
  };
  cases["U"] = [this] { expectToggle("U", [this] { return options().isNeurological(); }); };
  cases["K"] = cases["Shift+K"] = cases["Ctrl+K"] = [this] {
    axial()->setFocus();
    const int first = axial()->slice();
    press("Shift+K");
    press("K");
    EXPECT_TRUE(QTest::qWaitFor([&] { return axial()->slice() != first; }, patience));
    press("Ctrl+K");
    press("K");
    const int stopped = axial()->slice();
    QTest::qWait(300);  // three slices' time
    EXPECT_EQ(axial()->slice(), stopped);
  };
  cases["N"] = cases["Shift+N"] = [this] {
    axial()->setFocus();
    press("N");
    EXPECT_EQ(views().activeView(), slice(SlicePlane::Sagittal));
    press("Shift+N");
    EXPECT_EQ(views().activeView(), axial());
  };
}

void Conventions::addViewCases(Cases& cases) {
  cases["Shift+A"] = [this] { expectLook("Shift+A", {0, 1, 0}); };
  cases["Shift+P"] = [this] { expectLook("Shift+P", {0, -1, 0}); };
  cases["Shift+L"] = [this] { expectLook("Shift+L", {-1, 0, 0}); };
  cases["Shift+R"] = [this] { expectLook("Shift+R", {1, 0, 0}); };
  cases["Shift+S"] = [this] { expectLook("Shift+S", {0, 0, -1}); };
  cases["Shift+I"] = [this] { expectLook("Shift+I", {0, 0, 1}); };
  cases["Num+1"] = [this] { expectLook("Num+1", {0, 1, 0}); };
  cases["Ctrl+Num+1"] = [this] { expectLook("Ctrl+Num+1", {0, -1, 0}); };
  cases["Num+3"] = [this] { expectLook("Num+3", {-1, 0, 0}); };
  cases["Ctrl+Num+3"] = [this] { expectLook("Ctrl+Num+3", {1, 0, 0}); };
  cases["Num+7"] = [this] { expectLook("Num+7", {0, 0, -1}); };
  cases["Ctrl+Num+7"] = [this] { expectLook("Ctrl+Num+7", {0, 0, 1}); };
  addLayoutCases(cases);
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
  for (const char* keys : {"Shift+F", "V", "Shift+V"})
    cases[keys] = [this, keys] {
      axial()->setFocus();
      press("Shift+F");
      EXPECT_EQ(planes().pose(SlicePlane::Axial).follow, PlaneFollow::C1);
      planes().setFollow(SlicePlane::Coronal, PlaneFollow::C2);
      press(keys);
      EXPECT_EQ(planes().pose(SlicePlane::Axial).follow, PlaneFollow::None);
      EXPECT_EQ(planes().isTurned(SlicePlane::Axial), std::string(keys) == "Shift+F");
      EXPECT_EQ(planes().isTurned(SlicePlane::Coronal), std::string(keys) != "Shift+V");
      planes().resetAll();
    };
  cases["F11"] = [this] { expectToggle("F11", [this] { return window_->isFullScreen(); }); };
  for (const auto& [keys, dock] :
       {std::pair("Ctrl+T", "tagsDock"), std::pair("Ctrl+Shift+T", "labelTableDock"),
        std::pair("Ctrl+Shift+D", "keyImagesDock"), std::pair("Ctrl+Shift+R", "reformatDock")})
    cases[keys] = [this, keys = keys, dock = dock] {
      const QWidget* shown = window_->findChild<QWidget*>(QLatin1String(dock));
      expectToggle(keys, [shown] { return shown->isVisible(); });
    };
  cases["Ctrl+D"] = [this] {
    const std::size_t before = document().keyImages().size();
    press("Ctrl+D");
    EXPECT_EQ(document().keyImages().size(), before + 1);
  };
  cases["Esc"] = [this] {
    views().toggleMaximised(axial());
    press("Esc");
    EXPECT_FALSE(views().isMaximised());
  };
}

Conventions::Cases Conventions::menuCases() {
  Cases cases;
  addStudyCases(cases);
  addFileAndEditCases(cases);
  addViewCases(cases);
  // The windows of product conventions, width and level.
  cases["1"] = [this] { expectWindow("1", {400.0, 40.0}); };
  cases["3"] = [this] { expectWindow("3", {110.0, 35.0}); };
  cases["4"] = [this] { expectWindow("4", {320.0, 50.0}); };
  cases["5"] = [this] { expectWindow("5", {400.0, 80.0}); };
  cases["6"] = [this] { expectWindow("6", {2000.0, 350.0}); };
  cases["7"] = [this] { expectWindow("7", {1500.0, -500.0}); };
  cases["8"] = [this] { expectWindow("8", {40.0, 40.0}); };
  cases["9"] = [this] { expectWindow("9", {215.0, 75.0}); };
  cases["0"] = [this] { expectWindow("0", {150.0, 30.0}); };
  cases["I"] = [this] { expectToggle("I", [this] { return document().isInverted(); }); };
  cases["W"] = [this] {
    press("W");
    auto* dialog = window_->findChild<WindowLevelDialog*>();
    ASSERT_TRUE(dialog);
    dialog->close();
    QApplication::setActiveWindow(window_.get());
  };
  const std::pair<const char*, MeasureKind> tools[] = {{"D", MeasureKind::Distance},    {"A", MeasureKind::Angle},
                                                       {"Q", MeasureKind::Ellipse},     {"B", MeasureKind::Rectangle},
                                                       {"Shift+D", MeasureKind::Arrow}, {"Shift+T", MeasureKind::Text}};
  for (const auto& tool : tools)
    cases[tool.first] = [this, tool] {
      waitUntilDrawn();  // Esc would stop what is under way first
      press(tool.first);
      EXPECT_EQ(measuring().kind(), tool.second);
      press("Esc");
      EXPECT_FALSE(measuring().kind());
    };
  cases["S"] = [this] {
    expectToggle("S", [this] { return window_->workspace().path.isDrawing(); });
    window_->findChild<QWidget*>(QStringLiteral("reformatDock"))->hide();
    waitUntilDrawn();
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

TEST_F(Conventions, Thorough_EveryKeyOfTheMenusDoesWhatItSays) {
  std::set<std::string> keys;
  for (const MenuKey& each : menuKeys(*qobject_cast<QMainWindow*>(window_.get())->menuBar())) {
    EXPECT_TRUE(keys.insert(each.keys.toStdString()).second) << each.keys.toStdString() << " twice";
    EXPECT_TRUE(keysHtml(*qobject_cast<QMainWindow*>(window_.get())->menuBar()).contains(each.text.toHtmlEscaped()));
  }
  run(menuCases(), keys);
}

}  // namespace fenestra::viewer
