// fenestra-cli place.

#include <cmath>

#include "io/ImageWriter.h"
#include "tests/cli/CommandLine.h"

namespace fenestra::tests::placeCommandTest {
namespace {

using PlaceCommand = CommandLine;

TEST_F(PlaceCommand, PlaceNamesTheNearestNumbersOfSamples) {
  const Result result = run({"place", "--phantom", "head", "--samples", "184"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_NE(result.error.find("108 and 192"), std::string::npos) << result.error;
}

TEST_F(PlaceCommand, Thorough_PlaceReportsBothCamerasAndDrawsTheMap) {
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
    if (usual["all"][i]["awkward"]["through_cut_end"].get<double>() <= 0.5) {
      EXPECT_LE(usual["all"][i]["worth"].get<double>(), usual["c1"]["worth"].get<double>());
    }
  // The paper's placement is by the quality alone.
  const Json pure = placed({"--sequential", "--json", "all", "--avoid-cut-ends", "off", "--upright-first", "off",
                            "--flat-from-front", "off", "--near-side-first", "off"});
  for (std::size_t i = 0; i < 48; ++i) {
    EXPECT_LE(pure["all"][i]["quality"].get<double>(), pure["c1"]["quality"].get<double>());
    EXPECT_EQ(pure["all"][i]["quality"], pure["all"][i]["worth"]);
    EXPECT_EQ(pure["all"][i]["quality"], usual["all"][i]["quality"]);
  }
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
  // The organs end at the top of the phantom's volume: a view down on them is worth as much as the weight says.
  const auto endFaces = [](const Json& placement) {
    return std::max(placement["c1"]["descriptors"]["end_face"].get<double>(),
                    placement["c2"]["descriptors"]["end_face"].get<double>());
  };
  EXPECT_GE(endFaces(placed({"--sequential", "--end-face", "5"})), endFaces(usual));
  EXPECT_EQ(placed({"--sequential", "--end-face", "0"})["c1"]["descriptors"]["end_face"], 0.0);
  EXPECT_EQ(run({"place", "--phantom", "head", "--joint", "--sequential"}).exitCode, 2);
}

const std::vector<std::string> allDescriptors{
    "entropy",           "structure-entropy",    "mutual-information", "i2", "stability", "depth-distribution",
    "silhouette-length", "silhouette-curvature", "curvature-entropy"};
const std::vector<std::string> smallTorso{"place", "--phantom", "torso", "--phantom-voxels", "64", "--samples", "48"};

std::vector<std::string> joined(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST_F(PlaceCommand, PlaceReportsDescriptors) {
  const Result result = run(joined(smallTorso, {"--size", "80x60", "--descriptors", "--pictures", at("seen")}));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Json json = result.json();
  ASSERT_EQ(json["descriptors"].size(), allDescriptors.size());
  EXPECT_EQ(json["directions"].size(), 48u);
  for (const std::string& name : allDescriptors) {
    const Json& each = json["descriptors"][name];
    ASSERT_EQ(each["values"].size(), 48u) << name;
    const std::size_t choice = each["choice"]["index"];
    const double best = each["choice"]["value"], sign = each["best"] == "high" ? 1.0 : -1.0;
    EXPECT_EQ(each["values"][choice], best) << name;
    for (const Json& value : each["values"]) EXPECT_LE(sign * value.get<double>(), sign * best) << name;
    EXPECT_EQ(each["choice"]["direction"], json["directions"][choice]) << name;
    for (const char* with : {"visibility", "coverage", "location", "share"})
      EXPECT_LE(std::abs(each["rank_correlation"][with].get<double>()), 1.0 + 1e-12) << name;
    EXPECT_LE(each["choice"]["degrees_from_c1"].get<double>(), 180.0);
    EXPECT_EQ(io::readPicture(at("seen/" + name + ".png")).size, glm::ivec2(80, 60));
  }
  // H(Z) is the same for all views of a channel, so I2 orders them as entropy does, reversed.
  EXPECT_EQ(json["descriptors"]["i2"]["choice"]["index"], json["descriptors"]["entropy"]["choice"]["index"]);
  const Json& views = json["representative_views"]["views"];
  EXPECT_EQ(views[0]["index"], json["descriptors"]["entropy"]["choice"]["index"]);
  EXPECT_EQ(json["representative_views"]["tour"].size(), views.size());
  for (std::size_t i = 1; i < views.size(); ++i)
    EXPECT_GT(views[i]["share_together"].get<double>(), views[i - 1]["share_together"].get<double>());
  EXPECT_TRUE(fs::exists(at("seen/c1.png")) && fs::exists(at("seen/representative-view-1.png")));
}

TEST_F(PlaceCommand, DescriptorsChangeNothingElse) {
  const auto placed = [&](const std::vector<std::string>& more) {
    const Result result = run(joined(smallTorso, more));
    EXPECT_EQ(result.exitCode, 0) << result.error;
    Json json = result.json();
    json.erase("milliseconds");
    return json;
  };
  const Json usual = placed({"--json", "all"});
  EXPECT_FALSE(usual.contains("descriptors") || usual.contains("directions"));
  Json described = placed({"--json", "all", "--descriptors", "silhouette-length,entropy"});
  EXPECT_EQ(described["descriptors"].size(), 2u);
  EXPECT_FALSE(described.contains("representative_views"));
  described.erase("descriptors");
  described.erase("directions");
  EXPECT_EQ(described, usual);
  const Json views = placed({"--descriptors", "representative-views"});
  EXPECT_TRUE(views["descriptors"].empty());
  EXPECT_FALSE(views["representative_views"]["views"].empty());
}

TEST_F(PlaceCommand, UnknownDescriptorsAreNamedWithTheKnownOnes) {
  const Result result = run(joined(smallTorso, {"--descriptors", "entropy,beauty"}));
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_NE(result.error.find("beauty"), std::string::npos) << result.error;
  for (const std::string& name : joined(allDescriptors, {"all", "representative-views"}))
    EXPECT_NE(result.error.find(name), std::string::npos) << result.error;
  EXPECT_EQ(run(joined(smallTorso, {"--descriptors", "", "--json", "all"})).exitCode, 2);
  EXPECT_EQ(run(joined(smallTorso, {"--descriptors", "--refine"})).exitCode, 2);
  EXPECT_EQ(run(joined(smallTorso, {"--pictures", at("seen")})).exitCode, 2);
}

TEST_F(PlaceCommand, PicturesNeedAFolder) {
  write(at("file"), "");
  expectFailure(run(joined(smallTorso, {"--descriptors", "entropy", "--pictures", at("file")})), at("file"));
}

TEST_F(PlaceCommand, PlaceWithoutAFocusFails) {
  const std::string empty = at("head.mha");
  ASSERT_EQ(run({"convert", "--phantom", "head", "--phantom-voxels", "24", "-o", empty}).exitCode, 0);
  expectFailure(run({"place", empty, "--map", at("map.png")}), empty);
  expectFailure(run({"place", empty, "--focus-range", "9000:9001"}), empty);
  expectFailure(run({"render", empty, "--camera", "best", "-o", at("x.png")}), empty);
  EXPECT_FALSE(fs::exists(at("map.png")) || fs::exists(at("x.png")));
}

// LiveSync: cameras for the structure at a point.

TEST_F(PlaceCommand, PickLooksAtALabel) {
  const Result result = run(joined(smallTorso, {"--pick", "0,0,0", "--json", "all", "--reach", "60"}));
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Json json = result.json();
  EXPECT_EQ(json["by"], "livesync");
  EXPECT_EQ(json["structure"]["name"], "mediastinum");
  EXPECT_FALSE(json["structure"]["grown"]);
  EXPECT_EQ(json["candidates"], 48);
  ASSERT_EQ(json["all"].size(), 48u + 6u);
  double along = 0.0;
  for (const char* camera : {"c1", "c2"}) {
    EXPECT_EQ(json[camera]["camera"]["target"], Json({0.0, 0.0, 0.0}));
    EXPECT_TRUE(json[camera]["spheres"]["view_history"].is_null());
  }
  for (std::size_t i = 0; i < 3; ++i)
    along += json["c1"]["direction"][i].get<double>() * json["c2"]["direction"][i].get<double>();
  EXPECT_LE(std::abs(along), 0.5 + 1e-9);
  for (const Json& each : json["all"]) {
    const Json& spheres = each["spheres"];
    const double mean = (spheres["patient_orientation"].get<double>() + spheres["local_shape"].get<double>() +
                         spheres["visibility"].get<double>()) /
                        3.0;
    EXPECT_NEAR(each["rating"].get<double>(), mean, 1e-12);
    EXPECT_LE(each["rating"].get<double>(), json["c1"]["rating"].get<double>() + 1e-9);
  }
  // By orientation alone, from the front.
  const Json front = run(joined(smallTorso, {"--pick", "0,0,0", "--pick-weights", "1,0,0"})).json();
  EXPECT_NEAR(front["c1"]["direction"][1].get<double>(), -1.0, 1e-12);
}

TEST_F(PlaceCommand, PickGrowsARegionWithoutLabels) {
  const std::string plain = at("plain.mha");
  ASSERT_EQ(run({"convert", "--phantom", "head", "--phantom-voxels", "64", "-o", plain}).exitCode, 0);
  const Json whole = run({"place", plain, "--pick", "0,0,0", "--samples", "48"}).json();
  ASSERT_TRUE(whole.contains("structure"));
  EXPECT_TRUE(whole["structure"]["grown"]);
  EXPECT_TRUE(whole["structure"]["label"].is_null());
  EXPECT_GT(whole["structure"]["voxels_within_reach"].get<int>(), 0);
  EXPECT_EQ(whole["c1"]["camera"]["target"], Json({0.0, 0.0, 0.0}));
}

TEST_F(PlaceCommand, PickOutsideOrInAirFails) {
  const auto fails = [&](const std::string& pick, const std::string& why) {
    const Result result = run(joined(smallTorso, {"--pick", pick}));
    expectFailure(result, "phantom torso");
    EXPECT_NE(result.error.find(why), std::string::npos) << result.error;
    EXPECT_TRUE(result.out.empty());
  };
  fails("0,0,5000", "outside of the volume");
  fails("1e300,0,0", "outside of the volume");
  fails("190,120,100", "lies in air");
  for (const std::string pick : {"0,0", "a,b,c", "0,0,nan"})
    EXPECT_EQ(run(joined(smallTorso, {"--pick", pick})).exitCode, 2) << pick;
  for (const std::string other : {"--joint", "--sequential", "--refine", "--descriptors"})
    EXPECT_EQ(run(joined(smallTorso, {"--pick", "0,0,0", other})).exitCode, 2) << other;
  EXPECT_EQ(run(joined(smallTorso, {"--reach", "20"})).exitCode, 2);
  EXPECT_EQ(run(joined(smallTorso, {"--pick", "0,0,0", "--pick-weights", "1,-1,0"})).exitCode, 2);
}

}  // namespace
}  // namespace fenestra::tests::placeCommandTest
