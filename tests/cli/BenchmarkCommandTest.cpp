// fenestra-cli benchmark, on pictures that are too small to say anything about the machine.

#include "tests/cli/CommandLine.h"

namespace fenestra::tests::benchmarkCommandTest {
namespace {

/// Expects `settings` settings for each scene, with their times in order.
void expectTimes(const Json& json, std::size_t settings) {
  EXPECT_EQ(json.at("size"), Json({64, 60}));
  ASSERT_EQ(json.at("scenes").size(), 3u);
  for (const Json& scene : json.at("scenes")) {
    EXPECT_EQ(scene.at("settings").size(), settings) << scene;
    for (const Json& setting : scene.at("settings")) {
      EXPECT_GT(setting.at("min_ms"), 0.0);
      EXPECT_GE(setting.at("median_ms"), setting.at("min_ms"));
      EXPECT_GE(setting.at("max_ms"), setting.at("median_ms"));
    }
  }
  for (const char* time : {"context_ms", "phantom_ms", "first_picture_ms", "placing_ms", "both_cameras_ms"})
    EXPECT_GT(json.at(time), 0.0) << time;
  for (const Json& machine : json.at("compared"))
    EXPECT_TRUE(machine.at("times_as_fast").is_null()) << "pictures of another size are not compared";
}

TEST_F(CommandLine, Exhaustive_BenchmarkMeasuresTimesAndErrorsOfEveryScene) {
  const Result result = run({"benchmark", "--size", "64x60"});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Json json = result.json();
  expectTimes(json, 7);
  for (const Json& scene : json.at("scenes"))
    for (const Json& setting : scene.at("settings")) {
      EXPECT_GT(setting.at("rms"), 0.0) << "compared with nothing";
      if (setting.contains("max_error")) {
        EXPECT_LE(setting.at("error_99_99"), setting.at("max_error")) << setting;
      }
    }
}

TEST_F(CommandLine, Exhaustive_AQuickBenchmarkMeasuresTimesAlone) {
  const Result result = run({"benchmark", "--quick", "--size", "64x60"});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  expectTimes(result.json(), 3);
  EXPECT_EQ(result.out.find("rms"), std::string::npos);
}

TEST_F(CommandLine, BenchmarkRefusesWhatItCannotWrite) {
  EXPECT_EQ(run({"benchmark", "--quick", "-o", at("machine.txt")}).exitCode, 2);
  EXPECT_EQ(run({"benchmark", "--size", "0x10"}).exitCode, 2);
  const std::string nowhere = at("no/folder/machine.md");
  expectFailure(run({"benchmark", "-o", nowhere}), nowhere);  // at once, not after minutes
  EXPECT_TRUE(nothingLeftBehind());
}

}  // namespace
}  // namespace fenestra::tests::benchmarkCommandTest
