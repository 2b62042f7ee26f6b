#include "rendering/reference/Walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rendering/scene/Walls.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

/// A wall with what is drawn on it, in mm from its first voxel: x along its rows, y across them.
struct Drawn {
  Wall wall;
  glm::dvec3 alongX, alongY, normal;  ///< world, unit
  double width;                       ///< of lines, mm
  struct Line {
    glm::dvec3 colour;
    std::vector<std::array<glm::dvec2, 2>> pieces;
  };
  std::vector<Line> lines;

  glm::dvec2 mmOf(glm::dvec3 world) const {
    return {glm::dot(world - wall.origin, alongX), glm::dot(world - wall.origin, alongY)};
  }
  /// Voxels along the two sides, from mm.
  glm::dvec2 placeOf(glm::dvec2 mm) const {
    const double v = mm.y / glm::dot(wall.down, alongY);
    return {(mm.x - v * glm::dot(wall.down, alongX)) / glm::length(wall.right), v};
  }
};

Drawn drawnOn(const Wall& wall, const Scene& scene, const ShownSlices& slices) {
  const Grid& grid = scene.volume->grid;
  Drawn drawn{wall, glm::normalize(wall.right), {}, glm::normalize(glm::cross(wall.right, wall.down)), 0.0, {}};
  drawn.alongY = glm::cross(drawn.normal, drawn.alongX);
  drawn.width = lineWidth(wall, grid);
  for (const WallLine& line : linesOn(wall, *wallsOf(scene.look), scene, slices)) {
    Drawn::Line& made = drawn.lines.emplace_back(Drawn::Line{line.colour, {}});
    for (const WallLine::Piece& piece : line.pieces)
      made.pieces.push_back({drawn.mmOf(wall.worldFromPlace(piece.from)), drawn.mmOf(wall.worldFromPlace(piece.to))});
  }
  return drawn;
}

double distanceTo(const std::array<glm::dvec2, 2>& piece, glm::dvec2 point) {
  const glm::dvec2 along = piece[1] - piece[0];
  const double square = glm::dot(along, along);
  const double share = square > 0.0 ? std::clamp(glm::dot(point - piece[0], along) / square, 0.0, 1.0) : 0.0;
  return glm::distance(point, piece[0] + share * along);
}

/// How far a point of the wall's plane lies inwards from the nearest of the rim's four edges, mm.
double inwards(const Drawn& drawn, glm::dvec2 mm) {
  const auto corner = [&](double u, double v) { return drawn.mmOf(drawn.wall.worldFromPlace({u, v})); };
  const glm::dvec2 end = glm::dvec2(drawn.wall.size) - 0.5;
  const std::array<glm::dvec2, 4> corners{corner(-0.5, -0.5), corner(end.x, -0.5), corner(end.x, end.y),
                                          corner(-0.5, end.y)};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 edge = glm::normalize(corners[(i + 1) % 4] - corners[i]), from = mm - corners[i];
    least = std::min(least, edge.x * from.y - edge.y * from.x);
  }
  return least;
}

double greyOf(double value, const Volume& volume, const ShownSlices& slices) {
  const WindowLevel window = slices.window ? *slices.window : volume.defaultWindow();
  const double grey = std::clamp((value - window.level) / window.width + 0.5, 0.0, 1.0);
  return volume.lowIsWhite != slices.inverted ? 1.0 - grey : grey;
}

glm::dvec3 withLines(glm::dvec3 colour, const Drawn& drawn, glm::dvec2 mm, double pixel) {
  const double half = 0.5 * drawn.width, box = std::min(pixel, drawn.width);
  for (const Drawn::Line& line : drawn.lines) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& piece : line.pieces) nearest = std::min(nearest, distanceTo(piece, mm));
    const double low = std::max(nearest - 0.5 * box, -half), high = std::min(nearest + 0.5 * box, half);
    colour = glm::mix(colour, line.colour, std::clamp((high - low) / box, 0.0, 1.0));
  }
  return colour;
}

/// Width of a pixel in mm at the view depth of a point.
double pixelWidth(const Camera& camera, glm::ivec2 size, glm::dvec3 world) {
  if (camera.projection == Projection::Orthographic) return camera.orthographicHeight / size.y;
  const double depth = glm::dot(world - camera.eye, camera.axes().forward);
  return 2.0 * depth * std::tan(0.5 * glm::radians(camera.verticalFov)) / size.y;
}

}  // namespace

std::vector<glm::dvec4> wallColours(const Scene& scene, const Camera& camera, glm::ivec2 size, const ShownSlices& given,
                                    const std::vector<WallRay>& rays) {
  const Volume& volume = *scene.volume;
  ShownSlices slices = given;
  if (!slices.window) slices.window = volume.defaultWindow();
  std::vector<Drawn> walls;
  for (const Wall& wall : wallsAt(*wallsOf(scene.look), volume.grid, slices, camera))
    walls.push_back(drawnOn(wall, scene, slices));
  std::vector<glm::dvec4> colours(rays.size(), glm::dvec4(0.0));
  withValues(ShownVolume{scene.volume}, [&](const auto& valueAt) {
    parallelFor(rays.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto& [ray, shown] = rays[i];
        double nearest = shown ? shown->tOut : std::numeric_limits<double>::infinity();
        for (const Drawn& drawn : walls) {
          const double t =
              glm::dot(drawn.wall.origin - ray.origin, drawn.normal) / glm::dot(ray.direction, drawn.normal);
          if (!(t >= (shown ? shown->tIn : 0.0) && t < nearest)) continue;
          const glm::dvec3 world = ray.origin + t * ray.direction;
          const double pixel = pixelWidth(camera, size, world);
          const glm::dvec2 mm = drawn.mmOf(world);
          const double opacity = std::clamp(0.5 + inwards(drawn, mm) / pixel, 0.0, 1.0);
          if (!(opacity > 0.0)) continue;
          nearest = t;
          const glm::dvec2 place = glm::clamp(drawn.placeOf(mm), glm::dvec2(-0.5), glm::dvec2(drawn.wall.size) - 0.5);
          const glm::dvec3 index = drawn.wall.indexFromPlace(place);
          const double grey = greyOf(interpolated(volume.grid, index, valueAt), volume, slices);
          const glm::dvec2 inside = drawn.mmOf(drawn.wall.worldFromPlace(place));
          colours[i] = glm::dvec4(withLines(glm::dvec3(grey), drawn, inside, pixel), 1.0) * opacity;
        }
      }
    });
  });
  return colours;
}

}  // namespace fenestra::reference
