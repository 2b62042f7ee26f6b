// Cones on the focus alone, against the reference's search of all pixels: hits at random in pictures of any size,
// focuses near and far from the eye, and more than one of the pyramid's top squares.

#include "rendering/passes/ConePass.h"

#include "tests/gl/PassTest.h"

namespace fenestra::tests::conePassTest {
namespace {

struct MadeCones {
  Grid grid = obliqueGrid({24, 18, 14});
  Camera camera;
  glm::ivec2 size;
  RayFrame rays;
  MadeHits hits;

  MadeCones(glm::ivec2 pictureSize, Where focus, Projection projection = Projection::Perspective, double zoom = 1.0)
      : camera(Camera::fromAngles(33.0, 21.0, grid, projection).zoomed(zoom)),
        size(pictureSize),
        rays(camera, size, grid),
        hits(madeHits(camera, size, grid, focus)) {}

  /// The pass's picture, drawn as a whole; parts must give the same.
  std::vector<float> starts(Schedule schedule, const ConePass::Cones& cones, const gl::Region& around) const {
    const gl::Texture hitImage = imageOf(hits.texels, size);
    ConePass pass;
    gl::Texture image = blank<float>(size), tiled = blank<float>(size);
    runWhole(pass, schedule, rays, hitImage, around, cones, image);
    runInTiles(pass, schedule, rays, hitImage, around, cones, tiled);
    EXPECT_TRUE(sameBits(texelsOf<float>(tiled), texelsOf<float>(image))) << "in tiles";
    return texelsOf<float>(image);
  }
  std::vector<float> starts(Schedule schedule, const ConePass::Cones& cones) const {
    return starts(schedule, cones, {glm::ivec2(0), size});
  }

  /// The box of pixels that meet the focus.
  gl::Region focusRegion() const {
    glm::ivec2 first = size, last(-1);
    for (std::size_t i = 0; i < hits.texels.size(); ++i)
      if (isSomething(hits.texels[i].y)) {
        first = glm::min(first, pixelAt(i, size));
        last = glm::max(last, pixelAt(i, size));
      }
    return {glm::min(first, size - 1), glm::max(last - first + 1, 0)};
  }
};

/// Returns how many rays start elsewhere than at their hits.
int expectConesMatch(const MadeCones& made, const ConePass::Cones& cones) {
  const reference::Image truth =
      reference::coneStart(made.hits.truth, made.camera, made.size, cones.slope, cones.onSilhouette);
  int opened = 0;
  for (const Schedule schedule : schedules) {
    SCOPED_TRACE(named(schedule, made.size) + ", slope " + std::to_string(cones.slope));
    const std::vector<float> starts = made.starts(schedule, cones);
    EXPECT_TRUE(sameBits(made.starts(schedule, cones, made.focusRegion()), starts)) << "around the focus alone";
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (std::isnan(truth[i])) {
        EXPECT_EQ(starts[i], nothing) << "pixel " << i;
        continue;
      }
      // A few roundings to float32 of positions within 100 mm: a ten thousandth of the finest voxel's 0.7 mm.
      EXPECT_NEAR(timeOf(starts[i], made.rays), truth[i], 1e-4) << "pixel " << i;
      opened += truth[i] > made.hits.truth.tContext[i] && std::isnan(made.hits.truth.tFocus[i]);
    }
  }
  return opened;
}

using ConePassTest = GlTest;

TEST_F(ConePassTest, Exhaustive_PicturesOfAnySize) {
  for (const glm::ivec2 size : awkwardSizes)
    for (const bool onSilhouette : {false, true})
      for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
        const MadeCones made(size, Where::Somewhere, projection);
        for (const double slope : {0.01, 0.3, 1.7, 60.0}) {
          const int opened = expectConesMatch(made, {slope, onSilhouette});
          if (size.x > 100 && slope < 1.0) {
            EXPECT_GT(opened, 200) << "there is something to compare";
          }
        }
      }
}

TEST_F(ConePassTest, Thorough_MoreThanOneTopSquare) {
  const MadeCones made({603, 290}, Where::Somewhere);
  EXPECT_GT(expectConesMatch(made, {0.6, false}), 2000);
  expectConesMatch(made, {1.7, true});
}

TEST_F(ConePassTest, TheEyeBesideTheVolume) {
  // Depths from near nothing on: the quotient of the perspective formula counts.
  expectConesMatch(MadeCones({101, 64}, Where::Somewhere, Projection::Perspective, 3.0), {0.5, false});
  expectConesMatch(MadeCones({101, 64}, Where::Somewhere, Projection::Perspective, 0.02), {0.5, false});
}

TEST_F(ConePassTest, FocusNowhereAndEverywhere) {
  for (const Where focus : {Where::Nowhere, Where::Everywhere})
    for (const bool onSilhouette : {false, true}) expectConesMatch(MadeCones({33, 17}, focus), {0.5, onSilhouette});
}

TEST_F(ConePassTest, WhereNoConeReachesRaysStartAtTheirHitsBitForBit) {
  const MadeCones made({101, 64}, Where::Somewhere);
  const ConePass::Cones steep{1e4, false};
  const reference::Image truth = reference::coneStart(made.hits.truth, made.camera, made.size, steep.slope, false);
  for (const Schedule schedule : schedules) {
    const std::vector<float> starts = made.starts(schedule, steep);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const glm::vec2 hit = made.hits.texels[i];
      // The ray leaves the box where float32 has it; hits nearer to there than it can tell are cut off.
      if (isSomething(hit.y) && timeOf(hit.y, made.rays) > made.hits.truth.tOut[i] - 1e-3) continue;
      if (!isSomething(hit.y) && truth[i] > made.hits.truth.tContext[i]) continue;
      EXPECT_EQ(starts[i], isSomething(hit.y) ? hit.y : hit.x) << "pixel " << i;
    }
  }
}

TEST_F(ConePassTest, KeepsItsPyramidUntilReleased) {
  const MadeCones made({33, 17}, Where::Somewhere);
  const gl::Texture hits = imageOf(made.hits.texels, made.size);
  gl::Texture image = blank<float>(made.size);
  ConePass pass;
  EXPECT_EQ(pass.bytes(), 0u);
  runWhole(pass, Schedule::Plain, made.rays, hits, gl::Region{{0, 0}, made.size}, ConePass::Cones{}, image);
  EXPECT_EQ(pass.bytes(), 4u * ((1 << 18) - 1) / 3);
  pass.release();
  EXPECT_EQ(pass.bytes(), 0u);
}

}  // namespace
}  // namespace fenestra::tests::conePassTest
