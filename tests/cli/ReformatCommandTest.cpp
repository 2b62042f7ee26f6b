// fenestra-cli reformat: along a path of a file, and along the centre line of a structure.

#include <cmath>
#include <numbers>

#include "io/ImageWriter.h"
#include "tests/cli/CommandLine.h"

namespace fenestra::tests::reformatCommandTest {
namespace {

using ReformatCommand = CommandLine;

TEST_F(ReformatCommand, FollowsAPathFromAFile) {
  // A quarter circle of 40 mm in the middle of the phantom.
  Json points = Json::array();
  for (int i = 0; i <= 9; ++i) {
    const double angle = std::numbers::pi / 18 * i;
    points.push_back({40 * std::cos(angle) - 20, 40 * std::sin(angle) - 20, 0.0});
  }
  write(at("path.json"), Json{{"points", points}}.dump());
  const std::vector<std::string> reformat{"reformat",      "--phantom", "head", "--phantom-voxels", "64", "--path",
                                          at("path.json"), "--spacing", "0.5",  "--width",          "20"};
  std::vector<std::string> straight = reformat;
  straight.insert(straight.end(), {"-o", at("straight.png")});
  const Result result = run(straight);
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Json json = result.json();
  const double length = 20 * std::numbers::pi;
  EXPECT_NEAR(json["length"], length, 0.005 * length);
  EXPECT_EQ(json["size"], (Json{41, static_cast<int>(json["length"].get<double>() / 0.5) + 1}));
  EXPECT_EQ(json["places"].size(), 64u);
  EXPECT_NEAR(json["places"].back()["point"][0], -20.0, 1e-6);
  EXPECT_TRUE(json["places"][0].contains("area")) << "of the phantom's own focus, or null where the path leaves it";
  EXPECT_EQ(io::readPicture(at("straight.png")).size, glm::ivec2(41, json["size"][1]));

  std::vector<std::string> across = reformat;
  across.insert(across.end(), {"--section", "30", "-o", at("section.png")});
  const Result section = run(across);
  ASSERT_EQ(section.exitCode, 0) << section.error;
  EXPECT_EQ(section.json()["size"], (Json{41, 41}));
  EXPECT_EQ(section.json()["section"], 30.0);
}

TEST_F(ReformatCommand, MistakesNameTheFileAndTheWayOut) {
  const auto refused = [&](const std::string& text, const std::string& says) {
    write(at("path.json"), text);
    const Result result =
        run({"reformat", "--phantom", "head", "--phantom-voxels", "16", "--path", at("path.json"), "-o", at("x.png")});
    expectFailure(result, at("path.json"));
    EXPECT_NE(result.error.find(says), std::string::npos) << result.error;
    EXPECT_FALSE(fs::exists(at("x.png")));
  };
  refused("{", "JSON");
  refused("[]", "\"points\": [[l, p, s], ...]");
  refused("{\"points\": 3}", "no list");
  refused("{\"points\": []}", "two points");
  refused("{\"points\": [[1, 2, 3]]}", "two points");
  refused("{\"points\": [[1, 2, 3], [1, 2, 3]]}", "two points that differ");
  refused("{\"points\": [[1, 2, 3], [1, 2]]}", "point 2");
  refused("{\"points\": [[1, 2, 3], [1, 2, \"x\"]]}", "point 2");
  refused("{\"points\": [[1, 2, 3], [1, 2, 1e300]]}", "point 2");
  const auto fails = [&](std::vector<std::string> more, const std::string& says, int code) {
    more.insert(more.begin(), {"reformat", "--phantom", "head", "--phantom-voxels", "16", "-o", at("x.png")});
    const Result result = run(more);
    EXPECT_EQ(result.exitCode, code) << result.error;
    EXPECT_NE(result.error.find(says), std::string::npos) << result.error;
  };
  fails({"--path", at("none.json")}, "none.json", 1);
  write(at("path.json"), "{\"points\": [[-20, 0, 0], [20, 0, 0]]}");
  fails({"--path", at("path.json"), "--section", "41"}, "its length is 40", 1);
  fails({"--path", at("path.json"), "--spacing", "0.0001"}, "--spacing", 1);
  fails({"--path", at("path.json"), "--width", "-3"}, "--width", 2);
}

TEST_F(ReformatCommand, FollowsTheAorta) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "labelled/totalsegmentator-torso");
  const Result result =
      run({"reformat", folder / "example_ct.nii.gz", "--labels", folder / "example_seg_fast_force_split.nii.gz",
           "--focus-labels", "52", "--spacing", "1", "--width", "60", "-o", at("aorta.mha")});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Json json = result.json();
  EXPECT_EQ(json["path"], "centre line");
  // 51 slices of 3 mm, nearly straight down.
  EXPECT_GT(json["length"], 153.0);
  EXPECT_LT(json["length"], 165.0);
  EXPECT_EQ(json["size"], (Json{61, static_cast<int>(json["length"].get<double>()) + 1}));
  for (const Json& place : json["places"]) {
    // Its slices have 28 to 62 voxels of 9 mm², radii of 9 to 13 mm; its ends are round.
    if (place["at"] < 10.0 || place["at"] > json["length"].get<double>() - 10.0) continue;
    EXPECT_GT(place["radius"], 7.5) << place;
    EXPECT_LT(place["radius"], 14.5) << place;
  }
  EXPECT_TRUE(fs::exists(at("aorta.mha")));
}

}  // namespace
}  // namespace fenestra::tests::reformatCommandTest
