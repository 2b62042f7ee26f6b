// Slices that stand as walls (MethodStages::Walls), on their two places in the chain.

#include "rendering/PassChain.h"

namespace fenestra {

void PassChain::dropWalls() {
  for (gl::Texture* texture : {&wallLayer, &walledLayer, &walledPicture}) *texture = {};
  wallPass.release();
  walls.forget();
}

void PassChain::standWallsInside() {
  const auto wanted = wallsOf(frame->scene.look);
  if (!wanted || (wanted->placement == WallPlacement::Inside && !frame->hasCutaway)) return dropWalls();
  if (wanted->placement != WallPlacement::Inside) {
    walledLayer = {};
    return;
  }
  walledPicture = {};
  WallKey key{.focusLayer = focus.version(), .start = start.version(), .removed = opening ? removed.version() : 0};
  key.walls = *wanted;
  standWalls(std::move(key), WallPass::Opening{hitsToOpen(), rayStart}, focusLayer, walledLayer);
}

void PassChain::standWallsAround() {
  const auto wanted = wallsOf(frame->scene.look);
  if (!wanted || wanted->placement != WallPlacement::Around) return;
  WallKey key{.focusLayer = focus.version()};
  key.walls = *wanted;
  if (composed) key.composite = composite.version();
  if (exempted) key.exempt = exempt.version();
  standWalls(std::move(key), {}, unwalled(), walledPicture);
}

void PassChain::standWalls(WallKey key, const std::optional<WallPass::Opening>& cut, const gl::Texture& below,
                           gl::Texture& picture) {
  const Scene& scene = frame->scene;
  const View& view = frame->view;
  key.slices = view.slices;
  key.volume = scene.volume;
  if (key.walls.outlines) {
    key.labels = scene.labels;
    key.structures = structuresOf(scene);
    key.settings = scene.look.labels;
  }
  key.camera = view.camera;
  key.size = view.size;
  addIfStale(Pass::Walls, walls, std::move(key), frame->changed, [&](Regions regions) {
    wallPass.run(
        steps, *gpu, scene, view.slices, *rays, cut, below, regions,
        {sized(wallLayer, gl::Format::RGBA32F, view.size), sized(picture, gl::Format::RGBA32F, view.size, presented)});
  });
}

}  // namespace fenestra
