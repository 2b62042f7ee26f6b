// Views through the end of a scan, as the GPU measures them.

#include "tests/placement/CandidateTesting.h"

namespace fenestra::placement::candidateEndFacesTest {
namespace {

/// A body around the lobes that the scan cuts off below, and on one side; air has other values than tissue, in two
/// gaps.
Scene cutBody(const Grid& grid, Focus focus) {
  const auto inBody = [&](glm::ivec3 i) {
    const glm::dvec3 u = glm::dvec3(i) / glm::dvec3(grid.dims);
    return glm::length((u - glm::dvec3(0.5, 0.45, 0.3)) * glm::dvec3(1.0, 0.8, 0.6)) < 0.42;
  };
  Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
  const Scene values = valueScene(
      grid, [&](glm::ivec3 i) { return lobes(grid, i) ? 90.0
                                       : inBody(i)    ? 40.0 + (i.x + i.y) % 3
                                                      : -800.0; }, 0.0);
  scene.volume = values.volume;
  scene.look = values.look;
  scene.look.focus = std::move(focus);
  // From -200 on and not around 41: there are values that the context leaves out among its own.
  scene.look.context.function.nodes = {{-200.0, {{1, 1, 1}, 0.0}}, {-100.0, {{1, 1, 1}, 0.4}}};
  return scene;
}

TEST_F(CandidateTest, Exhaustive_EndFacesAgreeWithTheCpu) {
  std::vector<glm::dvec3> few = someDirections();
  few.resize(2);
  few.emplace_back(0.0, 0.0, -1.0);
  few.emplace_back(0.0, 0.0, 1.0);
  const std::pair<Grid, Focus> cases[] = {{gridOf({37, 31, 29}), LabelFocus{{1}}},
                                          {shearedGrid({31, 25, 17}), LabelFocus{{1}}},
                                          {obliqueGrid({15, 13, 10}), ValueFocus{{60.0, 1000.0}, 0.0}}};
  for (const auto& [grid, focus] : cases) {
    const Scene scene = cutBody(grid, focus);
    const std::vector<Candidate> candidates = measure(scene, few, side, 0, true);
    const std::vector<Candidate> without = measure(scene, few);
    double least = 1.0, greatest = 0.0;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const ImageSums truth = CpuImage(scene, candidates[i].direction, side).sums();
      const double endFace = candidates[i].descriptors.endFace;
      // A ray whose entry point has the value of the body's surface may fall to either side in float32: one pixel.
      EXPECT_NEAR(endFace, truth.ends / truth.count, 1e-4 + 1.0 / truth.count) << i;
      least = std::min(least, endFace);
      greatest = std::max(greatest, endFace);
      EXPECT_EQ(without[i].descriptors.endFace, 0.0);
      EXPECT_EQ(without[i].sums.count, candidates[i].sums.count) << "the rest is measured as before";
      EXPECT_EQ(without[i].sums.depth, candidates[i].sums.depth);
    }
    EXPECT_GT(greatest, least + 0.1) << "the views differ";
  }
}

TEST_F(CandidateTest, EndFacesOfACutCylinderInClosedForm) {
  // A body that fills the volume from bottom to top but not to the sides, its focus a small ball on the axis: views
  // from above and below come in through the ends, those from the sides do not.
  const Grid grid = gridOf({40, 40, 30});
  const auto fromAxis = [](glm::ivec3 i) { return glm::length(glm::dvec2(i.x, i.y) - 19.5); };
  Scene scene = valueScene(
      grid,
      [&](glm::ivec3 i) {
        return glm::length(glm::dvec3(i) - glm::dvec3(19.5, 19.5, 14.5)) < 3.0
                   ? 300.0
                   : 100.0 * std::clamp(14.0 - fromAxis(i), -1.0, 1.0);
      },
      250.0);
  scene.look.context.function.nodes = {{-1.0, {{1, 1, 1}, 0.0}}, {0.0, {{1, 1, 1}, 1.0}}, {1.0, {{1, 1, 1}, 1.0}}};
  for (const Candidate& candidate : measure(scene, ringDirections(4), side, 0, true)) {
    const double z = std::abs(candidate.direction.z), across = std::sqrt(1.0 - z * z);
    // A ray to the ball's centre passes the end at this distance from the axis; the ball has a radius of 3.
    const double distance = z > 0.0 ? 15.0 * across / z : 1e9;
    if (distance + 3.5 / z < 14.0) {
      EXPECT_NEAR(candidate.descriptors.endFace, 1.0, 1e-5);  // float32 sums
    } else if (distance - 3.5 / z > 14.0) {
      EXPECT_EQ(candidate.descriptors.endFace, 0.0);
    }
  }
}

TEST_F(CandidateTest, EndFacesAreMeasuredAgainOnlyWhenTheyChange) {
  const Grid grid = gridOf({37, 31, 29});
  Scene scene = cutBody(grid, LabelFocus{{1}});
  Placer placer;
  Options options, without;
  without.weights.endFace = 0.0;
  const auto measured = [&](const Options& with) { return placer.measure(gpu(), scene, {48}, with).candidates.data(); };
  const Candidate* kept = measured(options);
  EXPECT_EQ(measured(without), kept);
  scene.look.context.function.nodes[1].properties.colour = {1, 0, 0};
  EXPECT_EQ(measured(options), kept) << "a colour opens no end";
  const double before = placer.measured().candidates[0].descriptors.endFace;
  EXPECT_GT(before, 0.0);
  scene.look.context.function.nodes = {{2000.0, {{1, 1, 1}, 0.0}}, {2001.0, {{1, 1, 1}, 0.4}}};
  EXPECT_EQ(placer.measure(gpu(), scene, {48}, without).candidates[0].descriptors.endFace, before);
  EXPECT_LT(placer.measure(gpu(), scene, {48}, options).candidates[0].descriptors.endFace, before);
  placer.forget();
  placer.measure(gpu(), scene, {48}, without);
  scene.look.context.function.nodes[1].value = 2002.0;
  const Candidate* plain = measured(without);
  scene.look.context.function.nodes[1].value = 2003.0;
  EXPECT_EQ(measured(without), plain);
}

TEST_F(CandidateTest, Thorough_RefinementWithEndFacesFindsWhatAnExhaustiveSearchFinds) {
  const Grid grid = gridOf({37, 31, 29});
  const Scene scene = cutBody(grid, LabelFocus{{1}});
  const Options options;
  constexpr int finest = 16;
  measure(scene, {});
  const int pixels = CandidateImages::sideFor(gpu());
  const auto measured = [&](const std::vector<glm::dvec3>& directions) {
    return measure(scene, directions, pixels, 0, true);
  };
  Refinement refinement(options, 0, 2, finest);
  while (!refinement.wanted().empty()) refinement.add(measured(refinement.wanted()));
  const std::vector<Candidate> all = refinement.candidates();
  const std::vector<Candidate> found(all.begin() + static_cast<std::ptrdiff_t>(refinement.coarser()), all.end());
  std::vector<glm::dvec3> directions;
  for (int pixel = 0; pixel < 12 * finest * finest; ++pixel) directions.push_back(nestedDirection(finest, pixel));
  const std::vector<Candidate> brute = measured(directions);
  const Candidate& c1 = brute[bestView(brute, options).value()];
  EXPECT_EQ(found[bestView(found, options).value()].direction, c1.direction);
  EXPECT_EQ(found[dualView(found, c1.direction, options).value()].direction,
            brute[dualView(brute, c1.direction, options).value()].direction);
}

}  // namespace
}  // namespace fenestra::placement::candidateEndFacesTest
