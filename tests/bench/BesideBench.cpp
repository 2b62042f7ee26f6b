#include "tests/bench/BesideBench.h"

#include <malloc.h>
#include <fstream>
#include <stdexcept>
#include <string>

#include <QEventLoop>
#include <QTimer>

namespace fenestra::viewer {
namespace {

using Json = nlohmann::ordered_json;

/// MB of a line of /proc/self/status, after what the allocator holds in reserve is given back.
double megabytes(const std::string& name) {
  ::malloc_trim(0);
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(name + ":")) return std::stod(line.substr(name.size() + 1)) * 1024.0 / 1e6;
  throw std::runtime_error("no " + name + " in /proc/self/status");
}

void passTime(int milliseconds) {
  QEventLoop loop;
  QTimer::singleShot(milliseconds, &loop, &QEventLoop::quit);
  loop.exec();
}

}  // namespace

Json besideMemory(MainWindow& window, const std::function<io::Study(const io::Progress&)>& read,
                  const std::function<void(MainWindow&)>& settle) {
  MainWindow& beside = window.showBeside();
  const auto open = [&](MainWindow& into) {
    bool opened = false, failed = false;
    QObject context;
    QObject::connect(&into, &MainWindow::opened, &context, [&] { opened = true; });
    QObject::connect(&into, &MainWindow::failed, &context, [&] { failed = true; });
    into.open(read);
    while (!opened && !failed) passTime(1);
    if (failed) throw std::runtime_error("the study does not open");
    settle(into);
    passTime(3000);  // previews and pictures of panels are made after the views are at rest
    settle(into);
  };
  passTime(1000);
  const double none = megabytes("VmRSS");
  open(window);
  const double one = megabytes("VmRSS");
  open(beside);
  settle(window);
  const double both = megabytes("VmRSS");
  return {{"size", {window.width(), window.height(), beside.width(), beside.height()}},
          {"none_mb", none},
          {"one_mb", one},
          {"both_mb", both},
          {"peak_mb", megabytes("VmHWM")},
          {"share", (both - none) / (2.0 * (one - none))}};
}

}  // namespace fenestra::viewer
