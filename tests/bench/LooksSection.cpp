#include <functional>
#include <iostream>

#include "app/benchmark/Numbers.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/reference/Picture.h"
#include "tests/bench/RandomLooks.h"
#include "tests/bench/Sections.h"

namespace fenestra::bench {
namespace {

constexpr int randomPictures = 50;
const std::vector<double> bounds{4.0, 2.0, 1.0, 0.5};

/// One of the choices for how a scene looks, and how it is made.
struct Kind {
  const char* name;
  std::function<void(Scene&)> apply;
  /// A scene has one spline at most, and surfaces of labels where these are its focus.
  enum class Group { Spline, Labels, Other } group = Group::Other;

  bool isFor(const Scene& scene) const {
    return group != Group::Labels || std::holds_alternative<LabelFocus>(scene.look.focus);
  }
};

/// The inner three quarters of the volume, cut by an oblique plane through its centre.
void clip(Scene& scene) {
  const Grid& grid = scene.volume->grid;
  const CropFrame frame(grid);
  const glm::dvec3 margin = (frame.high - frame.low) / 8.0, normal = glm::normalize(glm::dvec3(1.0, 2.0, 0.5));
  Clipping& clipping = scene.look.clipping;
  clipping.cropped = true;
  clipping.box = {frame.low + margin, frame.high - margin};
  clipping.planes = {{normal, glm::dot(normal, grid.centre())}};
}

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"curved", [](Scene& scene) { scene.look.reconstruction = Reconstruction::Cubic; }, Kind::Group::Spline},
      {"smoothed more", [](Scene& scene) { scene.look.reconstruction = Reconstruction::Smoother; },
       Kind::Group::Spline},
      {"label surfaces", [](Scene& scene) { scene.look.labelSmoothing = LabelSmoothing::Strong; }, Kind::Group::Labels},
      {"occlusion and shadow",
       [](Scene& scene) {
         scene.look.shading.enabled = true;
         scene.look.shading.occlusion = 0.6;
         scene.look.shading.shadow = 0.5;
       }},
      {"smooth edges", [](Scene& scene) { scene.look.edges = Edges::Smooth; }},
      {"clipped", clip}};
  return all;
}

/// Errors of one picture with each bound, in 1/255 of the worst channel; empty where the scan has no room.
std::vector<Distribution> errorsWithin(const Scene& scene, const Camera& camera, const Options& options) {
  Measurable what{{}, scene, options.views.size, {camera}, {}, {}};
  what.pixels = sampledPixels(options.views.size, options.views.pixelBlock);
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  std::vector<std::vector<glm::vec4>> pictures;
  for (const double bound : bounds) {
    View view{camera, what.size};
    view.maxError = bound;
    renderer.render(scene, view);
    if (!gpu->reductionNotice().empty()) return {};
    pictures.push_back(renderer.readLayers().final);
  }
  const std::vector<glm::dvec4> truth =
      reference::picture(scene, camera, what.size, reference::PictureOptions{.pixels = what.pixels}).final;
  std::vector<Distribution> errors;
  for (const std::vector<glm::vec4>& picture : pictures) errors.push_back(errorsOf(picture, truth, what).channel);
  return errors;
}

/// The errors of all pixels of several pictures, with each bound.
using Sums = std::vector<Distribution>;

/// The greatest error of a picture with each bound, and how many pixels are beyond theirs; adds it to the sums.
std::vector<std::string> row(std::vector<std::string> cells, const std::vector<Distribution>& errors, Sums& sums) {
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    cells.push_back(number(errors[i].max()));
    beyond += errors[i].countAbove(bounds[i]);
    sums[i].add(errors[i]);
  }
  cells.resize(cells.size() + bounds.size() - errors.size());
  cells.push_back(errors.empty() ? "no room" : std::to_string(beyond));
  return cells;
}

Table tableOf(const std::string& name) {
  Table table{name, {"scene", "look"}, {}};
  for (const double bound : bounds) table.columns.push_back("within " + number(bound));
  table.columns.emplace_back("beyond");
  return table;
}

/// Every kind of look on each scene.
Table ofScenes(const Subjects& subjects, const Options& options, Sums& sums) {
  Table table = tableOf("looks");
  for (const Subject& subject : subjects.here) {
    const Scene plain = io::readStudy(subject.options).drawn.scene();
    for (const Kind& kind : kinds()) {
      if (!kind.isFor(plain)) continue;
      Scene scene = plain;
      kind.apply(scene);
      const Camera camera = cameraPath(scene, 1, options.views.projection()).front();
      table.rows.push_back(row({subject.name, kind.name}, errorsWithin(scene, camera, options), sums));
      std::cerr << plainText({"", table.columns, {table.rows.back()}});
    }
  }
  return table;
}

/// Gives a scene a random transfer function and about half of the kinds of look, whose names it returns.
std::string makeRandom(Scene& scene, std::mt19937& random) {
  std::bernoulli_distribution half(0.5);
  scene.look.context = {};
  scene.look.context.function = randomTransfer(scene.volume->range, random);
  scene.look.cutaway.enabled = half(random);
  scene.look.shading.enabled = half(random);
  std::string names;
  bool hasSpline = false;
  for (const Kind& kind : kinds()) {
    const bool isSpline = kind.group == Kind::Group::Spline;
    if (!half(random) || !kind.isFor(scene) || (isSpline && hasSpline)) continue;
    kind.apply(scene);
    hasSpline = hasSpline || isSpline;
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  return names;
}

/// Pictures in which all but the data and the focus is random.
Table ofRandomPictures(const Subjects& subjects, const Options& options, Sums& sums) {
  Table table = tableOf("random-looks");
  table.isLong = true;
  std::mt19937 random(1);
  for (int picture = 0; picture < randomPictures && !subjects.here.empty(); ++picture) {
    const Subject& subject = subjects.here[static_cast<std::size_t>(picture) % subjects.here.size()];
    Scene scene = io::readStudy(subject.options).drawn.scene();
    const std::string names = makeRandom(scene, random);
    const Camera camera = randomCamera(scene.volume->grid, random);
    table.rows.push_back(row({subject.name, names}, errorsWithin(scene, camera, options), sums));
    std::cerr << plainText({"", table.columns, {table.rows.back()}});
  }
  return table;
}

void addSums(Table& table, const std::string& pictures, const Sums& sums) {
  for (std::size_t i = 0; i < bounds.size(); ++i)
    table.rows.push_back({pictures, number(bounds[i]), std::to_string(sums[i].count()),
                          std::to_string(sums[i].countAbove(bounds[i])), number(sums[i].percentile(99.99)),
                          number(sums[i].max())});
}

}  // namespace

Section looksSection(const Options& options, const TruthStore&) {
  Section section;
  section.title = "The error bound with every kind of look";
  section.text =
      "Errors in 1/255 of the worst channel against the reference, with each bound: of one view of the ten scenes with "
      "one kind of look each, and of " +
      std::to_string(randomPictures) +
      " pictures with a random transfer function, view and looks, half of them opened and half lit. Of each picture "
      "the greatest error, and how many of the four times compared pixels are beyond their bound. Where a scan is too "
      "large to be drawn with curves, the window says so and draws it straight: no room.";
  Options small = options;
  small.views.phantomVoxels = 96;
  const Subjects subjects = boundSubjects(small.views);
  for (const std::string& missing : subjects.missing) section.text += "\n\n" + missing;
  Sums sums(bounds.size()), randomSums(bounds.size());
  const Table scenes = ofScenes(subjects, small, sums), random = ofRandomPictures(subjects, small, randomSums);
  Table all{"looks-summary", {"pictures", "bound", "pixels", "beyond", "99.99 %", "maximum"}, {}};
  addSums(all, "scenes", sums);
  addSums(all, "random", randomSums);
  section.tables = {all, scenes, random};
  return section;
}

}  // namespace fenestra::bench
