// What runs again when a method or one of its settings changes, and that a method that is not in use costs nothing.

#include "rendering/scene/Lighting.h"
#include "rendering/settings/Settings.h"
#include "tests/gl/MethodsTesting.h"

namespace fenestra::tests {

/// Runs by pass of the last picture of several.
std::set<std::string> Methods::runsOfLast(const std::vector<Scene>& scenes, const View& view) {
  Renderer renderer(gpuWith(usualSchedule()));
  std::array<PassStats, passCount> before{};
  for (const Scene& scene : scenes) {
    before = renderer.stats();
    renderer.render(scene, view);
  }
  std::set<std::string> names;
  for (std::size_t pass = 0; pass < passCount; ++pass)
    if (renderer.stats()[pass].runs > before[pass].runs) names.emplace(nameOf(static_cast<Pass>(pass)));
  return names;
}

namespace {

TEST_F(Methods, Thorough_ReRunOnlyWhatAChangeReaches) {
  const Scene scene = hazyBody(methods::Cone{});
  const View view = viewOf(from(25, 15, scene));
  const auto after = [&](const Scene& first, auto&& change) {
    Scene changed = first;
    change(changed);
    return runsOfLast({first, changed}, view);
  };
  const std::set<std::string> cut{"cones", "distance map", "ray start", "focus layer", "composite"};
  EXPECT_EQ(after(scene, [](Scene& s) { s.look.method.of<methods::Cone>().angle = 50.0; }), cut);
  EXPECT_EQ(after(scene, [](Scene& s) { s.look.cutaway.openWidth += 9.0; }), std::set<std::string>());
  EXPECT_EQ(after(scene, [](Scene& s) { s.look.method.of<methods::Importance>().angle = 50.0; }),
            std::set<std::string>());
  EXPECT_EQ(after(scene, [](Scene& s) { s.look.cutaway.borderWidth += 1.0; }), std::set<std::string>{"composite"});
  const Scene faint = hazyBody(methods::Importance{.mode = ImportanceMode::Average});
  EXPECT_EQ(after(faint, [](Scene& s) { s.look.method.of<methods::Importance>().opacity = 0.5; }),
            std::set<std::string>{"composite"});
  EXPECT_EQ(after(faint, [](Scene& s) { s.look.method.of<methods::Importance>().sparseness = Sparseness::ScreenDoor; }),
            std::set<std::string>{"composite"});
  const Scene clear = hazyBody(methods::ClearView{});
  for (double methods::ClearView::*number :
       {&methods::ClearView::radius, &methods::ClearView::bends, &methods::ClearView::rim}) {
    EXPECT_EQ(after(clear, [=](Scene& s) { s.look.method.of<methods::ClearView>().*number *= 1.5; }),
              std::set<std::string>{"composite"});
    EXPECT_EQ(after(scene, [=](Scene& s) { s.look.method.of<methods::ClearView>().*number *= 1.5; }),
              std::set<std::string>());
  }
  EXPECT_EQ(after(clear, [](Scene& s) { s.look.method.of<methods::ClearView>().fade = LensFade::Depth; }),
            std::set<std::string>{"composite"});
  EXPECT_EQ(after(clear, [](Scene& s) { s.look.cutaway.borderWidth += 4.0; }), std::set<std::string>());
  EXPECT_EQ(after(faint, [](Scene& s) { s.look.method.kind = kindOf<methods::ClearView>; }),
            (std::set<std::string>{"lens", "composite"}));
  const Scene faded = hazyBody(methods::ContextPreserving{});
  for (double methods::ContextPreserving::*number :
       {&methods::ContextPreserving::reach, &methods::ContextPreserving::sharpness}) {
    EXPECT_EQ(after(faded, [=](Scene& s) { s.look.method.of<methods::ContextPreserving>().*number *= 1.5; }),
              std::set<std::string>{"focus layer"});
    EXPECT_EQ(after(scene, [=](Scene& s) { s.look.method.of<methods::ContextPreserving>().*number *= 1.5; }),
              std::set<std::string>());
  }
  const Scene around = hazyBody(methods::FocalRegion{.size = 7.0, .fallOff = 12.0});
  for (double methods::FocalRegion::*number : {&methods::FocalRegion::size, &methods::FocalRegion::fallOff}) {
    EXPECT_EQ(after(around, [=](Scene& s) { s.look.method.of<methods::FocalRegion>().*number *= 1.5; }),
              std::set<std::string>{"focus layer"});
    EXPECT_EQ(after(faded, [=](Scene& s) { s.look.method.of<methods::FocalRegion>().*number *= 1.5; }),
              std::set<std::string>());
    EXPECT_EQ(after(scene, [=](Scene& s) { s.look.method.of<methods::FocalRegion>().*number *= 1.5; }),
              std::set<std::string>());
  }
  EXPECT_EQ(after(around, [](Scene& s) { s.look.method.of<methods::FocalRegion>().shape = FocalShape::Box; }),
            std::set<std::string>{"focus layer"});
  EXPECT_EQ(after(around, [](Scene& s) { s.look.method.of<methods::FocalRegion>().shape = FocalShape::Distance; }),
            std::set<std::string>{"focus layer"});
  EXPECT_EQ(after(around, [](Scene& s) { s.look.method.of<methods::ContextPreserving>().reach *= 2.0; }),
            std::set<std::string>());
  const Scene exploded = hazyBody(methods::Explode{});
  for (const Scene& first : {exploded, faded, scene}) {
    const std::set<std::string> reached = first.look.method.kind == kindOf<methods::Explode>
                                              ? std::set<std::string>{"focus layer"}
                                              : std::set<std::string>();
    EXPECT_EQ(after(first, [](Scene& s) { s.look.method.of<methods::Explode>().degree = 0.2; }), reached);
    EXPECT_EQ(after(first, [](Scene& s) { s.look.method.of<methods::Explode>().planes = ExplosionPlanes::One; }),
              reached);
    EXPECT_EQ(after(first, [](Scene& s) { s.look.method.of<methods::Explode>().axes = ExplosionAxes::View; }), reached);
  }
  EXPECT_EQ(
      after(exploded,
            [](Scene& s) { s.look.cutaway.openWidth = s.look.method.of<methods::ContextPreserving>().reach = 9.0; }),
      std::set<std::string>());
  const Scene maximum = hazyBody(methods::Mip{});
  EXPECT_EQ(after(maximum, [](Scene& s) { s.look.method.of<methods::Mip>().thickness = 2.0; }),
            (std::set<std::string>{"maximum", "composite"}));
  EXPECT_EQ(after(scene, [](Scene& s) { s.look.method.of<methods::Mip>().thickness = 2.0; }), std::set<std::string>());
  const Scene ghost = hazyBody(methods::Selection{});
  for (double methods::Selection::*number :
       {&methods::Selection::strength, &methods::Selection::edge, &methods::Selection::outline}) {
    EXPECT_EQ(after(ghost, [=](Scene& s) { s.look.method.of<methods::Selection>().*number *= 0.5; }),
              (std::set<std::string>{"focus layer", "composite"}));
    EXPECT_EQ(after(scene, [=](Scene& s) { s.look.method.of<methods::Selection>().*number *= 0.5; }),
              std::set<std::string>());
  }
  EXPECT_EQ(after(faded, [](Scene& s) { s.look.cutaway.openWidth = s.look.cutaway.borderWidth = 9.0; }),
            std::set<std::string>());
}

TEST_F(Methods, WallsReRunAlone) {
  using Names = std::set<std::string>;
  const auto after = [](const Scene& scene, auto&& change) {
    const View view = viewOf(from(25, 15, scene));
    Scene changed = scene;
    View changedView = view;
    change(changed, changedView);
    Renderer renderer(gpuWith(usualSchedule()));
    renderer.render(scene, view);
    const auto before = renderer.stats();
    renderer.render(changed, changedView);
    Names names;
    for (std::size_t pass = 0; pass < passCount; ++pass)
      if (renderer.stats()[pass].runs > before[pass].runs) names.emplace(nameOf(static_cast<Pass>(pass)));
    return names;
  };
  const Scene around = hazyBody(methods::Walls{});
  const Scene inside = hazyBody(methods::Walls{.placement = WallPlacement::Inside});
  const auto move = [](Scene& scene, View& view) { view.slices.crosshair = scene.volume->grid.centre() + 3.0; };
  const auto widen = [](Scene&, View& view) { view.slices.window = WindowLevel{70.0, 50.0}; };
  EXPECT_EQ(after(around, move), Names{"walls"});
  EXPECT_EQ(after(around, widen), Names{"walls"});
  EXPECT_EQ(after(inside, move), (Names{"walls", "composite"}));
  EXPECT_EQ(after(inside, widen), (Names{"walls", "composite"}));
  for (bool methods::Walls::*which :
       {&methods::Walls::axial, &methods::Walls::sagittal, &methods::Walls::coronal, &methods::Walls::outlines})
    EXPECT_TRUE(after(around, [=](Scene& scene, View&) {
                  scene.look.method.of<methods::Walls>().*which = false;
                }).contains("walls"));
  EXPECT_EQ(
      after(around, [](Scene& scene, View&) { put(scene.look.labels, {.label = 1, .visible = false}); }).count("walls"),
      1u);
  EXPECT_EQ(after(hazyBody({}), move), Names());
  EXPECT_EQ(after(around, [](Scene&, View&) {}), Names());
}

TEST_F(Methods, Thorough_AMethodThatIsNotInUseCostsNothing) {
  const Scene scene = hazyBody({});
  const View view = viewOf(from(25, 15, scene));
  Scene others = scene;
  Method& unused = others.look.method;
  unused.of<methods::Cone>() = {.angle = 70.0};
  unused.of<methods::Importance>() = {
      .mode = ImportanceMode::Average, .angle = 40.0, .opacity = 0.9, .sparseness = Sparseness::Colour};
  unused.of<methods::ClearView>() = {.fade = LensFade::Depth, .radius = 70.0, .bends = 3.0, .rim = 9.0};
  unused.of<methods::ContextPreserving>() = {.reach = 7.0, .sharpness = 1.5};
  unused.of<methods::FocalRegion>() = {.shape = FocalShape::Box, .size = 4.0, .fallOff = 3.0};
  unused.of<methods::Walls>() = {.placement = WallPlacement::Inside, .axial = false, .outlines = false};
  unused.of<methods::Explode>() = {.degree = 0.9, .planes = ExplosionPlanes::Three, .axes = ExplosionAxes::View};
  unused.of<methods::Mip>() = {.thickness = 3.0};
  unused.of<methods::Selection>() = {.strength = 0.3, .edge = 40.0, .outline = 0.9};
  View other = view;
  other.slices = {scene.volume->grid.centre() + 5.0, WindowLevel{9.0, 8.0}, true};
  Renderer renderer(gpuWith(usualSchedule())), fresh(gpuWith(usualSchedule()));
  fresh.render(scene, view);
  for (const Pass pass : {Pass::Cones, Pass::FaintLayer, Pass::Lens, Pass::Walls, Pass::Maximum})
    EXPECT_EQ(fresh.stats()[static_cast<std::size_t>(pass)].runs, 0u) << nameOf(pass);
  renderer.render(others, other);
  EXPECT_EQ(renderer.readPicture(), fresh.readPicture());
  EXPECT_EQ(renderer.imageBytes(), fresh.imageBytes());
  // A method gives back what it took.
  for (const auto& [name, method] : otherMethods()) {
    Scene byIt = scene;
    byIt.look.method = method;
    renderer.render(byIt, view);
    renderer.render(scene, view);
    EXPECT_EQ(renderer.readPicture(), fresh.readPicture()) << name;
    EXPECT_EQ(renderer.imageBytes(), fresh.imageBytes()) << name;
  }
}

TEST_F(Methods, Exhaustive_ChangesLeaveNothingBehind) {
  Renderer renderer(gpuWith(usualSchedule()));
  const auto expectFresh = [&](const Scene& scene, const View& view, const std::string& what) {
    renderer.render(scene, view);
    Renderer fresh(gpuWith(usualSchedule()));
    fresh.render(scene, view);
    EXPECT_EQ(renderer.readPicture(), fresh.readPicture()) << what;
    EXPECT_EQ(renderer.imageBytes(), fresh.imageBytes()) << what;
  };
  const View view = viewOf(from(25, 15, hazyBody({})));
  View frozen = view;
  frozen.frozen = OpeningView{from(0, 5, hazyBody({})), size, 1.0};
  for (const auto& [name, method] : otherMethods()) {
    Scene scene = hazyBody(method);
    expectFresh(scene, view, name);
    expectFresh(brushed(scene), view, name + ", a stroke");
    expectFresh(scene, frozen, name + ", frozen");
    expectFresh(brushed(scene), frozen, name + ", a stroke, frozen");
    scene.look.method.of<methods::Cone>().angle = scene.look.method.of<methods::Importance>().angle = 55.0;
    scene.look.method.of<methods::Importance>().opacity = 0.6;
    scene.look.method.of<methods::ClearView>().radius = 30.0;
    scene.look.method.of<methods::ContextPreserving>().reach = 5.0;
    scene.look.method.of<methods::FocalRegion>().size = 9.0;
    scene.look.method.of<methods::Walls>().sagittal = false;
    scene.look.method.of<methods::Explode>().degree = 0.8;
    scene.look.method.of<methods::Selection>().strength = 0.4;
    scene.look.method.of<methods::Mip>().thickness = 3.0;
    expectFresh(scene, view, name + ", other parameters");
    View moved = view;
    moved.slices.crosshair = scene.volume->grid.centre() - 4.0;
    expectFresh(scene, moved, name + ", another crosshair");
    expectFresh(withProtected(scene), view, name + ", a protected label");
    scene.look.cutaway.openWidth = 20.0;
    scene.look.method.kind = kindOf<methods::Adaptive>;
    expectFresh(scene, view, name + ", then the adaptive cutaway");
    scene.look.cutaway.enabled = false;
    expectFresh(scene, view, name + ", then none");
  }
}

}  // namespace
}  // namespace fenestra::tests
