// The measures of a method: a slab of haze before a ball in closed form, and the opacity of every method's picture
// against the reference.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "rendering/reference/Lens.h"
#include "rendering/reference/Picture.h"
#include "tests/bench/ContextMeasures.h"
#include "tests/bench/MethodVariants.h"
#include "tests/bench/MethodsPage.h"
#include "tests/support/Scenes.h"

namespace fenestra::bench {
namespace {

using namespace tests;

constexpr glm::ivec2 size{90, 90};
constexpr double pixel = 0.3;                            // mm
constexpr double side = 90 * pixel;                      // mm, of the picture
constexpr double front = 4.0, back = 12.0, haze = 0.25;  // mm, mm, 1/mm
constexpr ViewSamples::Sampling everything{1, 1'000'000};
const glm::dvec3 middle{20.0, 30.0, 20.0};  // of the ball
constexpr double radius = 6.2;              // mm

/// Seen along y, with parallel rays, which all meet the slab.
Camera parallel() { return lookAt({20.0, -100.0, 20.0}, middle, Projection::Orthographic, side); }

Scene slabBeforeBall() {
  const Grid grid = gridOf({41, 46, 41});
  Scene scene;
  scene.volume = volumeOf<float>(grid, [](glm::ivec3 i) { return i.y; });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) {
    return glm::distance(glm::dvec3(i), middle) < radius ? 1 : i.y < 20 ? 2 : 3;
  });
  scene.look.focus = LabelFocus{{1}};
  const OpticalProperties clear{glm::dvec3(0.5), 0.0}, hazy{glm::dvec3(0.5), haze};
  scene.look.context.function = {{{front, clear}, {front, hazy}, {back, hazy}, {back, clear}}};
  scene.look.contextLayer.strength = 0.0;
  scene.look.cutaway.borderWidth = 0.0;
  scene.look.shading.enabled = false;
  return scene;
}

std::vector<float> floats(const reference::Image& image) { return {image.begin(), image.end()}; }

/// A view of a scene, and the effect of its method there by the reference.
struct Case {
  Scene scene;
  Camera camera;
  reference::Stages stages;
  RaySampler sampler;
  ViewSamples samples;

  Case(const Scene& what, const Camera& from, double pixelScale = 1.0)
      : scene(what),
        camera(from),
        stages(reference::geometricStages(scene, camera, size, pixelScale)),
        sampler(scene),
        samples(sampler, camera, size, floats(stages.hits.tContext), floats(stages.hits.tFocus), everything) {}
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;

  MethodRays rays() const {
    if (!scene.look.cutaway.enabled) return {};
    const MethodStages method = stagesOf(scene.look.method);
    if (method.fading && !method.fading->ghost) return {{}, {}, method.fading};
    MethodRays result{floats(stages.tStart), {}, method.fading};
    if (method.lens) {
      std::vector<glm::vec4> surfaces;
      for (const auto& point : reference::lensPoints(scene, camera, size, stages.hits, pixels()))
        surfaces.emplace_back(point.normal, point.distance);
      result.shares = lensShares(*method.lens, radiusOf(*method.lens, scene.volume->grid), size,
                                 floats(stages.hits.tContext), floats(stages.hits.tFocus), surfaces);
    } else if (method.keepsRemoved()) {
      for (const glm::ivec2 at : pixels())
        result.shares.push_back(static_cast<float>(faintShare(method.sparseness, method.faintOpacity, at.x, at.y)));
    }
    return result;
  }
  static std::vector<glm::ivec2> pixels() {
    std::vector<glm::ivec2> all;
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i) all.emplace_back(i, j);
    return all;
  }
};

/// Starts where rays cross a plane of constant y.
std::vector<float> startsAt(const Camera& camera, double y) {
  std::vector<float> starts;
  for (const glm::ivec2 at : Case::pixels()) {
    const reference::Ray ray = reference::pixelRay(camera, size, at);
    starts.push_back(static_cast<float>((y - ray.origin.y) / ray.direction.y));
  }
  return starts;
}

TEST(ContextKept, OfASlabBeforeABallIsWhatACylinderLeaves) {
  Scene scene = slabBeforeBall();
  scene.look.cutaway.openWidth = 0.0;
  const Case view(scene, parallel());
  const double covered = std::numbers::pi * radius * radius / (side * side);  // of the picture, by the ball's outline
  const ContextKept kept = view.samples.kept(view.rays());
  // The indicator's surface is up to half a voxel off the ball's, a twelfth of the radius.
  EXPECT_NEAR(kept.volume, 1.0 - covered, 2.0 / 12.0 * covered);
  EXPECT_NEAR(kept.surface, kept.volume, 1e-4) << "a cylinder takes as much of the surface";

  Scene faint = scene;
  faint.look.method.kind = kindOf<methods::Importance>;
  faint.look.method.of<methods::Importance>().mode = ImportanceMode::Average;
  faint.look.method.of<methods::Importance>().opacity = 0.25;
  const Case faintView(faint, parallel());
  EXPECT_NEAR(1.0 - faintView.samples.kept(faintView.rays()).volume, 0.75 * (1.0 - kept.volume), 1e-6);

  scene.look.cutaway.enabled = false;
  const Case plain(scene, parallel());
  EXPECT_DOUBLE_EQ(plain.samples.kept(plain.rays()).volume, 1.0);
  EXPECT_DOUBLE_EQ(plain.samples.kept(plain.rays()).surface, 1.0);
}

TEST(ContextKept, OfASlabIsWhatAConeLeaves) {
  const Case view(slabBeforeBall(), parallel());
  // A cone with its apex on the axis, of half the slope: sections of radius (apex - y) / 2.
  constexpr double apex = 26.0;
  MethodRays rays{startsAt(parallel(), front), {}};
  std::size_t at = 0;
  for (const glm::ivec2 place : Case::pixels()) {
    const glm::dvec3 origin = reference::pixelRay(parallel(), size, place).origin;
    const double away = glm::distance(glm::dvec2(origin.x, origin.z), glm::dvec2(middle.x, middle.z));
    rays.starts[at] = std::max(rays.starts[at], static_cast<float>(apex - 2.0 * away - origin.y));
    ++at;
  }
  const double large = 0.5 * (apex - front), small = 0.5 * (apex - back);
  const double frustum = std::numbers::pi / 3.0 * (large * large + large * small + small * small) * (back - front);
  const ContextKept kept = view.samples.kept(rays);
  // A ray meets the slab in some 16 stretches, so that it is known to a half of one: 3 % of what is removed.
  EXPECT_NEAR(kept.volume, 1.0 - frustum / (side * side * (back - front)),
              0.03 * frustum / (side * side * (back - front)));
  EXPECT_NEAR(kept.surface, 1.0 - std::numbers::pi * large * (large - 0.5) / (side * side), 0.01)
      << "the cone takes of a skin of 1 mm a frustum, too";
}

TEST(ContextKept, CountsVolumeInTheWorldWhereRaysDiverge) {
  const Camera near = [] {
    Camera camera = lookAt({20.0, -20.0, 20.0}, middle);
    camera.verticalFov = 40.0;
    return camera;
  }();
  const Case view(slabBeforeBall(), near);
  const auto cube = [](double x) { return x * x * x; };
  // The front half of the slab is removed: of a pyramid between depths of 24 and 32 mm the part behind 28 stays, 0.6.
  const double expected = (cube(32.0) - cube(28.0)) / (cube(32.0) - cube(24.0));
  const ContextKept kept = view.samples.kept({startsAt(near, 8.0), {}});
  EXPECT_NEAR(kept.volume, expected, 0.02) << "half of one of 16 stretches";
  EXPECT_NEAR(kept.surface, 0.0, 1e-6);
}

TEST(ContextKept, AroundAFocalRegionIsTheGradientsShare) {
  // Values rise evenly.
  const Grid grid = gridOf({41, 41, 41});
  Scene scene = slabBeforeBall();
  scene.volume = volumeOf<float>(grid, [](glm::ivec3 i) { return i.y; });
  scene.labels = labelsOf(grid, [](glm::ivec3 i) { return i == glm::ivec3(20, 38, 20) ? 1 : 0; });
  scene.look.method.kind = kindOf<methods::FocalRegion>;
  scene.look.method.of<methods::FocalRegion>().size = 1.0;
  scene.look.method.of<methods::FocalRegion>().fallOff = 1e5;
  const Case view(scene, parallel());
  // The range of 40 over 1 mm, halved, is the steepest slope: 1 mm⁻¹ is a twentieth.
  EXPECT_NEAR(view.samples.kept(view.rays()).volume, 1.0 / 20.0, 1e-3);
  scene.look.method.of<methods::FocalRegion>().size = 100.0;
  const Case inside(scene, parallel());
  EXPECT_DOUBLE_EQ(inside.samples.kept(inside.rays()).volume, 1.0);
}

TEST(ContextKept, OfContextPreservingIsTheSolutionForOneMaterial) {
  Scene scene = slabBeforeBall();
  scene.look.method.kind = kindOf<methods::ContextPreserving>;
  scene.look.method.of<methods::ContextPreserving>().reach = 0.0;
  const Case still(scene, parallel());
  EXPECT_DOUBLE_EQ(still.samples.kept(still.rays()).volume, 1.0);
  scene.look.method.of<methods::ContextPreserving>().reach = 0.3;
  const Case view(scene, parallel());
  const reference::Picture exact = reference::picture(scene, parallel(), size);
  const double slab = haze * (back - front);
  // Beside the ball a ray's optical depth is κ times what is kept of the slab.
  const std::size_t beside = 0;
  const double expected = -std::log1p(-exact.final[beside].a) / slab;
  EXPECT_GT(expected, 0.05);
  EXPECT_LT(expected, 0.9);
  EXPECT_NEAR(view.samples.kept(view.rays()).volume, expected, 0.01);
}

TEST(ContextKept, OfAGhostIsItsShareOfWhatAnOpeningRemoves) {
  Scene scene = slabBeforeBall();
  scene.look.cutaway.openWidth = 0.0;
  const Case opened(scene, parallel());
  const double removed = 1.0 - opened.samples.kept(opened.rays()).volume;
  ASSERT_GT(removed, 0.1);
  Method& method = scene.look.method;
  method.kind = kindOf<methods::Selection>;
  method.of<methods::Selection>().strength = 0.8;
  method.of<methods::Selection>().edge = 10.0;
  method.of<methods::Selection>().outline = 0.5;
  // Values rise by 1 mm⁻¹ along the rays; half of their range of 45 over 1 mm is the steepest slope.
  const double slope = 1.0 / 22.5, square = slope * slope;
  const double share = 1.0 - 0.8 * (1.0 - 0.5 * square / (square + 0.1 * 0.1));
  const Case ghost(scene, parallel());
  EXPECT_NEAR(1.0 - ghost.samples.kept(ghost.rays()).volume, (1.0 - share) * removed, 1e-3);
}

TEST(DepthOrder, Thorough_IsWrongWhereAFocusFloatsBeforeWhatHidesIt) {
  Scene scene = slabBeforeBall();
  const double opacity = -std::expm1(-haze * (back - front));
  const auto orderOf = [&](double pixelScale = 1.0) {
    const Case view(scene, parallel(), pixelScale);
    return view.samples.order(view.rays());
  };
  scene.look.cutaway.openWidth = 0.0;
  const DepthOrder bare = orderOf();
  EXPECT_NEAR(bare.wrong, opacity, 1e-2) << "all of the slab stands beside the ball, and nothing over it";
  EXPECT_EQ(bare.wrongPairs, 1);
  EXPECT_EQ(bare.pairs, 1) << "ball and slab";

  scene.look.cutaway.openWidth = 12.0;
  const DepthOrder opened = orderOf();
  EXPECT_NEAR(opened.wrong, 0.0, 1e-9) << "the wall begins at the ball";
  EXPECT_EQ(opened.wrongPairs, 0);

  scene.look.method.kind = kindOf<methods::Importance>;
  scene.look.method.of<methods::Importance>().mode = ImportanceMode::Average;
  for (const double share : {0.05, 0.75}) {
    scene.look.method.of<methods::Importance>().opacity = share;
    const DepthOrder faint = orderOf();
    EXPECT_NEAR(faint.wrong, (1.0 - share) * opacity, 1e-2) << share;
    EXPECT_EQ(faint.wrongPairs, share < 0.5);
  }

  scene.look.cutaway.enabled = false;
  const DepthOrder plain = orderOf();
  EXPECT_NEAR(plain.wrong, 0.0, 1e-6) << "a film over both";
  EXPECT_EQ(plain.wrongPairs, 0);
}

TEST(DepthOrder, IsRightWhereTheFocusLiesInFront) {
  // Seen from behind, the ball lies before the slab.
  Scene scene = slabBeforeBall();
  scene.look.cutaway.openWidth = 0.0;
  const Case view(scene, lookAt({20.0, 140.0, 20.0}, middle, Projection::Orthographic, side));
  EXPECT_EQ(view.samples.order(view.rays()).wrong, 0.0);
}

TEST(MethodMeasures, Thorough_EveryMethodHasTheOpacityOfItsReference) {
  const Grid grid = gridOf({41, 46, 41});
  Scene base = slabBeforeBall();
  base.volume = volumeOf<float>(grid, [](glm::ivec3 i) {
    return std::max(40.0 - 2.2 * glm::distance(glm::dvec3(i), glm::dvec3(20.0, 22.0, 20.0)), 0.0) +
           2.0 * std::sin(0.4 * i.x) * std::cos(0.3 * i.z);
  });
  const glm::dvec3 grey(0.5);
  base.look.context.function = {{{3.0, {grey, 0.0}}, {12.0, {grey, 0.06}}, {40.0, {grey, 0.01}}}};
  base.look.focusAppearance.extinction = 0.05;
  base.look.shading.enabled = true;
  const Camera camera = lookAt({-40.0, -60.0, 50.0}, {20.0, 22.0, 20.0});
  for (const MethodVariant& variant : methodVariants()) {
    if (variant.moves || stagesOf(variant.method).walls) continue;  // walls are in the picture's opacity
    Scene scene = base;
    scene.look.method = variant.method;
    scene.look.method.of<methods::FocalRegion>().size = 8.0;
    const Case view(scene, camera);
    const reference::Picture exact = reference::picture(scene, camera, size);
    const std::vector<double> opacities = view.samples.opacities(view.rays());
    double sum = 0.0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < exact.final.size(); ++i)
      if (!std::isnan(view.stages.hits.tContext[i])) sum += std::abs(opacities[at++] - exact.final[i].a);
    ASSERT_EQ(at, opacities.size());
    ASSERT_GT(at, 1000u);
    // A stretch as long as a voxel counts as uniform, with the values of its middle; where rays start beyond ε, a film
    // below it is missing.
    EXPECT_LT(sum / static_cast<double>(at), 0.01) << variant.name;
  }
}

TEST(MethodsPage, MarksTheBestAndSaysWhereTheAdaptiveCutawayIsNot) {
  MethodFigures adaptive, other;
  adaptive.name = "Ours";
  adaptive.seen = 0.9501;
  adaptive.volume = 0.8;
  other.name = "Theirs";
  other.seen = 0.9502;
  other.volume = 0.9;
  SceneFigures scene;
  scene.methods = {adaptive, other};
  const Section section = sectionOf(scene);
  EXPECT_NE(section.text.find("best, alone or with others, in focus seen"), std::string::npos) << section.text;
  EXPECT_NE(section.text.find("not best in volume kept (0.800; Theirs: 0.900)."), std::string::npos) << section.text;
  const Table& table = section.tables.front();
  ASSERT_EQ(table.rows.size(), 3u);
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  EXPECT_EQ(table.rows[0][1], "**0.950**");
  EXPECT_EQ(table.rows[0][3], "0.800");
  EXPECT_EQ(table.rows[1][3], "**0.900**");
  const Section best = summaryOf({scene});
  EXPECT_EQ(best.tables.front().rows[0][3], "0");
  EXPECT_EQ(best.tables.front().rows[1][3], "1");
}

}  // namespace
}  // namespace fenestra::bench
