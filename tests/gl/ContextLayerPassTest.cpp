// Stage 6 alone, against the reference: curvature, light, value and silhouette of hits that are given, and where there
// is no surface to draw.

#include "rendering/passes/ContextLayerPass.h"

#include "rendering/reference/ContextLayer.h"
#include "tests/gl/PassTest.h"

namespace fenestra::tests::contextLayerPassTest {
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
  scene.look.contextLayer.strength = 0.7;
  return scene;
}

Camera aside(const Scene& scene, Projection projection = Projection::Perspective) {
  return Camera::fromAngles(33.0, 21.0, scene.volume->grid, projection);
}

/// The reference's stage 1 as the pass reads it, and rounded for the reference.
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

struct Drawn {
  std::vector<glm::vec4> layer;  ///< value real
  std::vector<float> silhouette;
};

/// The pass's images, drawn as a whole; parts must give the same.
Drawn draw(const Scene& scene, const Camera& camera, const MadeHits& made, glm::ivec2 size, Schedule schedule) {
  GpuScene gpu;
  gpu.setSchedule(schedule);
  gpu.update(scene);
  const RayFrame rays(camera, size, scene.volume->grid);
  const gl::Texture hits = imageOf(made.texels, size);
  ContextLayerPass pass;
  gl::Texture layer = blank<glm::vec4>(size), silhouette = blank<float>(size);
  runWhole(pass, gpu, scene.look.shading, rays, hits, whole(size), layer, silhouette);
  Drawn drawn{texelsOf<glm::vec4>(layer), texelsOf<float>(silhouette)};
  const auto runLayer = [&](const std::vector<gl::Region>& regions, gl::Texture& image) {
    runWhole(pass, gpu, scene.look.shading, rays, hits, regions, image, silhouette);
  };
  const auto runSilhouette = [&](const std::vector<gl::Region>& regions, gl::Texture& image) {
    runWhole(pass, gpu, scene.look.shading, rays, hits, regions, layer, image);
  };
  expectPartsMakeTheWhole(drawn.layer, size, runLayer);
  expectPartsMakeTheWhole(drawn.silhouette, size, runSilhouette);
  expectOnlyTheRegionIsWritten(drawn.layer, size, runLayer);
  expectOnlyTheRegionIsWritten(drawn.silhouette, size, runSilhouette);
  for (glm::vec4& texel : drawn.layer)
    texel.w = static_cast<float>(gpu.volume().slope * static_cast<double>(texel.w) + gpu.volume().offset);
  return drawn;
}

/// Returns at how many pixels there is a surface that bends. `tolerance` of curvatures (1/mm), light and silhouette;
/// the value's is relative to the range.
std::size_t expectLayerMatches(const Scene& scene, const Camera& camera, const MadeHits& made, glm::ivec2 size,
                               double tolerance) {
  std::vector<reference::Ray> rays;
  for (std::size_t i = 0; i < pixelsIn(size); ++i) rays.push_back(reference::pixelRay(camera, size, pixelAt(i, size)));
  const auto truth = reference::contextLayer(scene, camera, rays, made.truth.tContext, made.truth.tFocus);
  const double range = scene.volume->range.high - scene.volume->range.low;
  for (const Schedule schedule : schedules) {
    SCOPED_TRACE(named(schedule, size));
    const Drawn drawn = draw(scene, camera, made, size, schedule);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const bool isSurface = isSomething(drawn.layer[i].x);
      EXPECT_EQ(isSurface, truth[i].has_value()) << "pixel " << i;
      if (!isSurface) {
        EXPECT_EQ(drawn.silhouette[i], 0.0f) << "pixel " << i;
      }
      if (!isSurface || !truth[i]) continue;
      EXPECT_NEAR(drawn.layer[i].x, truth[i]->k1, tolerance) << "k1 at " << i;
      EXPECT_NEAR(drawn.layer[i].y, truth[i]->k2, tolerance) << "k2 at " << i;
      EXPECT_NEAR(drawn.layer[i].z, truth[i]->illumination, tolerance) << "illumination at " << i;
      EXPECT_NEAR(drawn.layer[i].w, truth[i]->value, 1e-5 * range) << "value at " << i;
      EXPECT_NEAR(drawn.silhouette[i], truth[i]->silhouette, tolerance) << "silhouette at " << i;
    }
  }
  return static_cast<std::size_t>(std::count_if(
      truth.begin(), truth.end(), [](const auto& point) { return point && (point->k1 != 0.0 || point->k2 != 0.0); }));
}

/// A float volume stays float32: some hundred products and sums, then quotients by a gradient of a fiftieth of the
/// range per mm.
constexpr double inFloat = 2e-4;
/// Values in 16 bits, steps of 1/65535 of the range: against such gradients that turns normals by 1e-3 and shifts
/// second derivatives by as much.
constexpr double in16Bits = 1e-3;

using ContextLayerPassTest = GlTest;

TEST_F(ContextLayerPassTest, PicturesOfAnySize) {
  const Scene scene = body<float>(gridOf({26, 22, 24}));
  for (const glm::ivec2 size : awkwardSizes)
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
      const Camera camera = aside(scene, projection);
      EXPECT_GT(expectLayerMatches(scene, camera, hitsOf(scene, camera, size), size, inFloat), 0u);
    }
}

TEST_F(ContextLayerPassTest, ObliqueGridsThinnedAlongSomeAxesAndThinVolumes) {
  // Along its last axis the oblique grid is too coarse to be thinned; the other one has too few voxels there.
  for (const Grid& grid : {obliqueGrid({30, 20, 12}), gridOf({24, 22, 7}, {1.0, 1.1, 1.5}, {90.0, -7.0, 3.0})}) {
    const Scene real = body<float>(grid), integer = body<std::int16_t>(grid);
    constexpr glm::ivec2 size{53, 35};
    EXPECT_GT(expectLayerMatches(real, aside(real), hitsOf(real, aside(real), size), size, inFloat), 20u);
    EXPECT_GT(expectLayerMatches(integer, aside(integer), hitsOf(integer, aside(integer), size), size, in16Bits), 20u);
  }
}

TEST_F(ContextLayerPassTest, LightThatIsTurnedAside) {
  Scene scene = body<float>(gridOf({26, 22, 24}));
  scene.look.shading = {.ambient = 0.1, .diffuse = 0.5, .lightAzimuth = 70.0, .lightElevation = -30.0};
  constexpr glm::ivec2 size{53, 35};
  EXPECT_GT(expectLayerMatches(scene, aside(scene), hitsOf(scene, aside(scene), size), size, inFloat), 20u);
}

TEST_F(ContextLayerPassTest, NoSurfaceToDraw) {
  // The finest voxel is 1 mm, along one axis alone.
  const Scene scene = body<float>(gridOf({26, 22, 24}, {1.4, 1.0, 1.5}));
  constexpr glm::ivec2 size{53, 35};
  const Camera camera = aside(scene);
  const RayFrame rays(camera, size, scene.volume->grid);
  const MadeHits made = hitsOf(scene, camera, size);
  const auto surfaces = [&](const auto& change) {
    MadeHits changed = made;
    for (std::size_t i = 0; i < pixelsIn(size); ++i) {
      change(changed.texels[i], i);
      changed.truth.tContext[i] = timeOf(changed.texels[i].x, rays);
      changed.truth.tFocus[i] = timeOf(changed.texels[i].y, rays);
    }
    return expectLayerMatches(scene, camera, changed, size, inFloat);
  };
  EXPECT_GT(surfaces([](glm::vec2&, std::size_t) {}), 20u);
  EXPECT_EQ(surfaces([](glm::vec2& hit, std::size_t) { hit = glm::vec2(nothing); }), 0u);
  EXPECT_EQ(surfaces([](glm::vec2& hit, std::size_t) { hit.y = nothing; }), 0u) << "no focus";
  EXPECT_EQ(surfaces([](glm::vec2& hit, std::size_t) { hit.x = hit.y; }), 0u) << "a focus that lies bare";
  EXPECT_EQ(surfaces([](glm::vec2& hit, std::size_t) { hit.x = hit.y - 0.4f; }), 0u) << "less than half a voxel before";
  EXPECT_GT(surfaces([](glm::vec2& hit, std::size_t) {
              if (isSomething(hit.y)) hit.x = hit.y - 0.6f;
            }),
            20u);
  const auto behindTheFace = [&](double distance) {
    return surfaces([&](glm::vec2& hit, std::size_t i) {
      const auto span = reference::clip(reference::pixelRay(camera, size, pixelAt(i, size)), scene.volume->grid);
      if (span) hit.x = positionOf(span->tIn + distance, rays);
    });
  };
  EXPECT_EQ(behindTheFace(0.4), 0u) << "where the scan begins";
  EXPECT_EQ(behindTheFace(1.0), 0u) << "where the spline takes values from beyond the face";
  EXPECT_GT(behindTheFace(6.0), 20u);
}

TEST_F(ContextLayerPassTest, EvenValuesHaveNoSurface) {
  Scene scene = body<float>(gridOf({26, 22, 24}));
  constexpr glm::ivec2 size{53, 35};
  const Camera camera = aside(scene);
  const MadeHits made = hitsOf(scene, camera, size);
  // The coded values are zeros, whose derivatives are zero in float32 as well.
  scene.volume = volumeOf<std::int16_t>(scene.volume->grid, [](glm::ivec3) { return 700; });
  EXPECT_EQ(expectLayerMatches(scene, camera, made, size, inFloat), 0u);
}

TEST_F(ContextLayerPassTest, FocusEverywhereLiesBare) {
  Scene scene = body<float>(gridOf({26, 22, 24}));
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3) { return 1; });
  constexpr glm::ivec2 size{53, 35};
  EXPECT_EQ(expectLayerMatches(scene, aside(scene), hitsOf(scene, aside(scene), size), size, inFloat), 0u);
}

}  // namespace
}  // namespace fenestra::tests::contextLayerPassTest
