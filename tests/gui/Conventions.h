#pragma once
// What the tests of keys and gestures share: a case for each, by its name in the program's list.

#include <functional>
#include <map>
#include <set>
#include <string>

#include <QApplication>
#include <QDialog>
#include <QMouseEvent>
#include <QTest>
#include <QTimer>

#include "tests/gui/WindowFixture.h"
#include "viewer/panels/AppearancePanel.h"

namespace fenestra::viewer {

class Conventions : public Window {
 protected:
  using Cases = std::map<std::string, std::function<void()>>;

  void press(const char* keys) {
    QApplication::setActiveWindow(window_.get());  // a dialog may have been it
    const QKeyCombination key = QKeySequence(QLatin1String(keys))[0];
    QTest::keyClick(window_.get(), key.key(), key.keyboardModifiers());
  }
  /// The action opens a dialog, which is closed again.
  template <class Action>
  void expectDialogOf(const Action& action) {
    bool opened = false;
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, [&] {
      if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
        opened = true;
        dialog->reject();
      }
    });
    poll.start(20);
    action();
    EXPECT_TRUE(QTest::qWaitFor([&] { return opened; }, patience));
    EXPECT_TRUE(QTest::qWaitFor([] { return !QApplication::activeModalWidget(); }, patience));
  }
  void expectDialog(const char* keys) {
    expectDialogOf([&] { press(keys); });
  }
  void expectWindow(const char* key, WindowLevel wanted) {
    press(key);
    EXPECT_EQ(document().window(), wanted);
  }
  void expectLook(const char* keys, glm::dvec3 forward) {
    press(keys);
    EXPECT_LT(glm::distance(cameras().camera(0).axes().forward, forward), 1e-9);
  }
  /// The keys turn an option over, and back.
  void expectToggle(const char* keys, const std::function<bool()>& is) {
    const bool before = is();
    press(keys);
    EXPECT_NE(is(), before);
    press(keys);
    EXPECT_EQ(is(), before);
  }
  void run(const Cases& cases, const std::set<std::string>& wanted) {
    for (const std::string& each : wanted) EXPECT_TRUE(cases.contains(each)) << each << " has no test";
    for (const auto& [name, check] : cases) {
      SCOPED_TRACE(name);
      EXPECT_TRUE(wanted.contains(name)) << "the list has no such entry";
      check();
    }
  }
  void move(QWidget* view, QPoint at, Qt::KeyboardModifiers modifiers = {}, Qt::MouseButton button = Qt::NoButton) {
    QMouseEvent event(QEvent::MouseMove, at, view->mapToGlobal(at), Qt::NoButton, button, modifiers);
    QApplication::sendEvent(view, &event);
  }
  SliceView* axial() { return slice(SlicePlane::Axial); }
  QPoint at(glm::dvec3 world) { return axial()->widgetFromWorld(world).toPoint(); }
  TransferFunctionPlot& plot() { return panel<AppearancePanel>().editor().plot(); }
  MeasureMode& measuring() { return window_->workspace().measuring; }
  SlicePlanes& planes() { return window_->workspace().planes; }
  Cases menuCases();
  void addStudyCases(Cases& cases);
  void addFileAndEditCases(Cases& cases);
  void addViewCases(Cases& cases);
  void addLayoutCases(Cases& cases);
  Cases sliceGestures();
  void addVolumeGestures(Cases& cases);
  void addEditorGestures(Cases& cases);
  void addGesturesOfAllViews(Cases& cases);
  void addArchiveGestures(Cases& cases);
  void addListGestures(Cases& cases);
  void addKeyImageGestures(Cases& cases);
  void addReformatGestures(Cases& cases);
};

}  // namespace fenestra::viewer
