// window-bench: how the window answers. Opens a scene as `fenestra` does, drags a view in circles with a synthetic
// mouse at 60 events a second, lets go, drags the transfer function, opens the list of presets, and places the cameras.
// Writes one JSON object: new pictures a second of each view, longest gap between two, times until the pictures at
// rest, and the longest time that one event kept the window's thread busy, with what of it the thread itself worked:
// the rest it waited, for another program on a busy machine. With --grow L,P,S it clicks there, with --correct also
// outside the region that grows, and that --rounds times in the study opened anew; then it moves the region's
// tolerance and turns it, also as a label. With --scroll it turns the wheel over a slice alone, with --beside it opens
// the study twice, side by side, and tells the memory. Needs a display with OpenGL. Takes the options of a scene and
// --seconds.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <iostream>
#include <numeric>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <QApplication>
#include <QMouseEvent>
#include <QTimer>

#include "app/SceneOptions.h"
#include "app/ScheduleChoice.h"
#include "io/study/ReadStudy.h"
#include "tests/bench/BesideBench.h"
#include "tests/bench/ScrollBench.h"
#include "tests/gui/TimedApplication.h"
#include "viewer/MainWindow.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/RegionPanel.h"
#include "viewer/style/Style.h"
#include "viewer/views/ScenePreparation.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

const Clock::time_point programStart = Clock::now();
double now() { return millisecondsSince(programStart); }

/// When each new picture of each 3-D view came onto the screen.
class PictureTimes {
 public:
  explicit PictureTimes(const std::vector<VolumeView*>& views) : times_(views.size()) {
    for (VolumeView* view : views)
      QObject::connect(view, &VolumeView::drawn, &context_, [this, view](bool isNew) {
        if (isNew) times_[static_cast<std::size_t>(view->index())].push_back(now());
      });
  }
  void clear() {
    for (auto& times : times_) times.clear();
  }
  const std::vector<double>& of(std::size_t view) const { return times_[view]; }

 private:
  QObject context_;
  std::vector<std::vector<double>> times_;
};

void wait(double milliseconds) {
  QEventLoop loop;
  QTimer::singleShot(static_cast<int>(milliseconds), &loop, &QEventLoop::quit);
  loop.exec();
}

void sendMouse(QWidget* widget, QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons buttons,
               Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QMouseEvent event(type, at, widget->mapToGlobal(at), button, buttons, modifiers);
  QApplication::sendEvent(widget, &event);
}

/// Gaps between pictures from `start` on, until `end`.
Json ratesOf(const std::vector<double>& times, double start, double end) {
  std::vector<double> gaps;
  double last = start;
  for (const double time : times)
    if (time >= start && time <= end) {
      gaps.push_back(time - last);
      last = time;
    }
  const double pictures = static_cast<double>(gaps.size());
  gaps.push_back(end - last);
  std::sort(gaps.begin(), gaps.end());
  return {{"pictures_a_second", 1000.0 * pictures / (end - start)},
          {"median_gap_ms", gaps[gaps.size() / 2]},
          {"longest_gap_ms", gaps.back()}};
}

/// Median and greatest of times in ms.
Json summaryOf(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return {{"median_ms", times[times.size() / 2]}, {"longest_ms", times.back()}};
}

/// Handles events until `condition` holds, for a minute at most; `what` names it in the error.
template <class Condition>
void waitUntil(const char* what, Condition condition) {
  QTimer wakes;  // conditions change without an event, too
  wakes.start(1);
  for (const double start = now(); !condition();) {
    QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    if (now() > start + 60000.0) throw std::runtime_error(std::string("no ") + what + " within a minute");
  }
}

class Bench {
 public:
  Bench(TimedApplication& application, MainWindow& window, double seconds)
      : application_(application), window_(window), seconds_(seconds), times_(window.views().volumeViews()) {}

  Json start() { return {{"first_picture", untilDrawn()}}; }

  Json scroll() {
    return scrollRates(window_, [this] { waitUntilDrawn(); });
  }

  Json beside(const io::StudyRequest& study) {
    return besideMemory(
        window_, [study](const io::Progress& progress) { return io::readStudy(study, progress); },
        [](MainWindow& window) { untilAtRest(window); });
  }

  Json run() {
    Json result = start();
    const QSize size = window_.views().volumeViews().front()->size();
    result["view_size"] = {size.width(), size.height()};
    for (int view = 0; view < 2; ++view) result[view == 0 ? "turn_C1" : "turn_C2"] = turn(view);
    result["edit_transfer_function"] = edit();
    result["presets"] = presets();
    result["place"] = place();
    return result;
  }

  /// A region from a click at `seed`, world mm, and a correction by a click outside it, if there is one.
  Json grow(glm::dvec3 seed, std::optional<glm::dvec3> outside) {
    untilDrawn();
    Json result{{"click", click(seed, Qt::NoModifier)}};
    const Document& document = window_.workspace().document;
    result["step"] = document.regionStep();
    result["ml"] = document.growth()->curve.volume[static_cast<std::size_t>(document.regionStep())] / 1000.0;
    if (outside) result["correction"] = click(*outside, Qt::ControlModifier);
    result["turn"] = turn(0);
    return result;
  }

  /// What follows a region: its tolerance changes, and it turns, also as a label.
  Json useRegion() {
    Json result{{"tolerance", changeTolerance()}, {"drag", dragTolerance()}, {"turn_region", turn(0)}};
    // The region as a label: it has to turn as fast.
    RegionPanel* panel = window_.findChild<RegionPanel*>();
    panel->keep()->click();
    waitUntil("a label in focus",
              [&] { return std::holds_alternative<LabelFocus>(window_.workspace().document.focus()); });
    waitUntilDrawn();
    result["turn_label"] = turn(0);
    return result;
  }

 private:
  /// A click on the axial slice through a position: until the slice shows the outline of a first region, until the
  /// region is whole, until the 3-D views show it from where they go to.
  Json click(glm::dvec3 world, Qt::KeyboardModifiers modifiers) {
    Document& document = window_.workspace().document;
    window_.workspace().cursor.moveTo(world);
    waitUntilDrawn();
    takeBlocks();
    SliceView* axial = window_.views().sliceViews().front();
    const QPointF at = axial->widgetFromWorld(world);
    times_.clear();
    Json changes = Json::array();
    QObject context;
    const double clicked = now();
    QObject::connect(&document, &Document::sceneChanged, &context, [&] { changes.push_back(now() - clicked); });
    sendMouse(axial, QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton, modifiers);
    sendMouse(axial, QEvent::MouseButtonRelease, at, Qt::LeftButton, Qt::NoButton, modifiers);
    if (!document.region()) throw std::runtime_error("no region grows from the click");
    const auto isGivenUp = [&] { return !document.region(); };
    waitUntil("a first region", [&] { return document.growth() || isGivenUp(); });
    axial->repaint();
    Json result{{"first_ms", now() - clicked}};
    waitUntil("the whole region", [&] { return document.isWhole() || isGivenUp(); });
    if (isGivenUp()) throw std::runtime_error("the click shows no region");
    axial->repaint();
    result["whole_ms"] = now() - clicked;
    result["asks"] = document.asksToOpen();
    document.openToRegion();
    result["blocks_while_growing"] = takeBlocks();
    waitUntilDrawn();
    result["placed_and_at_rest_ms"] = now() - clicked;
    result["scene_changes_ms"] = changes;
    for (std::size_t view = 0; view < 2; ++view)
      for (const double time : times_.of(view))
        result["C" + std::to_string(view + 1) + "_pictures_ms"].push_back(time - clicked);
    result["blocks_while_placing"] = takeBlocks();
    return result;
  }

  QSlider* toleranceSlider() { return window_.findChild<RegionPanel*>()->slider(); }

  /// Single steps of the slider from rest: until the event is handled, until the 3-D pictures' focus is the new region,
  /// and until the first picture of it.
  Json changeTolerance() {
    QSlider* slider = toleranceSlider();
    const Document& document = window_.workspace().document;
    ScenePreparation& preparation = window_.views().volumeViews().front()->preparation();
    std::vector<double> handled, focus, picture;
    std::optional<double> made;
    QObject context;
    QObject::connect(&preparation.glContext(), &GlContext::freed, &context, [&] {
      if (!made && preparation.gpuScene()->holds(document.scene())) made = now();
    });
    const int first = slider->value();
    for (const int change : {1, 2, 1, 0, -2, 0, 8, 0, -8, 0, 16, 2, -12, 0}) {
      const int step = std::clamp(first + change, slider->minimum(), slider->maximum());
      if (step == slider->value()) continue;
      made.reset();
      times_.clear();
      const double start = now();
      slider->setValue(step);
      handled.push_back(now() - start);
      waitUntil("focus of another tolerance", [&] { return made.has_value(); });
      focus.push_back(*made - start);
      waitUntilDrawn();
      const std::vector<double>& drawn = times_.of(0);
      picture.push_back(*std::upper_bound(drawn.begin(), drawn.end(), *made) - start);
    }
    return {{"handled", summaryOf(handled)},
            {"focus", summaryOf(focus)},
            {"picture", summaryOf(picture)},
            {"blocks", takeBlocks()}};
  }

  /// The slider is drawn up and down by a step in every 16 ms.
  Json dragTolerance() {
    QSlider* slider = toleranceSlider();
    const int first = slider->value();
    times_.clear();
    const double start = now(), end = start + 1000.0 * seconds_;
    QTimer mouse;
    QEventLoop loop;
    QObject::connect(&mouse, &QTimer::timeout, [&] {
      slider->setValue(first + static_cast<int>(std::lround(10.0 * std::sin((now() - start) / 300.0))));
      if (now() > end) loop.quit();
    });
    mouse.start(16);
    loop.exec();
    mouse.stop();
    Json result{{"C1", ratesOf(times_.of(0), start, now())},
                {"C2", ratesOf(times_.of(1), start, now())},
                {"blocks", takeBlocks()}};
    waitUntilDrawn();
    return result;
  }

  void waitUntilDrawn() { untilAtRest(window_); }
  static void untilAtRest(MainWindow& window) {
    bool drawn = false;
    window.whenDrawn([&] { drawn = true; });
    waitUntil("pictures at rest", [&] { return drawn; });
  }

  /// After a change at `start`: when each view's first picture came, when all were at rest.
  Json untilDrawn() {
    const double opened = now();
    waitUntilDrawn();
    Json result{{"since_start_ms", opened}};
    for (std::size_t view = 0; view < 2; ++view)
      result["C" + std::to_string(view + 1) + "_ms"] = times_.of(view).empty() ? -1.0 : times_.of(view).front();
    result["at_rest_ms"] = now();
    result["blocks"] = takeBlocks();
    return result;
  }

  /// When a drag began and ended.
  struct Drag {
    double start, released;
  };
  /// Drags the mouse over a widget along `at`, which gives its place after so many seconds.
  Drag drag(QWidget* widget, const std::function<QPointF(double)>& at) {
    wait(500);
    takeBlocks();
    times_.clear();
    sendMouse(widget, QEvent::MouseButtonPress, at(0.0), Qt::LeftButton, Qt::LeftButton);
    const double start = now(), end = start + 1000.0 * seconds_;
    QPointF last;
    QTimer mouse;
    QEventLoop loop;
    QObject::connect(&mouse, &QTimer::timeout, [&] {
      last = at((now() - start) / 1000.0);
      sendMouse(widget, QEvent::MouseMove, last, Qt::NoButton, Qt::LeftButton);
      if (now() > end) loop.quit();
    });
    mouse.start(16);
    loop.exec();
    mouse.stop();
    sendMouse(widget, QEvent::MouseButtonRelease, last, Qt::LeftButton, Qt::NoButton);
    return {start, now()};
  }

  Json turn(int index) {
    VolumeView* view = window_.views().volumeViews()[static_cast<std::size_t>(index)];
    const QPointF middle = QRectF(view->rect()).center();
    const FramePacer& pacer = window_.views().pacer();
    std::vector<double> scales;
    const auto [start, released] = drag(view, [&](double seconds) {
      if (const auto& last = pacer.last()) scales.push_back(last->effort.scale);
      const double angle = 2.0 * seconds;
      return middle + 80.0 * QPointF(std::cos(angle) - 1.0, std::sin(angle));
    });
    Json result{{"turned", ratesOf(times_.of(static_cast<std::size_t>(index)), start, released)},
                {"linked", ratesOf(times_.of(static_cast<std::size_t>(1 - index)), start, released)},
                // The larger picture of each frame counts.
                {"mean_scale", std::accumulate(scales.begin(), scales.end(), 0.0) / static_cast<double>(scales.size())},
                {"blocks", takeBlocks()}};
    waitUntilDrawn();
    result["at_rest"] = {{"all_after_ms", now() - released}};
    for (std::size_t other = 0; other < 2; ++other) {
      Json after = Json::array();
      for (const double time : times_.of(other))
        if (time > released) after.push_back(time - released);
      result["at_rest"]["C" + std::to_string(other + 1) + "_pictures_after_ms"] = after;
    }
    result["at_rest"]["blocks"] = takeBlocks();
    return result;
  }

  /// Drags the second node of the transfer function to and fro.
  Json edit() {
    TransferFunctionPlot& plot = window_.findChild<AppearancePanel*>()->editor().plot();
    const TransferFunction function = plot.function();
    const TransferFunction::Node& node = function.nodes.at(1);
    const QPointF from = plot.place(node.value, opacityFromExtinction(node.properties.extinction));
    // Towards the plot's middle: a node that is held at the border changes nothing.
    const double inwards = from.y() < QRectF(plot.rect()).center().y() ? 1.0 : -1.0;
    const auto [start, released] = drag(
        &plot, [&](double seconds) { return from + 40.0 * QPointF(0.0, inwards * std::abs(std::sin(3.0 * seconds))); });
    Json result{{"C1", ratesOf(times_.of(0), start, released)},
                {"C2", ratesOf(times_.of(1), start, released)},
                {"blocks", takeBlocks()}};
    window_.workspace().document.undoStack().undo();
    bool drawn = false;
    window_.whenDrawn([&] { drawn = true; });
    while (!drawn) wait(2);
    return result;
  }

  /// Opens the list of presets and waits for its pictures.
  Json presets() {
    wait(500);
    application_.takeBlocks();
    PresetPicker& presets = window_.findChild<AppearancePanel*>()->presets();
    const double start = now();
    presets.box()->showPopup();
    while (!presets.hasAllPictures()) wait(2);
    Json result{{"all_pictures_ms", now() - start}, {"blocks", takeBlocks()}};
    presets.box()->hidePopup();
    return result;
  }

  Json place() {
    PlacementController& placement = window_.workspace().placement;
    if (!placement.canPlace()) return nullptr;
    wait(500);
    takeBlocks();
    const double start = now();
    placement.place();
    while (placement.isBusy()) wait(2);
    Json result{{"measured_after_ms", now() - start}, {"blocks", takeBlocks()}};
    waitUntilDrawn();
    result["at_rest_after_ms"] = now() - start;
    result["blocks_after"] = takeBlocks();
    return result;
  }

  Json takeBlocks() {
    const TimedApplication::Blocks blocks = application_.takeBlocks();
    return {{"longest_ms", blocks.longest},
            {"longest_event", blocks.event},
            {"longest_own_ms", blocks.ownTime},
            {"over_50_ms", blocks.over50},
            {"over_100_ms", blocks.over100}};
  }

  TimedApplication& application_;
  MainWindow& window_;
  const double seconds_;
  PictureTimes times_;
};

glm::dvec3 positionOf(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

int main(int argc, char** argv) {
  CLI::App program{"Measures how the window answers."};
  io::StudyRequest options;
  app::addSceneOptions(program, options);
  double seconds = 5.0;
  bool onlyStart = false;
  program.add_option("--seconds", seconds, "length of each drag");
  program.add_flag("--only-start", onlyStart, "end once the first pictures are at rest");
  bool scroll = false;
  program.add_flag("--scroll", scroll, "only scroll slices");
  bool beside = false;
  program.add_flag("--beside", beside, "only open the study twice, side by side");
  std::vector<double> seed;
  CLI::Option* grow =
      program.add_option("--grow", seed, "L,P,S in mm: only grow a region from there")->delimiter(',')->expected(3);
  std::vector<double> outside;
  program.add_option("--correct", outside, "L,P,S in mm: a correction of that region, a click outside it")
      ->delimiter(',')
      ->expected(3)
      ->needs(grow);
  int rounds = 1;
  program.add_option("--rounds", rounds, "how often the study opens and the region grows")->needs(grow);
  CLI11_PARSE(program, argc, argv);

  requestOpenGl();
  TimedApplication application(argc, argv);
  QApplication::setOrganizationName(QStringLiteral("Fenestra"));
  QApplication::setApplicationName(QStringLiteral("Fenestra"));
  applyStyle(application);
  const GlSupport gl = probeOpenGl();
  if (!gl.available) throw std::runtime_error(gl.problem.toStdString());
  const auto read = [options](const io::Progress& progress) { return io::readStudy(options, progress); };
  MainWindow window(
      {.gl = gl,
       .atRest = Effort{.quality = options.quality, .maxError = options.maxError},
       .expected = io::expectedFocus(options),
       .chooseSchedule = [software = gl.software](
                             const std::shared_ptr<GpuScene>& gpu, const Scene& scene,
                             const View& view) { app::chooseScheduleQuickly({}, software, gpu, scene, view); },
       .remember = false,
       .openFirst =
           [&](MainWindow& opening) {
             if (!beside) opening.open(read);
           }});
  const glm::ivec2 size = options.size.value_or(glm::ivec2(1600, 1000));
  window.resize(size.x, size.y);
  Bench bench(application, window, seconds);
  bool opened = false, failed = false;
  QObject::connect(&window, &MainWindow::opened, [&] { opened = true; });
  QObject::connect(&window, &MainWindow::failed, [&](const QString& message) {
    std::cerr << message.toStdString() << '\n';
    failed = true;
  });
  window.show();
  if (beside) {
    std::cout << bench.beside(options).dump(2) << '\n';
    return 0;
  }
  const auto isOpen = [&] {
    while (!opened && !failed) wait(1);
    return opened;
  };
  if (!isOpen()) return 1;
  Json result;
  for (int round = 0; round < (grow->empty() ? 1 : rounds); ++round) {
    if (round > 0) {
      opened = failed = false;
      window.open(read);
      if (!isOpen()) return 1;
    }
    if (onlyStart)
      result = bench.start();
    else if (scroll)
      result = bench.scroll();
    else if (grow->empty())
      result = bench.run();
    else
      result["rounds"].push_back(
          bench.grow(positionOf(seed), outside.empty() ? std::nullopt : std::optional(positionOf(outside))));
  }
  if (!grow->empty()) result["region"] = bench.useRegion();
  std::cout << result.dump(2) << '\n';
  return 0;
}

}  // namespace
}  // namespace fenestra::viewer

int main(int argc, char** argv) {
  try {
    return fenestra::viewer::main(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "window-bench: " << error.what() << '\n';
    return 1;
  }
}
