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

/// As one reads: no step of Tab within a panel goes back up, but to the top of a column further right.
TEST_F(Keyboard, TabGoesDownEachPanel) {
  int steps = 0;
  // Those that are not open at first, too: a row of them where nothing covers the column of panels.
  for (QDockWidget* dock : window_->findChildren<QDockWidget*>())
    if (dock->isHidden()) dock->show();
  waitUntilDrawn();
  forEachDock([&] {
    QWidget* before = volume(0);
    before->setFocus(Qt::TabFocusReason);
    for (int presses = 0; presses < 300; ++presses) {
      QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
      QWidget* now = QApplication::focusWidget();
      if (!now || now == volume(0)) break;
      const auto dockOf = [](QWidget* widget) -> QDockWidget* {
        for (QWidget* each = widget; each; each = each->parentWidget())
          if (auto* dock = qobject_cast<QDockWidget*>(each)) return dock;
        return nullptr;
      };
      QDockWidget* dock = dockOf(now);
      if (dock && dock == dockOf(before)) {
        const QRect from(before->mapTo(dock, QPoint()), before->size()), to(now->mapTo(dock, QPoint()), now->size());
        // A title's buttons stand beside it, and a list holds what is edited in it.
        const bool isUp = to.bottom() <= from.top() && to.left() < from.right();
        EXPECT_FALSE(isUp) << nameOf(before) << "\n-> " << nameOf(now);
        ++steps;
      }
      before = now;
    }
  });
  EXPECT_GT(steps, 50);
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
