#pragma once
// Times and errors of the renderer's pictures.

#include <optional>
#include <string>
#include <vector>

#include "app/benchmark/ColourError.h"
#include "app/benchmark/Views.h"
#include "rendering/Renderer.h"

namespace fenestra::bench {

/// How the renderer chooses its steps.
struct Setting {
  std::string name;
  Quality quality = Quality::Normal;
  std::optional<double> maxError = std::nullopt;  ///< 1/255
};
/// Draft and normal; high is an error bound.
std::vector<Setting> unboundedSettings();
std::vector<Setting> boundSettings(const std::vector<double>& bounds);

/// A subject loaded, its views and what they should show.
struct Measurable {
  std::string name;
  Scene scene;
  glm::ivec2 size{0};  ///< of the pictures, pixels
  std::vector<Camera> cameras;
  std::vector<glm::ivec2> pixels;               ///< that are compared
  std::vector<std::vector<glm::dvec4>> truths;  ///< of the first cameras, premultiplied RGBA of `pixels`
};

struct Measured {
  Distribution milliseconds;  ///< one a frame, from the call until the picture is in the graphics memory
  ColourErrors errors;        ///< over all cameras
};
/// Draws along the path with each setting in turn, `rounds` times, so that a machine that is slower for a while is so
/// for all of them; each time after a view from elsewhere. Needs a current context.
std::vector<Measured> measure(Renderer& renderer, const Measurable& what, const std::vector<Setting>& settings,
                              int rounds);

/// The compared pixels of a layer of the picture's size against their truth.
ColourErrors errorsOf(const std::vector<glm::vec4>& here, const std::vector<glm::dvec4>& truth, const Measurable& what);

}  // namespace fenestra::bench
