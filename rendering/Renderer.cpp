#include "rendering/Renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rendering/PassChain.h"

namespace fenestra {

Renderer::Renderer(std::shared_ptr<GpuScene> gpuScene) : chain_(std::make_unique<PassChain>(std::move(gpuScene))) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::render(const Scene& scene, const View& view) {
  begin(scene, view);
  chain_->advance(std::nullopt);
}

void Renderer::begin(const Scene& scene, const View& view) { chain_->begin(scene, view); }

bool Renderer::advance(double milliseconds) { return chain_->advance(milliseconds); }

void Renderer::drop() { chain_->drop(); }

bool Renderer::isDrawing() const { return chain_->frame.has_value(); }

namespace {

void drawOver(PassChain& s, glm::ivec2 size) {
  const bool enlarged = s.picture().size().x < size.x || s.picture().size().y < size.y;
  gl::ShaderProgram& program = s.gpu->presentation(enlarged);
  program.bind("picture", s.picture());
  program.set("background", s.background);
  program.set("backgroundRise", s.backgroundRise);
  program.drawFullScreen();
}

}  // namespace

void Renderer::present(std::uint32_t framebuffer, glm::ivec4 rectangle) {
  if (!chain_->picture()) return;
  const gl::DrawTarget target(framebuffer, rectangle);
  drawOver(*chain_, {rectangle.z, rectangle.w});
}

std::vector<std::uint8_t> Renderer::readPresented(glm::ivec2 size) {
  if (!chain_->picture()) return {};
  const gl::Texture image = gl::Texture::make2D(gl::Format::BGRA8, size);
  {
    const gl::DrawTarget target(image);
    drawOver(*chain_, size);
  }
  std::vector<std::uint8_t> pixels(image.bytes());
  image.readInto(std::span(pixels));
  // OpenGL's first row is the lowest.
  const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(size.x);
  for (std::ptrdiff_t top = 0, bottom = (size.y - 1) * row; top < bottom; top += row, bottom -= row)
    std::swap_ranges(pixels.begin() + top, pixels.begin() + top + row, pixels.begin() + bottom);
  return pixels;
}

std::vector<std::uint8_t> Renderer::readPicture() {
  PassChain& s = *chain_;
  if (!s.picture()) return {};
  const auto width = static_cast<std::size_t>(s.picture().size().x),
             height = static_cast<std::size_t>(s.picture().size().y);
  std::vector<glm::vec4> values(width * height);
  s.picture().readInto(std::span(values));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(values.size() * 4);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const glm::vec4& front = values[i];
    const float above = 1.0f - (static_cast<float>(i / width) + 0.5f) / static_cast<float>(height);
    const glm::vec3 colour = glm::vec3(front) + (1.0f - front.a) * (s.background + above * s.backgroundRise);
    for (int channel = 0; channel < 3; ++channel)
      bytes.push_back(static_cast<std::uint8_t>(std::clamp(colour[channel], 0.0f, 1.0f) * 255.0f + 0.5f));
    bytes.push_back(255);
  }
  return bytes;
}

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::size_t pixelCount(const Layers& layers) {
  return static_cast<std::size_t>(layers.size.x) * static_cast<std::size_t>(layers.size.y);
}

/// A position along a ray as the passes store it, in mm from the eye.
float timeOf(const PassChain& chain, float position) {
  return isSomething(position) ? static_cast<float>(chain.rays->distance() + position) : nan;
}

void readTimes(const PassChain& chain, const gl::Texture& texture, std::vector<float>& into, std::size_t count) {
  into.resize(count);
  texture.readInto(std::span(into));
  for (float& value : into) value = timeOf(chain, value);
}

/// Where a chain's rays meet context and focus and where they start.
Layers rayStartsOf(PassChain& s) {
  Layers layers;
  layers.size = s.rays->size();
  if (!s.hitPoints || s.exploded) return layers;
  const std::size_t count = pixelCount(layers);
  std::vector<glm::vec2> hits(count);
  s.hitsToOpen().readInto(std::span(hits));
  for (const glm::vec2& hit : hits) {
    layers.tContext.push_back(timeOf(s, hit.x));
    layers.tFocus.push_back(timeOf(s, hit.y));
  }
  readTimes(s, s.rayStart, layers.tStart, count);
  return layers;
}

}  // namespace

Renderer::Opening Renderer::readOpening() {
  PassChain& s = *chain_;
  if (!s.picture()) return {};
  PassChain& cuts = s.opening ? *s.opening : s;
  return {cuts.rays->camera(), rayStartsOf(cuts)};
}

Layers Renderer::readLayers() {
  PassChain& s = *chain_;
  if (!s.picture()) return {};
  Layers layers = rayStartsOf(s);
  const std::size_t count = pixelCount(layers);
  if (s.focusFilled) readTimes(s, s.focusFilled, layers.tFocusFilled, count);
  if (s.distances) {
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
  if (s.lensSurface) {
    layers.lens.resize(count);
    s.lensSurface.readInto(std::span(layers.lens));
    for (glm::vec4& texel : layers.lens)
      if (!isSomething(texel.w)) texel.w = nan;
  }
  layers.focusLayer.resize(count);
  s.focusLayer.readInto(std::span(layers.focusLayer));
  if (s.faintLayer) {
    layers.faintLayer.resize(count);
    s.faintLayer.readInto(std::span(layers.faintLayer));
  }
  if (s.protectedLayer) {
    layers.protectedLayer.resize(count);
    s.protectedLayer.readInto(std::span(layers.protectedLayer));
  }
  if (s.wallLayer) {
    layers.walls.resize(count);
    s.wallLayer.readInto(std::span(layers.walls));
  }
  layers.final = layers.focusLayer;
  if (&s.picture() != &s.focusLayer) s.picture().readInto(std::span(layers.final));
  return layers;
}

std::optional<PickedPlace> Renderer::pickPlace(glm::dvec2 pixel) {
  PassChain& s = *chain_;
  const glm::ivec2 at(glm::floor(pixel));
  if (!s.shows(at)) return std::nullopt;
  const auto place = [&](float position) { return s.rays->worldPosition(glm::dvec2(at) + 0.5, position); };
  const glm::dvec3 ray = glm::normalize(place(1.0f) - place(0.0f));
  if (s.exploded) {
    const std::optional<glm::dvec3> inPart = s.pickExploded(at);
    return inPart ? std::optional(PickedPlace{*inPart, ray}) : std::nullopt;
  }
  const float position = s.startAt(at);
  if (!isSomething(position)) return std::nullopt;
  return s.peeled ? s.pickPeeled(place(position), ray) : PickedPlace{place(position), ray};
}

std::optional<glm::dvec3> Renderer::pick(glm::dvec2 pixel) {
  const std::optional<PickedPlace> picked = pickPlace(pixel);
  return picked ? std::optional(picked->place) : std::nullopt;
}

bool Renderer::movesContext() const { return chain_->exploded || chain_->peeled; }

glm::dvec3 Renderer::shownAt(glm::dvec3 world) const { return chain_->movedPosition(world); }

std::optional<BrushPoint> Renderer::pickBrush(glm::dvec2 pixel, BrushMode mode, std::optional<glm::dvec3> before) {
  PassChain& s = *chain_;
  const glm::ivec2 at(glm::floor(pixel));
  if (!s.shows(at) || movesContext()) return std::nullopt;
  const glm::vec2 hit = s.hitAt(at);
  const float context = hit.x, start = s.startAt(at);
  float position = context;
  if (mode == BrushMode::Open) {
    position = start;
    if (s.editMap && isSomething(position))
      position = std::max(context, position - std::max(0.0f, s.editMap.readTexel(at).x));
  }
  const RayFrame& rays = *s.rays;
  BrushPoint point;
  if (isSomething(position)) {
    // The surface under the pixel's centre, at the pixel's own place.
    const double depth = rays.depthOf(rays.worldPosition(glm::dvec2(at) + 0.5, position));
    point.anchor = rays.worldPositionAtDepth(pixel, depth);
    point.meetsFocus = isSomething(hit.y);
    point.removed = isSomething(start) ? std::max(0.0f, start - context) : 0.0;
    point.beforeFocus = point.meetsFocus && isSomething(start) ? std::max(0.0f, hit.y - start) : 0.0;
  } else if (before) {
    point.hitsContext = false;
    point.anchor = rays.worldPositionAtDepth(pixel, rays.depthOf(*before));
  } else {
    return std::nullopt;
  }
  point.pixelSize = rays.pixelSize(rays.depthOf(point.anchor)) * s.pixelScale;
  return point;
}

void Renderer::setTiming(bool on) { chain_->timing = on; }

const std::array<PassStats, passCount>& Renderer::stats() const { return *chain_->stats; }

namespace {

std::size_t imageBytesOf(const PassChain& s) {
  std::size_t sum = s.pullPushPass.bytes() + s.conePass.bytes() + s.distanceMapPass.bytes() + s.editMapPass.bytes() +
                    s.focusLayerPass.bytes() + s.lensPass.bytes() + s.wallPass.bytes() + s.occlusionPass.bytes() +
                    s.occlusionNodes.bytes();
  for (const gl::Texture* texture :
       {&s.hitPoints,  &s.focusFilled, &s.coneStart,      &s.distances,    &s.editMap,    &s.rayStart,
        &s.focusLayer, &s.faintLayer,  &s.protectedLayer, &s.contextLayer, &s.silhouette, &s.lensSurface,
        &s.wallLayer,  &s.walledLayer, &s.walledPicture,  &s.composed,     &s.exempted,   &s.pickedHit,
        &s.faces,      &s.hole,        &s.openedHits})
    if (*texture) sum += texture->bytes();
  for (const gl::Texture& hits : s.importantHits)
    if (hits) sum += hits.bytes();
  if (s.edgeSamples) sum += s.edgeSamples->bytes();
  return s.opening ? sum + imageBytesOf(*s.opening) : sum;
}

}  // namespace

std::size_t Renderer::imageBytes() const { return imageBytesOf(*chain_); }

}  // namespace fenestra
