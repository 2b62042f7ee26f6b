// Pictures with a layer peeled off: against the reference with every focus, to the bit where nothing is peeled, and
// what a pick means.

#include "rendering/reference/Peeled.h"
#include "rendering/reference/Picture.h"
#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::peeledTest {
namespace {

constexpr glm::ivec2 size{64, 56};

Scene body(const Focus& focus, double amount, PeelSide side = PeelSide::Anterior) {
  Scene scene = bodyWithOrgans<std::int16_t>(gridOf({40, 36, 34}, {1.0, 1.2, 0.9}, {-70.0, 300.0, 12.0}));
  scene.look.focus = focus;
  scene.look.method = methods::Peel{.amount = amount, .side = side, .radius = 5.0, .margin = 3.0};
  return scene;
}

std::vector<Focus> focuses() { return {LabelFocus{{1}}, ValueFocus{{95.0, 1000.0}, 0.0}, std::monostate{}}; }

View viewOf(const Scene& scene, double azimuth, double elevation) {
  View view{.camera = Camera::fromAngles(azimuth, elevation, scene.volume->grid), .size = size};
  view.maxError = 1.0;
  return view;
}

class Peeled : public GlTest {
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

/// Pixels whose colour is off by more than the view's bound.
int beyond(const std::vector<glm::vec4>& picture, const std::vector<glm::dvec4>& truth) {
  EXPECT_EQ(picture.size(), truth.size());
  int count = 0;
  for (std::size_t i = 0; i < std::min(picture.size(), truth.size()); ++i) {
    const glm::dvec4 off = 255.0 * glm::abs(glm::dvec4(picture[i]) - truth[i]);
    count += !(std::max({off.r, off.g, off.b, off.a}) <= 1.0);
  }
  return count;
}

TEST_F(Peeled, Exhaustive_AreTheReferencesWithEveryFocus) {
  for (const Focus& focus : focuses())
    for (const PeelSide side : {PeelSide::Anterior, PeelSide::Superior})
      for (const double amount : {0.3, 1.0}) {
        SCOPED_TRACE(testing::Message() << focus.index() << ", " << static_cast<int>(side) << ", " << amount);
        const Scene scene = body(focus, amount, side);
        const View view = viewOf(scene, 25.0, 20.0);
        const std::vector<glm::vec4> here = drawn(scene, view);
        const reference::Picture truth = reference::picture(scene, view);
        // Where a ray grazes the focus, rounding decides what it meets: four in a thousand.
        EXPECT_LE(beyond(here, truth.final), size.x * size.y / 250);
        Scene plain = scene;
        plain.look.cutaway.enabled = false;
        EXPECT_GT(beyond(here, reference::picture(plain, view).final), size.x * size.y / 50) << "the test would notice";
      }
}

TEST_F(Peeled, Thorough_AreTheReferencesClippedHiddenAndSmoothed) {
  std::vector<Scene> scenes(3, body(LabelFocus{{1}}, 0.8));
  scenes[0] = clipped(scenes[0], true);
  put(scenes[1].look.labels, {.label = 2, .role = LabelRole::Hidden});
  scenes[1] = occluded(scenes[1]);
  scenes[2].look.reconstruction = Reconstruction::Smooth;
  scenes[2].look.labelSmoothing = LabelSmoothing::Strong;
  for (const Scene& scene : scenes) {
    SCOPED_TRACE(&scene - scenes.data());
    const View view = viewOf(scene, 25.0, 20.0);
    EXPECT_LE(beyond(drawn(scene, view), reference::picture(scene, view).final), size.x * size.y / 250);
  }
}

TEST_F(Peeled, Thorough_NothingPeeledIsThePlainPictureToTheBitAndCostsNothing) {
  for (const Focus& focus : focuses()) {
    const Scene scene = body(focus, 0.0);
    Scene plain = scene;
    plain.look.cutaway.enabled = false;
    for (const Quality quality : {Quality::Draft, Quality::Normal, Quality::High}) {
      View view = viewOf(scene, 35.0, 20.0);
      view.maxError.reset();
      view.quality = quality;
      EXPECT_EQ(drawn(scene, view), drawn(plain, view));
    }
    EXPECT_EQ(gpu()->peeled(scene), nullptr);
  }
  // Back from a peeled one, the volume is the scene's own again.
  const Scene scene = body(LabelFocus{{1}}, 0.6);
  Scene plain = scene;
  plain.look.method.of<methods::Peel>().amount = 0.0;
  const View view = viewOf(scene, 35.0, 20.0);
  Renderer renderer(gpu());
  renderer.render(plain, view);
  const auto before = renderer.readPicture();
  renderer.render(scene, view);
  EXPECT_NE(renderer.readPicture(), before);
  EXPECT_TRUE(gpu()->holds(scene));
  EXPECT_FALSE(gpu()->holds(plain));
  renderer.render(plain, view);
  EXPECT_EQ(renderer.readPicture(), before);
  EXPECT_FALSE(gpu()->holds(scene));
}

TEST_F(Peeled, OnlyWhatTheLayerDependsOnIsMadeAgain) {
  const Scene scene = body(LabelFocus{{1}}, 0.6);
  const View view = viewOf(scene, 35.0, 20.0);
  Renderer renderer(gpu());
  renderer.render(scene, view);
  const GpuScene::Versions before = gpu()->versions();
  Scene changed = scene;
  changed.look.shading.ambient = 0.9;
  changed.look.cutaway.openWidth = 90.0;
  changed.look.method.of<methods::Explode>().degree = 0.9;
  renderer.render(changed, viewOf(scene, 40.0, 20.0));
  EXPECT_EQ(gpu()->versions(), before);
  changed.look.method.of<methods::Peel>().radius = 9.0;
  renderer.render(changed, view);
  EXPECT_NE(gpu()->versions().volume, before.volume);
}

/// A pick gives the place in the volume, which the picture shows where the pick was made.
TEST_F(Peeled, PicksAreOfTheVolumeAndShowWhereTheyWerePicked) {
  const Scene scene = body(LabelFocus{{1}}, 0.9);
  const Grid& grid = scene.volume->grid;
  const View view = viewOf(scene, 10.0, 15.0);
  Renderer renderer(gpu());
  renderer.render(scene, view);
  ASSERT_TRUE(renderer.movesContext());
  const std::vector<glm::vec4> picture = renderer.readLayers().final;
  int picked = 0, moved = 0, inFocus = 0;
  for (int j = 0; j < size.y; j += 2)
    for (int i = 0; i < size.x; i += 2) {
      const auto place = renderer.pickPlace(glm::dvec2(i, j) + 0.5);
      if (picture[static_cast<std::size_t>(j * size.x + i)].a == 0.0f) {
        EXPECT_FALSE(place) << i << ", " << j;
      }
      if (!place) continue;
      ++picked;
      EXPECT_NEAR(glm::length(place->ray), 1.0, 1e-9);
      const glm::dvec3 index(grid.indexFromWorld() * glm::dvec4(place->place, 1.0));
      const glm::ivec3 voxel(glm::floor(index + 0.5));
      ASSERT_TRUE(grid.contains(voxel));
      inFocus += scene.labels->value(voxel) == 1;
      const glm::dvec3 shown = renderer.shownAt(place->place);
      const reference::Ray ray = reference::pixelRay(view.camera, view.size, {i, j});
      const glm::dvec3 from = shown - ray.origin;
      // Positions on rays are floats of some 100 mm.
      EXPECT_LT(glm::length(from - glm::dot(from, ray.direction) * ray.direction), 1e-3) << i << ", " << j;
      moved += glm::distance(shown, place->place) > 2.0;
    }
  EXPECT_GT(picked, 100);
  EXPECT_GT(moved, picked / 10);
  EXPECT_GT(inFocus, 3);
  EXPECT_FALSE(renderer.pickBrush({30.5, 30.5}, BrushMode::Open)) << "no place for a brush";
  const glm::dvec3 middle = reference::focusCentre(scene);
  EXPECT_EQ(renderer.shownAt(middle), middle);
  for (const double far : {1e3, -1e3, 1e12, -1e12})
    EXPECT_TRUE(std::isfinite(glm::length(renderer.shownAt(middle + far))));
}

/// Seen along its axis, nothing lies before the focus: its first hits are those of the focus alone.
TEST_F(Peeled, TheFocusShowsWholeFromItsSide) {
  Scene scene = body(LabelFocus{{1}}, 1.0);
  scene.look.method.of<methods::Peel>().depth = 1.0;
  scene.look.method.of<methods::Peel>().margin = 1.0;
  View view = viewOf(scene, 0.0, 0.0);
  view.camera = Camera::standard(StandardView::Anterior, scene.volume->grid, Projection::Orthographic);
  Renderer renderer(gpu());
  renderer.render(scene, view);
  const reference::HitPoints hits = reference::hitPoints(scene, view.camera, view.size);
  int seen = 0, met = 0;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) {
      const double t = hits.tFocus[static_cast<std::size_t>(j * size.x + i)];
      if (std::isnan(t)) continue;
      ++met;
      const auto place = renderer.pick(glm::dvec2(i, j) + 0.5);
      const reference::Ray ray = reference::pixelRay(view.camera, view.size, {i, j});
      // Around the focus the soft face of the hollow begins up to a voxel before it.
      seen += place && glm::distance(*place, ray.origin + t * ray.direction) < 1.2;
    }
  EXPECT_GT(met, 20);
  EXPECT_EQ(seen, met);
}

}  // namespace
}  // namespace fenestra::tests::peeledTest
