// fenestra-cli grow and render --seed, as a script uses them.

#include <sys/wait.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/ImageWriter.h"
#include "io/LabelReader.h"
#include "io/PhantomFile.h"
#include "io/VolumeReader.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::growTest {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// In the left kidney of the phantom, and its label.
const std::string kidney = "78,44,-98";
constexpr std::uint16_t kidneyLabel = 20;

class Grow : public ::testing::Test {
 protected:
  /// `options` in the shell's own syntax, on a small phantom. The exit code; -1 when ended by a signal.
  int run(const std::string& command, const std::string& options) const {
    const std::string line = std::string(FENESTRA_CLI) + " " + command + " --phantom torso --phantom-voxels 120 " +
                             options + " >'" + at("out") + "' 2>'" + at("error") + "' </dev/null";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::string contents(const std::string& name) const {
    std::ifstream file(at(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  Json json() const { return Json::parse(contents("out"), nullptr, false); }
  /// Exit code 1 and one line on standard error.
  void expectFailure(const std::string& options, const std::string& cause) const {
    EXPECT_EQ(run("grow", options), 1);
    const std::string error = contents("error");
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
    EXPECT_NE(error.find("phantom torso: " + cause), std::string::npos) << error;
    EXPECT_FALSE(fs::exists(at("grown.nii.gz")));
  }
  std::string toFile() const { return " -o '" + at("grown.nii.gz") + "'"; }

 private:
  const fs::path folder_ = scratchFolder();
};

TEST_F(Grow, WritesTheStructureAsALabelMap) {
  ASSERT_EQ(run("grow", "--seed " + kidney + " -o '" + at("grown.nrrd") + "'"), 0) << contents("error");
  EXPECT_EQ(io::openLabels(at("grown.nrrd"), io::openPhantom("torso", 120).labels->grid).labels->labels.at(0).name,
            "region");
  ASSERT_EQ(run("grow", "--seed " + kidney + toFile()), 0) << contents("error");
  const io::OpenedPhantom phantom = io::openPhantom("torso", 120);
  const auto grown = io::openVolume(at("grown.nii.gz")).volume;
  const Grid& grid = phantom.labels->grid;
  ASSERT_EQ(grown->grid.dims, grid.dims);
  EXPECT_LT(glm::distance(grown->grid.origin, grid.origin), 1e-3);  // NIfTI-1 stores floats
  double both = 0.0, either = 0.0, voxels = 0.0;
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x) {
        const double value = grown->value({x, y, z});
        ASSERT_TRUE(value == 0.0 || value == 1.0);
        const double label = phantom.labels->value({x, y, z}) == kidneyLabel ? 1.0 : 0.0;
        both += value * label;
        either += value + label;
        voxels += value;
      }
  EXPECT_GT(2.0 * both / either, 0.9);  // at 4 mm a voxel much of the kidney is its border
  const Json result = json();
  EXPECT_EQ(result["voxels"], voxels);
  EXPECT_NEAR(result["volume_ml"].get<double>(), voxels * grid.voxelVolume() / 1000.0, 1e-6);
  EXPECT_EQ(result["automatic"], true);
  EXPECT_EQ(result["by"], "tissues");
  ASSERT_FALSE(result["plateaus"].empty());
  EXPECT_EQ(result["plateaus"][0]["tolerance"], result["tolerance"]);
  EXPECT_FALSE(result.contains("curve"));
}

TEST_F(Grow, GrowsWithTheTolerance) {
  double before = 0.0;
  for (const char* tolerance : {"20", "60", "120"}) {
    ASSERT_EQ(run("grow", "--curve --seed " + kidney + " --tolerance " + tolerance + toFile()), 0);
    const Json result = json();
    EXPECT_EQ(result["tolerance"], std::stod(tolerance));
    EXPECT_EQ(result["automatic"], false);
    EXPECT_GT(result["volume_ml"].get<double>(), before);
    before = result["volume_ml"].get<double>();
    const auto volumes = result["curve"]["volume_ml"].get<std::vector<double>>();
    EXPECT_EQ(volumes.size(), result["curve"]["tolerance"].size());
    EXPECT_TRUE(std::is_sorted(volumes.begin(), volumes.end()));
    EXPECT_NE(std::find(volumes.begin(), volumes.end(), before), volumes.end());
  }
}

TEST_F(Grow, AnOutsideSeedHoldsTheRegionBack) {
  // Far beyond the plateau, where the region is most of the body.
  const std::string seed = "--seed " + kidney + " --tolerance 300";
  ASSERT_EQ(run("grow", seed + toFile()), 0);
  const double all = json()["volume_ml"];
  EXPECT_EQ(json()["by"], "tissues");
  ASSERT_EQ(run("grow", "--by values " + seed + toFile()), 0) << contents("error");
  EXPECT_EQ(json()["by"], "values");
  ASSERT_EQ(run("grow", seed + " --outside 64,0,-24 --outside=-80,2,-34" + toFile()), 0) << contents("error");
  EXPECT_LT(json()["volume_ml"].get<double>(), 0.5 * all);
  EXPECT_EQ(json()["outside"].size(), 2u);
}

TEST_F(Grow, WarnsOfALargeShareOfTheBody) {
  ASSERT_EQ(run("grow", "--seed " + kidney + toFile()), 0);
  EXPECT_LT(json()["share_of_body"], 0.15);
  EXPECT_EQ(contents("error").find("of the body"), std::string::npos);
  ASSERT_EQ(run("grow", "--tolerance 2000 --seed " + kidney + toFile()), 0);
  EXPECT_GT(json()["share_of_body"], 0.15);
  EXPECT_NE(contents("error").find("% of the body"), std::string::npos) << contents("error");
  ASSERT_EQ(run("grow", "--tolerance 2000 --ball 30 --seed " + kidney + toFile()), 0);
  EXPECT_LT(json()["volume_ml"], 1.1 * 4.0 / 3.0 * 3.1416 * 27.0);
}

TEST_F(Grow, NamesWhatIsWrong) {
  expectFailure("--seed 1000,0,0" + toFile(), "does not reach to the seed 1000,0,0");
  expectFailure("--seed " + kidney + " --outside 0,0,-999" + toFile(), "does not reach to the point outside, 0,0,-999");
  for (const std::string& misuse : {"--seed 1,2" + toFile(), "--seed 1,2,x" + toFile(), toFile(),
                                    "--seed " + kidney + " --tolerance -1" + toFile(), "--seed " + kidney}) {
    EXPECT_EQ(run("grow", misuse), 2) << misuse;
    EXPECT_FALSE(fs::exists(at("grown.nii.gz")));
  }
}

TEST_F(Grow, Thorough_RenderOpensTheViewToTheRegion) {
  const std::string view = "--size 90x80 --camera P ";
  const auto hits = [&](const std::string& focus, const std::string& layers) {
    EXPECT_EQ(run("render", view + focus + " --layers '" + at(layers) + "' -o '" + at("picture.png") + "'"), 0)
        << contents("error");
    return io::readPicture(fs::path(at(layers)) / "t_focus.mha").values;
  };
  const std::vector<float> grown = hits("--seed " + kidney, "grown");
  const std::vector<float> labelled = hits("--focus-labels 20", "labelled");
  const auto hit = [](float t) { return std::isfinite(t); };
  double both = 0.0, either = 0.0;
  ASSERT_EQ(grown.size(), labelled.size());
  for (std::size_t i = 0; i < grown.size(); ++i) {
    both += hit(grown[i]) && hit(labelled[i]) ? 1.0 : 0.0;
    either += (hit(grown[i]) ? 1.0 : 0.0) + (hit(labelled[i]) ? 1.0 : 0.0);
  }
  EXPECT_GT(either, 0.0);
  EXPECT_GT(2.0 * both / either, 0.9);
  // The session keeps the seed, and gives the same picture.
  const std::string picture = " -o '" + at("picture.png") + "'";
  ASSERT_EQ(run("render", view + "--seed " + kidney + " --save-session '" + at("grown.fenestra") + "'" + picture), 0);
  const std::string seen = contents("picture.png");
  const std::string again = std::string(FENESTRA_CLI) + " render '" + at("grown.fenestra") + "'" + picture;
  ASSERT_EQ(std::system(again.c_str()), 0);
  EXPECT_EQ(contents("picture.png"), seen);
  EXPECT_EQ(run("render", view + "--seed " + kidney + " --focus-range 0:9 -o '" + at("no.png") + "'"), 2);
}

TEST_F(Grow, Thorough_SelectPaintsTheRegion) {
  const std::string view = "--size 90x80 --camera P --method selection ";
  const auto hits = [&](const std::string& focus, const std::string& layers) {
    EXPECT_EQ(run("render", view + focus + " --layers '" + at(layers) + "' -o '" + at("picture.png") + "'"), 0)
        << contents("error");
    return io::readPicture(fs::path(at(layers)) / "t_focus.mha").values;
  };
  const auto count = [](const std::vector<float>& values) {
    return std::count_if(values.begin(), values.end(), [](float t) { return std::isfinite(t); });
  };
  const auto one = count(hits("--select ball:0,0,0:40", "one"));
  EXPECT_GT(one, 100);
  const auto two = count(hits("--select ball:0,0,0:40 --select ball:90,0,0:20", "two"));
  EXPECT_GT(two, one);
  // A ball that is taken away leaves a hole through the other one.
  EXPECT_LT(count(hits("--select ball:0,0,0:40 --select=-ball:0,0,0:41 --select ball:90,0,0:20", "hole")),
            two - one + 9);
  EXPECT_NE(hits("--select ball:0,0,0:40:1", "soft"), hits("--select ball:0,0,0:40", "hard"));
  // The session keeps what was painted, and gives the same picture.
  const std::string picture = " -o '" + at("picture.png") + "'";
  ASSERT_EQ(
      run("render", view + "--select ball:0,0,0:40:0.5 --save-session '" + at("painted.fenestra") + "'" + picture), 0);
  const std::string seen = contents("picture.png");
  const std::string again = std::string(FENESTRA_CLI) + " render '" + at("painted.fenestra") + "'" + picture;
  ASSERT_EQ(std::system(again.c_str()), 0);
  EXPECT_EQ(contents("picture.png"), seen);
  for (const std::string misuse :
       {"ball:0,0,0", "ball:0,0:5", "ball:0,0,0:0", "ball:0,0,0:5:2", "box:0,0,0:5", "ball:0,0,0:nan"})
    EXPECT_EQ(run("render", view + "--select " + misuse + " -o '" + at("no.png") + "'"), 2) << misuse;
  EXPECT_EQ(run("render", view + "--select ball:0,0,0:40 --focus-range 0:9 -o '" + at("no.png") + "'"), 2);
  for (const auto& [wrong, message] :
       {std::pair("--select ball:9000,0,0:5", "has no voxel within the ball at 9000,0,0"),
        std::pair("--select=-ball:0,0,0:5", "has no voxel in what the balls select")}) {
    EXPECT_EQ(run("render", view + wrong + " -o '" + at("no.png") + "'"), 1) << wrong;
    EXPECT_NE(contents("error").find(message), std::string::npos) << contents("error");
  }
  EXPECT_FALSE(fs::exists(at("no.png")));
}

}  // namespace
}  // namespace fenestra::tests::growTest
