// A monkey at mouse and keyboard: random events on everything that the window shows, while it loads, grows, places and
// draws. The window must survive, answer, and keep no OpenGL objects behind.
//
// FENESTRA_MONKEY_EVENTS sets the number of events of each seed; some hundred by default.

#include <cstdlib>
#include <iostream>
#include <random>

#include <epoxy/gl.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QElapsedTimer>
#include <QMenu>
#include <QTest>
#include <QTimer>

#include "tests/gui/WindowFixture.h"

namespace fenestra::viewer {
namespace {

int eventCount() {
  const char* wanted = std::getenv("FENESTRA_MONKEY_EVENTS");
  return wanted ? std::max(1, std::atoi(wanted)) : 100;
}

/// Names of OpenGL objects in use in the current context.
int glObjects() {
  constexpr GLuint mostNames = 20000;
  int count = 0;
  for (GLuint name = 1; name < mostNames; ++name)
    count += glIsTexture(name) + glIsBuffer(name) + glIsFramebuffer(name) + glIsQuery(name);
  return count;
}

}  // namespace

class Monkey : public Window, public testing::WithParamInterface<unsigned> {
 protected:
  void SetUp() override {
    Window::SetUp();
    // Dialogs and menus wait for an answer: the monkey waits a moment and leaves them.
    QObject::connect(&closer_, &QTimer::timeout, [] {
      if (QWidget* popup = QApplication::activePopupWidget()) popup->close();
      if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) dialog->reject();
    });
    closer_.start(40);
  }

  int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(std::max(1, bound))); }
  template <class T>
  T oneOf(std::initializer_list<T> choices) {
    return choices.begin()[below(static_cast<int>(choices.size()))];
  }
  Qt::KeyboardModifiers modifiers() {
    return oneOf<Qt::KeyboardModifiers>(
        {Qt::NoModifier, Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier, Qt::AltModifier});
  }
  QPoint pointIn(const QWidget& widget) { return {below(widget.width()), below(widget.height())}; }

  /// A view half of the time, else any widget.
  QWidget* target() {
    QList<QWidget*> choices;
    if (below(2) == 0) {
      for (VolumeView* view : views().volumeViews()) choices << view;
      for (SliceView* view : views().sliceViews()) choices << view;
    } else {
      choices = window_->findChildren<QWidget*>();
    }
    choices.removeIf([](const QWidget* widget) { return !widget->isVisible() || !widget->isEnabled(); });
    return choices.isEmpty() ? window_.get() : choices[below(static_cast<int>(choices.size()))];
  }

  void press() {
    QWidget* widget = target();
    const auto button = oneOf({Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::RightButton, Qt::MiddleButton});
    switch (below(4)) {
      case 0:
        QTest::mouseClick(widget, button, modifiers(), pointIn(*widget));
        break;
      case 1:
        QTest::mouseDClick(widget, button, modifiers(), pointIn(*widget));
        break;
      case 2:
        wheel(widget, below(7) - 3, modifiers());
        break;
      default:
        drag(widget, pointIn(*widget), pointIn(*widget), button, modifiers());
    }
  }

  void type() {
    const auto key = oneOf(
        {Qt::Key_Left,   Qt::Key_Right,       Qt::Key_Up,    Qt::Key_Down,   Qt::Key_Escape, Qt::Key_P, Qt::Key_E,
         Qt::Key_C,      Qt::Key_O,           Qt::Key_T,     Qt::Key_G,      Qt::Key_L,      Qt::Key_R, Qt::Key_F5,
         Qt::Key_Delete, Qt::Key_BracketLeft, Qt::Key_Comma, Qt::Key_Period, Qt::Key_1,      Qt::Key_3, Qt::Key_5,
         Qt::Key_PageUp, Qt::Key_Space,       Qt::Key_Tab,   Qt::Key_Return, Qt::Key_Z});
    QWidget* receiver = QApplication::focusWidget() ? QApplication::focusWidget() : window_.get();
    QTest::keyClick(receiver, key, key == Qt::Key_Z ? Qt::ControlModifier : modifiers());
  }

  void command() {
    QList<QAction*> actions = window_->findChildren<QAction*>();
    actions.removeIf([](const QAction* action) {
      return !action->isEnabled() || action->menu() || action->text().contains(QStringLiteral("Quit"));
    });
    if (!actions.isEmpty()) actions[below(static_cast<int>(actions.size()))]->trigger();
  }

  void load() {
    Study study = markedBall();
    if (below(2) == 0) study.scene.labels = nullptr;
    if (below(4) == 0) {
      window_->open([](const io::Progress&) -> Study { throw io::Error("ball.nii", "is torn", "take another"); });
    } else {
      window_->open([study](const io::Progress&) { return study; });
    }
  }

  void act() {
    const int choice = below(100);
    if (choice < 55) {
      press();
    } else if (choice < 78) {
      type();
    } else if (choice < 92) {
      command();
    } else if (choice < 95) {
      window_->resize(500 + below(1200), 400 + below(800));
    } else if (choice < 97) {
      load();
    } else {
      QTest::qWait(below(120));
    }
    QCoreApplication::processEvents();
  }

  /// The window as it is after opening a study, whatever was done to it.
  int objectsAtRest() {
    QTest::qWait(200);                             // dialogs are closed
    QApplication::setActiveWindow(window_.get());  // as no window manager does after a dialog
    window_->setWindowState(Qt::WindowNoState);
    window_->resize(1280, 800);
    for (int i = 0; i < 4; ++i) QTest::keyClick(window_.get(), Qt::Key_Escape);
    for (QAction* action : window_->findChildren<QAction*>())
      if (action->text().remove(QLatin1Char('&')) == QStringLiteral("Reset layout")) action->trigger();
    setAutomatic(false);
    options().setGrows(true);
    open(markedBall());
    int objects = 0;
    volume(0)->inContext([&](const auto&) { objects = glObjects(); });
    return objects;
  }

  std::mt19937 random_{GetParam()};
  QTimer closer_;
};

TEST_P(Monkey, TheWindowSurvivesAndAnswers) {
  const int events = eventCount();
  QElapsedTimer clock;
  qint64 longest = 0;
  int before = 0;
  for (int half = 0; half < 2; ++half) {
    for (int i = 0; i < events / 2; ++i) {
      clock.start();
      act();
      longest = std::max(longest, clock.elapsed());
      ASSERT_TRUE(window_->isVisible()) << "closed by event " << i;
    }
    const int objects = objectsAtRest();
    ASSERT_GT(objects, 0);
    // The second half may leave programs compiled and pictures of efforts tried that the first did not need; what grows
    // with each event would be hundreds.
    if (half == 1) {
      EXPECT_LE(objects, before + 40);
    }
    before = objects;
  }
  std::cerr << "longest event: " << longest << " ms\n";
  // A click after it all: the cross-hair follows.
  const glm::dvec3 at = cursor().position();
  QTest::mouseClick(slice(SlicePlane::Axial), Qt::LeftButton, {},
                    slice(SlicePlane::Axial)->rect().center() / 2 + QPoint(60, 60));
  EXPECT_NE(cursor().position(), at);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Monkey, testing::Values(1u, 2u, 3u, 4u, 5u));

}  // namespace fenestra::viewer
