// The greatest value of the context along rays, alone: against the reference, over and under what the focus layer
// shows.

#include "rendering/passes/MaximumPass.h"

#include "rendering/reference/Maximum.h"
#include "tests/gl/MadeOpening.h"

namespace fenestra::tests::maximumPassTest {
namespace {

using MaximumPassTest = GlTest;

constexpr MethodStages::Maximum layer{.thickness = 4.0};
/// Values are rounded to float32 and the function rises by 0.15 over some 400 of them.
constexpr double tolerance = 0.02;  // 1/255

/// What the pass reads of an opening, and the same rays for the reference.
struct Rays {
  std::vector<reference::CutRay> truth;
  std::vector<glm::vec2> hits, holes;
  std::vector<float> starts;
};

/// From where a ray enters the volume, or from the opening.
Rays raysOf(const Scene& scene, const Camera& camera, glm::ivec2 size, bool opened) {
  Rays rays;
  const MadeOpening made(scene, camera, size);
  rays.hits = made.hits;
  rays.starts = made.starts;
  for (std::size_t i = 0; i < pixelsIn(size); ++i) {
    reference::CutRay& ray = rays.truth.emplace_back();
    ray.ray = reference::pixelRay(camera, size, pixelAt(i, size));
    const auto span = reference::clip(ray.ray, scene.volume->grid);
    ray.span = span.value_or(reference::Span{1.0, 0.0});
    if (!opened) continue;
    const double start = made.truth.tStart[i];
    ray.span =
        std::isnan(start) ? reference::Span{1.0, 0.0} : reference::Span{std::max(start, ray.span.tIn), ray.span.tOut};
  }
  return rays;
}

class Drawing {
 public:
  Drawing(const Scene& scene, const Camera& camera, glm::ivec2 size, Schedule schedule, const Rays& rays, bool opened)
      : rays_(camera, size, scene.volume->grid),
        size_(size),
        hits_(imageOf(rays.hits, size)),
        starts_(imageOf(rays.starts, size)),
        below_(imageOf(std::vector<glm::vec4>(pixelsIn(size)), size)) {
    gpu_.setSchedule(schedule);
    gpu_.update(scene);
    if (!rays.holes.empty()) holes_ = imageOf(rays.holes, size);
    if (opened) opening_.emplace(FocusLayerPass::RayStarts{hits_, starts_, holes_ ? &holes_ : nullptr});
  }
  void lieBeneath(const std::vector<glm::vec4>& focusLayer) { below_.upload(std::span(focusLayer)); }
  void run(std::span<const gl::Region> regions, gl::Texture& image, double leastTransmittance = 0.0) {
    runWhole(pass_, gpu_, layer, rays_, opening_, below_, leastTransmittance, regions, image);
  }
  std::vector<glm::vec4> pixels(double leastTransmittance = 0.0) {
    gl::Texture image = blank<glm::vec4>(size_);
    run(whole(size_), image, leastTransmittance);
    return texelsOf<glm::vec4>(image);
  }

 private:
  GpuScene gpu_;
  RayFrame rays_;
  glm::ivec2 size_;
  gl::Texture hits_, starts_, holes_, below_;
  std::optional<FocusLayerPass::RayStarts> opening_;
  MaximumPass pass_;
};

constexpr glm::ivec2 size{61, 47};

/// Compares with the reference in both schedules.
void expectMatches(const Scene& scene, bool opened, const std::string& what) {
  SCOPED_TRACE(what);
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    const Camera camera = aside(scene, projection);
    const Rays rays = raysOf(scene, camera, size, opened);
    const std::vector<glm::dvec4> truth = reference::maximumLayer(scene, rays.truth, layer);
    double most = 0.0;
    for (const glm::dvec4& colour : truth) most = std::max(most, colour.a);
    EXPECT_GT(most, 0.1) << "there is something to compare";
    for (const Schedule schedule : schedules)
      EXPECT_LE(errorsOf(Drawing(scene, camera, size, schedule, rays, opened).pixels(), truth).worst, tolerance)
          << named(schedule, size);
  }
}

TEST_F(MaximumPassTest, Thorough_IsTheReferences) {
  const Scene scene = waves(false);
  for (const bool opened : {false, true}) expectMatches(scene, opened, opened ? "opened" : "closed");
  Scene plain = scene;
  plain.look.focus = {};
  expectMatches(plain, false, "no focus");
  Scene byValue = scene;
  for (const ValueRange range : {ValueRange{600.0, 1e4}, ValueRange{-1e4, 450.0}}) {
    byValue.look.focus = ValueFocus{range, 0.0};
    expectMatches(byValue, false, "a focus of values from " + std::to_string(range.low));
  }
  Scene smoothed = scene;
  smoothed.look.labelSmoothing = LabelSmoothing::Strong;
  expectMatches(smoothed, true, "a smoothed focus");
}

TEST_F(MaximumPassTest, LeavesOutValuesThatDoNotShow) {
  Scene scene = waves(false);
  const glm::dvec3 grey(0.7);
  scene.look.context.function = {{{200.0, {grey, 0.0}},
                                  {350.0, {grey, 0.1}},
                                  {450.0, {grey, 0.0}},
                                  {600.0, {grey, 0.0}},
                                  {700.0, {glm::dvec3(0.2, 0.9, 0.3), 0.2}},
                                  {800.0, {grey, 0.0}}}};
  expectMatches(scene, true, "gaps of values");
}

/// Regions of one value each, at steps up and down: what ends in a step shows as below it, what begins in one as above.
TEST_F(MaximumPassTest, RegionsAtTheValueOfAStepShowAsTheReferences) {
  Scene scene = waves(false);
  scene.volume = volumeOf<std::int16_t>(scene.volume->grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = glm::dvec3(i) / 4.0;
    return 100.0 * std::floor(5.0 + 3.9 * std::sin(p.x + 0.7 * p.z) * std::cos(p.y - 0.4 * p.x));
  });
  const glm::dvec3 red(0.9, 0.2, 0.1), blue(0.1, 0.3, 0.8);
  scene.look.context.function = {
      {{200.0, {red, 0.0}}, {300.0, {red, 0.1}}, {300.0, {blue, 0.2}}, {600.0, {blue, 0.3}}, {600.0, {red, 0.0}}}};
  expectMatches(scene, true, "a step up and a step down");
}

TEST_F(MaximumPassTest, TakesTheFunctionsOfFaintLabels) {
  Scene scene = waves(false);
  scene.labels = labelsOf(scene.volume->grid, [](glm::ivec3 i) {
    return glm::distance(glm::dvec3(i), glm::dvec3(11.0, 8.0, 9.5)) < 4.0 ? 1 : i.x > 12 ? 2 : 0;
  });
  put(scene.look.labels, {.label = 2, .opacity = 0.4});
  expectMatches(scene, true, "a faint label");
}

TEST_F(MaximumPassTest, LeavesOutAHole) {
  const Scene scene = waves(false);
  const Camera camera = aside(scene);
  const RayFrame frame(camera, size, scene.volume->grid);
  Rays rays = raysOf(scene, camera, size, true);
  const std::vector<glm::dvec4> whole = reference::maximumLayer(scene, rays.truth, layer);
  for (reference::CutRay& ray : rays.truth) {
    glm::vec2 hole(1e30f);
    if (ray.span.tIn <= ray.span.tOut) {
      hole = {positionOf(glm::mix(ray.span.tIn, ray.span.tOut, 0.2), frame),
              positionOf(glm::mix(ray.span.tIn, ray.span.tOut, 0.7), frame)};
      ray.hole = {timeOf(hole.x, frame), timeOf(hole.y, frame)};
    }
    rays.holes.push_back(hole);
  }
  const std::vector<glm::dvec4> truth = reference::maximumLayer(scene, rays.truth, layer);
  EXPECT_NE(truth, whole);
  for (const Schedule schedule : schedules)
    EXPECT_LE(errorsOf(Drawing(scene, camera, size, schedule, rays, true).pixels(), truth).worst, tolerance);
}

TEST_F(MaximumPassTest, LiesBeneathTheFocusLayer) {
  const Scene scene = waves(false);
  const Camera camera = aside(scene);
  const Rays rays = raysOf(scene, camera, size, true);
  const std::vector<glm::dvec4> behind = reference::maximumLayer(scene, rays.truth, layer);
  std::vector<glm::vec4> focus;
  std::vector<glm::dvec4> truth;
  for (std::size_t i = 0; i < pixelsIn(size); ++i) {
    const float opacity = static_cast<float>(i % 4) / 3.0f;
    focus.push_back(opacity * glm::vec4(0.9f, 0.3f, 0.1f, 1.0f));
    truth.push_back(glm::dvec4(focus.back()) + (1.0 - focus.back().a) * behind[i]);
  }
  for (const Schedule schedule : schedules) {
    Drawing drawing(scene, camera, size, schedule, rays, true);
    drawing.lieBeneath(focus);
    EXPECT_LE(errorsOf(drawing.pixels(), truth).worst, tolerance);
    // Nothing is looked for behind a focus that hides it.
    const std::vector<glm::vec4> ended = drawing.pixels(0.5);
    for (std::size_t i = 0; i < pixelsIn(size); ++i) {
      if (i % 4 >= 2) {
        EXPECT_EQ(ended[i], focus[i]);
      }
    }
  }
}

TEST_F(MaximumPassTest, PartsMakeTheWhole) {
  const Scene scene = waves(false);
  for (const glm::ivec2 each : awkwardSizes) {
    const Camera camera = aside(scene);
    const Rays rays = raysOf(scene, camera, each, true);
    for (const Schedule schedule : schedules) {
      SCOPED_TRACE(named(schedule, each));
      Drawing drawing(scene, camera, each, schedule, rays, true);
      const auto run = [&](const std::vector<gl::Region>& regions, gl::Texture& image) { drawing.run(regions, image); };
      expectPartsMakeTheWhole(drawing.pixels(), each, run);
      expectOnlyTheRegionIsWritten(drawing.pixels(), each, run);
    }
  }
}

}  // namespace
}  // namespace fenestra::tests::maximumPassTest
