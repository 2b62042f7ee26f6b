// The values that ClearView's lens reads of the context's surface, at given hits, against the reference.

#include "rendering/passes/LensPass.h"

#include "rendering/reference/Lens.h"
#include "tests/gl/PassTest.h"

namespace fenestra::tests::lensPassTest {
namespace {

/// A bumpy body of high values around a ball of label 1.
template <class T>
Scene body(const Grid& grid) {
  const glm::dvec3 centre = (glm::dvec3(grid.dims) - 1.0) * 0.5;
  Scene scene;
  scene.volume = volumeOf<T>(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = (glm::dvec3(i) - centre) / glm::dvec3(grid.dims) * 2.0;
    return 1000.0 * (1.0 - glm::length(p)) + 60.0 * std::sin(5.0 * p.x) * std::cos(4.0 * p.y + p.z);
  });
  scene.labels = labelsOf(
      grid, [&](glm::ivec3 i) { return glm::length((glm::dvec3(i) - centre) / glm::dvec3(grid.dims)) < 0.22 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(200.0);
  scene.look.contextLayer.strength = 0.0;
  scene.look.method.kind = kindOf<methods::ClearView>;
  return scene;
}

/// The pass's image, drawn as a whole; parts must give the same.
std::vector<glm::vec4> draw(const Scene& scene, const RayFrame& rays, const MadeHits& made, Schedule schedule) {
  GpuScene gpu;
  gpu.setSchedule(schedule);
  gpu.update(scene);
  const glm::ivec2 size = rays.size();
  const gl::Texture hits = imageOf(made.texels, size);
  // The pass itself finds where the line of sight to the focus's middle meets the context.
  const glm::dvec3 focus = reference::focusCentre(scene);
  LensPass pass;
  gl::Texture surface = blank<glm::vec4>(size);
  runWhole(pass, gpu, rays, hits, focus, whole(size), surface);
  const std::vector<glm::vec4> drawn = texelsOf<glm::vec4>(surface);
  const auto run = [&](const std::vector<gl::Region>& regions, gl::Texture& image) {
    runWhole(pass, gpu, rays, hits, focus, regions, image);
  };
  expectPartsMakeTheWhole(drawn, size, run);
  expectOnlyTheRegionIsWritten(drawn, size, run);
  return drawn;
}

struct Counts {
  int normals = 0, without = 0, nothing = 0;  ///< pixels with a normal; a surface without one; no surface
};

Counts expectLensMatches(const Scene& scene, const Camera& camera, const MadeHits& made, glm::ivec2 size,
                         double tolerance) {
  const RayFrame rays(camera, size, scene.volume->grid);
  std::vector<glm::ivec2> pixels;
  for (std::size_t i = 0; i < pixelsIn(size); ++i) pixels.push_back(pixelAt(i, size));
  const std::vector<reference::LensPoint> truth = reference::lensPoints(scene, camera, size, made.truth, pixels);
  Counts counts;
  for (const Schedule schedule : schedules) {
    SCOPED_TRACE(named(schedule, size));
    const std::vector<glm::vec4> drawn = draw(scene, rays, made, schedule);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      EXPECT_LT(glm::distance(glm::dvec3(drawn[i]), truth[i].normal), tolerance) << "normal at " << i;
      EXPECT_EQ(isSomething(drawn[i].w), !std::isnan(truth[i].distance)) << i;
      if (std::isnan(truth[i].distance)) {
        ++counts.nothing;
        continue;
      }
      // Roundings to float32 of positions within 100 mm, and the refined hit on the line of sight, within 1e-3 voxels.
      EXPECT_NEAR(drawn[i].w, truth[i].distance, 7e-4) << "distance at " << i;
      ++(truth[i].normal == glm::dvec3(0.0) ? counts.without : counts.normals);
    }
  }
  return counts;
}

/// As for the context layer: sums in float32 over a gradient of a fiftieth of the range per mm; values in 16 bits,
/// whose steps turn normals by 1e-3.
constexpr double inFloat = 2e-4, in16Bits = 1e-3;

using LensPassTest = GlTest;

/// The reference's stage 1, rounded as the pass reads it.
MadeHits hitsOf(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  const RayFrame rays(camera, size, scene.volume->grid);
  MadeHits made{{}, reference::hitPoints(scene, camera, size)};
  for (std::size_t i = 0; i < pixelsIn(size); ++i) {
    made.texels.emplace_back(positionOf(made.truth.tContext[i], rays), positionOf(made.truth.tFocus[i], rays));
    made.truth.tContext[i] = timeOf(made.texels[i].x, rays);
    made.truth.tFocus[i] = timeOf(made.texels[i].y, rays);
  }
  return made;
}

TEST_F(LensPassTest, PicturesOfAnySize) {
  const Scene scene = body<float>(gridOf({26, 22, 24}));
  for (const glm::ivec2 size : awkwardSizes)
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
      const Camera camera = Camera::fromAngles(33.0, 21.0, scene.volume->grid, projection);
      EXPECT_GT(expectLensMatches(scene, camera, hitsOf(scene, camera, size), size, inFloat).normals, 0);
    }
}

TEST_F(LensPassTest, ObliqueGridsFarFromTheOriginAndIntegers) {
  constexpr glm::ivec2 size{53, 35};
  Grid far = obliqueGrid({30, 20, 12});
  far.origin += 1e5;
  for (const Grid& grid : {obliqueGrid({30, 20, 12}), far}) {
    const Scene real = body<float>(grid), integer = body<std::int16_t>(grid);
    const Camera camera = Camera::fromAngles(33.0, 21.0, grid);
    EXPECT_GT(expectLensMatches(real, camera, hitsOf(real, camera, size), size, inFloat).normals, 20);
    EXPECT_GT(expectLensMatches(integer, camera, hitsOf(integer, camera, size), size, in16Bits).normals, 20);
  }
}

TEST_F(LensPassTest, WhereThereIsNoSurfaceOrNoNormal) {
  const Scene scene = body<float>(gridOf({26, 22, 24}, {1.4, 1.0, 1.5}));
  constexpr glm::ivec2 size{53, 35};
  const Camera camera = Camera::fromAngles(33.0, 21.0, scene.volume->grid);
  const RayFrame rays(camera, size, scene.volume->grid);
  const MadeHits made = hitsOf(scene, camera, size);
  const auto counts = [&](const auto& change) {
    MadeHits changed = made;
    for (std::size_t i = 0; i < pixelsIn(size); ++i) {
      change(changed.texels[i], i);
      changed.truth.tContext[i] = timeOf(changed.texels[i].x, rays);
      changed.truth.tFocus[i] = timeOf(changed.texels[i].y, rays);
    }
    return expectLensMatches(scene, camera, changed, size, inFloat);
  };
  const auto unchanged = [](glm::vec2&, std::size_t) {};
  const auto bare = [](glm::vec2& hit, std::size_t) { hit.x = hit.y; };
  const auto nearlyBare = [](glm::vec2& hit, std::size_t) { hit.x = isSomething(hit.y) ? hit.y - 0.4f : hit.y; };
  const auto before = [](glm::vec2& hit, std::size_t) { hit.x = isSomething(hit.y) ? hit.y - 0.6f : hit.y; };
  EXPECT_GT(counts(unchanged).normals, 20);
  EXPECT_GT(counts([](glm::vec2& hit, std::size_t) { hit.y = nothing; }).normals, 20) << "no focus";
  EXPECT_EQ(counts(bare).normals, 0);
  EXPECT_EQ(counts(nearlyBare).normals, 0) << "less than half a voxel before";
  EXPECT_GT(counts(before).normals, 20);
  const Counts begins = counts([&](glm::vec2& hit, std::size_t i) {
    const auto span = reference::clip(reference::pixelRay(camera, size, pixelAt(i, size)), scene.volume->grid);
    if (span) hit.x = positionOf(span->tIn + 0.4, rays);
  });
  EXPECT_EQ(begins.normals, 0) << "where the scan begins";
  EXPECT_GT(begins.without, 20);
}

}  // namespace
}  // namespace fenestra::tests::lensPassTest
