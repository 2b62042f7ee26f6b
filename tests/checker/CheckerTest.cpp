// The checker agrees with the reference, and finds each thing that a renderer could get wrong.

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "io/PhantomFile.h"
#include "tests/checker/LayerFiles.h"
#include "tests/support/Scenes.h"
#include "tests/support/TestData.h"

namespace fenestra {
namespace {

using namespace tests;
namespace fs = std::filesystem;

struct Picture {
  Scene scene;
  Camera camera;
  glm::ivec2 size{0};
  std::string labels;  ///< as the checker's option
};

Picture phantomPicture(const std::string& name, const std::vector<std::string>& structures, int voxels, double azimuth,
                       double elevation, Projection projection) {
  Picture picture;
  const Phantom::Rasterised raster = io::loadPhantom(name).rasterise(voxels);
  picture.scene.volume = raster.volume;
  picture.scene.labels = raster.labels;
  picture.scene.look.context.function = opaqueFrom(-300.0);
  LabelFocus focus;
  for (const Label& label : raster.labels->labels)
    for (const std::string& structure : structures)
      if (label.name == structure) {
        focus.labels.push_back(label.value);
        if (!picture.labels.empty()) picture.labels += ',';
        picture.labels += std::to_string(label.value);
      }
  EXPECT_EQ(focus.labels.size(), structures.size());
  picture.scene.look.focus = focus;
  picture.camera = Camera::fromAngles(azimuth, elevation, raster.volume->grid, projection);
  picture.size = {150, 130};
  return picture;
}

Outcome checkLayers(const Picture& picture, const reference::Stages& stages, const std::string& options = "") {
  const fs::path folder = scratchFolder();
  writeScene(picture.scene, folder);
  writeLayers(stages, picture.camera, picture.size, picture.scene.volume->grid, folder);
  return runCommand(std::string(LAYERS_CHECK) + " " + quoted(folder / "IMAGE.mha") + " " +
                    quoted(folder / "LABELS.mha") + " --labels " + picture.labels + " " + quoted(folder) + " " +
                    options);
}

TEST(Checker, confirmsTheReference) {
  const Picture pictures[] = {
      phantomPicture("torso", {"left kidney", "right kidney"}, 96, 180.0, 0.0, Projection::Perspective),
      phantomPicture("torso", {"aorta"}, 96, 37.0, 21.0, Projection::Perspective),
      phantomPicture("head", {"tumour"}, 64, 90.0, 0.0, Projection::Orthographic),
  };
  for (const Picture& picture : pictures) {
    const Outcome outcome =
        checkLayers(picture, reference::geometricStages(picture.scene, picture.camera, picture.size));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_NE(outcome.output.find("\"passed\": true"), std::string::npos) << outcome.output;
  }
}

TEST(Checker, confirmsObliqueGridsAndOtherWidths) {
  Picture picture;
  std::mt19937 random(4);
  std::bernoulli_distribution inside(0.02);
  picture.scene = labelScene(obliqueGrid({20, 18, 16}), [&](glm::ivec3) { return inside(random) ? 7 : 0; });
  picture.scene.look.focus = LabelFocus{{7}};
  picture.scene.look.context.function = opaqueFrom(-1.0);
  picture.scene.look.cutaway.openWidth = 7.5;
  picture.scene.look.cutaway.borderWidth = 0.0;
  picture.labels = std::to_string(7);
  picture.size = {121, 77};
  picture.camera = Camera::fromAngles(-50.0, 40.0, picture.scene.volume->grid);
  const auto stages = reference::geometricStages(picture.scene, picture.camera, picture.size);
  const Outcome right = checkLayers(picture, stages, "--w-open 7.5 --w-border 0");
  EXPECT_EQ(right.exitCode, 0) << right.output;
  const Outcome wrong = checkLayers(picture, stages, "--w-open 20 --w-border 0");
  EXPECT_EQ(wrong.exitCode, 1) << wrong.output;
}

/// Each case spoils one thing about correct layers.
TEST(Checker, findsEachFault) {
  const Picture picture = phantomPicture("torso", {"liver"}, 64, 20.0, 10.0, Projection::Perspective);
  const reference::Stages good = reference::geometricStages(picture.scene, picture.camera, picture.size);
  const double voxel = picture.scene.volume->grid.spacing.x;
  // In the middle of the liver's picture, and on its rim's outer side.
  std::size_t middle = 0, beside = 0;
  for (std::size_t i = 0; i < good.distance.size(); ++i) {
    const bool interior = i % 150 > 3 && !std::isnan(good.hits.tFocus[i]) && !std::isnan(good.hits.tFocus[i - 3]) &&
                          !std::isnan(good.hits.tFocus[i + 3]) && !std::isnan(good.hits.tFocus[i + 3 * 150]);
    if (interior && good.hits.tContext[i] < good.hits.tFocus[i] - 10.0) middle = i;
    if (good.distance[i] == 3.0 && !std::isnan(good.hits.tContext[i])) beside = i;
  }
  ASSERT_NE(middle, 0u);
  ASSERT_NE(beside, 0u);
  const struct {
    const char* what;
    std::function<void(reference::Stages&)> spoil;
  } faults[] = {
      {"hit off the 0.5 level", [&](auto& s) { s.hits.tFocus[middle] += 0.02 * voxel; }},
      {"hit off the 0.5 level", [&](auto& s) { s.hits.tFocus[middle] -= 0.02 * voxel; }},
      {"focus before the hit", [&](auto& s) { s.hits.tFocus[middle] += 3.0 * voxel; }},
      {"missed hit", [&](auto& s) { s.hits.tFocus[middle] = nan; }},
      {"hit off the 0.5 level", [&](auto& s) { s.hits.tFocus[beside] = s.hits.tContext[beside]; }},
      {"context behind the focus", [&](auto& s) { s.hits.tContext[middle] = s.hits.tFocus[middle] + voxel; }},
      {"hit on a ray that misses the volume", [&](auto& s) { s.hits.tContext[0] = 100.0; }},
      {"context outside the volume", [&](auto& s) { s.hits.tContext[beside] = 1.0; }},
      {"wrong distance", [&](auto& s) { s.distance[beside] += 1e-3; }},
      {"wrong distance", [&](auto& s) { s.distance[beside] = nan; }},
      {"distance left out within its range", [&](auto& s) { s.distance[beside] = infinity; }},
      {"fill changed a known pixel", [&](auto& s) { s.tFocusFilled[middle] *= 1.0 + 1e-6; }},
      {"hole in the fill", [&](auto& s) { s.tFocusFilled[beside] = nan; }},
      {"fill beyond known values", [&](auto& s) { s.tFocusFilled[beside] = 0.0; }},
      {"ray start off the formula", [&](auto& s) { s.tStart[beside] += 0.05 * voxel; }},
      {"ray start off the formula", [&](auto& s) { s.tStart[middle] -= 0.05 * voxel; }},
      {"ray start without a hit, or a hit without one", [&](auto& s) { s.tStart[beside] = nan; }},
  };
  for (const auto& fault : faults) {
    reference::Stages spoilt = good;
    fault.spoil(spoilt);
    const Outcome outcome = checkLayers(picture, spoilt);
    EXPECT_EQ(outcome.exitCode, 1) << fault.what << "\n" << outcome.output;
    EXPECT_NE(outcome.output.find(fault.what), std::string::npos) << fault.what << "\n" << outcome.output;
  }
}

TEST(Checker, saysWhatItCannotUse) {
  const fs::path folder = scratchFolder();
  EXPECT_EQ(runCommand(LAYERS_CHECK).exitCode, 2);
  EXPECT_EQ(runCommand(std::string(LAYERS_CHECK) + " a.mha b.mha --labels x " + quoted(folder)).exitCode, 2);
  const Outcome missing = runCommand(std::string(LAYERS_CHECK) + " a.mha b.mha --labels 1 " + quoted(folder));
  EXPECT_EQ(missing.exitCode, 2);
  EXPECT_NE(missing.output.find("b.mha"), std::string::npos) << missing.output;
}

}  // namespace
}  // namespace fenestra
