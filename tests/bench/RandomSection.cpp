#include "tests/bench/Sections.h"

#include <iostream>

#include "app/benchmark/Numbers.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/reference/Picture.h"
#include "tests/bench/RandomLooks.h"

namespace fenestra::bench {
namespace {

constexpr int picturesEach = 50, steepPicturesEach = 12;

/// Voxels along the longest side of phantoms that are coarse: some are ten pixels wide in a picture.
constexpr int coarseVoxels = 48;
constexpr glm::ivec2 steepSize{640, 480};

struct Row {
  Distribution milliseconds, pictureRms;
  ColourErrors errors;
};

/// Draws one picture with each setting in turn and compares it with the reference.
void measureOne(Renderer& renderer, const Scene& scene, const Camera& camera, const Options& options,
                const std::vector<Setting>& settings, std::vector<Row>& rows) {
  Measurable what{
      {}, scene, options.views.size, {camera}, sampledPixels(options.views.size, 2 * options.views.pixelBlock), {}};
  const reference::PictureOptions exactly{.pixels = what.pixels};
  const std::vector<glm::dvec4> truth = reference::picture(scene, camera, options.views.size, exactly).final;
  for (std::size_t k = 0; k < settings.size(); ++k) {
    View view{camera, options.views.size, 1.0, settings[k].quality};
    view.maxError = settings[k].maxError;
    renderer.render(scene, view);  // uploads the transfer function and compiles what the setting needs
    view.camera.eye.x = std::nextafter(view.camera.eye.x, std::numeric_limits<double>::infinity());
    rows[k].milliseconds.add(timed([&] { renderer.render(scene, view); }));
    const ColourErrors errors = errorsOf(renderer.readLayers().final, truth, what);
    rows[k].pictureRms.add(errors.squares.rms());
    rows[k].errors.add(errors);
  }
}

}  // namespace

Section randomSection(const Options& options, const TruthStore&) {
  Section section;
  section.title = "Random transfer functions";
  section.text =
      "Plain pictures with " + std::to_string(picturesEach) +
      " random transfer functions and views of each volume, every other one lit; errors in 1/255 against the "
      "reference, of the worst channel of each pixel, over all pictures; RMS also of the worst picture. Times are the "
      "medians of one frame each.";
  Options small = options;
  small.views.phantomVoxels = 96;
  Table table{"random", {"scene", "setting", "99.9 %", "maximum", "RMS", "worst picture's RMS", "ms"}, {}};
  std::vector<Setting> settings = unboundedSettings();
  for (const Setting& bound : boundSettings({4.0, 1.0})) settings.push_back(bound);
  const Subjects subjects = boundSubjects(small.views);
  for (const Subject& subject : subjects.here) {
    constexpr std::array wanted{"phantom-plain", "phantom-head", "small-head-plain", "torso", "brain"};
    if (std::find(wanted.begin(), wanted.end(), subject.id) == wanted.end()) continue;
    Scene scene = io::readStudy(subject.options).drawn.scene();
    scene.look.cutaway.enabled = false;
    std::mt19937 random(static_cast<std::mt19937::result_type>(std::hash<std::string>{}(subject.id)));
    Renderer renderer(std::make_shared<GpuScene>());
    std::vector<Row> rows(settings.size());
    for (int picture = 0; picture < picturesEach; ++picture) {
      scene.look.context = {};
      scene.look.context.function = randomTransfer(scene.volume->range, random);
      scene.look.shading.enabled = picture % 2 == 1;
      measureOne(renderer, scene, randomCamera(scene.volume->grid, random), small, settings, rows);
    }
    const std::size_t first = table.rows.size();
    for (std::size_t k = 0; k < settings.size(); ++k)
      table.rows.push_back({subject.name, settings[k].name, number(rows[k].errors.channel.percentile(99.9)),
                            number(rows[k].errors.channel.max()), number(rows[k].errors.squares.rms()),
                            number(rows[k].pictureRms.max()), fixed(rows[k].milliseconds.median(), 1)});
    std::cerr << plainText(
        {"", table.columns, {table.rows.begin() + static_cast<std::ptrdiff_t>(first), table.rows.end()}});
  }
  section.tables.push_back(std::move(table));
  return section;
}

Section steepSection(const Options& options, const TruthStore&) {
  Section section;
  section.title = "Steep transfer functions";
  section.text =
      "Plain, unlit pictures of " + std::to_string(steepSize.x) + "×" + std::to_string(steepSize.y) + " pixels with " +
      std::to_string(steepPicturesEach) +
      " random transfer functions and views of each volume: seven nodes anywhere in the range of values, of opacities "
      "up to 0.35 over 1 mm. Phantoms have " +
      std::to_string(coarseVoxels) +
      " voxels along their longest side, so that a segment of a ray spans much of such a function, and squares of the "
      "lattice of rays are as wide as they may be. Errors as above; times are the medians of one frame each.";
  Options wide = options;
  wide.views.size = steepSize;
  wide.views.phantomVoxels = coarseVoxels;
  Table table{"steep", {"scene", "setting", "99.9 %", "99.99 %", "maximum", "RMS", "worst picture's RMS", "ms"}, {}};
  std::vector<Setting> settings = unboundedSettings();
  for (const Setting& bound : boundSettings({2.0, 1.0})) settings.push_back(bound);
  const Subjects subjects = boundSubjects(wide.views);
  for (const Subject& subject : subjects.here) {
    constexpr std::array wanted{"phantom-plain", "phantom-head", "small-head-plain", "torso", "brain"};
    if (std::find(wanted.begin(), wanted.end(), subject.id) == wanted.end()) continue;
    Scene scene = io::readStudy(subject.options).drawn.scene();
    scene.look.cutaway.enabled = scene.look.shading.enabled = false;
    std::mt19937 random(static_cast<std::mt19937::result_type>(std::hash<std::string>{}(subject.id)));
    Renderer renderer(std::make_shared<GpuScene>());
    std::vector<Row> rows(settings.size());
    for (int picture = 0; picture < steepPicturesEach; ++picture) {
      scene.look.context = {};
      scene.look.context.function = steepTransfer(scene.volume->range, random);
      measureOne(renderer, scene, randomCamera(scene.volume->grid, random), wide, settings, rows);
    }
    for (std::size_t k = 0; k < settings.size(); ++k) {
      const Distribution& channel = rows[k].errors.channel;
      table.rows.push_back({subject.name, settings[k].name, number(channel.percentile(99.9)),
                            number(channel.percentile(99.99)), number(channel.max()),
                            number(rows[k].errors.squares.rms()), number(rows[k].pictureRms.max()),
                            fixed(rows[k].milliseconds.median(), 1)});
    }
    std::cerr << plainText(
        {"", table.columns, {table.rows.end() - static_cast<std::ptrdiff_t>(settings.size()), table.rows.end()}});
  }
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace fenestra::bench
