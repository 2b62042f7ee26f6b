// fenestra-cli render --focus-transfer, as a script uses it.

#include "io/session/LookFile.h"
#include "io/session/SessionFile.h"
#include "tests/cli/CommandLine.h"

namespace fenestra::tests::focusTransferTest {
namespace {

class FocusTransfer : public CommandLine {
 protected:
  FocusTransfer() {
    write(at("f.json"), R"({"name": "f", "domain": "value", "nodes": [
      {"value": -50, "colour": [0.2, 0.4, 1], "opacity": 0.01}, {"value": 60, "colour": [0.9, 0.3, 0.2], "opacity": 0.1},
      {"value": 60, "colour": [0.1, 1, 0.3], "opacity": 0.2}, {"value": 200, "colour": [1, 0.9, 0.5], "opacity": 0.5}]})");
  }
  /// Draws the torso with other options after these.
  Result draw(const std::string& name, std::vector<std::string> more) const {
    std::vector<std::string> arguments{"render", "--phantom", "torso", "--phantom-voxels",
                                       "64",     "--size",    "90x80", "--max-error",
                                       "0.5",    "-o",        at(name)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  /// The percentile of the difference of two pictures over their channels, 0 to 1.
  double difference(const std::string& a, const std::string& b, const char* percentile) const {
    const Json report = run({"compare", at(a), at(b)}).json();
    return report.contains("percentiles") ? report["percentiles"][percentile].get<double>() : 2.0;
  }
};

TEST_F(FocusTransfer, Thorough_LabelsAndRangesAreShownByValueAsInTheReference) {
  const std::vector<std::vector<std::string>> kinds{{"--focus-labels", "left kidney,right kidney"},
                                                    {"--focus-range", "40:3000"}};
  for (std::vector<std::string> options : kinds) {
    ASSERT_EQ(draw("material.png", options).exitCode, 0);
    options.insert(options.end(), {"--focus-transfer", at("f.json")});
    const Result result = draw("value.png", options);
    ASSERT_EQ(result.exitCode, 0) << result.error;
    options.push_back("--reference");
    ASSERT_EQ(draw("truth.png", options).exitCode, 0);
    EXPECT_GT(difference("value.png", "material.png", "99"), 0.1);
    // The bound, and rounding of two pictures to 8 bits; rays that graze a surface start elsewhere.
    EXPECT_LE(255.0 * difference("value.png", "truth.png", "99"), 1.5) << options[0];
  }
}

TEST_F(FocusTransfer, SingleLabelsHaveFunctionsOfTheirOwnInSessionsToo) {
  const std::vector<std::string> focus{"--focus-labels", "left kidney,right kidney"};
  std::vector<std::string> options = focus;
  options.insert(options.end(),
                 {"--focus-transfer", "left kidney=" + at("f.json"), "--save-session", at("s.fenestra")});
  ASSERT_EQ(draw("one.png", options).exitCode, 0);
  const io::Session session = io::readSession(at("s.fenestra"));
  ASSERT_EQ(session.look.labels.size(), 1u);
  ASSERT_TRUE(session.look.labels[0].function);
  EXPECT_EQ(session.look.labels[0].function->nodes.size(), 4u);
  ASSERT_EQ(run({"render", at("s.fenestra"), "-o", at("again.png")}).exitCode, 0);
  EXPECT_EQ(contents(at("again.png")), contents(at("one.png")));
  ASSERT_EQ(run({"render", at("s.fenestra"), "--focus-transfer", "none", "-o", at("none.png")}).exitCode, 0);
  ASSERT_EQ(draw("material.png", focus).exitCode, 0);
  EXPECT_EQ(contents(at("none.png")), contents(at("material.png")));
}

TEST_F(FocusTransfer, PresetsOfALookCarryTheFunctionOfARange) {
  const std::vector<std::string> focus{"--focus-range", "40:3000"};
  std::vector<std::string> saved = focus, read = focus;
  saved.insert(saved.end(), {"--focus-transfer", at("f.json"), "--save-look", at("l.json")});
  read.insert(read.end(), {"--look", at("l.json")});
  ASSERT_EQ(draw("saved.png", saved).exitCode, 0);
  ASSERT_TRUE(io::readLook(at("l.json")).look.focusAppearance.function);
  ASSERT_EQ(draw("read.png", read).exitCode, 0);
  EXPECT_EQ(contents(at("read.png")), contents(at("saved.png")));
}

TEST_F(FocusTransfer, PresetsOfALookCarryTheFunctionsOfLabels) {
  const std::vector<std::string> focus{"--focus-labels", "left kidney,right kidney"};
  std::vector<std::string> saved = focus, read = focus, overridden = focus;
  saved.insert(saved.end(), {"--focus-transfer", "left kidney=" + at("f.json"), "--save-look", at("l.json")});
  read.insert(read.end(), {"--look", at("l.json")});
  overridden.insert(overridden.end(), {"--look", at("l.json"), "--focus-transfer", "left kidney=none"});
  ASSERT_EQ(draw("material.png", focus).exitCode, 0);
  ASSERT_EQ(draw("saved.png", saved).exitCode, 0);
  const io::LookPreset preset = io::readLook(at("l.json"));
  ASSERT_EQ(preset.labels.size(), 1u);
  EXPECT_EQ(preset.labels[0].label, "left kidney");
  ASSERT_EQ(draw("read.png", read).exitCode, 0);
  EXPECT_EQ(contents(at("read.png")), contents(at("saved.png")));
  ASSERT_EQ(draw("overridden.png", overridden).exitCode, 0);
  EXPECT_EQ(contents(at("overridden.png")), contents(at("material.png"))) << "the option counts more";
}

TEST_F(FocusTransfer, MistakesAreNamed) {
  expectFailure(draw("x.png", {"--focus-transfer", at("absent.json")}), at("absent.json"));
  expectFailure(draw("x.png", {"--focus-transfer", "kidnee=ct-bone"}), "phantom torso");
  write(at("bad.json"), R"({"domain": "value", "nodes": [{"value": 1}]})");
  expectFailure(draw("x.png", {"--focus-transfer", "left kidney=" + at("bad.json")}), at("bad.json"));
  EXPECT_EQ(draw("x.png", {"--focus-transfer", "=ct-bone"}).exitCode, 2);
  EXPECT_FALSE(fs::exists(at("x.png")));
}

}  // namespace
}  // namespace fenestra::tests::focusTransferTest
