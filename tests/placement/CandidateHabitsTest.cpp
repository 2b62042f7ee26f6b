// Where the cameras go in scans with cut ends and in thin stacks, measured on the GPU.

#include "tests/placement/CandidateTesting.h"

namespace fenestra::placement::candidateHabitsTest {
namespace {

struct Cameras {
  glm::dvec3 c1, c2;
  double highest() const { return std::max(std::abs(c1.z), std::abs(c2.z)); }
};

class HabitsTest : public CandidateTest {
 protected:
  Cameras placed(const Scene& scene, const Options& options, bool joint, bool refined = false) {
    Sampling sampling;
    sampling.refined = refined;
    const Measured& measured = placer_.measure(gpu(), scene, sampling, options);
    const Placement placement = choose(measured, options, joint);
    return {measured.candidates[placement.c1.value()].direction, measured.candidates[placement.c2.value()].direction};
  }

 private:
  Placer placer_;
};

/// Tissue that fills the volume from bottom to top but not to the sides, with a flat organ across it, which shows most
/// from above and below.
Scene trunk(glm::ivec3 dims) {
  const Grid grid = gridOf(dims);
  const auto fromAxis = [=](glm::ivec3 i) {
    return glm::length((glm::dvec2(i.x, i.y) - 0.5 * glm::dvec2(dims.x - 1, dims.y - 1)) * glm::dvec2(1.0, 1.4));
  };
  const auto inOrgan = [=](glm::ivec3 i) { return fromAxis(i) < 9.0 && std::abs(i.z - dims.z / 2) < dims.z / 20 + 1; };
  Scene scene = labelScene(grid, [&](glm::ivec3 i) { return inOrgan(i) ? 1 : 0; });
  const auto volume = volumeOf<float>(grid, [&](glm::ivec3 i) { return fromAxis(i) < 0.35 * dims.x ? 40.0 : -1000.0; });
  volume->unit = "HU";
  scene.volume = volume;
  scene.look.context.function = opaqueFrom(-200.0);
  return scene;
}

const double limit = std::sqrt(0.5) + 1e-9;

TEST_F(HabitsTest, Thorough_NoCameraLooksThroughTheEndsOfACutTrunk) {
  const Scene scene = trunk({40, 40, 40});
  Options options;
  options.weights.endFace = 0.0;  // measured by what the context shows; here the habit is alone
  for (const bool joint : {false, true})
    for (const bool refined : {false, true}) {
      options.habits = {};
      EXPECT_LE(placed(scene, options, joint, refined).highest(), limit);
      options.habits = noHabits;
      EXPECT_GT(placed(scene, options, joint, refined).highest(), limit);
    }
}

TEST_F(HabitsTest, AFaceThatTheUserClippedIsNoCutEnd) {
  Scene scene = trunk({40, 40, 40});
  const auto cutsOf = [&](const Scene& of) {
    GpuScene gpu;
    const ScanShape scan = Placer().measure(gpu, of, {48}, {}).scan;
    return std::pair(scan.faces[2].cut, scan.faces[5].cut);  // S, I
  };
  EXPECT_EQ(cutsOf(scene), std::pair(1.0, 1.0));
  scene.look.clipping.planes = {{{0.0, 0.0, 1.0}, 4.0}};
  EXPECT_EQ(cutsOf(scene), std::pair(1.0, 0.0));
}

TEST_F(HabitsTest, AThinStackIsSeenFromBelow) {
  const Scene scene = trunk({40, 40, 3});
  Options options;
  for (const bool joint : {false, true}) {
    options.habits = {};
    const Cameras with = placed(scene, options, joint);
    EXPECT_LT(with.c1.z, -0.9);
    EXPECT_LT(with.c2.z, -0.45) << "60° from C1 is the least";
    if (!joint) continue;
    options.habits.flatFromFront = false;
    EXPECT_GT(placed(scene, options, joint).c1.z, -0.9);
  }
}

TEST_F(HabitsTest, TheyCostNoMeasurement) {
  const Scene scene = trunk({40, 40, 40});
  Placer placer;
  Options options;
  const Candidate* kept = placer.measure(gpu(), scene, {48}, options).candidates.data();
  options.habits = noHabits;
  EXPECT_EQ(placer.measure(gpu(), scene, {48}, options).candidates.data(), kept);
}

}  // namespace
}  // namespace fenestra::placement::candidateHabitsTest
