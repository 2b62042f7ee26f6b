#include "rendering/reference/Picture.h"

#include "rendering/reference/Blend.h"
#include "rendering/reference/ContextLayer.h"
#include "rendering/reference/Exploded.h"
#include "rendering/reference/FocusLayer.h"
#include "rendering/reference/Lens.h"
#include "rendering/reference/Light.h"
#include "rendering/reference/Maximum.h"
#include "rendering/reference/Occlusion.h"
#include "rendering/reference/Peeled.h"
#include "rendering/reference/Strokes.h"
#include "rendering/reference/Unknown.h"
#include "rendering/reference/Walls.h"
#include "rendering/scene/ContextLines.h"
#include "rendering/scene/EdgeRays.h"
#include "rendering/scene/Edges.h"
#include "rendering/scene/Explosion.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/Lighting.h"
#include "rendering/scene/Maximum.h"
#include "rendering/scene/Walls.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

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

/// What the rays of a picture have in common, those through its pixels and those between.
struct Frame {
  const Scene& scene;
  const Camera& camera;
  glm::ivec2 size;
  const Stages* pixels;  ///< stages 1 to 4 of the pixels; null without an opening
  Widths widths;         ///< of the opening
  const Occlusion* occlusion;
  double tolerance;
  const ShownSlices& slices;
  double leastLine = lines::all;  ///< strength of the weakest of the context's edges that show
  bool hasBorder() const {
    return pixels && scene.look.cutaway.borderWidth > 0.0 && stagesOf(scene.look.method).hasBorder;
  }
};

/// Some of those rays.
struct Rays {
  std::vector<glm::dvec2> places;  ///< on the picture, pixels from its top left
  const Stages& stages;
  std::vector<std::size_t> at;  ///< of each ray in the stages
  const Image& borderDistance;  ///< that the line around the opening goes by, as the stages; empty without one
  double boxWidth;              ///< pixels that a ray stands for
  double start(std::size_t i) const { return stages.tStart[at[i]]; }
  double tContext(std::size_t i) const { return stages.hits.tContext[at[i]]; }
  double tFocus(std::size_t i) const { return stages.hits.tFocus[at[i]]; }
  double factor(std::size_t i) const { return stages.editFactor.empty() ? 1.0 : stages.editFactor[at[i]]; }
};

double finestSpacing(const Scene& scene) {
  const glm::dvec3 spacing = scene.volume->grid.spacing;
  return std::min({spacing.x, spacing.y, spacing.z});
}

/// Unit normal of the face that the cutaway cuts, from the ray starts of the pixels beside a ray's own; zero where the
/// ray starts on the focus, or on the context's own surface.
glm::dvec3 wallNormal(const Frame& frame, const Rays& rays, std::size_t i) {
  const double start = rays.start(i), tFocus = rays.tFocus(i);
  // Another camera's opening may let a ray start in front of the focus.
  if (rays.stages.apart ? start == tFocus : !std::isnan(tFocus)) return glm::dvec3(0.0);
  if (!(start > rays.tContext(i) + 0.5 * lighting::wallDepthVoxels * finestSpacing(frame.scene)))
    return glm::dvec3(0.0);
  const glm::ivec2 pixel(glm::floor(rays.places[i]));
  std::array<glm::dvec3, 2> tangents;
  for (int axis = 0; axis < 2; ++axis) {
    const glm::ivec2 step(1 - axis, axis);
    const auto startPoint = [&](glm::ivec2 beside) {
      const Ray ray = pixelRay(frame.camera, frame.size, beside);
      return ray.origin + frame.pixels->tStart[offset(frame.size, beside)] * ray.direction;
    };
    const glm::dvec3 before = startPoint(glm::max(pixel - step, 0)),
                     after = startPoint(glm::min(pixel + step, frame.size - 1));
    if (std::isnan(before.x) || std::isnan(after.x)) return glm::dvec3(0.0);
    tangents[static_cast<std::size_t>(axis)] = after - before;
  }
  const glm::dvec3 normal = glm::cross(tangents[0], tangents[1]);
  const double length = glm::length(normal);
  return length > 0.0 ? normal / length : glm::dvec3(0.0);
}

/// The rays, starting where the box or the cutaway lets them.
std::vector<CutRay> cutRays(const Frame& frame, const Rays& rays) {
  constexpr Span missed{1.0, 0.0};
  const Scene& scene = frame.scene;
  std::vector<CutRay> cut;
  cut.reserve(rays.places.size());
  const std::vector<HalfSpace> kept = halfSpaces(scene.look.clipping, scene.volume->grid);
  const auto fading = fadingOf(scene.look);
  const bool ghosted = fading && fading->ghost;
  for (std::size_t i = 0; i < rays.places.size(); ++i) {
    CutRay ray{.ray = rayThrough(frame.camera, frame.size, rays.places[i]), .span = missed};
    const std::optional<Span> span = clip(ray.ray, scene.volume->grid, kept);
    if (span) ray.span = *span;
    if (frame.pixels && ghosted) {
      const bool opened = rays.start(i) > rays.tContext(i) || !std::isnan(rays.tFocus(i));
      ray.ghostedTo = opened ? rays.start(i) : -std::numeric_limits<double>::infinity();
      if (const auto& apart = rays.stages.apart; apart && !std::isnan(rays.start(i)))
        ray.hole = {apart->holeBegin[rays.at[i]], apart->holeEnd[rays.at[i]]};
    } else if (frame.pixels) {
      const double start = rays.start(i);
      if (std::isnan(start)) {
        ray.span = missed;
      } else {
        ray.span.tIn = std::max(ray.span.tIn, start);
        ray.onFocus = start == rays.tFocus(i);
        ray.wall = wallNormal(frame, rays, i);
        if (const auto& apart = rays.stages.apart)
          ray.hole = {apart->holeBegin[rays.at[i]], apart->holeEnd[rays.at[i]]};
      }
    }
    if (span && ray.wall == glm::dvec3(0.0))
      if (const auto normal = capNormal(ray.ray, scene.volume->grid, kept)) {
        ray.wall = *normal;
        ray.beforeWall = ray.span.tIn - span->tIn;
        const double opened = std::max(ray.span.tIn, ray.ghostedTo.value_or(ray.span.tIn));
        const bool onFace = opened - span->tIn <= 0.5 * lighting::wallDepthVoxels * finestSpacing(scene);
        const bool onFocus = frame.pixels && rays.start(i) == rays.tFocus(i);
        if (scene.look.clipping.grey && onFace && !onFocus)
          ray.grey = GreyFace{*scene.look.clipping.grey, !frame.pixels};
      }
    cut.push_back(ray);
  }
  return cut;
}

/// The lens at the pixels of some rays; empty without one.
std::vector<LensPoint> lensOf(const Frame& frame, const Rays& rays, Picture& picture) {
  if (!frame.pixels || !stagesOf(frame.scene.look.method).lens) return {};
  std::vector<glm::ivec2> pixels;
  for (const glm::dvec2 place : rays.places) pixels.emplace_back(glm::floor(place));
  std::vector<LensPoint> points =
      lensPoints(frame.scene, frame.camera, frame.size, frame.pixels->hits, pixels, frame.slices);
  for (const LensPoint& point : points) picture.lens.emplace_back(point.normal, point.distance);
  return points;
}

/// A colour that the opening removes, as faint as the method keeps it.
glm::dvec4 madeFaint(glm::dvec4 colour, const MethodStages& method, glm::dvec2 place) {
  const glm::ivec2 pixel(glm::floor(place));
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

/// The walls on some rays; empty where the picture has none of that placement.
std::vector<glm::dvec4> wallsOn(const Frame& frame, const Rays& rays, WallPlacement placement) {
  const auto walls = wallsOf(frame.scene.look);
  if (!walls || walls->placement != placement) return {};
  const bool inside = placement == WallPlacement::Inside;
  if (inside && !frame.pixels) return {};
  std::vector<WallRay> seen;
  for (std::size_t i = 0; i < rays.places.size(); ++i) {
    WallRay& ray = seen.emplace_back(WallRay{rayThrough(frame.camera, frame.size, rays.places[i]), {}});
    if (!inside) continue;
    // Comparisons with a start that is not there are false.
    const bool opened = std::isnan(rays.tFocus(i)) && rays.start(i) > rays.tContext(i);
    ray.shown = opened ? Span{rays.tContext(i), rays.start(i)} : Span{1.0, 0.0};
  }
  return wallColours(frame.scene, frame.camera, frame.size, frame.slices, seen);
}

/// Strength of the weakest edge that shows in a picture, as rendering/scene/ContextLines.h has it.
double leastLineOf(const Scene& scene, const Camera& camera, glm::ivec2 size, const HitPoints& hits) {
  const ContextLayer& look = scene.look.contextLayer;
  if (!(look.strength > 0.0) || look.share >= 1.0) return lines::all;
  std::vector<Ray> rays;
  Image tContext, tFocus;
  for (int j = 0; j < size.y; ++j)
    for (int i = 0; i < size.x; ++i)
      if (const std::size_t at = offset(size, {i, j}); !std::isnan(hits.tFocus[at])) {
        rays.push_back(pixelRay(camera, size, {i, j}));
        tContext.push_back(hits.tContext[at]);
        tFocus.push_back(hits.tFocus[at]);
      }
  const double scale = derivativeSpacing(scene.volume->grid);
  std::vector<std::uint32_t> counts(lines::bins, 0);
  for (const auto& point : contextLayer(scene, camera, rays, tContext, tFocus))
    if (point) ++counts[lines::binOf(strengthOf(look, *point, scale))];
  return lines::leastStrength(counts, static_cast<std::uint32_t>(rays.size()), look.share);
}

/// Share of a box across the line around the opening that w_open < DM ≤ w_open + w_border covers.
double borderCoverage(double distance, Widths widths, double boxWidth) {
  if (!(distance > 0.0)) return 0.0;
  const double low = std::max(distance - 0.5 * boxWidth, widths.open),
               high = std::min(distance + 0.5 * boxWidth, widths.open + widths.border);
  return std::clamp((high - low) / boxWidth, 0.0, 1.0);
}

void addContextLayer(const Frame& frame, const Rays& rays, const std::vector<CutRay>& cut,
                     const std::vector<LensPoint>& lens, Picture& picture) {
  const ContextLayer& look = frame.scene.look.contextLayer;
  std::vector<Ray> uncut;
  Image tContext, tFocus;
  for (std::size_t i = 0; i < cut.size(); ++i) {
    uncut.push_back(cut[i].ray);
    tContext.push_back(rays.tContext(i));
    // Where another camera's opening leaves the context's surface in place, no edges are laid over it: it shows itself.
    const bool stays = rays.stages.apart && !(rays.start(i) > rays.tContext(i));
    tFocus.push_back(stays ? unknown : rays.tFocus(i));
  }
  const double scale = derivativeSpacing(frame.scene.volume->grid);
  const TransferFunction context = frame.scene.look.context.shifted();
  for (const auto& point : contextLayer(frame.scene, frame.camera, uncut, tContext, tFocus)) {
    const std::size_t i = picture.contextLayer.size();
    picture.contextLayer.push_back(point ? glm::dvec4(point->k1, point->k2, point->illumination, point->value)
                                         : glm::dvec4(unknown));
    picture.silhouette.push_back(point ? point->silhouette : unknown);
    if (!point) continue;
    const glm::dvec4 surface(contextColour(look, context, *point), 1.0);
    double opacity = contextOpacity(look, *point, scale, rays.factor(i), frame.leastLine);
    if (!lens.empty()) opacity *= 1.0 - lens[i].share;
    picture.final[i] = over(surface * opacity, picture.final[i]);
  }
}

Picture explodedPicture(const Frame& frame, const Rays& rays) {
  FocusLayer layer = explodedLayer(frame.scene, frame.camera, frame.size, rays.places, frame.tolerance);
  Picture result;
  result.final = layer.colour;
  result.focusLayer = std::move(layer.colour);
  result.error = std::move(layer.error);
  return result;
}

void addBorder(const Frame& frame, const Rays& rays, std::vector<glm::dvec4>& final) {
  const glm::dvec4 border(frame.scene.look.cutaway.borderColour, 1.0);
  for (std::size_t i = 0; frame.hasBorder() && i < final.size(); ++i) {
    if (std::isnan(rays.tContext(i))) continue;
    const double coverage = borderCoverage(rays.borderDistance[rays.at[i]], frame.widths, rays.boxWidth);
    final[i] = glm::mix(final[i], border, coverage * rays.factor(i));
  }
}

/// What clipping leaves whole, before and behind the picture; adds its error.
void addExemptLabels(const Frame& frame, const std::vector<CutRay>& cut, std::vector<glm::dvec4>& final,
                     std::vector<double>& error) {
  const Scene& scene = frame.scene;
  const Clipping& clipping = scene.look.clipping;
  if (clipping.exempt.empty() || !structuresOf(scene) || halfSpaces(clipping, scene.volume->grid).empty()) return;
  const ExemptLayers exempt = exemptLayers(scene, frame.camera, cut, 0.25 * frame.tolerance, frame.occlusion);
  for (std::size_t i = 0; i < cut.size(); ++i) {
    final[i] = over(over(exempt.before.colour[i], final[i]), exempt.behind.colour[i]);
    error[i] += exempt.before.error[i] + exempt.behind.error[i];
  }
}

/// Stages 5 to 7 of some rays.
Picture drawn(const Frame& frame, const Rays& rays) {
  const Scene& scene = frame.scene;
  if (explosionOf(scene.look)) return explodedPicture(frame, rays);
  const std::vector<CutRay> cut = cutRays(frame, rays);
  const bool guarded = frame.pixels && !labelsWith(LabelRole::Protected, scene).empty();
  const MethodStages method = stagesOf(scene.look.method);
  const bool hasFaint = frame.pixels && method.keepsRemoved();
  // Each layer has an equal share of the tolerance, and half of it where exempt labels are drawn beside them.
  const double tolerance =
      frame.tolerance / (1.0 + guarded + hasFaint) * (scene.look.clipping.exempt.empty() ? 1.0 : 0.5);
  FocusLayer layer = maximumOf(scene.look) ? layerOf(Alone::InFocus, scene, frame.camera, cut, tolerance)
                                           : focusLayer(scene, frame.camera, cut, tolerance, frame.occlusion);
  Picture result;
  result.final = layer.colour;
  if (const auto maximum = maximumOf(scene.look)) {
    const std::vector<glm::dvec4> behind = maximumLayer(scene, cut, *maximum);
    for (std::size_t i = 0; i < cut.size(); ++i) result.final[i] = over(result.final[i], behind[i]);
  }
  if (const std::vector<glm::dvec4> inside = wallsOn(frame, rays, WallPlacement::Inside); !inside.empty()) {
    for (std::size_t i = 0; i < cut.size(); ++i) result.final[i] = over(inside[i], result.final[i]);
    result.walls = inside;
  }
  const std::vector<LensPoint> lens = lensOf(frame, rays, result);
  Image firstHits;
  for (std::size_t i = 0; (guarded || hasFaint) && i < cut.size(); ++i) firstHits.push_back(rays.tContext(i));
  if (hasFaint)
    layOver(removedLayer(scene, frame.camera, cut, firstHits, tolerance, frame.occlusion), result.faintLayer,
            layer.error, result.final, [&](glm::dvec4 colour, std::size_t i) {
              return lens.empty() ? madeFaint(colour, method, rays.places[i]) : lens[i].share * colour;
            });
  if (guarded)
    layOver(protectedLayer(scene, frame.camera, cut, firstHits, tolerance, frame.occlusion), result.protectedLayer,
            layer.error, result.final, [](glm::dvec4 colour, std::size_t) { return colour; });
  if (frame.pixels && scene.look.contextLayer.strength > 0.0) addContextLayer(frame, rays, cut, lens, result);
  addBorder(frame, rays, result.final);
  for (std::size_t i = 0; i < lens.size(); ++i) {
    glm::dvec4& colour = result.final[i];
    const double line = lens[i].line * rays.factor(i) * colour.a;
    colour = {glm::max(glm::dvec3(colour) - line, 0.0), colour.a};
  }
  addExemptLabels(frame, cut, result.final, layer.error);
  if (const std::vector<glm::dvec4> around = wallsOn(frame, rays, WallPlacement::Around); !around.empty()) {
    for (std::size_t i = 0; i < cut.size(); ++i) result.final[i] = over(result.final[i], around[i]);
    result.walls = around;
  }
  result.focusLayer = std::move(layer.colour);
  result.error = std::move(layer.error);
  return result;
}

bool isInside(glm::ivec2 pixel, glm::ivec2 size) {
  return glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) && glm::all(glm::lessThan(pixel, size));
}
constexpr std::array<glm::ivec2, 4> steps{{glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(-1, 0), glm::ivec2(0, -1)}};

/// The pixels, then their neighbours that are not among them; and where each pixel of the picture is in that list.
struct Neighbourhood {
  std::vector<glm::ivec2> pixels;
  std::vector<std::size_t> indexOf;
  static constexpr std::size_t absent = std::numeric_limits<std::size_t>::max();
};
Neighbourhood withNeighbours(const std::vector<glm::ivec2>& pixels, glm::ivec2 size) {
  Neighbourhood all{
      {}, std::vector(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), Neighbourhood::absent)};
  const auto add = [&](glm::ivec2 pixel, bool again) {
    std::size_t& index = all.indexOf[offset(size, pixel)];
    if (index != Neighbourhood::absent && !again) return;
    index = all.pixels.size();
    all.pixels.push_back(pixel);
  };
  for (const glm::ivec2 pixel : pixels) add(pixel, true);
  for (const glm::ivec2 pixel : pixels)
    for (const glm::ivec2 step : steps)
      if (isInside(pixel + step, size)) add(pixel + step, false);
  return all;
}

/// Greatest difference of a channel between a pixel and one beside it, as EdgeRays.h defines it.
double contrastOf(const Frame& frame, const Rays& rays, const std::vector<glm::dvec4>& colours,
                  const Neighbourhood& all, std::size_t i) {
  const auto isOnBorder = [&](std::size_t k) {
    return frame.hasBorder() && !std::isnan(rays.tContext(k)) &&
           borderCoverage(rays.borderDistance[rays.at[k]], frame.widths, 1.0) > 0.0;
  };
  const auto meetTheSame = [&](std::size_t a, std::size_t b) {
    return std::isnan(rays.tContext(a)) == std::isnan(rays.tContext(b)) &&
           std::isnan(rays.tFocus(a)) == std::isnan(rays.tFocus(b));
  };
  double contrast = 0.0;
  for (const glm::ivec2 step : steps) {
    const glm::ivec2 beside = all.pixels[i] + step;
    if (!isInside(beside, frame.size)) continue;
    const std::size_t k = all.indexOf[offset(frame.size, beside)];
    const bool outlined = frame.pixels && !meetTheSame(i, k);
    if (!outlined && (isOnBorder(i) || isOnBorder(k))) continue;
    const glm::dvec4 difference = (outlined ? edges::outline : 1.0) * glm::abs(colours[i] - colours[k]);
    contrast = std::max({contrast, difference.r, difference.g, difference.b, difference.a});
  }
  return contrast;
}

/// Makes the edges of the first `count` pixels of a picture smooth.
void smoothEdges(const Frame& frame, const Rays& rays, double pixelScale, const Neighbourhood& all, std::size_t count,
                 Picture& picture) {
  struct Edge {
    std::size_t pixel;
    double weight;
  };
  std::vector<Edge> found;
  std::vector<glm::dvec2> places;
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = edges::weight(contrastOf(frame, rays, picture.final, all, i));
    if (!(weight > 0.0)) continue;
    found.push_back({i, weight});
    for (const glm::dvec2 sample : edges::sampleOffsets) places.push_back(rays.places[i] + sample);
  }
  if (found.empty()) return;
  const Stages stages =
      frame.pixels ? stagesBetween(frame.scene, frame.camera, frame.size, *frame.pixels, pixelScale, places) : Stages{};
  Rays samples{
      std::move(places), stages, {}, stages.apart ? stages.apart->distance : stages.distance, edges::sampleWidth};
  for (std::size_t i = 0; i < samples.places.size(); ++i) samples.at.push_back(i);
  const Picture between = drawn(frame, samples);
  constexpr std::size_t perPixel = edges::sampleOffsets.size();
  for (std::size_t e = 0; e < found.size(); ++e) {
    glm::dvec4& colour = picture.final[found[e].pixel];
    glm::dvec4 sum = colour;
    double& error = picture.error[found[e].pixel];
    for (std::size_t k = e * perPixel; k < (e + 1) * perPixel; ++k) {
      sum += between.final[k];
      error = std::max(error, between.error[k]);
    }
    colour = glm::mix(colour, sum / static_cast<double>(perPixel + 1), found[e].weight);
  }
}

}  // namespace

Picture picture(const Scene& scene, const Camera& camera, glm::ivec2 size, const PictureOptions& options) {
  const Stages stages = hasCutaway(scene) ? geometricStages(scene, camera, size, options.pixelScale) : Stages{};
  return picture(scene, camera, size, stages, options);
}

Picture picture(const Scene& scene, const View& view, double tolerance) {
  return picture(asDrawn(scene, view), view.camera, view.size,
                 hasCutaway(scene) ? geometricStages(scene, view) : Stages{},
                 {.pixelScale = view.pixelScale, .tolerance = tolerance, .pixels = {}, .slices = view.slices});
}

Scene asDrawn(Scene scene, const View& view) {
  if (!hasSmoothEdges(scene.look, view)) scene.look.edges = Edges::Off;
  return scene;
}

Picture picture(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages& stages,
                const PictureOptions& options) {
  if (const auto peeled = peeledScene(scene)) return picture(*peeled, camera, size, stages, options);
  const bool cutaway = hasCutaway(scene), smooth = scene.look.edges == Edges::Smooth;
  std::vector<glm::ivec2> pixels = pixelsOf(size, options);
  const std::size_t count = pixels.size();
  Neighbourhood all;
  if (smooth) {
    all = withNeighbours(pixels, size);
    pixels = all.pixels;
  }
  std::optional<Occlusion> occlusion;
  if (hasOcclusion(scene.look)) occlusion.emplace(scene, camera, size, cutaway ? &stages : nullptr);
  Frame frame{scene,
              camera,
              size,
              cutaway ? &stages : nullptr,
              {},
              occlusion ? &*occlusion : nullptr,
              options.tolerance,
              options.slices,
              cutaway ? leastLineOf(scene, camera, size, stages.hits) : lines::all};
  Image distance;
  if (frame.hasBorder()) {
    frame.widths = stages.apart ? stages.apart->widths : widthsInPixels(scene, camera, size, options.pixelScale);
    // The border's rim is filtered over one pixel, so it shows half a pixel beyond the border.
    distance = stages.apart ? stages.apart->distance
                            : distanceMap(openedBy(stages), size, frame.widths.open + frame.widths.border + 1.0);
  }
  Rays rays{{}, stages, {}, distance, 1.0};
  for (const glm::ivec2 pixel : pixels) {
    rays.places.push_back(glm::dvec2(pixel) + 0.5);
    rays.at.push_back(offset(size, pixel));
  }
  Picture result = drawn(frame, rays);
  if (smooth) smoothEdges(frame, rays, options.pixelScale, all, count, result);
  for (auto* layer : {&result.focusLayer, &result.faintLayer, &result.protectedLayer, &result.contextLayer,
                      &result.lens, &result.walls, &result.final})
    if (layer->size() > count) layer->resize(count);
  for (Image* image : {&result.silhouette, &result.error})
    if (image->size() > count) image->resize(count);
  return result;
}

}  // namespace fenestra::reference
