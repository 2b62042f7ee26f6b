#pragma once
// What a picture is made from, beside the scene: a camera, a size and a sampling.

#include <optional>

#include <glm/glm.hpp>

#include "rendering/settings/Camera.h"
#include "rendering/settings/Cutaway.h"
#include "rendering/settings/Quality.h"
#include "rendering/vocabulary/MethodStages.h"
#include "rendering/volume/Volume.h"

namespace fenestra {

/// The picture that an opening is cut for: w_open and w_border count in its pixels.
struct OpeningView {
  Camera camera;
  glm::ivec2 size{0};       ///< pixels, at least 1×1
  double pixelScale = 1.0;  ///< pixels per device-independent pixel
  bool operator==(const OpeningView&) const = default;
};

/// Which slices walls show (rendering/scene/Walls.h), and how, and where a lens over the crosshair lies. Other pictures
/// do not depend on it; see dependsOnSlices() there.
struct ShownSlices {
  std::optional<glm::dvec3> crosshair = std::nullopt;  ///< world, mm; unset: for walls, the volume's centre
  std::optional<WindowLevel> window = std::nullopt;    ///< unset: Volume::defaultWindow
  bool inverted = false;                               ///< low values bright, where the volume has them dark
  bool operator==(const ShownSlices&) const = default;
};

/// One picture to make.
struct View {
  Camera camera;
  glm::ivec2 size{0};       ///< rendered pixels, at least 1×1
  double pixelScale = 1.0;  ///< rendered pixels per device-independent pixel; widths in pixels scale with it
  Quality quality = Quality::Normal;
  /// Greatest error of a pixel's colour in 1/255 that sampling may leave; used instead of `quality`. It is kept by
  /// estimates: on the ten scenes of tests/bench/results by 99.99 % of the pixels.
  std::optional<double> maxError = std::nullopt;
  /// A frozen opening: it stays cut for that picture while the camera moves. Empty: the opening follows the camera.
  std::optional<OpeningView> frozen = std::nullopt;
  ShownSlices slices{};
  /// False: without ambient occlusion and shadow, whatever the look says. They are computed for all of the volume and
  /// anew for each camera, so that a smaller picture does not cost less: pictures in motion leave them out.
  bool occlusion = true;
  bool operator==(const View&) const = default;
};

/// The point that a lens lies over, world mm.
glm::dvec3 placeOf(const MethodStages::Lens& lens, const ShownSlices& slices, glm::dvec3 focusCentre);

/// The greatest error of a pixel's colour, in 1/255, that the view asks for; empty where it asks for none.
std::optional<double> errorBound(const View& view);

/// The picture that a view's opening is cut for, where that is not the view's own: the frozen one or else the view's,
/// turned about the focus's centre (world, mm) by the cutaway's axis offset. Empty: the view's own.
std::optional<OpeningView> openingOf(const View& view, const Cutaway& cutaway, glm::dvec3 focusCentre);

}  // namespace fenestra
