#include "tests/bench/Sections.h"

#include <cmath>
#include <iostream>

#include "app/benchmark/Numbers.h"
#include "rendering/gpu/GpuScene.h"

namespace fenestra::bench {
namespace {

/// Errors of one map in its unit; pixels that only one side knows are counted.
struct MapErrors {
  Distribution errors;
  std::size_t missed = 0, extra = 0;
};

MapErrors compare(const std::vector<float>& here, const reference::Image& truth, double unit) {
  MapErrors result;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const bool known = !std::isnan(here[i]), expected = !std::isnan(truth[i]);
    if (known && expected)
      result.errors.add(here[i] == truth[i] ? 0.0 : std::abs(here[i] - truth[i]) / unit);
    else if (expected)
      ++result.missed;
    else if (known)
      ++result.extra;
  }
  return result;
}

reference::Image widened(const std::vector<float>& values) { return {values.begin(), values.end()}; }

void addRow(Table& table, const std::string& subject, const std::string& stage, const std::string& unit,
            const Distribution& errors, const std::string& missed, const std::string& extra) {
  table.rows.push_back({subject, stage, unit, std::to_string(errors.count()), number(errors.median()),
                        number(errors.percentile(99.9)), number(errors.percentile(99.99)), number(errors.max()), missed,
                        extra});
}

}  // namespace

Section stageSection(const Options& options, const TruthStore& truths) {
  Section section;
  section.title = "Errors, stage by stage";
  section.text =
      "One view of each subject at high quality against the double-precision reference. Hits along rays in units of "
      "the "
      "finest voxel spacing; missed: hits that only the reference has, extra: hits that only the renderer has. The "
      "later stages are given the renderer's own earlier ones, so that an error shows where it arises; the picture is "
      "the whole chain.";
  Table table{"stages",
              {"subject", "stage", "unit", "pixels", "median", "99.9 %", "99.99 %", "maximum", "missed", "extra"},
              {}};
  Options oneView = options;
  oneView.views.compared = 1;
  const Subjects subjects = reportSubjects(options.views);
  const glm::ivec2 size = options.views.size;
  for (const Subject& subject : subjects.here) {
    std::cerr << "stages: " << subject.name << '\n';
    const io::Study study = io::readStudy(subject.options);
    const Scene& scene = study.drawn.scene();
    const Measurable what = prepare(subject.name, scene, oneView, truths);
    const Camera& camera = what.cameras.front();
    Renderer renderer(std::make_shared<GpuScene>());
    renderer.render(scene, {camera, size, 1.0, Quality::High});
    const Layers layers = renderer.readLayers();

    const double voxel = stepLength(scene.volume->grid, 1.0);
    reference::Stages own;
    own.hits = truths.hits(scene, camera, size);
    const auto add = [&](const char* stage, const char* unit, const MapErrors& errors) {
      addRow(table, subject.name, stage, unit, errors.errors, std::to_string(errors.missed),
             std::to_string(errors.extra));
    };
    add("context hit", "voxel", compare(layers.tContext, own.hits.tContext, voxel));
    add("focus hit", "voxel", compare(layers.tFocus, own.hits.tFocus, voxel));
    own.hits.tContext = widened(layers.tContext);
    own.hits.tFocus = widened(layers.tFocus);
    own.tFocusFilled = widened(layers.tFocusFilled);
    own.distance = widened(layers.distance);
    own.tStart = widened(layers.tStart);
    const reference::Widths widths = reference::widthsInPixels(scene, camera, size, 1.0);
    add("filled focus hit", "voxel", compare(layers.tFocusFilled, reference::fill(own.hits.tFocus, size), voxel));
    add("distance", "px",
        compare(layers.distance, reference::distanceMap(own.hits.tFocus, size, widths.open + widths.border), 1.0));
    add("ray start", "voxel",
        compare(layers.tStart, reference::rayStart(own.hits, own.tFocusFilled, own.distance, widths.open), voxel));
    reference::PictureOptions pictureOptions;
    pictureOptions.pixels = what.pixels;
    const reference::Picture picture = reference::picture(scene, camera, size, own, pictureOptions);
    addRow(table, subject.name, "focus layer", "1/255", errorsOf(layers.focusLayer, picture.focusLayer, what).channel,
           "", "");
    addRow(table, subject.name, "composite", "1/255", errorsOf(layers.final, picture.final, what).channel, "", "");
    addRow(table, subject.name, "picture", "1/255", errorsOf(layers.final, what.truths.front(), what).channel, "", "");
  }
  std::cerr << plainText(table);
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace fenestra::bench
