#include "rendering/segmentation/TissueTree.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "rendering/segmentation/Mask.h"
#include "rendering/segmentation/RegionGrowing.h"
#include "rendering/segmentation/TissueMerger.h"
#include "tests/support/Scenes.h"

namespace fenestra::segmentation::tissueTreeTest {
namespace {

using tests::gridOf;
using tests::volumeOf;

bool inBall(glm::ivec3 at, glm::dvec3 centre, double radius) { return glm::distance(glm::dvec3(at), centre) <= radius; }

template <class ValueAt>
std::shared_ptr<Volume> noisyVolume(const Grid& grid, double noise, ValueAt valueAt) {
  std::mt19937 random(5);
  std::normal_distribution<double> deviation(0.0, noise);
  return volumeOf<float>(grid, [&](glm::ivec3 at) { return valueAt(at) + deviation(random); });
}

/// The best Dice of the voxels that join at some level or before.
template <class InsideAt>
double bestDice(const std::vector<Level>& joins, const Grid& grid, InsideAt insideAt) {
  std::array<double, 256> all{}, right{};
  double size = 0.0;
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    const Level level = joins[grid.offset(at)];
    const double is = insideAt(at) ? 1.0 : 0.0;
    all[level] += 1.0;
    right[level] += is;
    size += is;
  });
  double best = 0.0, region = 0.0, both = 0.0;
  for (std::size_t level = 0; level < levelCount; ++level) {
    region += all[level];
    both += right[level];
    best = std::max(best, 2.0 * both / (region + size));
  }
  return best;
}

std::vector<Level> joinsFrom(const TissueTree& tree, const Volume& volume, glm::ivec3 seed) {
  return tree.joinsOf(volume, seed);
}

glm::dvec3 worldOf(const Grid& grid, glm::ivec3 index) {
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(glm::dvec3(index), 1.0));
}

// Two balls of one tissue that touch in a neck, in noise of a quarter of their contrast.
const glm::dvec3 left(16.0, 20.0, 20.0), right(42.0, 20.0, 20.0);
constexpr double radius = 13.5;
bool inLeft(glm::ivec3 at) { return inBall(at, left, radius); }
bool inEither(glm::ivec3 at) { return inLeft(at) || inBall(at, right, radius); }
std::shared_ptr<Volume> touchingBalls() {
  return noisyVolume(gridOf(glm::ivec3(59, 41, 41)), 12.0, [](glm::ivec3 at) { return inEither(at) ? 50.0 : 0.0; });
}

TEST(TissueMerger, MergesTwoTissuesAtTheCostOfTheirBorder) {
  const Tissue a{3000.0, 3000.0 * 2.0, 800.0}, b{500.0, 500.0 * 5.0, 400.0};
  // Means 2 and 5 and an edge of 4; 500 of 2000 mm³; a quarter of the surface of b.
  const auto tree = mergeTissues({{a, b}, {{0, 1, 100.0f, 400.0f}}}, {});
  ASSERT_TRUE(tree);
  EXPECT_EQ(tree->parents, (std::vector<std::uint32_t>{2, 2, UINT32_MAX}));
  EXPECT_NEAR(tree->heights[2], 7.0 * std::sqrt(500.0 / 2000.0) / std::pow(0.25, 0.35), 1e-5);
}

TEST(TissueMerger, AParentIsNoLowerThanItsChildren) {
  const auto volume = noisyVolume(gridOf(glm::ivec3(24, 20, 16)), 20.0, [](glm::ivec3 at) { return at.x * 5.0; });
  const TissueCells cells = tissueCells(*volume);
  const Basins basins = basinsOf(cells.tones, CellNeighbours(cells.grid));
  const auto tree = mergeTissues(tissuesOf(cells, basins), {});
  ASSERT_TRUE(tree);
  ASSERT_GT(basins.count, 20u);
  ASSERT_EQ(tree->parents.size(), 2u * basins.count - 1u);  // all are connected
  for (std::size_t node = 0; node + 1 < tree->parents.size(); ++node) {
    ASSERT_GT(tree->parents[node], node);
    ASSERT_GE(tree->heights[tree->parents[node]], tree->heights[node]);
  }
}

TEST(Basins, AFlatTissueIsOne) {
  const Grid grid = gridOf(glm::ivec3(41));
  const auto isIn = [](glm::ivec3 at, double within) { return inBall(at, glm::dvec3(20.0), within); };
  std::vector<float> tones(grid.voxelCount());
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) { tones[grid.offset(at)] = isIn(at, 15.0) ? 40.0f : 0.0f; });
  const Basins basins = basinsOf(tones, CellNeighbours(grid));
  // By index alone, the cells at the ball's lower left would each begin a basin.
  const std::uint32_t middle = basins.numbers[grid.offset(glm::ivec3(20))];
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    const std::uint32_t number = basins.numbers[grid.offset(at)];
    if (isIn(at, 13.0)) {
      ASSERT_EQ(number, middle);
    }
    if (!isIn(at, 17.0)) {
      ASSERT_EQ(number, basins.numbers.front());
    }
  });
}

TEST(TissueMerger, StopsWhenAsked) {
  const auto volume = noisyVolume(gridOf(glm::ivec3(64)), 20.0, [](glm::ivec3) { return 0.0; });
  EXPECT_EQ(TissueTree::build(*volume, [](double share) { return share < 0.3; }), nullptr);
  EXPECT_EQ(TissueTree::build(*volume, [](double share) { return share < 0.5; }), nullptr);
}

TEST(TissueTree, PartsBallsThatTouchInANeck) {
  const auto volume = touchingBalls();
  const auto tree = TissueTree::build(*volume);
  const std::vector<Level> joins = joinsFrom(*tree, *volume, glm::ivec3(left));
  EXPECT_GT(bestDice(joins, volume->grid, inLeft), 0.95);
  EXPECT_GT(bestDice(joins, volume->grid, inEither), 0.95);  // at a greater tolerance
}

TEST(TissueTree, SmallPocketsBelongToWhatEnclosesThem) {
  const glm::dvec3 centre(22.0);
  const auto shellAround = [&](double hollow) {
    return noisyVolume(gridOf(glm::ivec3(45)), 5.0, [&, hollow](glm::ivec3 at) {
      return inBall(at, centre, 15.0) && !inBall(at, centre, hollow) ? 200.0 : 0.0;
    });
  };
  const auto filled = [&](glm::ivec3 at) { return inBall(at, centre, 15.0); };
  const glm::ivec3 inShell(35, 22, 22);
  const auto marrow = shellAround(9.0);  // a fifth of the ball
  const auto bone = TissueTree::build(*marrow);
  EXPECT_GT(bestDice(joinsFrom(*bone, *marrow, inShell), marrow->grid, filled), 0.97);
  // From within, the pocket is a tissue of its own.
  const auto hollow = [&](glm::ivec3 at) { return inBall(at, centre, 9.0); };
  EXPECT_GT(bestDice(joinsFrom(*bone, *marrow, glm::ivec3(centre)), marrow->grid, hollow), 0.95);
  // What is larger than half of the wall is no pocket.
  const auto thin = shellAround(11.5);
  const auto wall = [&](glm::ivec3 at) { return filled(at) && !inBall(at, centre, 11.5); };
  const std::vector<Level> joins = joinsFrom(*TissueTree::build(*thin), *thin, inShell);
  EXPECT_GT(bestDice(joins, thin->grid, wall), 0.9);
}

TEST(TissueCells, ThickSlicesMakeNoCellCoarserThanItHasToBe) {
  const auto sizeIn = [](glm::ivec3 dims, glm::dvec3 spacing = {0.75, 0.75, 5.0}) {
    const auto slope = [](glm::ivec3 at) { return static_cast<double>(at.x); };
    return tissueCells(*volumeOf<std::int16_t>(gridOf(dims, spacing), slope)).size;
  };
  EXPECT_EQ(sizeIn(glm::ivec3(64, 60, 20)), glm::ivec3(1)) << "a cell a voxel";
  // 6.4 million voxels make 1.6 million cells of 1.5 mm, which is less than a slice is thick.
  EXPECT_EQ(sizeIn(glm::ivec3(400, 400, 40)), glm::ivec3(2, 2, 1));
  // The sides of a cell of 10 mm: along x, where there are two voxels, more of them than an int counts would fit.
  EXPECT_EQ(sizeIn(glm::ivec3(2, 2000, 1600), {1e-9, 5.0, 5.0}), glm::ivec3(2, 2, 2));
}

TEST(TissueTree, CellsOfSeveralVoxelsKeepTheVoxelsEdges) {
  const glm::dvec3 centre(90.0, 80.0, 85.0);
  const auto ball = [&](glm::ivec3 at) { return inBall(at, centre, 31.0); };
  const auto volume =
      volumeOf<std::int16_t>(gridOf(glm::ivec3(170)), [&](glm::ivec3 at) { return ball(at) ? 90.0 : 0.0; });
  ASSERT_GT(tissueCells(*volume).size.x, 1);
  const auto tree = TissueTree::build(*volume);
  // Cells alone would be wrong in a shell of half a cell, and the Dice 0.97.
  EXPECT_GT(bestDice(joinsFrom(*tree, *volume, glm::ivec3(centre)), volume->grid, ball), 0.99);
}

RegionFocus byTissues(const Volume& volume, glm::ivec3 seed) {
  return {{worldOf(volume.grid, seed)}, {}, {}, {}, RegionRule::Tissues};
}

TEST(RegionByTissues, ClicksAnywhereInABallGiveTheBall) {
  const auto volume = touchingBalls();
  const VoxelBox whole = wholeOf(volume->grid.dims);
  const auto tree = TissueTree::build(*volume);
  for (const glm::ivec3 offset : {glm::ivec3(0), glm::ivec3(1, 0, 0), glm::ivec3(-7, 3, 2), glm::ivec3(2, -8, 1)}) {
    const Growth growth = *growRegion(*volume, byTissues(*volume, glm::ivec3(left) + offset), whole, {}, tree);
    double both = 0.0, either = 0.0;
    const Mask mask = maskAt(growth, growth.curve.automatic);
    tests::forEachVoxel(volume->grid.dims, [&](glm::ivec3 at) {
      const bool a = mask.voxels[volume->grid.offset(at)], b = inLeft(at);
      both += a && b;
      either += a + b;
    });
    EXPECT_GT(2.0 * both / either, 0.95) << offset.x << ' ' << offset.y << ' ' << offset.z;
    EXPECT_EQ(growth.bodyVolume, tree->bodyVolume());
  }
}

TEST(RegionByTissues, SeedsChangeNothingElse) {
  const glm::dvec3 small(38.0, 20.0, 20.0);
  const auto inSmall = [&](glm::ivec3 at) { return inBall(at, small, 9.5); };
  const auto volume = noisyVolume(gridOf(glm::ivec3(59, 41, 41)), 12.0,
                                  [&](glm::ivec3 at) { return inLeft(at) || inSmall(at) ? 50.0 : 0.0; });
  const VoxelBox whole = wholeOf(volume->grid.dims);
  const auto tree = TissueTree::build(*volume);
  const auto opened = [](const Growth& growth) {
    return growth.curve.volume[static_cast<std::size_t>(growth.curve.automatic)];
  };
  RegionFocus settings = byTissues(*volume, glm::ivec3(left));
  const Growth one = *growRegion(*volume, settings, whole, {}, tree);
  settings.inside.push_back(worldOf(volume->grid, glm::ivec3(small)));
  const Growth two = *growRegion(*volume, settings, whole, {}, tree);
  EXPECT_EQ(two.curve.automatic, one.curve.automatic);
  const double share = std::pow(9.5 / radius, 3.0);  // of the small ball in the large one
  EXPECT_NEAR(opened(two), (1.0 + share) * opened(one), 0.05 * opened(one));
  settings.outside.push_back(worldOf(volume->grid, glm::ivec3(small) + glm::ivec3(4, 0, 0)));
  settings.inside.pop_back();
  const Growth again = *growRegion(*volume, settings, whole, {}, tree);
  EXPECT_EQ(again.curve.automatic, one.curve.automatic);
  EXPECT_NEAR(opened(again), opened(one), 0.05 * opened(one));
  // No tolerance reaches it, and none before it is lost.
  const glm::ivec3 outside = glm::ivec3(small) + glm::ivec3(4, 0, 0);
  EXPECT_EQ(again.steps->value(outside), 0);
  const auto reached = static_cast<std::size_t>(one.steps->value(outside));
  EXPECT_EQ(again.curve.volume[reached - 1], one.curve.volume[reached - 1]);
}

TEST(RegionByTissues, ASeedAtTheSurfaceAddsALayerAtMost) {
  const auto volume = touchingBalls();
  const VoxelBox whole = wholeOf(volume->grid.dims);
  const auto tree = TissueTree::build(*volume);
  RegionFocus settings = byTissues(*volume, glm::ivec3(left));
  const Growth one = *growRegion(*volume, settings, whole, {}, tree);
  const auto opened = [](const Growth& growth) {
    return growth.curve.volume[static_cast<std::size_t>(growth.curve.automatic)];
  };
  // Two voxels beside the ball, in what surrounds it and is far larger.
  settings.inside.push_back(worldOf(volume->grid, glm::ivec3(left) - glm::ivec3(static_cast<int>(radius) + 2, 0, 0)));
  const Growth two = *growRegion(*volume, settings, whole, {}, tree);
  EXPECT_LT(opened(two), 1.3 * opened(one));
}

TEST(RegionByTissues, NoiseAboveTheContrastHidesNoBorder) {
  constexpr double noise = 40.0, contrast = 35.0;
  const Grid grid = gridOf(glm::ivec3(56));
  const auto inOrgan = [](glm::ivec3 at) { return inBall(at, glm::dvec3(28.0), 14.0); };
  const auto volume = noisyVolume(grid, noise, [&](glm::ivec3 at) { return inOrgan(at) ? contrast : 0.0; });
  volume->unit = "HU";
  const Growth growth = *growRegion(*volume, byTissues(*volume, glm::ivec3(28)), wholeOf(grid.dims));
  const Mask region = maskAt(growth, growth.curve.automatic);
  double both = 0.0, sum = 0.0;
  tests::forEachVoxel(grid.dims, [&](glm::ivec3 at) {
    const double joined = region.voxels[grid.offset(at)], inside = inOrgan(at) ? 1.0 : 0.0;
    both += 2.0 * joined * inside;
    sum += joined + inside;
  });
  EXPECT_GT(both / sum, 0.85);
}

TEST(RegionByTissues, TakesVolumesOfAnyKind) {
  const auto single = volumeOf<std::uint8_t>(gridOf(glm::ivec3(1)), [](glm::ivec3) { return 3; });
  const auto flat = volumeOf<std::int16_t>(gridOf({30, 20, 1}), [](glm::ivec3) { return -5; });
  const auto holes = volumeOf<float>(gridOf(glm::ivec3(12)), [](glm::ivec3 at) {
    return at.x == 6 ? tests::nan : at.y == 6 ? tests::infinity : at.z == 6 ? -tests::infinity : 1.0 + at.x;
  });
  for (const auto& volume : {single, flat, holes}) {
    RegionFocus settings = byTissues(*volume, volume->grid.dims / 2);
    settings.inside.push_back(worldOf(volume->grid, glm::ivec3(0)));
    settings.outside.push_back(worldOf(volume->grid, volume->grid.dims - 1));
    const Growth growth = *growRegion(*volume, settings, wholeOf(volume->grid.dims));
    EXPECT_GE(growth.curve.automatic, 0);
    EXPECT_LE(growth.curve.automatic, stepCount);
  }
}

TEST(RegionByTissues, NothingGrowsOutsideTheBallDrawn) {
  const auto volume = touchingBalls();
  for (const RegionRule rule : {RegionRule::Values, RegionRule::Tissues}) {
    RegionFocus settings = byTissues(*volume, glm::ivec3(left));
    settings.rule = rule;
    settings.ball = 6.0;
    const Growth growth = *growRegion(*volume, settings, wholeOf(volume->grid.dims));
    double most = 0.0;
    for (int step = 1; step <= stepCount; ++step)
      most = std::max(most, growth.curve.volume[static_cast<std::size_t>(step)]);
    double inside = 0.0;
    tests::forEachVoxel(volume->grid.dims, [&](glm::ivec3 at) {
      const glm::dvec3 away = worldOf(volume->grid, at) - settings.inside.front();
      inside += glm::length(away) <= 6.0 ? volume->grid.voxelVolume() : 0.0;
    });
    EXPECT_GT(most, 0.0);
    EXPECT_LE(most, inside);
  }
}

}  // namespace
}  // namespace fenestra::segmentation::tissueTreeTest
