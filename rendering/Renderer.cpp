#include "rendering/Renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "rendering/gl/Context.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/gpu/SceneBinding.h"
#include "rendering/passes/CompositePass.h"
#include "rendering/passes/ContextLayerPass.h"
#include "rendering/passes/DistanceMapPass.h"
#include "rendering/passes/EditMapPass.h"
#include "rendering/passes/FocusLayerPass.h"
#include "rendering/passes/HitPointPass.h"
#include "rendering/passes/PullPushPass.h"
#include "rendering/passes/RayStartPass.h"

namespace fenestra {
namespace {

/// What a pass last ran with. Its version grows with every run, so that later passes can have it in their own keys.
template <class Key>
class Memo {
 public:
  bool isStale(const Key& key) const { return key_ != key; }
  void ran(Key key) {
    key_ = std::move(key);
    ++version_;
  }
  void forget() { key_.reset(); }
  const std::optional<Key>& key() const { return key_; }  ///< of the last run, unless forgotten
  std::uint64_t version() const { return version_; }

 private:
  std::optional<Key> key_;
  std::uint64_t version_ = 0;
};

struct HitKey {
  std::uint64_t volume, focus, gaps;
  Camera camera;
  glm::ivec2 size;
  bool operator==(const HitKey&) const = default;
};
struct FillKey {
  std::uint64_t hits;
  bool operator==(const FillKey&) const = default;
};
struct DistanceKey {
  std::uint64_t hits;
  int range;
  bool operator==(const DistanceKey&) const = default;
};
struct RayStartKey {
  std::uint64_t hits, fill, distance;
  double openWidth;
  bool operator==(const RayStartKey&) const = default;
};
struct FocusLayerKey {
  std::optional<std::uint64_t> rayStart;
  std::uint64_t volume, focus, transfer, gradient, palette;
  double focusExtinction;
  Shading shading;
  Camera camera;
  glm::ivec2 size;
  FocusLayerPass::Sampling sampling;
  bool operator==(const FocusLayerKey&) const = default;
};
struct ContextLayerKey {
  std::uint64_t hits, derivative;
  Shading shading;
  bool operator==(const ContextLayerKey&) const = default;
};
struct CompositeKey {
  std::uint64_t focusLayer;
  std::uint64_t distance;
  std::optional<std::uint64_t> contextLayer, ownColours;
  glm::dvec2 widths;
  glm::dvec3 borderColour;
  ContextLayer look;
  bool operator==(const CompositeKey&) const = default;
  /// Whether both lay something over the same picture.
  bool sameBelow(const CompositeKey& other) const {
    return focusLayer == other.focusLayer && distance == other.distance && contextLayer == other.contextLayer;
  }
  double reach() const { return widths.x + widths.y + 1.0; }  ///< rendered pixels around the focus, its rim included
};

using Regions = std::span<const gl::Region>;

/// Of images that may be presented: a draft is smaller than the rectangle it fills.
constexpr gl::Filter presented = gl::Filter::Linear;

/// A picture-sized image that lasts until the size changes or it is no longer used.
gl::Texture& sized(gl::Texture& texture, gl::Format format, glm::ivec2 size, gl::Filter filter = gl::Filter::Nearest) {
  if (!texture || glm::ivec2(texture.size()) != size) texture = gl::Texture::make2D(format, size, filter);
  return texture;
}

/// Pixels from one ray that has to be followed to the next: a power of two, no more than a voxel is wide, so that what
/// the volume holds does not slip through; or else `least`.
int pitchOf(const Grid& grid, const RayFrame& rays, double least) {
  constexpr int widest = 4;
  const double finestSpacing = std::min({grid.spacing.x, grid.spacing.y, grid.spacing.z});
  const double depth = rays.depthOf(grid.centre());
  const double voxel = depth > 0.0 ? finestSpacing / rays.pixelSize(depth) : 0.0;  // pixels
  int pitch = widest;
  while (pitch > std::max(voxel, least)) pitch /= 2;
  return pitch;
}

FocusLayerPass::Sampling samplingOf(const View& view, const Grid& grid, const RayFrame& rays) {
  if (view.maxError) return {.maxError = *view.maxError / 255.0};
  if (view.quality == Quality::High) return {.maxError = highQualityError / 255.0};
  if (view.quality == Quality::Draft) return {.pitch = pitchOf(grid, rays, 2.0), .tolerance = 3.0 / 256.0};
  return {.pitch = pitchOf(grid, rays, 1.0)};
}

/// Distance maps reach this far (rendered pixels) or the next power of two beyond what the widths need: a slider that
/// moves within it leaves the map as it is.
constexpr int leastDistanceRange = 64;

/// What of the picture lies within `reach` pixels of a box of voxels.
gl::Region around(const IndexBox& box, double reach, const RayFrame& rays, const Grid& grid) {
  const glm::dvec3 low = glm::dvec3(box.low) - 1.0, high = glm::dvec3(box.high) + 1.0;
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const glm::dvec2 size(rays.size());
  glm::dvec2 first(size), last(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 world(worldFromIndex * glm::dvec4(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                                                       corner & 4 ? high.z : low.z, 1.0));
    if (!(rays.depthOf(world) > 0.0)) return {glm::ivec2(0), rays.size()};  // it reaches behind the eye
    const glm::dvec2 pixel = rays.pixelOf(world);
    first = glm::min(first, pixel - reach);
    last = glm::max(last, pixel + reach);
  }
  const glm::ivec2 origin(glm::clamp(glm::floor(first), glm::dvec2(0.0), size));
  return {origin, glm::max(glm::ivec2(glm::clamp(glm::ceil(last), glm::dvec2(0.0), size)) - origin, 0)};
}

/// Fills with zeros all of a picture but one region.
void clearAround(const gl::Region& region, gl::Texture& picture) {
  const glm::ivec2 size(picture.size()), first = region.origin, end = first + region.size;
  picture.clear({0, 0}, {size.x, first.y});
  picture.clear({0, end.y}, {size.x, size.y - end.y});
  picture.clear({0, first.y}, {first.x, region.size.y});
  picture.clear({end.x, first.y}, {size.x - end.x, region.size.y});
}

int distanceRange(glm::dvec2 widths, glm::ivec2 size) {
  // Half a pixel more than the border's rim, which is anti-aliased.
  const double needed = std::min(widths.x + widths.y + 1.0, std::hypot(size.x, size.y));
  int range = leastDistanceRange;
  while (range < needed) range *= 2;
  return range;
}

}  // namespace

std::string_view nameOf(Pass pass) {
  constexpr std::array<std::string_view, passCount> names{"hit points", "pull-push",   "distance map",  "edit map",
                                                          "ray start",  "focus layer", "context layer", "composite"};
  return names[static_cast<std::size_t>(pass)];
}

struct Renderer::State {
  std::shared_ptr<GpuScene> gpu;

  HitPointPass hitPointPass;
  PullPushPass pullPushPass;
  DistanceMapPass distanceMapPass;
  EditMapPass editMapPass;
  RayStartPass rayStartPass;
  FocusLayerPass focusLayerPass;
  ContextLayerPass contextLayerPass;
  CompositePass compositePass;
  gl::ShaderProgram presentProgram;

  gl::Texture hitPoints, focusFilled, distances, editMap, rayStart, focusLayer, contextLayer, silhouette, composed;
  gl::Texture pickedHit;

  Memo<HitKey> hits;
  Memo<FillKey> fill;
  Memo<DistanceKey> distance;
  Memo<RayStartKey> edits, start;
  Memo<FocusLayerKey> focus;
  Memo<ContextLayerKey> context;
  Memo<CompositeKey> composite;

  /// What the images were last edited by, in the last picture's view; unknown after an error stopped a picture.
  std::optional<ProjectedStrokes> strokes{std::in_place};

  std::optional<RayFrame> rays;  ///< of the last picture
  double pixelScale = 1.0;
  glm::dvec2 widths{0.0};
  glm::vec3 background{0.0f};
  bool timing = false;
  std::array<PassStats, passCount> stats{};

  /// Runs body(regions) over the whole picture, or the part of it that depends on what the key is known to have changed
  /// in, when the key changed; and over `changed`, where strokes changed.
  template <class Key, class Body>
  void runIfStale(Pass pass, Memo<Key>& memo, Key key, Regions changed, const Body& body,
                  const std::optional<gl::Region>& part = std::nullopt) {
    const bool stale = memo.isStale(key);
    if (!stale && changed.empty()) return;
    std::vector<gl::Region> regions;
    if (stale) regions.push_back(part.value_or(gl::Region{glm::ivec2(0), rays->size()}));
    if (!stale || part) regions.insert(regions.end(), changed.begin(), changed.end());
    PassStats& mine = stats[static_cast<std::size_t>(pass)];
    if (timing) {
      gl::TimerQuery timer;
      body(regions);
      mine.milliseconds = timer.elapsedMilliseconds();
    } else {
      body(regions);
    }
    ++mine.runs;
    mine.pixels = 0;
    for (const gl::Region& region : regions) mine.pixels += std::uint64_t(region.size.x) * std::uint64_t(region.size.y);
    if (stale) memo.ran(std::move(key));
  }

  void releaseEdits() {
    editMap = {};
    editMapPass.release();
    edits.forget();
  }
  /// Everything that strokes show in.
  void forgetEdited() {
    edits.forget();
    start.forget();
    focus.forget();
    composite.forget();
  }

  glm::dvec2 widthsInPixels(const Scene& scene) const;
  /// What is seen, without the background; a plain volume rendering has nothing laid over it.
  const gl::Texture& picture() const { return composed ? composed : focusLayer; }
  bool shows(glm::ivec2 pixel) const;
  /// First hits (context or focus, focus) on the ray of a pixel of the picture.
  glm::vec2 hitAt(glm::ivec2 pixel);
  /// Where the ray starts to see; `nothing` where it meets nothing.
  float startAt(glm::ivec2 pixel) { return rayStart ? rayStart.readTexel(pixel).x : hitAt(pixel).x; }
};

bool Renderer::State::shows(glm::ivec2 pixel) const {
  return picture() && glm::all(glm::greaterThanEqual(pixel, glm::ivec2(0))) &&
         glm::all(glm::lessThan(pixel, glm::ivec2(picture().size())));
}

glm::vec2 Renderer::State::hitAt(glm::ivec2 pixel) {
  if (hitPoints) return hitPoints.readTexel(pixel);
  // A plain volume rendering has no hit points: find this pixel's alone.
  hitPointPass.run(*gpu, *rays, sized(pickedHit, gl::Format::RG32F, glm::ivec2(1)), pixel);
  return pickedHit.readTexel(glm::ivec2(0));
}

glm::dvec2 Renderer::State::widthsInPixels(const Scene& scene) const {
  const glm::dvec2 wanted =
      glm::max(glm::dvec2(scene.look.cutaway.openWidth, scene.look.cutaway.borderWidth), glm::dvec2(0.0));
  if (scene.look.cutaway.unit == WidthUnit::Pixel) return wanted * pixelScale;
  const Grid& grid = scene.volume->grid;
  double depth = rays->depthOf(gpu->focus().centre(grid).value_or(grid.centre()));
  if (!(depth > 0.0)) depth = rays->depthOf(grid.centre());
  return wanted / rays->pixelSize(std::max(depth, 1e-3 * grid.boundingRadius()));
}

Renderer::Renderer(std::shared_ptr<GpuScene> gpuScene) : state_(std::make_unique<State>()) {
  state_->gpu = std::move(gpuScene);
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::render(const Scene& scene, const View& view) {
  State& s = *state_;
  s.gpu->update(scene);
  const GpuScene& gpu = *s.gpu;
  const GpuScene::Versions& version = gpu.versions();
  const Grid& grid = scene.volume->grid;
  s.rays.emplace(view.camera, view.size, grid);
  const RayFrame& rays = *s.rays;
  s.pixelScale = view.pixelScale;
  s.background = glm::vec3(scene.look.background);
  const bool cutaway = hasCutaway(scene);
  const bool contextLayer = cutaway && scene.look.contextLayer.strength > 0.0;
  s.widths = cutaway ? s.widthsInPixels(scene) : glm::dvec2(0.0);

  const FocusLayerPass::Sampling sampling = samplingOf(view, grid, rays);
  // Strokes are in no pass's key: all that depends on them is patched together, or not at all.
  const std::optional<ProjectedStrokes> before = std::exchange(s.strokes, std::nullopt);
  if (!before) s.forgetEdited();
  const ProjectedStrokes strokes = cutaway ? project(scene.look.strokes, rays) : ProjectedStrokes();
  const std::vector<gl::Region> changed =
      before ? changedRegions(*before, strokes, view.size, FocusLayerPass::reach(sampling)) : std::vector<gl::Region>();

  // What of the picture lies within so many pixels of the focus, where it is known to end.
  const auto nearFocus = [&](double reach) {
    return gpu.focus().box ? std::optional(around(*gpu.focus().box, reach, rays, grid)) : std::nullopt;
  };

  const std::uint64_t startBefore = s.start.version();
  // How far from the focus rays start elsewhere than before, where nothing but the opening moved.
  std::optional<double> moved;
  if (cutaway) {
    s.runIfStale(Pass::HitPoints, s.hits, HitKey{version.volume, version.focus, version.gaps, view.camera, view.size},
                 {}, [&](Regions) { s.hitPointPass.run(gpu, rays, sized(s.hitPoints, gl::Format::RG32F, view.size)); });
    s.runIfStale(Pass::PullPush, s.fill, FillKey{s.hits.version()}, {}, [&](Regions) {
      s.pullPushPass.run(gpu.schedule(), s.hitPoints, sized(s.focusFilled, gl::Format::R32F, view.size));
    });
    const int range = distanceRange(s.widths, view.size);
    s.runIfStale(Pass::DistanceMap, s.distance, DistanceKey{s.hits.version(), range}, {}, [&](Regions) {
      s.distanceMapPass.run(gpu.schedule(), s.hitPoints, range, sized(s.distances, gl::Format::R32F, view.size));
    });
    const RayStartKey startKey{s.hits.version(), s.fill.version(), s.distance.version(), s.widths.x};
    const RayStartPass::Inputs inputs{s.hitPoints, s.focusFilled, s.distances, s.widths.x};
    if (strokes.empty())
      s.releaseEdits();
    else
      s.runIfStale(Pass::EditMap, s.edits, startKey, changed, [&](Regions regions) {
        s.editMapPass.run(gpu.schedule(), rays, inputs, strokes, regions,
                          sized(s.editMap, gl::Format::RG32F, view.size));
      });
    if (const auto& last = s.start.key(); last && last->hits == startKey.hits)
      moved = std::max(last->openWidth, startKey.openWidth) + 1.0;
    s.runIfStale(
        Pass::RayStart, s.start, startKey, changed,
        [&](Regions regions) {
          s.rayStartPass.run(gpu.schedule(), rays, inputs, s.editMap ? &s.editMap : nullptr, regions,
                             sized(s.rayStart, gl::Format::R32F, view.size));
        },
        moved ? nearFocus(*moved) : std::nullopt);
  } else {
    // A plain volume rendering keeps none of the cutaway's images.
    for (gl::Texture* texture : {&s.hitPoints, &s.focusFilled, &s.distances, &s.rayStart}) *texture = {};
    s.pullPushPass.release();
    s.distanceMapPass.release();
    s.releaseEdits();
    s.hits.forget();
    s.fill.forget();
    s.distance.forget();
    s.start.forget();
  }

  const FocusLayerKey focusKey{cutaway ? std::optional(s.start.version()) : std::nullopt,
                               version.volume,
                               version.focus,
                               version.transfer,
                               version.gradient,
                               version.palette,
                               scene.look.focusAppearance.extinction,
                               scene.look.shading,
                               view.camera,
                               view.size,
                               sampling};
  FocusLayerKey keyBefore = focusKey;
  keyBefore.rayStart = startBefore;
  const bool onlyMoved = moved && !s.focus.isStale(keyBefore), anew = !onlyMoved && s.focus.isStale(focusKey);
  // Elsewhere rays miss the volume.
  const IndexBox all{glm::ivec3(0), grid.dims - 1};
  const gl::Region nearVolume = around(all, FocusLayerPass::reach(sampling), rays, grid);
  s.runIfStale(
      Pass::FocusLayer, s.focus, focusKey, anew ? Regions() : Regions(changed),
      [&](Regions regions) {
        std::optional<FocusLayerPass::Opening> opening;
        if (cutaway) opening.emplace(FocusLayerPass::Opening{s.hitPoints, s.rayStart});
        gl::Texture& focusLayer = sized(s.focusLayer, gl::Format::RGBA32F, view.size, presented);
        if (anew) clearAround(nearVolume, focusLayer);
        s.focusLayerPass.run(gpu, scene.look, rays, opening, sampling, regions, focusLayer);
      },
      onlyMoved ? nearFocus(*moved + FocusLayerPass::reach(sampling)) : nearVolume);

  if (contextLayer) {
    s.runIfStale(
        Pass::ContextLayer, s.context, ContextLayerKey{s.hits.version(), version.derivative, scene.look.shading}, {},
        [&](Regions regions) {
          s.contextLayerPass.run(gpu, scene.look.shading, rays, s.hitPoints, regions,
                                 sized(s.contextLayer, gl::Format::RGBA32F, view.size),
                                 sized(s.silhouette, gl::Format::R32F, view.size));
        },
        nearFocus(1.0));
  } else {
    s.contextLayer = {};
    s.silhouette = {};
    s.context.forget();
  }

  if (cutaway) {
    const CompositeKey compositeKey{s.focus.version(),
                                    s.distance.version(),
                                    contextLayer ? std::optional(s.context.version()) : std::nullopt,
                                    contextLayer ? std::optional(version.transfer) : std::nullopt,
                                    s.widths,
                                    scene.look.cutaway.borderColour,
                                    scene.look.contextLayer};
    // What lies over the focus layer lies near the focus; elsewhere the picture is the focus layer.
    const auto& last = s.composite.key();
    const bool sameBelow = last && last->sameBelow(compositeKey);
    const auto part = nearFocus(std::max(sameBelow ? last->reach() : 0.0, compositeKey.reach()));
    const bool stale = s.composite.isStale(compositeKey);
    const auto compose = [&](Regions regions) {
      gl::Texture& composed = sized(s.composed, gl::Format::RGBA32F, view.size, presented);
      if (stale && !sameBelow && part) composed.copy(s.focusLayer);
      CompositePass::Inputs inputs{s.focusLayer, s.hitPoints, s.distances, s.widths};
      if (s.editMap) inputs.editMap = &s.editMap;
      if (contextLayer) {
        inputs.contextLayer = &s.contextLayer;
        inputs.silhouette = &s.silhouette;
      }
      s.compositePass.run(gpu, inputs, scene.look, regions, composed);
    };
    s.runIfStale(Pass::Composite, s.composite, compositeKey, changed, compose, part);
  } else {
    s.composed = {};
    s.composite.forget();
  }
  s.strokes = strokes;
}

void Renderer::present(std::uint32_t framebuffer, glm::ivec4 rectangle) {
  State& s = *state_;
  if (!s.picture()) return;
  if (!s.presentProgram) s.presentProgram = gl::ShaderProgram::graphics("Present.vert", "Present.frag");
  const gl::DrawTarget target(framebuffer, rectangle);
  s.presentProgram.bind("picture", s.picture());
  s.presentProgram.set("background", s.background);
  s.presentProgram.drawFullScreen();
}

std::vector<std::uint8_t> Renderer::readPicture() {
  State& s = *state_;
  if (!s.picture()) return {};
  std::vector<glm::vec4> values(static_cast<std::size_t>(s.picture().size().x) *
                                static_cast<std::size_t>(s.picture().size().y));
  s.picture().readInto(std::span(values));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(values.size() * 4);
  for (const glm::vec4& front : values) {
    const glm::vec3 colour = glm::vec3(front) + (1.0f - front.a) * s.background;
    for (int channel = 0; channel < 3; ++channel)
      bytes.push_back(static_cast<std::uint8_t>(std::clamp(colour[channel], 0.0f, 1.0f) * 255.0f + 0.5f));
    bytes.push_back(255);
  }
  return bytes;
}

Layers Renderer::readLayers() {
  State& s = *state_;
  Layers layers;
  if (!s.picture()) return layers;
  layers.size = glm::ivec2(s.picture().size());
  const std::size_t count = static_cast<std::size_t>(layers.size.x) * static_cast<std::size_t>(layers.size.y);
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto time = [&](float position) {
    return isSomething(position) ? static_cast<float>(s.rays->distance() + position) : nan;
  };
  const auto times = [&](const gl::Texture& texture, std::vector<float>& into) {
    into.resize(count);
    texture.readInto(std::span(into));
    for (float& value : into) value = time(value);
  };
  if (s.hitPoints) {
    std::vector<glm::vec2> hits(count);
    s.hitPoints.readInto(std::span(hits));
    for (const glm::vec2& hit : hits) {
      layers.tContext.push_back(time(hit.x));
      layers.tFocus.push_back(time(hit.y));
    }
    times(s.focusFilled, layers.tFocusFilled);
    times(s.rayStart, layers.tStart);
    layers.distance.resize(count);
    s.distances.readInto(std::span(layers.distance));
    for (float& distance : layers.distance)
      if (distance > s.widths.x + s.widths.y) distance = std::numeric_limits<float>::infinity();
  }
  if (s.editMap) {
    layers.edits.resize(count);
    s.editMap.readInto(std::span(layers.edits));
  }
  if (s.contextLayer) {
    layers.contextLayer.resize(count);
    s.contextLayer.readInto(std::span(layers.contextLayer));
    const VolumeTexture& coding = s.gpu->volume();
    for (std::size_t i = 0; i < count; ++i) {
      glm::vec4& texel = layers.contextLayer[i];
      const bool written = !std::isnan(layers.tFocus[i]);
      texel = written && isSomething(texel.x)
                  ? glm::vec4(glm::vec3(texel), static_cast<float>(coding.slope * texel.w + coding.offset))
                  : glm::vec4(nan);
    }
  }
  layers.focusLayer.resize(count);
  s.focusLayer.readInto(std::span(layers.focusLayer));
  layers.final = layers.focusLayer;
  if (s.composed) s.composed.readInto(std::span(layers.final));
  return layers;
}

std::optional<glm::dvec3> Renderer::pick(glm::dvec2 pixel) {
  State& s = *state_;
  const glm::ivec2 at(glm::floor(pixel));
  if (!s.shows(at)) return std::nullopt;
  const float position = s.startAt(at);
  if (!isSomething(position)) return std::nullopt;
  return s.rays->worldPosition(glm::dvec2(at) + 0.5, position);
}

std::optional<BrushPoint> Renderer::pickBrush(glm::dvec2 pixel, BrushMode mode, std::optional<glm::dvec3> before) {
  State& s = *state_;
  const glm::ivec2 at(glm::floor(pixel));
  if (!s.shows(at)) return std::nullopt;
  const float context = s.hitAt(at).x;
  float position = context;
  if (mode == BrushMode::Open) {
    position = s.startAt(at);
    if (s.editMap && isSomething(position))
      position = std::max(context, position - std::max(0.0f, s.editMap.readTexel(at).x));
  }
  const RayFrame& rays = *s.rays;
  BrushPoint point;
  if (isSomething(position)) {
    // The surface under the pixel's centre, at the pixel's own place.
    const double depth = rays.depthOf(rays.worldPosition(glm::dvec2(at) + 0.5, position));
    point.anchor = rays.worldPositionAtDepth(pixel, depth);
  } else if (before) {
    point.anchor = rays.worldPositionAtDepth(pixel, rays.depthOf(*before));
  } else {
    return std::nullopt;
  }
  point.pixelSize = rays.pixelSize(rays.depthOf(point.anchor)) * s.pixelScale;
  return point;
}

void Renderer::setTiming(bool on) { state_->timing = on; }

const std::array<PassStats, passCount>& Renderer::stats() const { return state_->stats; }

std::size_t Renderer::imageBytes() const {
  const State& s = *state_;
  std::size_t sum =
      s.pullPushPass.bytes() + s.distanceMapPass.bytes() + s.editMapPass.bytes() + s.focusLayerPass.bytes();
  for (const gl::Texture* texture : {&s.hitPoints, &s.focusFilled, &s.distances, &s.editMap, &s.rayStart, &s.focusLayer,
                                     &s.contextLayer, &s.silhouette, &s.composed, &s.pickedHit})
    if (*texture) sum += texture->bytes();
  return sum;
}

}  // namespace fenestra
