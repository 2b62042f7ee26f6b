// fenestra-cli slice in any direction, as slabs, and facing a camera: values and places against their own computation.

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <sstream>

#include <glm/glm.hpp>

#include "tests/cli/CommandLine.h"

namespace fenestra::tests::sliceCommandTest {
namespace {

glm::dvec3 vectorOf(const Json& json) { return {json[0], json[1], json[2]}; }

/// A MetaImage as its format says, read without the project.
struct MetaFile {
  std::map<std::string, std::vector<double>> numbers;
  std::string type;
  std::vector<float> values;

  explicit MetaFile(const std::string& file) {
    const std::string bytes = contents(file);
    std::size_t at = 0;
    for (bool isHeader = true; isHeader && at < bytes.size();) {
      const std::size_t end = bytes.find('\n', at);
      const std::string line = bytes.substr(at, end - at);
      at = end + 1;
      const std::string key = line.substr(0, line.find(" = ")), value = line.substr(line.find(" = ") + 3);
      if (key == "ElementType") type = value;
      std::istringstream stream(value);
      for (double number; stream >> number;) numbers[key].push_back(number);
      isHeader = key != "ElementDataFile";
    }
    values.resize((bytes.size() - at) / sizeof(float));
    std::memcpy(values.data(), bytes.data() + at, values.size() * sizeof(float));
  }
  glm::dvec3 vector(const std::string& key, std::size_t first = 0) const {
    const std::vector<double>& list = numbers.at(key);
    return {list.at(first), list.at(first + 1), list.at(first + 2)};
  }
  /// Where a pixel lies, LPS.
  glm::dvec3 place(int i, int j) const {
    const glm::dvec3 spacing = vector("ElementSpacing");
    return vector("Offset") + i * spacing.x * vector("TransformMatrix") + j * spacing.y * vector("TransformMatrix", 3);
  }
  int width() const { return static_cast<int>(numbers.at("DimSize")[0]); }
  int height() const { return static_cast<int>(numbers.at("DimSize")[1]); }
  float value(int i, int j) const { return values[static_cast<std::size_t>(j * width() + i)]; }
};

class SliceCommand : public CommandLine {
 protected:
  /// A ramp: 20 + 3·L - 2·P + 5·S at its voxels, which are 1 × 1.5 × 2 mm and begin at 0.
  std::string ramp() const {
    std::string header =
        "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = False\n"
        "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\nElementSpacing = 1 1.5 2\nDimSize = 40 30 25\n"
        "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
    for (int z = 0; z < 25; ++z)
      for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
          const auto value = static_cast<float>(rampAt({x, 1.5 * y, 2.0 * z}));
          header.append(reinterpret_cast<const char*>(&value), sizeof(value));
        }
    write(at("ramp.mha"), header);
    return at("ramp.mha");
  }
  static double rampAt(glm::dvec3 p) { return 20.0 + 3.0 * p.x - 2.0 * p.y + 5.0 * p.z; }
  static bool isWellInside(glm::dvec3 p) {
    return p.x > 0.0 && p.y > 0.0 && p.z > 0.0 && p.x < 39.0 && p.y < 43.5 && p.z < 48.0;
  }
  Result slice(std::vector<std::string> more) const {
    more.insert(more.begin(), "slice");
    return run(more);
  }
};

TEST_F(SliceCommand, AnObliqueSliceHoldsTheValuesAtItsPlaces) {
  const Result result = slice({ramp(), "--normal", "1,2,3", "--through", "20,21,24", "--spacing", "0.7", "--size",
                               "51x41", "-o", at("slice.mha")});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Json json = result.json();
  const MetaFile file(at("slice.mha"));
  EXPECT_EQ(file.type, "MET_FLOAT");
  EXPECT_EQ(file.width(), 51);
  EXPECT_EQ(file.height(), 41);
  EXPECT_EQ(json["plane"], "oblique");
  EXPECT_EQ(json["interpolation"], "trilinear");
  EXPECT_EQ(json["slab"], nullptr);
  EXPECT_NEAR(json["pixel_spacing"][0], 0.7, 1e-12);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, 3));
  EXPECT_NEAR(std::abs(glm::dot(vectorOf(json["normal"]), normal)), 1.0, 1e-12);
  EXPECT_LT(glm::distance(vectorOf(json["centre"]), glm::dvec3(20, 21, 24)), 1e-9);
  // The nearest plane is axial: posterior stays down, left to the right.
  EXPECT_GT(json["down"][1], 0.7);
  EXPECT_GT(json["right"][0], 0.7);
  int inside = 0;
  for (int j = 0; j < file.height(); ++j)
    for (int i = 0; i < file.width(); ++i) {
      const glm::dvec3 place = file.place(i, j);
      EXPECT_NEAR(glm::dot(place - glm::dvec3(20, 21, 24), normal), 0.0, 1e-9);
      if (!isWellInside(place)) continue;
      ++inside;
      // Trilinear interpolation is exact for a ramp; values up to 400 have 24 bits.
      EXPECT_NEAR(file.value(i, j), rampAt(place), 1e-3);
    }
  EXPECT_GT(inside, 1000);
  // The middle pixel is the point.
  EXPECT_NEAR(file.value(25, 20), rampAt({20, 21, 24}), 1e-3);
}

TEST_F(SliceCommand, TheNormalsSignAndLengthHaveNoEffect) {
  const std::string volume = ramp();
  ASSERT_EQ(slice({volume, "--normal", "0.1,1,0.2", "-o", at("a.mha")}).exitCode, 0);
  ASSERT_EQ(slice({volume, "--normal", "-5,-50,-10", "-o", at("b.mha")}).exitCode, 0);
  EXPECT_EQ(contents(at("a.mha")), contents(at("b.mha")));
}

TEST_F(SliceCommand, OutsideTheVolumeIsNoNumberAndBlack) {
  const std::string volume = ramp();
  const std::vector<std::string> where{volume, "--normal", "1,0,1", "--through", "1,20,20", "--size", "60x60"};
  std::vector<std::string> asValues = where;
  asValues.insert(asValues.end(), {"-o", at("a.mha")});
  ASSERT_EQ(slice(asValues).exitCode, 0);
  const MetaFile file(at("a.mha"));
  EXPECT_TRUE(std::isnan(file.value(0, 0)));
  EXPECT_FALSE(std::isnan(file.value(30, 30)));
}

TEST_F(SliceCommand, SlabsAreMaximumMinimumAndMeanAlongTheNormal) {
  const std::string volume = ramp();
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 2, 3));
  const double perMm = std::abs(3.0 * normal.x - 2.0 * normal.y + 5.0 * normal.z);
  for (const auto& [mode, sign] : std::map<std::string, double>{{"max", 1.0}, {"min", -1.0}, {"mean", 0.0}}) {
    const Result result = slice({volume, "--normal", "1,2,3", "--through", "20,21,24", "--size", "9x9", "--slab",
                                 "8:" + mode, "-o", at("slab.mha")});
    ASSERT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.json()["slab"]["mm"], 8.0);
    EXPECT_EQ(result.json()["slab"]["mode"], mode);
    const MetaFile file(at("slab.mha"));
    for (int j = 0; j < 9; ++j)
      for (int i = 0; i < 9; ++i) EXPECT_NEAR(file.value(i, j), rampAt(file.place(i, j)) + sign * 4.0 * perMm, 1e-3);
  }
  // With the volume's own planes, too: 5 a mm along S.
  ASSERT_EQ(slice({volume, "--plane", "axial", "--index", "12", "--slab", "6:max", "-o", at("own.mha")}).exitCode, 0);
  const MetaFile own(at("own.mha"));
  EXPECT_EQ(own.width(), 40);
  EXPECT_NEAR(own.value(7, 9), rampAt({7.0, 13.5, 24.0}) + 15.0, 1e-3);
}

TEST_F(SliceCommand, OwnPlanesKeepTheirPixelsUnlessASizeIsNamed) {
  const std::string volume = ramp();
  const Result own = slice({volume, "--plane", "sagittal", "--index", "3", "-o", at("own.mha")});
  ASSERT_EQ(own.exitCode, 0) << own.error;
  EXPECT_EQ(own.json()["interpolation"], "none");
  EXPECT_EQ(own.json()["slice"], 3);
  const MetaFile file(at("own.mha"));
  EXPECT_EQ(file.width(), 30);
  EXPECT_EQ(file.height(), 25);
  EXPECT_EQ(file.place(0, 0), glm::dvec3(3.0, 0.0, 48.0));
  EXPECT_NEAR(file.value(4, 5), rampAt(file.place(4, 5)), 1e-3);
  const Result square =
      slice({volume, "--plane", "sagittal", "--index", "3", "--spacing", "0.5", "-o", at("fine.mha")});
  ASSERT_EQ(square.exitCode, 0) << square.error;
  EXPECT_EQ(square.json()["plane"], "sagittal");
  const MetaFile fine(at("fine.mha"));
  // 45 mm and 50 mm, with a pixel's centre in the middle: half a pixel more at either end.
  EXPECT_EQ(fine.width(), 91);
  EXPECT_EQ(fine.height(), 101);
  for (const glm::ivec2 at : {glm::ivec2(40, 50), glm::ivec2(20, 33)}) {
    EXPECT_NEAR(fine.place(at.x, at.y).x, 3.0, 1e-9);
    EXPECT_NEAR(fine.value(at.x, at.y), rampAt(fine.place(at.x, at.y)), 1e-3);
  }
}

TEST_F(SliceCommand, Thorough_FacesThePlacedCamera) {
  const std::vector<std::string> scene{"--phantom", "torso", "--phantom-voxels", "48"};
  std::vector<std::string> placing = scene, facing = scene;
  placing.insert(placing.begin(), "place");
  const Json placed = run(placing).json();
  for (const std::string camera : {"C1", "C2"}) {
    facing.resize(scene.size());
    facing.insert(facing.end(), {"--facing", camera, "-o", at("facing.png")});
    const Result result = slice(facing);
    ASSERT_EQ(result.exitCode, 0) << result.error;
    const Json json = result.json(), eye = placed[camera == "C1" ? "c1" : "c2"]["camera"];
    EXPECT_EQ(json["facing"], camera);
    const glm::dvec3 forward = glm::normalize(vectorOf(eye["target"]) - vectorOf(eye["eye"]));
    EXPECT_NEAR(glm::dot(vectorOf(json["normal"]), forward), 1.0, 1e-9);
    EXPECT_NEAR(glm::dot(vectorOf(json["down"]), vectorOf(eye["up"])), -1.0, 1e-9);
    EXPECT_NEAR(glm::dot(vectorOf(json["right"]), glm::cross(forward, vectorOf(eye["up"]))), 1.0, 1e-9);
  }
}

TEST_F(SliceCommand, FacesTheCameraOfASession) {
  ASSERT_EQ(run({"render", "--phantom", "torso", "--phantom-voxels", "48", "--camera", "30,20", "--size", "64x64",
                 "--save-session", at("a.fenestra"), "-o", at("a.png")})
                .exitCode,
            0);
  const Result result = slice({at("a.fenestra"), "--facing", "C1", "--through", "5,3,1", "--size", "33x33", "--spacing",
                               "2", "-o", at("facing.png")});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const double azimuth = glm::radians(30.0), elevation = glm::radians(20.0);
  // Azimuth 0 looks from anterior, 90 from the left.
  const glm::dvec3 towardsEye(std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation),
                              std::sin(elevation));
  EXPECT_NEAR(glm::dot(vectorOf(result.json()["normal"]), towardsEye), -1.0, 1e-6);
  EXPECT_LT(glm::distance(vectorOf(result.json()["centre"]), glm::dvec3(5, 3, 1)), 1e-9);
}

TEST_F(SliceCommand, MistakesNameTheirWayOut) {
  const std::string volume = ramp();
  const auto mistake = [&](std::vector<std::string> more, const std::string& says, int code = 2) {
    more.insert(more.begin(), volume);
    more.insert(more.end(), {"-o", at("x.png")});
    const Result result = slice(more);
    EXPECT_EQ(result.exitCode, code) << result.error;
    EXPECT_NE(result.error.find(says), std::string::npos) << result.error;
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
    EXPECT_FALSE(fs::exists(at("x.png")));
  };
  mistake({"--normal", "0,0,0"}, "is no direction");
  mistake({"--normal", "1,nan,0"}, "--normal");
  mistake({"--normal", "1,1,0", "--plane", "axial"}, "--plane");
  mistake({"--normal", "1,1,0", "--index", "3"}, "--index");
  mistake({"--normal", "1,1,0", "--size", "0x10"}, "--size");
  mistake({"--normal", "1,1,0", "--size", "99999x10"}, "--size");
  mistake({"--normal", "1,1,0", "--spacing", "-1"}, "above 0");
  mistake({"--normal", "1,1,0", "--spacing", "0"}, "above 0");
  mistake({"--slab", "-3:max"}, "0 or more");
  mistake({"--slab", "3:most"}, "none of max, min and mean");
  mistake({"--slab", "3"}, "MM:max|min|mean");
  mistake({"--facing", "C3"}, "--facing");
  mistake({"--normal", "1,1,0", "--through", "500,0,0"}, "name one within the volume by --through", 1);
  mistake({"--normal", "1,1,0", "--spacing", "0.0001"}, "--spacing", 1);
  mistake({"--facing", "C1"}, "--focus-labels", 1);
}

}  // namespace
}  // namespace fenestra::tests::sliceCommandTest
