// Stage 7 alone, against the paper's equation in double precision: every input at random, each one left out, and the
// widths that decide.

#include "rendering/passes/CompositePass.h"

#include "rendering/passes/DistanceMapPass.h"
#include "tests/gl/PassTest.h"

namespace fenestra::tests::compositePassTest {
namespace {

/// Hermite's step from 0 at `low` to 1 at `high`.
double step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Everything the pass may read, at random.
struct MadePicture {
  Scene scene;
  glm::ivec2 size;
  std::vector<glm::vec4> focusLayer, contextLayer;  ///< the latter's value is real
  std::vector<glm::vec2> hits, edits;
  std::vector<float> distances, silhouette;

  MadePicture(glm::ivec2 pictureSize, Where focus) : size(pictureSize) {
    const Grid grid = gridOf({10, 9, 11}, {1.0, 1.3, 0.9});
    scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3 i) { return 100 * i.x - 50; });
    scene.labels = labelsOf(grid, [](glm::ivec3 i) { return i.x == 5; });
    scene.look.focus = LabelFocus{{1}};
    scene.look.context.function = {{{-50.0, {{0.1, 0.9, 0.3}, 0.4}}, {850.0, {{0.8, 0.2, 0.6}, 0.4}}}};
    scene.look.contextLayer = {.strength = 0.8,
                               .curvatureWeight = 0.9,
                               .silhouetteWeight = 0.7,
                               .illuminationWeight = 0.6,
                               .valueWeight = 0.5};
    std::mt19937 random(31);
    const auto in = [&](double low, double high) {
      return static_cast<float>(std::uniform_real_distribution<double>(low, high)(random));
    };
    for (std::size_t i = 0; i < pixelsIn(size); ++i) {
      const float opacity = in(0.0, 1.0);
      focusLayer.emplace_back(opacity * in(0.0, 1.0), opacity * in(0.0, 1.0), opacity * in(0.0, 1.0), opacity);
      contextLayer.emplace_back(in(-0.3, 0.5), in(-0.5, 0.1), in(0.2, 1.2), in(-200.0, 1000.0));
      silhouette.push_back(in(0.0, 1.0));
      edits.emplace_back(in(-5.0, 5.0), in(0.0, 2.0));
      const bool missed = in(0.0, 1.0) < 0.2f, meetsFocus = in(0.0, 1.0) < 0.4f, bare = in(0.0, 1.0) < 0.2f;
      hits.emplace_back(missed ? nothing : in(-20.0, 0.0), nothing);
      if (!missed && (focus == Where::Everywhere || (focus == Where::Somewhere && meetsFocus)))
        hits[i].y = in(0.0, 20.0);
      if (bare) contextLayer[i].x = contextLayer[i].y = nothing;
      const float distance = in(0.0, 1.0) < 0.2f ? DistanceMapPass::beyond : in(0.4, 14.0);
      distances.push_back(isSomething(hits[i].y) ? 0.0f : distance);
    }
  }

  /// Which of the inputs that may be left out the pass is given.
  struct Given {
    bool contextLayer, edits;
  };

  std::vector<glm::vec4> drawn(Schedule schedule, glm::dvec2 widths, Given given) const {
    GpuScene gpu;
    gpu.setSchedule(schedule);
    gpu.update(scene);
    std::vector<glm::vec4> coded = contextLayer;
    for (glm::vec4& texel : coded)
      texel.w = static_cast<float>(gpu.volume().codedFromReal(static_cast<double>(texel.w)));
    const gl::Texture below = imageOf(focusLayer, size), hitImage = imageOf(hits, size),
                      distanceImage = imageOf(distances, size), layer = imageOf(coded, size),
                      rim = imageOf(silhouette, size), editImage = imageOf(edits, size);
    CompositePass::Inputs inputs{below, hitImage, distanceImage, widths};
    if (given.contextLayer) {
      inputs.contextLayer = &layer;
      inputs.silhouette = &rim;
    }
    if (given.edits) inputs.editMap = &editImage;
    CompositePass pass;
    const auto run = [&](const std::vector<gl::Region>& regions, gl::Texture& image) {
      runWhole(pass, gpu, inputs, scene.look, regions, image);
    };
    gl::Texture image = blank<glm::vec4>(size);
    run(whole(size), image);
    const std::vector<glm::vec4> all = texelsOf<glm::vec4>(image);
    expectPartsMakeTheWhole(all, size, run);
    expectOnlyTheRegionIsWritten(all, size, run);
    return all;
  }

  /// The colour of pixel i: the context layer over the focus, and the border over what is not focus.
  glm::dvec4 truth(std::size_t i, glm::dvec2 widths, Given given) const {
    glm::dvec4 seen(focusLayer[i]);
    const double factor = given.edits ? static_cast<double>(edits[i].y) : 1.0;
    const glm::dvec4 point(contextLayer[i]);
    const ContextLayer& look = scene.look.contextLayer;
    if (given.contextLayer && isSomething(hits[i].y) && isSomething(contextLayer[i].x)) {
      // Axes of 10, 9 and 11 voxels of 1, 1.3 and 0.9 mm are all thinned by two: the finest of the spacings is 1.8 mm.
      const double bend = std::sqrt((point.x * point.x + point.y * point.y) / 2.0) * 1.8;
      const double lines = look.curvatureWeight * step(0.1, 0.4, bend) +
                           look.silhouetteWeight * step(0.3, 0.85, static_cast<double>(silhouette[i]));
      const double opacity = std::min(1.0, look.strength * std::min(lines, 1.0) * factor);
      const glm::dvec3 own = scene.look.context.function.evaluate(point.w).colour;
      const glm::dvec3 colour = ((1.0 - look.valueWeight) * look.colour + look.valueWeight * own) *
                                (1.0 - look.illuminationWeight + look.illuminationWeight * point.z);
      seen = (1.0 - opacity) * seen + opacity * glm::dvec4(colour, 1.0);
    }
    if (isSomething(hits[i].x) && distances[i] > 0.0f) {
      // The pixel is a box of one pixel across the border.
      const double distance = distances[i];
      const double nearer = std::max(distance - 0.5, widths.x), farther = std::min(distance + 0.5, widths.x + widths.y);
      const double border = std::max(farther - nearer, 0.0) * factor;
      seen = (1.0 - border) * seen + border * glm::dvec4(scene.look.cutaway.borderColour, 1.0);
    }
    return seen;
  }
};

void expectMatch(const MadePicture& made, glm::dvec2 widths, MadePicture::Given given) {
  for (const Schedule schedule : schedules) {
    SCOPED_TRACE(named(schedule, made.size) + (given.contextLayer ? ", context layer" : "") +
                 (given.edits ? ", edits" : "") + ", widths " + std::to_string(widths.x) + " and " +
                 std::to_string(widths.y));
    const std::vector<glm::vec4> drawn = made.drawn(schedule, widths, given);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const glm::dvec4 truth = made.truth(i, widths, given);
      // Half an entry of the 16384 of the transfer function's table, of a colour that changes by 0.7 over all of them;
      // and float32 in opacities that rise by 10 per unit of the bend.
      for (int channel = 0; channel < 4; ++channel)
        EXPECT_NEAR(drawn[i][channel], truth[channel], 5e-5) << "pixel " << i;
    }
  }
}

constexpr std::array<MadePicture::Given, 4> everyInput{{{false, false}, {true, false}, {false, true}, {true, true}}};

using CompositePassTest = GlTest;

TEST_F(CompositePassTest, EveryInputInPicturesOfAnySize) {
  for (const glm::ivec2 size : awkwardSizes)
    for (const MadePicture::Given given : everyInput)
      expectMatch(MadePicture(size, Where::Somewhere), {5.0, 3.0}, given);
}

TEST_F(CompositePassTest, FocusNowhereAndEverywhere) {
  for (const Where focus : {Where::Nowhere, Where::Everywhere})
    for (const MadePicture::Given given : everyInput) expectMatch(MadePicture({33, 17}, focus), {5.0, 3.0}, given);
}

TEST_F(CompositePassTest, WidthsOfZeroAndOfLessThanAPixel) {
  const MadePicture made({33, 17}, Where::Somewhere);
  for (const glm::dvec2 widths : {glm::dvec2(0.0, 3.0), glm::dvec2(4.0, 0.0), glm::dvec2(0.0, 0.0),
                                  glm::dvec2(3.2, 0.3), glm::dvec2(0.2, 0.4), glm::dvec2(0.0, 100.0)})
    expectMatch(made, widths, {true, true});
}

TEST_F(CompositePassTest, WithoutABorderAndALayerThePictureIsTheFocusLayer) {
  const MadePicture made({33, 17}, Where::Somewhere);
  for (const Schedule schedule : schedules)
    for (const bool edits : {false, true})
      EXPECT_TRUE(sameBits(made.drawn(schedule, {4.0, 0.0}, {false, edits}), made.focusLayer));
}

TEST_F(CompositePassTest, RaysThatMeetNothingShowTheFocusLayer) {
  MadePicture made({33, 17}, Where::Somewhere);
  for (glm::vec2& hit : made.hits) hit = glm::vec2(nothing);
  for (const Schedule schedule : schedules)
    EXPECT_TRUE(sameBits(made.drawn(schedule, {5.0, 3.0}, {true, true}), made.focusLayer));
}

TEST_F(CompositePassTest, ALayerOfNoStrengthShowsNothing) {
  MadePicture made({33, 17}, Where::Everywhere);
  const glm::dvec2 noBorder(0.0);
  made.scene.look.contextLayer.curvatureWeight = 0.0;
  made.scene.look.contextLayer.silhouetteWeight = 0.0;
  for (const Schedule schedule : schedules)
    EXPECT_TRUE(sameBits(made.drawn(schedule, noBorder, {true, false}), made.focusLayer));
}

TEST_F(CompositePassTest, ASurfaceHasTheColourOfWhatIsOpaqueNextToIt) {
  MadePicture made({33, 17}, Where::Everywhere);
  const glm::dvec3 opaque(0.2, 0.5, 0.9);
  made.scene.look.context.function = {
      {{0.0, {glm::dvec3(1.0), 0.0}}, {400.0, {glm::dvec3(1.0), 0.0}}, {400.0, {opaque, 2.0}}, {800.0, {opaque, 2.0}}}};
  ContextLayer& look = made.scene.look.contextLayer;
  look.strength = look.valueWeight = 1.0;
  look.silhouetteWeight = 5.0;
  look.illuminationWeight = 0.0;
  made.silhouette.assign(pixelsIn(made.size), 1.0f);  // opaque lines everywhere
  // On the step, on either side of it by less than an entry of the table (0.05), and far into what is clear.
  for (std::size_t i = 0; i < made.contextLayer.size(); ++i)
    made.contextLayer[i] = {0.0f, 0.0f, 1.0f, std::array{400.0f, 399.98f, 400.02f, 100.0f}[i % 4]};
  for (const Schedule schedule : schedules) {
    const std::vector<glm::vec4> drawn = made.drawn(schedule, glm::dvec2(0.0), {true, false});
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      if (!isSomething(made.hits[i].y)) continue;
      const glm::dvec3 colour = i % 4 == 3 ? look.colour : opaque;
      for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(drawn[i][channel], colour[channel], 1e-5) << i;
      EXPECT_EQ(drawn[i].a, 1.0f);
    }
  }
}

}  // namespace
}  // namespace fenestra::tests::compositePassTest
