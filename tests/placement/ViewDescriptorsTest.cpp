// View descriptors, rank correlation and representative views, against closed forms: no OpenGL.

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "rendering/viewpoints/RankCorrelation.h"
#include "rendering/viewpoints/RepresentativeViews.h"
#include "rendering/viewpoints/Sphere.h"
#include "rendering/viewpoints/SurfaceCurvature.h"
#include "rendering/viewpoints/ViewDescriptors.h"
#include "tests/support/Scenes.h"

namespace fenestra::placement::viewDescriptorsTest {
namespace {

using tests::randomUnit;

constexpr double pi = std::numbers::pi;
/// Sums of up to a thousand terms in double precision.
constexpr double rounding = 1e-12;

void see(Candidate& candidate, std::size_t point) { candidate.seen[point / 64] |= std::uint64_t{1} << (point % 64); }

/// Candidates that see all points of a convex surface that face them.
std::vector<Candidate> facing(const SurfacePoints& surface, const std::vector<glm::dvec3>& directions) {
  std::vector<Candidate> candidates;
  for (const glm::dvec3 direction : directions) {
    Candidate candidate;
    candidate.direction = direction;
    candidate.seen.assign((surface.normals.size() + 63) / 64, 0);
    for (std::size_t z = 0; z < surface.normals.size(); ++z)
      if (glm::dot(surface.normals[z], direction) > 0.0) see(candidate, z);
    candidates.push_back(candidate);
  }
  return candidates;
}

SurfacePoints cube() {
  SurfacePoints surface;
  for (const glm::dvec3 normal : {glm::dvec3(1, 0, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0),
                                  glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1)}) {
    surface.positions.push_back(normal);
    surface.normals.push_back(normal);
  }
  surface.labels = {1, 1, 2, 2, 3, 3};
  surface.area = 24.0;
  return surface;
}

/// Points of equal area on a sphere.
SurfacePoints ball(double radius, int nside = 8) {
  SurfacePoints surface;
  for (const glm::dvec3 normal : ringDirections(nside)) {
    surface.positions.push_back(radius * normal);
    surface.normals.push_back(normal);
  }
  surface.area = 4.0 * pi * radius * radius;
  return surface;
}

std::vector<std::vector<double>> randomAreas(std::size_t views, std::size_t elements) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> area;
  std::vector<std::vector<double>> areas(views, std::vector<double>(elements));
  for (std::vector<double>& row : areas)
    for (double& each : row) each = std::max(0.0, area(random) - 0.3);  // some are hidden
  return areas;
}

TEST(ViewDescriptors, ACubeShowsOneTwoOrThreeEqualFaces) {
  const glm::dvec3 face(1, 0, 0), edge = glm::normalize(glm::dvec3(1, 1, 0)), corner = glm::normalize(glm::dvec3(1));
  const SurfacePoints surface = cube();
  const DescribedViews views(facing(surface, {face, edge, corner}), surface, {});
  const std::vector<double> entropy = views.values(ViewDescriptor::Entropy);
  EXPECT_NEAR(entropy[0], 0.0, rounding);
  EXPECT_NEAR(entropy[1], 1.0, rounding);
  EXPECT_NEAR(entropy[2], std::log2(3.0), rounding);
  // Each axis is a structure here, so that structures give the same.
  const std::vector<double> structures = views.values(ViewDescriptor::StructureEntropy);
  for (std::size_t v = 0; v < 3; ++v) EXPECT_NEAR(structures[v], entropy[v], rounding);
  EXPECT_EQ(views.shares(), (std::vector<double>{1.0 / 6.0, 2.0 / 6.0, 3.0 / 6.0}));
  EXPECT_EQ(choiceBy(ViewDescriptor::Entropy, entropy), std::size_t{2});
  // H(Z) is one number, so I2 orders views as entropy does, reversed.
  const std::vector<double> i2 = views.values(ViewDescriptor::I2);
  EXPECT_NEAR(i2[0] - i2[2], std::log2(3.0), rounding);
  EXPECT_EQ(choiceBy(ViewDescriptor::I2, i2), std::size_t{2});
  EXPECT_NEAR(preferenceCorrelation(ViewDescriptor::I2, i2, entropy), 1.0, rounding);
}

TEST(ViewDescriptors, AnObliqueFaceCountsByItsProjectedArea) {
  // Seen along (3, 4, 0)/5, two faces have the shares 3/7 and 4/7.
  const SurfacePoints surface = cube();
  const DescribedViews views(facing(surface, {{0.6, 0.8, 0.0}}), surface, {});
  const double expected = -3.0 / 7.0 * std::log2(3.0 / 7.0) - 4.0 / 7.0 * std::log2(4.0 / 7.0);
  EXPECT_NEAR(views.values(ViewDescriptor::Entropy)[0], expected, rounding);
}

TEST(ViewDescriptors, AFocusOfOneStructureHasNoEntropyOfStructures) {
  SurfacePoints surface = cube();
  surface.labels.assign(6, 7);
  surface.labels[3] = 0;  // no label was found there
  const DescribedViews views(facing(surface, ringDirections(1)), surface, {});
  const std::vector<double> values = views.values(ViewDescriptor::StructureEntropy);
  for (const double value : values) EXPECT_TRUE(std::isnan(value));
  EXPECT_EQ(choiceBy(ViewDescriptor::StructureEntropy, values), std::nullopt);
}

TEST(ViewDescriptors, ViewsThatSeeTheSameTellNothingApart) {
  const std::vector<std::vector<double>> areas(5, {1.0, 2.0, 5.0});
  const ViewChannel channel(areas);
  for (std::size_t v = 0; v < 5; ++v) {
    EXPECT_NEAR(channel.mutualInformation(v), 0.0, rounding);
    EXPECT_NEAR(channel.specificInformation(v), 0.0, rounding);
    EXPECT_NEAR(channel.divergence(v, (v + 1) % 5), 0.0, rounding);
    EXPECT_NEAR(channel.viewShare(v), 0.2, rounding);
  }
}

TEST(ViewDescriptors, ViewsThatShareNothingTellAllApart) {
  const ViewChannel channel({{1.0, 1.0, 0.0, 0.0}, {0.0, 0.0, 3.0, 3.0}, {0.0, 0.0, 0.0, 0.0}});
  EXPECT_NEAR(channel.entropy(0), 1.0, rounding);
  EXPECT_NEAR(channel.viewShare(1), 0.75, rounding);
  // For the elements that a view sees, p(z) is p(v) p(z|v).
  EXPECT_NEAR(channel.mutualInformation(0), 2.0, rounding);
  EXPECT_NEAR(channel.mutualInformation(1), std::log2(4.0 / 3.0), rounding);
  // The Jensen–Shannon divergence of disjoint distributions is the entropy of their weights.
  EXPECT_NEAR(channel.divergence(0, 1), -0.25 * std::log2(0.25) - 0.75 * std::log2(0.75), rounding);
  EXPECT_EQ(channel.divergence(0, 2), 0.0);
  EXPECT_TRUE(std::isnan(channel.mutualInformation(2)) && std::isnan(channel.entropy(2)));
}

TEST(ViewDescriptors, BothInformationsAddUpToTheChannels) {
  const std::vector<std::vector<double>> areas = randomAreas(40, 30);
  const ViewChannel channel(areas);
  // I(V;Z) = H(V) + H(Z) − H(V,Z), from the areas alone.
  std::vector<double> joint, ofViews, ofElements(30, 0.0);
  for (const std::vector<double>& row : areas) {
    joint.insert(joint.end(), row.begin(), row.end());
    ofViews.push_back(std::accumulate(row.begin(), row.end(), 0.0));
    for (std::size_t z = 0; z < row.size(); ++z) ofElements[z] += row[z];
  }
  const double all = entropyOf(ofViews) + entropyOf(ofElements) - entropyOf(joint);
  ASSERT_GT(all, 0.1);
  double mutual = 0.0, specific = 0.0;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    EXPECT_GE(channel.mutualInformation(v), 0.0);
    mutual += channel.viewShare(v) * channel.mutualInformation(v);
    specific += channel.viewShare(v) * channel.specificInformation(v);
  }
  EXPECT_NEAR(mutual, all, rounding);
  EXPECT_NEAR(specific, all, rounding);
}

TEST(ViewDescriptors, DivergenceIsInformationLostByMixingTwoViews) {
  // Feixas et al., equation for D(v, w): the loss of I(V;Z) when the two views are clustered, over p(v) + p(w).
  const std::vector<std::vector<double>> areas = randomAreas(2, 20);
  const ViewChannel channel(areas);
  const double all =
      channel.viewShare(0) * channel.mutualInformation(0) + channel.viewShare(1) * channel.mutualInformation(1);
  EXPECT_NEAR(channel.divergence(0, 1), all, rounding);  // of two views alone, mixing them loses all
}

TEST(ViewDescriptors, ABallLooksTheSameFromEverywhere) {
  const SurfacePoints surface = ball(12.0);
  const DescribedViews views(facing(surface, ringDirections(4)), surface, {});
  // Its points are a lattice of 768: directions of one kind see it alike to within the lattice, whose points are 4.2°
  // apart, so that values scatter by some hundredths of a bit around the closed form.
  // H of p(z) ∝ cos θ on a half sphere of n/2 points: log₂(n/2) − ∫ 2u log₂(2u) du over 0…1 = log₂(n/2) − 1 + 1/(2 ln
  // 2).
  const double expected = std::log2(0.5 * 768.0) - 1.0 + 0.5 / std::log(2.0);
  for (const double value : views.values(ViewDescriptor::Entropy)) EXPECT_NEAR(value, expected, 0.03);
  for (const double value : views.values(ViewDescriptor::CurvatureEntropy)) EXPECT_EQ(value, 0.0);
  const std::vector<double> stability = views.values(ViewDescriptor::Stability);
  const auto [least, greatest] = std::minmax_element(stability.begin(), stability.end());
  EXPECT_GT(*least, 0.7);
  EXPECT_LT(*greatest, 1.0);
  // Neighbours are 11° to 21° away, more evenly in some places than in others.
  EXPECT_LT(*greatest - *least, 0.06);
}

TEST(ViewDescriptors, ViewsLikeTheirNeighboursAreStable) {
  // A plate seen from in front: all views that see it see it whole, whatever its projected area.
  SurfacePoints surface;
  for (int i = 0; i < 10; ++i) {
    surface.positions.emplace_back(i, 0.0, 0.0);
    surface.normals.emplace_back(0.0, 0.0, 1.0);
  }
  surface.area = 10.0;
  const std::vector<glm::dvec3> directions = ringDirections(4);
  const DescribedViews views(facing(surface, directions), surface, {});
  const std::vector<double> stability = views.values(ViewDescriptor::Stability);
  for (std::size_t v = 0; v < directions.size(); ++v) {
    if (directions[v].z > 1e-9)
      EXPECT_NEAR(stability[v], 1.0, rounding);
    else
      EXPECT_TRUE(std::isnan(stability[v])) << v;
  }
}

TEST(ViewDescriptors, CurvatureOfSpheresCylindersAndSaddles) {
  for (const double radius : {0.5, 12.0, 200.0}) {
    const SurfacePoints surface = ball(radius);
    for (const double curvature : gaussianCurvatures(surface.positions, surface.normals)) {
      EXPECT_NEAR(curvature * radius * radius, 1.0, 1e-9);  // the fit is exact
      EXPECT_EQ(curvatureClass(curvature, surface.area), 2);
    }
  }
  std::vector<glm::dvec3> positions, normals;
  for (int row = 0; row < 20; ++row)
    for (int i = 0; i < 40; ++i) {
      const double angle = 2.0 * pi * i / 40.0;
      normals.emplace_back(std::cos(angle), std::sin(angle), 0.0);
      positions.push_back(10.0 * normals.back() + glm::dvec3(0.0, 0.0, 1.5 * row));
    }
  for (const double curvature : gaussianCurvatures(positions, normals)) EXPECT_NEAR(curvature, 0.0, 1e-9);
  // z = (x² − y²)/2 has the curvature −1/(1 + x² + y²)². Neighbours lie unevenly around a point where the lattice is
  // tilted, so that the error is of the first order in their distance.
  const auto errorOn = [&](int halfCount) {
    positions.clear();
    normals.clear();
    const double step = 1.0 / halfCount;
    for (int y = -halfCount; y <= halfCount; ++y)
      for (int x = -halfCount; x <= halfCount; ++x) {
        const glm::dvec2 at(step * x, step * y);
        positions.emplace_back(at, 0.5 * (at.x * at.x - at.y * at.y));
        normals.push_back(glm::normalize(glm::dvec3(-at.x, at.y, 1.0)));
      }
    const std::vector<double> curvatures = gaussianCurvatures(positions, normals);
    double greatest = 0.0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const glm::dvec2 at(positions[i]);
      const double away = 1.0 + glm::dot(at, at);
      if (std::abs(at.x) < 0.6 && std::abs(at.y) < 0.6)  // no neighbour is missing there
        greatest = std::max(greatest, std::abs(curvatures[i] + 1.0 / (away * away)));
    }
    return greatest;
  };
  const double coarse = errorOn(20), fine = errorOn(40);
  EXPECT_LT(fine, 0.02);
  EXPECT_LT(fine, 0.6 * coarse);
  // Too few neighbours, and neighbours on a line.
  for (const int count : {1, 3}) {
    positions.clear();
    for (int i = 0; i < count; ++i) positions.emplace_back(i, 0.0, 0.0);
    normals.assign(positions.size(), glm::dvec3(0.0, 0.0, 1.0));
    for (const double curvature : gaussianCurvatures(positions, normals)) EXPECT_TRUE(std::isnan(curvature));
  }
}

TEST(ViewDescriptors, CurvatureEntropyOfABallAndASaddle) {
  // Half of the points lie on a ball, half on a plate far away; from the side both show, in the ratio of their visible
  // points.
  SurfacePoints surface = ball(10.0, 4);
  const std::size_t ofBall = surface.normals.size();
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 12; ++x) {
      surface.positions.emplace_back(100.0 + x, y, 0.0);
      surface.normals.emplace_back(0.0, 0.0, 1.0);
    }
  const glm::dvec3 up = glm::normalize(glm::dvec3(0.1, 0.2, 1.0));
  const std::vector<Candidate> candidates = facing(surface, {up, -up});
  const DescribedViews views(candidates, surface, {});
  double above = 0.0;
  for (std::size_t z = 0; z < ofBall; ++z) above += glm::dot(surface.normals[z], up) > 0.0 ? 1.0 : 0.0;
  const std::vector<double> values = views.values(ViewDescriptor::CurvatureEntropy);
  EXPECT_NEAR(values[0], entropyOf({above, 192.0}), rounding);
  EXPECT_EQ(values[1], 0.0);
}

TEST(RankCorrelation, OfKnownPermutations) {
  EXPECT_NEAR(rankCorrelation({1, 2, 3, 4, 5}, {2, 4, 6, 8, 100}), 1.0, rounding);
  EXPECT_NEAR(rankCorrelation({1, 2, 3, 4, 5}, {5, 4, 3, 2, 1}), -1.0, rounding);
  // Without ties, 1 − 6 Σ d² / (n (n² − 1)); d = 1, 1, 1, 1, 0.
  EXPECT_NEAR(rankCorrelation({1, 2, 3, 4, 5}, {2, 1, 4, 3, 5}), 1.0 - 6.0 * 4.0 / 120.0, rounding);
  // With ties: ranks 1, 2.5, 2.5, 4 against 1, 2, 3, 4: 4.5 / √(4.5 · 5).
  EXPECT_NEAR(rankCorrelation({10, 20, 20, 30}, {1, 2, 3, 4}), 4.5 / std::sqrt(4.5 * 5.0), rounding);
  EXPECT_NEAR(rankCorrelation({1, 1, 2, 2}, {3, 3, 9, 9}), 1.0, rounding);
  const double nan = std::nan("");
  EXPECT_NEAR(rankCorrelation({1, nan, 2, 3, 7}, {1, 0, 2, 3, nan}), 1.0, rounding);
  EXPECT_TRUE(std::isnan(rankCorrelation({1, 1, 1}, {1, 2, 3})));
  EXPECT_TRUE(std::isnan(rankCorrelation({}, {})));
}

/// A disc of a radius around a middle, both in pixels, with exact crossings; its depth is `depthAt` the distance from
/// the middle.
template <class Depth>
FocusImage disc(double radius, glm::dvec2 middle, int side, Depth&& depthAt, double hole = 0.0) {
  FocusImage image;
  image.size = glm::ivec2(side);
  const std::size_t count = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  image.depth.assign(count, std::nanf(""));
  image.right.assign(count, 0.5f);
  image.below.assign(count, 0.5f);
  const auto inside = [&](glm::dvec2 at) {
    const double away = glm::distance(at, middle);
    return away < radius && away >= hole;
  };
  const auto crossing = [&](glm::dvec2 from, glm::dvec2 to) {
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 30; ++i) {
      const double half = 0.5 * (low + high);
      (inside(glm::mix(from, to, half)) == inside(from) ? low : high) = half;
    }
    return static_cast<float>(low);
  };
  for (int y = 0; y + 1 < side; ++y)
    for (int x = 0; x + 1 < side; ++x) {
      const glm::dvec2 at(x, y);
      if (inside(at)) image.depth[image.offset({x, y})] = static_cast<float>(depthAt(glm::distance(at, middle)));
      image.right[image.offset({x, y})] = crossing(at, at + glm::dvec2(1.0, 0.0));
      image.below[image.offset({x, y})] = crossing(at, at + glm::dvec2(0.0, 1.0));
    }
  return image;
}

TEST(FocusImage, OutlineOfADiscAndOfARing) {
  const auto flat = [](double) { return 1.0; };
  for (const double radius : {6.0, 20.0, 45.0}) {
    FocusImage image = disc(radius, {49.3, 50.8}, 100, flat);
    image.pixel = 0.5;
    const auto outlines = outlinesOf(image);
    ASSERT_EQ(outlines.size(), 1u);
    // A chord of length c is shorter than its arc by (c/r)²/24 of it, and within a square of pixels c ≤ √2.
    EXPECT_NEAR(lengthOf(outlines, image.pixel) / (pi * radius), 1.0, 1.0 / (12.0 * radius * radius));
    EXPECT_NEAR(turningOf(outlines, 2.0), 2.0 * pi, 1e-9);
    EXPECT_NEAR(measuresOf(image, 0.0, 2.0, 10.0).silhouetteLength, pi * radius / 10.0, 0.01);
  }
  const auto ring = outlinesOf(disc(40.0, {49.3, 50.8}, 100, flat, 20.0));
  ASSERT_EQ(ring.size(), 2u);
  EXPECT_NEAR(lengthOf(ring, 1.0), 2.0 * pi * 60.0, 0.02);
  EXPECT_NEAR(turningOf(ring, 4.0), 4.0 * pi, 1e-9);
  EXPECT_EQ(turningOf(outlinesOf(disc(1.5, {20.1, 20.2}, 40, flat)), 2.0), 0.0);  // shorter than 12 pixels
}

TEST(FocusImage, PixelsAcrossADiagonalAreConnected) {
  FocusImage image;
  image.size = {4, 4};
  image.depth.assign(16, std::nanf(""));
  image.right.assign(16, 0.5f);
  image.below.assign(16, 0.5f);
  image.depth[image.offset({1, 1})] = image.depth[image.offset({2, 2})] = 0.0f;
  const auto outlines = outlinesOf(image);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0].size(), 8u);
  EXPECT_NEAR(lengthOf(outlines, 1.0), 8.0 * std::sqrt(0.5), rounding);
}

TEST(FocusImage, ABentOutlineTurnsMoreThanAConvexOne) {
  const double radius = 20.0;
  FocusImage image = disc(radius, {35.2, 40.4}, 90, [](double) { return 1.0; });
  const FocusImage other = disc(radius, {35.2 + radius, 40.4}, 90, [](double) { return 1.0; });
  for (std::size_t i = 0; i < image.depth.size(); ++i) {
    if (i % 90 <= 45) continue;
    image.depth[i] = other.depth[i];
    image.right[i] = other.right[i];
    image.below[i] = other.below[i];
  }
  const auto outlines = outlinesOf(image);
  ASSERT_EQ(outlines.size(), 1u);
  // The circles meet at ±60° from the line between their centres: two arcs of 240°, and two notches that turn back by
  // 60° each. Smoothed by a Gaussian g of two pixels, the curvature around a notch is 1/r − π/3 · g.
  double expected = 2.0 * glm::radians(240.0) - 80.0 / radius;
  constexpr double step = 0.01;
  for (double along = -20.0; along < 20.0; along += step) {
    const double gaussian = std::exp(-along * along / 8.0) / std::sqrt(8.0 * pi);
    expected += 2.0 * step * std::abs(1.0 / radius - pi / 3.0 * gaussian);
  }
  ASSERT_GT(expected, 2.0 * pi + 1.0);
  // Chords cut the tip of each notch off, by up to a pixel of some eight over which it is smoothed.
  EXPECT_NEAR(turningOf(outlines, 2.0), expected, 0.2);
}

TEST(FocusImage, DepthsOfABallAndOfAPlate) {
  const auto flat = [](double) { return 3.0; };
  const FocusImage plate = disc(30.0, {39.5, 39.5}, 80, flat);
  EXPECT_EQ(depthEntropy(plate, -10.0, 10.0), 0.0);
  EXPECT_EQ(depthEntropy(plate, 3.0, 3.0), 0.0);
  EXPECT_EQ(depthEntropy(plate, -10.0, 2.0), 0.0);  // beyond the last bin
  EXPECT_TRUE(std::isnan(depthEntropy(disc(0.0, {39.5, 39.5}, 80, flat), -10.0, 10.0)));
  // The area of a ball's near half per unit of depth is proportional to the height above the ball's middle: bin k of
  // the 16 there has (2k + 1)/256.
  const double radius = 300.0;
  std::vector<double> shares;
  for (int k = 0; k < 16; ++k) shares.push_back((2.0 * k + 1.0) / 256.0);
  const FocusImage image = disc(radius, {309.5, 309.5}, 620,
                                [&](double away) { return -std::sqrt(std::max(0.0, radius * radius - away * away)); });
  // 280 000 pixels, each in one bin: counts scatter by the outlines of the bins, some 1900 pixels long.
  EXPECT_NEAR(depthEntropy(image, -radius, radius), entropyOf(shares), 0.005);
}

TEST(RepresentativeViews, TakeWhatIsNew) {
  // View 1 sees the most, view 0 nothing that it does not see, view 2 and 3 the rest.
  const ViewChannel channel(
      {{1, 1, 1, 0, 0, 0, 0, 0}, {1, 1, 1, 1, 0, 0, 0, 0}, {0, 0, 0, 1, 1, 1, 0, 0}, {0, 0, 0, 0, 0, 0, 1, 0}});
  // An element that no view sees is not waited for. View 3 sees one element: its entropy is 0, and so is its gain.
  const RepresentativeViews chosen = representativeViews(channel, 1.0);
  EXPECT_EQ(chosen.views, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(chosen.shares, (std::vector<double>{0.5, 0.75}));
  EXPECT_EQ(representativeViews(channel, 0.5).views, (std::vector<std::size_t>{1}));
  EXPECT_EQ(representativeViews(channel, 1.0, 1).views, (std::vector<std::size_t>{1}));
  EXPECT_TRUE(representativeViews(ViewChannel({}), 1.0).views.empty());
}

TEST(RepresentativeViews, OfACubeAreTwoOppositeCorners) {
  const SurfacePoints surface = cube();
  std::vector<glm::dvec3> directions;
  for (int corner = 0; corner < 8; ++corner)
    directions.push_back(glm::normalize(glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
  const DescribedViews views(facing(surface, directions), surface, {});
  const RepresentativeViews chosen = representativeViews(views.channel(), 1.0);
  EXPECT_EQ(chosen.views, (std::vector<std::size_t>{0, 7}));
  EXPECT_EQ(chosen.shares.back(), 1.0);
  EXPECT_NEAR(shortestTour({directions[0], directions[7]}).length, 2.0 * pi, 1e-7);
}

TEST(RepresentativeViews, TheTourIsTheShortest) {
  std::vector<glm::dvec3> circle;
  for (const int at : {0, 3, 1, 4, 2}) circle.emplace_back(std::cos(0.4 * pi * at), std::sin(0.4 * pi * at), 0.0);
  const Tour tour = shortestTour(circle);
  EXPECT_EQ(tour.order, (std::vector<std::size_t>{0, 2, 4, 1, 3}));
  EXPECT_NEAR(tour.length, 2.0 * pi, 1e-9);
  EXPECT_EQ(shortestTour({}).length, 0.0);
  EXPECT_EQ(shortestTour({circle[0]}).order, (std::vector<std::size_t>{0}));
}

TEST(ViewDescriptors, NamesAreInTheOrderOfTheEnumeration) {
  for (std::size_t i = 0; i < viewDescriptors().size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(viewDescriptors()[i].descriptor), i);
}

}  // namespace
}  // namespace fenestra::placement::viewDescriptorsTest
