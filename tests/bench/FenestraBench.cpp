// fenestra-bench FOLDER: measures the renderer's speed and error and writes a report to FOLDER: fenestra.md,
// fenestra.html, and CSV and SVG files. Needs no display; reference pictures are kept in FOLDER/truth.

#include <algorithm>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>

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
  static const std::vector<NamedSection> all{{"sweep", sweepSection},    {"bounds", boundsSection},
                                             {"stages", stageSection},   {"passes", passSection},
                                             {"updates", updateSection}, {"memory", memorySection}};
  return all;
}

void run(const Arguments& arguments) {
  const egl::EglContext context;
  const TruthStore truths(arguments.folder / "truth");
  Options options = arguments.options;
  options.peers = arguments.folder / "peers";
  Report report;
  report.title = "Speed against error";
  report.text = "Written by `fenestra-bench` on " + context.description() + ".";
  for (const NamedSection& section : allSections()) {
    const auto& wanted = arguments.sections;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), section.name) == wanted.end()) continue;
    report.sections.push_back(section.make(options, truths));
    // After each, so that a run cut short leaves what it has.
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
