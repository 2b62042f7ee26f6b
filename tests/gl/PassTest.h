#pragma once
// Shared by the tests of single passes: images made from numbers and read back, sizes and parts of pictures that no
// group of invocations divides, and both schedules.

#include <array>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "rendering/gl/Texture.h"
#include "rendering/gpu/RayFrame.h"
#include "rendering/gpu/Schedule.h"
#include "rendering/passes/HitPointPass.h"
#include "rendering/passes/Steps.h"
#include "tests/gl/GlTest.h"

namespace fenestra::tests {

inline constexpr std::array schedules{Schedule::Plain, Schedule::Llvmpipe};
/// One pixel, one row, one column, and sizes that neither groups of 8×8 nor words and tiles of 32 pixels divide.
inline constexpr std::array<glm::ivec2, 5> awkwardSizes{
    {glm::ivec2(1, 1), glm::ivec2(1, 37), glm::ivec2(41, 1), glm::ivec2(33, 17), glm::ivec2(101, 64)}};

inline std::size_t pixelsIn(glm::ivec2 size) {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
}
inline std::size_t offsetOf(glm::ivec2 pixel, glm::ivec2 size) {
  return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(pixel.x);
}
/// The inverse.
inline glm::ivec2 pixelAt(std::size_t offset, glm::ivec2 size) {
  const int at = static_cast<int>(offset);
  return {at % size.x, at / size.x};
}

inline std::string named(Schedule schedule, glm::ivec2 size) {
  return std::string(nameOf(schedule)) + ", " + std::to_string(size.x) + "×" + std::to_string(size.y);
}

/// Runs a pass at once.
template <class P, class... Args>
void runWhole(P&& pass, Args&&... args) {
  Steps steps;
  pass.run(steps, std::forward<Args>(args)...);
  EXPECT_TRUE(steps.advance());
}

/// Runs a pass in tiles as small as they get.
template <class P, class... Args>
void runInTiles(P&& pass, Args&&... args) {
  Steps steps;
  pass.run(steps, std::forward<Args>(args)...);
  while (!steps.advance(0.0)) {
  }
}

template <class T>
gl::Format formatFor() {
  if constexpr (std::is_same_v<T, glm::vec4>) return gl::Format::RGBA32F;
  if constexpr (std::is_same_v<T, glm::vec2>) return gl::Format::RG32F;
  if constexpr (std::is_same_v<T, float>) return gl::Format::R32F;
}

template <class T>
gl::Texture imageOf(const std::vector<T>& texels, glm::ivec2 size) {
  gl::Texture image = gl::Texture::make2D(formatFor<T>(), size);
  image.upload(std::span(texels));
  return image;
}

/// The value of an image's pixels before a pass. No pass writes it, so that a pixel that is left out shows.
inline constexpr float unwritten = -12345.0f;
template <class T>
gl::Texture blank(glm::ivec2 size) {
  return imageOf(std::vector<T>(pixelsIn(size), T(unwritten)), size);
}

template <class T>
std::vector<T> texelsOf(const gl::Texture& image) {
  std::vector<T> texels(pixelsIn(glm::ivec2(image.size())));
  image.readInto(std::span(texels));
  return texels;
}

inline std::vector<gl::Region> whole(glm::ivec2 size) { return {{glm::ivec2(0), size}}; }

/// Disjoint parts of odd sizes that make up the picture.
inline std::vector<gl::Region> parts(glm::ivec2 size) {
  constexpr glm::ivec2 step(29, 13);
  std::vector<gl::Region> regions;
  for (glm::ivec2 at(0); at.y < size.y; at.y += step.y)
    for (at.x = 0; at.x < size.x; at.x += step.x) regions.push_back({at, glm::min(step, size - at)});
  return regions;
}

/// A run over parts, all at once and one by one, makes the same image as a run over the whole.
/// `run` draws regions into an image; `expected` is the whole one's.
template <class T, class Run>
void expectPartsMakeTheWhole(const std::vector<T>& expected, glm::ivec2 size, const Run& run) {
  gl::Texture together = blank<T>(size), single = blank<T>(size);
  const std::vector<gl::Region> regions = parts(size);
  run(regions, together);
  for (const gl::Region& region : regions) run(std::vector{region}, single);
  EXPECT_TRUE(sameBits(texelsOf<T>(together), expected)) << "all parts at once";
  EXPECT_TRUE(sameBits(texelsOf<T>(single), expected)) << "one part after the other";
}

/// A run over one region writes its pixels and no more than the rest of its last groups of 8×8.
template <class T, class Run>
void expectOnlyTheRegionIsWritten(const std::vector<T>& expected, glm::ivec2 size, const Run& run) {
  const gl::Region region{size / 3, glm::max(size / 4, 1)};
  gl::Texture image = blank<T>(size);
  run(std::vector{region}, image);
  const std::vector<T> texels = texelsOf<T>(image);
  const glm::ivec2 end = region.origin + region.size, last = region.origin + (region.size + 7) / 8 * 8;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const glm::ivec2 pixel = pixelAt(i, size);
    const bool after = glm::all(glm::greaterThanEqual(pixel, region.origin));
    if (after && glm::all(glm::lessThan(pixel, end))) {
      EXPECT_EQ(texels[i], expected[i]) << pixel.x << ", " << pixel.y;
    } else if (!after || !glm::all(glm::lessThan(pixel, last))) {
      EXPECT_EQ(texels[i], T(unwritten)) << pixel.x << ", " << pixel.y;
    }
  }
}

/// t along the ray as the reference has it, from a position that a pass reads or writes; NaN for nothing.
inline double timeOf(float position, const RayFrame& rays) {
  return isSomething(position) ? rays.distance() + static_cast<double>(position) : nan;
}
inline reference::Image timesOf(const std::vector<float>& positions, const RayFrame& rays) {
  reference::Image times;
  for (const float position : positions) times.push_back(timeOf(position, rays));
  return times;
}
inline float positionOf(double time, const RayFrame& rays) {
  return std::isnan(time) ? nothing : static_cast<float>(time - rays.distance());
}

/// Hits as a pass reads them, and those values for the reference.
struct MadeHits {
  std::vector<glm::vec2> texels;
  reference::HitPoints truth;
};

enum class Where : std::uint8_t { Nowhere, Somewhere, Everywhere };
inline constexpr std::array everyWhere{Where::Nowhere, Where::Somewhere, Where::Everywhere};

/// Hits at random places on the rays that meet the box of a grid, the focus behind the context. With a focus somewhere
/// a tenth of these rays meets nothing, and the focus is a disc.
inline MadeHits madeHits(const Camera& camera, glm::ivec2 size, const Grid& grid, Where focus) {
  const RayFrame rays(camera, size, grid);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  MadeHits made;
  for (std::size_t i = 0; i < pixelsIn(size); ++i) {
    const glm::ivec2 pixel = pixelAt(i, size);
    const auto span = reference::clip(reference::pixelRay(camera, size, pixel), grid);
    const double first = share(random), second = share(random), missed = share(random);
    glm::vec2 hit(nothing);
    if (span && (focus != Where::Somewhere || missed > 0.1)) {
      const double context = glm::mix(span->tIn, span->tOut, 0.4 * first);
      hit.x = positionOf(context, rays);
      const double aside = glm::distance((glm::dvec2(pixel) + 0.5) / glm::dvec2(size), glm::dvec2(0.45, 0.5));
      if (focus == Where::Everywhere || (focus == Where::Somewhere && aside < 0.2))
        hit.y = positionOf(glm::mix(context, span->tOut, second), rays);
    }
    made.texels.push_back(hit);
    made.truth.tContext.push_back(timeOf(hit.x, rays));
    made.truth.tFocus.push_back(timeOf(hit.y, rays));
    made.truth.tOut.push_back(span ? span->tOut : nan);
  }
  return made;
}

}  // namespace fenestra::tests
