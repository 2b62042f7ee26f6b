// fenestra-bench FOLDER: measures the renderer's speed and error and writes a report to FOLDER: fenestra.md,
// fenestra.html, and CSV and SVG files. Needs no display; reference pictures are kept in FOLDER/truth.

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>

#include "app/benchmark/Machine.h"
#include "tests/bench/Sections.h"

namespace fenestra::bench {
namespace {

struct Arguments {
  std::filesystem::path folder;
  std::vector<std::string> sections;
  Options options;
};

struct NamedSection {
  const char* name;
  std::function<Section(const Options&, const TruthStore&)> make;
};

const std::vector<NamedSection>& allSections() {
  static const std::vector<NamedSection> all{
      {"sweep", sweepSection},   {"bounds", boundsSection},  {"looks", looksSection},
      {"random", randomSection}, {"steep", steepSection},    {"stages", stageSection},
      {"passes", passSection},   {"updates", updateSection}, {"memory", memorySection}};
  return all;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::ostringstream text;
  text << std::put_time(std::gmtime(&now), "%Y-%m-%d");
  return text.str();
}

void run(const Arguments& arguments) {
  const egl::EglContext context;
  const TruthStore truths(arguments.folder / "truth");
  Options options = arguments.options;
  options.peers = arguments.folder / "peers";
  Report report;
  report.title = "Speed against error";
  const Views& views = options.views;
  std::ostringstream text;
  text << "Written on " << today() << " by `tests/bench/report`, on " << processors() << ", OpenGL by "
       << context.description() << ". Pictures of " << views.size.x << "×" << views.size.y << " pixels; "
       << views.cameras << " views on a path around each subject, " << std::min(views.compared, views.cameras)
       << " of them compared with the reference, one pixel of every " << views.pixelBlock << "×" << views.pixelBlock
       << "; phantoms of " << views.phantomVoxels << " voxels along their longest side.";
  report.text = text.str();
  for (const NamedSection& section : allSections()) {
    const auto& wanted = arguments.sections;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), section.name) == wanted.end()) continue;
    const auto start = std::chrono::steady_clock::now();
    report.sections.push_back(section.make(options, truths));
    std::cerr << section.name << ": "
              << std::chrono::round<std::chrono::seconds>(std::chrono::steady_clock::now() - start).count() << " s\n";
    // Written after each, so that a run that is cut short leaves its results so far.
    write(report, arguments.folder, "fenestra");
  }
}

}  // namespace
}  // namespace fenestra::bench

int main(int argc, char** argv) {
  using namespace fenestra::bench;
  Arguments arguments;
  Options& options = arguments.options;
  CLI::App program{"Measures the renderer's speed and error and writes a report."};
  program.add_option("FOLDER", arguments.folder, "where the report goes, and the reference pictures are kept")
      ->required();
  std::vector<std::string> names;
  for (const NamedSection& section : allSections()) names.emplace_back(section.name);
  program.add_option("--sections", arguments.sections, "these alone")->delimiter(',')->check(CLI::IsMember(names));
  addViewOptions(program, options.views);
  CLI11_PARSE(program, argc, argv);
  try {
    run(arguments);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "fenestra-bench: " << error.what() << '\n';
    return 1;
  }
}
