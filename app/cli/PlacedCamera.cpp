#include "app/cli/PlacedCamera.h"

#include <optional>

#include "app/cli/Report.h"
#include "rendering/placement/Placer.h"

namespace fenestra::cli {

Camera placedCamera(const std::filesystem::path& source, io::Study& study, GpuScene& gpuScene, io::PlacedView which) {
  const Scene& scene = study.drawn.scene();
  placement::Placer placer;
  const placement::Measured& measured = placer.measure(gpuScene, scene, {}, {});
  const placement::Placement placement = placement::choose(measured, {}, placement::jointByDefault);
  const std::optional<std::size_t> chosen = which == io::PlacedView::Best ? placement.c1 : placement.c2;
  if (!chosen) throw io::Error(source, placement.note, placementHint);
  return Camera::fromDirection(measured.candidates[*chosen].direction, visibleOf(study), study.view->camera.projection);
}

}  // namespace fenestra::cli
