// fenestra-cli render --certify: its statements against whole reference pictures.

#include <cmath>

#include "io/ImageWriter.h"
#include "tests/cli/CommandLine.h"

namespace fenestra::tests::certifyTest {
namespace {

class Certify : public CommandLine {
 protected:
  /// A picture of a small phantom.
  Result render(const std::vector<std::string>& more) const {
    std::vector<std::string> all{"render", "--phantom", "torso", "--phantom-voxels", "64", "--size",
                                 "120x90", "--camera",  "30,20"};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }

  /// Share of the pixels of the renderer's finished layer in `folder` that are within `within`/255 of the reference's.
  double trueShare(const std::string& folder, double within) const {
    const io::Picture mine = io::readPicture(fs::path(at(folder)) / "final.mha");
    const io::Picture exact = io::readPicture(fs::path(at(folder + "-exact")) / "final.mha");
    std::size_t right = 0;
    for (std::size_t i = 0; i < mine.values.size(); i += 4) {
      float worst = 0.0f;
      for (std::size_t c = 0; c < 3; ++c) worst = std::max(worst, std::abs(mine.values[i + c] - exact.values[i + c]));
      right += 255.0f * worst <= static_cast<float>(within) + 1e-3f ? 1 : 0;  // the layers are in single precision
    }
    return static_cast<double>(right) / static_cast<double>(mine.values.size() / 4);
  }
};

TEST_F(Certify, Thorough_WhatItStatesIsTrueOfTheWholePicture) {
  int stated = 0, isTrue = 0;
  for (const std::string preset : {"ct-soft-tissue", "ct-bone"}) {
    ASSERT_EQ(render({"--transfer-function", preset, "--reference", "--layers", at(preset + "-exact")}).exitCode, 0);
    for (const std::vector<std::string>& quality :
         {std::vector<std::string>{"--quality", "draft"}, {"--quality", "normal"}, {"--max-error", "1"}}) {
      for (const std::string seed : {"1", "2"}) {
        std::vector<std::string> options{
            "--transfer-function", preset,     "--certify", "3000", "--certify-seed", seed, "-o",
            at("x.png"),           "--layers", at(preset)};
        options.insert(options.end(), quality.begin(), quality.end());
        const Result result = render(options);
        ASSERT_EQ(result.exitCode, 0) << result.error;
        const Json proof = result.json();
        ++stated;
        isTrue += trueShare(preset, proof.at("within")) >= proof.at("share").get<double>() ? 1 : 0;
        EXPECT_EQ(proof.at("pixels"), 3000);
        EXPECT_EQ(proof.at("seed"), std::stoi(seed));
        EXPECT_EQ(proof.at("confidence"), 0.95);
      }
    }
  }
  EXPECT_EQ(stated, 12);
  EXPECT_GE(isTrue, 11);  // each is true with a probability of 0.95 or more, and these seeds are fixed
}

TEST_F(Certify, AllPixelsOfASmallPictureAreMeasured) {
  ASSERT_EQ(render({"--reference", "--layers", at("a-exact")}).exitCode, 0);
  const Result result = render({"--certify", "20000", "--max-error", "0.5", "-o", at("x.png"), "--layers", at("a")});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Json proof = result.json();
  EXPECT_EQ(proof.at("pixels"), 120 * 90);
  EXPECT_EQ(proof.at("confidence"), 1.0);
  EXPECT_EQ(proof.at("within"), 0.5);
  EXPECT_NEAR(proof.at("share"), trueShare("a", 0.5), 0.5 / (120.0 * 90.0));
}

TEST_F(Certify, ThePictureCarriesItsProofAndNoPath) {
  const fs::path study = folder() / "Doe^Jane";
  fs::create_directories(study);
  const std::string volume = (study / "head.nii").string();
  ASSERT_EQ(run({"convert", "--phantom", "head", "--phantom-voxels", "32", "-o", volume}).exitCode, 0);
  const Result result =
      run({"render", volume, "--size", "60x50", "--certify", "-o", at("x.png"), "--save-session", at("s.fenestra")});
  ASSERT_EQ(result.exitCode, 0) << result.error;
  const Json proof = result.json();
  const std::string png = contents(at("x.png"));
  const std::string keyword = std::string("tEXtFenestra certificate") + '\0';
  const std::size_t begin = png.find(keyword);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t text = begin + keyword.size();
  EXPECT_EQ(Json::parse(png.substr(text, png.find('}', text) + 1 - text)), proof);
  EXPECT_EQ(png.find("Doe"), std::string::npos);
  EXPECT_EQ(proof.at("data"), Json::parse(contents(at("s.fenestra")))["volume"]["contents"]);
  EXPECT_EQ(proof.at("scene").get<std::string>().substr(0, 7), "sha256:");
  EXPECT_EQ(io::readPicture(at("x.png")).size, glm::ivec2(60, 50));

  // A copy at another path has the same certificate: only what is shown counts.
  const std::string moved = at("moved.nii");
  fs::copy(volume, moved);
  const Json again = run({"render", moved, "--size", "60x50", "--certify", "-o", at("y.png")}).json();
  EXPECT_EQ(again, proof);
  const Json other =
      run({"render", moved, "--size", "60x50", "--certify", "--camera", "10,0", "-o", at("y.png")}).json();
  EXPECT_NE(other.at("scene"), proof.at("scene"));
}

TEST_F(Certify, NeedsAPictureOfTheRenderer) {
  EXPECT_EQ(run({"render", "--phantom", "head", "--reference", "--certify", "-o", at("x.png")}).exitCode, 2);
  EXPECT_EQ(run({"render", "--phantom", "head", "--certify"}).exitCode, 2);
  EXPECT_EQ(run({"render", "--phantom", "head", "--certify", "0", "-o", at("x.png")}).exitCode, 2);
  EXPECT_TRUE(nothingLeftBehind());
}

}  // namespace
}  // namespace fenestra::tests::certifyTest
