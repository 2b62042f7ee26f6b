#include "tests/bench/Subjects.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tests/support/TestData.h"

namespace fenestra::bench {
namespace {

namespace fs = std::filesystem;

class List {
 public:
  explicit List(const Views& views) : views_(views) {}

  void phantom(const std::string& id, const std::string& name, const std::string& body) {
    Subject subject{id, name, {}};
    subject.options.phantom = body;
    subject.options.phantomVoxels = views_.phantomVoxels;
    if (id.starts_with(views_.only)) subjects_.here.push_back(std::move(subject));
  }
  void labelled(const std::string& id, const std::string& name, const fs::path& image, const fs::path& labels,
                std::vector<std::string> focus) {
    Subject subject{id, name, {}};
    subject.options.path = tests::findTestData(image);
    subject.options.labels = tests::findTestData(labels);
    subject.options.focusLabels = std::move(focus);
    add(std::move(subject), image);
  }
  void ranged(const std::string& id, const std::string& name, const fs::path& image, ValueRange focus) {
    Subject subject{id, name, {}};
    subject.options.path =
        image.extension() == ".xz" ? tests::unpackTestData(image, image.stem().stem()) : tests::findTestData(image);
    subject.options.focusRange = focus;
    add(std::move(subject), image);
  }
  /// The subject `id` if it has just been added.
  app::SceneOptions* last(const std::string& id) {
    const bool here = !subjects_.here.empty() && subjects_.here.back().id == id;
    return here ? &subjects_.here.back().options : nullptr;
  }
  Subjects take() { return std::move(subjects_); }

 private:
  void add(Subject subject, const fs::path& image) {
    if (!subject.id.starts_with(views_.only)) return;
    if (subject.options.path.empty())
      subjects_.missing.push_back(subject.name + ": left out, needs the test-data file " + image.string());
    else
      subjects_.here.push_back(std::move(subject));
  }

  const Views& views_;
  Subjects subjects_;
};

const fs::path headCt = "visible-human/VHMCT1mm_Head.tar.xz", smallHeadCt = "ct-head/ct.nii.gz";
const fs::path torsoCt = "labelled/totalsegmentator-torso/example_ct.nii.gz";
const fs::path torsoLabels = "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz";
const fs::path brainMr = "labelled/brain-colin27/ch2.nii.gz", brainLabels = "labelled/brain-colin27/aal.nii.gz";
const fs::path chestCt = "labelled/slicer-ctchest/CTChest4.nrrd";
const fs::path chestLabels = "labelled/slicer-ctchest/Segmentation.seg.nrrd";

}  // namespace

Subjects reportSubjects(const Views& views) {
  List list(views);
  list.phantom("phantom", "phantom torso: organs", "torso");
  list.ranged("head", "Visible Human head, CT: skull", headCt, {300.0, 3000.0});
  list.labelled("torso", "torso, CT: kidneys", torsoCt, torsoLabels, {"2", "3"});
  list.labelled("brain", "brain, MR: hippocampus", brainMr, brainLabels, {"37", "38"});
  return list.take();
}

Subjects boundSubjects(const Views& views) {
  List list(views);
  list.phantom("phantom", "phantom torso: organs", "torso");
  list.phantom("phantom-plain", "phantom torso: plain, unlit", "torso");
  if (app::SceneOptions* options = list.last("phantom-plain"))
    options->look.cutaway.enabled = options->look.shading.enabled = false;
  list.phantom("phantom-head", "phantom head: tumour, ventricles", "head");
  list.ranged("head", "Visible Human head, CT: skull", headCt, {300.0, 3000.0});
  list.ranged("small-head", "small head, CT: skull", smallHeadCt, {0.6, 1.0});
  list.ranged("small-head-plain", "small head, CT: plain", smallHeadCt, {0.6, 1.0});
  if (app::SceneOptions* options = list.last("small-head-plain")) options->look.cutaway.enabled = false;
  list.labelled("torso", "torso, CT: kidneys", torsoCt, torsoLabels, {"2", "3"});
  list.labelled("torso-aorta", "torso, CT: aorta, unlit", torsoCt, torsoLabels, {"52"});
  if (app::SceneOptions* options = list.last("torso-aorta")) options->look.shading.enabled = false;
  list.labelled("brain", "brain, MR: hippocampus", brainMr, brainLabels, {"37", "38"});
  list.labelled("chest", "chest, CT: lungs", chestCt, chestLabels, {"right lung", "left lung"});
  return list.take();
}

Scene plainScene(const Scene& scene) {
  const Volume& source = *scene.volume;
  const glm::ivec3 dims = source.grid.dims, last = dims - 1;
  auto volume = std::make_shared<Volume>();
  volume->grid = source.grid;
  volume->slope = source.slope;
  volume->intercept = source.intercept;
  volume->range = source.range;
  volume->modality = source.modality;
  source.voxels.visit([&]<class T>(std::span<const T> from) {
    volume->voxels = Voxels(scalarTypeOf<T>(), from.size());
    const std::span<T> to = volume->voxels.as<T>();
    std::copy(from.begin(), from.end(), to.begin());
    const T least = static_cast<T>((source.range.low - source.intercept) / source.slope);
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y) {
        const std::size_t row = source.grid.offset({0, y, z});
        if (z == 0 || z == last.z || y == 0 || y == last.y)
          std::fill_n(to.begin() + static_cast<std::ptrdiff_t>(row), dims.x, least);
        else
          to[row] = to[row + static_cast<std::size_t>(last.x)] = least;
      }
  });
  Scene plain = scene;
  plain.volume = std::move(volume);
  plain.labels = nullptr;
  plain.look.focus = {};
  plain.look.shading.enabled = false;
  return plain;
}

std::vector<Camera> cameraPath(const Scene& scene, int count) {
  const Grid framed = visibleGrid(shownVolume(scene), scene.look.context.shifted());
  std::vector<Camera> path;
  for (int i = 0; i < count; ++i) {
    // Off the axes, where rays would run along the voxels' planes and flatter everybody.
    const double turn = 0.02 + static_cast<double>(i) / count;
    path.push_back(Camera::fromAngles(360.0 * turn, 25.0 * std::sin(6.0 + 17.0 * turn), framed));
  }
  return path;
}

std::vector<glm::ivec2> sampledPixels(glm::ivec2 size, int side) {
  std::vector<glm::ivec2> pixels;
  for (int y = 0; y < size.y; y += side)
    for (int x = 0; x < size.x; x += side) {
      // A hash of the block's place (the finaliser of MurmurHash3).
      auto hash = static_cast<std::uint32_t>(y) * 65537u + static_cast<std::uint32_t>(x);
      hash = (hash ^ (hash >> 16)) * 0x85ebca6bu;
      hash = (hash ^ (hash >> 13)) * 0xc2b2ae35u;
      hash ^= hash >> 16;
      const glm::ivec2 pixel(x + static_cast<int>(hash % static_cast<std::uint32_t>(side)),
                             y + static_cast<int>(hash / 4096u % static_cast<std::uint32_t>(side)));
      pixels.push_back(glm::min(pixel, size - 1));
    }
  return pixels;
}

double stepLength(const Grid& grid, double samplesPerVoxel) {
  return std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z}) / samplesPerVoxel;
}

}  // namespace fenestra::bench
