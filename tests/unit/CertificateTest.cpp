// The statements that a sample of pixels proves about a picture.

#include <gtest/gtest.h>

#include "rendering/reference/Certificate.h"
#include "rendering/reference/Picture.h"
#include "tests/support/Scenes.h"

namespace fenestra::reference::certificateTest {
namespace {

using namespace tests;

/// Probability that at most `exceeding` of `pixels` exceed the bound where a share of 1 - `share` of all pixels does.
double probability(int pixels, int exceeding, double share) {
  double sum = 0.0;
  for (int k = 0; k <= exceeding; ++k)
    sum += std::exp(std::lgamma(pixels + 1.0) - std::lgamma(k + 1.0) - std::lgamma(pixels - k + 1.0) +
                    k * std::log1p(-share) + (pixels - k) * std::log(share));
  return sum;
}

TEST(Certificate, LeastShareIsTheLimitOfClopperAndPearson) {
  for (const int pixels : {1, 59, 3000, 10000}) {
    EXPECT_NEAR(leastShare(pixels, 0, 0.95), std::pow(0.05, 1.0 / pixels), 1e-12);
    EXPECT_EQ(leastShare(pixels, pixels, 0.95), 0.0);
    // At the limit, so few would exceed with a probability of 5 %.
    for (const int exceeding : {1, 4, 40}) {
      if (exceeding >= pixels) continue;
      EXPECT_NEAR(probability(pixels, exceeding, leastShare(pixels, exceeding, 0.95)), 0.05, 1e-9);
    }
  }
}

class CertificateOfAPicture : public ::testing::Test {
 protected:
  CertificateOfAPicture() {
    scene_.volume = volumeOf(gridOf({16, 16, 16}, glm::dvec3(1.0)), [](glm::ivec3 i) {
      return 100.0 * std::exp(-0.03 * glm::dot(glm::dvec3(i) - 7.5, glm::dvec3(i) - 7.5));
    });
    scene_.look.context.function = {
        {{20.0, {{0.9, 0.2, 0.1}, 0.0}}, {50.0, {{0.9, 0.2, 0.1}, 0.3}}, {100.0, {{0.1, 0.3, 0.8}, 1.0}}}};
    scene_.look.background = {0.2, 0.4, 0.6};
    const glm::dvec3 centre = scene_.volume->grid.centre();
    camera_ = lookAt(centre + glm::dvec3(-40.0, -60.0, 20.0), centre, Projection::Perspective, 30.0);
    for (const glm::dvec4& colour : picture(scene_, camera_, size_).final) exact_.emplace_back(colour);
  }
  Certificate certified(const std::vector<glm::vec4>& picture, CertificateOptions options) const {
    return certify(picture, scene_, {.camera = camera_, .size = size_}, options);
  }

  static constexpr glm::ivec2 size_{60, 50};
  Scene scene_;
  Camera camera_;
  std::vector<glm::vec4> exact_;
};

TEST_F(CertificateOfAPicture, AnExactPictureIsCertified) {
  const Certificate sample = certified(exact_, {.pixels = 2999, .within = 0.001});
  EXPECT_EQ(sample.exceeding, 0);
  EXPECT_EQ(sample.share, wantedShare);
  EXPECT_EQ(sample.confidence, 0.95);
  const Certificate all = certified(exact_, {});
  EXPECT_EQ(all.pixels, 3000);
  EXPECT_EQ(all.share, 1.0);
  EXPECT_EQ(all.confidence, 1.0);
  EXPECT_LE(all.within, 0.005);  // both references are within their tolerance of 1e-5, which is 0.0026/255
}

TEST_F(CertificateOfAPicture, AWrongPictureIsFoundOut) {
  std::vector<glm::vec4> wrong = exact_;
  for (std::size_t i = 0; i < wrong.size(); i += 5) wrong[i].g += 2.0f / 255.0f;
  const Certificate told = certified(wrong, {.pixels = 1000, .within = 1.0});
  EXPECT_NEAR(told.exceeding, 200, 40);  // three standard deviations
  EXPECT_LE(told.share, 0.8);
  EXPECT_GT(told.share, 0.75);
  const Certificate found = certified(wrong, {.pixels = 1000});
  EXPECT_NEAR(found.within, 2.0, 0.01);

  std::vector<glm::vec4> broken = exact_;
  broken[1234].r = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(certified(broken, {.within = 1.0}).exceeding, 1);
}

/// The stated share is too high for at most one sample in twenty, whatever the picture.
TEST_F(CertificateOfAPicture, StatementsAreTrueAsOftenAsTheySay) {
  std::vector<glm::vec4> wrong = exact_;
  std::size_t count = 0;
  for (std::size_t i = 0; i < wrong.size(); i += 101, ++count) wrong[i].b -= 3.0f / 255.0f;
  const double truth = 1.0 - static_cast<double>(count) / static_cast<double>(wrong.size());
  int isTrue = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed)
    isTrue += certified(wrong, {.pixels = 300, .seed = seed, .within = 1.0}).share <= truth ? 1 : 0;
  EXPECT_GE(isTrue, 950 - 21);  // three standard deviations of a binomial distribution
}

TEST_F(CertificateOfAPicture, IsSaidInOneSentence) {
  EXPECT_EQ(statementOf({.within = 1.0, .share = 0.999, .confidence = 0.95, .pixels = 10000, .seed = 7}),
            "at least 99.9 % of the pixels are within 1/255 of the exact picture, with 95 % confidence (0 of 10000 "
            "random pixels exceed it, seed 7)");
  EXPECT_EQ(statementOf({.within = 0.125, .share = 0.98767, .pixels = 300, .exceeding = 4}),
            "98.76 % of the pixels are within 0.125/255 of the exact picture (all 300 were measured)");
}

}  // namespace
}  // namespace fenestra::reference::certificateTest
