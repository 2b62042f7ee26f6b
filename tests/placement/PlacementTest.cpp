// Regions, choices and searches on made-up descriptors: no OpenGL.

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "rendering/viewpoints/Choice.h"
#include "rendering/viewpoints/Refinement.h"
#include "rendering/viewpoints/Sphere.h"
#include "tests/support/Scenes.h"

namespace fenestra::placement::placementTest {
namespace {

using tests::randomUnit;

constexpr std::size_t points = 200;

/// Candidates over the sphere that all see the focus; their quality is `location` alone.
template <class F>
std::vector<Candidate> candidatesOf(int nside, F&& location) {
  std::vector<Candidate> candidates;
  for (const glm::dvec3 direction : ringDirections(nside)) {
    Candidate candidate;
    candidate.direction = direction;
    candidate.sums.count = 1.0;
    candidate.descriptors.location = location(direction);
    candidate.seen.assign((points + 63) / 64, 0);
    candidates.push_back(candidate);
  }
  return candidates;
}

Options locationOnly(Region region = Region::SemiSphere) {
  Options options;
  options.weights = {.visibility = 0.0, .coverage = 0.0, .location = 1.0, .orientation = 0.0, .endFace = 0.0};
  options.region = region;
  return options;
}

void seeRandomly(std::vector<Candidate>& candidates, std::mt19937& random) {
  std::bernoulli_distribution coin(0.3);
  for (Candidate& candidate : candidates)
    for (std::size_t o = 0; o < points; ++o)
      if (coin(random)) candidate.seen[o / 64] |= std::uint64_t{1} << (o % 64);
}

void seeEverything(std::vector<Candidate>& candidates) {
  for (Candidate& candidate : candidates)
    for (std::size_t o = 0; o < points; ++o) candidate.seen[o / 64] |= std::uint64_t{1} << (o % 64);
}

TEST(Placement, DescribesAnImage) {
  // Four pixels of an image of 10², at (0.1, 0.3) on average and at a depth of 0.25.
  const ImageSums sums{4.0, 1.0, {0.4, 1.2}, {5, 3, 6, 4}, 3.0};
  const Descriptors d = describe(sums, 10, {0.6, 0.0, 0.8});
  EXPECT_DOUBLE_EQ(d.visibility, 0.25);
  EXPECT_DOUBLE_EQ(d.coverage, 0.04);
  EXPECT_DOUBLE_EQ(d.location, 1.0 - std::sqrt(0.1) / std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(d.orientation, 0.8);
  EXPECT_DOUBLE_EQ(d.endFace, 0.75);
  const Descriptors unseen = describe({}, 10, {1.0, 0.0, 0.0});
  EXPECT_EQ(unseen.visibility + unseen.coverage + unseen.location, 0.0);
}

TEST(Placement, StreamIsTheBandAroundTheOrthogonalCircle) {
  std::mt19937 random(3);
  for (const double delta : {0.0, 5.0, 15.0, 90.0}) {
    Options options = locationOnly(Region::Stream);
    options.streamHalfWidth = delta;
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 a = randomUnit(random), b = randomUnit(random);
      const double offOrthogonal = std::abs(90.0 - glm::degrees(std::acos(glm::dot(a, b))));
      EXPECT_EQ(inRegion(a, b, options), offOrthogonal <= std::min(delta, 30.0)) << delta;
      EXPECT_EQ(inRegion(a, b, options), inRegion(b, a, options));
    }
  }
}

TEST(Placement, SemiSphereIsTheRightHalfBetween60And120Degrees) {
  const Options options = locationOnly();
  const glm::dvec3 anterior(0, -1, 0), left(1, 0, 0), superior(0, 0, 1);
  EXPECT_TRUE(inRegion(anterior, left, options));
  EXPECT_FALSE(inRegion(anterior, -left, options));
  EXPECT_TRUE(inRegion(anterior, superior, options));
  EXPECT_FALSE(inRegion(anterior, anterior, options));
  EXPECT_FALSE(inRegion(anterior, -anterior, options));
  std::mt19937 random(4);
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 a = randomUnit(random), b = randomUnit(random);
    const double angle = glm::degrees(std::acos(glm::dot(a, b)));
    const bool differ = angle >= 60.0 && angle <= 120.0;
    EXPECT_EQ(inRegion(a, b, options), differ && glm::dot(b, axesAt(a).right) >= 0.0);
    // One of two directions is to the right of the other, or nearly so where the way up changes.
    if (!differ) {
      EXPECT_FALSE(inRegion(a, b, options) || inRegion(b, a, options));
    }
  }
}

TEST(Placement, AxesAreDefinedEverywhere) {
  for (const glm::dvec3 direction : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0)}) {
    const Camera::Axes axes = axesAt(direction);
    EXPECT_LT(glm::length(axes.forward + direction), 1e-12);
    EXPECT_LT(glm::length(glm::cross(axes.right, axes.up) + axes.forward), 1e-12);
  }
}

TEST(Placement, TiesGoToTheLowestIndex) {
  std::vector<Candidate> candidates = candidatesOf(3, [](glm::dvec3) { return 0.5; });
  candidates[0].sums.count = 0.0;  // does not see the focus
  for (const Region region : {Region::Stream, Region::SemiSphere}) {
    const Options options = locationOnly(region);
    ASSERT_EQ(bestView(candidates, options), std::size_t{1});
    const glm::dvec3 c1 = candidates[1].direction;
    std::size_t first = 1;
    while (!inRegion(c1, candidates[first].direction, options)) ++first;
    EXPECT_EQ(dualView(candidates, c1, options), first);
  }
}

TEST(Placement, OfEquallyGoodViewsTheNearestToAStandardViewIsTaken) {
  std::vector<Candidate> candidates = candidatesOf(3, [](glm::dvec3) { return 0.5; });
  seeEverything(candidates);
  for (Candidate& candidate : candidates) candidate.descriptors = describe(candidate.sums, 10, candidate.direction);
  const auto orientation = [&](std::size_t i) { return candidates[i].descriptors.orientation; };
  double greatest = 0.0;
  for (std::size_t i = 0; i < candidates.size(); ++i) greatest = std::max(greatest, orientation(i));
  const Options options;
  EXPECT_EQ(orientation(bestView(candidates, options).value()), greatest);
  const Pair pair = jointSearch(candidates, points, options).value();
  EXPECT_EQ(orientation(pair.c1), greatest);
  EXPECT_EQ(orientation(pair.c2), greatest);
}

TEST(Placement, AViewThroughAnEndOfTheScanIsAvoided) {
  std::vector<Candidate> candidates = candidatesOf(4, [](glm::dvec3 d) { return 0.6 + 0.2 * d.z; });
  std::mt19937 random(9);
  seeRandomly(candidates, random);
  for (Candidate& candidate : candidates) candidate.descriptors.endFace = candidate.direction.z > 0.5 ? 1.0 : 0.0;
  Options options = locationOnly();
  EXPECT_GT(candidates[bestView(candidates, options).value()].direction.z, 0.5);
  options.weights.endFace = -1.0;
  options.shareWeight = 0.5;
  const std::size_t c1 = bestView(candidates, options).value();
  EXPECT_LE(candidates[c1].direction.z, 0.5);
  EXPECT_LE(candidates[dualView(candidates, candidates[c1].direction, options).value()].direction.z, 0.5);
  const Pair pair = jointSearch(candidates, points, options).value();
  EXPECT_LE(std::max(candidates[pair.c1].direction.z, candidates[pair.c2].direction.z), 0.5);
}

TEST(Placement, BestAndDualAreTheMaximaOfTheirRegions) {
  std::mt19937 random(5);
  for (const Region region : {Region::Stream, Region::SemiSphere}) {
    const Options options = locationOnly(region);
    for (int round = 0; round < 20; ++round) {
      std::uniform_real_distribution<double> uniform(0.0, 1.0);
      const std::vector<Candidate> candidates = candidatesOf(4, [&](glm::dvec3) { return uniform(random); });
      const std::size_t c1 = bestView(candidates, options).value();
      const std::size_t c2 = dualView(candidates, candidates[c1].direction, options).value();
      EXPECT_TRUE(inRegion(candidates[c1].direction, candidates[c2].direction, options));
      for (const Candidate& candidate : candidates) {
        EXPECT_LE(candidate.descriptors.location, candidates[c1].descriptors.location);
        if (inRegion(candidates[c1].direction, candidate.direction, options)) {
          EXPECT_LE(candidate.descriptors.location, candidates[c2].descriptors.location);
        }
      }
    }
  }
}

TEST(Placement, ShareCountsThePointsOfEither) {
  std::vector<Candidate> candidates = candidatesOf(1, [](glm::dvec3) { return 0.0; });
  candidates[0].seen = {0b1011, 0, 0, 0};
  candidates[1].seen = {0b0110, 0, 0, std::uint64_t{1} << 7};
  EXPECT_DOUBLE_EQ(seenShare(candidates[0], candidates[1], points), 5.0 / points);
  EXPECT_DOUBLE_EQ(seenShare(candidates[0], candidates[0], points), 3.0 / points);
  EXPECT_EQ(seenShare(candidates[0], candidates[1], 0), 0.0);
}

TEST(Placement, JointSearchFindsWhatTryingEveryPairFinds) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const Region region : {Region::Stream, Region::SemiSphere})
    for (const double shareWeight : {1.0, 0.5, 0.0}) {
      Options options = locationOnly(region);
      options.shareWeight = shareWeight;
      std::vector<Candidate> candidates = candidatesOf(3, [&](glm::dvec3) { return uniform(random); });
      seeRandomly(candidates, random);
      candidates[7].sums.count = 0.0;
      candidates[7].seen.assign(candidates[7].seen.size(), ~std::uint64_t{0});
      const auto valueOf = [&](const Candidate& a, const Candidate& b) {
        return shareWeight * seenShare(a, b, points) +
               (1.0 - shareWeight) * 0.5 * (a.descriptors.location + b.descriptors.location);
      };
      // The definition: among the pairs within 0.01 of the greatest value, the one that looks through least.
      const auto farness = [](const Candidate& candidate) {
        return candidate.descriptors.visibility - 0.1 * candidate.descriptors.orientation;
      };
      const auto pairFarness = [&](const Candidate& c1, const Candidate& c2) {
        return 0.8 * farness(c1) + 0.2 * farness(c2);
      };
      double greatest = -1.0, least = 1e9;
      const auto forEachPair = [&](const auto& visit) {
        for (const Candidate& a : candidates)
          for (const Candidate& b : candidates)
            if (&a != &b && a.sums.count > 0.0 && b.sums.count > 0.0 &&
                (inRegion(a.direction, b.direction, options) || inRegion(b.direction, a.direction, options)))
              visit(a, b);
      };
      forEachPair([&](const auto& a, const auto& b) { greatest = std::max(greatest, valueOf(a, b)); });
      forEachPair([&](const auto& a, const auto& b) {
        // The sum is taken in another order: one rounding.
        if (valueOf(a, b) >= greatest - 0.01 + 1e-15) least = std::min(least, pairFarness(a, b));
      });
      const Pair pair = jointSearch(candidates, points, options).value();
      const Candidate &c1 = candidates[pair.c1], &c2 = candidates[pair.c2];
      EXPECT_TRUE(inRegion(c1.direction, c2.direction, options) || inRegion(c2.direction, c1.direction, options));
      EXPECT_EQ(pair.share, seenShare(c1, c2, points));
      EXPECT_GE(valueOf(c1, c2), greatest - 0.01 - 1e-15);
      EXPECT_LE(pairFarness(c1, c2), least + 1e-15);
    }
}

TEST(Placement, TheNearerSideIsC1AndFarPairsGiveWayToEquallyGoodNearOnes) {
  // Opposite views see the same: only their depth tells them apart. The focus is near the left side.
  const glm::dvec3 left(1.0, 0.0, 0.0);
  for (const Region region : {Region::Stream, Region::SemiSphere}) {
    std::vector<Candidate> candidates = candidatesOf(4, [](glm::dvec3) { return 0.5; });
    seeEverything(candidates);
    for (Candidate& candidate : candidates)
      candidate.descriptors.visibility = 0.5 - 0.4 * glm::dot(candidate.direction, left);
    Options options;
    options.region = region;
    // Seen from the far left, it is worth less than a hundredth less.
    for (Candidate& candidate : candidates)
      if (glm::dot(candidate.direction, left) > 0.9) candidate.descriptors.location = 0.45;
    const Pair pair = jointSearch(candidates, points, options).value();
    EXPECT_GT(glm::dot(candidates[pair.c1].direction, left), 0.9);
    EXPECT_GE(glm::dot(candidates[pair.c2].direction, left), -1e-9);
    // A focus that is clearly better seen from the right is looked at from there.
    for (Candidate& candidate : candidates)
      if (glm::dot(candidate.direction, left) > 0.0) candidate.seen.assign(candidate.seen.size(), 0);
    const Pair far = jointSearch(candidates, points, options).value();
    EXPECT_LE(std::min(glm::dot(candidates[far.c1].direction, left), glm::dot(candidates[far.c2].direction, left)),
              0.0);
  }
}

TEST(Placement, ShareOfTheJointSearchIsNoHundredthBelowAnotherPairs) {
  std::mt19937 random(7);
  Measured measured;
  measured.candidates = candidatesOf(3, [&](glm::dvec3 d) { return 0.5 + 0.5 * d.x; });
  measured.spread = measured.candidates.size();
  measured.surfacePoints = points;
  for (const glm::dvec3 d : {glm::dvec3(0, -1, 0), glm::dvec3(0, 1, 0), glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0),
                             glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)}) {
    Candidate candidate = measured.candidates.front();
    candidate.direction = d;
    candidate.descriptors.orientation = 1.0;
    measured.candidates.push_back(candidate);
  }
  seeRandomly(measured.candidates, random);
  const Options semiSphere = locationOnly(), stream = locationOnly(Region::Stream);
  const double joint = choose(measured, semiSphere, true).share, jointStream = choose(measured, stream, true).share;
  // Pairs within a hundredth are equally good to the joint search.
  EXPECT_GE(joint, jointStream - 0.01);
  EXPECT_GE(joint, choose(measured, semiSphere, false).share - 0.01);
  EXPECT_GE(jointStream, choose(measured, stream, false).share - 0.01);
  EXPECT_GE(jointStream, bestStandardPair(measured.candidates, points).value().share - 0.01);
}

TEST(Placement, NothingToChooseFromIsSaid) {
  EXPECT_EQ(bestView({}, {}), std::nullopt);
  EXPECT_EQ(dualView({}, {1.0, 0.0, 0.0}, {}), std::nullopt);
  EXPECT_EQ(jointSearch({}, 0, {}), std::nullopt);
  EXPECT_EQ(bestStandardPair({}, 0), std::nullopt);
  const Placement none = choose({}, {}, true);
  EXPECT_FALSE(none.c1 || none.c2);
  EXPECT_FALSE(none.note.empty());

  Measured unseen;
  unseen.candidates = candidatesOf(2, [](glm::dvec3) { return 0.0; });
  for (Candidate& candidate : unseen.candidates) candidate.sums.count = 0.0;
  unseen.spread = unseen.candidates.size();
  EXPECT_FALSE(choose(unseen, {}, false).c1);
  EXPECT_FALSE(choose(unseen, {}, false).note.empty());
}

TEST(Placement, TheSameFromEverywhereIsSaid) {
  Measured measured;
  measured.candidates = candidatesOf(2, [](glm::dvec3) { return 0.5; });
  measured.spread = measured.candidates.size();
  measured.surfacePoints = points;
  const Placement same = choose(measured, locationOnly(), false);
  EXPECT_EQ(same.c1, std::size_t{0});
  EXPECT_TRUE(same.c2);
  EXPECT_NE(same.note, "");
  measured.candidates[5].descriptors.location = 0.9;
  EXPECT_EQ(choose(measured, locationOnly(), false).note, "");
}

TEST(Placement, DescriptorsOfTheSeenSurface) {
  // Two views that see halves, one that sees everything, one that sees nothing.
  std::vector<Candidate> candidates(4);
  for (std::size_t i = 0; i < 4; ++i) candidates[i].direction = ringDirections(1)[i];
  candidates[0].seen = {0x0000ffff};
  candidates[1].seen = {0xffff0000};
  candidates[2].seen = {0xffffffff};
  candidates[3].seen = {0};
  describeTogether(candidates, 32);
  EXPECT_DOUBLE_EQ(candidates[0].descriptors.entropy, std::log(16.0) / std::log(32.0));
  EXPECT_DOUBLE_EQ(candidates[2].descriptors.entropy, 1.0);
  EXPECT_EQ(candidates[3].descriptors.entropy, 0.0);
  // p(o) is the same for all points: the whole view tells nothing about the viewpoint, a half view the most.
  EXPECT_NEAR(candidates[2].descriptors.mutualInformation, 1.0, 1e-12);
  EXPECT_NEAR(candidates[0].descriptors.mutualInformation, 0.0, 1e-12);
  // Jensen–Shannon divergences of view 0: 1 to the other half and to nothing, and to the whole, of which it is half,
  // log₂ 2 - ¾ log₂ 3 + ½ log₂ 2 … = 1.5 - 0.75 log₂ 3.
  const double toWhole = 1.5 - 0.75 * std::log2(3.0);
  EXPECT_NEAR(candidates[0].descriptors.stability, 1.0 - (1.0 + toWhole + 1.0) / 3.0, 1e-12);
}

TEST(Placement, RefinementReachesTheFinestMaximumOfASmoothQuality) {
  std::mt19937 random(8);
  for (int round = 0; round < 20; ++round) {
    const glm::dvec3 peak = randomUnit(random), second = randomUnit(random);
    std::size_t images = 0;
    const auto evaluate = [&](const std::vector<glm::dvec3>& directions) {
      std::vector<Candidate> measured;
      for (const glm::dvec3 direction : directions) {
        Candidate candidate;
        candidate.direction = direction;
        candidate.sums.count = 1.0;
        const double a = glm::dot(direction, peak), b = glm::dot(direction, second);
        candidate.descriptors.location = 0.5 + 0.3 * std::exp(4.0 * (a - 1.0)) + 0.2 * std::exp(4.0 * (b - 1.0));
        measured.push_back(candidate);
      }
      images += directions.size();
      return measured;
    };
    std::vector<glm::dvec3> finest;
    for (int pixel = 0; pixel < 12 * 32 * 32; ++pixel) finest.push_back(nestedDirection(32, pixel));
    const std::vector<Candidate> brute = evaluate(finest);
    images = 0;
    const Options options = locationOnly(round % 2 == 0 ? Region::SemiSphere : Region::Stream);
    Refinement refinement(options);
    while (!refinement.wanted().empty()) refinement.add(evaluate(refinement.wanted()));
    EXPECT_LT(images, 300u);
    const std::vector<Candidate> all = refinement.candidates();
    EXPECT_EQ(all.size(), images);
    const std::vector<Candidate> refined(all.begin() + static_cast<std::ptrdiff_t>(refinement.coarser()), all.end());
    const glm::dvec3 c1 = brute[bestView(brute, options).value()].direction;
    const glm::dvec3 found = refined[bestView(refined, options).value()].direction;
    EXPECT_EQ(found, c1) << round;
    const auto qualityOf = [&](const std::vector<Candidate>& among) {
      return among[dualView(among, c1, options).value()].descriptors.location;
    };
    EXPECT_EQ(qualityOf(refined), qualityOf(brute)) << round;
  }
}

TEST(Placement, RefinementOfAnUnseenFocusEnds) {
  Refinement refinement({});
  std::vector<Candidate> unseen(refinement.wanted().size());
  EXPECT_EQ(unseen.size(), 48u);
  refinement.add(unseen);
  EXPECT_TRUE(refinement.wanted().empty());
  EXPECT_EQ(refinement.coarser(), 48u);
}

}  // namespace
}  // namespace fenestra::placement::placementTest
