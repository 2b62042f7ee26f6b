// fenestra-cli render.

#include <cmath>
#include <set>

#include "io/ImageWriter.h"
#include "tests/cli/CommandLine.h"

namespace fenestra::tests::renderCommandTest {
namespace {

using RenderCommand = CommandLine;

TEST_F(RenderCommand, RenderWritesPictureLayersCameraAndStatistics) {
  const Result result =
      run({"render", "--phantom", "torso", "--phantom-voxels", "64", "--size", "96x72", "--w-open", "6", "-o",
           at("picture.png"), "--layers", at("layers"), "--stats", at("stats.json"), "--repeat", "3"});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const io::Picture picture = io::readPicture(at("picture.png"));
  EXPECT_EQ(picture.size, glm::ivec2(96, 72));
  EXPECT_EQ(picture.channels, 3);
  for (const char* name : {"t_context", "t_focus", "t_focus_filled", "t_start", "distance"}) {
    const io::Picture layer = io::readPicture(folder() / "layers" / (std::string(name) + ".mha"));
    EXPECT_EQ(layer.size, picture.size) << name;
    EXPECT_EQ(layer.channels, 1) << name;
  }
  for (const char* name : {"focus_layer", "context_layer", "final"})
    EXPECT_EQ(io::readPicture(folder() / "layers" / (std::string(name) + ".mha")).channels, 4) << name;

  const Json camera = Json::parse(contents(folder() / "layers" / "camera.json"));
  EXPECT_EQ(camera["size"], Json({96, 72}));
  EXPECT_EQ(camera["projection"], "perspective");
  ASSERT_EQ(camera["clipFromWorld"].size(), 4u);
  EXPECT_EQ(camera["clipFromWorld"][3].size(), 4u);

  const Json stats = Json::parse(contents(at("stats.json")));
  ASSERT_EQ(stats["passes"].size(), 20u);
  // Without strokes there is nothing to edit, without protected labels nothing to protect; nothing is clipped, no light
  // is hidden, edges are not smooth, and the method stands no cones, keeps nothing faint and has neither levels of
  // importance nor lens nor walls nor a maximum, and all edges of the context are drawn.
  const std::set<std::string> unused{"important hits",  "cones",   "edit map",      "occlusion", "faint layer",
                                     "protected layer", "lens",    "exempt labels", "edges",     "edge rays",
                                     "walls",           "maximum", "context lines"};
  for (const Json& pass : stats["passes"])
    EXPECT_EQ(pass["runs"], unused.contains(pass["name"].get<std::string>()) ? 0 : 3) << pass["name"];
  EXPECT_EQ(stats["frames_ms"].size(), 3u);
  EXPECT_GT(stats["total_ms"].get<double>(), 0.0);
  EXPECT_GE(stats["median_ms"].get<double>(), stats["min_ms"].get<double>());
  EXPECT_FALSE(stats["gl"].get<std::string>().empty());
  EXPECT_TRUE(stats["max_error"].is_null()) << "lit pictures of normal quality have no bound";
}

TEST_F(RenderCommand, SavedCameraGivesTheSamePicture) {
  const auto rendered = [&](const std::string& camera, const std::string& name) {
    const Result result =
        run({"render", "--phantom", "head", "--phantom-voxels", "48", "--camera", camera, "--projection",
             "orthographic", "--size", "70x50", "-o", at(name + ".png"), "--layers", at(name)});
    EXPECT_EQ(result.exitCode, 0) << result.error;
  };
  rendered("37,21", "first");
  rendered(at("first/camera.json"), "second");
  EXPECT_EQ(contents(at("first.png")), contents(at("second.png")));
  EXPECT_EQ(contents(at("first/camera.json")), contents(at("second/camera.json")));
}

TEST_F(RenderCommand, Thorough_RenderLooksFromThePlacedCameras) {
  const std::vector<std::string> scene{"--phantom", "head", "--phantom-voxels", "48"};
  std::vector<std::string> place{"place"};
  place.insert(place.end(), scene.begin(), scene.end());
  const Json placed = run(place).json();
  for (const auto& [choice, key] : {std::pair{"best", "c1"}, std::pair{"dual", "c2"}}) {
    std::vector<std::string> render{"render", "--camera",  choice,     "--size",  "40x30",
                                    "-o",     at("x.png"), "--layers", at(choice)};
    render.insert(render.end(), scene.begin(), scene.end());
    ASSERT_EQ(run(render).exitCode, 0);
    const Json camera = Json::parse(contents(folder() / choice / "camera.json"));
    EXPECT_EQ(camera["eye_world"], placed[key]["camera"]["eye"]);
  }
}

TEST_F(RenderCommand, ReferenceAgreesWithThePictureAndItsLayers) {
  const std::vector<std::string> scene{"render", "--phantom", "head", "--phantom-voxels", "48", "--size",
                                       "61x47",  "--w-open",  "5",    "--camera",         "A",  "--focus-labels",
                                       "tumour"};
  std::vector<std::string> onGpu = scene, onCpu = scene;
  onGpu.insert(onGpu.end(), {"--quality", "high", "-o", at("gpu.png"), "--layers", at("gpu")});
  onCpu.insert(onCpu.end(), {"--reference", "-o", at("cpu.png"), "--layers", at("cpu")});
  ASSERT_EQ(run(onGpu).exitCode, 0);
  ASSERT_EQ(run(onCpu).exitCode, 0);
  const auto expectWithin = [&](const std::string& name, double limit) {
    const Result compared = run({"compare", at("gpu" + name), at("cpu" + name)});
    EXPECT_EQ(compared.exitCode, 0) << name << ": " << compared.out << compared.error;
    EXPECT_LE(compared.json()["max"].get<double>(), limit) << name;
  };
  // Square roots of whole numbers in single precision.
  expectWithin("/distance.mha", 1e-5);
  // A hit to a thousandth of a voxel of 5 mm.
  for (const char* name : {"/t_context.mha", "/t_focus.mha", "/t_start.mha"}) expectWithin(name, 5e-3);
  // High quality is asked for an error below 1/255; a picture rounds once more.
  for (const char* name : {"/focus_layer.mha", "/final.mha"}) expectWithin(name, 1.0 / 255.0);
  expectWithin(".png", 2.0 / 255.0);
  expectWithin("/context_layer.mha", 2e-3);
  EXPECT_EQ(contents(at("gpu/camera.json")), contents(at("cpu/camera.json")));
}

TEST_F(RenderCommand, ReferenceNeedsSomewhereToWriteAndTakesNoTimes) {
  EXPECT_EQ(run({"render", "--phantom", "head", "--reference"}).exitCode, 2);
  EXPECT_EQ(run({"render", "--phantom", "head", "--reference", "-o", at("x.png"), "--repeat", "2"}).exitCode, 2);
  EXPECT_EQ(run({"render", "--phantom", "head", "--reference", "-o", at("x.png"), "--stats", at("x.json")}).exitCode,
            2);
  EXPECT_TRUE(nothingLeftBehind());
}

TEST_F(RenderCommand, TheTableOfACtIsHiddenUnlessAskedFor) {
  const auto render = [&](std::vector<std::string> scene, const std::string& hide, const std::string& name) {
    std::vector<std::string> all{"render", "--camera", "60,0", "--size", "90x90", "-o", at(name)};
    if (!hide.empty()) all.insert(all.end(), {"--hide-table", hide});
    all.insert(all.end(), scene.begin(), scene.end());
    const Result result = run(all);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return result.error;
  };
  const std::vector<std::string> phantom{"--phantom", "torso", "--phantom-voxels", "64"};
  EXPECT_EQ(render(phantom, "on", "on.png"), "");
  EXPECT_EQ(render(phantom, "off", "off.png"), "");
  EXPECT_EQ(contents(at("on.png")), contents(at("off.png"))) << "there is no table";

  FENESTRA_TEST_DATA_OR_SKIP(ct, "labelled/totalsegmentator-torso/example_ct.nii.gz");
  EXPECT_NE(render({ct.string()}, "", "usual.png").find("table"), std::string::npos);
  EXPECT_EQ(render({ct.string()}, "off", "off.png"), "");
  render({ct.string()}, "on", "on.png");
  EXPECT_EQ(contents(at("on.png")), contents(at("usual.png")));
  EXPECT_NE(contents(at("on.png")), contents(at("off.png")));
  // A session keeps the choice.
  ASSERT_EQ(run({"render", ct.string(), "--hide-table", "off", "--save-session", at("shown.fenestra"), "--camera",
                 "60,0", "--size", "90x90", "-o", at("x.png")})
                .exitCode,
            0);
  const Result again = run({"render", at("shown.fenestra"), "-o", at("again.png")});
  EXPECT_EQ(again.exitCode, 0) << again.error;
  EXPECT_EQ(contents(at("again.png")), contents(at("off.png")));
}

TEST_F(RenderCommand, UnknownLabelsNameTheNearest) {
  const Result result = run(
      {"render", "--phantom", "torso", "--phantom-voxels", "32", "--focus-labels", "Left Kidny", "-o", at("x.png")});
  expectFailure(result, "phantom torso");
  EXPECT_NE(result.error.find("left kidney"), std::string::npos) << result.error;
  EXPECT_TRUE(nothingLeftBehind());
}

TEST_F(RenderCommand, BrokenCameraAndTransferFunctionFilesFail) {
  write(at("camera.json"), R"({"projection": "perspective"})");
  expectFailure(
      run({"render", "--phantom", "head", "--phantom-voxels", "16", "--camera", at("camera.json"), "-o", at("x.png")}),
      at("camera.json"));
  expectFailure(run({"render", "--phantom", "head", "--phantom-voxels", "16", "--transfer-function", "ct-bones", "-o",
                     at("x.png")}),
                "ct-bones");
  EXPECT_FALSE(fs::exists(at("x.png")));
}

}  // namespace
}  // namespace fenestra::tests::renderCommandTest
