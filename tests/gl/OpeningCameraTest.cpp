// Openings that another camera than the picture's cuts: frozen ones and those with an axis offset.

#include "rendering/reference/Picture.h"
#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::openingCameraTest {
namespace {

constexpr glm::ivec2 size{88, 72};

/// A body that light passes through in part, so that what lies behind its surface shows.
Scene hazyBody() {
  Scene scene = bodyWithOrgans<std::int16_t>(gridOf({40, 36, 34}));
  scene.look.context.function = {{{20.0, {glm::dvec3(0.8, 0.5, 0.4), 0.0}},
                                  {60.0, {glm::dvec3(0.9, 0.7, 0.6), 0.08}},
                                  {120.0, {glm::dvec3(1.0, 0.95, 0.9), 0.3}}}};
  scene.look.focus = LabelFocus{{1}};
  scene.look.cutaway.openWidth = 12.0;
  return scene;
}

Camera from(double azimuth, double elevation, const Scene& scene, Projection projection = Projection::Perspective) {
  return Camera::fromAngles(azimuth, elevation, scene.volume->grid, projection);
}

View viewOf(const Camera& camera, double maxError = 1.0) {
  View view{.camera = camera, .size = size};
  view.maxError = maxError;
  return view;
}

View frozenView(const Camera& camera, const Camera& frozen, glm::ivec2 frozenSize = size) {
  View view = viewOf(camera);
  view.frozen = OpeningView{frozen, frozenSize, 1.0};
  return view;
}

Layers drawn(const Scene& scene, const View& view, Schedule schedule = usualSchedule()) {
  const auto gpuScene = std::make_shared<GpuScene>();
  gpuScene->setSchedule(schedule);
  Renderer renderer(gpuScene);
  renderer.render(scene, view);
  return renderer.readLayers();
}

double worstOf(glm::dvec4 difference) {
  difference = glm::abs(difference) * 255.0;
  return std::max({difference.r, difference.g, difference.b, difference.a});
}

/// Share of the pixels, in per mille, whose colour is off by more than a limit in 1/255.
template <class Colour>
double perMilleBeyond(double bound, const std::vector<glm::vec4>& picture, const std::vector<Colour>& truth) {
  EXPECT_EQ(picture.size(), truth.size());
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < std::min(picture.size(), truth.size()); ++i)
    if (!(worstOf(glm::dvec4(picture[i]) - glm::dvec4(truth[i])) <= bound)) ++beyond;
  return 1000.0 * static_cast<double>(beyond) / static_cast<double>(truth.size());
}

std::size_t holesIn(const reference::Stages& stages) {
  const reference::Image& begins = stages.apart.value().holeBegin;
  return static_cast<std::size_t>(
      std::count_if(begins.begin(), begins.end(), [](double t) { return std::isfinite(t); }));
}

/// Where a ray grazes a surface or the opening's rim, rounding decides what it meets first: as in expectStagesMatch(),
/// such pixels lie on lines and are held to a few in a thousand. The others keep the picture's bound of 1/255.
void expectMatches(const Scene& scene, const View& view, double perMille = 4.0) {
  const reference::Picture truth = reference::picture(scene, view);
  for (const Schedule schedule : pictureSchedules()) {
    const Layers layers = drawn(scene, view, schedule);
    EXPECT_LE(perMilleBeyond(*view.maxError, layers.focusLayer, truth.focusLayer), perMille) << nameOf(schedule);
    EXPECT_LE(perMilleBeyond(*view.maxError, layers.final, truth.final), perMille) << nameOf(schedule);
  }
}

using OpeningCamera = GlTest;

TEST_F(OpeningCamera, FrozenForThePicturesOwnCameraIsTheOrdinaryOpening) {
  const Scene scene = hazyBody();
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    const Camera camera = from(25, 15, scene, projection);
    const Layers ordinary = drawn(scene, viewOf(camera)), frozen = drawn(scene, frozenView(camera, camera));
    EXPECT_LE(perMilleBeyond(2.0, frozen.final, ordinary.final), 4.0);
    const reference::Picture truth = reference::picture(scene, viewOf(camera));
    const reference::Picture apart = reference::picture(scene, frozenView(camera, camera));
    std::vector<glm::vec4> single(apart.final.begin(), apart.final.end());
    EXPECT_LE(perMilleBeyond(0.05, single, truth.final), 4.0) << "in double precision";
  }
}

TEST_F(OpeningCamera, FrozenMatchesTheReferenceFromOtherSides) {
  const Scene scene = hazyBody();
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
    for (const glm::dvec2 angles : {glm::dvec2(40, 20), glm::dvec2(-70, 5), glm::dvec2(180, -10)}) {
      const View view = frozenView(from(angles.x, angles.y, scene, projection), from(0, 0, scene));
      SCOPED_TRACE(std::to_string(angles.x) + (projection == Projection::Perspective ? "" : ", parallel"));
      expectMatches(scene, view);
    }
}

TEST_F(OpeningCamera, APictureOfAnotherSizeMayBeFrozen) {
  const Scene scene = hazyBody();
  expectMatches(scene, frozenView(from(30, 10, scene), from(0, 0, scene, Projection::Orthographic), {61, 97}));
}

TEST_F(OpeningCamera, RaysThatPassTheContextSeeNothingInTheOpening) {
  const Scene scene = hazyBody();
  const View view = frozenView(from(75, 0, scene), from(0, 0, scene));
  reference::Stages stages = reference::geometricStages(scene, view);
  EXPECT_GT(holesIn(stages), 100u) << "too few to tell";
  expectMatches(scene, view);
  // The test would notice if holes did nothing.
  const reference::Picture with = reference::picture(scene, view);
  std::fill(stages.apart->holeBegin.begin(), stages.apart->holeBegin.end(), infinity);
  std::fill(stages.apart->holeEnd.begin(), stages.apart->holeEnd.end(), infinity);
  const reference::Picture without = reference::picture(scene, view.camera, view.size, stages);
  const std::vector<glm::vec4> single(with.final.begin(), with.final.end());
  EXPECT_GT(perMilleBeyond(1.0, single, without.final), 15.0);
}

TEST_F(OpeningCamera, AxisOffsetMatchesTheReference) {
  Scene scene = hazyBody();
  const Layers straight = drawn(scene, viewOf(from(10, 10, scene)));
  for (const glm::dvec2 offset : {glm::dvec2(30, 0), glm::dvec2(45, 120), glm::dvec2(80, -90)}) {
    scene.look.cutaway.axisOffset = offset.x;
    scene.look.cutaway.axisDirection = offset.y;
    SCOPED_TRACE(offset.x);
    expectMatches(scene, viewOf(from(10, 10, scene)));
    EXPECT_GT(perMilleBeyond(4.0, straight.final, drawn(scene, viewOf(from(10, 10, scene))).final), 20.0);
  }
}

TEST_F(OpeningCamera, ValuesLightStrokesAndProtectedLabels) {
  Scene lit = hazyBody();
  lit.look.shading.enabled = true;
  const View view = frozenView(from(50, 15, lit), from(0, 5, lit));
  Scene values = lit;
  values.look.focus = ValueFocus{{95.0, 1000.0}, 0.0};
  expectMatches(values, view);
  expectMatches(brushed(lit), view);
  expectMatches(withProtected(lit), view);
  Scene bare = lit;
  bare.look.cutaway.openWidth = 0.0;
  expectMatches(bare, view, 6.0);
}

TEST_F(OpeningCamera, TheFocusIsNeverRemoved) {
  const Scene scene = hazyBody();
  const View view = frozenView(from(60, 20, scene), from(0, 0, scene));
  const Layers layers = drawn(scene, view);
  for (std::size_t i = 0; i < layers.tStart.size(); ++i)
    if (!std::isnan(layers.tFocus[i])) {
      EXPECT_LE(layers.tStart[i], layers.tFocus[i]) << "pixel " << i;
    }
}

TEST_F(OpeningCamera, WhileFrozenACameraMoveCutsNothingAnew) {
  const Scene scene = hazyBody();
  Renderer renderer(std::make_shared<GpuScene>());
  const auto runs = [&](Pass pass) { return renderer.stats()[static_cast<std::size_t>(pass)].runs; };
  renderer.render(scene, frozenView(from(0, 0, scene), from(0, 0, scene)));
  const auto hits = runs(Pass::HitPoints), fills = runs(Pass::PullPush), distances = runs(Pass::DistanceMap);
  renderer.render(scene, frozenView(from(20, 0, scene), from(0, 0, scene)));
  EXPECT_EQ(runs(Pass::HitPoints), hits + 1) << "of the picture's own rays";
  EXPECT_EQ(runs(Pass::PullPush), fills);
  EXPECT_EQ(runs(Pass::DistanceMap), distances);
}

TEST_F(OpeningCamera, CostsNothingWhereUnused) {
  const Scene scene = hazyBody();
  const View plain = viewOf(from(20, 0, scene));
  Renderer never(std::make_shared<GpuScene>()), once(std::make_shared<GpuScene>());
  never.render(scene, plain);
  once.render(scene, frozenView(from(20, 0, scene), from(0, 0, scene)));
  const std::size_t frozenBytes = once.imageBytes();
  once.render(scene, plain);
  EXPECT_EQ(once.imageBytes(), never.imageBytes());
  EXPECT_GT(frozenBytes, once.imageBytes());
  EXPECT_EQ(once.readPicture(), never.readPicture());
}

TEST_F(OpeningCamera, DrawnALittleAtATimeIsTheSame) {
  const Scene scene = brushed(hazyBody());
  const View view = frozenView(from(40, 10, scene), from(0, 0, scene));
  Renderer whole(std::make_shared<GpuScene>()), tiles(std::make_shared<GpuScene>());
  whole.render(scene, view);
  tiles.begin(scene, view);
  while (!tiles.advance(0.0)) {
  }
  EXPECT_EQ(whole.readPicture(), tiles.readPicture());
  // Strokes that change patch the ordinary picture; the frozen one follows them too.
  Scene unbrushed = scene;
  unbrushed.look.strokes.clear();
  tiles.render(unbrushed, view);
  whole.render(scene, view);
  Renderer fresh(std::make_shared<GpuScene>());
  fresh.render(unbrushed, view);
  EXPECT_EQ(tiles.readPicture(), fresh.readPicture());
}

}  // namespace
}  // namespace fenestra::tests::openingCameraTest
