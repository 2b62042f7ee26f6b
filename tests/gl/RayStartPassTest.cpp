// Stage 4 alone, against the reference: hits, distances and edits at random, with every width that decides.

#include "rendering/passes/RayStartPass.h"

#include "rendering/passes/DistanceMapPass.h"
#include "tests/gl/PassTest.h"

namespace fenestra::tests::rayStartPassTest {
namespace {

constexpr double openWidth = 9.0;

/// All input of the pass, and the same values for the reference.
struct MadeStart {
  Grid grid = obliqueGrid({24, 18, 14});
  Camera camera;
  glm::ivec2 size;
  RayFrame rays;
  MadeHits hits;
  std::vector<float> filled, distances;
  std::vector<glm::vec2> edits;

  MadeStart(glm::ivec2 pictureSize, Where focus, Projection projection = Projection::Perspective)
      : camera(Camera::fromAngles(33.0, 21.0, grid, projection)),
        size(pictureSize),
        rays(camera, size, grid),
        hits(madeHits(camera, size, grid, focus)) {
    std::mt19937 random(23);
    const auto share = [&] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
    for (std::size_t i = 0; i < hits.texels.size(); ++i) {
      // From before the box to behind it.
      filled.push_back(static_cast<float>(glm::mix(-60.0, 60.0, share())));
      const double which = share(), distance = which < 0.1 ? openWidth : which < 0.2 ? 0.0 : 2.0 * openWidth * share();
      distances.push_back(share() < 0.2 ? DistanceMapPass::beyond : static_cast<float>(distance));
      edits.emplace_back(share() < 0.3 ? 0.0 : glm::mix(-50.0, 50.0, share()), share());
    }
  }

  /// The pass's picture, drawn as a whole; parts must give the same.
  std::vector<float> starts(Schedule schedule, double width, bool edited) const {
    const gl::Texture hitImage = imageOf(hits.texels, size), filledImage = imageOf(filled, size),
                      distanceImage = imageOf(distances, size), editImage = imageOf(edits, size);
    RayStartPass pass;
    const auto run = [&](const std::vector<gl::Region>& regions, gl::Texture& image) {
      runWhole(pass, schedule, rays, RayStartPass::Inputs{hitImage, filledImage, distanceImage, width},
               edited ? &editImage : nullptr, regions, image);
    };
    gl::Texture image = blank<float>(size);
    run(whole(size), image);
    const std::vector<float> all = texelsOf<float>(image);
    expectPartsMakeTheWhole(all, size, run);
    expectOnlyTheRegionIsWritten(all, size, run);
    return all;
  }

  reference::Image truth(double width, bool edited) const {
    reference::Image start = reference::rayStart(hits.truth, timesOf(filled, rays),
                                                 reference::Image(distances.begin(), distances.end()), width);
    for (std::size_t i = 0; edited && i < start.size(); ++i) {
      const double context = hits.truth.tContext[i], focus = hits.truth.tFocus[i];
      const double farthest = std::isnan(focus) ? hits.truth.tOut[i] : focus;
      start[i] = std::clamp(start[i] + static_cast<double>(edits[i].x), context, std::max(context, farthest));
    }
    return start;
  }
};

void expectStartsMatch(const MadeStart& made, double width, bool edited) {
  const reference::Image truth = made.truth(width, edited);
  for (const Schedule schedule : schedules) {
    SCOPED_TRACE(named(schedule, made.size) + ", width " + std::to_string(width));
    const std::vector<float> starts = made.starts(schedule, width, edited);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      if (std::isnan(truth[i])) {
        EXPECT_EQ(starts[i], nothing) << "pixel " << i;
      } else {
        // A few roundings to float32 of positions within 100 mm, and of where the ray leaves the box.
        EXPECT_NEAR(timeOf(starts[i], made.rays), truth[i], 1e-4) << "pixel " << i;
      }
    }
  }
}

using RayStartPassTest = GlTest;

TEST_F(RayStartPassTest, PicturesOfAnySize) {
  for (const glm::ivec2 size : awkwardSizes)
    for (const bool edited : {false, true}) {
      expectStartsMatch(MadeStart(size, Where::Somewhere), openWidth, edited);
      expectStartsMatch(MadeStart(size, Where::Somewhere, Projection::Orthographic), openWidth, edited);
    }
}

TEST_F(RayStartPassTest, FocusNowhereAndEverywhere) {
  for (const Where focus : {Where::Nowhere, Where::Everywhere})
    for (const bool edited : {false, true}) expectStartsMatch(MadeStart({33, 17}, focus), openWidth, edited);
}

TEST_F(RayStartPassTest, WithoutAWidthRaysStartAtTheirHits) {
  const MadeStart made({33, 17}, Where::Somewhere);
  expectStartsMatch(made, 0.0, false);
  for (const Schedule schedule : schedules) {
    const std::vector<float> starts = made.starts(schedule, 0.0, false);
    for (std::size_t i = 0; i < starts.size(); ++i) {
      const glm::vec2 hit = made.hits.texels[i];
      // The ray leaves the box where float32 has it; hits nearer to there than it can tell are cut off.
      if (isSomething(hit.y) && timeOf(hit.y, made.rays) > made.hits.truth.tOut[i] - 1e-3) continue;
      EXPECT_EQ(starts[i], isSomething(hit.y) ? hit.y : hit.x) << "pixel " << i;
    }
  }
}

TEST_F(RayStartPassTest, RaysThatMeetNothingStartNowhere) {
  MadeStart made({33, 17}, Where::Nowhere);
  for (glm::vec2& hit : made.hits.texels) hit = glm::vec2(nothing);
  for (const Schedule schedule : schedules)
    for (const bool edited : {false, true})
      for (const float start : made.starts(schedule, openWidth, edited)) EXPECT_EQ(start, nothing);
}

}  // namespace
}  // namespace fenestra::tests::rayStartPassTest
