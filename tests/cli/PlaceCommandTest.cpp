// fenestra-cli place.

#include <cmath>

#include "io/ImageWriter.h"
#include "tests/cli/CommandLine.h"

namespace fenestra::tests {
namespace {

using PlaceCommand = CommandLine;

TEST_F(PlaceCommand, PlaceNamesTheNearestNumbersOfSamples) {
  const Result result = run({"place", "--phantom", "head", "--samples", "184"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_NE(result.error.find("108 and 192"), std::string::npos) << result.error;
}

TEST_F(PlaceCommand, PlaceReportsBothCamerasAndDrawsTheMap) {
  const std::vector<std::string> scene{"place", "--phantom", "torso", "--phantom-voxels", "64", "--samples", "48"};
  const auto placed = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = scene;
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Result result = run(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return result.json();
  };
  const auto cosine = [](const Json& placement) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += placement["c1"]["direction"][i].get<double>() * placement["c2"]["direction"][i].get<double>();
    return sum;
  };
  const Json usual = placed({"--sequential", "--map", at("map.png"), "--json", "all"});
  EXPECT_FALSE(usual["joint"]);
  EXPECT_EQ(usual["candidates"], 48);
  EXPECT_EQ(usual["all"].size(), 48u + 6u);  // and the standard views
  for (std::size_t i = 0; i < 48; ++i)
    EXPECT_LE(usual["all"][i]["quality"].get<double>(), usual["c1"]["quality"].get<double>());
  EXPECT_LE(std::abs(cosine(usual)), 0.5 + 1e-9);
  for (const char* camera : {"c1", "c2"})
    for (const char* key : {"eye", "target", "up"}) EXPECT_EQ(usual[camera]["camera"][key].size(), 3u);
  const io::Picture map = io::readPicture(at("map.png"));
  EXPECT_EQ(map.size.x, 2 * map.size.y);

  EXPECT_LE(std::abs(cosine(placed({"--region", "stream", "--delta", "10"}))),
            std::sin(10.0 * 3.14159265 / 180.0) + 1e-6);
  const Json joint = placed({"--share-weight", "1"});
  EXPECT_TRUE(joint["joint"]);
  EXPECT_EQ(placed({"--joint"})["c1"], placed({})["c1"]);
  EXPECT_LE(std::abs(cosine(joint)), 0.5 + 1e-9);
  EXPECT_GE(joint["share"].get<double>(), usual["share"].get<double>());
  EXPECT_GE(joint["share"].get<double>(), joint["standard_pair_share"].get<double>());
  EXPECT_GE(placed({"--sequential", "--refine"})["c1"]["quality"].get<double>(),
            0.99 * usual["c1"]["quality"].get<double>());
  EXPECT_NE(placed({"--sequential", "--weights", "1,0,0"})["c1"]["index"], usual["c1"]["index"]);
  // The organs end at the top of the phantom's volume: looking down on them is worth what the weight says.
  const auto endFaces = [](const Json& placement) {
    return std::max(placement["c1"]["descriptors"]["end_face"].get<double>(),
                    placement["c2"]["descriptors"]["end_face"].get<double>());
  };
  EXPECT_GE(endFaces(placed({"--sequential", "--end-face", "5"})), endFaces(usual));
  EXPECT_EQ(placed({"--sequential", "--end-face", "0"})["c1"]["descriptors"]["end_face"], 0.0);
  EXPECT_EQ(run({"place", "--phantom", "head", "--joint", "--sequential"}).exitCode, 2);
}

TEST_F(PlaceCommand, PlaceWithoutAFocusFails) {
  const std::string empty = at("head.mha");
  ASSERT_EQ(run({"convert", "--phantom", "head", "--phantom-voxels", "24", "-o", empty}).exitCode, 0);
  expectFailure(run({"place", empty, "--map", at("map.png")}), empty);
  expectFailure(run({"place", empty, "--focus-range", "9000:9001"}), empty);
  expectFailure(run({"render", empty, "--camera", "best", "-o", at("x.png")}), empty);
  EXPECT_FALSE(fs::exists(at("map.png")) || fs::exists(at("x.png")));
}

}  // namespace
}  // namespace fenestra::tests
