// The first minute: a scan is dropped onto the empty window and one click opens a structure in it, with real mouse
// events. Each step leaves a picture of the window to be looked at, in the folder that FENESTRA_TEST_PICTURES names or
// in the test's own.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <utility>
#include <vector>

#include <QTest>

#include "io/LabelWriter.h"
#include "io/PhantomFile.h"
#include "rendering/Renderer.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/volume/Slice.h"
#include "tests/gui/WindowFixture.h"
#include "tests/io/DicomWriter.h"
#include "tests/support/TestData.h"
#include "viewer/model/Paths.h"

namespace fenestra::viewer::firstMinuteTest {
namespace {

namespace fs = std::filesystem;

/// The slices of a volume of 16 bits as DICOM files in a new folder.
void writeSlices(const Volume& volume, const std::string& modality, const fs::path& folder) {
  fs::create_directories(folder);
  const Grid& grid = volume.grid;
  const auto values = volume.voxels.as<std::int16_t>();
  const auto perSlice = static_cast<std::size_t>(grid.dims.x) * static_cast<std::size_t>(grid.dims.y);
  for (int z = 0; z < grid.dims.z; ++z) {
    tests::DicomSpec spec;
    if (modality == "MR") spec.sopClass = "1.2.840.10008.5.1.4.1.1.4";
    spec.modality = modality;
    spec.instance = "1.2.3.4." + std::to_string(z + 1);
    spec.instanceNumber = z + 1;
    spec.columns = grid.dims.x;
    spec.rows = grid.dims.y;
    spec.row = grid.direction[0];
    spec.column = grid.direction[1];
    spec.pixelSpacing = std::to_string(grid.spacing.y) + "\\" + std::to_string(grid.spacing.x);
    spec.position = glm::dvec3(grid.worldFromIndex() * glm::dvec4(0.0, 0.0, z, 1.0));
    const auto slice = values.subspan(static_cast<std::size_t>(z) * perSlice, perSlice);
    for (const std::int16_t value : slice) {
      // As MR, soft tissues fill the range and neither air nor bone shows.
      const int shown = modality == "MR" ? std::clamp(10 * (value + 20), 0, 800) : value;
      spec.words.push_back(static_cast<std::uint16_t>(shown));
    }
    tests::writeDicom(folder / ("slice" + std::to_string(z) + ".dcm"), spec);
  }
}

class FirstMinute : public Window {
 protected:
  void SetUp() override {
    makeWindow();
    if (HasFatalFailure()) return;
    setAutomatic(true);
    window_->resize(1600, 1000);
  }

  /// Turns the wheel until the axial view shows the slice with a place, and clicks there.
  void clickAt(glm::dvec3 world) {
    SliceView* axial = slice(SlicePlane::Axial);
    const Grid& grid = document().scene().volume->grid;
    const int wanted = static_cast<int>(std::lround(sliceGeometry(grid, SlicePlane::Axial).pixelFromWorld(world).z));
    const int before = axial->slice();
    if (before != wanted) wheel(axial, 1);
    const int forward = axial->slice() - before;  // slices for one notch
    while (axial->slice() != wanted) {
      const int now = axial->slice();
      wheel(axial, (wanted > now) == (forward > 0) ? 1 : -1);
      ASSERT_NE(axial->slice(), now) << "the wheel leads no further";
    }
    cameras().orbit(0, 0.3, 0.2);  // the best view may be the one that data open with
    before_ = cameras().camera(0);
    QTest::mouseClick(axial, Qt::LeftButton, {}, axial->widgetFromWorld(world).toPoint());
  }
  /// The click's structure is in the focus, placed and drawn.
  void waitUntilOpen() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().awaitsGrowth(); }, 4 * patience));
    ASSERT_FALSE(document().asksToOpen()) << "the window asks before it opens to the region";
    ASSERT_TRUE(QTest::qWaitFor([&] { return placement().measured() != nullptr; }, 4 * patience));
    waitUntilDrawn();
  }
  /// ml of the region in the focus.
  double size() {
    return document().growth()->curve.volume[static_cast<std::size_t>(document().regionStep())] / 1000.0;
  }
  /// The cameras have moved, and C1 shows enough of the focus with nothing in front of it.
  void expectOpen() {
    EXPECT_NE(cameras().camera(0), before_);
    std::size_t ofFocus = 0, open = 0;
    volume(0)->inGlContext([&](const std::shared_ptr<GpuScene>& gpu) {
      Renderer renderer(gpu);
      renderer.render(volume(0)->shownScene(), volume(0)->restView());
      const Layers layers = renderer.readLayers();
      const glm::dvec3 spacing = document().scene().volume->grid.spacing;
      const double voxel = std::max({spacing.x, spacing.y, spacing.z});
      for (std::size_t i = 0; i < layers.tFocus.size(); ++i) {
        if (std::isnan(layers.tFocus[i])) continue;
        ++ofFocus;
        open += layers.tStart[i] >= layers.tFocus[i] - voxel;
      }
    });
    EXPECT_GT(ofFocus, 300u) << "pixels";
    EXPECT_GT(static_cast<double>(open), 0.98 * static_cast<double>(ofFocus)) << "of " << ofFocus;
  }
  void keepPicture(const std::string& name) {
    const char* chosen = std::getenv("FENESTRA_TEST_PICTURES");
    const fs::path folder = chosen ? fs::path(chosen) : folder_;
    EXPECT_TRUE(window_->picture().save(toQString(folder / (name + ".png"))));
  }

  /// Drops `paths` and clicks at `seed`; the region that grows must have a size within `ml`.
  void playRegion(const std::vector<fs::path>& paths, glm::dvec3 seed, glm::dvec2 ml, const std::string& name) {
    drop(paths);
    if (HasFatalFailure()) return;
    keepPicture(name + "-1-dropped");
    clickAt(seed);
    if (HasFatalFailure()) return;
    waitUntilOpen();
    if (HasFatalFailure()) return;
    keepPicture(name + "-2-clicked");
    ASSERT_TRUE(document().region());
    EXPECT_GT(size(), ml.x);
    EXPECT_LT(size(), ml.y);
    expectOpen();
  }
  /// Plays the minute in the Visible Human's head: 245 DICOM files of 512×512.
  void playHead(glm::dvec3 seed, glm::dvec2 ml, const std::string& name) {
    const fs::path head = tests::unpackTestData("visible-human/VHMCT1mm_Head.tar.xz", "VHMCT1mm_Head");
    if (head.empty()) GTEST_SKIP() << "needs the test-data file visible-human/VHMCT1mm_Head.tar.xz";
    playRegion({head}, seed, ml, name);
  }
  /// Plays the minute in a phantom as DICOM. The label of the structure says how large the part is that holds the seed.
  void playPhantom(const std::string& name, const std::string& modality, glm::dvec3 seed,
                   const std::string& structure) {
    const io::OpenedPhantom phantom = io::openPhantom(name, 180);
    const LabelMap& labels = *phantom.labels;
    const glm::ivec3 start(glm::round(glm::dvec3(labels.grid.indexFromWorld() * glm::dvec4(seed, 1.0))));
    const double ml = static_cast<double>(partAt(labels, start)) * labels.grid.voxelVolume() / 1000.0;
    ASSERT_GT(ml, 0.0);
    // Voxels of 1.6 mm: half a voxel at the surface of an eye is a tenth of its volume and more.
    writeSlices(*phantom.volume.volume, modality, folder_ / "scan");
    playRegion({folder_ / "scan"}, seed, {0.8 * ml, 1.2 * ml}, structure);
  }
  /// Voxels that have the label of one and are joined to it over faces.
  static std::size_t partAt(const LabelMap& labels, glm::ivec3 start) {
    std::vector<char> met(labels.grid.voxelCount(), 0);
    std::vector<glm::ivec3> part;
    const auto meet = [&](glm::ivec3 at) {
      if (!labels.grid.contains(at) || labels.value(at) != labels.value(start)) return;
      if (!std::exchange(met[labels.grid.offset(at)], 1)) part.push_back(at);
    };
    meet(start);
    for (std::size_t i = 0; i < part.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          glm::ivec3 next = part[i];
          next[axis] += step;
          meet(next);
        }
    return part.size();
  }

  const fs::path folder_ = tests::scratchFolder();
  Camera before_;
};

TEST_F(FirstMinute, TheMandibleOfAHead) { playHead({231, 184, 1057}, {30.0, 70.0}, "head-mandible"); }
TEST_F(FirstMinute, AnEyeOfAHead) { playHead({221, 172, 1148}, {5.0, 9.0}, "head-eye"); }
TEST_F(FirstMinute, TheAirwayOfAHead) { playHead({250, 231, 1022}, {4.0, 15.0}, "head-airway"); }

TEST_F(FirstMinute, AVentricleInMr) {
  FENESTRA_TEST_DATA_OR_SKIP(brain, "labelled/brain-colin27/ch2.nii.gz");
  playRegion({brain}, {10.0, 0.0, 24.0}, {5.0, 20.0}, "brain-ventricle");
}

TEST_F(FirstMinute, TheJawOfAPhantom) { playPhantom("head", "CT", {40.0, -24.0, -72.0}, "phantom-jaw"); }
TEST_F(FirstMinute, AnEyeOfAPhantom) { playPhantom("head", "CT", {-32.0, -64.0, -2.0}, "phantom-eye"); }
// Its mouth is open, and so is its windpipe; a sinus is the air that is closed.
TEST_F(FirstMinute, ASinusOfAPhantom) { playPhantom("head", "CT", {-28.0, -55.0, -36.0}, "phantom-sinus"); }
TEST_F(FirstMinute, AVentricleOfAPhantomInMr) { playPhantom("head", "MR", {-11.0, 0.0, 57.0}, "phantom-ventricle"); }

/// Files of a labelled scan dropped together: a click takes the label.
class LabelledFirstMinute : public FirstMinute {
 protected:
  void play(const std::vector<fs::path>& paths, const std::string& structure, const std::string& name) {
    drop(paths);
    if (HasFatalFailure()) return;
    keepPicture(name + "-1-dropped");
    const LabelMap& labels = *document().labels();
    const auto label = std::find_if(labels.labels.begin(), labels.labels.end(),
                                    [&](const Label& each) { return each.name == structure; });
    ASSERT_NE(label, labels.labels.end());
    clickAt(middleOf(labels, label->value));
    if (HasFatalFailure()) return;
    EXPECT_TRUE(document().isFocused(label->value));
    waitUntilOpen();
    if (HasFatalFailure()) return;
    keepPicture(name + "-2-clicked");
    expectOpen();
  }

 private:
  /// The voxel of a label nearest to their mean.
  static glm::dvec3 middleOf(const LabelMap& labels, std::uint16_t value) {
    std::vector<glm::ivec3> voxels;
    glm::dvec3 mean(0.0);
    glm::ivec3 at;
    for (at.z = 0; at.z < labels.grid.dims.z; ++at.z)
      for (at.y = 0; at.y < labels.grid.dims.y; ++at.y)
        for (at.x = 0; at.x < labels.grid.dims.x; ++at.x)
          if (labels.value(at) == value) {
            voxels.push_back(at);
            mean += glm::dvec3(at);
          }
    if (voxels.empty()) return {};
    mean /= static_cast<double>(voxels.size());
    const auto nearest = std::min_element(voxels.begin(), voxels.end(), [&](glm::ivec3 a, glm::ivec3 b) {
      return glm::distance(glm::dvec3(a), mean) < glm::distance(glm::dvec3(b), mean);
    });
    return glm::dvec3(labels.grid.worldFromIndex() * glm::dvec4(glm::dvec3(*nearest), 1.0));
  }
};

TEST_F(LabelledFirstMinute, AKidneyOfATorso) {
  FENESTRA_TEST_DATA_OR_SKIP(scan, "labelled/totalsegmentator-torso/example_ct.nii.gz");
  FENESTRA_TEST_DATA_OR_SKIP(labels, "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz");
  play({scan, labels}, "kidney_left", "torso-kidney");
}

TEST_F(LabelledFirstMinute, AKidneyOfAPhantom) {
  const io::OpenedPhantom phantom = io::openPhantom("torso", 160);
  const fs::path labels = folder_ / "labels.seg.nrrd";
  writeSlices(*phantom.volume.volume, "CT", folder_ / "scan");
  io::writeLabels(*phantom.labels, labels);
  play({folder_ / "scan", labels}, "left kidney", "phantom-kidney");
}

}  // namespace
}  // namespace fenestra::viewer::firstMinuteTest
