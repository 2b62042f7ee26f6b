// Runs the fenestra-cli binary as a user or a script does.

#include <sys/wait.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/ImageWriter.h"
#include "rendering/scene/Settings.h"
#include "tests/support/TestData.h"

namespace fenestra {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write(const fs::path& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

struct Result {
  int exitCode = -1;  ///< -1: ended by a signal
  std::string out, error;
  Json json() const { return Json::parse(out, nullptr, false); }
};

class CommandLine : public ::testing::Test {
 protected:
  Result run(const std::vector<std::string>& arguments) const {
    std::string command = quoted(FENESTRA_CLI);
    for (const std::string& argument : arguments) command.append(" ").append(quoted(argument));
    const fs::path out = logs_ / "out", error = logs_ / "error";
    command.append(" >").append(quoted(out)).append(" 2>").append(quoted(error)).append(" </dev/null");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(out), contents(error)};
  }

  /// Exit code 1 and one line on standard error that names the program and `path`.
  static void expectFailure(const Result& result, const std::string& path) {
    EXPECT_EQ(result.exitCode, 1) << result.error;
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
    EXPECT_TRUE(result.error.starts_with("fenestra-cli: " + path + ": ")) << result.error;
  }

  fs::path folder() const { return folder_; }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  bool nothingLeftBehind() const { return fs::is_empty(folder_); }

 private:
  static std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
  }
  static fs::path made(const fs::path& path) {
    fs::create_directories(path);
    return path;
  }

  const fs::path scratch_ = tests::scratchFolder();
  const fs::path logs_ = made(scratch_ / "logs");
  const fs::path folder_ = made(scratch_ / "files");
};

TEST_F(CommandLine, HelpAndVersionSucceed) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--help"}, {"--version"}, {"info", "--help"}, {"render", "--help"}}) {
    const Result result = run(arguments);
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_FALSE(result.out.empty());
    EXPECT_TRUE(result.error.empty()) << result.error;
  }
}

TEST_F(CommandLine, WrongUsageExitsWithTwo) {
  const std::string png = at("x.png");
  const std::vector<std::vector<std::string>> mistakes{
      {},
      {"frobnicate"},
      {"info"},
      {"info", "a", "--phantom", "torso"},
      {"info", "--phantom", "elephant"},
      {"info", "a", "--raw", "nonsense"},
      {"info", "a", "--spacing", "1,1,1"},
      {"info", "--phantom", "head", "--phantom-voxels", "0"},
      {"convert", "a"},
      {"slice", "a", "--plane", "oblique", "-o", png},
      {"slice", "a", "--at", "3", "--index", "3", "-o", png},
      {"slice", "a", "--window", "-5", "-o", png},
      {"render", "--phantom", "head"},
      {"render", "a", "--focus-labels", "3", "-o", png},
      {"render", "--phantom", "head", "--labels", "b", "-o", png},
      {"render", "--phantom", "head", "--focus-range", "5:3", "-o", png},
      {"render", "--phantom", "head", "--focus-range", "nan:3", "-o", png},
      {"render", "--phantom", "head", "--focus-range", "1:3", "--focus-labels", "3", "-o", png},
      {"render", "--phantom", "head", "--size", "0x5", "-o", png},
      {"render", "--phantom", "head", "--size", "5x16385", "-o", png},
      {"render", "--phantom", "head", "--size", "640", "-o", png},
      {"render", "--phantom", "head", "--camera", "Q", "-o", png},
      {"render", "--phantom", "head", "--camera", "1,2,3", "-o", png},
      {"render", "--phantom", "head", "--w-open", "-1", "-o", png},
      {"render", "--phantom", "head", "--light", "0,91", "-o", png},
      {"render", "--phantom", "head", "--context-layer", "1.5", "-o", png},
      {"render", "--phantom", "head", "--cutaway", "maybe", "-o", png},
      {"render", "--phantom", "head", "--background", "1,2,3", "-o", png},
      {"render", "--phantom", "head", "--reference"},
      {"render", "--phantom", "head", "--repeat", "0", "-o", png},
      {"place"},
      {"place", "--phantom", "head", "--samples", "100"},
      {"place", "--phantom", "head", "--samples", "0"},
      {"place", "--phantom", "head", "--region", "sphere"},
      {"place", "--phantom", "head", "--weights", "1,2"},
      {"place", "--phantom", "head", "--delta", "91"},
      {"place", "--phantom", "head", "--share-weight", "0.5", "--sequential"},
      {"place", "--phantom", "head", "--side", "0"},
      {"compare", "a"},
  };
  for (const auto& arguments : mistakes) {
    const Result result = run(arguments);
    std::string line;
    for (const std::string& argument : arguments) line += argument + " ";
    EXPECT_EQ(result.exitCode, 2) << line << result.error;
    EXPECT_TRUE(result.out.empty()) << line;
    EXPECT_TRUE(result.error.starts_with("fenestra-cli: ")) << line << result.error;
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << line << result.error;
  }
  EXPECT_TRUE(nothingLeftBehind());
}

/// Every setting with an option is in --help with its description, and refuses numbers outside its range.
TEST_F(CommandLine, OptionsOfSettingsAreAsDeclared) {
  const std::string help = run({"render", "--help"}).out, png = at("a.png");
  int options = 0;
  const auto check = [&]<class Part>(const Part& part) {
    forEachSetting<Part>([&](const auto& setting) {
      if (!setting.option) return;
      ++options;
      EXPECT_NE(help.find(std::string("  ") + setting.option + " "), std::string::npos) << setting.option;
      EXPECT_NE(help.find(setting.description + 1), std::string::npos) << setting.option;
      if constexpr (std::same_as<std::remove_cvref_t<decltype(part.*setting.member)>, double>) {
        for (const double outside : {setting.range.low - 1.0, setting.range.high * 1.01}) {
          const auto result = run({"render", "--phantom", "head", setting.option, std::to_string(outside), "-o", png});
          EXPECT_EQ(result.exitCode, 2) << setting.option << " " << outside;
        }
      }
    });
  };
  check(Cutaway{});
  check(ContextLayer{});
  check(Shading{});
  check(ValueFocus{});
  check(Look{});
  EXPECT_EQ(options, 15);
  EXPECT_TRUE(nothingLeftBehind());
}

/// A file or folder that is no volume.
struct BadInput {
  std::string name;  ///< what it is, and the file's name
  std::string file;
  std::function<void(const fs::path&)> make;
};
void PrintTo(const BadInput& input, std::ostream* out) { *out << input.name; }

std::string randomBytes(std::size_t count) {
  std::mt19937 engine(7);
  std::string bytes(count, '\0');
  for (char& c : bytes) c = static_cast<char>(engine() & 0xff);
  return bytes;
}

/// The first `keep` bytes of a volume that the program itself wrote.
std::function<void(const fs::path&)> truncated(std::size_t keep) {
  return [=](const fs::path& path) {
    const std::string command =
        std::string(FENESTRA_CLI) + " convert --phantom head --phantom-voxels 24 -o '" + path.string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    ASSERT_GT(fs::file_size(path), keep);
    fs::resize_file(path, keep);
  };
}

std::vector<BadInput> badInputs() {
  const auto bytes = [](std::string text) { return [=](const fs::path& path) { write(path, text); }; };
  const std::string png = "\x89PNG\r\n\x1a\n" + randomBytes(300);
  return {
      {"Missing", "missing.nii.gz", [](const fs::path&) {}},
      {"MissingFolder", "missing", [](const fs::path&) {}},
      {"EmptyNifti", "empty.nii", bytes("")},
      {"EmptyGzip", "empty.nii.gz", bytes("")},
      {"EmptyMeta", "empty.mha", bytes("")},
      {"EmptyNrrd", "empty.nrrd", bytes("")},
      {"EmptyDicom", "empty.dcm", bytes("")},
      {"EmptyNamelessFile", "empty", bytes("")},
      {"TruncatedNiftiHeader", "header.nii", truncated(200)},
      {"TruncatedNifti", "data.nii", truncated(2000)},
      {"TruncatedGzip", "data.nii.gz", truncated(900)},
      {"TruncatedMeta", "data.mha", truncated(900)},
      {"TruncatedNrrd", "data.nrrd", truncated(900)},
      {"PngCalledNifti", "picture.nii.gz", bytes(png)},
      {"PngCalledDicom", "picture.dcm", bytes(png)},
      {"PngCalledNrrd", "picture.nrrd", bytes(png)},
      {"TextCalledMeta", "letter.mha", bytes("Dear reader,\nthis is no volume.\n")},
      {"RandomNifti", "random.nii", bytes(randomBytes(5000))},
      {"RandomMeta", "random.mha", bytes(randomBytes(5000))},
      {"RandomDicom", "random.dcm", bytes(randomBytes(5000))},
      {"RandomNamelessFile", "random", bytes(randomBytes(5000))},
      {"HugeMeta", "huge.mha",
       bytes("ObjectType = Image\nNDims = 3\nDimSize = 100000 100000 100000\nElementType = MET_SHORT\n"
             "ElementDataFile = LOCAL\nab")},
      {"HugeNrrd", "huge.nrrd",
       bytes("NRRD0004\ntype: short\ndimension: 3\nsizes: 2000000000 2000000000 "
             "2000000000\nencoding: raw\n\nab")},
      {"EmptyFolder", "folder", [](const fs::path& path) { fs::create_directories(path); }},
      {"FolderWithoutImages", "papers",
       [](const fs::path& path) {
         fs::create_directories(path);
         write(path / "notes.txt", "no images here\n");
         write(path / "noise.bin", randomBytes(2000));
       }},
  };
}

class BrokenInput : public CommandLine, public ::testing::WithParamInterface<BadInput> {};

TEST_P(BrokenInput, FailsWithOneClearLineAndNoOutput) {
  const fs::path inputs = folder().parent_path() / "inputs";
  fs::create_directories(inputs);
  const std::string path = (inputs / GetParam().file).string();
  GetParam().make(path);
  ASSERT_FALSE(HasFatalFailure());
  expectFailure(run({"info", path}), path);
  expectFailure(run({"convert", path, "-o", at("out.mha")}), path);
  expectFailure(run({"slice", path, "-o", at("out.png")}), path);
  expectFailure(run({"render", path, "-o", at("out.png"), "--stats", at("out.json")}), path);
  EXPECT_TRUE(nothingLeftBehind());
}

INSTANTIATE_TEST_SUITE_P(Kinds, BrokenInput, ::testing::ValuesIn(badInputs()),
                         [](const auto& instance) { return instance.param.name; });

TEST_F(CommandLine, UnwritableOutputFails) {
  write(folder() / "file", "in the way");
  const std::string below = at("file/out");
  expectFailure(run({"convert", "--phantom", "head", "--phantom-voxels", "16", "-o", below + ".mha"}), below + ".mha");
  expectFailure(run({"slice", "--phantom", "head", "--phantom-voxels", "16", "-o", below + ".png"}), below + ".png");
  const Result result = run({"render", "--phantom", "head", "--phantom-voxels", "16", "--reference", "--size", "4x4",
                             "--layers", at("file/layers")});
  expectFailure(result, at("file/layers"));
  EXPECT_EQ(contents(folder() / "file"), "in the way");
}

TEST_F(CommandLine, UnknownOutputFormatFails) {
  expectFailure(run({"convert", "--phantom", "head", "--phantom-voxels", "16", "-o", at("out.xyz")}), at("out.xyz"));
  EXPECT_TRUE(nothingLeftBehind());
}

TEST_F(CommandLine, InfoDescribesThePhantom) {
  const Result result = run({"info", "--phantom", "torso", "--phantom-voxels", "48"});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  EXPECT_TRUE(result.error.empty()) << result.error;
  const Json info = result.json();
  EXPECT_EQ(info["format"], "phantom");
  EXPECT_EQ(info["unit"], "HU");
  EXPECT_EQ(info["modality"], "CT");
  EXPECT_EQ(info["type"], "int16");
  EXPECT_EQ(info["dims"].size(), 3u);
  EXPECT_EQ(info["dims"][2], 48);
  EXPECT_EQ(info["range"][0], -1000.0);
  EXPECT_EQ(info["warnings"], Json::array());
}

TEST_F(CommandLine, ConvertedVolumesAreTheSameVolume) {
  const Json original = run({"info", "--phantom", "head", "--phantom-voxels", "40"}).json();
  for (const std::string name : {"volume.mha", "volume.nii.gz", "volume.nii", "volume.nrrd", "Kopf größer 頭.nrrd"}) {
    const Result converted = run({"convert", "--phantom", "head", "--phantom-voxels", "40", "-o", at(name)});
    ASSERT_EQ(converted.exitCode, 0) << converted.error;
    const Result result = run({"info", at(name)});
    ASSERT_EQ(result.exitCode, 0) << name << ": " << result.error;
    const Json info = result.json();
    EXPECT_EQ(info["dims"], original["dims"]) << name;
    EXPECT_EQ(info["type"], original["type"]) << name;
    EXPECT_EQ(info["range"], original["range"]) << name;
    for (int axis = 0; axis < 3; ++axis) {
      // NIfTI keeps its geometry in single precision: 6e-8 of up to 150 mm.
      EXPECT_NEAR(info["spacing"][axis].get<double>(), original["spacing"][axis].get<double>(), 1e-5) << name;
      EXPECT_NEAR(info["origin"][axis].get<double>(), original["origin"][axis].get<double>(), 1e-4) << name;
      for (int column = 0; column < 3; ++column)
        EXPECT_NEAR(info["direction"][axis][column].get<double>(), axis == column, 1e-6) << name;
    }
  }
}

TEST_F(CommandLine, SliceOfRawBytesIsExact) {
  // 3×2×2: value 10·x + 40·y + 100·z; axes along L, P, S.
  std::string bytes;
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 3; ++x) bytes += static_cast<char>(10 * x + 40 * y + 100 * z);
  const std::string raw = (folder() / "bytes.raw").string();
  write(raw, bytes);
  const auto sliceOf = [&](const std::string& plane, const std::string& index) {
    const Result result = run({"slice", raw, "--raw", "3x2x2:uint8", "--spacing", "1,2,3", "--plane", plane, "--index",
                               index, "--window", "255", "--level", "127.5", "-o", at("slice.png")});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    std::vector<int> grey;
    for (const float value : io::readPicture(at("slice.png")).values)
      grey.push_back(static_cast<int>(std::lround(value * 255.0f)));
    return grey;
  };
  EXPECT_EQ(sliceOf("axial", "1"), (std::vector<int>{100, 110, 120, 140, 150, 160}));
  EXPECT_EQ(sliceOf("coronal", "0"), (std::vector<int>{100, 110, 120, 0, 10, 20}));
  EXPECT_EQ(sliceOf("sagittal", "2"), (std::vector<int>{120, 160, 20, 60}));
}

TEST_F(CommandLine, SlicesOfThePhantomAreTheRightWayUp) {
  const auto sliceOf = [&](const std::string& plane, const std::string& mm) {
    const Result result = run({"slice", "--phantom", "head", "--phantom-voxels", "150", "--plane", plane, "--at", mm,
                               "--window", "400", "--level", "0", "-o", at("slice.png")});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    return io::readPicture(at("slice.png"));
  };
  const auto grey = [](const io::Picture& picture, int i, int j) {
    return picture.values[static_cast<std::size_t>(j * picture.size.x + i)];
  };
  /// Pixels of air from an edge inwards: from (i, j) in steps of (di, dj).
  const auto air = [&](const io::Picture& picture, int i, int j, int di, int dj) {
    int steps = 0;
    for (; i >= 0 && j >= 0 && i < picture.size.x && j < picture.size.y && grey(picture, i, j) < 0.1f; i += di, j += dj)
      ++steps;
    return steps;
  };
  // The nose comes close to the front of the picture's box, the back of the head does not.
  const io::Picture axial = sliceOf("axial", "-30");
  const int middle = axial.size.x / 2;
  EXPECT_LT(air(axial, middle, 0, 0, 1) + 5, air(axial, middle, axial.size.y - 1, 0, -1));
  // The neck runs out of the box below, there is air above the crown.
  const io::Picture coronal = sliceOf("coronal", "15");
  EXPECT_EQ(air(coronal, coronal.size.x / 2, coronal.size.y - 1, 0, -1), 0);
  EXPECT_GT(air(coronal, coronal.size.x / 2, 0, 0, 1), 3);
  const io::Picture sagittal = sliceOf("sagittal", "0");
  EXPECT_EQ(air(sagittal, sagittal.size.x / 2, sagittal.size.y - 1, 0, -1), 0);
  const int noseRow = sagittal.size.y * 6 / 10;  // z = -30 of 150 … -150
  EXPECT_LT(air(sagittal, 0, noseRow, 1, 0) + 5, air(sagittal, sagittal.size.x - 1, noseRow, -1, 0));
}

TEST_F(CommandLine, SliceOutsideTheVolumeFails) {
  const Result result =
      run({"slice", "--phantom", "head", "--phantom-voxels", "16", "--index", "16", "-o", at("x.png")});
  expectFailure(result, "phantom head");
  EXPECT_NE(result.error.find("0 to 15"), std::string::npos) << result.error;
  EXPECT_TRUE(nothingLeftBehind());
}

TEST_F(CommandLine, CompareMeasuresErrors) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::vector<float> a{0.0f, 1.0f, 2.0f, nan, inf, -inf}, b{0.5f, 1.0f, 0.0f, nan, inf, -inf};
  io::writeLayer(at("a.mha"), {3, 2}, 1, a);
  io::writeLayer(at("b.mha"), {3, 2}, 1, b);
  const Result same = run({"compare", at("a.mha"), at("a.mha")});
  EXPECT_EQ(same.exitCode, 0) << same.error;
  EXPECT_EQ(same.json()["max"], 0.0);
  const Result differ = run({"compare", at("a.mha"), at("b.mha")});
  EXPECT_EQ(differ.exitCode, 0) << differ.error;
  EXPECT_EQ(differ.json()["compared"], 3);
  EXPECT_EQ(differ.json()["max"], 2.0);
  EXPECT_NEAR(differ.json()["rms"].get<double>(), std::sqrt(4.25 / 3.0), 1e-12);
  EXPECT_EQ(differ.json()["percentiles"]["50"], 0.5);
}

TEST_F(CommandLine, CompareFailsWhereNanOrInfinityDisagree) {
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  io::writeLayer(at("finite.mha"), {2, 1}, 1, std::vector<float>{1.0f, 2.0f});
  io::writeLayer(at("nan.mha"), {2, 1}, 1, std::vector<float>{1.0f, nan});
  io::writeLayer(at("inf.mha"), {2, 1}, 1, std::vector<float>{1.0f, inf});
  io::writeLayer(at("minus.mha"), {2, 1}, 1, std::vector<float>{1.0f, -inf});
  const auto compared = [&](const std::string& a, const std::string& b) { return run({"compare", at(a), at(b)}); };
  EXPECT_EQ(compared("finite.mha", "nan.mha").exitCode, 1);
  EXPECT_EQ(compared("finite.mha", "nan.mha").json()["nan_mismatches"], 1);
  EXPECT_EQ(compared("inf.mha", "finite.mha").exitCode, 1);
  EXPECT_EQ(compared("inf.mha", "minus.mha").json()["infinity_mismatches"], 1);
  EXPECT_EQ(compared("nan.mha", "inf.mha").exitCode, 1);
}

TEST_F(CommandLine, CompareRefusesDifferentSizesAndNoPictures) {
  io::writeLayer(at("a.mha"), {2, 1}, 1, std::vector<float>{1.0f, 2.0f});
  io::writeLayer(at("b.mha"), {1, 2}, 1, std::vector<float>{1.0f, 2.0f});
  expectFailure(run({"compare", at("a.mha"), at("b.mha")}), at("b.mha"));
  expectFailure(run({"compare", at("a.mha"), at("missing.png")}), at("missing.png"));
  write(at("noise.png"), randomBytes(400));
  expectFailure(run({"compare", at("noise.png"), at("a.mha")}), at("noise.png"));
}

TEST_F(CommandLine, RenderWritesPictureLayersCameraAndStatistics) {
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
  ASSERT_EQ(stats["passes"].size(), 9u);
  // Without strokes there is nothing to edit, and without protected labels nothing to protect.
  for (const Json& pass : stats["passes"])
    EXPECT_EQ(pass["runs"], pass["name"] == "edit map" || pass["name"] == "protected layer" ? 0 : 3) << pass["name"];
  EXPECT_EQ(stats["frames_ms"].size(), 3u);
  EXPECT_GT(stats["total_ms"].get<double>(), 0.0);
  EXPECT_GE(stats["median_ms"].get<double>(), stats["min_ms"].get<double>());
  EXPECT_FALSE(stats["gl"].get<std::string>().empty());
}

TEST_F(CommandLine, SavedCameraGivesTheSamePicture) {
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

TEST_F(CommandLine, ReferenceAgreesWithThePictureAndItsLayers) {
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

TEST_F(CommandLine, ReferenceNeedsSomewhereToWriteAndTakesNoTimes) {
  EXPECT_EQ(run({"render", "--phantom", "head", "--reference"}).exitCode, 2);
  EXPECT_EQ(run({"render", "--phantom", "head", "--reference", "-o", at("x.png"), "--repeat", "2"}).exitCode, 2);
  EXPECT_EQ(run({"render", "--phantom", "head", "--reference", "-o", at("x.png"), "--stats", at("x.json")}).exitCode,
            2);
  EXPECT_TRUE(nothingLeftBehind());
}

TEST_F(CommandLine, TheTableOfACtIsHiddenUnlessAskedFor) {
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

TEST_F(CommandLine, UnknownLabelsNameTheNearest) {
  const Result result = run(
      {"render", "--phantom", "torso", "--phantom-voxels", "32", "--focus-labels", "Left Kidny", "-o", at("x.png")});
  expectFailure(result, "phantom torso");
  EXPECT_NE(result.error.find("left kidney"), std::string::npos) << result.error;
  EXPECT_TRUE(nothingLeftBehind());
}

TEST_F(CommandLine, BrokenCameraAndTransferFunctionFilesFail) {
  write(at("camera.json"), R"({"projection": "perspective"})");
  expectFailure(
      run({"render", "--phantom", "head", "--phantom-voxels", "16", "--camera", at("camera.json"), "-o", at("x.png")}),
      at("camera.json"));
  expectFailure(run({"render", "--phantom", "head", "--phantom-voxels", "16", "--transfer-function", "ct-bones", "-o",
                     at("x.png")}),
                "ct-bones");
  EXPECT_FALSE(fs::exists(at("x.png")));
}

TEST_F(CommandLine, PlaceNamesTheNearestNumbersOfSamples) {
  const Result result = run({"place", "--phantom", "head", "--samples", "184"});
  EXPECT_EQ(result.exitCode, 2);
  EXPECT_NE(result.error.find("108 and 192"), std::string::npos) << result.error;
}

TEST_F(CommandLine, PlaceReportsBothCamerasAndDrawsTheMap) {
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

TEST_F(CommandLine, PlaceWithoutAFocusFails) {
  const std::string empty = at("head.mha");
  ASSERT_EQ(run({"convert", "--phantom", "head", "--phantom-voxels", "24", "-o", empty}).exitCode, 0);
  expectFailure(run({"place", empty, "--map", at("map.png")}), empty);
  expectFailure(run({"place", empty, "--focus-range", "9000:9001"}), empty);
  expectFailure(run({"render", empty, "--camera", "best", "-o", at("x.png")}), empty);
  EXPECT_FALSE(fs::exists(at("map.png")) || fs::exists(at("x.png")));
}

TEST_F(CommandLine, RenderLooksFromThePlacedCameras) {
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

TEST_F(CommandLine, LabelsAreWrittenByNumberAndName) {
  const std::vector<std::string> phantom{"--phantom", "torso", "--phantom-voxels", "48"};
  const auto convert = [&](std::vector<std::string> more) {
    std::vector<std::string> all{"convert"};
    all.insert(all.end(), phantom.begin(), phantom.end());
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  };
  EXPECT_EQ(convert({"-o", at("volume.nrrd")}).exitCode, 0);
  EXPECT_EQ(convert({"--focus-labels", "left kidney,right kidney", "-o", at("kidneys.nrrd")}).exitCode, 0);
  EXPECT_NE(contents(at("kidneys.nrrd")).find("Segment1_Name:=left kidney"), std::string::npos);
  EXPECT_EQ(contents(at("kidneys.nrrd")).find("Segment2_"), std::string::npos);
  // The whole label map, because a .dcm is a segmentation; back as labels of the volume, and out again.
  EXPECT_EQ(convert({"-o", at("all.dcm")}).exitCode, 0);
  const Result again = run({"convert", at("volume.nrrd"), "--labels", at("all.dcm"), "--focus-labels", "left kidney",
                            "-o", at("left.nii.gz")});
  EXPECT_EQ(again.exitCode, 0) << again.error;
  EXPECT_EQ(again.error, "");
  expectFailure(run({"convert", at("volume.nrrd"), "-o", at("x.dcm")}), at("volume.nrrd"));
  expectFailure(convert({"--focus-labels", "aorta", "-o", at("x.png")}), at("x.png"));
  EXPECT_EQ(run({"convert", at("volume.nrrd"), "--focus-labels", "3", "-o", at("x.nrrd")}).exitCode, 2);
}

TEST_F(CommandLine, ASurfaceIsWrittenAndMeasured) {
  const std::vector<std::string> scene{"surface", "--phantom",      "torso",       "--phantom-voxels",
                                       "64",      "--focus-labels", "left kidney", "-o"};
  std::vector<double> volumes;
  for (const char* name : {"a.stl", "a.ply", "a.obj"}) {
    std::vector<std::string> all = scene;
    all.insert(all.end(), {at(name), "--frame", "ras"});
    const Result result = run(all);
    ASSERT_EQ(result.exitCode, 0) << result.error;
    volumes.push_back(result.json().at("volume_ml"));
    EXPECT_EQ(result.json().at("frame"), "ras");
    EXPECT_GT(fs::file_size(at(name)), 1000u);
  }
  // A kidney has some 150 ml.
  EXPECT_GT(volumes[0], 50.0);
  EXPECT_LT(volumes[0], 400.0);
  EXPECT_EQ(volumes[0], volumes[1]);
  std::vector<std::string> all = scene;
  all.push_back(at("a.vtk"));
  expectFailure(run(all), at("a.vtk"));
  EXPECT_EQ(run({"surface", "--phantom", "torso"}).exitCode, 2);
}

}  // namespace
}  // namespace fenestra
