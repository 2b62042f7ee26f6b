#include "rendering/reference/Picture.h"

#include "rendering/reference/ContextLayer.h"
#include "rendering/reference/FocusLayer.h"
#include "rendering/reference/Light.h"
#include "rendering/reference/Occlusion.h"
#include "rendering/reference/Strokes.h"
#include "rendering/scene/Lighting.h"
#include "rendering/scene/Parallel.h"

namespace fenestra::reference {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::vector<glm::ivec2> pixelsOf(glm::ivec2 size, const PictureOptions& options) {
  if (!options.pixels.empty()) return options.pixels;
  std::vector<glm::ivec2> all;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i) all.emplace_back(i, j);
  return all;
}

std::size_t offset(glm::ivec2 size, glm::ivec2 pixel) {
  return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(pixel.x);
}

/// A picture's rays as the cutaway cuts them.
class Opening {
 public:
  Opening(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages& stages)
      : camera_(camera), size_(size), stages_(stages) {
    const glm::dvec3 spacing = scene.volume->grid.spacing;
    wallDepth_ = lighting::wallDepthVoxels * std::min({spacing.x, spacing.y, spacing.z});
  }

  /// Where `pixel`'s ray starts to see; NaN where it meets nothing.
  double start(glm::ivec2 pixel) const { return stages_.tStart[offset(size_, pixel)]; }

  /// Unit normal of the face that the cutaway cuts, from the neighbours' ray starts; zero where the ray starts on the
  /// focus, or on the context's own surface.
  glm::dvec3 wallNormal(glm::ivec2 pixel) const {
    const std::size_t at = offset(size_, pixel);
    const double tFocus = stages_.hits.tFocus[at];
    // Another camera's opening may let a ray start in front of the focus.
    if (stages_.apart ? start(pixel) == tFocus : !std::isnan(tFocus)) return glm::dvec3(0.0);
    if (!(start(pixel) > stages_.hits.tContext[at] + 0.5 * wallDepth_)) return glm::dvec3(0.0);
    std::array<glm::dvec3, 2> tangents;
    for (int axis = 0; axis < 2; ++axis) {
      const glm::ivec2 step(1 - axis, axis);
      const glm::ivec2 before = glm::max(pixel - step, 0), after = glm::min(pixel + step, size_ - 1);
      if (std::isnan(start(before)) || std::isnan(start(after))) return glm::dvec3(0.0);
      tangents[static_cast<std::size_t>(axis)] = startPoint(after) - startPoint(before);
    }
    const glm::dvec3 normal = glm::cross(tangents[0], tangents[1]);
    const double length = glm::length(normal);
    return length > 0.0 ? normal / length : glm::dvec3(0.0);
  }

 private:
  glm::dvec3 startPoint(glm::ivec2 pixel) const {
    const Ray ray = pixelRay(camera_, size_, pixel);
    return ray.origin + start(pixel) * ray.direction;
  }

  const Camera& camera_;
  glm::ivec2 size_;
  const Stages& stages_;
  double wallDepth_;  ///< mm
};

/// The rays of `pixels`, starting where the box or the cutaway lets them.
std::vector<CutRay> cutRays(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages* stages,
                            const std::vector<glm::ivec2>& pixels) {
  constexpr Span missed{1.0, 0.0};
  std::vector<CutRay> rays;
  rays.reserve(pixels.size());
  const std::vector<HalfSpace> kept = halfSpaces(scene.look.clipping, scene.volume->grid);
  const glm::dvec3 spacing = scene.volume->grid.spacing;
  const double finest = std::min({spacing.x, spacing.y, spacing.z});
  std::optional<Opening> opening;
  if (stages) opening.emplace(scene, camera, size, *stages);
  for (const glm::ivec2 pixel : pixels) {
    CutRay ray{.ray = pixelRay(camera, size, pixel), .span = missed};
    const std::optional<Span> span = clip(ray.ray, scene.volume->grid, kept);
    if (span) ray.span = *span;
    if (opening) {
      const double start = opening->start(pixel);
      if (std::isnan(start)) {
        ray.span = missed;
      } else {
        ray.span.tIn = std::max(ray.span.tIn, start);
        ray.wall = opening->wallNormal(pixel);
        if (stages->apart) {
          const std::size_t at = offset(size, pixel);
          ray.hole = {stages->apart->holeBegin[at], stages->apart->holeEnd[at]};
        }
      }
    }
    if (span && ray.wall == glm::dvec3(0.0))
      if (const auto normal = capNormal(ray.ray, scene.volume->grid, kept)) {
        ray.wall = *normal;
        ray.beforeWall = ray.span.tIn - span->tIn;
        const bool onFace = ray.beforeWall <= 0.5 * lighting::wallDepthVoxels * finest;
        const bool onFocus = opening && opening->start(pixel) == stages->hits.tFocus[offset(size, pixel)];
        if (scene.look.clipping.grey && onFace && !onFocus) ray.grey = GreyFace{*scene.look.clipping.grey, !opening};
      }
    rays.push_back(ray);
  }
  return rays;
}

/// Premultiplied `front` over `behind`.
glm::dvec4 over(glm::dvec4 front, glm::dvec4 behind) { return front + (1.0 - front.a) * behind; }

/// What shows of a colour that the opening removes, where the method keeps it faint.
glm::dvec4 madeFaint(glm::dvec4 colour, const MethodStages& method, glm::ivec2 pixel) {
  colour *= faintShare(method.sparseness, method.faintOpacity, pixel.x, pixel.y);
  if (method.sparseness != Sparseness::Colour) return colour;
  // Luminance after ITU-R BT.709.
  const double grey = glm::dot(glm::dvec3(colour), glm::dvec3(0.2126, 0.7152, 0.0722));
  return {glm::dvec3(grey), colour.a};
}

/// Lays a layer, each pixel as `shown` makes it, over the picture; `kept` gets the layer.
template <class Shown>
void layOver(FocusLayer front, std::vector<glm::dvec4>& kept, Image& error, std::vector<glm::dvec4>& picture,
             const Shown& shown) {
  for (std::size_t i = 0; i < picture.size(); ++i) {
    picture[i] = over(shown(front.colour[i], i), picture[i]);
    error[i] += front.error[i];
  }
  kept = std::move(front.colour);
}

/// Opacity of the context layer: both terms rise steeply, so that edges come out as lines. `factor` is the brush's.
double contextOpacity(const ContextLayer& look, const ContextPoint& point, double scale, double factor) {
  const double bend = std::sqrt(0.5 * (point.k1 * point.k1 + point.k2 * point.k2)) * scale;
  const double opacity = look.curvatureWeight * smoothstep(0.10, 0.40, bend) +
                         look.silhouetteWeight * smoothstep(0.30, 0.85, point.silhouette);
  return std::min(look.strength * std::clamp(opacity, 0.0, 1.0) * factor, 1.0);
}

glm::dvec3 contextColour(const ContextLayer& look, const TransferFunction& context, const ContextPoint& point) {
  return glm::mix(look.colour, context.evaluate(point.value).colour, look.valueWeight) *
         glm::mix(1.0, point.illumination, look.illuminationWeight);
}

/// Share of a pixel, a box one pixel wide across the rim, that w_open < DM ≤ w_open + w_border covers.
double borderCoverage(double distance, Widths widths) {
  if (!(distance > 0.0)) return 0.0;
  const double low = std::max(distance - 0.5, widths.open),
               high = std::min(distance + 0.5, widths.open + widths.border);
  return std::clamp(high - low, 0.0, 1.0);
}

}  // namespace

Picture picture(const Scene& scene, const Camera& camera, glm::ivec2 size, const PictureOptions& options) {
  const Stages stages = hasCutaway(scene) ? geometricStages(scene, camera, size, options.pixelScale) : Stages{};
  return picture(scene, camera, size, stages, options);
}

Picture picture(const Scene& scene, const View& view, double tolerance) {
  return picture(scene, view.camera, view.size, hasCutaway(scene) ? geometricStages(scene, view) : Stages{},
                 {.pixelScale = view.pixelScale, .tolerance = tolerance, .pixels = {}});
}

Picture picture(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages& stages,
                const PictureOptions& options) {
  const bool cutaway = hasCutaway(scene), hasContext = cutaway && scene.look.contextLayer.strength > 0.0;
  const std::vector<glm::ivec2> pixels = pixelsOf(size, options);
  const std::vector<CutRay> cut = cutRays(scene, camera, size, cutaway ? &stages : nullptr, pixels);
  const bool guarded = cutaway && !labelsWith(LabelRole::Protected, scene).empty();
  const MethodStages method = stagesOf(scene.look.method);
  const bool hasFaint = cutaway && method.faintOpacity > 0.0;
  // Of each of so many layers, and half of what is left beside exempt labels.
  const double tolerance =
      options.tolerance / (1.0 + guarded + hasFaint) * (scene.look.clipping.exempt.empty() ? 1.0 : 0.5);
  std::optional<Occlusion> occlusion;
  if (hasOcclusion(scene.look.shading)) occlusion.emplace(scene, camera, size, cutaway ? &stages : nullptr);
  const Occlusion* const occluded = occlusion ? &*occlusion : nullptr;
  FocusLayer layer = focusLayer(scene, camera, cut, tolerance, occluded);

  const auto factor = [&](glm::ivec2 pixel) {
    return stages.editFactor.empty() ? 1.0 : stages.editFactor[offset(size, pixel)];
  };

  Picture result;
  result.final = layer.colour;
  Image firstHits;
  if (guarded || hasFaint)
    for (const glm::ivec2 pixel : pixels) firstHits.push_back(stages.hits.tContext[offset(size, pixel)]);
  if (hasFaint)
    layOver(removedLayer(scene, camera, cut, firstHits, tolerance, occluded), result.faintLayer, layer.error,
            result.final, [&](glm::dvec4 colour, std::size_t i) { return madeFaint(colour, method, pixels[i]); });
  if (guarded)
    layOver(protectedLayer(scene, camera, cut, firstHits, tolerance, occluded), result.protectedLayer, layer.error,
            result.final, [](glm::dvec4 colour, std::size_t) { return colour; });
  if (hasContext) {
    std::vector<Ray> rays;
    Image tContext, tFocus;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      rays.push_back(cut[i].ray);
      const std::size_t at = offset(size, pixels[i]);
      tContext.push_back(stages.hits.tContext[at]);
      // Of a surface that another camera's opening leaves, the edges show in itself.
      const bool stays = stages.apart && !(stages.tStart[at] > stages.hits.tContext[at]);
      tFocus.push_back(stays ? nothing : stages.hits.tFocus[at]);
    }
    const double scale = derivativeSpacing(scene.volume->grid);
    const TransferFunction context = scene.look.context.shifted();
    for (const auto& point : contextLayer(scene, camera, rays, tContext, tFocus)) {
      const std::size_t i = result.contextLayer.size();
      result.contextLayer.push_back(point ? glm::dvec4(point->k1, point->k2, point->illumination, point->value)
                                          : glm::dvec4(nothing));
      result.silhouette.push_back(point ? point->silhouette : nothing);
      if (!point) continue;
      const glm::dvec4 surface(contextColour(scene.look.contextLayer, context, *point), 1.0);
      const double opacity = contextOpacity(scene.look.contextLayer, *point, scale, factor(pixels[i]));
      result.final[i] = over(surface * opacity, result.final[i]);
    }
  }
  if (cutaway && scene.look.cutaway.borderWidth > 0.0) {
    const Widths widths = stages.apart ? stages.apart->widths : widthsInPixels(scene, camera, size, options.pixelScale);
    // The border's rim is filtered over one pixel, so it shows half a pixel beyond the border.
    const Image distance =
        stages.apart ? stages.apart->distance : distanceMap(openedBy(stages), size, widths.open + widths.border + 1.0);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const std::size_t at = offset(size, pixels[i]);
      if (std::isnan(stages.hits.tContext[at])) continue;
      const glm::dvec4 border(scene.look.cutaway.borderColour, 1.0);
      result.final[i] = glm::mix(result.final[i], border, borderCoverage(distance[at], widths) * factor(pixels[i]));
    }
  }
  const Clipping& clipping = scene.look.clipping;
  if (!clipping.exempt.empty() && structuresOf(scene) && !halfSpaces(clipping, scene.volume->grid).empty()) {
    const ExemptLayers exempt = exemptLayers(scene, camera, cut, 0.25 * options.tolerance, occluded);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      result.final[i] = over(over(exempt.before.colour[i], result.final[i]), exempt.behind.colour[i]);
      layer.error[i] += exempt.before.error[i] + exempt.behind.error[i];
    }
  }
  result.focusLayer = std::move(layer.colour);
  result.error = std::move(layer.error);
  return result;
}

}  // namespace fenestra::reference
