#include "tests/bench/ScrollBench.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include <QApplication>
#include <QEvent>
#include <QWheelEvent>

#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// Counts how often a widget is painted.
class Paints : public QObject {
 public:
  explicit Paints(QWidget& widget) { widget.installEventFilter(this); }
  int count = 0;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    count += event->type() == QEvent::Paint ? 1 : 0;
    return QObject::eventFilter(watched, event);
  }
};

Json rateOf(SliceView& view, int notches) {
  Paints paints(view);
  std::vector<double> times;
  const auto begin = Clock::now();
  auto last = begin;
  for (int notch = 0; notch < notches; ++notch) {
    const int before = paints.count;
    const QPointF at = QRectF(view.rect()).center();
    QWheelEvent wheel(at, view.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &wheel);
    while (paints.count == before) QCoreApplication::processEvents(QEventLoop::AllEvents);
    const auto now = Clock::now();
    times.push_back(std::chrono::duration<double, std::milli>(now - last).count());
    last = now;
  }
  const double all = std::chrono::duration<double>(last - begin).count();
  std::sort(times.begin(), times.end());
  return {{"slices_a_second", notches / all}, {"median_ms", times[times.size() / 2]}, {"longest_ms", times.back()}};
}

}  // namespace

Json scrollRates(MainWindow& window, const std::function<void()>& settle) {
  Workspace& workspace = window.workspace();
  SliceView& view = *window.views().sliceViews().front();
  window.views().arrange(*findArrangement("slices"));
  window.views().toggleMaximised(&view);
  settle();
  window.resize(window.size() + QSize(700, 700) - view.size());
  settle();
  Json result{{"view", {view.width(), view.height()}}};
  constexpr int notches = 100;
  workspace.cursor.moveTo(workspace.document.scene().volume->grid.centre());
  result["axial"] = rateOf(view, notches);
  const PlaneAxes own = workspace.planes.axes(SlicePlane::Axial);
  for (const auto& [name, turns] :
       {std::pair("oblique by 20°", std::pair(0.28, 0.2)), {"oblique by 55°", std::pair(0.785, 0.615)}}) {
    workspace.planes.setAxes(SlicePlane::Axial, turned(turned(own, own.right, turns.first), own.down, turns.second));
    for (const auto& [mode, word] : {std::pair(SlabMode::Maximum, "maximum"), {SlabMode::Mean, "mean"}}) {
      workspace.planes.setSlab(SlicePlane::Axial, {10.0, mode});
      workspace.cursor.moveTo(workspace.document.scene().volume->grid.centre());
      settle();
      result[std::string(name) + ", slab of 10 mm, " + word] = rateOf(view, notches);
    }
    workspace.planes.setSlab(SlicePlane::Axial, {});
    settle();
    result[name] = rateOf(view, notches);
  }
  return result;
}

}  // namespace fenestra::viewer
