// Candidates as the GPU measures them, against a double-precision computation on the CPU.

#include "tests/placement/CandidateTesting.h"

namespace fenestra::placement::candidateImagesTest {
namespace {

TEST_F(CandidateTest, Thorough_LabelsAgreeWithTheCpuOnEveryKindOfGrid) {
  for (const Grid& grid : {gridOf({37, 31, 29}), gridOf({33, 29, 14}, {0.8, 1.1, 2.9}, {400.0, -3000.0, 7.0}),
                           obliqueGrid({31, 25, 17}), shearedGrid({31, 25, 17})}) {
    const Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
    expectSameAsOnCpu(scene, measure(scene, someDirections()));
  }
}

TEST_F(CandidateTest, Exhaustive_SmoothedLabelsAgreeWithTheCpu) {
  const Grid grid = obliqueGrid({31, 25, 17});
  Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
  scene.look.labelSmoothing = LabelSmoothing::Strong;
  // The CPU takes ten seconds for a view of smoothed labels, so one has to do.
  auto directions = someDirections();
  directions.resize(1);
  expectSameAsOnCpu(scene, measure(scene, directions));
}

TEST_F(CandidateTest, ValuesAgreeWithTheCpu) {
  const Grid grid = obliqueGrid({20, 17, 12});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> noise(0.0, 0.2);
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 index) { return lobes(grid, index) + noise(random); }, 0.55);
  const std::vector<glm::dvec3> all = someDirections();
  expectSameAsOnCpu(scene, measure(scene, {all[0], all[1], all.back()}));
}

TEST_F(CandidateTest, AFocusThatFillsTheVolumeAgreesWithTheCpu) {
  const Scene scene = labelScene(obliqueGrid({20, 17, 9}), [](glm::ivec3) { return 1; });
  const std::vector<Candidate> candidates = measure(scene, someDirections(), side, 500);
  expectSameAsOnCpu(scene, candidates);
  EXPECT_TRUE(surface().points.empty());
  Placer placer;
  const Placement placement = choose(placer.measure(gpu(), scene, {48}, {}), {}, true);
  EXPECT_TRUE(placement.c1 && placement.c2);
  EXPECT_EQ(placement.share, 0.0);
  EXPECT_NE(placement.note, "");
}

TEST_F(CandidateTest, AFocusAtTheBorderAgreesWithTheCpu) {
  const Scene scene =
      labelScene(gridOf({24, 20, 18}, {1.0, 1.2, 1.5}), [](glm::ivec3 i) { return i.x < 6 && i.y > 11 ? 1 : 0; });
  expectSameAsOnCpu(scene, measure(scene, someDirections()));
}

TEST_F(CandidateTest, AnEmptyFocusSeesNothingAndSaysSo) {
  const Scene scene = labelScene(gridOf({12, 12, 12}), [](glm::ivec3) { return 2; });
  for (const Candidate& candidate : measure(scene, someDirections(), side, 100)) {
    EXPECT_EQ(candidate.sums.count, 0.0);
    EXPECT_LT(candidate.sums.box.z, candidate.sums.box.x);
  }
  Placer placer;
  const Placement placement = choose(placer.measure(gpu(), scene, {}, {}), {}, false);
  EXPECT_FALSE(placement.c1 || placement.c2);
  EXPECT_NE(placement.note, "");
}

/// CandidateVisibility.comp in double precision: a point is seen when no focus lies between it, moved off its surface,
/// and the camera.
bool seesPoint(const Scene& scene, const FocusSurface& surface, std::size_t which, glm::dvec3 direction) {
  const Grid& grid = scene.volume->grid;
  const FocusSurface::Point& point = surface.points[which];
  const double slope = glm::dot(point.normal, direction);
  if (std::abs(slope) < 1e-5 ? which % 2 != 0 : slope < 0.0) return false;
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  double extent = 0.0;
  for (int axis = 0; axis < 3; ++axis) extent += std::abs(glm::dot(glm::dvec3(worldFromIndex[axis]), point.normal));
  const glm::dvec3 eye = glm::dvec3(worldFromIndex * glm::dvec4(point.index, 1.0)) +
                         extent * std::min(1.0 / std::abs(slope), 8.0) * direction;
  const Camera camera = lookAt(eye, eye + direction, Projection::Orthographic, 1.0);
  return std::isnan(reference::hitPoints(scene, camera, {1, 1}).tFocus.front());
}

TEST_F(CandidateTest, WhatIsSeenAndItsDescriptorsAgreeWithTheCpu) {
  const Grid grid = shearedGrid({31, 25, 17});
  const Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
  std::vector<Candidate> candidates = measure(scene, ringDirections(1), side, 150);
  const std::vector<FocusSurface::Point>& points = surface().points;
  describeTogether(candidates, points.size());

  const std::size_t n = candidates.size();
  std::vector<std::vector<double>> p(n, std::vector<double>(points.size(), 0.0));  // p(o|v)
  for (std::size_t v = 0; v < n; ++v) {
    double seen = 0.0;
    for (std::size_t o = 0; o < points.size(); ++o) {
      const bool sees = seesPoint(scene, surface(), o, candidates[v].direction);
      EXPECT_EQ(sees, (candidates[v].seen[o / 64] >> (o % 64) & 1u) != 0) << v << ' ' << o;
      p[v][o] = sees ? 1.0 : 0.0;
      seen += p[v][o];
    }
    for (double& share : p[v]) share /= seen;
  }
  const auto entropyOf = [](const std::vector<double>& distribution) {
    double bits = 0.0;
    for (const double share : distribution)
      if (share > 0.0) bits -= share * std::log2(share);
    return bits;
  };
  std::vector<double> mean(points.size(), 0.0), information(n, 0.0);
  for (const auto& distribution : p)
    for (std::size_t o = 0; o < mean.size(); ++o) mean[o] += distribution[o] / static_cast<double>(n);
  for (std::size_t v = 0; v < n; ++v)
    for (std::size_t o = 0; o < mean.size(); ++o)
      if (p[v][o] > 0.0) information[v] += p[v][o] * std::log2(p[v][o] / mean[o]);
  const double greatest = *std::max_element(information.begin(), information.end());
  for (std::size_t v = 0; v < n; ++v) {
    // The eight nearest; ties to the first.
    std::vector<std::size_t> nearest(n);
    std::iota(nearest.begin(), nearest.end(), std::size_t{0});
    std::stable_sort(nearest.begin(), nearest.end(), [&](std::size_t a, std::size_t b) {
      return glm::dot(candidates[a].direction, candidates[v].direction) >
             glm::dot(candidates[b].direction, candidates[v].direction);
    });
    double divergence = 0.0;
    for (std::size_t i = 1; i <= 8; ++i) {
      std::vector<double> middle(points.size());
      for (std::size_t o = 0; o < middle.size(); ++o) middle[o] = 0.5 * (p[v][o] + p[nearest[i]][o]);
      divergence += entropyOf(middle) - 0.5 * entropyOf(p[v]) - 0.5 * entropyOf(p[nearest[i]]);
    }
    const Descriptors& d = candidates[v].descriptors;
    const glm::dvec3 direction = candidates[v].direction;
    EXPECT_NEAR(d.entropy, entropyOf(p[v]) / std::log2(static_cast<double>(points.size())), 1e-4);
    EXPECT_NEAR(d.mutualInformation, 1.0 - information[v] / greatest, 1e-4);
    EXPECT_NEAR(d.stability, 1.0 - divergence / 8.0, 1e-4);
    EXPECT_NEAR(d.orientation, std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}), 1e-4);
  }
}

TEST_F(CandidateTest, ASymmetricFocusIsSaidToBe) {
  const Grid grid = gridOf({56, 56, 56});
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 i) { return 16.0 - glm::length(glm::dvec3(i) - 27.5); }, 0.0);
  Placer placer;
  gpu().update(scene);
  EXPECT_NE(choose(placer.measure(gpu(), scene, {}, {}), {}, false).note, "");
}

TEST_F(CandidateTest, TheSameCallTwiceGivesTheSameBits) {
  const Grid grid = obliqueGrid({40, 36, 30});
  const Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
  const auto bitsOf = [](const Measured& measured) {
    std::vector<std::uint64_t> bits;
    for (const Candidate& c : measured.candidates) {
      const double values[] = {c.sums.count,
                               c.sums.depth,
                               c.sums.position.x,
                               c.sums.position.y,
                               c.descriptors.visibility,
                               c.descriptors.coverage,
                               c.descriptors.location,
                               c.descriptors.entropy,
                               c.descriptors.mutualInformation,
                               c.descriptors.stability,
                               c.descriptors.orientation,
                               c.descriptors.endFace};
      for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
      for (int i = 0; i < 4; ++i) bits.push_back(static_cast<std::uint64_t>(c.sums.box[i]));
      bits.insert(bits.end(), c.seen.begin(), c.seen.end());
    }
    return bits;
  };
  for (const bool refined : {false, true}) {
    Placer first, second;
    Sampling sampling{.count = 48, .refined = refined, .side = 48, .surfacePoints = 256};
    GpuScene another;
    EXPECT_EQ(bitsOf(first.measure(gpu(), scene, sampling, {})), bitsOf(second.measure(another, scene, sampling, {})));
  }
}

TEST_F(CandidateTest, WhatWasMeasuredIsKept) {
  const Grid grid = gridOf({24, 24, 24});
  Scene scene = labelScene(grid, [&](glm::ivec3 index) { return lobes(grid, index); });
  Placer placer;
  Options options;
  const Candidate* kept = placer.measure(gpu(), scene, {}, options).candidates.data();
  options.weights.coverage = 3.0;
  options.region = Region::Stream;
  EXPECT_EQ(placer.measure(gpu(), scene, {}, options).candidates.data(), kept);
  EXPECT_EQ(placer.measure(gpu(), scene, {48}, options).spread, 48u);
  EXPECT_THROW(placer.measure(gpu(), scene, {100}, options), std::invalid_argument);
}

}  // namespace
}  // namespace fenestra::placement::candidateImagesTest
