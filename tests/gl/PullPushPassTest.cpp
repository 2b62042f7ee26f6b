// Stage 2 alone, against the reference: pictures of any size with no, one, some and all pixels known.

#include "rendering/passes/PullPushPass.h"

#include "tests/gl/PassTest.h"

namespace fenestra::tests::pullPushPassTest {
namespace {

constexpr float greatest = 150.0f;  // mm from the rays' anchor

/// The share of pixels that meets the focus, at positions on both sides of the anchor; the context hits are no matter.
std::vector<glm::vec2> hitsOf(glm::ivec2 size, double known, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> position(-greatest, greatest);
  std::bernoulli_distribution isKnown(known), hasContext(0.5);
  std::vector<glm::vec2> hits;
  for (std::size_t i = 0; i < pixelsIn(size); ++i) {
    const float s = position(random);
    hits.emplace_back(hasContext(random) ? position(random) : nothing, isKnown(random) ? s : nothing);
  }
  return hits;
}

reference::Image imageOfFocus(const std::vector<glm::vec2>& hits) {
  reference::Image image;
  for (const glm::vec2 hit : hits) image.push_back(isSomething(hit.y) ? static_cast<double>(hit.y) : nan);
  return image;
}

std::vector<float> filledBy(PullPushPass& pass, Schedule schedule, const std::vector<glm::vec2>& hits,
                            glm::ivec2 size) {
  gl::Texture filled = blank<float>(size);
  const gl::Texture image = imageOf(hits, size);
  runWhole(pass, schedule, image, filled);
  gl::Texture tiled = blank<float>(size);
  runInTiles(pass, schedule, image, tiled);
  EXPECT_TRUE(sameBits(texelsOf<float>(tiled), texelsOf<float>(filled))) << "in tiles";
  return texelsOf<float>(filled);
}

void expectFilled(PullPushPass& pass, Schedule schedule, const std::vector<glm::vec2>& hits, glm::ivec2 size) {
  SCOPED_TRACE(named(schedule, size));
  const reference::Image truth = reference::fill(imageOfFocus(hits), size);
  const std::vector<float> filled = filledBy(pass, schedule, hits, size);
  // At most ten roundings to float32 a level, up and down together, and seven levels at most.
  const double tolerance = 70.0 * 6e-8 * greatest;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (isSomething(hits[i].y)) {
      EXPECT_EQ(filled[i], hits[i].y) << "known pixel " << i;
    } else {
      EXPECT_NEAR(filled[i], truth[i], tolerance) << "pixel " << i;
    }
  }
}

using PullPushPassTest = GlTest;

TEST_F(PullPushPassTest, FillsPicturesOfAnySize) {
  // One pass for all, so that each size finds the pyramid of another one.
  PullPushPass pass;
  for (const glm::ivec2 size : awkwardSizes)
    for (const double known : {0.02, 0.4, 1.0}) {
      std::vector<glm::vec2> hits = hitsOf(size, known, 3);
      hits.back().y = -7.5f;  // one is known at least
      for (const Schedule schedule : schedules) expectFilled(pass, schedule, hits, size);
    }
}

TEST_F(PullPushPassTest, OneKnownPixelFillsThePicture) {
  PullPushPass pass;
  for (const glm::ivec2 size : awkwardSizes)
    for (const glm::ivec2 at : {glm::ivec2(0), size / 2, size - 1})
      for (const Schedule schedule : schedules) {
        SCOPED_TRACE(named(schedule, size));
        std::vector<glm::vec2> hits(pixelsIn(size), glm::vec2(3.0f, nothing));
        hits[offsetOf(at, size)].y = 42.0f;
        // The weights of every level add up to one, exactly.
        for (const float value : filledBy(pass, schedule, hits, size)) EXPECT_EQ(value, 42.0f);
      }
}

TEST_F(PullPushPassTest, WithNothingKnownThereIsNothing) {
  PullPushPass pass;
  for (const glm::ivec2 size : awkwardSizes)
    for (const Schedule schedule : schedules) {
      SCOPED_TRACE(named(schedule, size));
      const std::vector<glm::vec2> hits(pixelsIn(size), glm::vec2(3.0f, nothing));
      for (const float value : filledBy(pass, schedule, hits, size)) EXPECT_FALSE(isSomething(value)) << value;
    }
}

TEST_F(PullPushPassTest, KeepsBothPyramidsUntilReleased) {
  PullPushPass pass;
  EXPECT_EQ(pass.bytes(), 0u);
  constexpr glm::ivec2 size{33, 17};
  filledBy(pass, Schedule::Plain, hitsOf(size, 0.5, 1), size);
  // 17×9, 9×5, 5×3, 3×2, 2×1 and 1×1 floats, twice.
  EXPECT_EQ(pass.bytes(), 2u * 4u * (153u + 45u + 15u + 6u + 2u + 1u));
  pass.release();
  EXPECT_EQ(pass.bytes(), 0u);
  expectFilled(pass, Schedule::Plain, hitsOf(size, 0.5, 2), size);
}

}  // namespace
}  // namespace fenestra::tests::pullPushPassTest
