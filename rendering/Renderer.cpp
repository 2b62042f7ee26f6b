#include "rendering/Renderer.h"

#include <algorithm>
#include <span>
#include <utility>

#include "rendering/Enlargement.h"
#include "rendering/Picking.h"
#include "rendering/ReadLayers.h"
#include "rendering/gl/Context.h"
#include "rendering/gl/DrawTarget.h"

namespace fenestra {

struct Renderer::Parts {
  explicit Parts(std::shared_ptr<GpuScene> gpuScene) : chain(std::move(gpuScene)) {}
  Chain chain;
  Picking picking{chain};
};

Renderer::Renderer(std::shared_ptr<GpuScene> gpuScene) : parts_(std::make_unique<Parts>(std::move(gpuScene))) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::render(const Scene& scene, const View& view) {
  begin(scene, view);
  parts_->chain.advance(std::nullopt);
}

void Renderer::begin(const Scene& scene, const View& view) { parts_->chain.begin(scene, view); }

bool Renderer::advance(double milliseconds) { return parts_->chain.advance(milliseconds); }

void Renderer::drop() { parts_->chain.drop(); }

bool Renderer::isDrawing() const { return parts_->chain.isDrawing(); }

namespace {

bool isEnlarged(const gl::Texture& picture, glm::ivec2 size) {
  return picture.size().x < size.x || picture.size().y < size.y;
}

void drawOver(const Chain& chain, glm::ivec2 size) {
  const gl::Texture& picture = chain.picture();
  gl::ShaderProgram& program = chain.gpu().presentation(isEnlarged(picture, size));
  program.bind("picture", picture);
  program.set("background", chain.frame()->background);
  program.set("backgroundRise", chain.frame()->backgroundRise);
  program.drawFullScreen();
}

/// OpenGL's first row is the lowest.
void turnOver(std::vector<std::uint8_t>& pixels, glm::ivec2 size) {
  const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(size.x);
  for (std::ptrdiff_t top = 0, bottom = (size.y - 1) * row; top < bottom; top += row, bottom -= row)
    std::swap_ranges(pixels.begin() + top, pixels.begin() + top + row, pixels.begin() + bottom);
}

}  // namespace

glm::ivec2 Renderer::pictureSize() const { return parts_->chain.picture().size(); }

void Renderer::present(std::uint32_t framebuffer, glm::ivec4 rectangle) {
  if (!parts_->chain.picture()) return;
  const gl::DrawTarget target(framebuffer, rectangle);
  drawOver(parts_->chain, {rectangle.z, rectangle.w});
}

std::vector<std::uint8_t> Renderer::readPresented(glm::ivec2 size) {
  if (!parts_->chain.picture()) return {};
  const gl::Texture& picture = parts_->chain.picture();
  if (gl::isSoftwareRasteriser() && isEnlarged(picture, size)) {
    const Frame& frame = *parts_->chain.frame();
    std::vector<glm::vec4> values(picture.bytes() / sizeof(glm::vec4));
    picture.readInto(std::span(values));
    return enlarged(values, picture.size(), size, PlainBackground{frame.background, frame.backgroundRise});
  }
  const gl::Texture image = gl::Texture::make2D(gl::Format::BGRA8, size);
  {
    const gl::DrawTarget target(image);
    drawOver(parts_->chain, size);
  }
  std::vector<std::uint8_t> pixels(image.bytes());
  image.readInto(std::span(pixels));
  turnOver(pixels, size);
  return pixels;
}

std::vector<std::uint8_t> Renderer::readPicture() {
  const gl::Texture& picture = parts_->chain.picture();
  if (!picture) return {};
  const Frame& frame = *parts_->chain.frame();
  const auto width = static_cast<std::size_t>(picture.size().x), height = static_cast<std::size_t>(picture.size().y);
  std::vector<glm::vec4> values(width * height);
  picture.readInto(std::span(values));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(values.size() * 4);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const glm::vec4& front = values[i];
    const float above = 1.0f - (static_cast<float>(i / width) + 0.5f) / static_cast<float>(height);
    const glm::vec3 colour = glm::vec3(front) + (1.0f - front.a) * (frame.background + above * frame.backgroundRise);
    for (int channel = 0; channel < 3; ++channel)
      bytes.push_back(static_cast<std::uint8_t>(std::clamp(colour[channel], 0.0f, 1.0f) * 255.0f + 0.5f));
    bytes.push_back(255);
  }
  return bytes;
}

Renderer::Opening Renderer::readOpening() {
  if (!parts_->chain.picture()) return {};
  return {parts_->chain.frame()->cutting().rays.camera(), readOpeningOf(parts_->chain)};
}

Layers Renderer::readLayers() { return parts_->chain.picture() ? readLayersOf(parts_->chain) : Layers(); }

std::optional<PickedPlace> Renderer::pickPlace(glm::dvec2 pixel) { return parts_->picking.place(pixel); }

std::optional<glm::dvec3> Renderer::pick(glm::dvec2 pixel) {
  const std::optional<PickedPlace> picked = pickPlace(pixel);
  return picked ? std::optional(picked->place) : std::nullopt;
}

bool Renderer::movesContext() const { return parts_->picking.movesContext(); }

glm::dvec3 Renderer::shownAt(glm::dvec3 world) const { return parts_->picking.shownAt(world); }

std::optional<BrushPoint> Renderer::pickBrush(glm::dvec2 pixel, BrushMode mode, std::optional<glm::dvec3> before) {
  return parts_->picking.brushPoint(pixel, mode, before);
}

void Renderer::setTiming(bool on) { parts_->chain.setTiming(on); }

const std::array<PassStats, passCount>& Renderer::stats() const { return parts_->chain.stages().list.stats; }

std::size_t Renderer::imageBytes() const { return parts_->chain.stages().list.bytes() + parts_->picking.bytes(); }

}  // namespace fenestra
