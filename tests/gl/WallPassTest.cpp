// Slices that stand as walls, over pictures, hits and starts that are given, against the reference.

#include "rendering/passes/WallPass.h"

#include "rendering/reference/Walls.h"
#include "tests/gl/PassTest.h"

namespace fenestra::tests::wallPassTest {
namespace {

constexpr glm::ivec2 size{73, 58};

/// Smooth values and a few labels with outlines.
template <class T>
Scene slicesOf(const Grid& grid, WallPlacement placement) {
  const glm::dvec3 middle = (glm::dvec3(grid.dims) - 1.0) * 0.5;
  Scene scene;
  scene.volume = volumeOf<T>(grid, [&](glm::ivec3 i) {
    return 100.0 + 60.0 * std::sin(0.4 * i.x + 0.2 * i.y) * std::cos(0.3 * i.z - 0.1 * i.y) + i.x;
  });
  const auto labels = labelsOf(grid, [&](glm::ivec3 i) {
    const double r = glm::length((glm::dvec3(i) - middle) / middle);
    return r < 0.3 ? 1 : r < 0.6 ? 2 : i.x < 5 && i.y < 9 ? 7 : 0;
  });
  labels->labels = {{1, "one", {1.0, 0.4, 0.2}}, {2, "two", {0.2, 0.5, 1.0}}};
  scene.labels = labels;
  scene.look.focus = LabelFocus{{1}};
  scene.look.method = methods::Walls{.placement = placement};
  return scene;
}

/// Premultiplied noise, of any opacity.
std::vector<glm::vec4> madePicture() {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  std::vector<glm::vec4> picture;
  for (std::size_t i = 0; i < pixelsIn(size); ++i) {
    const float a = share(random);
    picture.emplace_back(a * share(random), a * share(random), a * share(random), a);
  }
  return picture;
}

struct Made {
  MadeHits hits;
  std::vector<float> starts;  ///< positions; between the context's hit and a focus's, or somewhat behind the former
};
Made madeOpening(const Camera& camera, const Grid& grid) {
  Made made{madeHits(camera, size, grid, Where::Somewhere), {}};
  std::mt19937 random(9);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  const float reach = static_cast<float>(grid.boundingRadius());
  for (const glm::vec2& hit : made.hits.texels)
    made.starts.push_back(isSomething(hit.y)   ? hit.y
                          : isSomething(hit.x) ? hit.x + std::max(0.0f, 1.6f * share(random) - 0.4f) * reach
                                               : nothing);
  return made;
}

std::vector<glm::dvec4> truthOf(const Scene& scene, const Camera& camera, const ShownSlices& slices, const Made* made) {
  const RayFrame frame(camera, size, scene.volume->grid);
  std::vector<reference::WallRay> rays;
  for (std::size_t i = 0; i < pixelsIn(size); ++i) {
    rays.push_back({reference::pixelRay(camera, size, pixelAt(i, size)), {}});
    if (!made) continue;
    const double context = timeOf(made->hits.texels[i].x, frame), start = timeOf(made->starts[i], frame);
    const bool isOpen = std::isnan(made->hits.truth.tFocus[i]) && start > context;
    rays.back().shown = isOpen ? reference::Span{context, start} : reference::Span{1.0, 0.0};
  }
  return reference::wallColours(scene, camera, size, slices, rays);
}

/// Rounding decides on pixels whose rays run along a wall or end at it: four in a thousand.
void expectNear(const std::vector<glm::vec4>& here, const std::vector<glm::dvec4>& truth, double tolerance) {
  ASSERT_EQ(here.size(), truth.size());
  std::size_t off = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const glm::dvec4 error = glm::abs(glm::dvec4(here[i]) - truth[i]);
    off += !(std::max({error.r, error.g, error.b, error.a}) <= tolerance);
  }
  EXPECT_LE(1000 * off, 4 * truth.size()) << off << " of " << truth.size();
}

class WallPassTest : public GlTest {
 protected:
  /// Returns the share of pixels with a wall.
  static double expectMatches(const Scene& scene, const Camera& camera, const ShownSlices& slices, double tolerance) {
    const bool inside = scene.look.method.of<methods::Walls>().placement == WallPlacement::Inside;
    const Made made = madeOpening(camera, scene.volume->grid);
    const std::vector<glm::vec4> picture = madePicture();
    const std::vector<glm::dvec4> walls = truthOf(scene, camera, slices, inside ? &made : nullptr);
    std::vector<glm::dvec4> laid;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const glm::dvec4 front = inside ? walls[i] : glm::dvec4(picture[i]),
                       behind = inside ? glm::dvec4(picture[i]) : walls[i];
      laid.push_back(front + (1.0 - front.a) * behind);
      shown += walls[i].a > 0.0;
    }
    const RayFrame rays(camera, size, scene.volume->grid);
    for (const Schedule schedule : schedules) {
      SCOPED_TRACE(named(schedule, size));
      GpuScene gpu;
      gpu.setSchedule(schedule);
      gpu.update(scene);
      const gl::Texture below = imageOf(picture, size), hits = imageOf(made.hits.texels, size),
                        starts = imageOf(made.starts, size);
      std::optional<WallPass::OpenedSpace> opening;
      if (inside) opening.emplace(WallPass::OpenedSpace{hits, starts});
      WallPass pass;
      const auto draw = [&](const std::vector<gl::Region>& regions, gl::Texture& layer, gl::Texture& image) {
        runWhole(pass, gpu, scene, slices, rays, opening, below, regions, WallPass::Outputs{layer, image});
      };
      gl::Texture layer = blank<glm::vec4>(size), image = blank<glm::vec4>(size);
      draw(whole(size), layer, image);
      expectNear(texelsOf<glm::vec4>(layer), walls, tolerance);
      expectNear(texelsOf<glm::vec4>(image), laid, tolerance);
      const auto run = [&](const std::vector<gl::Region>& regions, gl::Texture& part) {
        gl::Texture other = blank<glm::vec4>(size);
        draw(regions, other, part);
      };
      const std::vector<glm::vec4> drawn = texelsOf<glm::vec4>(image);
      expectPartsMakeTheWhole(drawn, size, run);
      expectOnlyTheRegionIsWritten(drawn, size, run);
    }
    return static_cast<double>(shown) / static_cast<double>(walls.size());
  }
};

/// Places in float32 to some 1e-5 voxels, over greys that change by up to 1/4 a voxel and lines by 1 over half a voxel
/// or a pixel's width.
constexpr double tolerance = 2e-4;

TEST_F(WallPassTest, AroundAndInsideInBothProjections) {
  const Grid grid = gridOf({30, 26, 22}, {1.0, 1.2, 1.4}, {5.0, -9.0, 3.0});
  const ShownSlices slices{.crosshair = grid.centre() + glm::dvec3(3.0, -4.0, 2.0),
                           .window = WindowLevel{120.0, 100.0}};
  for (const WallPlacement placement : {WallPlacement::Around, WallPlacement::Inside})
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
      for (const glm::dvec2 from : {glm::dvec2(35.0, 25.0), glm::dvec2(-110.0, -40.0)}) {
        SCOPED_TRACE(testing::Message() << int(placement) << ", " << from.x);
        const Scene scene = slicesOf<std::int16_t>(grid, placement);
        // A part of the walls around lies behind the volume.
        EXPECT_GT(expectMatches(scene, Camera::fromAngles(from.x, from.y, grid, projection), slices, tolerance),
                  placement == WallPlacement::Around ? 0.3 : 0.03);
      }
}

TEST_F(WallPassTest, OfEveryKindOfVoxelAndGrid) {
  Grid sheared = obliqueGrid({24, 20, 18});
  sheared.direction[2] = glm::normalize(sheared.direction[2] + 0.3 * sheared.direction[1]);
  for (const WallPlacement placement : {WallPlacement::Around, WallPlacement::Inside})
    for (const Grid& grid : {sheared, gridOf({24, 20, 18}, {0.05, 0.05, 10.0}, {1e6, -1e6, 1e6}), gridOf({1, 9, 8})}) {
      SCOPED_TRACE(testing::Message() << int(placement) << ", " << grid.origin.x);
      Scene scene = slicesOf<float>(grid, placement);
      const Camera camera = Camera::fromAngles(25.0, 15.0, grid);
      expectMatches(scene, camera, {}, tolerance);
      // A spline is walked as a finer grid; walls show the voxels.
      scene.look.reconstruction = Reconstruction::Cubic;
      expectMatches(scene, camera, {}, tolerance);
    }
}

TEST_F(WallPassTest, BrightAndDarkAndOfSingleSlices) {
  const Grid grid = gridOf({20, 18, 16});
  Scene scene = slicesOf<std::uint8_t>(grid, WallPlacement::Around);
  const Camera camera = Camera::fromAngles(35.0, 25.0, grid);
  expectMatches(scene, camera, {.inverted = true}, tolerance);
  scene.look.method.of<methods::Walls>().axial = scene.look.method.of<methods::Walls>().outlines = false;
  const double two = expectMatches(scene, camera, {}, tolerance);
  scene.look.method.of<methods::Walls>().coronal = false;
  const double one = expectMatches(scene, camera, {}, tolerance);
  EXPECT_LT(one, two);
  scene.look.method.of<methods::Walls>().sagittal = false;
  EXPECT_EQ(expectMatches(scene, camera, {}, tolerance), 0.0) << "none is on";
}

/// Far away, narrow windows, and voxels that are no numbers.
TEST_F(WallPassTest, OfUnusualValuesFromFarAway) {
  const Grid grid = gridOf({20, 18, 16});
  Scene scene = slicesOf<float>(grid, WallPlacement::Around);
  scene.volume = volumeOf<float>(grid, [](glm::ivec3 i) {
    return i.x < 4 ? nan : i.y < 3 ? infinity : i.z < 3 ? -infinity : i.x == 10 ? 1e30 : 1000.0 + 0.01 * i.y;
  });
  Camera camera = Camera::fromAngles(35.0, 25.0, grid);
  // A value of 1e30 fades to white within 1e-27 of a voxel, and rounding decides where.
  expectMatches(scene, camera, {.window = WindowLevel{1.0, 1000.0}}, tolerance);
  scene = slicesOf<float>(grid, WallPlacement::Around);
  const glm::dvec3 towards = glm::normalize(camera.eye - grid.centre());
  camera.verticalFov *= glm::distance(camera.eye, grid.centre()) / 1e6;
  camera.eye = grid.centre() + 1e6 * towards;
  EXPECT_GT(expectMatches(scene, camera, {}, 2e-3), 0.3) << "at such a distance rays are rounded to 1e-3 voxels";
}

}  // namespace
}  // namespace fenestra::tests::wallPassTest
