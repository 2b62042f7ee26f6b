// The renderer's layers, written by the command line, hold what they promise.

#include <sstream>

#include <gtest/gtest.h>

#include "io/PhantomFile.h"
#include "tests/checker/LayerFiles.h"
#include "tests/support/TestData.h"

namespace fenestra {
namespace {

using namespace tests;
namespace fs = std::filesystem;

/// Renders with `view` and `widths` options into `folder` and checks the layers.
void expectLayersHold(const fs::path& folder, const fs::path& image, const fs::path& labels,
                      const std::string& focusLabels, const std::string& view, const std::string& widths) {
  std::ostringstream render, check;
  render << FENESTRA_CLI << " render " << quoted(image) << " --labels " << quoted(labels) << " --focus-labels "
         << focusLabels << ' ' << view << ' ' << widths << " --layers " << quoted(folder) << " -o "
         << quoted(folder / "picture.png");
  const Outcome rendered = runCommand(render.str());
  ASSERT_EQ(rendered.exitCode, 0) << rendered.output;
  check << LAYERS_CHECK << ' ' << quoted(image) << ' ' << quoted(labels) << " --labels " << focusLabels << ' '
        << quoted(folder) << ' ' << widths;
  const Outcome checked = runCommand(check.str());
  EXPECT_EQ(checked.exitCode, 0) << checked.output;
}

void expectPhantomLayersHold(const std::string& phantom, const std::string& structure, const std::string& view,
                             const std::string& widths) {
  const Phantom::Rasterised raster = io::loadPhantom(phantom).rasterise(128);
  std::string label;
  for (const Label& candidate : raster.labels->labels)
    if (candidate.name == structure) label = std::to_string(candidate.value);
  ASSERT_FALSE(label.empty());
  Scene scene;
  scene.volume = raster.volume;
  scene.labels = raster.labels;
  const fs::path folder = scratchFolder();
  writeScene(scene, folder);
  expectLayersHold(folder, folder / "IMAGE.mha", folder / "LABELS.mha", label, view, widths);
}

TEST(Layers, Thorough_lesionBehindARib) {
  expectPhantomLayersHold("torso", "lesion", "--camera R --size 500x430", "--w-open 24 --w-border 2");
}

TEST(Layers, Thorough_heartFromTheLeftInParallel) {
  expectPhantomLayersHold("torso", "heart muscle", "--camera 40,15 --projection orthographic --size 333x277",
                          "--w-open 40 --w-border 3");
}

TEST(Layers, Thorough_tumourWithoutAnOpening) {
  expectPhantomLayersHold("head", "tumour", "--camera A --size 300x300", "--w-open 0 --w-border 0");
}

TEST(Layers, kidneysOfTheTorso) {
  FENESTRA_TEST_DATA_OR_SKIP(image, "labelled/totalsegmentator-torso/example_ct.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(labels, "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz");
  expectLayersHold(scratchFolder(), image, labels, "2,3", "--camera P --size 500x464", "--w-open 24 --w-border 2");
}

TEST(Layers, aortaOfTheTorso) {
  FENESTRA_TEST_DATA_OR_SKIP(image, "labelled/totalsegmentator-torso/example_ct.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(labels, "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz");
  expectLayersHold(scratchFolder(), image, labels, "52", "--camera 37,21 --size 500x464", "--w-open 40 --w-border 2");
}

TEST(Layers, Thorough_hippocampiOfTheBrain) {
  FENESTRA_TEST_DATA_OR_SKIP(image, "labelled/brain-colin27/ch2.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(labels, "labelled/brain-colin27/aal.nii.gz");
  expectLayersHold(scratchFolder(), image, labels, "37,38", "--camera L --projection orthographic --size 301x229",
                   "--w-open 24 --w-border 2");
}

}  // namespace
}  // namespace fenestra
