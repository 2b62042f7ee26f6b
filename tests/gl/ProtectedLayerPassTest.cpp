// The layer of protected labels within the opening, alone: against the reference and a closed form.

#include "rendering/passes/ProtectedLayerPass.h"

#include "rendering/reference/Picture.h"
#include "tests/gl/MadeOpening.h"

namespace fenestra::tests::protectedLayerPassTest {
namespace {

using Sampling = FocusLayerPass::Sampling;
using ProtectedLayerPassTest = GlTest;

/// The waves with a tube of label 2 that crosses the opening, partly behind the focus.
Scene tubeInWaves(bool lit) {
  Scene scene = waves(lit);
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) {
    if (glm::distance(glm::dvec3(i), glm::dvec3(11.0, 8.0, 9.5)) < 4.0) return 1;
    return glm::length(glm::dvec2(i.y - 4 - 0.3 * i.x, i.z - 12)) < 2.5 ? 2 : 0;
  });
  put(scene.look.labels, {.label = 2, .role = LabelRole::Protected});
  return scene;
}

/// The pass alone, after the reference's stages 1 to 4.
class Drawing {
 public:
  Drawing(const Scene& scene, const Camera& camera, glm::ivec2 size, Schedule schedule, const MadeOpening& made)
      : look_(scene.look),
        size_(size),
        rays_(camera, size, scene.volume->grid),
        hits_(imageOf(made.hits, size)),
        starts_(imageOf(made.starts, size)) {
    gpu_.setSchedule(schedule);
    gpu_.update(scene);
  }

  void run(const Sampling& sampling, std::span<const gl::Region> regions, gl::Texture& image) {
    runWhole(pass_, gpu_, look_, rays_, FocusLayerPass::RayStarts{hits_, starts_}, sampling, regions, image);
  }
  std::vector<glm::vec4> pixels(const Sampling& sampling) {
    gl::Texture image = blank<glm::vec4>(size_);
    run(sampling, whole(size_), image);
    return texelsOf<glm::vec4>(image);
  }

 private:
  GpuScene gpu_;
  Look look_;
  glm::ivec2 size_;
  RayFrame rays_;
  gl::Texture hits_, starts_;
  ProtectedLayerPass pass_;
};

double greatestOpacity(const std::vector<glm::dvec4>& colours) {
  double most = 0.0;
  for (const glm::dvec4& colour : colours) most = std::max(most, colour.a);
  return most;
}

TEST_F(ProtectedLayerPassTest, Thorough_IsTheReferencesInBothSchedules) {
  for (const bool lit : {false, true}) {
    const Scene scene = tubeInWaves(lit);
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
      for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(41, 1), glm::ivec2(61, 47)}) {
        const Camera camera = aside(scene, projection);
        const MadeOpening made(scene, camera, size);
        const std::vector<glm::dvec4> truth = reference::picture(scene, camera, size, made.truth, {}).protectedLayer;
        if (size.x == 61) {
          EXPECT_GT(greatestOpacity(truth), 0.1) << "there is something to compare";
        }
        for (const Schedule schedule : schedules) {
          SCOPED_TRACE(named(schedule, size) + (lit ? ", lit" : ", unlit"));
          Drawing drawing(scene, camera, size, schedule, made);
          // Half of the bound that is asked for; without one, half of the coarsest.
          EXPECT_LE(errorsOf(drawing.pixels({.maxError = 0.5 / 255.0}), truth).worst, 0.25);
          EXPECT_LE(errorsOf(drawing.pixels({}), truth).worst, 2.0);
        }
      }
  }
}

TEST_F(ProtectedLayerPassTest, ASlabInAnEvenMediumFollowsBeersLaw) {
  // Along y: a slab of 3 voxels before the focus, in a uniform medium.
  constexpr double extinction = 0.07, spacing = 1.2;
  Scene scene = waves(false);
  const OpticalProperties even{{0.9, 0.5, 0.2}, extinction};
  scene.look.context.function = {{{0.0, even}, {1000.0, even}}};
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) { return i.y >= 12 ? 1 : i.y >= 4 && i.y < 7 ? 2 : 0; });
  constexpr glm::ivec2 size{33, 17};
  const Camera camera = Camera::standard(StandardView::Anterior, scene.volume->grid, Projection::Orthographic);
  put(scene.look.labels, {.label = 2, .role = LabelRole::Protected});
  const MadeOpening made(scene, camera, size);
  const glm::dvec4 expected = (1.0 - std::exp(-extinction * 3.0 * spacing)) * glm::dvec4(even.colour, 1.0);
  std::vector<glm::dvec4> truth;
  for (const glm::vec2& hit : made.hits) truth.push_back(isSomething(hit.x) ? expected : glm::dvec4(0.0));
  EXPECT_GT(greatestOpacity(truth), 0.2);
  const std::vector<glm::dvec4> reference = reference::picture(scene, camera, size, made.truth, {}).protectedLayer;
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_LT(glm::distance(reference[i], truth[i]), 1e-6);
  for (const Schedule schedule : schedules)
    // A handful of pieces, each with an exponential in float32.
    EXPECT_LE(errorsOf(Drawing(scene, camera, size, schedule, made).pixels({.maxError = 0.5 / 255.0}), truth).worst,
              0.01);
}

TEST_F(ProtectedLayerPassTest, IsNothingWhereNothingIsRemoved) {
  const Scene scene = tubeInWaves(true);
  constexpr glm::ivec2 size{33, 17};
  const Camera camera = aside(scene);
  MadeOpening made(scene, camera, size);
  for (std::size_t i = 0; i < made.starts.size(); ++i) made.starts[i] = made.hits[i].x;
  for (const Schedule schedule : schedules)
    for (const glm::vec4 pixel : Drawing(scene, camera, size, schedule, made).pixels({.maxError = 0.5 / 255.0}))
      EXPECT_EQ(pixel, glm::vec4(0.0f));
}

TEST_F(ProtectedLayerPassTest, PartsMakeTheWhole) {
  const Scene scene = tubeInWaves(true);
  for (const glm::ivec2 size : awkwardSizes) {
    const Camera camera = aside(scene);
    const MadeOpening made(scene, camera, size);
    for (const Schedule schedule : schedules) {
      SCOPED_TRACE(named(schedule, size));
      Drawing drawing(scene, camera, size, schedule, made);
      const auto run = [&](const std::vector<gl::Region>& regions, gl::Texture& image) {
        drawing.run({}, regions, image);
      };
      expectPartsMakeTheWhole(drawing.pixels({}), size, run);
      expectOnlyTheRegionIsWritten(drawing.pixels({}), size, run);
    }
  }
}

}  // namespace
}  // namespace fenestra::tests::protectedLayerPassTest
