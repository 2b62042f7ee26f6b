// fenestra-cli render --strokes and --look, as a script uses them.

#include <sys/wait.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/ImageWriter.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::strokesTest {
namespace {

namespace fs = std::filesystem;

class Strokes : public ::testing::Test {
 protected:
  /// A small phantom, with `options` in the shell's own syntax. The exit code; -1 when ended by a signal.
  int render(const std::string& options) const {
    const std::string command = std::string(FENESTRA_CLI)
                                    .append(" render --phantom torso --phantom-voxels 64 --size 90x80 ")
                                    .append(options)
                                    .append(" 2>'")
                                    .append(at("error"))
                                    .append("'");
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::string error() const {
    std::ifstream file(at("error"));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// Writes strokes.json with one stroke's members.
  void write(const std::string& members) const {
    std::ofstream(at("strokes.json")) << R"({"format": "fenestra-strokes", "version": 1, "strokes": [{)" << members
                                      << "}]}";
  }
  std::vector<float> layer(const std::string& run, const std::string& name) const {
    return io::readPicture(folder_ / run / (name + ".mha")).values;
  }

 private:
  const fs::path folder_ = scratchFolder();
};

TEST_F(Strokes, MoveTheRayStart) {
  // Over the whole front of the body.
  write(
      R"("mode": "restore", "anchors": [[0, -110, 300], [0, -110, -300]], "radius": 250, "softness": 0, "depth": 1000)");
  ASSERT_EQ(render("-o '" + at("a.png") + "' --layers '" + at("plain") + "'"), 0) << error();
  ASSERT_EQ(render("-o '" + at("b.png") + "' --layers '" + at("edited") + "' --strokes '" + at("strokes.json") + "'"),
            0)
      << error();
  EXPECT_FALSE(fs::exists(at("plain") + "/edit_map.mha"));
  const std::vector<float> before = layer("plain", "t_start"), after = layer("edited", "t_start"),
                           context = layer("edited", "t_context"), focus = layer("edited", "t_focus"),
                           edits = layer("edited", "edit_map");
  ASSERT_EQ(edits.size(), 2 * after.size());
  std::size_t moved = 0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (std::isnan(after[i])) continue;
    // Positions are some 1000 mm from the eye: float32 holds them to 1e-4 mm.
    EXPECT_NEAR(after[i], before[i] + edits[2 * i], 1e-3);
    if (!std::isnan(focus[i])) {
      EXPECT_EQ(after[i], focus[i]);
    } else if (before[i] > context[i] + 1.0f) {
      EXPECT_NEAR(after[i], context[i], 1e-3);
      ++moved;
    }
  }
  EXPECT_GT(moved, 100u);
}

TEST_F(Strokes, OfTheOtherViewAreLeftOut) {
  const std::string members =
      R"("mode": "restore", "anchors": [[0, -110, 0]], "radius": 250, "depth": 1000, "covers_focus": true, "view": )";
  ASSERT_EQ(render("-o '" + at("plain.png") + "'"), 0) << error();
  const auto picture = [&](int view) {
    write(members + std::to_string(view));
    EXPECT_EQ(render("-o '" + at("x.png") + "' --strokes '" + at("strokes.json") + "'"), 0) << error();
    return io::readPicture(at("x.png")).values;
  };
  const std::vector<float> plain = io::readPicture(at("plain.png")).values, all = picture(-1);
  EXPECT_NE(all, plain);
  EXPECT_EQ(picture(0), all);
  EXPECT_EQ(picture(1), plain);
}

TEST_F(Strokes, BadFilesAreErrors) {
  write(R"("mode": "restore", "anchors": [[0, 0]])");
  EXPECT_EQ(render("-o '" + at("x.png") + "' --strokes '" + at("strokes.json") + "'"), 1);
  EXPECT_TRUE(error().starts_with("fenestra-cli: " + at("strokes.json") + ": ")) << error();
  EXPECT_EQ(render("-o '" + at("x.png") + "' --strokes '" + at("none.json") + "'"), 1);
  EXPECT_FALSE(fs::exists(at("x.png")));
}

TEST_F(Strokes, Thorough_LooksAreWhatTheirOptionsSay) {
  const auto picture = [&](const std::string& options) {
    EXPECT_EQ(render("-o '" + at("x.png") + "' " + options), 0) << error();
    return io::readPicture(at("x.png")).values;
  };
  const std::vector<float> plain = picture("");
  EXPECT_EQ(picture("--look plain"), plain);
  const std::string lines = "--context-layer 0.8 --context-value 1 --context-saturation 0.5 --context-share 0.1";
  EXPECT_EQ(picture("--look full"), picture(lines));
  EXPECT_NE(picture("--look full"), plain);
  EXPECT_EQ(picture("--look bare"), picture("--context-layer 0 --w-border 0"));
  EXPECT_EQ(picture("--w-border 2 --context-layer 0.7 --look bare"), plain) << "what is said by itself counts";
  EXPECT_NE(picture("--w-open 4 --look border"), picture("--w-open 4 --look bare"));
  EXPECT_EQ(render("-o '" + at("x.png") + "' --look nice"), 2);
}

}  // namespace
}  // namespace fenestra::tests::strokesTest
