#include "rendering/stages/WallStage.h"

#include "rendering/scene/Walls.h"
#include "rendering/stages/Images.h"

namespace fenestra {

WallStage::WallStage(StageList& list, WallPlacement placement) : KeyedStage(list, Pass::Walls), placement_(placement) {
  owns(layer_, picture_, pass_);
}

bool WallStage::isUsed(const Frame& frame) const {
  const auto wanted = wallsOf(frame.look());
  return wanted && wanted->placement == placement_ && (placement_ == WallPlacement::Around || frame.hasCutaway);
}

void WallStage::stand(const Frame& frame, Steps& steps, const Output& below, const std::optional<Inside>& inside) {
  const Scene& scene = frame.scene;
  const View& view = frame.view();
  WallKey key{.below = below.version,
              .starts = inside ? inside->starts.version : Version{},
              .walls = *wallsOf(scene.look),
              .slices = view.slices,
              .volume = scene.volume,
              .labels = nullptr,
              .structures = nullptr,
              .settings = {},
              .camera = view.camera,
              .size = view.size};
  if (key.walls.outlines) {
    key.labels = scene.labels;
    key.structures = structuresOf(scene);
    key.settings = scene.look.labels;
  }
  update(frame.own, steps, std::move(key), {.changed = changedStrokes(frame.own)}, [&](Regions regions) {
    std::optional<WallPass::OpenedSpace> opening;
    if (inside)
      opening.emplace(WallPass::OpenedSpace{.hitPoints = inside->hits.image, .rayStart = inside->starts.image});
    pass_.run(steps, gpu(), scene, view.slices, frame.own.rays, opening, below.image, regions,
              {.layer = sized(layer_, gl::Format::RGBA32F, view.size),
               .picture = sized(picture_, gl::Format::RGBA32F, view.size, presented)});
  });
}

}  // namespace fenestra
