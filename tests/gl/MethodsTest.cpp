// Pictures of the methods beside the adaptive cutaway: against the reference within their bounds, in scenes of every
// kind.

#include "rendering/reference/Picture.h"
#include "rendering/scene/Edges.h"
#include "rendering/scene/Lighting.h"
#include "tests/gl/MethodsTesting.h"

namespace fenestra::tests {
namespace {

/// The lens's values of the surface: rays that graze it are held to four in a thousand, as below.
void expectLensMatches(const std::vector<glm::vec4>& here, const std::vector<glm::dvec4>& truth) {
  ASSERT_EQ(here.size(), truth.size());
  std::size_t off = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const bool same = std::isnan(here[i].w) == std::isnan(truth[i].w);
    // Values in 16 bits, whose steps turn normals by 1e-3; hits within 2e-3 voxels, of up to 1 mm here.
    const bool isNear = glm::distance(glm::dvec3(here[i]), glm::dvec3(truth[i])) <= 2e-3 &&
                        (std::isnan(truth[i].w) || std::abs(here[i].w - truth[i].w) <= 2e-3);
    off += !(same && isNear);
  }
  EXPECT_LE(1000.0 * static_cast<double>(off), 4.0 * static_cast<double>(truth.size())) << "the lens's surface";
}

}  // namespace

/// Stages 1 to 4 and the picture. Where a ray grazes a surface or an opening's rim, rounding decides what it meets
/// first: such pixels lie on lines and are held to four in a thousand, as those of other openings are.
void Methods::expectMatches(const Scene& scene, const View& view) {
  const reference::Stages stages = reference::geometricStages(scene, view);
  reference::PictureOptions options;
  options.slices = view.slices;
  const reference::Picture truth = reference::picture(scene, view.camera, view.size, stages, options);
  const double voxel = finestSpacing(scene.volume->grid);
  for (const Schedule schedule : pictureSchedules()) {
    SCOPED_TRACE(nameOf(schedule));
    const Layers layers = drawn(scene, view, schedule);
    EXPECT_EQ(layers.tStart.empty(), !hasCutaway(scene)) << "a method that cuts nothing away has no starts";
    if (hasCutaway(scene)) {
      const StageErrors starts = compareMaps(layers.tStart, stages.tStart, voxel);
      // As for the adaptive cutaway's starts.
      EXPECT_LE(starts.percentile(0.996), 2e-3);
    }
    EXPECT_LE(perMilleBeyond(*view.maxError, layers.focusLayer, truth.focusLayer), 4.0);
    EXPECT_LE(perMilleBeyond(*view.maxError, layers.final, truth.final), 4.0);
    EXPECT_EQ(layers.faintLayer.empty(), truth.faintLayer.empty());
    if (!truth.faintLayer.empty()) {
      EXPECT_LE(perMilleBeyond(*view.maxError, layers.faintLayer, truth.faintLayer), 4.0);
    }
    expectLensMatches(layers.lens, truth.lens);
    EXPECT_EQ(layers.walls.empty(), truth.walls.empty());
    if (!truth.walls.empty()) {
      EXPECT_LE(perMilleBeyond(0.5, layers.walls, truth.walls), 4.0) << "the walls";
    }
  }
}

namespace {

TEST_F(Methods, EachMatchesTheReferenceAndIsAnotherPicture) {
  std::vector<std::vector<glm::vec4>> pictures{drawn(hazyBody({}), viewOf(from(25, 15, hazyBody({})))).final};
  for (const auto& [name, method] : otherMethods()) {
    SCOPED_TRACE(name);
    const Scene scene = hazyBody(method);
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
      expectMatches(scene, viewOf(from(25, 15, scene, projection)));
    }
    const std::vector<glm::vec4> picture = drawn(scene, viewOf(from(25, 15, scene))).final;
    for (const std::vector<glm::vec4>& other : pictures)
      EXPECT_GT(perMilleBeyond(1.0, picture, other), 8.0) << "twice what a match may miss";
    pictures.push_back(picture);
  }
}

/// Near enough that the focus fills a tenth of the picture, so that no fade could be mistaken for another.
TEST_F(Methods, FadesOfClearViewMatchAndDiffer) {
  std::vector<std::vector<glm::vec4>> pictures;
  for (const LensFade fade : {LensFade::Distance, LensFade::Curvature, LensFade::Depth}) {
    SCOPED_TRACE(wordOf(fade).word);
    const Scene scene = hazyBody(methods::ClearView{.fade = fade, .radius = 20.0});
    const View view = viewOf(from(25, 15, scene).zoomed(3.0));
    expectMatches(scene, view);
    pictures.push_back(drawn(scene, view).final);
    for (std::size_t other = 0; other + 1 < pictures.size(); ++other)
      EXPECT_GT(perMilleBeyond(4.0, pictures.back(), pictures[other]), 40.0) << other;
  }
}

TEST_F(Methods, ALensOverTheCrosshairMatchesAndMoves) {
  const Scene scene = hazyBody(methods::ClearView{.place = LensPlace::OverCrosshair, .radius = 20.0});
  View view = viewOf(from(25, 15, scene).zoomed(3.0));
  const std::vector<glm::vec4> overFocus = drawn(scene, view).final;
  view.slices.crosshair = scene.volume->grid.centre() + glm::dvec3(3.0, -2.0, 4.0);
  expectMatches(scene, view);
  EXPECT_GT(perMilleBeyond(4.0, drawn(scene, view).final, overFocus), 40.0);
}

/// Where light falls to 0, the lowest sharpness gives the fading a cusp, and the greatest a cut.
TEST_F(Methods, ContextPreservingKeepsItsBoundAtAnySharpness) {
  for (const bool lit : {true, false})
    for (const glm::dvec2 parameters : {glm::dvec2(8.0, 0.3), glm::dvec2(10.0, 2.0)}) {
      SCOPED_TRACE(testing::Message() << lit << ", " << parameters.x << ", " << parameters.y);
      Scene scene = hazyBody(methods::ContextPreserving{.reach = parameters.x, .sharpness = parameters.y});
      scene.look.shading.enabled = lit;
      for (TransferFunction::Node& node : scene.look.context.function.nodes) node.properties.extinction *= 10.0;
      expectMatches(scene, viewOf(from(25, 15, scene), 0.5));
    }
}

/// Regions of less than a voxel, that end between voxels or hold the eye; contours that fall off within a voxel or
/// reach through the whole body.
TEST_F(Methods, Exhaustive_FocalRegionsKeepTheirBoundAtAnySize) {
  for (const bool lit : {true, false})
    for (const FocalShape shape : {FocalShape::Sphere, FocalShape::Box, FocalShape::Distance})
      for (const glm::dvec2 parameters : {glm::dvec2(0.3, 1e5), glm::dvec2(7.3, 0.4), glm::dvec2(60.0, 4.0)}) {
        SCOPED_TRACE(testing::Message() << lit << ", " << wordOf(shape).word << ", " << parameters.x << ", "
                                        << parameters.y);
        Scene scene = hazyBody(methods::FocalRegion{.shape = shape, .size = parameters.x, .fallOff = parameters.y});
        scene.look.shading.enabled = lit;
        for (TransferFunction::Node& node : scene.look.context.function.nodes) node.properties.extinction *= 10.0;
        expectMatches(scene, viewOf(from(25, 15, scene), 0.5));
      }
  for (const FocalShape shape : {FocalShape::Sphere, FocalShape::Distance}) {
    Scene unfocused = hazyBody(methods::FocalRegion{.shape = shape, .size = 7.0, .fallOff = 12.0});
    unfocused.look.focus = {};
    expectMatches(unfocused, viewOf(from(25, 15, unfocused), 0.5));
  }
}

/// On a sheared grid, on one of a single voxel along an axis, and in a spline; while the focus changes, by value, too.
TEST_F(Methods, Thorough_FocalDistancesFollowTheGridAndTheFocus) {
  const Method method = methods::FocalRegion{.shape = FocalShape::Distance, .size = 2.5, .fallOff = 4.0};
  Grid sheared = gridOf({26, 24, 18}, {0.7, 0.7, 1.6});
  sheared.direction[2] = glm::normalize(glm::dvec3(0.0, -0.33, 1.0));
  for (const Grid& grid : {sheared, gridOf({24, 1, 20}), gridOf({22, 24, 20}, {0.05, 0.05, 10.0}, {1e4, -1e4, 1e4})}) {
    const Scene scene = hazyBody(method, grid);
    expectMatches(scene, viewOf(from(25, 15, scene), 0.5));
  }
  Scene scene = hazyBody(method);
  scene.look.reconstruction = Reconstruction::Cubic;
  expectMatches(scene, viewOf(from(25, 15, scene), 0.5));
  scene.look.reconstruction = Reconstruction::Linear;
  scene.look.focus = ValueFocus{{0.6 * scene.volume->range.high, scene.volume->range.high}, 0.0};
  expectMatches(scene, viewOf(from(25, 15, scene), 0.5));
}

/// Edges that hardly count or nearly all do; a focus alone, and an opening around it.
TEST_F(Methods, GhostsKeepTheirBoundAtAnyEdge) {
  for (const bool lit : {true, false})
    for (const double width : {0.0, 12.0})
      for (const glm::dvec3 parameters : {glm::dvec3(1.0, 0.3, 0.0), glm::dvec3(0.7, 60.0, 1.0)}) {
        SCOPED_TRACE(testing::Message() << lit << ", " << width << ", " << parameters.x << ", " << parameters.y);
        Scene scene =
            hazyBody(methods::Selection{.strength = parameters.x, .edge = parameters.y, .outline = parameters.z});
        scene.look.shading.enabled = lit;
        scene.look.cutaway.openWidth = width;
        for (TransferFunction::Node& node : scene.look.context.function.nodes) node.properties.extinction *= 10.0;
        expectMatches(scene, viewOf(from(25, 15, scene), 0.5));
      }
  Scene unfocused = hazyBody(methods::Selection{}), plain = hazyBody({});
  unfocused.look.focus = plain.look.focus = {};
  const View view = viewOf(from(25, 15, plain));
  EXPECT_EQ(drawn(unfocused, view).final, drawn(plain, view).final) << "to the bit";
}

TEST_F(Methods, Thorough_ASelectionHasSmoothEdges) {
  Scene scene = hazyBody(methods::Selection{});
  scene.look.edges = Edges::Smooth;
  const View view = viewOf(from(25, 15, scene));
  EXPECT_TRUE(hasSmoothEdges(scene.look, view));
  expectMatches(scene, view);
  expectMatches(brushed(scene), view);
  View frozen = view;
  frozen.frozen = OpeningView{from(0, 5, scene), size, 1.0};
  expectMatches(scene, frozen);
}

TEST_F(Methods, Exhaustive_ValuesSmoothedLabelsAndSplines) {
  for (const auto& [name, method] : eachMethod()) {
    SCOPED_TRACE(name);
    Scene values = hazyBody(method);
    values.look.focus = ValueFocus{{95.0, 1000.0}, 0.0};
    expectMatches(values, viewOf(from(25, 15, values)));
    Scene smoothed = hazyBody(method);
    smoothed.look.labelSmoothing = LabelSmoothing::Strong;
    expectMatches(smoothed, viewOf(from(25, 15, smoothed)));
    Scene spline = hazyBody(method);
    spline.look.reconstruction = Reconstruction::Cubic;
    expectMatches(spline, viewOf(from(25, 15, spline)));
  }
}

TEST_F(Methods, Exhaustive_BrushProtectedLabelsAndClipping) {
  for (const auto& [name, method] : eachMethod()) {
    SCOPED_TRACE(name);
    const Scene scene = hazyBody(method);
    const View view = viewOf(from(25, 15, scene));
    expectMatches(brushed(scene), view);
    expectMatches(withProtected(scene), view);
    expectMatches(withProtected(brushed(scene)), view);
    expectMatches(clipped(scene, false), view);
    expectMatches(clipped(scene, true), view);
    expectMatches(withFaint(scene), view);
    expectMatches(occluded(scene), viewOf(from(25, 15, scene), 2.0));
  }
}

TEST_F(Methods, Exhaustive_FrozenAndWithAnAxisOffset) {
  for (const auto& [name, method] : eachMethod()) {
    SCOPED_TRACE(name);
    Scene scene = hazyBody(method);
    View view = viewOf(from(50, 15, scene));
    view.frozen = OpeningView{from(0, 5, scene), size, 1.0};
    expectMatches(scene, view);
    expectMatches(brushed(scene), view);
    scene.look.cutaway.axisOffset = 30.0;
    expectMatches(scene, viewOf(from(25, 15, scene)));
  }
}

TEST_F(Methods, TheBorderFollowsTheRimOfWhatConesOpen) {
  Scene scene = hazyBody(methods::Cone{});
  scene.look.cutaway.borderWidth = 5.0;
  const View view = viewOf(from(25, 15, scene));
  const Layers layers = drawn(scene, view);
  // From the renderer's own hits and starts, so that an error shows where it arises.
  reference::Stages stages = reference::geometricStages(scene, view);
  stages.hits.tContext = widened(layers.tContext);
  stages.hits.tFocus = widened(layers.tFocus);
  stages.tCones = widened(layers.tStart);
  const StageErrors errors =
      compareMaps(layers.distance, reference::distanceMap(reference::openedBy(stages), size, 5.0), 1.0);
  // Squared distances are integers, so the only error is one rounding of a square root.
  EXPECT_LE(errors.max(), 1e-5);
  int inBorder = 0;
  for (std::size_t i = 0; i < layers.distance.size(); ++i)
    if (!std::isnan(layers.tContext[i]) && layers.distance[i] > 1.0f && layers.distance[i] < 4.5f) {
      ++inBorder;
      EXPECT_LT(glm::distance(glm::dvec4(layers.final[i]), glm::dvec4(scene.look.cutaway.borderColour, 1.0)), 1e-5);
    }
  EXPECT_GT(inBorder, 100);
}

/// The picture that ClearView should make of two others, without the context's edges: one in which nothing is removed,
/// and the focus layer.
TEST_F(Methods, ClearViewMixesThePictureAndTheOpenedOne) {
  Scene scene = hazyBody(methods::ClearView{.radius = 45.0, .bends = 0.0, .rim = 1000.0});
  scene.look.contextLayer.strength = 0.0;
  Scene closed = scene;
  closed.look.cutaway.enabled = false;
  // Near: along the body's outline the plain picture has haze too thin to be a surface, before which opened rays do not
  // start.
  const View view = viewOf(from(25, 15, scene).zoomed(3.0), 0.5);
  for (const Schedule schedule : pictureSchedules()) {
    const Layers plain = drawn(closed, view, schedule);
    for (const double radius : {45.0, 1000.0}) {
      scene.look.method.of<methods::ClearView>().radius = radius;
      const Layers clear = drawn(scene, view, schedule);
      const double mm = 0.01 * radius * 40.0;
      std::size_t mixed = 0, off = 0;
      for (std::size_t i = 0; i < plain.final.size(); ++i) {
        const bool isSurface = !std::isnan(clear.lens[i].w);
        const double d = clear.lens[i].w / mm;
        if (isSurface && std::abs(d - 1.0) < 1e-3) continue;  // its line
        const double w = isSurface ? std::min(d, 1.0) : 1.0;
        const glm::dvec4 expected = w * glm::dvec4(plain.final[i]) + (1.0 - w) * glm::dvec4(clear.focusLayer[i]);
        const glm::dvec4 error = 255.0 * glm::abs(glm::dvec4(clear.final[i]) - expected);
        // This is a weighted mean and a difference of three integrals with a bound of 0.5 each.
        off += std::max({error.r, error.g, error.b, error.a}) > 1.5;
        mixed += w < 0.9 && glm::distance(plain.final[i], clear.focusLayer[i]) > 0.1f;
      }
      EXPECT_LE(off, plain.final.size() / 1000);
      EXPECT_GT(mixed, 100u) << radius;
    }
  }
}

/// The pixel of a set that is nearest to another one.
glm::ivec2 nearestOf(const std::vector<glm::ivec2>& pixels, glm::ivec2 to) {
  return *std::min_element(pixels.begin(), pixels.end(), [&](glm::ivec2 a, glm::ivec2 b) {
    const auto square = [&](glm::ivec2 p) { return (p.x - to.x) * (p.x - to.x) + (p.y - to.y) * (p.y - to.y); };
    return square(a) < square(b);
  });
}

/// How bright a cut face is tells its normal: that of the cone which the ray leaves last, over a disc the one on the
/// nearest pixel of its rim.
TEST_F(Methods, CutFacesOfConesAreLitByTheConesNormal) {
  // An opaque context of one value, with no gradient of its own; a disc of focus deep in it, seen along y.
  const Grid grid = gridOf({64, 40, 64});
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3) { return 100; });
  scene.labels =
      labelsOf(grid, [](glm::ivec3 i) { return i.y >= 30 && std::hypot(i.x - 31.5, i.z - 31.5) < 8.0 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = {{{50.0, {glm::dvec3(1.0), 1e4}}, {150.0, {glm::dvec3(1.0), 1e4}}}};
  scene.look.contextLayer.strength = scene.look.cutaway.borderWidth = 0.0;
  scene.look.shading = {};
  scene.look.shading.ambient = scene.look.shading.specular = 0.0;
  scene.look.shading.diffuse = 1.0;
  scene.look.shading.lightAzimuth = 50.0;
  scene.look.method = methods::Cone{.angle = 40.0};
  const Camera camera = Camera::standard(StandardView::Anterior, grid, Projection::Orthographic);
  View view = viewOf(camera, 0.5);
  view.size = {200, 200};
  const Layers layers = drawn(scene, view);
  const auto at = [&](glm::ivec2 p) { return static_cast<std::size_t>(p.y * view.size.x + p.x); };
  std::vector<glm::ivec2> focus;
  for (int j = 0; j < view.size.y; ++j)
    for (int i = 0; i < view.size.x; ++i)
      if (!std::isnan(layers.tFocus[at({i, j})])) focus.emplace_back(i, j);
  ASSERT_GT(focus.size(), 500u);
  const glm::dvec3 light = lightDirection(camera.axes(), scene.look.shading);
  const double angle = glm::radians(40.0);
  int compared = 0;
  double darkest = 1.0, brightest = 0.0;
  for (int j = 1; j + 1 < view.size.y; j += 3)
    for (int i = 1; i + 1 < view.size.x; i += 3) {
      const glm::ivec2 pixel(i, j), apex = nearestOf(focus, pixel);
      const glm::dvec2 aside(pixel - apex);
      const double away = glm::length(aside);
      // Well within the face, and not where two cones meet.
      if (away < 8.0 || !(layers.tStart[at(pixel)] > layers.tContext[at(pixel)] + 4.0)) continue;
      if (nearestOf(focus, pixel + glm::ivec2(1, 0)) != apex || nearestOf(focus, pixel - glm::ivec2(1, 0)) != apex ||
          nearestOf(focus, pixel + glm::ivec2(0, 1)) != apex || nearestOf(focus, pixel - glm::ivec2(0, 1)) != apex)
        continue;
      const glm::dvec3 outwards = (camera.axes().right * aside.x - camera.axes().up * aside.y) / away;
      const glm::dvec3 normal = std::cos(angle) * outwards + std::sin(angle) * camera.axes().forward;
      const double face = std::abs(glm::dot(normal, light));
      // The rest of the light is that of a surface of average orientation.
      const double expected = glm::mix(lighting::meanIncidence, face, lighting::wallShare);
      // The normal comes from differences over two pixels, eight or more away from the apex: within 1/6 · 1/64 of its
      // slope. The picture's bound is 0.5/255.
      EXPECT_NEAR(layers.final[at(pixel)].r, expected, 0.006) << i << ", " << j;
      darkest = std::min(darkest, expected);
      brightest = std::max(brightest, expected);
      ++compared;
    }
  EXPECT_GT(compared, 100);
  EXPECT_GT(brightest - darkest, 0.3) << "the test would notice";
}

}  // namespace
}  // namespace fenestra::tests
