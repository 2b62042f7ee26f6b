// Facts about a scene on the GPU that the CPU can ask for.

#include <optional>

#include <epoxy/gl.h>

#include "rendering/gl/Texture.h"
#include "rendering/gpu/FittedScene.h"
#include "rendering/gpu/FocusIndexing.h"
#include "rendering/scene/Thinned.h"
#include "rendering/scene/VisibleFraming.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests::gpuSceneTest {
namespace {

using GpuSceneTest = GlTest;

TEST_F(GpuSceneTest, FocusCentreIsTheSameWithAndWithoutIt) {
  // A block of 4×3×2 voxels and a lone voxel, whose eight cells are too few to be kept.
  Scene scene = valueScene(
      obliqueGrid({24, 9, 8}),
      [](glm::ivec3 v) {
        const bool isBlock = v.x >= 2 && v.x <= 5 && v.y >= 2 && v.y <= 4 && v.z >= 2 && v.z <= 3;
        return isBlock || v == glm::ivec3(20, 7, 6) ? 100.0 : 0.0;
      },
      50.0);
  const Grid& grid = scene.volume->grid;
  std::get<ValueFocus>(scene.look.focus).minimumComponent = 9.0 * grid.voxelVolume();
  GpuScene gpu;
  gpu.update(scene);
  ASSERT_TRUE(gpu.focus().centre(grid));
  EXPECT_EQ(gpu.focus().centre(grid), focusCentre(scene));
  const glm::dvec3 block(grid.worldFromIndex() * glm::dvec4(3.5, 3.0, 2.5, 1.0));
  EXPECT_LT(glm::distance(*gpu.focus().centre(grid), block), 1e-9);
}

/// A ball in a box of soft tissue with a label map of both.
Scene largeScene() {
  Scene scene;
  const Grid grid = obliqueGrid({61, 40, 33});
  const auto isBall = [](glm::ivec3 v) { return glm::distance(glm::dvec3(v), glm::dvec3(34, 18, 15)) < 9.0; };
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 v) {
    return isBall(v) ? 900.0 : v.x > 5 && v.y > 4 && v.z > 4 ? 30.0 + v.x : -900.0;
  });
  scene.labels = labelsOf(grid, [&](glm::ivec3 v) { return isBall(v) ? 3 : 0; });
  scene.look.context.function = opaqueFrom(0.0);
  scene.look.focus = LabelFocus{{3}};
  scene.look.contextLayer.strength = 1.0;
  return scene;
}

std::vector<std::uint8_t> pictureOf(const Scene& scene, const std::optional<DeviceLimits>& limits = {},
                                    const std::optional<View>& view = {}) {
  const auto gpu = std::make_shared<GpuScene>();
  if (limits) gpu->setLimits(*limits);
  Renderer renderer(gpu);
  const View anterior{.camera = Camera::standard(StandardView::Anterior, scene.volume->grid), .size = {90, 70}};
  renderer.render(scene, view.value_or(anterior));
  return renderer.readPicture();
}

double meanDifference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
  return sum / static_cast<double>(a.size());
}

TEST_F(GpuSceneTest, ATransferFunctionThatShowsMoreRebuildsTheGradientOnceAtMost) {
  Scene scene = largeScene();
  scene.look.focus = {};
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  const auto show = [&](double leastValue) {
    scene.look.context.function = opaqueFrom(leastValue);
    renderer.render(scene, {.camera = Camera::standard(StandardView::Anterior, scene.volume->grid), .size = {90, 70}});
  };
  show(700.0);
  const std::uint64_t first = gpu->versions().gradient;
  for (const double leastValue : {500.0, 0.0, -500.0, 600.0, -800.0}) {
    show(leastValue);
    EXPECT_EQ(renderer.readPicture(), pictureOf(scene)) << leastValue << ": as from the beginning";
    EXPECT_LE(gpu->versions().gradient, first + 1);
  }
  EXPECT_EQ(gpu->versions().gradient, first + 1);
}

/// Placing cameras makes nothing that only pictures read, takes nothing away from them, and what is missing is made
/// later.
TEST_F(GpuSceneTest, FirstHitsTakeNoMemoryForLightAndEdges) {
  Scene scene = largeScene();
  scene.look.shading.enabled = true;
  const View anterior{.camera = Camera::standard(StandardView::Anterior, scene.volume->grid), .size = {90, 70}};
  const auto gpu = std::make_shared<GpuScene>();
  gpu->update(scene, GpuScene::Use::FirstHits);
  EXPECT_FALSE(gpu->gradient());
  EXPECT_FALSE(gpu->derivative().texture);
  EXPECT_FALSE(gpu->focusSmooth());
  EXPECT_TRUE(gpu->volume().texture);
  EXPECT_TRUE(gpu->focusBricks());
  Renderer renderer(gpu);
  renderer.render(scene, anterior);
  EXPECT_EQ(renderer.readPicture(), pictureOf(scene));
  EXPECT_TRUE(gpu->gradient());
  EXPECT_TRUE(gpu->derivative().texture);

  const GpuScene::Versions before = gpu->versions();
  gpu->update(scene, GpuScene::Use::FirstHits);
  EXPECT_EQ(gpu->versions(), before);
  scene.look.context.function = opaqueFrom(-950.0);
  gpu->update(scene, GpuScene::Use::FirstHits);
  renderer.render(scene, anterior);
  EXPECT_EQ(renderer.readPicture(), pictureOf(scene));
}

/// While a slider moves, pictures without occlusion and shadow follow, and what casts shadows waits for rest.
TEST_F(GpuSceneTest, PicturesWithoutOcclusionLeaveOccludersAlone) {
  Scene scene = largeScene();
  scene.look.shading.enabled = true;
  scene.look.shading.occlusion = scene.look.shading.shadow = 0.5;
  View moving{.camera = Camera::standard(StandardView::Anterior, scene.volume->grid), .size = {90, 70}};
  View rest = moving;
  moving.occlusion = false;
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  renderer.render(scene, moving);
  EXPECT_EQ(gpu->versions().occluders, 0u);
  EXPECT_TRUE(gpu->holds(scene, false));
  EXPECT_FALSE(gpu->holds(scene));
  renderer.render(scene, rest);
  EXPECT_TRUE(gpu->holds(scene));
  const std::uint64_t made = gpu->versions().occluders;

  Scene unlit = scene;
  unlit.look.context.function = scene.look.context.function = opaqueFrom(-950.0);
  unlit.look.shading.occlusion = unlit.look.shading.shadow = 0.0;
  renderer.render(scene, moving);
  EXPECT_EQ(gpu->versions().occluders, made);
  EXPECT_FALSE(gpu->holds(scene));
  EXPECT_EQ(renderer.readPicture(), pictureOf(unlit));
  gpu->update(scene, GpuScene::Use::FirstHits);
  EXPECT_EQ(gpu->versions().occluders, made);
  renderer.render(scene, rest);
  EXPECT_GT(gpu->versions().occluders, made);
  EXPECT_TRUE(gpu->holds(scene));
  EXPECT_EQ(renderer.readPicture(), pictureOf(scene));

  scene.look.shading.occlusion = scene.look.shading.shadow = 0.0;
  renderer.render(scene, moving);
  EXPECT_GT(gpu->versions().occluders, made + 1) << "what a look has no use for is dropped";
}

TEST_F(GpuSceneTest, AVolumeBeyondTheLimitsIsDrawnWithWholeVoxelsJoined) {
  for (const bool values : {false, true}) {
    Scene scene = largeScene();
    if (values) scene.look.focus = ValueFocus{{800.0, 1000.0}, 0.0};
    GpuScene gpu;
    gpu.setLimits({.side = 32, .bytes = {}});
    gpu.update(scene);
    EXPECT_EQ(gpu.reduction(), glm::ivec3(2, 2, 2));
    EXPECT_NE(gpu.reductionNotice().find("2×2×2"), std::string::npos);
    const Scene thin{thinned(shownVolume(scene), {2, 2, 2}), thinned(*scene.labels, {2, 2, 2}), scene.look};
    EXPECT_EQ(gpu.grid(), thin.volume->grid);
    // The camera frames the whole volume in both.
    Renderer direct(std::make_shared<GpuScene>());
    direct.render(thin, {.camera = Camera::standard(StandardView::Anterior, scene.volume->grid), .size = {90, 70}});
    const std::vector<std::uint8_t> reduced = pictureOf(scene, DeviceLimits{32, {}});
    EXPECT_EQ(reduced, direct.readPicture()) << "as if the thinned volume had been opened";
    // In 1/255: voxels of twice the size move edges by a fraction of a voxel.
    EXPECT_LT(meanDifference(reduced, pictureOf(scene)), 8.0);
    EXPECT_NE(reduced, pictureOf(scene));
  }
}

TEST_F(GpuSceneTest, FactorsFollowTheMemoryAndTheFinestAxis) {
  const Scene scene = largeScene();  // spacing 0.7, 1.3 and 2.1 mm
  const std::size_t whole = deviceBytes(scene, glm::ivec3(1));
  EXPECT_EQ(fittingFactor(scene, {2048, whole}), glm::ivec3(1));
  EXPECT_EQ(fittingFactor(scene, {2048, {}}), glm::ivec3(1));
  // Fewer voxels than are worth thinning.
  EXPECT_EQ(fittingFactor(scene, {2048, 1000}), glm::ivec3(1));
  Scene large = scene;
  large.volume = volumeOf<std::int16_t>(gridOf({128, 96, 80}, {0.7, 1.3, 2.1}), [](glm::ivec3 v) { return v.x; });
  const std::size_t bytes = deviceBytes(large, glm::ivec3(1));
  EXPECT_EQ(fittingFactor(large, {2048, bytes - 1}), glm::ivec3(2, 1, 1));
  EXPECT_EQ(fittingFactor(large, {100, {}}), glm::ivec3(2, 1, 1));
}

TEST_F(GpuSceneTest, TheTableIsHiddenAsIfItWereAir) {
  Scene scene = largeScene();
  const auto inBody = [](glm::ivec3 v) { return glm::length(glm::dvec3(v) - glm::dvec3(24.0, 20.0, 18.0)) < 14.0; };
  const Grid grid = gridOf({48, 40, 36});
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 v) { return inBody(v) ? 60 : v.y > 36 ? 100 : -1000; });
  scene.table = tableWhere(grid, [](glm::ivec3 v) { return v.y > 36; });
  scene.labels = nullptr;
  scene.look.focus = {};
  const auto hidden = pictureOf(scene);
  Scene cleared = scene;
  cleared.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 v) { return inBody(v) ? 60 : -1000; });
  cleared.table = nullptr;
  EXPECT_EQ(hidden, pictureOf(cleared));
  Scene shown = scene;
  shown.look.hideTable = false;
  EXPECT_EQ(shownVolume(shown), ShownVolume{scene.volume});
  EXPECT_NE(pictureOf(shown), hidden);
  // A GpuScene that holds one setting follows a change to the other, both ways.
  GpuScene gpu;
  gpu.update(scene);
  const std::uint64_t first = gpu.versions().volume;
  gpu.update(scene);
  EXPECT_EQ(gpu.versions().volume, first);
  gpu.update(shown);
  EXPECT_GT(gpu.versions().volume, first);
  // Without a table, hiding is no change.
  scene.table = std::make_shared<CoarseMask>();
  gpu.update(scene);
  const std::uint64_t second = gpu.versions().volume;
  scene.look.hideTable = false;
  gpu.update(scene);
  EXPECT_EQ(gpu.versions().volume, second);
}

TEST_F(GpuSceneTest, HiddenLabelsAreAirFocusAndHaveNoHits) {
  for (const bool lit : {false, true})
    for (const Focus& focus : {Focus(LabelFocus{{3}}), Focus(ValueFocus{{800.0, 1000.0}, 0.0}), Focus()}) {
      Scene scene = largeScene();
      const Grid& grid = scene.volume->grid;
      const auto isBone = [](glm::ivec3 v) { return glm::length(glm::dvec2(v.x - 20, v.z - 12)) < 4.0; };
      const auto valueAt = [&](glm::ivec3 v) {
        const double before = scene.volume->value(v);
        return isBone(v) && before > 0.0 ? 900.0 : before;
      };
      const auto whole = volumeOf<std::int16_t>(grid, valueAt);
      const auto cleared = volumeOf<std::int16_t>(
          grid, [&](glm::ivec3 v) { return isBone(v) ? std::min(valueAt(v), -900.0) : valueAt(v); });
      scene.labels = labelsOf(grid, [labels = scene.labels, &isBone](glm::ivec3 v) {
        return isBone(v) ? 5 : static_cast<int>(labels->value(v));
      });
      scene.look.focus = focus;
      scene.look.shading.enabled = lit;
      Scene hidden = scene, expected = scene;
      hidden.volume = whole;
      put(hidden.look.labels, {.label = 5, .role = LabelRole::Hidden});
      expected.volume = cleared;
      EXPECT_EQ(whole->range, cleared->range);
      EXPECT_EQ(pictureOf(hidden), pictureOf(expected));
      EXPECT_EQ(pictureOf(hidden, DeviceLimits{32, {}}), pictureOf(expected, DeviceLimits{32, {}})) << "thinned";
      scene.volume = whole;
      if (std::holds_alternative<ValueFocus>(focus)) {
        EXPECT_NE(pictureOf(hidden), pictureOf(scene)) << "the bone would be in focus";
      }
      EXPECT_EQ(visibleGrid(shownVolume(hidden), scene.look.context.function),
                visibleGrid(shownVolume(expected), scene.look.context.function));
      EXPECT_EQ(focusCentre(hidden), focusCentre(expected));
    }
}

/// All texels of a texture or bytes of a buffer that the shaders read of a focus, apart from the order of its slots.
struct FocusObjects {
  std::vector<std::uint16_t> skip, occupied;
  std::vector<std::uint32_t> cells;  ///< per brick: 0, 1, or 2 and the words of its slot
  std::vector<std::uint16_t> smooth;
  glm::ivec3 smoothOrigin{0};
  bool operator==(const FocusObjects&) const = default;
};

FocusObjects objectsOf(const GpuScene& gpu) {
  FocusObjects objects;
  const auto bricks = static_cast<std::size_t>(gpu.focus().slots.size());
  objects.skip.resize(bricks);
  gpu.focusSkip().readInto(std::span(objects.skip));
  objects.occupied.resize(bricks);
  gpu.occupiedSkip().readInto(std::span(objects.occupied));
  std::vector<std::uint32_t> slots(bricks), words(gpu.focusCells().bytes() / sizeof(std::uint32_t));
  gpu.focusBricks().readInto(std::span(slots));
  gpu.focusCells().read(std::as_writable_bytes(std::span(words)));
  for (const std::uint32_t slot : slots) {
    objects.cells.push_back(std::min(slot, 2u));
    for (std::size_t word = 0; slot >= 2 && word < cellsPerBrick / 4; ++word)
      objects.cells.push_back(words.at((slot - 2) * (cellsPerBrick / 4) + word));
  }
  if (!gpu.focusSmooth()) return objects;
  objects.smoothOrigin = gpu.focusSmoothOrigin();
  objects.smooth.resize(gpu.focusSmooth().bytes() / sizeof(std::uint16_t));
  gpu.focusSmooth().readInto(std::span(objects.smooth));
  return objects;
}

TEST_F(GpuSceneTest, Thorough_AFocusWhoseLabelsChangeIsToTheBitOneMadeFromScratch) {
  // Steps of a region that grows from a corner, leaks, and fills the volume; in a context, so that bricks are occupied
  // with and without the focus.
  std::mt19937 random(11);
  Scene scene = largeScene();
  const Grid grid = scene.volume->grid;
  scene.labels = labelsOf(grid, [&](glm::ivec3 v) {
    const double leak = v.y > 20 ? 60.0 : 0.0;
    return std::min(1.0 + 3.0 * glm::distance(glm::dvec3(v), glm::dvec3(30, 12, 9)) + leak + random() % 8, 254.0);
  });
  scene.look.context.function = opaqueFrom(500.0);
  const View view{.camera = Camera::standard(StandardView::Left, grid), .size = {90, 70}};
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  int last = 40;
  for (int change = 0; change < 24; ++change) {
    last = change % 4 == 3 ? static_cast<int>(random() % 255)
                           : std::clamp(last + static_cast<int>(random() % 7) - 3, 1, 254);
    scene.look.shading.enabled = change % 6 != 5;  // normals are dropped for a while
    LabelFocus focus;
    for (int label = 1; label <= last; ++label) focus.labels.push_back(static_cast<std::uint16_t>(label));
    scene.look.focus = focus;
    renderer.render(scene, view);
    const auto scratch = std::make_shared<GpuScene>();
    Renderer fresh(scratch);
    fresh.render(scene, view);
    ASSERT_EQ(gpu->focus().box.has_value(), scratch->focus().box.has_value());
    if (gpu->focus().box) {
      EXPECT_EQ(gpu->focus().box->low, scratch->focus().box->low);
      EXPECT_EQ(gpu->focus().box->high, scratch->focus().box->high);
    }
    EXPECT_EQ(objectsOf(*gpu), objectsOf(*scratch)) << "change " << change << " to " << last;
    EXPECT_EQ(renderer.readPicture(), fresh.readPicture()) << "change " << change << " to " << last;
  }
  // Another map, and back.
  Scene other = scene;
  other.labels = labelsOf(grid, [](glm::ivec3 v) { return v.x > 30 ? 1 : 0; });
  renderer.render(other, view);
  EXPECT_EQ(renderer.readPicture(), pictureOf(other, {}, view));
  renderer.render(scene, view);
  EXPECT_EQ(renderer.readPicture(), pictureOf(scene, {}, view));
}

TEST_F(GpuSceneTest, ColoursOfALabelFocusChangeAsIfMadeFromScratch) {
  Scene scene = largeScene();
  const Grid grid = scene.volume->grid;
  scene.labels = labelsOf(grid, [](glm::ivec3 v) { return v.x < 20 ? 1 : v.y < 20 ? 2 : v.z < 20 ? 3 : 0; });
  scene.look.context.function = opaqueFrom(500.0);
  scene.look.focus = LabelFocus{{1, 2, 3}};
  const View view{.camera = Camera::standard(StandardView::Left, grid), .size = {90, 70}};
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  std::vector<std::uint8_t> last;
  const auto expectNew = [&](const char* what) {
    renderer.render(scene, view);
    const std::vector<std::uint8_t> picture = renderer.readPicture();
    EXPECT_EQ(picture, pictureOf(scene, {}, view)) << what;
    EXPECT_NE(picture, last) << what;
    last = picture;
  };
  const glm::dvec3 red(1.0, 0.0, 0.0), green(0.0, 1.0, 0.0);
  put(scene.look.labels, {.label = 1, .colour = red});
  expectNew("a colour");
  put(scene.look.labels, {.label = 1, .colour = green});
  expectNew("another one: the voxels' entries stay");
  for (const std::uint16_t label : {1, 2}) put(scene.look.labels, {.label = label, .colour = red});
  expectNew("one for two labels");
  for (const std::uint16_t label : {1, 2, 3}) put(scene.look.labels, {.label = label, .colour = green});
  expectNew("one for all");
  put(scene.look.labels, {.label = 3, .colour = red});
  expectNew("two again");
  scene.look.focusAppearance.extinction *= 0.1;
  expectNew("translucent");
  scene.look.focus = LabelFocus{{1, 3}};
  expectNew("a label less");
  scene.labels = labelsOf(grid, [](glm::ivec3 v) { return v.y < 20 ? 1 : v.x < 20 ? 3 : 0; });
  expectNew("another map");
}

TEST_F(GpuSceneTest, FunctionsOfTheFocusTakeMemoryOnlyWhileTheyAreUsed) {
  Scene scene = labelScene(gridOf({20, 20, 20}), [](glm::ivec3 i) {
    return i.x < 8 ? 1 : i.x < 12 ? 2 : i.x < 16 ? 3 : 0;
  });
  scene.look.focus = LabelFocus{{1, 2, 3}};
  GpuScene gpu;
  const auto bytes = [&] {
    gpu.update(scene);
    EXPECT_EQ(gpu.focusByValue(), hasFocusFunction(scene));
    return gpu.transferTables().bytes();
  };
  const std::size_t table = bytes();
  const TransferFunction one{{{0.0, {glm::dvec3(1.0), 0.1}}}}, other{{{5.0, {glm::dvec3(0.5), 0.2}}}};
  const GpuScene::Versions before = gpu.versions();
  put(scene.look.labels, {.label = 1, .function = one});
  EXPECT_EQ(bytes(), 2 * table);
  EXPECT_EQ(gpu.versions().focus, before.focus);
  EXPECT_EQ(gpu.versions().gaps, before.gaps);
  EXPECT_GT(gpu.versions().palette, before.palette);
  put(scene.look.labels, {.label = 2, .function = other});
  EXPECT_EQ(bytes(), 3 * table);
  put(scene.look.labels, {.label = 3, .function = one});
  EXPECT_EQ(bytes(), 3 * table) << "labels share what is the same";
  scene.look.focus = LabelFocus{{2}};
  EXPECT_EQ(bytes(), 2 * table) << "labels out of focus need none";
  scene.look.labels.clear();
  EXPECT_EQ(bytes(), table);
}

TEST_F(GpuSceneTest, ProtectedLabelsTakeMemoryOnlyWhileTheyAreUsed) {
  Scene scene = largeScene();
  GpuScene gpu;
  const auto has = [&] {
    gpu.update(scene);
    const auto all = gpu.resources();
    return std::any_of(all.begin(), all.end(), [](const auto& each) { return each.name == "protected labels"; });
  };
  EXPECT_FALSE(has());
  put(scene.look.labels, {.label = 3, .role = LabelRole::Protected});
  EXPECT_FALSE(has()) << "it is in focus";
  scene.look.focus = ValueFocus{{20.0, 50.0}, 0.0};
  EXPECT_TRUE(has());
  const std::uint64_t version = gpu.versions().protectedLabels;
  EXPECT_TRUE(has());
  EXPECT_EQ(gpu.versions().protectedLabels, version) << "made once";
  scene.look.cutaway.enabled = false;
  EXPECT_FALSE(has());
  scene.look.cutaway.enabled = true;
  EXPECT_TRUE(has());
  put(scene.look.labels, {.label = 3, .role = LabelRole::Protected, .visible = false});
  EXPECT_FALSE(has());
}

/// Has no room for 3-D textures of more than so many texels.
class CrampedDriver {
 public:
  explicit CrampedDriver(std::int64_t most) {
    // epoxy looks a function up at its first call, and replaces the pointer.
    gl::Texture::make3D(gl::Format::R8, glm::ivec3(1));
    store_ = epoxy_glTextureStorage3D;
    self_ = this;
    most_ = most;
    epoxy_glTextureStorage3D = [](GLuint name, GLsizei levels, GLenum format, GLsizei x, GLsizei y, GLsizei z) {
      const bool fits = std::int64_t{x} * y * z <= self_->most_;
      // A texture of no size is refused by every driver.
      self_->store_(name, levels, format, fits ? x : 0, y, z);
    };
  }
  ~CrampedDriver() { epoxy_glTextureStorage3D = store_; }
  CrampedDriver(const CrampedDriver&) = delete;
  CrampedDriver& operator=(const CrampedDriver&) = delete;

 private:
  inline static CrampedDriver* self_ = nullptr;
  std::int64_t most_ = 0;
  PFNGLTEXTURESTORAGE3DPROC store_ = nullptr;
};

TEST_F(GpuSceneTest, AFailedAllocationThinsTheVolumeAndOneThatNothingHelpsNamesItsSize) {
  Scene scene = largeScene();
  scene.volume = volumeOf<std::int16_t>(gridOf({96, 80, 72}), [](glm::ivec3 v) { return v.x * 20 - 900; });
  scene.labels = nullptr;
  scene.look.focus = {};
  {
    const CrampedDriver driver(200000);
    GpuScene gpu;
    gpu.update(scene);
    EXPECT_NE(gpu.reduction(), glm::ivec3(1));
    EXPECT_LE(gpu.grid().voxelCount(), 200000u);
    EXPECT_FALSE(pictureOf(scene).empty());
  }
  const CrampedDriver driver(10);
  GpuScene gpu;
  try {
    gpu.update(scene);
    FAIL() << "nothing fits";
  } catch (const gl::AllocationError& error) {
    EXPECT_NE(std::string(error.what()).find("96×80×72"), std::string::npos) << error.what();
  }
}

TEST_F(GpuSceneTest, TheDriverSaysHowMuchItHolds) {
  const DeviceLimits limits = deviceLimits();
  EXPECT_GE(limits.side, 2048);  // OpenGL 4.5
  if (gl::isSoftwareRasteriser()) {
    EXPECT_GT(limits.bytes.value_or(0), std::size_t{1} << 28);
  }
}

}  // namespace
}  // namespace fenestra::tests::gpuSceneTest
