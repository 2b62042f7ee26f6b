#pragma once
// From a scene and a camera to a picture. Runs only what depends on something that has changed. rendering/README.md
// says how.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "rendering/Layers.h"
#include "rendering/PickedPlace.h"
#include "rendering/scene/Scene.h"
#include "rendering/scene/View.h"
#include "rendering/settings/BrushStroke.h"
#include "rendering/stages/Pass.h"

namespace fenestra {

class GpuScene;

/// Needs a current OpenGL 4.5 context in every call, always the same one or one that shares with it. Move-only.
class Renderer {
 public:
  /// `gpuScene` may be shared by several renderers whose contexts share objects: voxels are uploaded once.
  explicit Renderer(std::shared_ptr<GpuScene> gpuScene);
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Makes the picture. Nothing runs for an unchanged scene and view; where only strokes changed, what depends on them
  /// runs for the pixels under them, with the result of a run for all.
  void render(const Scene& scene, const View& view);
  /// Makes it a little at a time, with the same bits: starts the picture, and goes on with it for about so many
  /// milliseconds, at least one tile; true when it is done. A picture begun before another is done drops it. Until a
  /// picture is done the last one is shown and read, as far as it is not overwritten. Where a driver compiles a program
  /// or voxels are uploaded, a step takes longer.
  void begin(const Scene& scene, const View& view);
  bool advance(double milliseconds);
  /// A picture was begun and is not done.
  bool isDrawing() const;
  /// Forgets it.
  void drop();

  glm::ivec2 pictureSize() const;  ///< rendered pixels of the last picture; 0 where there is none

  /// Draws the last picture into `framebuffer` (an OpenGL name; QOpenGLWidget's is not 0), stretched over the rectangle
  /// x, y (from the bottom left), width, height; smoothly where that enlarges it. Restores the state it changes.
  void present(std::uint32_t framebuffer, glm::ivec4 rectangle);

  /// Reads back what present() draws: as many pixels as a rectangle of that size has, each blue, green, red, alpha in 8
  /// bits, row by row from the top. Empty where there is no picture.
  std::vector<std::uint8_t> readPresented(glm::ivec2 size);

  /// The last picture, 8-bit RGBA, premultiplied, row by row from the top.
  std::vector<std::uint8_t> readPicture();
  /// Every stage of the last picture. Stages that the scene does not use come back empty.
  Layers readLayers();

  /// The camera that cuts the opening (View::frozen), and in a picture of its own size where its rays meet context and
  /// focus and where they start: tContext, tFocus and tStart.
  struct Opening {
    Camera camera;
    Layers starts;
  };
  Opening readOpening();

  /// World position of what pixel (i, j from the top, in rendered pixels) of the last picture shows: where its ray
  /// starts to see. Empty where it shows the background.
  /// In an exploded view, the position is that in the volume; empty also in the hollow that the focus leaves.
  /// Where a layer is peeled off, it is that in the volume, too.
  std::optional<glm::dvec3> pick(glm::dvec2 pixel);
  /// That place, and how the ray goes on in the volume from there.
  std::optional<PickedPlace> pickPlace(glm::dvec2 pixel);
  bool movesContext() const;  ///< the last picture is an exploded view, or a layer is peeled off
  /// Where the last picture shows a world position: in an exploded view where its part is, but for what is in focus or
  /// within a voxel of it; on the roll, where it is peeled off and not in focus.
  glm::dvec3 shownAt(glm::dvec3 world) const;

  /// Where a brush at pixel (i, j), in rendered pixels as for pick(), touches. Open cuts into what is seen: its anchor
  /// is where the ray starts to see, or did before strokes opened it further, so that a stroke being painted does not
  /// dig itself in. The other modes are about the context that lies, or lay, before it: theirs is the context's first
  /// surface, even where the cutaway removed it; a point of that surface is the same from every side, which one of the
  /// cut face is not. Where the ray meets nothing, the point of the ray as deep in the view as `before`, a stroke's
  /// last anchor, so that a stroke can leave the body and come back; empty without one. An exploded view and a peeled
  /// volume have no place for a brush: empty.
  std::optional<BrushPoint> pickBrush(glm::dvec2 pixel, BrushMode mode, std::optional<glm::dvec3> before = {});

  /// Measures each pass with timer queries; waits for the GPU, so off by default.
  void setTiming(bool on);
  const std::array<PassStats, passCount>& stats() const;
  /// Bytes of this renderer's own images (the volume's are GpuScene's).
  std::size_t imageBytes() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace fenestra
