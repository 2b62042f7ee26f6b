// Shared by all commands of fenestra-cli: usage, options, bad input and output.

#include <functional>

#include "rendering/settings/Settings.h"
#include "tests/cli/CommandLine.h"

namespace fenestra::tests::commandLineTest {
namespace {

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
      {"render", "--phantom", "head", "--method", "scissors", "-o", png},
      {"render", "--phantom", "head", "--importance-sparseness", "none", "-o", png},
      {"render", "--phantom", "head", "--background", "1,2,3", "-o", png},
      {"render", "--phantom", "head", "--backdrop", "ramp", "-o", png},
      {"render", "--phantom", "head", "--light-preset", "chalk", "-o", png},
      {"render", "--phantom", "head", "--label-smoothing", "2", "-o", png},
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
  check(Method{});
  forEachMethod([&]<class M>() { check(M{}); });
  check(Cutaway{});
  check(ContextLayer{});
  check(Shading{});
  check(ValueFocus{});
  check(Look{});
  EXPECT_EQ(options, 60);
  EXPECT_TRUE(nothingLeftBehind());
}

/// A file or folder that is no volume.
struct BadInput {
  std::string name;  ///< what it is, and the file's name
  std::string file;
  std::function<void(const fs::path&)> make;
};
void PrintTo(const BadInput& input, std::ostream* out) { *out << input.name; }

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

TEST_P(BrokenInput, Thorough_FailsWithOneClearLineAndNoOutput) {
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

}  // namespace
}  // namespace fenestra::tests::commandLineTest
