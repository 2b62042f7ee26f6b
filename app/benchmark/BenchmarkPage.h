#pragma once
// A benchmark as one page, and how a machine compares with those that the project's report measured
// (resources/benchmark/machines.json).

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/benchmark/Benchmark.h"

namespace fenestra::bench {

/// Figures of another machine.
struct KnownMachine {
  std::string name, source, date;
  /// Median ms of a picture, by scene and setting.
  std::map<std::string, std::map<std::string, double>> milliseconds;
};
/// Throws std::runtime_error for a text that is no such file.
std::vector<KnownMachine> parseMachines(std::string_view json);
/// Those of the report.
std::vector<KnownMachine> knownMachines();

/// How many times as fast a result is, as the geometric mean over the settings that both have; empty where there is
/// none, or where its pictures have another size.
struct Comparison {
  double timesAsFast = 1.0;
  int settings = 0;
};
std::optional<Comparison> compare(const BenchmarkResult& here, const KnownMachine& there);

nlohmann::ordered_json benchmarkJson(const BenchmarkResult& result, const std::vector<KnownMachine>& machines);
/// Markdown, in English. `version` is the program's, `date` as 2026-01-31.
std::string benchmarkPage(const BenchmarkResult& result, const std::vector<KnownMachine>& machines,
                          const std::string& version, const std::string& date);

}  // namespace fenestra::bench
