// The benchmark's page: the figures of other machines, and the sentences that compare with them.

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/benchmark/BenchmarkPage.h"

namespace fenestra::bench {
namespace {

BenchmarkResult madeUp() {
  BenchmarkResult result;
  result.machine = {"4 × Made Up", 7.5, "Renderer, Driver 1.2", true, 0.1};
  result.schedule = "plain";
  result.size = {700, 650};
  result.first = 120.0;
  result.scenes = {
      {"plain", "plain volume rendering, unlit", {{"normal", {}, 9.0, 10.0, 12.0, 1.5, 0.3}}},
      {"opened", "opened", {{"0.5", 0.5, 70.0, 80.0, 90.0, 0.4, 0.03}, {"4", 4.0, 1.0, 1.0, 1.0, {}, {}}}}};
  return result;
}

const KnownMachine other{"Other", "a.md", "2026-01-31", {{"plain", {{"normal", 20.0}}}, {"opened", {{"0.5", 40.0}}}}};

TEST(Benchmark, ComparesByTheGeometricMeanOfWhatBothMeasured) {
  // Twice as fast in one setting and half as fast in another.
  const std::optional<Comparison> found = compare(madeUp(), other);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->settings, 2);
  EXPECT_DOUBLE_EQ(found->timesAsFast, 1.0);
  KnownMachine slower = other;
  slower.milliseconds["plain"]["normal"] = 80.0;
  EXPECT_DOUBLE_EQ(compare(madeUp(), slower)->timesAsFast, 2.0);
}

TEST(Benchmark, ComparesNothingThatIsNotAlike) {
  EXPECT_FALSE(compare(madeUp(), {"Other", "", "", {{"lit", {{"normal", 1.0}}}}}));
  BenchmarkResult smaller = madeUp();
  smaller.size = {350, 325};
  EXPECT_FALSE(compare(smaller, other));
  EXPECT_NE(benchmarkPage(smaller, {other}, "1.0.0", "2026-01-31").find("leave out `--size`"), std::string::npos);
}

TEST(Benchmark, ThePageNamesMachineTimesErrorsAndComparison) {
  const std::string page = benchmarkPage(madeUp(), {other}, "1.0.0", "2026-01-31");
  for (const char* expected :
       {"Fenestra 1.0.0, 2026-01-31", "4 × Made Up", "7.5 GiB", "Renderer, Driver 1.2: the processors draw",
        "| normal | 10 | 9.0 to 12 | 100 | 1.5 | 0.3 | 20 |",
        "| error ≤ 0.5/255 | 80 | 70 to 90 | 12.5 | 0.4 | 0.03 | 40 |",
        "1. Other, measured on 2026-01-31 (a.md): this machine takes 1 times as long, in the geometric mean of 2 "
        "settings"})
    EXPECT_NE(page.find(expected), std::string::npos) << expected << "\n" << page;
}

TEST(Benchmark, AQuickPageHasNoErrors) {
  BenchmarkResult quick = madeUp();
  quick.isQuick = true;
  const std::string page = benchmarkPage(quick, {other}, "1.0.0", "2026-01-31");
  EXPECT_NE(page.find("| normal | 10 | 9.0 to 12 | 100 | 20 |"), std::string::npos) << page;
  EXPECT_EQ(page.find("RMS"), std::string::npos);
}

TEST(Benchmark, ThePageSaysWhenTheMachineWasBusy) {
  BenchmarkResult result = madeUp();
  EXPECT_EQ(benchmarkPage(result, {}, "", "").find("Other programs"), std::string::npos);
  result.machine.load = 1.5;
  EXPECT_NE(benchmarkPage(result, {}, "", "").find("Other programs kept 1.5 processors busy"), std::string::npos);
}

TEST(Benchmark, TheJsonHoldsWhatThePageSays) {
  const nlohmann::ordered_json json = benchmarkJson(madeUp(), {other});
  EXPECT_EQ(json.at("processors"), "4 × Made Up");
  EXPECT_EQ(json.at("scenes").at(1).at("settings").at(0).at("max_error"), 0.5);
  EXPECT_EQ(json.at("compared").at(0).at("settings"), 2);
}

TEST(Benchmark, TheFiguresOfOtherMachinesHaveTheirSourceAndFitTheScenes) {
  const std::vector<KnownMachine> machines = knownMachines();
  EXPECT_GE(machines.size(), 2u);
  for (const KnownMachine& each : machines) {
    EXPECT_FALSE(each.name.empty());
    EXPECT_TRUE(each.source.starts_with("tests/bench/results/")) << each.source;
    int figures = 0;
    for (const auto& [scene, times] : each.milliseconds) {
      EXPECT_TRUE(scene == "plain" || scene == "lit" || scene == "opened") << scene;
      for (const auto& [setting, milliseconds] : times) {
        EXPECT_GT(milliseconds, 0.0) << scene << " " << setting;
        ++figures;
      }
    }
    EXPECT_GT(figures, 0);
  }
  EXPECT_THROW(parseMachines("{}"), std::runtime_error);
  EXPECT_THROW(parseMachines("no JSON"), std::runtime_error);
}

}  // namespace
}  // namespace fenestra::bench
