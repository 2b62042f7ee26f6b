#pragma once
// Bodies, views and the comparison that tests of the methods share.

#include <set>

#include "tests/gl/GlTest.h"
#include "tests/gl/SceneKinds.h"

namespace fenestra::tests {

constexpr glm::ivec2 size{88, 72};

/// A body that light passes through in part, with an organ in focus.
inline Scene hazyBody(const Method& method, const Grid& grid = gridOf({40, 36, 34})) {
  Scene scene = bodyWithOrgans<std::int16_t>(grid);
  scene.look.context.function = {{{20.0, {glm::dvec3(0.8, 0.5, 0.4), 0.0}},
                                  {60.0, {glm::dvec3(0.9, 0.7, 0.6), 0.08}},
                                  {120.0, {glm::dvec3(1.0, 0.95, 0.9), 0.3}}}};
  scene.look.focus = LabelFocus{{1}};
  scene.look.cutaway.openWidth = 12.0;
  scene.look.method = method;
  return scene;
}

inline Camera from(double azimuth, double elevation, const Scene& scene,
                   Projection projection = Projection::Perspective) {
  return Camera::fromAngles(azimuth, elevation, scene.volume->grid, projection);
}

inline View viewOf(const Camera& camera, double maxError = 1.0) {
  View view{.camera = camera, .size = size};
  view.maxError = maxError;
  return view;
}

class Methods : public GlTest {
 protected:
  static void TearDownTestSuite() {
    programs_.reset();
    GlTest::TearDownTestSuite();
  }
  /// All with the same programs, so that each is compiled once.
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
  static std::set<std::string> runsOfLast(const std::vector<Scene>& scenes, const View& view);

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

/// One of each kind; the others differ in the composite alone.
inline std::vector<std::pair<std::string, Method>> eachMethod() {
  auto methods = otherMethods();
  methods.resize(8);
  methods.emplace_back("maximum", methods::Mip{});
  return methods;
}

}  // namespace fenestra::tests
