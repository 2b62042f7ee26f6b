#include "app/cli/QualityMap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "io/ImageWriter.h"
#include "rendering/viewpoints/Sphere.h"

namespace fenestra::cli {
namespace {

constexpr glm::ivec2 mapSize{720, 360};

/// Dark violet to yellow over blue and green: evenly brighter, and distinct to colour-blind eyes.
glm::dvec3 ramp(double t) {
  static const std::array<glm::dvec3, 5> stops{glm::dvec3(68, 1, 84), glm::dvec3(59, 82, 139), glm::dvec3(33, 145, 140),
                                               glm::dvec3(94, 201, 98), glm::dvec3(253, 231, 37)};
  const double at = std::clamp(t, 0.0, 1.0) * 4.0;
  const std::size_t below = std::min<std::size_t>(3, static_cast<std::size_t>(at));
  return glm::mix(stops[below], stops[below + 1], at - static_cast<double>(below));
}

glm::dvec3 directionAt(glm::ivec2 pixel) {
  const double azimuth = ((pixel.x + 0.5) / mapSize.x - 0.5) * 2.0 * std::numbers::pi;
  const double elevation = (0.5 - (pixel.y + 0.5) / mapSize.y) * std::numbers::pi;
  return {std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
}

}  // namespace

void writeQualityMap(const std::filesystem::path& path, const placement::Measured& measured,
                     const placement::Options& options, const placement::Placement& placement) {
  std::vector<double> qualities;
  double least = 1e300, greatest = -1e300;
  for (std::size_t i = 0; i < measured.spread; ++i) {
    qualities.push_back(worth(measured.candidates[i].descriptors, options));
    if (measured.candidates[i].sums.count <= 0.0) continue;
    least = std::min(least, qualities.back());
    greatest = std::max(greatest, qualities.back());
  }
  const auto nside = measured.coarser == 0 ? placement::sideOf(static_cast<int>(measured.spread)) : std::nullopt;
  constexpr double markRadius = 0.05, outline = 0.02;  // radians
  std::vector<std::uint8_t> pixels;
  for (int y = 0; y < mapSize.y; ++y)
    for (int x = 0; x < mapSize.x; ++x) {
      const glm::dvec3 direction = directionAt({x, y});
      std::size_t nearest = nside ? static_cast<std::size_t>(placement::ringPixel(*nside, direction)) : 0;
      double cosine = nside ? 2.0 : -2.0;  // of a refinement, the one whose direction is nearest
      for (std::size_t i = 0; cosine < 2.0 && i < measured.spread; ++i)
        if (const double c = glm::dot(direction, measured.candidates[i].direction); c > cosine) {
          cosine = c;
          nearest = i;
        }
      glm::dvec3 colour(90.0);
      if (measured.candidates[nearest].sums.count > 0.0)
        colour = ramp(greatest > least ? (qualities[nearest] - least) / (greatest - least) : 1.0);
      const auto mark = [&](std::optional<std::size_t> camera, bool filled) {
        if (!camera) return;
        const double angle =
            std::acos(std::clamp(glm::dot(direction, measured.candidates[*camera].direction), -1.0, 1.0));
        if (angle <= markRadius + outline && angle > markRadius) colour = glm::dvec3(0.0);
        if (angle <= markRadius && (filled || angle > markRadius - outline)) colour = glm::dvec3(255.0);
      };
      mark(placement.c2, false);
      mark(placement.c1, true);
      for (int channel = 0; channel < 3; ++channel)
        pixels.push_back(static_cast<std::uint8_t>(std::lround(colour[channel])));
    }
  io::writePng(path, mapSize, 3, pixels);
}

}  // namespace fenestra::cli
