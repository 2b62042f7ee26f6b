// Views that a person would not take, on made-up candidates: no OpenGL.

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "rendering/viewpoints/Choice.h"
#include "rendering/viewpoints/Refinement.h"
#include "rendering/viewpoints/Sphere.h"
#include "tests/support/Scenes.h"

namespace fenestra::placement::habitsTest {
namespace {

constexpr std::size_t points = 192;

/// A scan whose faces are cut by so much, in the order of ScanShape::faces.
ScanShape scanOf(const std::array<double, 6>& cuts) {
  ScanShape scan;
  for (std::size_t f = 0; f < 6; ++f) {
    scan.faces[f].normal[static_cast<int>(f % 3)] = f < 3 ? 1.0 : -1.0;
    scan.faces[f].cut = cuts[f];
  }
  return scan;
}
const ScanShape trunk = scanOf({0, 0, 1, 0, 0, 1});

/// Candidates and the standard views; `shows(direction)` is the share of the surface that a view sees, and its quality.
template <class F>
Measured measuredOf(const ScanShape& scan, const F& shows) {
  Measured measured;
  measured.scan = scan;
  measured.surfacePoints = points;
  std::vector<glm::dvec3> directions = ringDirections(4);
  measured.spread = directions.size();
  directions.insert(directions.end(), standardDirections().begin(), standardDirections().end());
  std::mt19937 random(3);
  for (const glm::dvec3 direction : directions) {
    Candidate candidate;
    candidate.direction = direction;
    candidate.sums.count = 1.0;
    candidate.descriptors = describe(candidate.sums, 10, direction);
    candidate.descriptors.location = shows(direction);
    candidate.descriptors.awkwardness = awkwardness(scan, direction);
    candidate.seen.assign(points / 64, 0);
    for (std::size_t o = 0; o < static_cast<std::size_t>(std::lround(shows(direction) * points)); ++o)
      candidate.seen[o / 64] |= std::uint64_t{1} << (o % 64);
    measured.candidates.push_back(candidate);
  }
  return measured;
}

struct Cameras {
  glm::dvec3 c1, c2;
};
Cameras placed(const Measured& measured, const Options& options, bool joint) {
  const Placement placement = choose(measured, options, joint);
  return {measured.candidates[placement.c1.value()].direction, measured.candidates[placement.c2.value()].direction};
}

Options byLocation() {
  Options options;
  options.weights = {.visibility = 0.0, .coverage = 0.0, .location = 1.0, .orientation = 0.0, .endFace = 0.0};
  return options;
}

TEST(Habits, ACutEndIsLeftToOthersThatShowTwoThirds) {
  Awkwardness end, side;
  end.throughCutEnd = 0.6;
  side.throughCutEnd = 0.4;
  CutEndRule rule{Habits{}};
  EXPECT_TRUE(rule.admits(end, 1.0)) << "there is no other";
  rule.add(side, 0.5);
  rule.add(end, 0.9);
  EXPECT_TRUE(rule.admits(side, 0.1));
  EXPECT_FALSE(rule.admits(end, 0.75));
  EXPECT_TRUE(rule.admits(end, 0.76));
  EXPECT_TRUE(CutEndRule(noHabits).admits(end, 0.75));
}

TEST(Habits, CostsAddUpAndCountHalfForTheCostlierView) {
  const ScanShape scan = scanOf({0, 0, 0.8, 0, 0, 0});
  const Awkwardness view = awkwardness(scan, {0.6, 0.0, 0.8});
  EXPECT_NEAR(view.throughCutEnd, 0.8 * 0.64, 1e-12);
  EXPECT_NEAR(view.lying, 0.64, 1e-12);
  EXPECT_EQ(view.edgeOn, 0.0);
  const double all = costOf(view, {});
  EXPECT_GT(all, 0.0);
  EXPECT_NEAR(costOf(view, {true, false, false, false}) + costOf(view, {false, true, false, false}), all, 1e-12);
  EXPECT_EQ(costOf(view, noHabits), 0.0);
  EXPECT_NEAR(costOfPair(0.2, 0.1), 0.2, 1e-12);
  EXPECT_EQ(costOfPair(0.1, 0.2), costOfPair(0.2, 0.1));
}

TEST(Habits, NoCameraLooksThroughACutEndWhileOthersShowTwoThirds) {
  const double limit = std::sqrt(0.5) + 1e-9;
  for (const bool joint : {false, true}) {
    // From above and below a half more shows than from around.
    const Measured measured = measuredOf(trunk, [](glm::dvec3 d) { return 0.4 + 0.19 * std::abs(d.z); });
    Options options = byLocation();
    options.habits = {true, false, false, false};
    const Cameras with = placed(measured, options, joint);
    EXPECT_LE(std::max(std::abs(with.c1.z), std::abs(with.c2.z)), limit);
    EXPECT_TRUE(inRegion(with.c1, with.c2, options) || inRegion(with.c2, with.c1, options));
    options.habits = noHabits;
    const Cameras without = placed(measured, options, joint);
    EXPECT_GT(std::max(std::abs(without.c1.z), std::abs(without.c2.z)), limit);
    // Where they show more than that, they are taken.
    const Measured hidden = measuredOf(trunk, [](glm::dvec3 d) { return std::abs(d.z) > 0.9 ? 0.9 : 0.2; });
    options.habits = {true, false, false, false};
    const Cameras through = placed(hidden, options, joint);
    EXPECT_GT(std::max(std::abs(through.c1.z), std::abs(through.c2.z)), limit);
  }
}

TEST(Habits, C2AvoidsCutEndsOfItsRegionWhereverC1IsTurned) {
  const Measured measured = measuredOf(trunk, [](glm::dvec3 d) { return 0.5 + 0.2 * std::abs(d.z); });
  Options options = byLocation();
  for (const glm::dvec3 c1 : ringDirections(2)) {
    const auto c2 = chooseDual(measured, c1, options).c2;
    ASSERT_TRUE(c2);
    EXPECT_LE(std::abs(measured.candidates[*c2].direction.z), std::sqrt(0.5) + 1e-9);
  }
}

TEST(Habits, WithEveryOtherSideCutBothCamerasKeepToTheFreeOne) {
  const ScanShape piece = scanOf({1, 1, 1, 1, 0, 1});
  const Measured measured = measuredOf(piece, [](glm::dvec3 d) { return 0.5 + 0.1 * d.y; });
  const Cameras joint = placed(measured, byLocation(), true);
  EXPECT_LT(joint.c1.y, -std::sqrt(0.5));
  EXPECT_LT(joint.c2.y, -std::sqrt(0.5));
  // After a C1 straight from the front, the region has no such view: C2 goes to the least cut.
  const Measured front = measuredOf(piece, [](glm::dvec3 d) { return d.y < -0.98 ? 0.9 : 0.5; });
  Options options = byLocation();
  options.habits.uprightFirst = false;
  const Cameras sequential = placed(front, options, false);
  EXPECT_LT(sequential.c1.y, -0.98);
  EXPECT_LT(sequential.c2.y, -0.3);
}

TEST(Habits, AtEqualWorthCamerasLookFromAroundThePatient) {
  const Measured measured = measuredOf(scanOf({}), [](glm::dvec3) { return 0.5; });
  Options options;  // the default weight of standard views prefers all six alike
  for (const bool joint : {false, true}) {
    options.habits = {false, true, false, false};
    const Cameras with = placed(measured, options, joint);
    EXPECT_EQ(with.c1.z, 0.0);
    EXPECT_EQ(with.c2.z, 0.0);
    // Slightly more from above is not worth it, twice as much is.
    const auto above = [&](double more) {
      return placed(measuredOf(scanOf({}), [=](glm::dvec3 d) { return 0.4 + more * (std::abs(d.z) > 0.9); }), options,
                    joint);
    };
    const Cameras slightly = above(0.01), clearly = above(0.55);
    EXPECT_LT(std::max(std::abs(slightly.c1.z), std::abs(slightly.c2.z)), 0.9);
    EXPECT_GT(std::max(std::abs(clearly.c1.z), std::abs(clearly.c2.z)), 0.9);
    options.habits = noHabits;
    const Cameras slightlyWithout = above(0.01);
    EXPECT_GT(std::max(std::abs(slightlyWithout.c1.z), std::abs(slightlyWithout.c2.z)), 0.9);
    // A user's own weight wins.
    options.habits = {};
    options.weights.endFace = 1.0;
    Measured wanted = measured;
    for (Candidate& candidate : wanted.candidates) candidate.descriptors.endFace = candidate.direction.z > 0.9;
    const Cameras byUser = placed(wanted, options, joint);
    EXPECT_GT(std::max(byUser.c1.z, byUser.c2.z), 0.9);
    options.weights.endFace = -1.0;
  }
}

TEST(Habits, AThinStackIsSeenFromItsFront) {
  // Edge-on, all of the surface shows: from the front, next to nothing.
  ScanShape stack = scanOf({});
  stack.stack.flatness = 1.0;
  for (const glm::dvec3 front : {glm::dvec3(0, 0, -1), glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0)}) {
    stack.stack.front = front;
    const Measured measured =
        measuredOf(stack, [&](glm::dvec3 d) { return 0.9 * (1.0 - std::abs(glm::dot(d, front))); });
    for (const bool joint : {false, true}) {
      Options options = byLocation();
      const Cameras with = placed(measured, options, joint);
      EXPECT_GT(glm::dot(with.c1, front), 0.9);
      EXPECT_GT(glm::dot(with.c2, front), 0.45) << "60° from C1 is the least";
      options.habits.flatFromFront = false;
      EXPECT_LT(glm::dot(placed(measured, options, joint).c1, front), 0.5);
    }
  }
}

TEST(Habits, SwitchedOffTheyLeaveThePlacementAsItWas) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int round = 0; round < 20; ++round) {
    ScanShape scan = scanOf({1, 0, 1, 0.5, 0, 0.7});
    scan.stack.flatness = 0.4;
    scan.stack.front = {0, -1, 0};
    Measured measured = measuredOf(scan, [&](glm::dvec3) { return uniform(random); });
    Measured unaware = measured;
    for (Candidate& candidate : unaware.candidates) candidate.descriptors.awkwardness = {};
    Options options;
    options.habits = noHabits;
    for (const bool joint : {false, true}) {
      const Placement with = choose(measured, options, joint), without = choose(unaware, options, joint);
      EXPECT_EQ(with.c1, without.c1);
      EXPECT_EQ(with.c2, without.c2);
      EXPECT_EQ(with.share, without.share);
      EXPECT_EQ(worth(measured.candidates[5].descriptors, options),
                quality(measured.candidates[5].descriptors, options.weights));
    }
  }
}

TEST(Habits, AtEqualWorthCamerasLookFromTheNearSide) {
  ScanShape scan = scanOf({});
  scan.offset = {0.0, -0.8, 0.0};  // a mandible: in front of the head's middle
  for (const bool joint : {false, true}) {
    Options options = byLocation();
    const auto fromBehind = [&](double more) {
      return placed(measuredOf(scan, [=](glm::dvec3 d) { return 0.4 + more * std::max(0.0, d.y); }), options, joint);
    };
    // Slightly more from behind is not worth it, much more is.
    options.habits = {false, false, false, true};
    const Cameras with = fromBehind(0.03), clearly = fromBehind(0.5);
    EXPECT_LT(std::max(with.c1.y, with.c2.y), 0.3);
    EXPECT_GT(std::max(clearly.c1.y, clearly.c2.y), 0.7);
    options.habits = noHabits;
    const Cameras without = fromBehind(0.03);
    EXPECT_GT(std::max(without.c1.y, without.c2.y), 0.7);
  }
}

TEST(Habits, RefinementFindsTheBestOfWhatTheyAdmit) {
  std::mt19937 random(8);
  for (int round = 0; round < 12; ++round) {
    const glm::dvec3 peak = tests::randomUnit(random), second = tests::randomUnit(random);
    const auto evaluate = [&](const std::vector<glm::dvec3>& directions) {
      std::vector<Candidate> measured;
      for (const glm::dvec3 direction : directions) {
        Candidate candidate;
        candidate.direction = direction;
        candidate.sums.count = 1.0;
        const double a = glm::dot(direction, peak), b = glm::dot(direction, second);
        candidate.descriptors.location = 0.5 + 0.3 * std::exp(4.0 * (a - 1.0)) + 0.2 * std::exp(4.0 * (b - 1.0));
        candidate.descriptors.awkwardness = awkwardness(trunk, direction);
        candidate.seen = {0xffff};
        measured.push_back(candidate);
      }
      return measured;
    };
    std::vector<glm::dvec3> finest;
    for (int pixel = 0; pixel < 12 * 32 * 32; ++pixel) finest.push_back(nestedDirection(32, pixel));
    const std::vector<Candidate> brute = evaluate(finest);
    const Options options = byLocation();
    Refinement refinement(options);
    while (!refinement.wanted().empty()) refinement.add(evaluate(refinement.wanted()));
    const std::vector<Candidate> all = refinement.candidates();
    const std::vector<Candidate> refined(all.begin() + static_cast<std::ptrdiff_t>(refinement.coarser()), all.end());
    const Candidate& c1 = brute[bestView(brute, options).value()];
    EXPECT_LE(std::abs(c1.direction.z), std::sqrt(0.5) + 1e-9);
    EXPECT_EQ(refined[bestView(refined, options).value()].direction, c1.direction) << round;
    const auto worthOfC2 = [&](const std::vector<Candidate>& among) {
      return worth(among[dualView(among, c1.direction, options).value()].descriptors, options);
    };
    EXPECT_NEAR(worthOfC2(refined), worthOfC2(brute), 1e-3) << round;
  }
}

}  // namespace
}  // namespace fenestra::placement::habitsTest
