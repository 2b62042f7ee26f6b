#include "rendering/scene/SplineVolume.h"

#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "rendering/scene/Scene.h"
#include "tests/support/Scenes.h"

namespace fenestra::splineVolumeTest {
namespace {

using namespace tests;

ShownVolume shownAs(std::shared_ptr<const Volume> volume, Reconstruction reconstruction) {
  ShownVolume shown{std::move(volume)};
  shown.reconstruction = reconstruction;
  return shown;
}

/// A polynomial of degree 3 along each axis and of degree 9 in all, and its gradient.
struct Polynomial {
  static glm::dvec3 factors(glm::dvec3 p) {
    return {1.0 + p.x * (0.3 + p.x * (-0.2 + 0.02 * p.x)), 2.0 + p.y * (-0.7 + p.y * (0.1 - 0.01 * p.y)),
            -1.0 + p.z * (0.2 + p.z * (0.05 + 0.004 * p.z))};
  }
  static glm::dvec3 slopes(glm::dvec3 p) {
    return {0.3 + p.x * (-0.4 + 0.06 * p.x), -0.7 + p.y * (0.2 - 0.03 * p.y), 0.2 + p.z * (0.1 + 0.012 * p.z)};
  }
  static double value(glm::dvec3 p) {
    const glm::dvec3 f = factors(p);
    return f.x * f.y * f.z;
  }
  static glm::dvec3 gradient(glm::dvec3 p) {
    const glm::dvec3 f = factors(p), d = slopes(p);
    return {d.x * f.y * f.z, f.x * d.y * f.z, f.x * f.y * d.z};
  }
};

TEST(SplineVolume, CubicIsAPolynomialOfDegreeThreeUpToTheOutermostVoxels) {
  for (const glm::ivec3 dims : {glm::ivec3(12, 9, 7), glm::ivec3(4, 5, 40)}) {
    const auto volume = volumeOf(gridOf(dims), [](glm::ivec3 i) { return Polynomial::value(glm::dvec3(i)); });
    const SplineVolume spline(shownAs(volume, Reconstruction::Cubic));
    const double scale = std::max(std::abs(volume->range.low), std::abs(volume->range.high));
    std::mt19937 random(1);
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 p = randomIn(random, glm::dvec3(0.0), glm::dvec3(dims - 1));
      // A rounding of each of some 64 terms; the gradient's are greater by the difference.
      EXPECT_NEAR(spline.value(p), Polynomial::value(p), 1e-12 * scale);
      EXPECT_LT(glm::distance(spline.gradient(p), Polynomial::gradient(p)), 1e-11 * scale);
    }
  }
}

TEST(SplineVolume, CubicMeetsEveryVoxelAndFewVoxelsTakeTheirPolynomial) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1000.0, 3000.0);
  for (int n = 1; n <= 8; ++n) {
    const glm::ivec3 dims(n, 3, 9 - n);
    const auto volume = volumeOf(gridOf(dims), [&](glm::ivec3) { return any(random); });
    const SplineVolume spline(shownAs(volume, Reconstruction::Cubic));
    glm::ivec3 at;
    for (at.z = 0; at.z < dims.z; ++at.z)
      for (at.y = 0; at.y < dims.y; ++at.y)
        for (at.x = 0; at.x < dims.x; ++at.x) EXPECT_NEAR(spline.value(at), volume->value(at), 1e-9);
  }
  const auto parabola = volumeOf(gridOf({3, 2, 1}), [](glm::ivec3 i) { return 5.0 * i.x * i.x + 3.0 * i.y; });
  EXPECT_NEAR(SplineVolume(shownAs(parabola, Reconstruction::Cubic)).value({0.5, 0.25, 0.0}), 2.0, 1e-12);
}

TEST(SplineVolume, SmoothIsTheBSplineOverTheValues) {
  const auto impulse = volumeOf(gridOf({9, 9, 9}), [](glm::ivec3 i) { return i == glm::ivec3(4) ? 1.0 : 0.0; });
  const SplineVolume spline(shownAs(impulse, Reconstruction::Smooth));
  EXPECT_NEAR(spline.value({4, 4, 4}), 8.0 / 27.0, 1e-15);
  EXPECT_NEAR(spline.value({5, 4, 4}), 2.0 / 27.0, 1e-15);
  EXPECT_NEAR(spline.value({4.5, 4, 4}), 23.0 / 48.0 * 4.0 / 9.0, 1e-15);
  EXPECT_EQ(spline.value({6, 4, 4}), 0.0);
}

TEST(SplineVolume, SmootherIsTheBSplineOverBinomialMeans) {
  const auto impulse = volumeOf(gridOf({13, 13, 13}), [](glm::ivec3 i) { return i == glm::ivec3(6) ? 1.0 : 0.0; });
  const SplineVolume spline(shownAs(impulse, Reconstruction::Smoother));
  // Along an axis the B-spline is 1/6, 4/6, 1/6 at the voxels, and the means weigh 1, 4, 6, 4, 1 sixteenths.
  const std::array<double, 5> along{32.0 / 96.0, 23.0 / 96.0, 8.0 / 96.0, 1.0 / 96.0, 0.0};
  for (std::size_t i = 0; i < along.size(); ++i)
    EXPECT_NEAR(spline.value({6.0 + static_cast<double>(i), 6, 6}), along[i] * along[0] * along[0], 1e-15) << i;
  EXPECT_NEAR(spline.value({6, 4, 7}), along[0] * along[2] * along[1], 1e-15);
}

TEST(SplineVolume, MeansKeepWhatIsLinear) {
  // Up to the outermost voxels, and of so few that the means' five do not fit in.
  for (const glm::ivec3 dims : {glm::ivec3(9, 7, 8), glm::ivec3(2, 3, 1), glm::ivec3(1, 4, 2)}) {
    const auto linear = [](glm::dvec3 p) { return 100.0 + 3.0 * p.x - 2.0 * p.y + 0.5 * p.z; };
    const auto volume = volumeOf(gridOf(dims), [&](glm::ivec3 i) { return linear(i); });
    std::mt19937 random(5);
    for (const Reconstruction kind : {Reconstruction::Smooth, Reconstruction::Smoother}) {
      const SplineVolume spline(shownAs(volume, kind));
      for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = randomIn(random, glm::dvec3(0.0), glm::dvec3(dims - 1));
        EXPECT_NEAR(spline.value(p), linear(p), 1e-12);
      }
    }
  }
}

TEST(SplineVolume, GoesOnEvenlyBeyondTheOutermostVoxels) {
  const auto volume = volumeOf(gridOf({5, 5, 5}), [](glm::ivec3 i) { return std::sin(3.0 * i.x + i.y * i.z); });
  const SplineVolume spline(shownAs(volume, Reconstruction::Cubic));
  EXPECT_EQ(spline.value({-0.5, 2.3, 4.5}), spline.value({0.0, 2.3, 4.0}));
}

TEST(SplineVolume, ValuesLieBetweenTheCellsCoefficients) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const auto volume = volumeOf(gridOf({6, 6, 6}), [&](glm::ivec3) { return any(random); });
  const SplineVolume spline(shownAs(volume, Reconstruction::Cubic));
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 p = randomIn(random, glm::dvec3(-0.5), glm::dvec3(5.5));
    const ValueRange range = spline.range(glm::ivec3(glm::floor(p)));
    EXPECT_GE(spline.value(p), range.low - 1e-12);
    EXPECT_LE(spline.value(p), range.high + 1e-12);
  }
}

TEST(SplineVolume, AHiddenLabelsEdgeDoesNotRing) {
  const Grid grid = gridOf({16, 8, 8});
  const auto volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return i.y == 0 ? -1000 : i.y == 1 ? 500 : 40; });
  ASSERT_TRUE(volume->isInHounsfieldUnits());
  Scene scene;
  scene.volume = volume;
  scene.labels = labelsOf(grid, [](glm::ivec3 i) { return i.x >= 8 ? 1 : 0; });
  put(scene.look.labels, {.label = 1, .role = LabelRole::Hidden});
  for (const Reconstruction kind : {Reconstruction::Cubic, Reconstruction::Smooth, Reconstruction::Smoother}) {
    scene.look.reconstruction = kind;
    const SplineVolume spline(shownVolume(scene));
    // The slab at y = 1 keeps its own bend: far from it, values fall evenly from tissue to air.
    double before = spline.value({5.0, 7.0, 4.0});
    for (double x = 5.05; x <= 10.0; x += 0.05) {
      const double value = spline.value({x, 7.0, 4.0});
      EXPECT_LE(value, before + 1e-9) << x;
      before = value;
    }
    EXPECT_NEAR(before, -1000.0, 1e-9);
  }
}

/// Root mean square error of the reconstructions at random points away from the border.
struct Errors {
  double linear = 0.0, cubic = 0.0, smooth = 0.0, smoother = 0.0;
};

Errors errorsOf(int side, const auto& signal) {
  const auto volume = volumeOf(gridOf(glm::ivec3(side)), [&](glm::ivec3 i) { return signal(glm::dvec3(i)); });
  const SplineVolume cubic(shownAs(volume, Reconstruction::Cubic)), smooth(shownAs(volume, Reconstruction::Smooth)),
      smoother(shownAs(volume, Reconstruction::Smoother));
  std::mt19937 random(4);
  Errors sums;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 p = randomIn(random, glm::dvec3(4.0), glm::dvec3(side - 5.0));
    const auto square = [&](double value) { return std::pow(value - signal(p), 2.0); };
    sums.linear += square(volume->sample(p));
    sums.cubic += square(cubic.value(p));
    sums.smooth += square(smooth.value(p));
    sums.smoother += square(smoother.value(p));
  }
  const auto root = [](double sum) { return std::sqrt(sum / count); };
  return {root(sums.linear), root(sums.cubic), root(sums.smooth), root(sums.smoother)};
}

void expectOrder(const char* name, const Errors& errors) {
  std::cout << name << ": RMS error linear " << errors.linear << ", cubic " << errors.cubic << ", smooth "
            << errors.smooth << ", smoother " << errors.smoother << "\n";
  EXPECT_LT(errors.cubic, errors.linear);
  EXPECT_LT(errors.linear, errors.smooth);
  EXPECT_LT(errors.smooth, errors.smoother);
}

TEST(SplineVolume, CubicIsNearerToTheMarschnerLobbSignalThanLinearAndThatThanSmooth) {
  // Marschner and Lobb, "An evaluation of reconstruction filters for volume rendering", Vis 1994: 40 samples a side
  // over -1 … 1, f_M = 6, α = 0.25.
  constexpr int side = 41;
  const double pi = std::acos(-1.0);
  expectOrder("Marschner-Lobb, 41 samples a side", errorsOf(side, [&](glm::dvec3 index) {
                const glm::dvec3 p = index * (2.0 / (side - 1)) - 1.0;
                const double rho = std::cos(2.0 * pi * 6.0 * std::cos(0.5 * pi * std::hypot(p.x, p.y)));
                return (1.0 - std::sin(0.5 * pi * p.z) + 0.25 * (1.0 + rho)) / (2.0 * 1.25);
              }));
}

TEST(SplineVolume, CubicIsNearerToAZonePlateThanLinearAndThatThanSmooth) {
  // From the centre to the faces the frequency rises from 0 to a quarter of a period a voxel.
  constexpr int side = 64;
  const double pi = std::acos(-1.0);
  expectOrder("zone plate, 64 samples a side", errorsOf(side, [&](glm::dvec3 index) {
                const glm::dvec3 p = index - 0.5 * (side - 1);
                return 0.5 + 0.5 * std::cos(pi * 0.5 / side * glm::dot(p, p));
              }));
}

TEST(Reconstruction, AutoSmoothsCoarseAndSmallVolumesOnlyAndSharpOnesMore) {
  Scene scene;
  scene.look.reconstruction = Reconstruction::Auto;
  Modality modality = Modality::MR;
  glm::dvec3 spacing(1.0);
  const auto kindOf = [&](glm::ivec3 dims, ScalarType type) {
    auto volume = std::make_shared<Volume>();
    volume->grid.dims = dims;
    volume->grid.spacing = spacing;
    volume->modality = modality;
    volume->range = {-1000.0, 3000.0};
    volume->voxels = Voxels(type, 0);  // only grid, modality and range count
    scene.volume = volume;
    return reconstructionOf(scene);
  };
  EXPECT_EQ(kindOf({122, 101, 112}, ScalarType::Int16), Reconstruction::Smooth);
  EXPECT_EQ(kindOf({512, 512, 245}, ScalarType::Int16), Reconstruction::Linear);  // too many
  EXPECT_EQ(kindOf({2000, 50, 1}, ScalarType::Int16), Reconstruction::Linear);    // finer than pixels
  modality = Modality::CT;
  EXPECT_EQ(kindOf({122, 101, 112}, ScalarType::Int16), Reconstruction::Smoother);
  EXPECT_EQ(kindOf({180, 180, 170}, ScalarType::Int16), Reconstruction::Smooth);  // narrower than two pixels
  modality = Modality::MR;
  spacing.z = 5.0;
  EXPECT_EQ(kindOf({200, 200, 33}, ScalarType::Int16), Reconstruction::Smoother);  // thick slices
  scene.look.reconstruction = Reconstruction::Cubic;
  EXPECT_EQ(kindOf({2000, 50, 1}, ScalarType::Int16), Reconstruction::Cubic);
}

}  // namespace
}  // namespace fenestra::splineVolumeTest
