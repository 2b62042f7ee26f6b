// Pictures whose pixels are smaller than the volume's voxels: rays are followed between those of a lattice only where
// the picture is not smooth. Tests what that costs in accuracy, that no detail is missed, and that parts of a picture
// are redrawn as in a new one.

#include <random>

#include "rendering/passes/FocusLayerPass.h"
#include "tests/gl/PassTest.h"

namespace fenestra::tests::adaptiveSamplingTest {
namespace {

using Sampling = FocusLayerPass::Sampling;
const std::array<Sampling, 3> lattices{Sampling{.pitch = 2}, Sampling{.pitch = 2, .quincunx = true},
                                       Sampling{.pitch = 4}};
std::string nameOf(const Sampling& sampling) {
  return (sampling.quincunx ? "quincunx, pitch " : "pitch ") + std::to_string(sampling.pitch);
}
bool isOnLattice(const Sampling& sampling, int i, int j) {
  return sampling.quincunx ? (i + j) % 2 == 0 : i % sampling.pitch == 0 && j % sampling.pitch == 0;
}

/// The focus layer of a scene without cutaway with rays on a lattice at least.
std::vector<glm::vec4> drawn(const Scene& scene, const Camera& camera, glm::ivec2 size, const Sampling& sampling) {
  GpuScene gpu;
  gpu.update(scene);
  gl::Texture layer = gl::Texture::make2D(gl::Format::RGBA32F, size);
  const gl::Region whole{glm::ivec2(0), size};
  runWhole(FocusLayerPass(), gpu, scene.look, RayFrame(camera, size, scene.volume->grid), std::nullopt, sampling,
           std::span(&whole, 1), layer);
  std::vector<glm::vec4> pixels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  layer.readInto(std::span(pixels));
  return pixels;
}

/// Differences between a picture by a lattice and one with a ray a pixel, in 1/255 of the worst channel, sorted.
struct Differences {
  std::vector<double> sorted;
  double rms = 0.0;
  double at(double share) const { return sorted[static_cast<std::size_t>(share * double(sorted.size() - 1))]; }
};

Differences differencesBy(const Sampling& lattice, const Scene& scene, const Camera& camera, glm::ivec2 size) {
  const std::vector<glm::vec4> every = drawn(scene, camera, size, {}), some = drawn(scene, camera, size, lattice);
  Differences result;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const std::size_t at = static_cast<std::size_t>(j * size.x + i);
      if (isOnLattice(lattice, i, j)) {
        EXPECT_EQ(every[at], some[at]) << "on the lattice: " << i << ", " << j;
      }
      const glm::vec4 off = glm::abs(every[at] - some[at]) * 255.0f;
      result.sorted.push_back(std::max({off.r, off.g, off.b, off.a}));
      result.rms += result.sorted.back() * result.sorted.back();
    }
  result.rms = std::sqrt(result.rms / static_cast<double>(result.sorted.size()));
  std::sort(result.sorted.begin(), result.sorted.end());
  return result;
}

/// A view in which a voxel of the middle is `pixels` wide, in a picture of about `height` rows.
Camera closeUp(const Grid& grid, double pixels, int height, Projection projection = Projection::Perspective) {
  Camera camera = Camera::fromAngles(33.0, 21.0, grid, projection);
  const double shown = height / pixels * finestSpacing(grid);
  const glm::dvec3 aside = camera.eye - camera.target;
  camera.orthographicHeight = shown;
  camera.eye = camera.target + glm::normalize(aside) * 0.5 * shown / std::tan(glm::radians(0.5 * camera.verticalFov));
  return camera;
}

Scene plain(std::shared_ptr<Volume> volume, const TransferFunction& context) {
  Scene scene;
  scene.volume = std::move(volume);
  scene.look.context.function = context;
  scene.look.shading.enabled = false;
  return scene;
}

/// Tissue that changes gently, around a ball with a hard surface.
Scene softAndHard() {
  const Grid grid = gridOf({40, 40, 40});
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) {
    const glm::dvec3 p = glm::dvec3(i) / 6.0;
    const double ball = glm::length(glm::dvec3(i) - glm::dvec3(22.0, 16.0, 20.0));
    return 300.0 + 120.0 * std::sin(p.x + 0.6 * p.z) * std::cos(p.y) + (ball < 8.0 ? 600.0 : 0.0);
  });
  scene.labels = labelsOf(
      grid, [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - glm::dvec3(22.0, 16.0, 20.0)) < 6.0 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = {{{200.0, {{0.9, 0.3, 0.2}, 0.0}},
                                  {400.0, {{0.9, 0.6, 0.3}, 0.03}},
                                  {650.0, {{0.9, 0.6, 0.3}, 0.03}},
                                  {650.0, {{0.9, 0.9, 0.8}, 1.5}}}};
  scene.look.cutaway.openWidth = 6.0;
  scene.look.cutaway.borderWidth = 2.0;
  return scene;
}

using AdaptiveSampling = GlTest;

TEST_F(AdaptiveSampling, Thorough_IsOffByAboutItsTolerance) {
  constexpr glm::ivec2 size{220, 200};
  for (const bool lit : {false, true})
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
      for (const Sampling& lattice : lattices) {
        Scene scene = softAndHard();
        scene.look.shading.enabled = lit;
        const Camera camera = closeUp(scene.volume->grid, lattice.pitch + 0.1, size.y, projection);
        const Differences off = differencesBy(lattice, scene, camera, size);
        const double tolerance = lit ? 1.5 : 1.0;
        EXPECT_LE(off.rms, 0.5 * tolerance) << lit << nameOf(lattice);
        EXPECT_LE(off.at(0.999), 3.0 * tolerance) << lit << nameOf(lattice);
      }
}

TEST_F(AdaptiveSampling, NothingAsLargeAsAVoxelSlipsThrough) {
  // Single voxels anywhere between the rays of the lattice.
  const Grid grid = gridOf({48, 48, 48});
  std::mt19937 random(7);
  const std::shared_ptr<Volume> volume = volumeOf<std::uint8_t>(grid, [](glm::ivec3) { return 0; });
  for (int k = 0; k < 60; ++k) {
    const glm::ivec3 at(randomIn(random, glm::dvec3(2.0), glm::dvec3(45.0)));
    volume->voxels.as<std::uint8_t>()[grid.offset(at)] = 255;
  }
  const Scene scene = plain(volume, {{{0.0, {glm::dvec3(1.0), 0.0}}, {255.0, {glm::dvec3(1.0), 0.4}}}});
  constexpr glm::ivec2 size{260, 240};
  for (const double voxel : {2.02, 2.9, 4.05}) {
    const Camera camera = closeUp(grid, voxel, size.y);
    const std::vector<glm::vec4> some = drawn(scene, camera, size, {.pitch = voxel < 4.0 ? 2 : 4});
    const std::vector<glm::vec4> every = drawn(scene, camera, size, {});
    // Each voxel's brightest pixel.
    for (int j = 2; j < size.y - 2; ++j)
      for (int i = 2; i < size.x - 2; ++i) {
        const auto at = [&](const std::vector<glm::vec4>& of, int x, int y) {
          return of[static_cast<std::size_t>(y * size.x + x)].a;
        };
        bool brightest = at(every, i, j) > 0.1f;
        float shown = 0.0f;
        for (int y = j - 2; y <= j + 2; ++y)
          for (int x = i - 2; x <= i + 2; ++x) {
            brightest = brightest && at(every, x, y) <= at(every, i, j);
            shown = std::max(shown, at(some, x, y));
          }
        if (brightest) {
          EXPECT_GT(shown, 0.9f * at(every, i, j)) << voxel << ": " << i << ", " << j;
        }
      }
  }
}

TEST_F(AdaptiveSampling, EdgesStayWhereTheyAre) {
  // An opaque ball's rim: a pixel is on it or not, and no interpolation may soften it.
  const Grid grid = gridOf({32, 32, 32});
  const std::shared_ptr<Volume> volume =
      volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return 1000.0 - 60.0 * glm::length(glm::dvec3(i) - 15.3); });
  const Scene scene = plain(volume, opaqueFrom(400.0));
  constexpr glm::ivec2 size{200, 180};
  for (const Sampling& lattice : lattices)
    EXPECT_LE(differencesBy(lattice, scene, closeUp(grid, lattice.pitch + 0.3, size.y), size).at(1.0), 2.0)
        << nameOf(lattice);
}

TEST_F(AdaptiveSampling, Thorough_PicturesOfAnySize) {
  Scene scene = softAndHard();
  scene.look.shading.enabled = false;
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(2, 1), glm::ivec2(1, 7), glm::ivec2(3, 3),
                                glm::ivec2(4, 5), glm::ivec2(33, 17), glm::ivec2(50, 51), glm::ivec2(131, 66)})
    for (const Sampling& lattice : lattices) {
      const Camera camera = closeUp(scene.volume->grid, lattice.pitch + 0.2, size.y);
      EXPECT_LE(differencesBy(lattice, scene, camera, size).at(1.0), 8.0)
          << size.x << "×" << size.y << ", " << nameOf(lattice);
    }
}

TEST_F(AdaptiveSampling, Exhaustive_PartsAreRedrawnAsInANewPicture) {
  constexpr glm::ivec2 size{300, 270};
  for (const double voxel : {2.2, 4.4})
    for (const Quality quality : {Quality::Draft, Quality::Normal}) {
      Scene scene = softAndHard();
      const View view{closeUp(scene.volume->grid, voxel, size.y), size, 1.0, quality};
      Renderer kept(std::make_shared<GpuScene>());
      kept.render(scene, view);
      const auto expectAsNew = [&](const char* what) {
        kept.render(scene, view);
        Renderer fresh(std::make_shared<GpuScene>());
        fresh.render(scene, view);
        EXPECT_TRUE(kept.readLayers().final == fresh.readLayers().final) << what << ", " << voxel;
      };
      for (const double width : {9.0, 3.0, 0.0, 6.0}) {
        scene.look.cutaway.openWidth = width;
        expectAsNew("opening");
      }
      BrushStroke stroke;
      stroke.radius = 9.0;
      for (const BrushMode mode : {BrushMode::Open, BrushMode::Restore})
        for (const glm::dvec2 pixel : {glm::dvec2(120.5, 130.5), glm::dvec2(150.5, 141.5), glm::dvec2(171.5, 118.5)}) {
          stroke.mode = mode;
          const auto point = kept.pickBrush(pixel, mode);
          ASSERT_TRUE(point);
          extend(stroke, point->anchor);
          scene.look.strokes = {stroke};
          expectAsNew("stroke");
        }
      scene.look.cutaway.openWidth = 8.0;
      expectAsNew("opening under a stroke");
      scene.look.strokes.clear();
      expectAsNew("strokes gone");
    }
}

TEST_F(AdaptiveSampling, TakesNoMemoryWhereEveryRayIsFollowed) {
  const Scene scene = softAndHard();
  constexpr glm::ivec2 size{200, 180};
  // Close enough to fill the picture.
  const Camera close = closeUp(scene.volume->grid, 6.0, size.y), far = closeUp(scene.volume->grid, 0.9, size.y);
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, {far, size});
  const std::size_t every = renderer.imageBytes();
  renderer.render(scene, {close, size});
  // Two pixels of 4 bytes for each 2×2, in whole groups of 8×8 of these, and the list's head.
  EXPECT_EQ(renderer.imageBytes(), every + 2 * 4 * 104 * 96 + 16);
  renderer.render(scene, {close, size, 1.0, Quality::High});
  EXPECT_EQ(renderer.imageBytes(), every);
}

}  // namespace
}  // namespace fenestra::tests::adaptiveSamplingTest
