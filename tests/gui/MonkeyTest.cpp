// A monkey at mouse and keyboard: random events on everything that the window shows, while it loads, grows, places and
// draws. The window must survive, answer, and keep no OpenGL objects behind.
//
// FENESTRA_MONKEY_EVENTS sets the number of events of each seed; some hundred by default.

#include <time.h>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <map>
#include <random>
#include <sstream>

#include <epoxy/gl.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDrag>
#include <QElapsedTimer>
#include <QMenu>
#include <QTest>
#include <QTimer>

#include "tests/gui/WindowFixture.h"
#include "viewer/archive/ArchiveDock.h"

namespace fenestra::viewer::monkeyTest {
namespace {

int eventCount() {
  const char* wanted = std::getenv("FENESTRA_MONKEY_EVENTS");
  return wanted ? std::max(1, std::atoi(wanted)) : 100;
}

/// OpenGL objects in use in the current context. Ours are told apart from Qt's caches of letters and pixmaps by their
/// storage, which cannot change; blocks of programs are made when a program first runs, and live as long.
struct GlObjects {
  int textures = 0, qtTextures = 0, buffers = 0, framebuffers = 0, queries = 0, programs = 0, uniformBlocks = 0;

  int kept() const { return textures + buffers + framebuffers + queries; }
};

/// A number above the names of all objects. Names of deleted objects may be given again or not: those above any that
/// were given so far are not in use.
GLuint mostNames() {
  constexpr GLuint atLeast = 20000;
  std::array<GLuint, 4> next{};
  glGenTextures(1, &next[0]);
  glGenBuffers(1, &next[1]);
  glGenFramebuffers(1, &next[2]);
  glGenQueries(1, &next[3]);
  glDeleteTextures(1, &next[0]);
  glDeleteBuffers(1, &next[1]);
  glDeleteFramebuffers(1, &next[2]);
  glDeleteQueries(1, &next[3]);
  return std::max(atLeast, *std::ranges::max_element(next));
}

GlObjects glObjects() {
  const GLuint end = mostNames();
  GlObjects count;
  for (GLuint name = 1; name < end; ++name) {
    if (glIsTexture(name)) {
      GLint fixed = GL_FALSE;
      glGetTextureParameteriv(name, GL_TEXTURE_IMMUTABLE_FORMAT, &fixed);
      ++(fixed ? count.textures : count.qtTextures);
    }
    count.framebuffers += glIsFramebuffer(name);
    count.queries += glIsQuery(name);
    count.programs += glIsProgram(name);
    if (!glIsBuffer(name)) continue;
    std::array<char, 64> label{};
    glGetObjectLabel(GL_BUFFER, name, label.size(), nullptr, label.data());
    ++(std::string_view(label.data()).starts_with("uniform block") ? count.uniformBlocks : count.buffers);
  }
  return count;
}

std::ostream& operator<<(std::ostream& out, const GlObjects& count) {
  return out << count.textures << " textures and " << count.qtTextures << " of Qt, " << count.buffers << " buffers, "
             << count.framebuffers << " framebuffers, " << count.queries << " queries, " << count.programs
             << " programs with " << count.uniformBlocks << " uniform blocks";
}

constexpr qint64 slow = 1000;  ///< ms; longer events are printed

/// Processor time of this thread: on a busy machine an event takes longer by the clock.
double processorSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string nameOf(const QObject& object) {
  std::string name = object.metaObject()->className();
  if (!object.objectName().isEmpty()) name += ' ' + object.objectName().toStdString();
  return name;
}

}  // namespace

class Monkey : public Window, public testing::WithParamInterface<unsigned> {
 protected:
  void SetUp() override {
    Window::SetUp();
    // Dialogs and menus wait for an answer: the monkey waits a moment and leaves them.
    QObject::connect(&closer_, &QTimer::timeout, [this] {
      QDrag::cancel();  // a drag of selected text waits for the display's own mouse
      if (QWidget* popup = QApplication::activePopupWidget()) {
        event_ += "; closed " + nameOf(*popup);
        popup->close();
      }
      if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
        event_ += "; left " + nameOf(*dialog) + " \"" + dialog->windowTitle().toStdString() + '"';
        dialog->reject();
      }
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
    const int way = below(4);
    event_ = std::array{"click on ", "double click on ", "wheel over ", "drag in "}[static_cast<std::size_t>(way)] +
             nameOf(*widget);
    switch (way) {
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
    event_ = "key " + QKeySequence(key).toString().toStdString() + " in " + nameOf(*receiver);
    QTest::keyClick(receiver, key, key == Qt::Key_Z ? Qt::ControlModifier : modifiers());
  }

  void command() {
    QList<QAction*> actions = window_->findChildren<QAction*>();
    actions.removeIf([](const QAction* action) {
      return !action->isEnabled() || action->menu() || action->text().contains(QStringLiteral("Quit"));
    });
    if (actions.isEmpty()) return;
    QAction* action = actions[below(static_cast<int>(actions.size()))];
    event_ = "command " + action->text().toStdString();
    action->trigger();
  }

  void load() {
    event_ = "load";
    io::Study study = markedBall();
    if (below(2) == 0) study.scene.labels = nullptr;
    if (below(4) == 0) {
      window_->open([](const io::Progress&) -> io::Study { throw io::Error("ball.nii", "is torn", "take another"); });
    } else {
      window_->open([study](const io::Progress&) { return study; });
    }
  }

  void act() {
    event_ = "wait or resize";
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
  GlObjects objectsAtRest() {
    QTest::qWait(200);                             // dialogs are closed
    QApplication::setActiveWindow(window_.get());  // as no window manager does after a dialog
    window_->setWindowState(Qt::WindowNoState);
    window_->resize(1280, 800);
    for (int i = 0; i < 4; ++i) QTest::keyClick(window_.get(), Qt::Key_Escape);
    for (QAction* action : window_->findChildren<QAction*>())
      if (action->text().remove(QLatin1Char('&')) == QStringLiteral("Reset layout")) action->trigger();
    setAutomatic(false);
    options().setGrows(true);
    views().setAtRest(Quality::Draft, std::nullopt);  // another effort needs other images
    open(markedBall());
    // Each view has a picture that is shown and one that is refined. With an opening, whose images they keep from then
    // on; whoever draws soon enough has drawn one of the two alone.
    document().focusOn(marker);
    for (const StandardView side : {StandardView::Left, StandardView::Superior, StandardView::Anterior}) {
      for (const int view : {0, 1}) cameras().face(view, side);
      waitUntilDrawn();
    }
    GlObjects objects;
    volume(0)->inGlContext([&](const auto&) { objects = glObjects(); });
    return objects;
  }

  /// The window's own widgets, without those of its dialogs and menus.
  std::map<std::string, int> widgetsByClass() const {
    std::map<std::string, int> kinds;
    for (const QWidget* each : QApplication::allWidgets())
      if (each->window() == window_.get()) ++kinds[each->metaObject()->className()];
    return kinds;
  }

  /// Windows, dialogs and menus, shown or not, without tool tips, which come and go.
  static std::ptrdiff_t windowCount() {
    const QWidgetList all = QApplication::topLevelWidgets();
    return std::count_if(all.begin(), all.end(), [](const QWidget* each) { return each->windowType() != Qt::ToolTip; });
  }

  std::mt19937 random_{GetParam()};
  std::string event_;  ///< the one that is being done, and the dialogs that it opened
  QTimer closer_;
};

TEST_P(Monkey, TheWindowSurvivesAndAnswers) {
  const int events = eventCount();
  QElapsedTimer clock;
  qint64 longest = 0;
  std::string longestEvent;
  window_->findChild<ArchiveDock*>()->panel();  // made when the dock is first shown, and kept
  GlObjects before;
  int widgetsBefore = 0;
  std::ptrdiff_t windowsBefore = 0;
  std::map<std::string, int> kindsBefore;
  for (int half = 0; half < 2; ++half) {
    for (int i = 0; i < events / 2; ++i) {
      clock.start();
      const double start = processorSeconds();
      try {
        act();
      } catch (const std::exception& error) {
        FAIL() << error.what() << " in event " << half * (events / 2) + i << ": " << event_;
      }
      const qint64 took = clock.elapsed();
      std::ostringstream text;
      text << took << " ms, " << processorSeconds() - start << " s of the thread, event " << half * (events / 2) + i
           << ": " << event_;
      if (took > slow) std::cerr << text.str() << '\n';
      if (took > longest) {
        longest = took;
        longestEvent = text.str();
      }
      ASSERT_TRUE(window_->isVisible()) << "closed by event " << i;
    }
    const GlObjects objects = objectsAtRest();
    const std::map<std::string, int> kinds = widgetsByClass();
    int widgets = 0;
    for (const auto& [kind, count] : kinds) widgets += count;
    const std::ptrdiff_t windows = windowCount();
    std::cerr << "at rest: " << objects << "; " << widgets << " widgets, " << windows << " windows\n";
    ASSERT_GT(objects.textures, 0);
    // Each of four renderers (two views, each with a picture shown and one refined) keeps the images of passes that it
    // has run once: of an opening (14), and of a picked pixel, strokes, what an opening camera removes (two), protected
    // structures and context edges; and their buffers: three of strokes, and one of rays between those of the lattice.
    // The window may hold a few dialogs that leave it usable. Some widgets are made when they are first needed and
    // kept, such as Qt's rubber band of a dragged dock. A leak in one of a hundred events would make far more of 10
    // 000.
    constexpr int renderers = 4, imagesOfPasses = 14 + 6, buffersOfPasses = 4, dialogs = 4, madeOnce = 10;
    if (half == 1) {
      EXPECT_LE(objects.kept(), before.kept() + renderers * (imagesOfPasses + buffersOfPasses));
      std::ostringstream more;
      for (const auto& [kind, count] : kinds)
        if (count != kindsBefore[kind]) more << ' ' << kind << ' ' << kindsBefore[kind] << " to " << count;
      EXPECT_LE(widgets, widgetsBefore + madeOnce) << more.str();
      EXPECT_LE(windows, windowsBefore + dialogs);
    }
    before = objects;
    widgetsBefore = widgets;
    windowsBefore = windows;
    kindsBefore = kinds;
  }
  std::cerr << "longest event: " << longestEvent << '\n';
  // A click after it all: the cross-hair follows, unless the mouse draws a measure.
  while (window_->workspace().measuring.stop()) continue;
  const glm::dvec3 at = cursor().position();
  SliceView* axial = slice(SlicePlane::Axial);
  const QPoint beside = axial->widgetFromWorld(at).toPoint() + QPoint(20, 15);
  QTest::mouseClick(axial, Qt::LeftButton, {}, beside);
  EXPECT_NE(cursor().position(), at) << "click at " << beside.x() << ", " << beside.y() << " of " << axial->width()
                                     << "×" << axial->height() << ", visible " << axial->isVisible();
}

INSTANTIATE_TEST_SUITE_P(Seeds, Monkey, testing::Values(1u, 2u, 3u, 4u, 5u));

}  // namespace fenestra::viewer::monkeyTest
