// Regions of one value. Where a transfer function has a step at that value, or the focus ends there, rounding decides
// over a whole region, not over a surface: each quality has to put it where the definition does.

#include <array>

#include "rendering/reference/Picture.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests::plateauTest {
namespace {

constexpr glm::ivec2 size{33, 25};
constexpr std::array qualities{Quality::Draft, Quality::Normal, Quality::High};

using Plateaus = GlTest;

/// A volume of one value, unlit, without a focus.
template <class T>
Scene evenScene(double value) {
  Scene scene;
  scene.volume = volumeOf<T>(gridOf({9, 8, 7}, {1.0, 1.2, 1.1}), [value](glm::ivec3) { return value; });
  scene.look.reconstruction = Reconstruction::Linear;
  scene.look.shading.enabled = false;
  return scene;
}

/// Greatest error against Beer's law in a medium that fills the box, in 1/255.
double errorAgainst(const OpticalProperties& medium, const Scene& scene, Quality quality) {
  const Camera camera = Camera::fromAngles(33.0, 21.0, scene.volume->grid, Projection::Perspective);
  const std::vector<glm::vec4> drawn = renderOnce(scene, camera, size, quality).layers.focusLayer;
  double worst = 0.0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const glm::ivec2 pixel(static_cast<int>(i) % size.x, static_cast<int>(i) / size.x);
    const auto span = reference::clip(reference::pixelRay(camera, size, pixel), scene.volume->grid);
    const double opacity = span ? -std::expm1(-medium.extinction * (span->tOut - span->tIn)) : 0.0;
    const glm::dvec4 error = glm::abs(glm::dvec4(drawn[i]) - opacity * glm::dvec4(medium.colour, 1.0));
    worst = std::max({worst, error.r, error.g, error.b, error.a});
  }
  return 255.0 * worst;
}

/// Holds each quality to the error that it has where the function has no step and there is no focus.
void expectMedium(const OpticalProperties& medium, const Scene& scene, const std::string& what) {
  Scene even = scene;
  even.look.focus = {};
  even.look.context.function = {{{-1e6, medium}, {1e6, medium}}};
  for (const Quality quality : qualities)
    EXPECT_LE(errorAgainst(medium, scene, quality), errorAgainst(medium, even, quality) + 0.05)
        << what << ", quality " << static_cast<int>(quality);
}

/// Steps at a value, up from nothing, up, and down to nothing, with what is above each.
std::vector<std::pair<TransferFunction, OpticalProperties>> stepsAt(double value) {
  const OpticalProperties clear{{1.0, 0.1, 0.2}, 0.0}, thin{{0.3, 0.9, 0.2}, 0.02}, dense{{0.8, 0.3, 0.9}, 0.06};
  return {{{{{value, clear}, {value, dense}, {value + 70.0, dense}}}, dense},
          {{{{value - 30.0, thin}, {value, thin}, {value, dense}, {value + 70.0, dense}}}, dense},
          {{{{value - 30.0, dense}, {value, dense}, {value, clear}}}, clear}};
}

/// Volumes that are coded in different ways, each of one value.
std::vector<std::pair<Scene, double>> evenScenes() {
  const auto third = static_cast<double>(0.3f);
  return {{evenScene<std::uint8_t>(100.0), 100.0},
          {evenScene<std::int16_t>(-1000.0), -1000.0},
          {evenScene<std::uint16_t>(41234.0), 41234.0},
          {evenScene<float>(third), third}};
}

TEST_F(Plateaus, Thorough_AtAStepShowWhatIsAboveIt) {
  for (auto& [scene, value] : evenScenes())
    for (const auto& [function, above] : stepsAt(value))
      for (const bool lit : {false, true}) {
        scene.look.context.function = function;
        scene.look.shading.enabled = lit;  // where nothing has a gradient, light changes nothing
        expectMedium(above, scene,
                     std::to_string(value) + (lit ? ", lit, " : ", ") + std::to_string(function.nodes.size()));
      }
}

/// Errors of opacity against the reference, in 1/255.
struct Errors {
  double rms = 0.0, worst = 0.0;
};

Errors opacityErrors(const Scene& scene, Quality quality) {
  const Camera camera = Camera::fromAngles(33.0, 21.0, scene.volume->grid, Projection::Perspective);
  const std::vector<glm::dvec4> truth = reference::picture(scene, camera, size, {}, {}).focusLayer;
  const std::vector<glm::vec4> drawn = renderOnce(scene, camera, size, quality).layers.focusLayer;
  Errors errors;
  double most = 0.0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const double error = 255.0 * std::abs(drawn[i].a - truth[i].a);
    most = std::max(most, truth[i].a);
    errors.worst = std::max(errors.worst, error);
    errors.rms += error * error / static_cast<double>(drawn.size());
  }
  EXPECT_GT(most, 0.1) << "too little to tell";
  errors.rms = std::sqrt(errors.rms);
  return errors;
}

/// A layer of voxels that is lower than all others by 7 of the tables' 16 384 entries, where all that is lower shows.
TEST_F(Plateaus, WhatIsALittleLowerThanAStepDownShows) {
  Scene scene = evenScene<float>(100.0);
  scene.volume = volumeOf<float>(scene.volume->grid, [](glm::ivec3 i) { return i.z == 3 ? 99.957 : 100.0; });
  const glm::dvec3 white(1.0);
  scene.look.context.function = {{{0.0, {white, 0.3}}, {100.0, {white, 0.3}}, {100.0, {white, 0.0}}}};
  EXPECT_LE(opacityErrors(scene, Quality::High).worst, highQualityError);
}

/// Layers of two voxels that show from a value on: thinner than bricks, and even for one voxel of their width.
Errors errorsInLayers(double from) {
  Scene scene = evenScene<std::uint8_t>(0.0);
  scene.volume = volumeOf<std::uint8_t>(scene.volume->grid, [](glm::ivec3 i) { return i.x % 4 < 2 ? 255 : 0; });
  scene.look.shading.enabled = true;
  const glm::dvec3 white(1.0);
  scene.look.context.function = {{{100.0, {white, 0.0}}, {from, {white, 0.0}}, {from, {white, 0.3}}}};
  return opacityErrors(scene, Quality::Normal);
}

TEST_F(Plateaus, OfTheGreatestValueMayBeThin) {
  const double between = errorsInLayers(250.0).rms;
  // A step is held up to ten entries of 16 384 lower.
  EXPECT_LE(errorsInLayers(255.0).rms, between + 0.01)
      << "the error of normal quality where a step lies between the values";
}

TEST_F(Plateaus, Thorough_WhereTheFocusEndsAreInFocus) {
  const OpticalProperties material{{0.8, 0.3, 0.9}, 0.06};
  for (auto& [scene, value] : evenScenes())
    for (const ValueRange& range :
         {ValueRange{value, value}, ValueRange{value, value + 5.0}, ValueRange{value - 5.0, value}}) {
      scene.look.focus = ValueFocus{range, 0.0};
      scene.look.focusAppearance.colour = material.colour;
      scene.look.focusAppearance.extinction = material.extinction;
      expectMedium(material, scene, std::to_string(value));
    }
}

}  // namespace
}  // namespace fenestra::tests::plateauTest
