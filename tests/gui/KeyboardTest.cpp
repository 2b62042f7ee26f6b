// The keyboard reaches every control, and each shows that it has the focus.

#include <set>

#include <QAbstractButton>
#include <QApplication>
#include <QDockWidget>
#include <QTest>

#include "tests/gui/WindowFixture.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer::keyboardTest {
namespace {

class Keyboard : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    if (HasFatalFailure()) return;
    document().focusOn(marker);
    waitUntilDrawn();
  }
  /// What the keyboard should reach now.
  std::vector<QWidget*> controls() {
    std::vector<QWidget*> found;
    for (QWidget* widget : window_->findChildren<QWidget*>())
      if ((widget->focusPolicy() & Qt::TabFocus) && !widget->focusProxy() && widget->isVisible() &&
          widget->isEnabled() && widget->window() == window_.get() && !widget->visibleRegion().isEmpty())
        found.push_back(widget);
    return found;
  }
  void forEachDock(const std::function<void()>& use) {
    for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
      dock->raise();
      QTest::qWait(10);
      SCOPED_TRACE(dock->objectName().toStdString());
      use();
    }
  }
  static std::string nameOf(const QWidget* widget) {
    std::string name;
    for (const QObject* object = widget; object && name.size() < 120; object = object->parent())
      name = std::string(object->metaObject()->className()) + " " + object->objectName().toStdString() +
             (name.empty() ? "" : " > ") + name;
    return name;
  }
  /// As a widget looks on screen, with a rim in which a frame may be drawn.
  QImage look(QWidget* widget) {
    if (auto* view = qobject_cast<VolumeView*>(widget)) return view->grabSurface();
    const QRect area = QRect(widget->mapTo(window_.get(), QPoint(0, 0)), widget->size()).adjusted(-3, -3, 3, 3);
    return window_->grab(area).toImage();
  }
};

TEST_F(Keyboard, TabReachesEveryControl) {
  forEachDock([this] {
    std::set<QWidget*> reached;
    volume(0)->setFocus(Qt::TabFocusReason);
    for (int presses = 0; presses < 300; ++presses) {
      QWidget* now = QApplication::focusWidget();
      ASSERT_TRUE(now);
      reached.insert(now);
      QTest::keyClick(now, Qt::Key_Tab);
      if (QApplication::focusWidget() == volume(0)) break;
    }
    EXPECT_EQ(QApplication::focusWidget(), volume(0)) << "the round never ends";
    for (QWidget* control : controls()) {
      const auto* button = qobject_cast<QAbstractButton*>(control);
      // The arrow keys move within a group.
      if (button && button->autoExclusive()) continue;
      EXPECT_TRUE(reached.contains(control)) << nameOf(control);
    }
  });
}

TEST_F(Keyboard, TheFocusShows) {
  for (const Theme theme : {Theme::Dark, Theme::Light}) {
    applyStyle(*qApp, theme);
    forEachDock([this] {
      for (QWidget* control : controls()) {
        QWidget* elsewhere = control == volume(0) ? static_cast<QWidget*>(slice(SlicePlane::Axial)) : volume(0);
        elsewhere->setFocus(Qt::TabFocusReason);
        QTest::qWait(0);
        const QImage without = look(control);
        control->setFocus(Qt::TabFocusReason);
        QTest::qWait(0);
        if (QApplication::focusWidget() != control) continue;  // passed on
        EXPECT_NE(look(control), without) << nameOf(control);
      }
    });
  }
  applyStyle(*qApp, Theme::Dark);
}

}  // namespace
}  // namespace fenestra::viewer::keyboardTest
