#pragma once
// What walls show (rendering/scene/Walls.h), for shaders/Walls.comp: greys and lines of up to three slices.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "rendering/gl/Buffer.h"
#include "rendering/gl/Texture.h"
#include "rendering/scene/Scene.h"
#include "rendering/scene/Walls.h"

namespace fenestra {

/// Needs a current context.
class WallImages {
 public:
  /// The slices lie below each other in one image: a wall's first row there, in their order.
  static std::vector<int> firstRows(const std::vector<Wall>& walls);
  /// Brings images and lines up to date; uploads only what has changed.
  void update(const Scene& scene, const std::vector<Wall>& walls, const MethodStages::Walls& which,
              const ShownSlices& slices);

  /// R32F: grey before it is clamped to 0..1, though to ±greatestGrey, of each voxel of the slices.
  const gl::Texture& greys() const { return greys_; }
  /// As storage blocks of shaders/Walls.comp.
  void bindLines() const;
  std::size_t bytes() const;

  static constexpr float greatestGrey = 1e9f;

 private:
  /// What greys and lines are made from.
  struct Slice {
    int axis = 0, slice = 0;
    bool operator==(const Slice&) const = default;
  };
  struct GreyKey {
    std::shared_ptr<const Volume> volume;
    std::vector<Slice> slices;
    std::optional<WindowLevel> window;
    bool inverted = false;
    bool operator==(const GreyKey&) const = default;
  };
  struct LineKey {
    std::shared_ptr<const LabelMap> labels, structures;
    LabelSettings settings;
    Grid grid;
    std::vector<Slice> slices;
    std::vector<glm::dvec2> crossings;  ///< around the volume: where the other slices cut each one
    bool outlines = false;
    bool operator==(const LineKey&) const = default;
  };
  static std::vector<Slice> slicesOf(const std::vector<Wall>& walls);
  void uploadGreys(const std::shared_ptr<const Volume>& shown, const std::vector<Wall>& walls,
                   const ShownSlices& slices);
  void uploadLines(const Scene& scene, const std::vector<Wall>& walls, const MethodStages::Walls& which,
                   const ShownSlices& slices);

  gl::Texture greys_;
  gl::Buffer cells_, pieces_;
  std::optional<GreyKey> greyKey_;
  std::optional<LineKey> lineKey_;
};

}  // namespace fenestra
