// fenestra-cli with sessions: the picture of a session is that of the options which made it, to the bit; options given
// beside override it.

#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/session/LookFile.h"
#include "io/session/SessionFile.h"
#include "io/session/StrokeFile.h"
#include "tests/io/IoTesting.h"
#include "tests/session/SessionTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::sessionCommandTest {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

struct Result {
  int exitCode = -1;  ///< -1: ended by a signal
  std::string out, error;
};

class SessionCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = scratchFolder();
    logs_ = folder_ / "logs";
    fs::create_directory(logs_);
  }

  Result run(const std::vector<std::string>& arguments) const {
    std::string command = "cd '" + folder_.string() + "' && '" FENESTRA_CLI "'";
    for (const std::string& argument : arguments) command.append(" '").append(argument).append("'");
    command.append(" >'").append((logs_ / "out").string()).append("' 2>'");
    command.append((logs_ / "error").string()).append("' </dev/null");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, readFile(logs_ / "out"), readFile(logs_ / "error")};
  }
  /// A hash of the picture that `render` makes.
  std::string picture(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "render");
    arguments.insert(arguments.end(), {"-o", "picture.png"});
    const Result result = run(arguments);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return io::hashOf(readFile(folder_ / "picture.png"));
  }
  fs::path at(const char* name) const { return folder_ / name; }

  /// Half the phantom's head as files: a volume and its labels.
  void makeFiles() const {
    ASSERT_EQ(run({"convert", "--phantom", "head", "--phantom-voxels", "48", "-o", "head.nii.gz"}).exitCode, 0);
  }

  fs::path folder_, logs_;
};

/// Every option that a picture depends on, none of them at its default.
const std::vector<std::string> options{"--focus-range",
                                       "300:3000",
                                       "--focus-min-size",
                                       "50",
                                       "--camera",
                                       "-30,20",
                                       "--projection",
                                       "orthographic",
                                       "--size",
                                       "150x210",
                                       "--w-open",
                                       "9.5",
                                       "--w-border",
                                       "3.25",
                                       "--width-unit",
                                       "mm",
                                       "--context-layer",
                                       "0.4",
                                       "--quality",
                                       "draft",
                                       "--background",
                                       "0.1,0.2,0.3",
                                       "--backdrop",
                                       "gradient",
                                       "--background-top",
                                       "0.6,0.5,0.4",
                                       "--light-preset",
                                       "wet",
                                       "--transfer-function",
                                       "ct-soft-tissue"};

TEST_F(SessionCommand, APresetOfALookGivesThePictureOfItsSession) {
  makeFiles();
  const std::vector<std::string> data{"head.nii.gz", "--focus-range", "300:3000",  "--camera", "-30,20",
                                      "--size",      "120x90",        "--quality", "draft"};
  const std::vector<std::string> look{
      "--transfer-function", "ct-angio",    "--w-open",        "9.5",        "--w-border",      "3.25",
      "--width-unit",        "mm",          "--light",         "70,-20",     "--context-layer", "0.4",
      "--background",        "0.1,0.2,0.3", "--border-colour", "0.9,0.1,0.1"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = data;
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  std::vector<std::string> saving = look;
  saving.insert(saving.end(), {"--save-session", "a.fenestra", "--save-look", "Mine.json"});
  const std::string byOptions = picture(with(saving));
  EXPECT_NE(byOptions, picture(with({}))) << "the look differs from the default";
  EXPECT_EQ(picture(with({"--look", "Mine.json"})), byOptions);
  EXPECT_EQ(picture({"a.fenestra"}), byOptions);
  EXPECT_EQ(picture({"a.fenestra", "--look", "Mine.json"}), byOptions);
  EXPECT_EQ(picture(with({"--look", "Mine.json", "--save-look", "b.json"})), byOptions);
  io::LookPreset mine = io::readLook(at("Mine.json"));
  EXPECT_EQ(mine.name, "Mine");
  mine.name = "b";
  EXPECT_EQ(mine, io::readLook(at("b.json")));
  // An option beside it counts.
  std::vector<std::string> wider = look;
  wider[3] = "15";
  EXPECT_EQ(picture(with({"--w-open", "15", "--look", "Mine.json"})), picture(with(wider)));
}

TEST_F(SessionCommand, ALookThatIsNoneIsOneLineThatNamesTheFile) {
  makeFiles();
  writeFile(at("bad.json"), R"({"format": "fenestra-look", "version": 1, "name": "x", "nodes": 7})");
  for (const char* file : {"bad.json", "missing.json"}) {
    const Result result = run({"render", "head.nii.gz", "--look", file, "-o", "picture.png"});
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_NE(result.error.find(file), std::string::npos) << result.error;
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
    EXPECT_FALSE(fs::exists(at("picture.png")));
  }
  EXPECT_EQ(run({"render", "head.nii.gz", "--look", "pretty", "-o", "picture.png"}).exitCode, 2);
}

TEST_F(SessionCommand, Thorough_RendersASessionAsTheOptionsThatMadeIt) {
  makeFiles();
  std::vector<std::string> arguments{"head.nii.gz"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const std::string byOptions = picture(arguments);
  arguments.insert(arguments.end(), {"--save-session", "a.fenestra"});
  EXPECT_EQ(picture(arguments), byOptions);
  EXPECT_EQ(picture({"a.fenestra"}), byOptions);
  EXPECT_EQ(picture({"a.fenestra", "--save-session", "b.fenestra"}), byOptions);
  EXPECT_EQ(readFile(at("a.fenestra")), readFile(at("b.fenestra")));

  // One option beside, and it is as if it had been given in the first place.
  for (const std::vector<std::string>& beside :
       std::vector<std::vector<std::string>>{{"--w-open", "2"},
                                             {"--size", "120x90"},
                                             {"--shading", "off"},
                                             {"--light", "70,-20"},
                                             {"--cutaway", "off"},
                                             {"--method", "cone"},
                                             {"--quality", "normal"},
                                             {"--transfer-function", "ct-angio"},
                                             {"--focus-range", "900:3000"},
                                             {"--camera", "L"}}) {
    std::vector<std::string> instead{"head.nii.gz"};
    for (std::size_t i = 0; i < options.size(); i += 2)
      if (options[i] != beside[0]) instead.insert(instead.end(), {options[i], options[i + 1]});
    instead.insert(instead.end(), beside.begin(), beside.end());
    // A session's projection is its camera's; another camera comes in the usual one.
    std::vector<std::string> overridden{"a.fenestra", beside[0], beside[1]};
    if (beside[0] == "--camera") overridden.insert(overridden.end(), {"--projection", "orthographic"});
    // A standard camera frames what the transfer function shows; a session's camera stays where it is.
    if (beside[0] == "--transfer-function")
      overridden.insert(overridden.end(), {"--camera", "-30,20", "--projection", "orthographic"});
    if (beside[0] == "--focus-range") overridden.insert(overridden.end(), {"--focus-min-size", "50"});
    EXPECT_EQ(picture(overridden), picture(instead)) << beside[0];
    EXPECT_NE(picture(overridden), byOptions) << beside[0];
  }
}

TEST_F(SessionCommand, RendersPhantomsPlacedCamerasAndBothViews) {
  const std::vector<std::string> phantom{"--phantom", "head", "--phantom-voxels", "48", "--size", "90x130"};
  std::vector<std::string> arguments = phantom;
  arguments.insert(arguments.end(), {"--camera", "dual", "--save-session", "a.fenestra"});
  const std::string placed = picture(arguments);
  EXPECT_EQ(picture({"a.fenestra"}), placed);
  io::Session session = io::readSession(at("a.fenestra"));
  session.views[1] = {session.views[0].camera, {100, 140}, 2.0, true};
  session.views[1].camera.eye += glm::dvec3(30.0, 10.0, 0.0);
  io::writeSession(at("a.fenestra"), session);
  EXPECT_EQ(picture({"a.fenestra"}), placed);
  const std::string second = picture({"a.fenestra", "--view", "C2", "--save-session", "b.fenestra"});
  EXPECT_NE(second, placed);
  EXPECT_EQ(readFile(at("a.fenestra")), readFile(at("b.fenestra"))) << "C2's picture is of C2";
}

TEST_F(SessionCommand, PaintsTheStrokesOfASession) {
  const std::string plain =
      picture({"--phantom", "head", "--phantom-voxels", "64", "--size", "120x120", "--save-session", "a.fenestra"});
  io::Session session = io::readSession(at("a.fenestra"));
  BrushStroke stroke;
  stroke.mode = BrushMode::Fade;
  stroke.radius = 60.0;
  stroke.amount = 1.0;
  const glm::dvec3 towardsEye = glm::normalize(session.views[0].camera.eye - session.views[0].camera.target);
  for (double mm = 60.0; mm < 110.0; mm += 5.0)
    stroke.anchors.push_back(session.views[0].camera.target + mm * towardsEye);
  session.look.strokes = {stroke};
  io::writeSession(at("a.fenestra"), session);
  EXPECT_NE(picture({"a.fenestra"}), plain);
  session.look.strokes[0].view = 1;
  io::writeSession(at("a.fenestra"), session);
  EXPECT_EQ(picture({"a.fenestra"}), plain) << "painted for C2 alone";
  stroke.view = -1;
  io::writeStrokes(at("strokes.json"), {stroke});
  const std::string applied = picture({"a.fenestra", "--strokes", "strokes.json", "--save-session", "b.fenestra"});
  EXPECT_NE(applied, plain);
  EXPECT_EQ(picture({"b.fenestra"}), applied);
}

TEST_F(SessionCommand, OpensASessionWhereverAVolumeIsNamed) {
  makeFiles();
  picture({"head.nii.gz", "--focus-range", "300:3000", "--size", "64x64", "--save-session", "a.fenestra"});
  const Result info = run({"info", "a.fenestra"});
  ASSERT_EQ(info.exitCode, 0) << info.error;
  EXPECT_EQ(Json::parse(info.out)["dims"], Json::parse(run({"info", "head.nii.gz"}).out)["dims"]);
  EXPECT_EQ(Json::parse(info.out)["session"]["strokes"], 0);
  EXPECT_EQ(run({"convert", "a.fenestra", "-o", "again.nii.gz"}).exitCode, 0);
  EXPECT_EQ(run({"slice", "a.fenestra", "-o", "slice.png"}).exitCode, 0);

  io::Session session = io::readSession(at("a.fenestra"));
  session.placement.samples = 12;
  session.placement.weights.coverage = 3.0;
  session.placement.inStream = true;
  io::writeSession(at("a.fenestra"), session);
  const Json placed = Json::parse(run({"place", "a.fenestra"}).out);
  const Json same = Json::parse(run({"place", "head.nii.gz", "--focus-range", "300:3000", "--samples", "12",
                                     "--weights", "-0.02,3,0.5", "--region", "stream"})
                                    .out);
  EXPECT_EQ(placed["candidates"], 12);
  EXPECT_EQ(placed["c1"], same["c1"]);
  EXPECT_EQ(placed["region"], "stream");
  EXPECT_EQ(Json::parse(run({"place", "a.fenestra", "--samples", "48"}).out)["candidates"], 48);
}

TEST_F(SessionCommand, SaysWhatIsWrongInOneLine) {
  makeFiles();
  const std::string whole =
      picture({"head.nii.gz", "--focus-range", "300:3000", "--size", "64x64", "--save-session", "a.fenestra"});
  const auto expectFailure = [&](const std::vector<std::string>& arguments, const std::string& part) {
    const Result result = run(arguments);
    EXPECT_EQ(result.exitCode, 1) << result.error;
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
    EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
    EXPECT_TRUE(result.error.starts_with("fenestra-cli: ")) << result.error;
  };
  fs::create_directory(at("elsewhere"));
  fs::rename(at("head.nii.gz"), at("elsewhere") / "renamed.nii.gz");
  EXPECT_EQ(picture({"a.fenestra"}), whole) << "found below, by its contents";
  fs::rename(at("elsewhere"), folder_.parent_path() / "SessionCommand.elsewhere");
  expectFailure({"render", "a.fenestra", "-o", "b.png"}, "--data PATH");
  expectFailure({"info", "a.fenestra"}, "--data PATH");
  const fs::path moved = folder_.parent_path() / "SessionCommand.elsewhere" / "renamed.nii.gz";
  EXPECT_EQ(picture({"a.fenestra", "--data", moved.string()}), whole);
  fs::remove_all(moved.parent_path());

  writeFile(at("b.fenestra"), readFile(at("a.fenestra")).substr(0, 500));
  expectFailure({"render", "b.fenestra", "-o", "b.png"}, "not valid JSON");
  expectFailure({"info", "b.fenestra"}, "not valid JSON");
  expectFailure({"render", "none.fenestra", "-o", "b.png"}, "does not exist");
  EXPECT_FALSE(fs::exists(at("b.png")));
  expectFailure({"render", "a.fenestra", "--series", "1.2.3", "-o", "b.png"}, "leave out --series");
  EXPECT_EQ(run({"render", "a.fenestra", "--view", "C3", "-o", "b.png"}).exitCode, 2);
  EXPECT_EQ(run({"render", "head.nii.gz", "--data", "b.nii.gz", "-o", "b.png"}).exitCode, 2);
}

TEST_F(SessionCommand, ChangedDataIsSaid) {
  makeFiles();
  picture({"head.nii.gz", "--size", "64x64", "--save-session", "a.fenestra"});
  ASSERT_EQ(run({"convert", "--phantom", "head", "--phantom-voxels", "40", "-o", "head.nii.gz"}).exitCode, 0);
  const Result result = run({"render", "a.fenestra", "-o", "b.png"});
  EXPECT_EQ(result.exitCode, 0);
  EXPECT_NE(result.error.find("warning"), std::string::npos);
  EXPECT_NE(result.error.find("is not what it was"), std::string::npos) << result.error;
}

}  // namespace
}  // namespace fenestra::tests::sessionCommandTest
