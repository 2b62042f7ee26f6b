#include "rendering/reference/Importance.h"

#include <algorithm>
#include <cmath>

#include "rendering/reference/Unknown.h"
#include "rendering/scene/Importance.h"

namespace fenestra::reference {
std::vector<Image> importantHits(const Scene& scene, const Camera& camera, glm::ivec2 size, const HitPoints& hits,
                                 const std::vector<glm::dvec2>& places) {
  std::vector<Image> found;
  for (const std::vector<std::uint16_t>& labels : importanceLevels(scene)) {
    Image& level = found.emplace_back(places.size(), unknown);
    if (labels.empty()) continue;
    Scene alone = scene;
    alone.look.focus = LabelFocus{labels};
    level = hitPoints(alone, camera, size, places).tFocus;
    for (std::size_t i = 0; i < level.size(); ++i)
      level[i] = std::isnan(hits.tContext[i]) || std::isnan(level[i]) ? unknown : std::max(level[i], hits.tContext[i]);
  }
  return found;
}

ImportantStarts importantStarts(const HitPoints& hits, const std::vector<Image>& levels, const Camera& camera,
                                glm::ivec2 size, const MethodStages& method) {
  ImportantStarts result{hits.tContext, Image(hits.tContext.size(), unknown)};
  std::vector<Image> cuts;
  for (const Image& level : levels)
    cuts.push_back(coneStart({hits.tContext, level, hits.tOut}, camera, size, method.slope, method.onSilhouette));
  for (std::size_t i = 0; i < result.tStart.size(); ++i) {
    for (const Image& cut : cuts) result.tStart[i] = std::fmax(result.tStart[i], cut[i]);
    for (const Image& level : levels)
      if (level[i] == result.tStart[i]) result.tOpened[i] = level[i];
  }
  return result;
}

Image highestHits(const std::vector<Image>& levels) {
  Image highest = levels.front();
  for (const Image& level : levels)
    for (std::size_t i = 0; i < level.size(); ++i)
      if (!std::isnan(level[i])) highest[i] = level[i];
  return highest;
}

}  // namespace fenestra::reference
