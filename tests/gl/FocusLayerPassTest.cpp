// Stage 5 alone, against the reference and closed forms: with an opening and without one, cell by cell and from face to
// face. Rays between those of a lattice have a file of their own (AdaptiveSamplingTest).

#include "rendering/passes/FocusLayerPass.h"

#include "rendering/reference/Picture.h"
#include "tests/gl/MadeOpening.h"

namespace fenestra::tests::focusLayerPassTest {
namespace {

using Sampling = FocusLayerPass::Sampling;

/// A scene on the GPU and a picture of it.
class Drawing {
 public:
  Drawing(const Scene& scene, const Camera& camera, glm::ivec2 size, Schedule schedule)
      : look_(scene.look), size_(size), rays_(camera, size, scene.volume->grid) {
    gpu_.setSchedule(schedule);
    gpu_.update(scene);
  }

  void run(const MadeOpening* made, const Sampling& sampling, std::span<const gl::Region> regions, gl::Texture& image) {
    if (!made) return runWhole(pass_, gpu_, look_, rays_, std::nullopt, sampling, regions, image);
    const gl::Texture hits = imageOf(made->hits, size_), starts = imageOf(made->starts, size_);
    runWhole(pass_, gpu_, look_, rays_, FocusLayerPass::RayStarts{hits, starts}, sampling, regions, image);
  }
  std::vector<glm::vec4> pixels(const MadeOpening* made, const Sampling& sampling) {
    gl::Texture image = blank<glm::vec4>(size_);
    run(made, sampling, whole(size_), image);
    return texelsOf<glm::vec4>(image);
  }
  std::size_t bytes() const { return pass_.bytes(); }

 private:
  GpuScene gpu_;
  Look look_;
  glm::ivec2 size_;
  RayFrame rays_;
  FocusLayerPass pass_;
};

constexpr double bound = 0.5 / 255.0;

/// Holds both integrals against the reference, in both schedules. Without an opening rays start at the box's entry.
void expectMatch(Scene scene, const Camera& camera, glm::ivec2 size, bool open) {
  scene.look.cutaway.enabled = open;
  std::optional<MadeOpening> made;
  if (open) made.emplace(scene, camera, size);
  const std::vector<glm::dvec4> truth =
      reference::picture(scene, camera, size, made ? made->truth : reference::Stages(), {}).focusLayer;
  for (const Schedule schedule : schedules) {
    SCOPED_TRACE(named(schedule, size) + (open ? ", open" : ", closed"));
    Drawing drawing(scene, camera, size, schedule);
    // The bound is what cell by cell is asked for.
    EXPECT_LE(errorsOf(drawing.pixels(made ? &*made : nullptr, {.maxError = bound}), truth).worst, 0.5);
    // From face to face there is no bound: the focus's surface, a cubic along a ray, is taken for its chord, so that a
    // ray that grazes it is off by some ten steps of 8 bits, and all together by about one.
    EXPECT_LE(errorsOf(drawing.pixels(made ? &*made : nullptr, {}), truth).rms, 1.5);
  }
}

using FocusLayerPassTest = GlTest;

TEST_F(FocusLayerPassTest, Exhaustive_UnlitPicturesOfAnySize) {
  const Scene scene = waves(false);
  for (const glm::ivec2 size : awkwardSizes)
    for (const bool open : {false, true}) expectMatch(scene, aside(scene), size, open);
  for (const bool open : {false, true}) expectMatch(scene, aside(scene, Projection::Orthographic), {33, 17}, open);
}

TEST_F(FocusLayerPassTest, Thorough_LitPictures) {
  const Scene scene = waves(true);
  for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(33, 17)})
    for (const bool open : {false, true}) expectMatch(scene, aside(scene), size, open);
}

/// Ramps and a step, over values that differ by more than that from voxel to voxel.
TransferFunction stepped(double density) {
  return {{{200.0, {{1.0, 0.2, 0.1}, 0.0}},
           {450.0, {{0.9, 0.8, 0.2}, 0.1 * density}},
           {450.0, {{0.1, 0.3, 1.0}, density}},
           {600.0, {{0.2, 1.0, 0.3}, 0.3 * density}},
           {850.0, {{1.0, 1.0, 0.8}, 0.7 * density}}}};
}

TransferFunction ramps(double density) {
  return {{{200.0, {{1.0, 0.2, 0.1}, 0.0}},
           {450.0, {{0.1, 0.3, 1.0}, density}},
           {600.0, {{0.2, 1.0, 0.3}, 0.3 * density}},
           {850.0, {{1.0, 1.0, 0.8}, 0.7 * density}}}};
}

/// Three kinds of focus by value: one label; two labels, one of them with a material; a range of values.
std::vector<Scene> scenesByValue(bool lit, const TransferFunction& function) {
  Scene one = waves(lit), two = one, values = one;
  put(one.look.labels, {.label = 1, .function = function});
  two.labels = labelsOf(two.volume->grid, [](glm::ivec3 i) {
    return glm::distance(glm::dvec3(i), glm::dvec3(11.0, 8.0, 9.5)) < 5.0 ? (i.x + i.y < 19 ? 1 : 2) : 0;
  });
  two.look.focus = LabelFocus{{1, 2}};
  put(two.look.labels, {.label = 2, .opacity = 0.7, .function = function});
  values.look.focus = ValueFocus{{430.0, 700.0}, 0.0};
  values.labels = nullptr;
  values.look.focusAppearance.function = function;
  return {one, two, values};
}

TEST_F(FocusLayerPassTest, Exhaustive_FocusesByValue) {
  for (const bool lit : {false, true})
    for (const double density : {0.1, 1.0})
      for (const Scene& scene : scenesByValue(lit, stepped(density))) {
        SCOPED_TRACE((lit ? "lit, focus " : "unlit, focus ") + std::to_string(scene.look.focus.index()) + ", density " +
                     std::to_string(density));
        for (const bool open : {false, true}) expectMatch(scene, aside(scene), {33, 17}, open);
      }
}

TEST_F(FocusLayerPassTest, Exhaustive_FocusesByValueKeepEveryBound) {
  constexpr glm::ivec2 size{61, 47};
  for (const bool lit : {false, true})
    for (Scene scene : scenesByValue(lit, ramps(2.0))) {
      scene.look.cutaway.enabled = false;
      const Camera camera = aside(scene);
      const std::vector<glm::dvec4> truth = reference::picture(scene, camera, size, {}, {}).focusLayer;
      for (const Schedule schedule : schedules) {
        Drawing drawing(scene, camera, size, schedule);
        for (const double allowed : {4.0, 1.0, 0.5})
          EXPECT_LE(errorsOf(drawing.pixels(nullptr, {.maxError = allowed / 255.0}), truth).worst, allowed)
              << nameOf(schedule) << (lit ? ", lit" : ", unlit") << ", focus " << scene.look.focus.index();
      }
    }
}

TEST_F(FocusLayerPassTest, Thorough_AFunctionThatIsConstantShowsAMaterial) {
  constexpr glm::ivec2 size{33, 17};
  for (const bool lit : {false, true}) {
    Scene material = waves(lit);
    material.look.cutaway.enabled = false;
    const Camera camera = aside(material);
    Scene constant = material;
    const OpticalProperties same = focusMaterial(material, 1);
    put(constant.look.labels, {.label = 1, .function = TransferFunction{{{300.0, same}, {600.0, same}}}});
    for (const Schedule schedule : schedules) {
      const std::vector<glm::vec4> here =
          Drawing(constant, camera, size, schedule).pixels(nullptr, {.maxError = bound});
      std::vector<glm::dvec4> truth;
      for (const glm::vec4 pixel : Drawing(material, camera, size, schedule).pixels(nullptr, {.maxError = bound}))
        truth.emplace_back(pixel);
      EXPECT_LE(errorsOf(here, truth).worst, 2.0 * 0.5) << "each is within its bound";
    }
  }
}

TEST_F(FocusLayerPassTest, FocusNowhereAndEverywhere) {
  Scene none = waves(false), absent = none, everywhere = none;
  none.look.focus = {};
  none.labels = nullptr;
  expectMatch(none, aside(none), {33, 17}, false);
  absent.look.focus = LabelFocus{{7}};
  expectMatch(absent, aside(absent), {33, 17}, true);
  everywhere.labels = labelsOf(everywhere.volume->grid, [](glm::ivec3) { return 1; });
  for (const bool open : {false, true}) expectMatch(everywhere, aside(everywhere), {33, 17}, open);
}

/// Greatest error in a uniform medium, against Beer's law.
double errorInAnEvenMedium(double extinction, Schedule schedule, const Sampling& sampling) {
  Scene scene = waves(false);
  scene.look.focus = {};
  scene.labels = nullptr;
  const OpticalProperties even{{0.9, 0.5, 0.2}, extinction};
  scene.look.context.function = {{{0.0, even}, {1000.0, even}}};
  constexpr glm::ivec2 size{33, 17};
  const Camera camera = aside(scene);
  std::vector<glm::dvec4> truth;
  for (std::size_t i = 0; i < pixelsIn(size); ++i) {
    const auto span = reference::clip(reference::pixelRay(camera, size, pixelAt(i, size)), scene.volume->grid);
    const double opacity = span ? 1.0 - std::exp(-even.extinction * (span->tOut - span->tIn)) : 0.0;
    truth.push_back(opacity * glm::dvec4(even.colour, 1.0));
  }
  return errorsOf(Drawing(scene, camera, size, schedule).pixels(nullptr, sampling), truth).worst;
}

TEST_F(FocusLayerPassTest, AnEvenMediumFollowsBeersLaw) {
  for (const Schedule schedule : schedules)
    for (const Sampling& sampling : {Sampling{.maxError = bound}, Sampling{}}) {
      // Some forty pieces of a ray, each with an exponential in float32.
      EXPECT_LE(errorInAnEvenMedium(0.06, schedule, sampling), 0.01);
      EXPECT_LE(errorInAnEvenMedium(0.0, schedule, sampling), 0.0);
    }
}

TEST_F(FocusLayerPassTest, ARayEndsWhereHalfOfWhatIsLeftIsLittle) {
  for (const Schedule schedule : schedules) {
    // A ray with a bound ends at a quarter of it, one from face to face at the tolerance of a 256th, and either is off
    // by half of that.
    EXPECT_LE(errorInAnEvenMedium(0.6, schedule, {.maxError = bound}), 0.5 * 0.5 / 4.0 + 0.01);
    EXPECT_LE(errorInAnEvenMedium(0.6, schedule, {}), 0.5 + 0.01);
  }
}

TEST_F(FocusLayerPassTest, ShowsNothingWhereRaysStartNowhereOrThereIsNothing) {
  const Scene scene = waves(false);
  constexpr glm::ivec2 size{33, 17};
  const Camera camera = aside(scene);
  MadeOpening made(scene, camera, size);
  made.starts.assign(pixelsIn(size), nothing);
  Scene clear = scene;
  clear.look.focus = {};
  clear.labels = nullptr;
  clear.look.context.function = opaqueFrom(1e6);
  for (const Schedule schedule : schedules)
    for (const Sampling& sampling : {Sampling{.maxError = bound}, Sampling{}, Sampling{.pitch = 4}}) {
      SCOPED_TRACE(nameOf(schedule));
      for (const glm::vec4 pixel : Drawing(scene, camera, size, schedule).pixels(&made, sampling))
        EXPECT_EQ(pixel, glm::vec4(0.0f));
      for (const glm::vec4 pixel : Drawing(clear, camera, size, schedule).pixels(nullptr, sampling))
        EXPECT_EQ(pixel, glm::vec4(0.0f));
    }
}

TEST_F(FocusLayerPassTest, Exhaustive_PartsMakeTheWhole) {
  const Scene scene = waves(true);
  for (const glm::ivec2 size : awkwardSizes) {
    const Camera camera = aside(scene);
    const MadeOpening made(scene, camera, size);
    for (const Schedule schedule : schedules) {
      SCOPED_TRACE(named(schedule, size));
      Drawing drawing(scene, camera, size, schedule);
      const Sampling every{};
      expectPartsMakeTheWhole(drawing.pixels(&made, every), size,
                              [&](const std::vector<gl::Region>& regions, gl::Texture& image) {
                                drawing.run(&made, every, regions, image);
                              });
      EXPECT_EQ(drawing.bytes(), 0u) << "there is no list of pixels where every ray is followed";
      // Between the rays of a lattice, parts are drawn into a picture that has all of the lattice.
      for (const Sampling& some :
           {Sampling{.pitch = 2}, Sampling{.pitch = 2, .quincunx = true}, Sampling{.pitch = 4}}) {
        gl::Texture image = blank<glm::vec4>(size);
        drawing.run(&made, some, whole(size), image);
        const std::vector<glm::vec4> all = texelsOf<glm::vec4>(image);
        for (const gl::Region& region : parts(size)) drawing.run(&made, some, std::span(&region, 1), image);
        EXPECT_TRUE(sameBits(texelsOf<glm::vec4>(image), all)) << "pitch " << some.pitch << (some.quincunx ? "q" : "");
      }
    }
  }
}

TEST_F(FocusLayerPassTest, AMovedStartChangesNoPixelBeyondTheReach) {
  const Scene scene = waves(true);
  constexpr glm::ivec2 size{61, 47};
  const Camera camera = aside(scene);
  const MadeOpening made(scene, camera, size);
  MadeOpening moved = made;
  // A ray of the lattice that starts on a cut face, as the one beside it does: a cut face's light depends on both.
  const auto isCut = [&](glm::ivec2 pixel) {
    const std::size_t i = offsetOf(pixel, size);
    return !isSomething(made.hits[i].y) && isSomething(made.hits[i].x) && made.starts[i] > made.hits[i].x + 2.5f;
  };
  glm::ivec2 at(0);
  for (int j = 16; j < 32; j += 4)
    for (int i = 16; i < 46; i += 4)
      if (isCut({i, j}) && isCut({i + 1, j})) at = {i, j};
  ASSERT_NE(at, glm::ivec2(0));
  moved.starts[offsetOf(at, size)] += 4.0f;
  for (const Schedule schedule : schedules)
    for (const auto& [pitch, quincunx] :
         {std::pair(1, false), std::pair(2, false), std::pair(2, true), std::pair(4, false)}) {
      SCOPED_TRACE(named(schedule, size) + ", pitch " + std::to_string(pitch) + (quincunx ? ", quincunx" : ""));
      // Nearly everything between the lattice's rays is taken for smooth, so that what moved spreads as far as it can.
      const Sampling sampling{.pitch = pitch, .quincunx = quincunx, .tolerance = 0.5};
      Drawing drawing(scene, camera, size, schedule);
      const std::vector<glm::vec4> before = drawing.pixels(&made, sampling), after = drawing.pixels(&moved, sampling);
      int farthest = -1;
      for (std::size_t i = 0; i < before.size(); ++i) {
        const glm::ivec2 off = glm::abs(pixelAt(i, size) - at);
        if (before[i] == after[i]) continue;
        farthest = std::max({farthest, off.x, off.y});
      }
      EXPECT_LE(farthest, FocusLayerPass::reach(sampling));
      EXPECT_GE(farthest, pitch == 1 ? 1 : quincunx ? 2 : 2 * pitch) << "too little to tell";
    }
}

}  // namespace
}  // namespace fenestra::tests::focusLayerPassTest
