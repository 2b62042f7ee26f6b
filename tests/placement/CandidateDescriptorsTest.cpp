// View descriptors from measurements on the GPU, against closed forms and against placement's own measures.

#include <cmath>
#include <cstring>

#include "rendering/placement/FocusViews.h"
#include "tests/placement/CandidateTesting.h"

namespace fenestra::placement::candidateDescriptorsTest {
namespace {

/// Square pixels inside outlines: the sum of the signed areas of polygons, where holes run the other way round.
double areaWithin(const std::vector<std::vector<glm::dvec2>>& outlines) {
  double area = 0.0;
  for (const std::vector<glm::dvec2>& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
      area += 0.5 * (a.x * b.y - a.y * b.x);
    }
  return area;
}

/// A ring and a ball beside it, with voxels of three sizes.
Scene ringAndBall() {
  const Grid grid = gridOf({52, 48, 30}, {0.9, 1.0, 1.4});
  const auto inRing = [](glm::dvec3 p) {
    return glm::length(glm::dvec2(glm::length(glm::dvec2(p) - glm::dvec2(24.0, 22.0)) - 14.0, p.z - 20.0)) < 4.0;
  };
  Scene scene = labelScene(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = glm::dvec3(i) * grid.spacing;
    return glm::distance(p, glm::dvec3(40.0, 40.0, 10.0)) < 5.0 ? 2 : inRing(p) ? 1 : 0;
  });
  scene.look.focus = LabelFocus{{1, 2}};
  return scene;
}

class DescriptorsTest : public CandidateTest {
 protected:
  DescribedViews described(const Scene& scene, const Sampling& sampling = {}) {
    measured_ = placer_.measure(gpu(), scene, sampling, {});
    return describeViews(gpu(), scene, measured_, sampling, true);
  }
  const Measured& measured() const { return measured_; }

 private:
  Placer placer_;
  Measured measured_;
};

TEST_F(DescriptorsTest, AnImageIsTheOneThatPlacementMeasures) {
  Scene scene = ringAndBall();
  for (const bool clipped : {false, true}) {
    const glm::dvec3 normal(0.6, 0.0, 0.8);
    scene.look.clipping = {};
    if (clipped) scene.look.clipping.planes = {{normal, glm::dot(normal, scene.volume->grid.centre())}};
    gpu().update(scene);
    const std::vector<HalfSpace> kept = halfSpaces(scene.look.clipping, gpu().grid());
    ASSERT_EQ(kept.empty(), !clipped);
    CandidateImages images;
    const std::vector<glm::dvec3> directions = ringDirections(2);
    const std::vector<Candidate> before = images.measure(gpu(), directions, {}, side, false, kept);
    bool hasHole = false;
    for (const Candidate& candidate : before) {
      const FocusImage image = images.image(gpu(), candidate.direction, side, kept);
      const auto outlines = outlinesOf(image);
      // The candidate sums the same polygons in single precision.
      EXPECT_NEAR(areaWithin(outlines), candidate.sums.count, 1e-5 * candidate.sums.count);
      double depth = 0.0, pixels = 0.0;
      for (const float each : image.depth)
        if (!std::isnan(each)) {
          depth += each;
          ++pixels;
        }
      const double diameter = 2.0 * gpu().grid().boundingRadius();
      EXPECT_DOUBLE_EQ(image.pixel, diameter / side);
      // A mean over whole pixels and one over parts of them differ by the pixels of the outline, whose depths differ
      // from the mean by up to the focus's radius: a few hundredths of that here.
      EXPECT_NEAR(depth / pixels / diameter + 0.5, candidate.descriptors.visibility, 0.02);
      for (const auto& outline : outlines) hasHole = hasHole || areaWithin({outline}) < 0.0;
    }
    EXPECT_TRUE(hasHole || clipped);
    const std::vector<Candidate> after = images.measure(gpu(), directions, {}, side, false, kept);
    for (std::size_t i = 0; i < directions.size(); ++i)
      EXPECT_EQ(std::memcmp(&before[i].sums, &after[i].sums, sizeof(ImageSums)), 0) << i;
  }
}

TEST_F(DescriptorsTest, ABallInClosedForm) {
  const Grid grid = gridOf({64, 60, 56});
  const glm::dvec3 centre(28.3, 33.1, 26.4);
  const double r = 13.0;
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 i) { return r - glm::length(glm::dvec3(i) - centre); }, 0.0);
  Sampling sampling;
  sampling.count = 48;
  const DescribedViews views = described(scene, sampling);
  // Bins of depths as in the test of a ball on the CPU: bin k of 16 has (2k + 1)/256.
  std::vector<double> shares;
  for (int k = 0; k < 16; ++k) shares.push_back((2.0 * k + 1.0) / 256.0);
  const std::vector<double> depths = views.values(ViewDescriptor::DepthDistribution),
                            lengths = views.values(ViewDescriptor::SilhouetteLength),
                            turnings = views.values(ViewDescriptor::SilhouetteCurvature),
                            entropies = views.values(ViewDescriptor::Entropy),
                            curvatures = views.values(ViewDescriptor::CurvatureEntropy),
                            stabilities = views.values(ViewDescriptor::Stability);
  const double diameter = 2.0 * grid.boundingRadius();
  for (std::size_t v = 0; v < 48; ++v) {
    // 1000 pixels lie in bins of 4 to 120 pixels: counts scatter by their square roots or less. The ball around the
    // points is theirs, with a centre and a radius known to some tenths of a voxel.
    EXPECT_NEAR(depths[v], entropyOf(shares), 0.12);
    // Trilinear interpolation moves the surface inwards by up to (1/8)(2/r) voxels; chords, see ABallInClosedForm.
    EXPECT_NEAR(lengths[v], 2.0 * pi * r / diameter, 2.0 * pi * 0.03 / diameter);
    EXPECT_NEAR(turnings[v], 2.0 * pi, 0.05);
    // The limits are those of evenly spread points with exact normals (ViewDescriptorsTest). Points of a surface are
    // spread less evenly than a lattice, and normals err by up to two degrees.
    const double points = static_cast<double>(measured().surfacePoints);
    EXPECT_NEAR(entropies[v], std::log2(0.5 * points) - 1.0 + 0.5 / std::log(2.0), 0.05);
    EXPECT_NEAR(stabilities[v], stabilities[0], 0.1);
    // Curvatures from normals of voxels scatter over neighbouring classes; all are those of convex surfaces.
    EXPECT_LT(curvatures[v], 3.0);
  }
  // A ball's views have the same share, p(v) = 1/48.
  for (std::size_t v = 0; v < 48; ++v) EXPECT_NEAR(views.channel().viewShare(v), 1.0 / 48.0, 0.05 / 48.0);
}

TEST_F(DescriptorsTest, ProjectedAreasOfPointsAreThoseOfImages) {
  // Without occlusion, an ellipsoid's points and its image have the same area.
  const Grid grid = gridOf({60, 60, 60});
  const glm::dvec3 centre(30.2, 28.7, 31.1), axes(22.0, 14.0, 9.0);
  const Scene scene = valueScene(
      grid, [&](glm::ivec3 i) { return 1.0 - glm::length((glm::dvec3(i) - centre) / axes); }, 0.0);
  const DescribedViews views = described(scene);
  double sum = 0.0;
  for (std::size_t v = 0; v < measured().spread; ++v) sum += measured().candidates[v].sums.count;
  for (std::size_t v = 0; v < measured().spread; ++v)
    // 1024 points, half of them seen, give areas to one or two hundredths.
    EXPECT_NEAR(views.channel().viewShare(v) * sum / measured().candidates[v].sums.count, 1.0, 0.04) << v;
}

TEST_F(DescriptorsTest, TwoStructuresAreEvenestWhereBothShowMost) {
  const DescribedViews views = described(ringAndBall());
  const std::vector<double> values = views.values(ViewDescriptor::StructureEntropy);
  const std::size_t best = choiceBy(ViewDescriptor::StructureEntropy, values).value();
  for (const double value : values) {
    EXPECT_GE(value, 0.0);
    EXPECT_LE(value, 1.0);
  }
  // The ring is the larger one: its share is least where it is seen edge-on, and the ball is not behind it.
  EXPECT_LT(std::abs(measured().candidates[best].direction.z), 0.4);
  for (const ViewDescriptorEntry& entry : viewDescriptors()) {
    const std::vector<double> all = views.values(entry.descriptor);
    ASSERT_EQ(all.size(), measured().spread);
    for (const double value : all) EXPECT_TRUE(std::isfinite(value)) << entry.name;
  }
}

TEST_F(DescriptorsTest, AFocusWithoutASurfaceHasNoDescriptors) {
  // It fills the volume.
  const Scene scene = labelScene(gridOf({12, 12, 12}), [](glm::ivec3) { return 1; });
  const DescribedViews views = described(scene);
  for (const ViewDescriptorEntry& entry : viewDescriptors())
    EXPECT_EQ(choiceBy(entry.descriptor, views.values(entry.descriptor)), std::nullopt) << entry.name;
}

}  // namespace
}  // namespace fenestra::placement::candidateDescriptorsTest
