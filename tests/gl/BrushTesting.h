#pragma once
// A ball to paint on, and strokes through pixels of its picture.

#include "tests/gl/GlTest.h"

namespace fenestra::tests {

constexpr glm::ivec2 size{120, 100};

/// A ball of label 1 (radius 6 mm) off the middle of a larger ball of values falling outwards, in air.
inline Scene ballScene() {
  const Grid grid = gridOf({40, 40, 40});
  const auto from = [](glm::ivec3 i, glm::dvec3 centre) { return glm::length(glm::dvec3(i) - centre); };
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [&](glm::ivec3 i) { return 1000.0 - 60.0 * from(i, glm::dvec3(19.5)); });
  scene.labels = labelsOf(grid, [&](glm::ivec3 i) { return from(i, {19.5, 17.0, 21.0}) < 6.0 ? 1 : 0; });
  scene.look.focus = LabelFocus{{1}};
  scene.look.context.function = opaqueFrom(100.0);
  scene.look.cutaway.openWidth = 12.0;
  scene.look.cutaway.borderWidth = 3.0;
  return scene;
}

inline Camera frontOf(const Scene& scene, Projection projection = Projection::Perspective) {
  return Camera::fromAngles(20.0, 15.0, scene.volume->grid, projection);
}

inline View viewOf(const Scene& scene, Projection projection = Projection::Perspective) {
  return {.camera = frontOf(scene, projection), .size = size};
}

/// A stroke through pixels of the renderer's picture.
inline BrushStroke painted(Renderer& renderer, BrushMode mode, const std::vector<glm::dvec2>& pixels,
                           double radius = 4.0) {
  BrushStroke stroke;
  stroke.mode = mode;
  stroke.radius = radius;
  for (const glm::dvec2 pixel : pixels)
    if (const auto point = renderer.pickBrush(pixel, mode)) extend(stroke, point->anchor);
  EXPECT_EQ(stroke.anchors.size(), pixels.size());
  return stroke;
}

/// Paints with a renderer of its own, on the picture of a scene without strokes.
inline BrushStroke painted(const Scene& scene, const View& view, BrushMode mode, const std::vector<glm::dvec2>& pixels,
                           double radius = 4.0) {
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, view);
  return painted(renderer, mode, pixels, radius);
}

inline Layers layersOf(const Scene& scene, const View& view) {
  Renderer renderer(std::make_shared<GpuScene>());
  renderer.render(scene, view);
  return renderer.readLayers();
}

}  // namespace fenestra::tests
