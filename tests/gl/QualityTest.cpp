// The promises of draft and normal quality: the order of their errors, the details that they must not step over, and
// where the focus begins and ends. High quality is a bound on the error, which the hard cases hold.

#include <random>

#include "rendering/FrameOf.h"
#include "rendering/ViewSampling.h"
#include "rendering/reference/Picture.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests::qualityTest {
namespace {

constexpr glm::ivec2 size{64, 48};

using QualityErrors = GlTest;

/// Root mean square and greatest error of the focus layer, in 1/255 of the worst channel. Rays start where the
/// renderer's do.
struct Errors {
  double rms = 0.0, worst = 0.0;
};

Errors errorsOf(const Scene& scene, const Camera& camera, const Layers& layers) {
  reference::Stages stages;
  if (hasCutaway(scene)) {
    stages = reference::geometricStages(scene, camera, size);
    const auto widened = [](const std::vector<float>& values) {
      return reference::Image(values.begin(), values.end());
    };
    stages.hits.tContext = widened(layers.tContext);
    stages.hits.tFocus = widened(layers.tFocus);
    stages.tStart = widened(layers.tStart);
  }
  const reference::Picture truth = reference::picture(scene, camera, size, stages, {});
  Errors errors;
  for (std::size_t i = 0; i < truth.focusLayer.size(); ++i) {
    double worst = 0.0;
    for (int channel = 0; channel < 4; ++channel)
      worst = std::max(worst, 255.0 * std::abs(layers.focusLayer[i][channel] - truth.focusLayer[i][channel]));
    errors.rms += worst * worst;
    errors.worst = std::max(errors.worst, worst);
  }
  errors.rms = std::sqrt(errors.rms / static_cast<double>(truth.focusLayer.size()));
  return errors;
}

Errors errorsOf(const Scene& scene, const Camera& camera, Quality quality) {
  return errorsOf(scene, camera, renderOnce(scene, camera, size, quality).layers);
}

/// Waves that `across` voxels of 60 mm show, smooth at that scale.
Scene waves(int across) {
  const Grid grid = gridOf({across, across, across}, glm::dvec3(60.0 / across));
  Scene scene;
  scene.volume = volumeOf<float>(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = (glm::dvec3(i) + 0.5) / double(across) * 6.0;
    return 500.0 + 400.0 * std::sin(p.x + 0.7 * p.z) * std::cos(p.y - 0.4 * p.x);
  });
  scene.look.context.function = {
      {{100.0, {{1.0, 0.2, 0.1}, 0.0}}, {500.0, {{0.8, 0.7, 0.3}, 0.02}}, {900.0, {{0.2, 0.4, 1.0}, 0.05}}}};
  scene.look.shading.enabled = false;
  return scene;
}

Camera aside(const Scene& scene) { return Camera::fromAngles(33, 21, scene.volume->grid, Projection::Perspective); }

TEST_F(QualityErrors, NormalIsOfSecondOrder) {
  const Scene coarse = waves(24), fine = waves(48);
  const double one = errorsOf(coarse, aside(coarse), Quality::Normal).rms;
  const double half = errorsOf(fine, aside(fine), Quality::Normal).rms;
  EXPECT_GT(one, 0.01) << "too little to tell";
  // Half the voxels, a quarter of the error; a finer grid's trilinear field is another one, hence not quite.
  EXPECT_GT(one / half, 3.0) << one << " and " << half;
}

/// Air whose value is the very node where opacity begins, or ends, shows exactly nothing.
TEST_F(QualityErrors, AirAtTheNodeWhereOpacityBeginsStaysEmpty) {
  const Grid grid = gridOf({64, 64, 64});
  Scene scene;
  scene.volume = volumeOf<std::uint8_t>(grid, [](glm::ivec3 i) { return i == glm::ivec3(63) ? 200 : 100; });
  scene.look.shading.enabled = false;
  const OpticalProperties clear{{1.0, 1.0, 1.0}, 0.0}, dense{{1.0, 1.0, 1.0}, 0.36};
  const glm::dvec3 centre = grid.centre();
  // The rays pass the corner's voxel and its brick by.
  const Camera camera = lookAt(centre - glm::dvec3(0.0, 300.0, 0.0), centre, Projection::Orthographic, 40.0);
  for (const std::vector<TransferFunction::Node>& nodes :
       {std::vector<TransferFunction::Node>{{100.0, clear}, {110.0, dense}}, {{90.0, dense}, {100.0, clear}}}) {
    scene.look.context.function.nodes = nodes;
    for (const Quality quality : {Quality::Draft, Quality::Normal, Quality::High})
      for (const glm::vec4& colour : renderOnce(scene, camera, {48, 48}, quality).layers.final)
        ASSERT_EQ(colour, glm::vec4(0.0f));
  }
}

/// Around a cube whose faces lie on those of bricks, air that shows has no gradient, in any direction and however far.
TEST_F(QualityErrors, AirAroundASurfaceIsLitAsAir) {
  const Grid grid = gridOf({48, 48, 48});
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) {
    return glm::all(glm::greaterThanEqual(i, glm::ivec3(16))) && glm::all(glm::lessThan(i, glm::ivec3(31))) ? 400
                                                                                                            : -900;
  });
  const glm::dvec3 colour(0.9, 0.7, 0.5);
  scene.look.context.function = {{{-900.0, {colour, 0.03}}, {400.0, {colour, 0.2}}}};
  for (const Camera& camera : {aside(scene), Camera::fromAngles(-150, -40, grid, Projection::Perspective)}) {
    EXPECT_LE(errorsOf(scene, camera, Quality::High).worst, highQualityError);
    EXPECT_LE(errorsOf(scene, camera, Quality::Normal).worst, 8.0);  // a step edge between two voxels
  }
}

/// Cells that are 10 mm thick, in each of which a ray passes several nodes: ramps, a step, colours that alternate, and
/// opacities from next to nothing to all.
TEST_F(QualityErrors, BoundsHoldWhereThickCellsPassManyNodes) {
  Scene scene = waves(6);
  scene.look.context.function.nodes.clear();
  const std::array<double, 8> opacities{0.0, 0.83, 0.01, 0.3, 0.3, 0.0, 0.85, 0.05};
  for (int i = 0; i < 24; ++i) {
    const glm::dvec3 colour(i % 2, 0.5 + 0.5 * std::sin(i), i % 3 / 2.0);
    scene.look.context.function.nodes.push_back(
        {120.0 + 32.0 * (i - (i % 5 == 4)), {colour, extinctionFromOpacity(opacities[i % opacities.size()])}});
  }
  for (const bool lit : {false, true}) {
    scene.look.shading.enabled = lit;
    for (const double bound : {4.0, 1.0, 0.25}) {
      View view{aside(scene), size, 1.0, Quality::High};
      view.maxError = bound;
      Renderer renderer(std::make_shared<GpuScene>());
      renderer.render(scene, view);
      EXPECT_LE(errorsOf(scene, view.camera, renderer.readLayers()).worst, bound) << (lit ? "lit" : "unlit");
    }
  }
}

/// Normals that turn by more within a cell than a highlight is wide.
TEST_F(QualityErrors, BoundsHoldInHighlights) {
  Scene scene = waves(6);
  const glm::dvec3 dark(0.1, 0.15, 0.2);
  scene.look.context.function = {{{0.0, {dark, 0.2}}, {1000.0, {dark, 0.2}}}};
  scene.look.shading = {.enabled = true, .specular = 0.9};
  for (const double shininess : {8.0, 40.0, 100.0})
    for (const double bound : {4.0, 2.0, 1.0}) {
      scene.look.shading.shininess = shininess;
      View view{aside(scene), size, 1.0, Quality::High};
      view.maxError = bound;
      Renderer renderer(std::make_shared<GpuScene>());
      renderer.render(scene, view);
      EXPECT_LE(errorsOf(scene, view.camera, renderer.readLayers()).worst, bound) << shininess;
    }
}

/// Values without order from voxel to voxel, 4 mm apart, under functions of seven nodes: no cell's values change
/// evenly.
TEST_F(QualityErrors, NormalFollowsSteepFunctionsThroughCoarseVoxels) {
  std::mt19937 random(5);
  const auto share = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  Scene scene;
  scene.volume = volumeOf<float>(gridOf({12, 12, 12}, glm::dvec3(4.0)), [&](glm::ivec3) { return share(); });
  scene.look.shading.enabled = false;
  scene.look.reconstruction = Reconstruction::Linear;
  for (int picture = 0; picture < 4; ++picture) {
    scene.look.context.function.nodes.clear();
    for (int i = 0; i < 7; ++i)
      scene.look.context.function.nodes.push_back(
          {(i + 0.8 * share()) / 7.0, {{share(), share(), share()}, extinctionFromOpacity(0.35 * share())}});
    EXPECT_LT(errorsOf(scene, aside(scene), Quality::Normal).rms, 1.0) << "what normal quality promises";
    EXPECT_GT(errorsOf(scene, aside(scene), Quality::Draft).rms, 1.5) << "too little to tell";
  }
}

/// The sampling is all that the choice of a bound changes, so an equal one draws the same bits.
TEST_F(QualityErrors, OnlySteepUnlitPicturesOfNormalQualityChooseABound) {
  const auto drawn = [](const Scene& scene, const View& view) {
    GpuScene gpu;
    gpu.update(scene);
    return frameOf(scene, view, gpu, nullptr).sampling;
  };
  const auto expectAsBefore = [&](const Scene& scene, const View& view) {
    EXPECT_EQ(drawn(scene, view), samplingOf(view, scene.volume->grid, scene.look.shading.enabled));
  };
  const Scene smooth = waves(24);
  const View view{aside(smooth), size};
  expectAsBefore(smooth, view);
  Scene steep = waves(12);
  for (int i = 0; i < 24; ++i)
    steep.look.context.function.nodes.push_back({100.0 + 33.0 * i, {glm::dvec3(i % 2), i % 2 ? 0.0 : 0.3}});
  std::sort(steep.look.context.function.nodes.begin(), steep.look.context.function.nodes.end(),
            [](const auto& a, const auto& b) { return a.value < b.value; });
  EXPECT_EQ(drawn(steep, view).maxError, BoundChoice::bound / 255.0);
  for (const Quality quality : {Quality::Draft, Quality::High})
    expectAsBefore(steep, {.camera = view.camera, .size = size, .quality = quality});
  expectAsBefore(steep, {.camera = view.camera, .size = size, .maxError = 4.0});
  steep.look.shading.enabled = true;
  expectAsBefore(steep, view);
}

/// Opaque labels of several colours that meet within cells: each is as wide on the screen as its own voxels.
TEST_F(QualityErrors, NormalTellsLabelsApartWithinACell) {
  const Grid grid = gridOf({8, 8, 8}, glm::dvec3(7.5));
  Scene scene;
  scene.volume = volumeOf<std::uint8_t>(grid, [](glm::ivec3) { return 50; });
  scene.look.shading.enabled = false;
  scene.look.reconstruction = Reconstruction::Linear;
  auto labels = labelsOf(grid, [](glm::ivec3 i) { return 1 + (i.x + 2 * i.y + i.z) % 3; });
  labels->labels = {{1, "red", {0.9, 0.1, 0.1}}, {2, "green", {0.1, 0.8, 0.2}}, {3, "blue", {0.2, 0.2, 0.9}}};
  scene.labels = labels;
  scene.look.focus = LabelFocus{{1, 2, 3}};
  scene.look.cutaway.enabled = false;
  ASSERT_FALSE(BoundChoice().boundFor(scene, {aside(scene), size}));
  EXPECT_LT(errorsOf(scene, aside(scene), Quality::Normal).rms, 1.0) << "what normal quality promises";
}

TEST_F(QualityErrors, NormalLightsTheSideThatIsSeen) {
  // Surfaces that turn opaque within a voxel: lit where light comes from, not in the middle of what is behind it.
  Scene scene = waves(32);
  scene.look.context.function = {{{480.0, {{1.0, 0.7, 0.5}, 0.0}}, {520.0, {{1.0, 0.7, 0.5}, 4.0}}}};
  scene.look.shading.enabled = true;
  const double normal = errorsOf(scene, aside(scene), Quality::Normal).rms;
  EXPECT_LT(normal, 1.0) << "lit half way through each piece they would be off by 1.5";
}

TEST_F(QualityErrors, NormalLightsAFocusOfValuesByTheNormalsInItsCells) {
  // Coarse cells, in which the volume's normals turn fast along the focus's surface.
  Scene scene = waves(12);
  scene.look.focus = ValueFocus{{520.0, 900.0}, 0.0};
  scene.look.focusAppearance.extinction = 1.0;
  scene.look.context.function = {{{0.0, {{1.0, 1.0, 1.0}, 0.0}}}};
  scene.look.cutaway.enabled = false;
  scene.look.shading.enabled = true;
  // The error that normal quality must keep to; with one light and evenly varying normals it would be 2.06.
  EXPECT_LT(errorsOf(scene, aside(scene), Quality::Normal).rms, 1.0);
}

TEST_F(QualityErrors, NormalStepsOverNoThinLayer) {
  // Values that run evenly, and a layer a fifth of a voxel thick, nearly transparent: from face to face it is exact but
  // for its self-attenuation.
  const Grid grid = gridOf({40, 40, 40});
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return 100 * i.x + 60 * i.y; });
  scene.look.context.function = {{{3390.0, {glm::dvec3(1.0), 0.0}},
                                  {3390.0, {glm::dvec3(1.0), 0.5}},
                                  {3410.0, {glm::dvec3(1.0), 0.5}},
                                  {3410.0, {glm::dvec3(1.0), 0.0}}}};
  scene.look.shading.enabled = false;
  EXPECT_LE(errorsOf(scene, aside(scene), Quality::Normal).worst, 0.5);
  float most = 0.0f;
  for (const glm::vec4 pixel : renderOnce(scene, aside(scene), size, Quality::Normal).layers.final)
    most = std::max(most, pixel.a);
  EXPECT_GT(most, 10.0f / 255.0f) << "too little to miss";
}

TEST_F(QualityErrors, TheFocusEndsBetweenFacesInNormal) {
  // A focus of values in values that run evenly ends where they do, to float32; a label's surface is a cubic along a
  // ray, of which the chord is taken.
  Scene values;
  const Grid grid = gridOf({32, 32, 32});
  values.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return 50 * i.x + 20 * i.z; });
  values.look.focus = ValueFocus{{800.0, 1037.0}, 0.0};
  values.look.focusAppearance.extinction = 0.02;
  values.look.context.function = {{{0.0, {{0.2, 0.6, 1.0}, 0.01}}}};
  values.look.cutaway.enabled = false;
  values.look.shading.enabled = false;
  EXPECT_LE(errorsOf(values, aside(values), Quality::Normal).worst, 0.05);

  Scene labels = values;
  // Two labels, of two colours by their default.
  labels.labels =
      labelsOf(grid, [](glm::ivec3 i) { return glm::length(glm::dvec3(i) - 15.5) < 9.0 ? (i.x < 16 ? 1 : 2) : 0; });
  labels.look.focus = LabelFocus{{1, 2}};
  for (const bool cut : {false, true}) {
    labels.look.cutaway.enabled = cut;
    labels.look.cutaway.openWidth = 6.0;
    EXPECT_LT(errorsOf(labels, aside(labels), Quality::Normal).rms, 0.24) << cut;
  }
}

TEST_F(QualityErrors, RaysEndAtTheBordersAndAnywhereInside) {
  // Values at the border matter as much as any: from every side, and from an eye inside the volume.
  const Scene scene = waves(24);
  const Grid& grid = scene.volume->grid;
  for (const glm::dvec2 angles : {glm::dvec2(0, 0), glm::dvec2(90, 0), glm::dvec2(45, 35), glm::dvec2(200, -60)})
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
      const Camera camera = Camera::fromAngles(angles.x, angles.y, grid, projection);
      EXPECT_LE(errorsOf(scene, camera, Quality::Normal).worst, 2.0) << angles.x << ' ' << angles.y;
    }
  const Camera inside = lookAt(grid.centre(), grid.centre() + glm::dvec3(3.0, 20.0, 5.0));
  EXPECT_LE(errorsOf(scene, inside, Quality::Normal).worst, 2.0);
}

}  // namespace
}  // namespace fenestra::tests::qualityTest
