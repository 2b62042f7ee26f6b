// Exploded views: against the reference with every cut, what a pick means, and where the picture shows the volume.

#include "rendering/reference/Picture.h"
#include "rendering/scene/Explosion.h"
#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::explodedTest {
namespace {

constexpr glm::ivec2 size{72, 64};

Scene body(int planes, ExplosionAxes axes, double degree) {
  Scene scene = bodyWithOrgans<std::int16_t>(gridOf({40, 36, 34}, {1.0, 1.2, 0.9}, {-70.0, 300.0, 12.0}));
  scene.look.focus = LabelFocus{{1}};
  scene.look.method =
      methods::Explode{.degree = degree, .planes = static_cast<ExplosionPlanes>(planes - 1), .axes = axes};
  return scene;
}

class Exploded : public GlTest {
 protected:
  static void TearDownTestSuite() {
    gpu_.reset();
    GlTest::TearDownTestSuite();
  }
  static std::shared_ptr<GpuScene> gpu() {
    if (!gpu_) gpu_ = std::make_shared<GpuScene>();
    return gpu_;
  }
  static std::vector<glm::vec4> drawn(const Scene& scene, const View& view) {
    Renderer renderer(gpu());
    renderer.render(scene, view);
    return renderer.readLayers().final;
  }

 private:
  inline static std::shared_ptr<GpuScene> gpu_;
};

View viewOf(const Scene& scene, double azimuth, double elevation, Projection projection = Projection::Perspective) {
  View view{.camera = Camera::fromAngles(azimuth, elevation, scene.volume->grid, projection).zoomed(0.7), .size = size};
  view.maxError = 1.0;
  return view;
}

/// Number of pixels whose colour is off by more than a limit in 1/255.
template <class Colour>
int beyond(double bound, const std::vector<glm::vec4>& picture, const std::vector<Colour>& truth) {
  EXPECT_EQ(picture.size(), truth.size());
  int count = 0;
  for (std::size_t i = 0; i < std::min(picture.size(), truth.size()); ++i) {
    const glm::dvec4 off = 255.0 * glm::abs(glm::dvec4(picture[i]) - glm::dvec4(truth[i]));
    count += !(std::max({off.r, off.g, off.b, off.a}) <= bound);
  }
  return count;
}

TEST_F(Exploded, Thorough_EveryCutMatchesTheReference) {
  for (const ExplosionAxes axes : {ExplosionAxes::Patient, ExplosionAxes::View})
    for (int planes = 1; planes <= 3; ++planes)
      for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
        for (const double degree : {0.05, 0.9}) {
          SCOPED_TRACE(testing::Message() << planes << ", " << static_cast<int>(axes) << ", " << degree);
          const Scene scene = body(planes, axes, degree);
          const View view = viewOf(scene, 35.0, 20.0, projection);
          const std::vector<glm::vec4> here = drawn(scene, view);
          // Where a ray grazes a part's face or edge, rounding decides what it meets: four in a thousand.
          EXPECT_LE(beyond(1.0, here, reference::picture(scene, view).final), 4 * size.x * size.y / 1000);
          Scene plain = scene;
          plain.look.cutaway.enabled = false;
          EXPECT_GT(beyond(4.0, here, drawn(plain, view)), size.x * size.y / 50) << "the test would notice";
        }
}

TEST_F(Exploded, AnEyeBetweenTheParts) {
  const Scene scene = body(3, ExplosionAxes::Patient, 1.0);
  const Grid& grid = scene.volume->grid;
  for (const glm::dvec3 offset : {glm::dvec3(0.0), glm::dvec3(3.0, -9.0, 2.0), glm::dvec3(-1.0, 30.0, -4.0)}) {
    View view = viewOf(scene, 0.0, 0.0);
    view.camera = lookAt(grid.centre() + offset, grid.centre() + offset + glm::dvec3(0.3, 1.0, 0.2));
    view.camera.verticalFov = 90.0;
    EXPECT_LE(beyond(1.0, drawn(scene, view), reference::picture(scene, view).final), 4 * size.x * size.y / 1000);
  }
}

/// The faces of the parts in grey, with planes that clip the volume, too, and without; the hollow shows none.
TEST_F(Exploded, Thorough_FacesAreGreyAsThoseOfClippingAre) {
  for (const bool isClipped : {false, true}) {
    Scene scene = body(2, ExplosionAxes::Patient, 0.8);
    const View view = viewOf(scene, 35.0, 20.0);
    const std::vector<glm::vec4> coloured = drawn(scene, view);
    scene.look.clipping.grey = WindowLevel{160.0, 80.0};
    if (isClipped) scene = clipped(scene, true);
    const std::vector<glm::vec4> here = drawn(scene, view);
    EXPECT_LE(beyond(1.0, here, reference::picture(scene, view).final), 4 * size.x * size.y / 1000);
    EXPECT_GT(beyond(4.0, here, coloured), size.x * size.y / 50);
  }
}

TEST_F(Exploded, AtDegreeZeroItIsThePlainPictureToTheBit) {
  const Scene scene = body(3, ExplosionAxes::Patient, 0.0);
  Scene plain = scene;
  plain.look.cutaway.enabled = false;
  for (const Quality quality : {Quality::Draft, Quality::Normal, Quality::High}) {
    View view = viewOf(scene, 35.0, 20.0);
    view.maxError.reset();
    view.quality = quality;
    EXPECT_EQ(drawn(scene, view), drawn(plain, view));
  }
}

/// The context has no extinction, so that only the focus shows, in its place.
TEST_F(Exploded, TheFocusStaysInItsPlace) {
  Scene scene = body(3, ExplosionAxes::Patient, 0.8);
  for (TransferFunction::Node& node : scene.look.context.function.nodes) node.properties.extinction = 0.0;
  Scene plain = scene;
  plain.look.cutaway.enabled = false;
  const View view = viewOf(scene, 35.0, 20.0);
  const std::vector<glm::vec4> here = drawn(scene, view), there = drawn(plain, view);
  // Two pictures, each within a bound of 1.
  EXPECT_EQ(beyond(2.0, here, there), 0);
  EXPECT_GT(std::count_if(there.begin(), there.end(), [](const glm::vec4& pixel) { return pixel.a > 0.9f; }), 10);
}

/// A pick in the exploded view gives the place in the volume, which the picture shows where the pick was made.
TEST_F(Exploded, PicksAreOfTheVolumeAndShowWhereTheyWerePicked) {
  for (const ExplosionAxes axes : {ExplosionAxes::Patient, ExplosionAxes::View}) {
    const Scene scene = body(3, axes, 0.8);
    const Grid& grid = scene.volume->grid;
    const View view = viewOf(scene, 35.0, 20.0);
    Renderer renderer(gpu());
    renderer.render(scene, view);
    ASSERT_TRUE(renderer.movesContext());
    const std::vector<glm::vec4> picture = renderer.readLayers().final;
    int picked = 0, moved = 0;
    for (int j = 0; j < size.y; j += 3)
      for (int i = 0; i < size.x; i += 3) {
        const glm::dvec2 pixel(i + 0.5, j + 0.5);
        const auto place = renderer.pick(pixel);
        const float alpha = picture[static_cast<std::size_t>(j * size.x + i)].a;
        if (alpha == 0.0f) {
          EXPECT_FALSE(place) << i << ", " << j;
        }
        if (!place) continue;
        ++picked;
        const glm::dvec3 index(grid.indexFromWorld() * glm::dvec4(*place, 1.0));
        EXPECT_TRUE(glm::all(glm::greaterThan(index, glm::dvec3(-0.51)))) << "in the volume";
        EXPECT_TRUE(glm::all(glm::lessThan(index, glm::dvec3(grid.dims) - 0.49)));
        // Within a voxel of the focus, the place counts as the focus's.
        bool isBesideFocus = false;
        forEachVoxel(glm::ivec3(4), [&](glm::ivec3 step) {
          const glm::ivec3 voxel = glm::ivec3(glm::floor(index)) + step - 1;
          isBesideFocus |= grid.contains(voxel) && scene.labels->value(voxel) == 1;
        });
        if (isBesideFocus) continue;
        // On a cut face rounding decides which part a place belongs to: a little further into what is seen.
        const reference::Ray ray = reference::pixelRay(view.camera, view.size, {i, j});
        const glm::dvec3 shown = renderer.shownAt(*place + 1e-3 * ray.direction);
        const glm::dvec3 from = shown - ray.origin;
        const double off = glm::length(from - glm::dot(from, ray.direction) * ray.direction);
        EXPECT_LT(off, 2e-3) << "not on the pixel's ray: " << i << ", " << j;
        moved += glm::distance(shown, *place) > 2.0;
      }
    EXPECT_GT(picked, 60);
    EXPECT_GT(moved, picked / 3);
    EXPECT_FALSE(renderer.pickBrush({30.5, 30.5}, BrushMode::Open)) << "no place for a brush";
  }
}

TEST_F(Exploded, ThePickOfTheFocusIsItsPlace) {
  const Scene scene = body(2, ExplosionAxes::Patient, 1.0);
  const View view = viewOf(scene, 0.0, 0.0);
  Renderer renderer(gpu());
  renderer.render(scene, view);
  const glm::dvec3 middle = reference::focusCentre(scene);
  // The parts have left the line of sight to the focus's middle, which is seen from anterior between them.
  const reference::HitPoints hits = reference::hitPoints(scene, view.camera, view.size);
  int seen = 0;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const double t = hits.tFocus[static_cast<std::size_t>(j * size.x + i)];
      if (std::isnan(t)) continue;
      const auto place = renderer.pick({i + 0.5, j + 0.5});
      if (!place) continue;
      const reference::Ray ray = reference::pixelRay(view.camera, view.size, {i, j});
      seen += glm::distance(*place, ray.origin + t * ray.direction) < 2e-3;
    }
  EXPECT_GT(seen, 5);
  EXPECT_EQ(renderer.shownAt(middle), middle);
  // Far outside of the volume there is a part, too, and nothing is read beyond the focus's index.
  for (const double far : {1e3, -1e3, 1e12, -1e12}) {
    const glm::dvec3 outside = middle + glm::dvec3(far);
    EXPECT_TRUE(std::isfinite(glm::length(renderer.shownAt(outside))));
  }
}

/// Marks are drawn over the last picture while another view has already brought the shared scene to its next state.
TEST_F(Exploded, PlacesAreShownAlsoWhenTheSharedSceneHasLostItsFocus) {
  Scene scene = body(2, ExplosionAxes::Patient, 0.5);
  const View view = viewOf(scene, 0.0, 0.0);
  const auto gpu = std::make_shared<GpuScene>();
  Renderer behind(gpu), ahead(gpu);
  behind.render(scene, view);
  scene.look.focus = std::monostate{};
  ahead.render(scene, view);
  EXPECT_TRUE(std::isfinite(glm::length(behind.shownAt(scene.volume->grid.centre()))));
}

}  // namespace
}  // namespace fenestra::tests::explodedTest
