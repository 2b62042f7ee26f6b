// Pictures with several levels of importance: against the reference within their bounds, what runs again when, and that
// levels that are not in use cost nothing.

#include <set>

#include "rendering/reference/Picture.h"
#include "rendering/scene/Importance.h"
#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests::importanceTest {
namespace {

constexpr glm::ivec2 size{66, 54};

/// A hazy body, in it from the front to the back a ball of label 2, one of label 1 that it touches, and one of label 3
/// beside them.
Scene organs(std::vector<std::uint16_t> focus, std::initializer_list<std::pair<std::uint16_t, int>> levels,
             ImportanceMode mode = ImportanceMode::Maximum) {
  const Grid grid = gridOf({40, 36, 34});
  Scene scene = bodyWithOrgans<std::int16_t>(grid);
  scene.look.context.function = {{{20.0, {glm::dvec3(0.8, 0.5, 0.4), 0.0}},
                                  {60.0, {glm::dvec3(0.9, 0.7, 0.6), 0.08}},
                                  {120.0, {glm::dvec3(1.0, 0.95, 0.9), 0.3}}}};
  const auto labels = labelsOf(grid, [&](glm::ivec3 i) {
    const glm::dvec3 p = glm::dvec3(i) - grid.centre();
    return glm::length(p - glm::dvec3(1, 5, 0)) < 4.2      ? 1
           : glm::length(p - glm::dvec3(-2, -4, 2)) < 7.3  ? 2
           : glm::length(p - glm::dvec3(10, -3, -5)) < 4.4 ? 3
                                                           : 0;
  });
  labels->labels = {{1, "one", {1.0, 0.4, 0.2}}, {2, "two", {0.2, 0.5, 1.0}}, {3, "three", {0.3, 0.9, 0.4}}};
  scene.labels = labels;
  scene.look.focus = LabelFocus{std::move(focus)};
  scene.look.method = methods::Importance{.mode = mode, .opacity = 0.3};
  for (const auto& [label, level] : levels) put(scene.look.labels, {.label = label, .importance = level});
  return scene;
}

/// A ball of stripes of two labels of the same level, of which one is in focus: rays start on its surface within cells
/// that hold some of both.
Scene stripes(ImportanceMode mode) {
  Scene scene = organs({1}, {{1, 1}, {2, 1}}, mode);
  const Grid& grid = scene.volume->grid;
  const auto labels = labelsOf(grid, [&](glm::ivec3 i) {
    return glm::distance(glm::dvec3(i), grid.centre()) < 9.0 ? 1 + (i.x / 2 + i.z / 2) % 2 : 0;
  });
  labels->labels = scene.labels->labels;
  scene.labels = labels;
  return scene;
}

View viewOf(const Scene& scene, double azimuth = 12.0, Projection projection = Projection::Perspective) {
  View view{.camera = Camera::fromAngles(azimuth, 8.0, scene.volume->grid, projection), .size = size};
  view.maxError = 1.0;
  return view;
}

class ImportanceLevels : public GlTest {
 protected:
  static void TearDownTestSuite() {
    programs_.reset();
    GlTest::TearDownTestSuite();
  }
  static std::shared_ptr<GpuScene> gpuWith(Schedule schedule) {
    if (!programs_) programs_ = std::make_shared<gl::ComputePrograms>();
    const auto gpu = std::make_shared<GpuScene>(programs_);
    gpu->setSchedule(schedule);
    return gpu;
  }
  static Layers drawn(const Scene& scene, const View& view, Schedule schedule = usualSchedule()) {
    Renderer renderer(gpuWith(schedule));
    renderer.render(scene, view);
    return renderer.readLayers();
  }
  static void expectMatches(const Scene& scene, const View& view);
  /// Names of the passes that run for each picture after the first one.
  static std::vector<std::set<std::string>> runsOf(const std::vector<Scene>& scenes) {
    Renderer renderer(gpuWith(usualSchedule()));
    renderer.render(scenes.front(), viewOf(scenes.front()));
    std::vector<std::set<std::string>> names;
    for (std::size_t i = 1; i < scenes.size(); ++i) {
      const auto before = renderer.stats();
      renderer.render(scenes[i], viewOf(scenes[i]));
      std::set<std::string>& ran = names.emplace_back();
      for (std::size_t pass = 0; pass < passCount; ++pass)
        if (renderer.stats()[pass].runs > before[pass].runs) ran.emplace(nameOf(static_cast<Pass>(pass)));
    }
    return names;
  }

 private:
  inline static gl::SharedPrograms programs_;
};

/// Share of the pixels, in per mille, whose colour is off by more than a limit in 1/255.
template <class Colour>
double perMilleBeyond(double bound, const std::vector<glm::vec4>& picture, const std::vector<Colour>& truth) {
  EXPECT_EQ(picture.size(), truth.size());
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < std::min(picture.size(), truth.size()); ++i) {
    const glm::dvec4 off = 255.0 * glm::abs(glm::dvec4(picture[i]) - glm::dvec4(truth[i]));
    if (!(std::max({off.r, off.g, off.b, off.a}) <= bound)) ++beyond;
  }
  return 1000.0 * static_cast<double>(beyond) / static_cast<double>(truth.size());
}

/// Stages 1 to 4 and the picture. Where a ray grazes a surface or an opening's rim, rounding decides what it meets
/// first: such pixels lie on lines and are held to four in a thousand, as those of other methods are.
void ImportanceLevels::expectMatches(const Scene& scene, const View& view) {
  ASSERT_FALSE(importanceLevels(scene).empty());
  const reference::Stages stages = reference::geometricStages(scene, view);
  const reference::Picture truth = reference::picture(scene, view.camera, view.size, stages);
  const double voxel = finestSpacing(scene.volume->grid);
  for (const Schedule schedule : pictureSchedules()) {
    SCOPED_TRACE(nameOf(schedule));
    const Layers layers = drawn(scene, view, schedule);
    const StageErrors starts = compareMaps(layers.tStart, stages.tStart, voxel);
    EXPECT_LE(starts.percentile(0.996), 2e-3);
    const StageErrors opened = compareMaps(layers.tFocus, stages.hits.tFocus, voxel);
    EXPECT_LE(opened.percentile(0.996), 2e-3);
    EXPECT_LE(opened.onlyHere + opened.onlyReference, 4 * stages.tStart.size() / 1000);
    EXPECT_LE(perMilleBeyond(*view.maxError, layers.focusLayer, truth.focusLayer), 4.0);
    EXPECT_EQ(layers.faintLayer.empty(), truth.faintLayer.empty());
    if (!truth.faintLayer.empty()) {
      EXPECT_LE(perMilleBeyond(*view.maxError, layers.faintLayer, truth.faintLayer), 4.0);
    }
    EXPECT_LE(perMilleBeyond(*view.maxError, layers.final, truth.final), 4.0);
  }
}

struct Case {
  std::string name;
  Scene scene;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const ImportanceMode mode : {ImportanceMode::Maximum, ImportanceMode::Average}) {
    const std::string by = mode == ImportanceMode::Maximum ? ", maximum" : ", average";
    all.push_back({"a label of the context" + by, organs({1}, {{2, 1}}, mode)});
    all.push_back({"two in focus" + by, organs({1, 2}, {{2, 1}}, mode)});
    all.push_back({"three in focus" + by, organs({1, 2, 3}, {{1, 3}, {2, 2}, {3, 1}}, mode)});
    all.push_back({"the context above the focus" + by, organs({2}, {{2, 1}, {1, 3}}, mode)});
    all.push_back({"a label in focus of level 0" + by, organs({1, 2}, {{1, 2}, {2, 0}}, mode)});
    all.push_back({"stripes" + by, stripes(mode)});
    all.push_back({"nothing important" + by, organs({1, 2}, {{1, 0}, {2, 0}}, mode)});
  }
  return all;
}

TEST_F(ImportanceLevels, Thorough_MatchTheReference) {
  for (const auto& [name, scene] : cases()) {
    SCOPED_TRACE(name);
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
      expectMatches(scene, viewOf(scene, 12.0, projection));
  }
}

TEST_F(ImportanceLevels, Exhaustive_MatchTheReferenceWithWhatElseAPictureMayHave) {
  for (const ImportanceMode mode : {ImportanceMode::Maximum, ImportanceMode::Average}) {
    SCOPED_TRACE(wordOf(mode).word);
    const Scene scene = organs({1, 2}, {{1, 3}, {2, 1}}, mode);
    const auto expectWith = [&](const char* what, const auto& change) {
      SCOPED_TRACE(what);
      Scene changed = scene;
      View view = viewOf(scene);
      change(changed, view);
      expectMatches(changed, view);
    };
    expectWith("smoothed labels", [](Scene& s, View&) { s.look.labelSmoothing = LabelSmoothing::Strong; });
    expectWith("a spline", [](Scene& s, View&) { s.look.reconstruction = Reconstruction::Cubic; });
    expectWith("strokes", [](Scene& s, View&) { s = brushed(s); });
    expectWith("a protected label", [](Scene& s, View&) {
      put(s.look.labels, {.label = 3, .role = LabelRole::Protected, .importance = 2});
    });
    expectWith("grey faces", [](Scene& s, View&) { s = clipped(s, true); });
    expectWith("faces by value", [](Scene& s, View&) { s = clipped(s, false); });
    expectWith("a frozen opening", [](Scene& s, View& v) {
      v.frozen = OpeningView{viewOf(s, -25.0).camera, {70, 66}, 1.0};
    });
    expectWith("occlusion", [](Scene& s, View&) { s = occluded(s); });
    expectWith("no light", [](Scene& s, View&) { s.look.shading.enabled = false; });
    expectWith("a focus by value", [](Scene& s, View&) {
      LabelSetting setting = settingFor(s.look.labels, 2);
      setting.function = byValue(s).look.focusAppearance.function;
      put(s.look.labels, setting);
    });
    expectWith("faint labels", [](Scene& s, View&) { s = withFaint(s); });
  }
}

TEST_F(ImportanceLevels, Thorough_OfNormalQualityAreNoWorseThanOneLevel) {
  // Segments that begin on a surface of the focus are of the focus, on whichever side rounding has put their ends;
  // those that begin on another label's are not.
  for (const auto& [name, scene] : cases()) {
    SCOPED_TRACE(name);
    View view = viewOf(scene);
    view.maxError.reset();
    const auto beyond = [&](const Scene& of) {
      const reference::Picture truth = reference::picture(of, view);
      return perMilleBeyond(8.0, drawn(of, view).final, truth.final);
    };
    Scene plain = scene;
    for (LabelSetting& each : plain.look.labels) each.importance.reset();
    // Each further level has rims of its own.
    EXPECT_LE(beyond(scene), 3.0 * beyond(plain) + 4.0);
  }
}

TEST_F(ImportanceLevels, Thorough_AreOtherPicturesThanOneLevel) {
  std::vector<std::vector<glm::vec4>> pictures;
  for (const auto& [name, scene] : cases()) {
    Scene plain = scene;
    for (LabelSetting& each : plain.look.labels) each.importance.reset();
    for (const Scene& each : {scene, plain}) pictures.push_back(drawn(each, viewOf(each)).final);
    EXPECT_GT(perMilleBeyond(4.0, pictures[pictures.size() - 2], pictures.back()), 8.0)
        << name << ": twice what a match may miss";
  }
}

TEST_F(ImportanceLevels, CostNothingWhereTheFocusIsTheOneLevel) {
  for (const ImportanceMode mode : {ImportanceMode::Maximum, ImportanceMode::Average}) {
    const Scene plain = organs({1, 2}, {}, mode), same = organs({1, 2}, {{1, 2}, {2, 2}, {3, 0}}, mode),
                levelled = organs({1, 2}, {{2, 1}}, mode);
    const View view = viewOf(plain);
    const auto gpu = gpuWith(usualSchedule());
    Renderer renderer(gpu), fresh(gpuWith(usualSchedule()));
    fresh.render(plain, view);
    const auto expectPlain = [&](const char* what) {
      EXPECT_EQ(renderer.readPicture(), fresh.readPicture()) << what;
      EXPECT_EQ(renderer.imageBytes(), fresh.imageBytes()) << what;
      for (const GpuScene::Resource& each : gpu->resources()) EXPECT_NE(each.name, "levels of importance") << what;
    };
    renderer.render(same, view);
    expectPlain("the same level for all of the focus");
    EXPECT_EQ(renderer.stats()[static_cast<std::size_t>(Pass::Importance)].runs, 0u);
    renderer.render(levelled, view);
    EXPECT_NE(renderer.readPicture(), fresh.readPicture());
    renderer.render(plain, view);
    expectPlain("what levels took is given back");
    Scene other = plain;
    other.look.method.kind = kindOf<methods::Adaptive>;
    renderer.render(other, view);
    EXPECT_EQ(renderer.stats()[static_cast<std::size_t>(Pass::Importance)].runs, 1u);
  }
}

TEST_F(ImportanceLevels, RunAgainWhatAChangeConcerns) {
  const Scene scene = organs({1, 2}, {{2, 1}});
  Scene wider = scene, recoloured = scene, lower = scene;
  wider.look.method.of<methods::Importance>().angle = 40.0;
  put(recoloured.look.labels, {.label = 2, .colour = glm::dvec3(1.0, 1.0, 0.0), .importance = 1});
  put(lower.look.labels, {.label = 3, .importance = 1});
  const auto ran = runsOf({scene, wider, wider, scene, recoloured, lower});
  EXPECT_FALSE(ran[0].contains("important hits")) << "an angle turns cones alone";
  EXPECT_TRUE(ran[0].contains("cones"));
  EXPECT_TRUE(ran[1].empty());
  EXPECT_FALSE(ran[3].contains("cones"));
  EXPECT_TRUE(ran[3].contains("focus layer"));
  EXPECT_TRUE(ran[4].contains("important hits"));
}

TEST_F(ImportanceLevels, Exhaustive_ChangesLeaveNothingBehind) {
  Renderer renderer(gpuWith(usualSchedule()));
  const auto expectFresh = [&](const Scene& scene, const View& view, const std::string& what) {
    renderer.render(scene, view);
    Renderer fresh(gpuWith(usualSchedule()));
    fresh.render(scene, view);
    EXPECT_EQ(renderer.readPicture(), fresh.readPicture()) << what;
    EXPECT_EQ(renderer.imageBytes(), fresh.imageBytes()) << what;
  };
  for (const auto& [name, scene] : cases()) {
    const View view = viewOf(scene);
    View frozen = view, larger = view;
    frozen.frozen = OpeningView{viewOf(scene, -25.0).camera, {70, 66}, 1.0};
    larger.size = {96, 61};
    expectFresh(scene, view, name);
    expectFresh(brushed(scene), view, name + ", a stroke");
    expectFresh(scene, frozen, name + ", frozen");
    expectFresh(scene, larger, name + ", of another size");
    Scene recoloured = scene;
    LabelSetting setting = settingFor(scene.look.labels, 2);
    setting.colour = glm::dvec3(1.0, 1.0, 0.0);
    put(recoloured.look.labels, setting);
    expectFresh(recoloured, larger, name + ", another colour");
    Scene value = scene;
    value.look.focus = ValueFocus{{95.0, 1000.0}, 0.0};
    expectFresh(value, larger, name + ", then values in focus");
  }
}

TEST_F(ImportanceLevels, AClickMeetsWhatIsSeen) {
  const Scene scene = organs({1, 2}, {{2, 1}});
  const View view = viewOf(scene);
  Renderer renderer(gpuWith(usualSchedule()));
  renderer.render(scene, view);
  const reference::Stages stages = reference::geometricStages(scene, view);
  Scene plain = scene;
  plain.look.labels.clear();
  const reference::Stages ofOneLevel = reference::geometricStages(plain, view);
  int beforeTheFocus = 0;
  for (int j = 4; j < size.y; j += 4)
    for (int i = 4; i < size.x; i += 4) {
      const auto at = static_cast<std::size_t>(j * size.x + i);
      const auto picked = renderer.pick({i + 0.5, j + 0.5});
      ASSERT_EQ(picked.has_value(), !std::isnan(stages.tStart[at]));
      if (!picked) continue;
      const reference::Ray ray = reference::pixelRay(view.camera, size, {i, j});
      EXPECT_NEAR(glm::distance(*picked, ray.origin), stages.tStart[at], 2e-3) << i << ", " << j;
      beforeTheFocus += stages.tStart[at] > ofOneLevel.tStart[at] + 1.0;
    }
  EXPECT_GT(beforeTheFocus, 5) << "a label in focus that is opened";
}

}  // namespace
}  // namespace fenestra::tests::importanceTest
