// slice: a slice in any direction, or a slab, as a picture or as real values.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include <nlohmann/json.hpp>

#include "app/ScheduleChoice.h"
#include "app/cli/Commands.h"
#include "app/cli/PlacedCamera.h"
#include "app/cli/ReadBesideContext.h"
#include "app/cli/Report.h"
#include "app/cli/SliceFile.h"
#include "io/base/Words.h"
#include "io/study/ReadStudy.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gpu/FocusIndexing.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/volume/ObliqueSlice.h"

namespace fenestra::cli {
namespace {

using Json = nlohmann::ordered_json;

const char* nameOf(SlicePlane plane) {
  switch (plane) {
    case SlicePlane::Axial:
      return "axial";
    case SlicePlane::Sagittal:
      return "sagittal";
    case SlicePlane::Coronal:
      break;
  }
  return "coronal";
}

std::string text(glm::dvec3 v) {
  std::ostringstream stream;
  stream << v.x << ',' << v.y << ',' << v.z;
  return stream.str();
}

/// The slice to draw, and which one of how many it is.
struct ChosenSlice {
  SliceGeometry geometry;
  int index = 0;
  bool isNumbered = false;  ///< a slice of the volume's own
};

void requireInside(const SliceOptions& options, const Grid& grid, glm::dvec3 point) {
  const glm::dvec3 index(grid.indexFromWorld() * glm::dvec4(point, 1.0));
  if (glm::all(glm::greaterThanEqual(index, glm::dvec3(-0.5))) &&
      glm::all(glm::lessThanEqual(index, glm::dvec3(grid.dims) - 0.5)))
    return;
  glm::dvec3 low = grid.centre(), high = low;
  for (const glm::dvec3& corner : grid.corners()) {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  throw io::Error(options.study.source(), "has no point " + text(point),
                  "name one within the volume by --through; it reaches from " + text(low) + " to " + text(high));
}

ChosenSlice numberedSlice(const SliceOptions& options, const Grid& grid) {
  ChosenSlice chosen{sliceGeometry(grid, options.plane), 0, true};
  const int count = chosen.geometry.count;
  chosen.index = count / 2;
  if (options.at) chosen.index = chosen.geometry.sliceAt(*options.at);
  if (options.index) chosen.index = *options.index;
  if (chosen.index < 0 || chosen.index >= count)
    throw io::Error(options.study.source(),
                    "there is no " + std::string(nameOf(options.plane)) + " slice " + std::to_string(chosen.index),
                    "slices run from 0 to " + std::to_string(count - 1));
  return chosen;
}

/// In square pixels of a size that may be asked for.
ChosenSlice squareSlice(const SliceOptions& options, const Grid& grid, SlicePlane plane, const PlaneAxes& axes,
                        glm::dvec3 through) {
  requireInside(options, grid, through);
  const SliceGeometry all = obliqueGeometry(grid, plane, axes, through);
  const double pixel = options.spacing.value_or(glm::length(all.right));
  if (options.study.size) return {sliceAround(plane, axes, through, *options.study.size, pixel), 0, false};
  constexpr double largest = 16384.0;
  const double factor = glm::length(all.right) / pixel;
  if (!(factor * std::max(all.width, all.height) <= largest))
    throw io::Error(options.study.source(), "a slice of the whole volume would have more than 16384 pixels a side",
                    "name larger pixels by --spacing, or a part by --size");
  const SliceGeometry geometry = obliqueGeometry(grid, plane, axes, through, pixel);
  return {geometry, static_cast<int>(std::lround(geometry.pixelFromWorld(through).z)), false};
}

/// With the camera's right and up.
PlaneAxes facingAxes(const Camera& camera) {
  const Camera::Axes axes = camera.axes();
  return {axes.right, -axes.up, axes.forward};
}

/// Where the focus is; without one, a session's crosshair.
glm::dvec3 middleOfFocus(const SliceOptions& options, const io::Study& study) {
  if (const std::optional<glm::dvec3> centre = focusCentre(study.drawn.scene())) return *centre;
  if (options.study.session && options.study.session->crosshair) return *options.study.session->crosshair;
  throw io::Error(options.study.source(), "has no focus whose middle the slice could go through",
                  std::string("name a point by --through, or ") + placementHint);
}

struct Facing {
  io::Study study;
  Camera camera;
};

/// The study, and the camera of its session, or the one placed for its focus.
Facing facingCamera(const SliceOptions& options) {
  if (options.study.session) {
    io::Study study = io::readStudy(options.study, progressOnTerminal());
    const std::size_t which = *options.facing == io::PlacedView::Best ? 0 : 1;
    return {std::move(study), options.study.session->views[which].camera};
  }
  std::optional<egl::EglContext> context;
  io::Study study = readBesideContext(options.study, context);
  const auto gpu = std::make_shared<GpuScene>();
  const Scene& scene = study.drawn.scene();
  if (const auto known = app::knownSchedule({}, *scene.volume)) gpu->setSchedule(*known);
  gpu->update(scene, GpuScene::Use::FirstHits);
  const Camera camera = placedCamera(options.study.source(), study, *gpu, *options.facing);
  return {std::move(study), camera};
}

Json describe(const SliceOptions& options, const ChosenSlice& chosen, const Grid& grid) {
  const SliceGeometry& g = chosen.geometry;
  Json json{{"plane", chosen.isNumbered || (!options.normal && !options.facing) ? nameOf(g.plane) : "oblique"}};
  if (options.facing) json["facing"] = *options.facing == io::PlacedView::Best ? "C1" : "C2";
  if (chosen.isNumbered) {
    json["slice"] = chosen.index;
    json["slices"] = g.count;
  }
  const auto voxels = static_cast<std::size_t>(g.width) * static_cast<std::size_t>(g.height) *
                      static_cast<std::size_t>(std::max(g.count, 1));
  // Those of a sheared volume lie between its voxels.
  const bool isVoxels = chosen.isNumbered && options.slab.thickness == 0.0 && voxels == grid.voxelCount();
  const glm::dvec3 across = glm::normalize(glm::cross(g.right, g.down));
  json["size"] = {g.width, g.height};
  json["pixel_spacing"] = {glm::length(g.right), glm::length(g.down)};
  json["centre"] = listOf(g.worldFromPixel(0.5 * (g.width - 1), 0.5 * (g.height - 1), chosen.index));
  json["right"] = listOf(glm::normalize(g.right));
  json["down"] = listOf(glm::normalize(g.down));
  json["normal"] = listOf(glm::dot(across, g.normal) < 0.0 ? -across : across);
  json["edges"] = {{"left", orientationLetters(-g.right)},
                   {"right", orientationLetters(g.right)},
                   {"top", orientationLetters(-g.down)},
                   {"bottom", orientationLetters(g.down)}};
  json["slab"] = nullptr;
  if (options.slab.thickness > 0.0)
    json["slab"] = {{"mm", options.slab.thickness}, {"mode", wordOf(options.slab.mode).word}};
  json["interpolation"] = isVoxels ? "none" : "trilinear";
  return json;
}

}  // namespace

void slice(const SliceOptions& options) {
  io::Study study;
  std::optional<Camera> camera;
  if (options.facing) {
    Facing facing = facingCamera(options);
    study = std::move(facing.study);
    camera = facing.camera;
  } else {
    study = io::openData(options.study, progressOnTerminal());
  }
  printWarnings(study.warnings);
  const Volume& volume = *study.scene.volume;
  const Grid& grid = volume.grid;

  ChosenSlice chosen;
  if (camera) {
    const PlaneAxes axes = facingAxes(*camera);
    const glm::dvec3 through = options.through ? *options.through : middleOfFocus(options, study);
    chosen = squareSlice(options, grid, nearestPlane(grid, axes.normal), axes, through);
  } else if (options.normal) {
    chosen = squareSlice(options, grid, nearestPlane(grid, *options.normal), planeAxes(grid, *options.normal),
                         options.through.value_or(grid.centre()));
  } else if (options.through || options.spacing || options.study.size) {
    const ChosenSlice own = numberedSlice(options, grid);
    const SliceGeometry& g = own.geometry;
    const glm::dvec3 middle = g.worldFromPixel(0.5 * (g.width - 1), 0.5 * (g.height - 1), own.index);
    chosen =
        squareSlice(options, grid, options.plane, planeAxes(grid, options.plane), options.through.value_or(middle));
  } else {
    chosen = numberedSlice(options, grid);
  }

  const SliceGeometry& geometry = chosen.geometry;
  const std::vector<float> values = slabValues(volume, geometry, chosen.index, options.slab);
  Json json = describe(options, chosen, grid);
  if (isValueFile(options.output)) {
    writeValues(options.output, geometry, chosen.index, values);
  } else {
    WindowLevel window = volume.defaultWindow();
    window.width = options.width.value_or(window.width);
    window.level = options.level.value_or(window.level);
    writeGrey(options.output, {geometry.width, geometry.height}, values, window, volume.lowIsWhite);
    json["window"] = {{"width", window.width}, {"level", window.level}};
  }
  printJson(json);
}

}  // namespace fenestra::cli
