#include "rendering/reference/Occlusion.h"

#include "rendering/reference/Unknown.h"
#include "rendering/scene/Lighting.h"
#include "rendering/volume/Threads.h"

namespace fenestra::reference {
namespace {

/// The rays that an opening cuts, to ask how much of a point's surroundings they leave.
class CutRays {
 public:
  CutRays(const Camera& camera, glm::ivec2 size, const Image& context, const Image& start)
      : camera_(camera), axes_(camera.axes()), size_(size), context_(context), start_(start) {}

  /// `width` as in occlusion::visibleShare; `nearest`: a view depth before which nothing is removed, mm.
  double visibleShare(glm::dvec3 world, double width, double nearest) const {
    const bool perspective = camera_.projection == Projection::Perspective;
    const glm::dvec3 from = world - camera_.eye;
    const double depth = glm::dot(from, axes_.forward);
    if (!(depth >= (perspective ? nearest : 0.0))) return 1.0;
    const double halfHeight =
        perspective ? depth * std::tan(0.5 * glm::radians(camera_.verticalFov)) : 0.5 * camera_.orthographicHeight;
    const double perMillimetre = 0.5 * size_.y / halfHeight;
    const glm::dvec2 at(0.5 * size_.x + perMillimetre * glm::dot(from, axes_.right),
                        0.5 * size_.y - perMillimetre * glm::dot(from, axes_.up));
    if (!(at.x >= 0.0 && at.y >= 0.0 && at.x < size_.x && at.y < size_.y)) return 1.0;
    const glm::ivec2 pixel(at);
    const std::size_t offset =
        static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(pixel.x);
    if (std::isnan(start_[offset])) return 1.0;
    const double t = depth / glm::dot(pixelRay(camera_, size_, pixel).direction, axes_.forward);
    return occlusion::visibleShare(t, start_[offset], context_[offset], width);
  }

 private:
  const Camera& camera_;
  Camera::Axes axes_;
  glm::ivec2 size_;
  const Image &context_, &start_;
};

std::size_t offsetIn(glm::ivec3 dims, glm::ivec3 cell) {
  Grid lattice;
  lattice.dims = dims;
  return lattice.offset(cell);
}

}  // namespace

double OccludingMedium::at(glm::ivec3 cell) const { return extinction[offsetIn(dims, cell)]; }

double OccludingMedium::sideLength() const { return std::cbrt(grid.voxelVolume() * side.x * side.y * side.z); }

double OccludingMedium::transmittance(glm::ivec3 cell, glm::dvec3 direction, const occlusion::Weight& weight) const {
  const glm::dvec3 along = glm::dmat3(grid.indexFromWorld()) * direction / glm::dvec3(side);
  const glm::dvec3 from = glm::dvec3(cell) + 0.5;
  glm::ivec3 at = cell;
  double t = 0.0, depth = 0.0;
  while (glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, dims)) && t < weight.fadeTo) {
    double next = infinity;
    int exit = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (along[axis] == 0.0) continue;
      const double face = (at[axis] + (along[axis] > 0.0 ? 1.0 : 0.0) - from[axis]) / along[axis];
      if (face < next) {
        next = face;
        exit = axis;
      }
    }
    const double to = std::max(t, std::min(next, weight.fadeTo));
    depth += this->at(at) * (weight.upTo(to) - weight.upTo(t));
    t = to;
    at[exit] += along[exit] > 0.0 ? 1 : -1;
  }
  return std::exp(-depth);
}

double OccludingMedium::meanTransmittance(glm::ivec3 cell, const std::vector<glm::dvec3>& directions,
                                          const occlusion::Weight& weight) const {
  double sum = 0.0;
  for (const glm::dvec3& direction : directions) sum += transmittance(cell, direction, weight);
  return sum / static_cast<double>(directions.size());
}

OccludingMedium occludingMedium(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages* stages) {
  const OccluderCells cells = occluderCells(scene);
  OccludingMedium medium{scene.volume->grid, cells.dims, cells.side, std::vector<double>(cells.extinction.size(), 0.0)};
  const Grid& grid = medium.grid;
  const double width = 0.5 * medium.sideLength();
  const std::vector<HalfSpace> kept = halfSpaces(scene.look.clipping, grid);
  std::optional<CutRays> cut;
  double nearest = 0.0;
  if (stages) {
    const auto& apart = stages->apart;
    const Camera& cuts = apart ? apart->opening.camera : camera;
    cut.emplace(cuts, apart ? apart->opening.size : size, apart ? apart->openingContext : stages->hits.tContext,
                apart ? apart->openingStart : stages->tStart);
    nearest = 1e-3 * std::max(glm::dot(grid.centre() - cuts.eye, cuts.axes().forward), grid.boundingRadius());
  }
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  parallelFor(static_cast<std::size_t>(cells.dims.z), 1, [&](std::size_t begin, std::size_t end) {
    glm::ivec3 cell;
    for (cell.z = static_cast<int>(begin); cell.z < static_cast<int>(end); ++cell.z)
      for (cell.y = 0; cell.y < cells.dims.y; ++cell.y)
        for (cell.x = 0; cell.x < cells.dims.x; ++cell.x) {
          const std::size_t offset = offsetIn(cells.dims, cell);
          const OccluderCells::Extinction& of = cells.extinction[offset];
          double sum = 0.0;
          for (int i = 0; i < 8; ++i) {
            const glm::dvec3 place = (glm::dvec3(cell) + occlusion::pointInCell(i)) * glm::dvec3(cells.side) - 0.5;
            const glm::dvec3 world(worldFromIndex * glm::dvec4(place, 1.0));
            double inside = 1.0;
            for (const HalfSpace& each : kept) inside *= occlusion::clippedShare(each.distance(world), width);
            const double left = cut ? cut->visibleShare(world, width, nearest) : 1.0;
            sum += inside * (left * of.context + of.kept) + (1.0 - inside) * of.exempt;
          }
          medium.extinction[offset] = sum / 8.0;
        }
  });
  return medium;
}

Occlusion::Occlusion(const Scene& scene, const Camera& camera, glm::ivec2 size, const Stages* stages)
    : Occlusion(occludingMedium(scene, camera, size, stages), scene.look.shading,
                lightDirection(camera.axes(), scene.look.shading)) {}

Occlusion::Occlusion(OccludingMedium medium, const Shading& shading, glm::dvec3 light,
                     const occlusion::Directions& directions)
    : medium_(std::move(medium)),
      shading_(shading),
      around_(occlusion::allAround(directions.around)),
      towardsLight_(occlusion::towards(light, occlusion::lightRadius, directions.towardsLight)),
      nodes_(std::make_unique<std::atomic<double>[]>(2 * medium_.extinction.size())) {
  for (std::size_t i = 0; i < 2 * medium_.extinction.size(); ++i) nodes_[i] = unknown;
}

glm::dvec2 Occlusion::compute(glm::ivec3 cell) const {
  bool needed = false;
  for (int i = 0; i < 27; ++i)
    needed |=
        medium_.at(glm::clamp(cell + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1, glm::ivec3(0), medium_.dims - 1)) > 0.0;
  glm::dvec2 open(1.0);
  if (!needed) return open;
  const double side = medium_.sideLength();
  if (shading_.occlusion > 0.0) {
    const double mean = medium_.meanTransmittance(cell, around_, occlusion::nearWeight(side));
    open.x -= shading_.occlusion * (1.0 - std::min(2.0 * mean, 1.0));
  }
  if (shading_.shadow > 0.0)
    open.y -= shading_.shadow * (1.0 - medium_.meanTransmittance(cell, towardsLight_, occlusion::farWeight(side)));
  return open;
}

glm::dvec2 Occlusion::atNode(glm::ivec3 cell) const {
  std::atomic<double>* node = &nodes_[2 * offsetIn(medium_.dims, cell)];
  glm::dvec2 open(node[0].load(), node[1].load());
  if (std::isnan(open.x) || std::isnan(open.y)) {
    open = compute(cell);
    node[0] = open.x;
    node[1] = open.y;
  }
  return open;
}

glm::dvec2 Occlusion::at(glm::dvec3 index) const {
  const glm::dvec3 place =
      glm::clamp((index + 0.5) / glm::dvec3(medium_.side) - 0.5, glm::dvec3(0.0), glm::dvec3(medium_.dims - 1));
  const glm::ivec3 low = glm::min(glm::ivec3(place), glm::max(medium_.dims - 2, 0));
  std::array<glm::dvec2, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[static_cast<std::size_t>(i)] =
        atNode(glm::min(low + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2), medium_.dims - 1));
  return interpolate(corners, place - glm::dvec3(low));
}

void Occlusion::appendCrossings(const Piece& piece, std::vector<double>& places) const {
  for (int axis = 0; axis < 3; ++axis) {
    const double side = medium_.side[axis], way = piece.end[axis] - piece.begin[axis];
    const auto nodeAt = [&](double within) { return (piece.cell[axis] + within + 0.5) / side - 0.5; };
    const auto [low, high] = std::minmax({nodeAt(piece.begin[axis]), nodeAt(piece.end[axis])});
    for (double plane = std::ceil(low); plane <= high; plane += 1.0) {
      const double s = ((plane + 0.5) * side - 0.5 - piece.cell[axis] - piece.begin[axis]) / way;
      if (s > 0.0 && s < 1.0) places.push_back(s);
    }
  }
}

}  // namespace fenestra::reference
