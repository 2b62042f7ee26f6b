#include "tests/bench/Sections.h"

#include <algorithm>
#include <functional>
#include <iostream>
#include <optional>

#include "app/benchmark/Numbers.h"
#include "rendering/gpu/GpuScene.h"
#include "tests/support/FeatureScenes.h"

namespace fenestra::bench {
namespace {

/// Names of the passes that ran between two states of the statistics.
std::string passesBetween(const std::array<PassStats, passCount>& before,
                          const std::array<PassStats, passCount>& after) {
  std::string names;
  for (std::size_t pass = 0; pass < passCount; ++pass)
    if (after[pass].runs > before[pass].runs)
      names.append(names.empty() ? "" : ", ").append(nameOf(static_cast<Pass>(pass)));
  return names.empty() ? "none" : names;
}

std::string mebibytes(std::size_t bytes) { return fixed(static_cast<double>(bytes) / (1 << 20), 2); }

/// The phantom as it opens.
io::Study phantomScene(const Options& options) {
  io::StudyRequest scene;
  scene.phantom = "torso";
  scene.makePlain();
  scene.phantomVoxels = options.views.phantomVoxels;
  return io::readStudy(scene);
}

}  // namespace

Section passSection(const Options& options, const TruthStore&) {
  Section section;
  section.title = "Time, pass by pass";
  section.text = "GPU time of each pass over the camera path at normal quality, milliseconds.";
  Table table{"passes", {"subject", "pass", "least", "median", "most"}, {}};
  const Subjects subjects = reportSubjects(options.views);
  for (const Subject& subject : subjects.here) {
    std::cerr << "passes: " << subject.name << '\n';
    const io::Study study = io::readStudy(subject.options);
    const std::vector<Camera> path =
        cameraPath(study.drawn.scene(), options.views.cameras + 1, options.views.projection());
    Renderer renderer(std::make_shared<GpuScene>());
    renderer.setTiming(true);
    std::array<Distribution, passCount> times;
    for (std::size_t i = 0; i < path.size(); ++i) {
      renderer.render(study.drawn.scene(), {path[i], options.views.size});
      if (i == 0) continue;  // uploads and compiles
      for (std::size_t pass = 0; pass < passCount; ++pass) times[pass].add(renderer.stats()[pass].milliseconds);
    }
    for (std::size_t pass = 0; pass < passCount; ++pass)
      table.rows.push_back({subject.name, std::string(nameOf(static_cast<Pass>(pass))),
                            fixed(times[pass].percentile(0.0), 2), fixed(times[pass].median(), 2),
                            fixed(times[pass].max(), 2)});
  }
  std::cerr << plainText(table);
  section.tables.push_back(std::move(table));
  return section;
}

Section updateSection(const Options& options, const TruthStore&) {
  Section section;
  section.title = "What a change costs";
  section.text =
      "The phantom torso, " + std::to_string(options.views.phantomVoxels) +
      " voxels a side, one view at normal quality: one thing moves back and forth, and only what depends on it runs "
      "again. The share is of the median of full frames drawn in turns with it, as the camera moves. A drag of the "
      "transfer function rebuilds the empty-space skipping: that time alone is the row named so.";
  Table table{"updates", {"change", "passes that run", "least ms", "median ms", "most ms", "share"}, {}};
  const io::Study study = phantomScene(options);
  const Scene& scene = study.drawn.scene();
  const View view{study.view->camera, options.views.size};
  const auto gpu = std::make_shared<GpuScene>();
  Renderer renderer(gpu);
  renderer.render(scene, view);
  constexpr int repetitions = 7;

  /// `change` gets 0, 1, 2, … and turns the scene and view into those to be drawn next.
  const auto add = [&](const std::string& name, const std::function<void(Scene&, View&, int)>& change,
                       bool sceneAlone = false) {
    Distribution times, full;
    std::string passes;
    for (int i = 0; i <= repetitions; ++i) {
      View turned = view;
      turned.camera = view.camera.orbited(0.003 * (i + 1), 0.0);
      const double whole = timed([&] { renderer.render(scene, turned); });
      // Each step starts from the one before, as in a drag.
      Scene changed = scene;
      View seen = view;
      if (i > 0) change(changed, seen, i - 1);
      renderer.render(changed, seen);
      changed = scene;
      seen = view;
      change(changed, seen, i);
      const auto before = renderer.stats();
      const double elapsed = timed([&] {
        if (sceneAlone)
          gpu->update(changed);
        else
          renderer.render(changed, seen);
      });
      if (i == 0) continue;  // the first may compile or allocate
      times.add(elapsed);
      full.add(whole);
      passes = passesBetween(before, renderer.stats());
    }
    table.rows.push_back({name, passes, fixed(times.percentile(0.0), 2), fixed(times.median(), 2),
                          fixed(times.max(), 2), fixed(100.0 * times.median() / full.median(), 1) + " %"});
    renderer.render(scene, view);
  };
  add("camera: full frame", [](Scene&, View& v, int i) { v.camera = v.camera.orbited(0.002 * (i + 1), 0.0); });
  add("w_open", [](Scene& s, View&, int i) { s.look.cutaway.openWidth += 0.5 * (i + 1); });
  add("w_border", [](Scene& s, View&, int i) { s.look.cutaway.borderWidth += 0.25 * (i + 1); });
  add("border colour", [](Scene& s, View&, int i) { s.look.cutaway.borderColour = glm::dvec3(0.05 * i); });
  add("context layer's strength", [](Scene& s, View&, int i) { s.look.contextLayer.strength = 0.05 * (i + 1); });
  BrushStroke dab;
  dab.anchors = {renderer.pick(glm::dvec2(view.size) * 0.5).value_or(scene.volume->grid.centre())};
  add("brush: a dab of 5 mm", [&dab](Scene& s, View&, int i) {
    // Away from where the one before was, within the same centimetre.
    dab.anchors.front().z += i % 2 ? 2.0 : -2.0;
    s.look.strokes = {dab};
  });
  const auto drag = [](Scene& s, View&, int i) {
    // Every node wanders by a few HU and shows a little more or less.
    for (TransferFunction::Node& node : s.look.context.function.nodes) {
      node.value += 2.0 * (i + 1);
      node.properties.extinction *= 1.0 + 0.01 * (i + 1);
    }
  };
  add("transfer function: skipping rebuilt", drag, true);
  add("transfer function: frame", drag);
  add("transfer function: colour", [](Scene& s, View&, int i) {
    for (TransferFunction::Node& node : s.look.context.function.nodes) node.properties.colour *= 1.0 - 0.02 * (i + 1);
  });
  std::cerr << plainText(table);
  section.tables.push_back(std::move(table));
  return section;
}

Section memorySection(const Options& options, const TruthStore&) {
  Section section;
  section.title = "Only what a scene needs";
  section.text =
      "The phantom torso, " + std::to_string(options.views.phantomVoxels) +
      " voxels a side, as scenes that use more and more. Graphics memory in MiB by resource, images at the picture's "
      "size included, main memory of the voxels and labels, and the passes that run.";
  const io::Study study = phantomScene(options);
  const std::vector<tests::FeatureScene> scenes =
      tests::featureScenes(study.drawn.scene(), ValueFocus{{200.0, 3000.0}});
  std::vector<std::string> names;
  std::vector<std::vector<GpuScene::Resource>> all;
  Table table{"memory", {"scene"}, {}};
  std::vector<std::string> passes, mainMemory;
  for (const tests::FeatureScene& kind : scenes) {
    const auto gpu = std::make_shared<GpuScene>();
    Renderer renderer(gpu);
    const auto before = renderer.stats();
    renderer.render(kind.scene, {study.view->camera, options.views.size});
    passes.push_back(passesBetween(before, renderer.stats()));
    all.push_back(gpu->resources());
    all.back().push_back({"images", renderer.imageBytes()});
    const Scene& scene = kind.scene;
    mainMemory.push_back(
        mebibytes(scene.volume->voxels.byteCount() + (scene.labels ? scene.labels->voxels.byteCount() : 0)));
    for (const GpuScene::Resource& resource : all.back())
      if (std::find(names.begin(), names.end(), resource.name) == names.end()) names.push_back(resource.name);
  }
  table.columns.insert(table.columns.end(), names.begin(), names.end());
  table.columns.insert(table.columns.end(), {"graphics memory", "main memory", "passes"});
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    std::vector<std::string> row{scenes[i].name};
    std::size_t sum = 0;
    for (const std::string& name : names) {
      const auto at = std::find_if(all[i].begin(), all[i].end(),
                                   [&](const GpuScene::Resource& resource) { return resource.name == name; });
      row.push_back(at == all[i].end() ? "" : mebibytes(at->bytes));
      sum += at == all[i].end() ? 0 : at->bytes;
    }
    row.insert(row.end(), {mebibytes(sum), mainMemory[i], passes[i]});
    table.rows.push_back(std::move(row));
  }
  std::cerr << plainText(table);
  section.tables.push_back(std::move(table));
  return section;
}

}  // namespace fenestra::bench
