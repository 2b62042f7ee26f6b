#include "app/cli/Commands.h"

#include <chrono>
#include <ctime>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>

#include "app/ScheduleChoice.h"
#include "app/benchmark/BenchmarkPage.h"
#include "app/cli/Report.h"
#include "io/base/AtomicFile.h"
#include "io/study/ReadStudy.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gpu/GpuScene.h"

namespace fenestra::cli {
namespace {

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::ostringstream text;
  text << std::put_time(::gmtime_r(&now, &parts), "%Y-%m-%d");
  return text.str();
}

}  // namespace

void benchmark(const BenchmarkOptions& options) {
  // Before minutes are spent.
  if (!options.output.empty() &&
      !std::filesystem::is_directory(std::filesystem::absolute(options.output).parent_path()))
    throw io::Error(options.output, "cannot be written: there is no such folder", "choose a folder that exists");
  const auto starting = std::chrono::steady_clock::now();
  const egl::EglContext context;
  const double contextTime = millisecondsSince(starting);

  io::StudyRequest phantom;
  phantom.phantom = "torso";
  const auto reading = std::chrono::steady_clock::now();
  const io::Study study = io::readStudy(phantom);
  const double readingTime = millisecondsSince(reading);

  const auto gpu = std::make_shared<GpuScene>();
  bench::BenchmarkOptions measured{.isQuick = options.isQuick};
  if (options.size) measured.size = *options.size;
  View view = *study.view;
  view.size = measured.size;
  app::chooseSchedule(options.schedule, gpu, study.drawn.scene(), view);
  const io::Progress progress = progressOnTerminal();
  bench::BenchmarkResult result =
      bench::runBenchmark(gpu, study.drawn.scene(), measured, [&](double share, std::string_view doing) {
        if (progress) progress(share, doing);
      });
  result.context = contextTime;
  result.reading = readingTime;

  const std::vector<bench::KnownMachine> machines = bench::knownMachines();
  if (options.output.extension() == ".md")
    io::writeText(options.output, bench::benchmarkPage(result, machines, FENESTRA_VERSION, today()));
  else if (!options.output.empty())
    io::writeText(options.output, bench::benchmarkJson(result, machines).dump(2) + "\n");
  else
    printJson(bench::benchmarkJson(result, machines));
}

}  // namespace fenestra::cli
