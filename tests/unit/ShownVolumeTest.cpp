// The volume as 3-D pictures show it, voxel by voxel and row by row, and the settings of labels.

#include "rendering/scene/ShownVolume.h"

#include <gtest/gtest.h>

#include "rendering/scene/Thinned.h"
#include "tests/support/Scenes.h"

namespace fenestra::shownVolumeTest {
namespace {

using namespace tests;

const Grid grid = gridOf({11, 7, 5}, {1.0, 2.0, 3.0});

/// A table of cells of 3×2×2 voxels, and two labels of which one is hidden.
Scene maskedScene(std::shared_ptr<Volume> volume) {
  Scene scene;
  scene.volume = std::move(volume);
  scene.labels = labelsOf(grid, [](glm::ivec3 v) { return v.x == 4 ? 3 : v.y == 5 ? 7 : 0; });
  auto table = std::make_shared<CoarseMask>();
  table->stride = {3, 2, 2};
  table->dims = {4, 4, 3};
  for (int i = 0; i < 48; ++i) table->cells.push_back(i % 5 == 0);
  table->count = 10;
  scene.table = table;
  put(scene.look.labels, {.label = 3, .role = LabelRole::Hidden});
  return scene;
}

bool isMasked(glm::ivec3 v) { return v.x == 4 || (v.x / 3 + 4 * (v.y / 2 + 4 * (v.z / 2))) % 5 == 0; }

/// Holds value(), sample() at voxels, withValues() and row() against `expected`.
template <class T>
void expectShown(const Scene& scene, double (*expected)(glm::ivec3)) {
  const ShownVolume shown = shownVolume(scene);
  const ShownVoxels voxels(shown);
  withValues(shown, [&](auto valueAt) {
    std::vector<T> buffer;
    for (int z = 0; z < grid.dims.z; ++z)
      for (int y = 0; y < grid.dims.y; ++y) {
        const T* row = voxels.row(y, z, buffer);
        for (int x = 0; x < grid.dims.x; ++x) {
          const glm::ivec3 v(x, y, z);
          const double stored = scene.volume->slope * static_cast<double>(row[x]) + scene.volume->intercept;
          EXPECT_EQ(stored, expected(v)) << x << ", " << y << ", " << z;
          EXPECT_EQ(voxels.value(v), expected(v));
          EXPECT_EQ(voxels.sample(v), expected(v));
          EXPECT_EQ(valueAt(v), expected(v));
        }
      }
  });
}

double hounsfield(glm::ivec3 v) { return v.z == 0 ? -1024.0 : v.x * 20.0 - 100.0 + v.y; }

TEST(ShownVolume, HidesTheTableAndHiddenLabelsAndNothingElse) {
  const auto volume = volumeOf<std::int16_t>(grid, hounsfield);
  volume->modality = Modality::CT;
  volume->unit = "HU";
  ASSERT_TRUE(volume->isInHounsfieldUnits());
  // Values below air stay as they are.
  expectShown<std::int16_t>(
      maskedScene(volume), [](glm::ivec3 v) { return isMasked(v) ? std::min(hounsfield(v), -1000.0) : hounsfield(v); });
  Scene scene = maskedScene(volume);
  scene.look.labels.clear();
  scene.look.hideTable = false;
  expectShown<std::int16_t>(scene, hounsfield);
  EXPECT_EQ(shownVolume(scene), ShownVolume{scene.volume});
}

TEST(ShownVolume, AirIsTheLeastValueWithoutHounsfieldUnitsAndUnderAFallingScale) {
  const auto falling = volumeOf<std::uint16_t>(grid, [](glm::ivec3 v) { return 900 - 10 * v.x - v.z; });
  falling->slope = -2.0;
  falling->intercept = 2000.0;
  falling->computeRange();
  expectShown<std::uint16_t>(maskedScene(falling),
                             [](glm::ivec3 v) { return isMasked(v) ? 200.0 : 2000.0 - 2.0 * (900 - 10 * v.x - v.z); });
  const auto fractions = volumeOf<float>(grid, [](glm::ivec3 v) { return v.x == 4 ? nan : 0.25 * v.y; });
  Scene scene = maskedScene(fractions);
  scene.table = nullptr;
  expectShown<float>(scene, [](glm::ivec3 v) { return v.x == 4 ? 0.0 : 0.25 * v.y; });
}

TEST(ShownVolume, AnUnmaskedRowIsTheVolumesOwn) {
  const Scene scene = maskedScene(volumeOf<std::uint8_t>(grid, [](glm::ivec3 v) { return 10 + v.x; }));
  Scene plain = scene;
  plain.look.labels.clear();
  plain.table = nullptr;
  const ShownVolume shown = shownVolume(plain);
  std::vector<std::uint8_t> buffer;
  EXPECT_EQ(ShownVoxels(shown).row(2, 1, buffer),
            scene.volume->voxels.as<std::uint8_t>().data() + grid.offset({0, 2, 1}));
  EXPECT_TRUE(buffer.empty()) << "nothing is copied";
}

TEST(ShownVolume, ThinnedVoxelsAreMeansOfWhatIsShown) {
  const Scene scene = maskedScene(volumeOf<double>(grid, [](glm::ivec3 v) { return 100.0 + v.x; }));
  const auto thin = thinned(shownVolume(scene), {11, 1, 1});
  for (int y = 0; y < grid.dims.y; ++y) {
    double sum = 0.0;
    for (int x = 0; x < grid.dims.x; ++x) sum += isMasked({x, y, 0}) ? 100.0 : 100.0 + x;
    EXPECT_NEAR(thin->value({0, y, 0}), sum / grid.dims.x, 1e-9);
  }
}

TEST(LabelRoles, AFocusedLabelHasNoOtherRole) {
  Scene scene = maskedScene(volumeOf<std::uint8_t>(grid, [](glm::ivec3) { return 10; }));
  scene.table = nullptr;
  put(scene.look.labels, {.label = 7, .role = LabelRole::Protected});
  put(scene.look.labels, {.label = 9, .role = LabelRole::Protected, .visible = false});
  EXPECT_EQ(labelsWith(LabelRole::Hidden, scene), (std::vector<std::uint16_t>{3}));
  EXPECT_EQ(labelsWith(LabelRole::Protected, scene), (std::vector<std::uint16_t>{7})) << "9 is not visible";
  scene.look.focus = LabelFocus{{3, 7}};
  EXPECT_TRUE(labelsWith(LabelRole::Hidden, scene).empty());
  EXPECT_TRUE(labelsWith(LabelRole::Protected, scene).empty());
  EXPECT_EQ(shownVolume(scene), ShownVolume{scene.volume});
  // The labels of a region in focus are others.
  scene.structures = std::exchange(scene.labels, labelsOf(grid, [](glm::ivec3) { return 3; }));
  EXPECT_EQ(labelsWith(LabelRole::Hidden, scene), (std::vector<std::uint16_t>{3}));
  EXPECT_EQ(shownVolume(scene).labels, scene.structures);
}

TEST(LabelSettings, AreSortedAndHoldNoDefaults) {
  LabelSettings settings;
  put(settings, {.label = 5, .opacity = 0.5});
  put(settings, {.label = 2, .visible = false});
  put(settings, {.label = 9});
  ASSERT_EQ(settings.size(), 2u);
  EXPECT_EQ(settings[0].label, 2);
  EXPECT_EQ(settingFor(settings, 5).opacity, 0.5);
  EXPECT_EQ(settingFor(settings, 6), (LabelSetting{.label = 6}));
  put(settings, {.label = 5, .role = LabelRole::Protected});
  EXPECT_EQ(settingFor(settings, 5).opacity, 1.0);
  put(settings, {.label = 5});
  EXPECT_EQ(settings.size(), 1u);
}

TEST(LabelSettings, OpacityIsThatOfTenMillimetres) {
  for (const double extinction : {0.01, 0.3, 2.0, 1e9}) {
    EXPECT_EQ(opticalExtinction(extinction, 1.0), extinction);
    EXPECT_EQ(opticalExtinction(extinction, 0.0), 0.0);
    const double whole = 1.0 - std::exp(-extinction * 10.0);
    for (const double opacity : {0.001, 0.25, 0.5, 0.99})
      EXPECT_NEAR(1.0 - std::exp(-opticalExtinction(extinction, opacity) * 10.0), opacity * whole, 1e-12);
  }
}

}  // namespace
}  // namespace fenestra::shownVolumeTest
