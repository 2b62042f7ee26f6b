// Stage 3 alone, against the nearest of all pixels: pictures of any size, ranges around the words and tiles of 32
// pixels.

#include "rendering/passes/DistanceMapPass.h"

#include "tests/gl/PassTest.h"

namespace fenestra::tests::distanceMapPassTest {
namespace {

/// Which pixels meet the focus, row by row.
using Mask = std::vector<bool>;

/// As the pass reads it: the focus lies on both sides of the rays' anchor, and the context is no matter.
gl::Texture hitsOf(const Mask& mask, glm::ivec2 size) {
  std::vector<glm::vec2> hits;
  for (std::size_t i = 0; i < mask.size(); ++i)
    hits.emplace_back(i % 2 ? 1.0f : nothing, !mask[i] ? nothing : i % 3 ? 20.0f : -700.0f);
  return imageOf(hits, size);
}

/// Squared distance to the nearest pixel of the mask, of all of them; -1 with none.
std::vector<int> squaredDistances(const Mask& mask, glm::ivec2 size) {
  std::vector<glm::ivec2> known;
  for (std::size_t i = 0; i < mask.size(); ++i)
    if (mask[i]) known.push_back(pixelAt(i, size));
  std::vector<int> squared;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    int nearest = -1;
    for (const glm::ivec2 pixel : known) {
      const glm::ivec2 off = pixel - pixelAt(i, size);
      const int here = off.x * off.x + off.y * off.y;
      if (nearest < 0 || here < nearest) nearest = here;
    }
    squared.push_back(nearest);
  }
  return squared;
}

void expectDistances(DistanceMapPass& pass, const Mask& mask, glm::ivec2 size, const std::vector<int>& ranges) {
  const std::vector<int> squared = squaredDistances(mask, size);
  const gl::Texture hits = hitsOf(mask, size);
  for (const Schedule schedule : schedules)
    for (const int range : ranges) {
      SCOPED_TRACE(named(schedule, size) + ", range " + std::to_string(range));
      gl::Texture image = blank<float>(size);
      runWhole(pass, schedule, hits, range, image);
      const std::vector<float> distances = texelsOf<float>(image);
      gl::Texture tiled = blank<float>(size);
      runInTiles(pass, schedule, hits, range, tiled);
      EXPECT_TRUE(sameBits(texelsOf<float>(tiled), distances)) << "in tiles";
      for (std::size_t i = 0; i < mask.size(); ++i) {
        if (squared[i] < 0 || squared[i] > range * range) {
          EXPECT_EQ(distances[i], DistanceMapPass::beyond) << "pixel " << i;
        } else {
          // One rounding of the square root, which GLSL allows to be off by a few units of the last place.
          const double truth = std::sqrt(static_cast<double>(squared[i]));
          EXPECT_NEAR(distances[i], truth, truth * 4e-7) << "pixel " << i;
        }
      }
    }
}

Mask randomMask(glm::ivec2 size, double share) {
  std::mt19937 random(5);
  std::bernoulli_distribution isKnown(share);
  Mask mask(pixelsIn(size));
  for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = isKnown(random);
  return mask;
}

const std::vector<int> everyRange{0, 1, 5, 31, 32, 33, 64, 200};

using DistanceMapPassTest = GlTest;

TEST_F(DistanceMapPassTest, SparseAndDenseFocusInPicturesOfAnySize) {
  // One pass for all, so that each size finds the images of another one.
  DistanceMapPass pass;
  for (const glm::ivec2 size : awkwardSizes)
    for (const double share : {0.001, 0.02, 0.3}) expectDistances(pass, randomMask(size, share), size, everyRange);
}

TEST_F(DistanceMapPassTest, SinglePixelsAtBordersOfWordsAndTiles) {
  DistanceMapPass pass;
  constexpr glm::ivec2 size{101, 67};
  for (const int x : {0, 31, 32, 63, 64, 100})
    for (const int y : {0, 31, 32, 66}) {
      Mask mask(pixelsIn(size));
      mask[offsetOf({x, y}, size)] = true;
      expectDistances(pass, mask, size, {1, 32, 33, 64});
    }
}

TEST_F(DistanceMapPassTest, FocusNowhereAndEverywhere) {
  DistanceMapPass pass;
  for (const glm::ivec2 size : awkwardSizes) {
    expectDistances(pass, Mask(pixelsIn(size), false), size, {0, 32, 200});
    // Every pixel is its own nearest one; brute force would look at the square of their number.
    const Mask all(pixelsIn(size), true);
    const gl::Texture hits = hitsOf(all, size);
    for (const Schedule schedule : schedules)
      for (const int range : {0, 32}) {
        gl::Texture image = blank<float>(size);
        runWhole(pass, schedule, hits, range, image);
        for (const float distance : texelsOf<float>(image)) EXPECT_EQ(distance, 0.0f);
      }
  }
}

TEST_F(DistanceMapPassTest, ALongRow) {
  // Row distances need 16 bits, and their squares exceed the 24 bits that float32 holds exactly.
  DistanceMapPass pass;
  constexpr glm::ivec2 size{5000, 3};
  Mask mask(pixelsIn(size));
  mask[offsetOf({0, 2}, size)] = true;
  expectDistances(pass, mask, size, {4998, 8192});
}

TEST_F(DistanceMapPassTest, KeepsItsImagesUntilReleased) {
  DistanceMapPass pass;
  EXPECT_EQ(pass.bytes(), 0u);
  constexpr glm::ivec2 size{33, 17};
  const Mask mask = randomMask(size, 0.1);
  expectDistances(pass, mask, size, {8});
  // Words of 32 pixels, of which 2 would do, and a byte a tile, of which 2 × 1 would: 3 is the next number that is no
  // power of two. Two bytes a pixel.
  EXPECT_EQ(pass.bytes(), 4u * 3u * 17u + 3u * 3u + 2u * 33u * 17u);
  pass.release();
  EXPECT_EQ(pass.bytes(), 0u);
  expectDistances(pass, mask, size, {8});
}

}  // namespace
}  // namespace fenestra::tests::distanceMapPassTest
