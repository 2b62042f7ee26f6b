// Stage 1 alone, against the reference: every kind of focus and none, pictures of any size, windows of a picture.

#include "rendering/passes/HitPointPass.h"

#include "tests/gl/PassTest.h"

namespace fenestra::tests::hitPointPassTest {
namespace {

/// A bumpy body on an oblique grid of anisotropic voxels; a ball of label 1 in it.
Scene body() {
  const Grid grid = obliqueGrid({24, 18, 14});
  const glm::dvec3 centre = (glm::dvec3(grid.dims) - 1.0) * 0.5;
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = (glm::dvec3(i) - centre) / glm::dvec3(grid.dims) * 2.0;
    return 1000.0 * (1.0 - glm::length(p)) + 90.0 * std::sin(6.0 * p.x) * std::cos(5.0 * p.y + p.z);
  });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return glm::distance(glm::dvec3(i), centre) < 4.2 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(200.0);
  return scene;
}

Camera aside(const Scene& scene, Projection projection = Projection::Perspective) {
  return Camera::fromAngles(33.0, 21.0, scene.volume->grid, projection);
}

std::vector<glm::vec2> hitsOf(const Scene& scene, const Camera& camera, glm::ivec2 size, Schedule schedule) {
  GpuScene gpu;
  gpu.setSchedule(schedule);
  gpu.update(scene);
  gl::Texture image = blank<glm::vec2>(size);
  runWhole(HitPointPass(), gpu, RayFrame(camera, size, scene.volume->grid), image);
  return texelsOf<glm::vec2>(image);
}

void expectMatch(const std::vector<float>& positions, const RayFrame& rays, const reference::Image& truth, double voxel,
                 const char* name) {
  std::vector<double> errors;
  std::size_t differ = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double here = timeOf(positions[i], rays);
    if (std::isnan(here) != std::isnan(truth[i]))
      ++differ;
    else if (!std::isnan(here))
      errors.push_back(std::abs(here - truth[i]) / voxel);
  }
  std::sort(errors.begin(), errors.end());
  // Where a ray grazes a surface, rounding decides whether it meets it and moves the hit far along it: one pixel in a
  // thousand, as in the chain of passes. The others are off by 1e-3 voxel, which the method asks of refined hits.
  const std::size_t grazing = std::max<std::size_t>(1, truth.size() / 1000);
  EXPECT_LE(differ, grazing) << name;
  if (errors.size() > grazing) {
    EXPECT_LE(errors[errors.size() - 1 - grazing], 1e-3) << name;
  }
}

/// Returns how many rays meet the focus.
std::size_t expectHitsMatch(const Scene& scene, const Camera& camera, glm::ivec2 size) {
  const RayFrame rays(camera, size, scene.volume->grid);
  const reference::HitPoints truth = reference::hitPoints(scene, camera, size);
  for (const Schedule schedule : schedules) {
    SCOPED_TRACE(named(schedule, size));
    std::vector<float> context, focus;
    for (const glm::vec2 hit : hitsOf(scene, camera, size, schedule)) {
      context.push_back(hit.x);
      focus.push_back(hit.y);
    }
    expectMatch(context, rays, truth.tContext, finestSpacing(scene.volume->grid), "context");
    expectMatch(focus, rays, truth.tFocus, finestSpacing(scene.volume->grid), "focus");
  }
  return static_cast<std::size_t>(
      std::count_if(truth.tFocus.begin(), truth.tFocus.end(), [](double t) { return !std::isnan(t); }));
}

using HitPointPassTest = GlTest;

TEST_F(HitPointPassTest, LabelFocusInPicturesOfAnySize) {
  const Scene scene = body();
  for (const glm::ivec2 size : awkwardSizes)
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
      EXPECT_GT(expectHitsMatch(scene, aside(scene, projection), size), 0u) << "the picture's middle shows the focus";
}

TEST_F(HitPointPassTest, ValueFocus) {
  Scene scene = body();
  scene.look.focus = ValueFocus{{600.0, 800.0}, 0.0};
  EXPECT_GT(expectHitsMatch(scene, aside(scene), {101, 64}), 100u);
}

TEST_F(HitPointPassTest, InATransparentContextTheFirstHitIsTheFocus) {
  Scene scene = body();
  scene.look.context.function = opaqueFrom(1e6);
  constexpr glm::ivec2 size{33, 17};
  EXPECT_GT(expectHitsMatch(scene, aside(scene), size), 10u);
  for (const Schedule schedule : schedules)
    for (const glm::vec2 hit : hitsOf(scene, aside(scene), size, schedule)) EXPECT_EQ(hit.x, hit.y);
}

TEST_F(HitPointPassTest, AnEyeInsideTheVolume) {
  const Scene scene = body();
  const glm::dvec3 centre = scene.volume->grid.centre();
  EXPECT_GT(expectHitsMatch(scene, lookAt(centre + glm::dvec3(2.0, 1.0, 6.0), centre), {33, 17}), 10u);
}

TEST_F(HitPointPassTest, NoFocusAnywhere) {
  Scene none = body(), absent = body(), outside = body();
  none.look.focus = {};
  none.labels = nullptr;
  absent.look.focus = LabelFocus{{7}};  // a label that no voxel has
  outside.look.focus = ValueFocus{{5000.0, 6000.0}, 0.0};
  for (const Scene* scene : {&none, &absent, &outside}) {
    EXPECT_EQ(expectHitsMatch(*scene, aside(*scene), {33, 17}), 0u);
    for (const Schedule schedule : schedules) {
      std::size_t met = 0;
      for (const glm::vec2 hit : hitsOf(*scene, aside(*scene), {33, 17}, schedule)) {
        EXPECT_EQ(hit.y, nothing);
        met += isSomething(hit.x);
      }
      EXPECT_GT(met, 20u) << "the context is met";
    }
  }
}

TEST_F(HitPointPassTest, NothingAtAll) {
  Scene scene = body();
  scene.look.focus = {};
  scene.look.context.function = opaqueFrom(1e6);
  for (const Schedule schedule : schedules)
    for (const glm::vec2 hit : hitsOf(scene, aside(scene), {33, 17}, schedule)) EXPECT_EQ(hit, glm::vec2(nothing));
}

TEST_F(HitPointPassTest, FocusEverywhereIsMetAtTheBoxsEntry) {
  Scene scene = body();
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3) { return 1; });
  constexpr glm::ivec2 size{33, 17};
  const Camera camera = aside(scene);
  const RayFrame rays(camera, size, scene.volume->grid);
  for (const Schedule schedule : schedules) {
    const std::vector<glm::vec2> hits = hitsOf(scene, camera, size, schedule);
    std::size_t met = 0, differ = 0;
    for (std::size_t i = 0; i < hits.size(); ++i) {
      EXPECT_EQ(hits[i].x, hits[i].y);
      const auto span = reference::clip(reference::pixelRay(camera, size, pixelAt(i, size)), scene.volume->grid);
      differ += span.has_value() != isSomething(hits[i].y);
      if (!span || !isSomething(hits[i].y)) continue;
      // float32 in a box of some 60 mm around the rays' anchor.
      EXPECT_NEAR(timeOf(hits[i].y, rays), span->tIn, 1e-4);
      ++met;
    }
    EXPECT_LE(differ, 1u) << "a ray along the box's edge";
    EXPECT_GT(met, 50u);
  }
}

TEST_F(HitPointPassTest, WindowsShowTheSameAsTheWholePicture) {
  const Scene scene = body();
  constexpr glm::ivec2 size{41, 27}, window{11, 9};
  const Camera camera = aside(scene);
  const RayFrame rays(camera, size, scene.volume->grid);
  for (const Schedule schedule : schedules) {
    SCOPED_TRACE(nameOf(schedule));
    const std::vector<glm::vec2> all = hitsOf(scene, camera, size, schedule);
    GpuScene gpu;
    gpu.setSchedule(schedule);
    gpu.update(scene);
    HitPointPass pass;
    gl::Texture tiled = blank<glm::vec2>(size);
    runInTiles(pass, gpu, rays, tiled);
    EXPECT_TRUE(sameBits(texelsOf<glm::vec2>(tiled), all)) << "in tiles";
    // The last one reaches beyond the picture, where nothing is written.
    for (const glm::ivec2 origin : {glm::ivec2(0, 0), glm::ivec2(17, 9), glm::ivec2(35, 22)}) {
      gl::Texture image = blank<glm::vec2>(window);
      runWhole(pass, gpu, rays, image, origin);
      const std::vector<glm::vec2> shown = texelsOf<glm::vec2>(image);
      for (std::size_t i = 0; i < shown.size(); ++i) {
        const glm::ivec2 pixel = origin + pixelAt(i, window);
        const bool inside = glm::all(glm::lessThan(pixel, size));
        EXPECT_EQ(shown[i], inside ? all[offsetOf(pixel, size)] : glm::vec2(unwritten)) << pixel.x << ", " << pixel.y;
      }
    }
    gl::Texture single = blank<glm::vec2>(glm::ivec2(1));
    runWhole(pass, gpu, rays, single, size / 2);
    EXPECT_EQ(texelsOf<glm::vec2>(single)[0], all[offsetOf(size / 2, size)]);
    EXPECT_TRUE(isSomething(all[offsetOf(size / 2, size)].y));
  }
}

}  // namespace
}  // namespace fenestra::tests::hitPointPassTest
