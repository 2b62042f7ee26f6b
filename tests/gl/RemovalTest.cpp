// Pictures of volumes that something was carved out of: as if the voxels had been read like that, as the reference has
// them, and back to the bit.

#include "rendering/reference/Picture.h"
#include "rendering/settings/SettingWords.h"
#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::removalTest {
namespace {

constexpr glm::ivec2 size{80, 66};

/// A body with an organ in focus; a ball removes a part of the organ, a saw and a bent plane cut beside it.
Scene carvedBody(const Focus& focus, const Method& method) {
  Scene scene = bodyWithOrgans<std::int16_t>(gridOf({40, 36, 34}));
  scene.look.context.function = {{{20.0, {glm::dvec3(0.8, 0.5, 0.4), 0.0}},
                                  {60.0, {glm::dvec3(0.9, 0.7, 0.6), 0.08}},
                                  {120.0, {glm::dvec3(1.0, 0.95, 0.9), 0.3}}}};
  scene.look.focus = focus;
  scene.look.method = method;
  const glm::dvec3 middle = scene.volume->grid.centre();
  Removal ball, saw, plane;
  ball.points = {middle + glm::dvec3(4.0, -10.0, 1.0), middle + glm::dvec3(5.0, -4.0, 1.0)};
  ball.size = 4.5;
  ball.softness = 2.0;
  saw.shape = RemovalShape::Saw;
  saw.points = {middle + glm::dvec3(-12.0, -14.0, 3.0), middle + glm::dvec3(-6.0, -16.0, -8.0)};
  saw.size = 3.0;
  saw.depth = 12.0;
  plane.shape = RemovalShape::Plane;
  plane.points = {middle + glm::dvec3(-20.0, 0.0, 11.0), middle + glm::dvec3(20.0, 3.0, 9.0),
                  middle + glm::dvec3(2.0, -18.0, 10.0)};
  plane.direction = {0.0, 0.0, 1.0};
  plane.bends = {{middle + glm::dvec3(0.0, -4.0, 10.0), -5.0, 9.0}};
  scene.look.removals = {ball, saw, plane};
  return scene;
}

std::vector<Focus> focuses() { return {LabelFocus{{1}}, ValueFocus{{95.0, 1000.0}, 0.0}, std::monostate{}}; }

View viewOf(const Scene& scene) {
  View view{.camera = Camera::fromAngles(25.0, 15.0, scene.volume->grid), .size = size};
  view.maxError = 1.0;
  return view;
}

class RemovalTest : public GlTest {
 protected:
  static std::shared_ptr<GpuScene> gpu() {
    if (!programs_) programs_ = std::make_shared<gl::ComputePrograms>();
    return std::make_shared<GpuScene>(programs_);
  }
  static void TearDownTestSuite() {
    programs_.reset();
    GlTest::TearDownTestSuite();
  }
  static std::vector<std::uint8_t> pictureOf(Renderer& renderer, const Scene& scene) {
    renderer.render(scene, viewOf(scene));
    return renderer.readPicture();
  }
  static std::vector<std::uint8_t> pictureOf(const Scene& scene) {
    Renderer renderer(gpu());
    return pictureOf(renderer, scene);
  }

 private:
  inline static gl::SharedPrograms programs_;
};

/// Share of the pixels, in per mille, that are off by more than the view's bound of 1/255.
double perMilleOff(const std::vector<glm::vec4>& picture, const std::vector<glm::dvec4>& truth) {
  EXPECT_EQ(picture.size(), truth.size());
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < std::min(picture.size(), truth.size()); ++i) {
    const glm::dvec4 off = 255.0 * glm::abs(glm::dvec4(picture[i]) - truth[i]);
    if (!(std::max({off.r, off.g, off.b, off.a}) <= 1.0)) ++beyond;
  }
  return 1000.0 * static_cast<double>(beyond) / static_cast<double>(truth.size());
}

TEST_F(RemovalTest, AreTheReferencesWithEveryFocusAndMethod) {
  const std::vector<Method> methods{{}, methods::Sculpt{}, methods::Bend{}, methods::Cone{}};
  for (const Focus& focus : focuses())
    for (const Method& method : methods) {
      SCOPED_TRACE(std::string(wordOf(method.kind).word) + ", focus " + std::to_string(focus.index()));
      const Scene scene = Sculptor().of(carvedBody(focus, method));
      const View view = viewOf(scene);
      Renderer renderer(gpu());
      renderer.render(scene, view);
      const reference::Stages stages = reference::geometricStages(scene, view);
      const reference::Picture truth = reference::picture(scene, view.camera, view.size, stages);
      // Rays that graze a surface or an opening's rim, as of the methods.
      EXPECT_LE(perMilleOff(renderer.readLayers().final, truth.final), 4.0);
    }
}

TEST_F(RemovalTest, AreTheReferencesWithASpline) {
  Scene scene = carvedBody(LabelFocus{{1}}, methods::Sculpt{});
  scene.look.reconstruction = Reconstruction::Smooth;
  scene = Sculptor().of(scene);
  Renderer renderer(gpu());
  renderer.render(scene, viewOf(scene));
  const reference::Stages stages = reference::geometricStages(scene, viewOf(scene));
  EXPECT_LE(
      perMilleOff(renderer.readLayers().final, reference::picture(scene, viewOf(scene).camera, size, stages).final),
      4.0);
}

TEST_F(RemovalTest, AreAsIfTheVoxelsHadBeenReadLikeThat) {
  for (const Focus& focus : focuses()) {
    const Scene scene = carvedBody(focus, {}), carved = Sculptor().of(scene);
    const ShownVolume shown = shownVolume(carved);
    const ShownVoxels voxels(shown);
    Scene read = scene;
    read.look.removals.clear();
    const auto volume =
        volumeOf<std::int16_t>(scene.volume->grid, [&](glm::ivec3 voxel) { return voxels.value(voxel); });
    volume->range = scene.volume->range;
    read.volume = volume;
    read.labels = carved.labels;
    EXPECT_EQ(pictureOf(carved), pictureOf(read)) << focus.index();
    Scene whole = scene;
    whole.look.removals.clear();
    EXPECT_NE(pictureOf(carved), pictureOf(whole)) << "the test would notice";
  }
}

TEST_F(RemovalTest, ComeBackToTheBitAndCostNothingWhereThereAreNone) {
  const Scene carved = carvedBody(LabelFocus{{1}}, {});
  Scene whole = carved;
  whole.look.removals.clear();
  const auto device = gpu();
  Renderer renderer(device);
  const auto bytes = [&] {
    std::size_t sum = 0;
    for (const GpuScene::Resource& each : device->resources()) sum += each.bytes;
    return sum;
  };
  Sculptor sculptor;
  const auto before = pictureOf(renderer, sculptor.of(whole));
  const std::size_t bytesBefore = bytes();
  const auto without = pictureOf(renderer, sculptor.of(carved));
  EXPECT_NE(without, before);
  // Part by part, as a user carves.
  Scene growing = whole;
  for (const Removal& each : carved.look.removals) {
    growing.look.removals.push_back(each);
    pictureOf(renderer, sculptor.of(growing));
  }
  EXPECT_EQ(pictureOf(renderer, sculptor.of(growing)), without);
  EXPECT_EQ(pictureOf(renderer, sculptor.of(whole)), before) << "undone";
  EXPECT_EQ(bytes(), bytesBefore);
}

TEST_F(RemovalTest, Thorough_OfEverythingLeaveNothing) {
  for (const Focus& focus : focuses())
    for (const MethodKind kind : {kindOf<methods::Adaptive>, kindOf<methods::Sculpt>, kindOf<methods::Importance>}) {
      Scene scene = carvedBody(focus, Method(kind));
      scene.look.removals.resize(1);
      scene.look.removals[0].size = 1000.0;
      Renderer renderer(gpu());
      renderer.render(Sculptor().of(scene), viewOf(scene));
      for (const glm::vec4& pixel : renderer.readLayers().final) EXPECT_EQ(pixel, glm::vec4(0.0f));
    }
}

}  // namespace
}  // namespace fenestra::tests::removalTest
