#include "rendering/placement/CandidateImages.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "rendering/passes/SceneBinding.h"

namespace fenestra::placement {
namespace {

enum Block : unsigned { candidatesBlock = 2, tilesBlock = 3, partialsBlock = 4, totalsBlock = 5 };

/// As the shaders declare them (std430).
struct Axes {
  glm::vec4 right, up, forward;
};
struct Sums {
  glm::vec4 sums;
  glm::ivec4 box;
};
struct SurfacePoint {
  glm::vec4 position, facing;
};

/// Tiles traced in one go: 64 bytes of sums each, and no dispatch so long that a window manager takes the GPU for hung.
constexpr std::size_t tilesPerBatch = 1 << 16;
constexpr int tileSide = 8;
/// Work groups in a row of a dispatch; the shaders count on it.
constexpr int groupsPerRow = 1024;

glm::ivec2 groupsFor(std::size_t count) {
  const int groups = static_cast<int>(count);
  return {std::min(groups, groupsPerRow), (groups + groupsPerRow - 1) / groupsPerRow};
}

template <class T>
gl::Buffer bufferOf(const std::vector<T>& values) {
  return gl::Buffer(std::as_bytes(std::span(values)));
}

gl::Buffer axesBuffer(const Grid& grid, const std::vector<Candidate>& candidates) {
  const glm::dmat3 cellsFromWorld(grid.indexFromWorld());
  std::vector<Axes> axes;
  for (const Candidate& candidate : candidates) {
    const Camera::Axes world = axesAt(candidate.direction);
    axes.push_back({glm::vec4(cellsFromWorld * world.right, 0.0), glm::vec4(cellsFromWorld * world.up, 0.0),
                    glm::vec4(cellsFromWorld * world.forward, 0.0)});
  }
  return bufferOf(axes);
}

/// First and last tile (column and row) that the focus's box projects onto, half a voxel wider than its voxels: the 0.5
/// level reaches no farther.
struct TileRange {
  glm::ivec2 low{0}, high{-1};
};
TileRange tilesOf(const Grid& grid, const IndexBox& box, const Camera::Axes& axes, int side) {
  const glm::dmat4 worldFromIndex = grid.worldFromIndex();
  const glm::dvec3 centre = grid.centre();
  const double radius = grid.boundingRadius();
  glm::dvec2 low(1e300), high(-1e300);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 index((corner & 1) ? box.high.x + 1.0 : box.low.x - 1.0,
                           (corner & 2) ? box.high.y + 1.0 : box.low.y - 1.0,
                           (corner & 4) ? box.high.z + 1.0 : box.low.z - 1.0);
    const glm::dvec3 offset = glm::dvec3(worldFromIndex * glm::dvec4(index, 1.0)) - centre;
    const glm::dvec2 pixel =
        (glm::dvec2(glm::dot(offset, axes.right), -glm::dot(offset, axes.up)) / radius + 1.0) * (0.5 * side);
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }
  const int last = (side + tileSide - 1) / tileSide - 1;
  return {glm::clamp(glm::ivec2(glm::floor(low)) / tileSide, 0, last),
          glm::clamp(glm::ivec2(glm::floor(high)) / tileSide, 0, last)};
}

}  // namespace

std::vector<Candidate> CandidateImages::measure(const GpuScene& gpu, const std::vector<glm::dvec3>& directions,
                                                const FocusSurface& surface, int side) {
  std::vector<Candidate> candidates(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) candidates[i].direction = directions[i];
  if (gpu.focus().box && !directions.empty()) {
    measureImages(gpu, candidates, side);
    if (!surface.points.empty()) measureVisibility(gpu, surface, candidates);
  }
  for (Candidate& candidate : candidates) candidate.descriptors = describe(candidate.sums, side, candidate.direction);
  return candidates;
}

void CandidateImages::setSphere(const GpuScene& gpu, gl::ShaderProgram& program) const {
  const Grid& grid = gpu.grid();
  program.set("volumeDims", grid.dims);
  program.set("sphereCentre", (glm::vec3(grid.dims) + 1.0f) * 0.5f);  // index (dims-1)/2 in the cell frame
  program.set("sphereRadius", static_cast<float>(grid.boundingRadius()));
}

void CandidateImages::measureImages(const GpuScene& gpu, std::vector<Candidate>& candidates, int side) {
  const gl::Buffer axes = axesBuffer(gpu.grid(), candidates);
  for (std::size_t begin = 0; begin < candidates.size();) {
    // Whole candidates, until a batch is full.
    std::vector<glm::uvec2> tiles, ranges;
    std::size_t end = begin;
    for (; end < candidates.size() && (end == begin || tiles.size() < tilesPerBatch); ++end) {
      const TileRange range = tilesOf(gpu.grid(), *gpu.focus().box, axesAt(candidates[end].direction), side);
      const std::size_t first = tiles.size();
      for (int y = range.low.y; y <= range.high.y; ++y)
        for (int x = range.low.x; x <= range.high.x; ++x)
          tiles.emplace_back(static_cast<unsigned>(end), static_cast<unsigned>(x) | static_cast<unsigned>(y) << 16);
      ranges.emplace_back(static_cast<unsigned>(first), static_cast<unsigned>(tiles.size() - first));
    }
    const gl::Buffer partials = gl::Buffer::zeroed(tiles.size() * sizeof(Sums));
    {
      gl::ShaderProgram& program = tiles_.get({focusDefine(gpu)});
      setSphere(gpu, program);
      bindVolume(gpu, program);
      bindFocus(gpu, program);
      axes.bind(candidatesBlock);
      const gl::Buffer tileList = bufferOf(tiles);
      tileList.bind(tilesBlock);
      partials.bind(partialsBlock);
      program.set("tileCount", static_cast<int>(tiles.size()));
      program.set("side", side);
      program.dispatch(groupsFor(tiles.size()), {1, 1});
    }
    std::vector<Sums> totals(ranges.size());
    const gl::Buffer result = gl::Buffer::zeroed(totals.size() * sizeof(Sums));
    gl::ShaderProgram& program = sums_.get();
    const gl::Buffer rangeList = bufferOf(ranges);
    rangeList.bind(tilesBlock);
    partials.bind(partialsBlock);
    result.bind(totalsBlock);
    program.set("candidateCount", static_cast<int>(ranges.size()));
    program.dispatch(groupsFor(ranges.size()), {1, 1});
    result.read(std::as_writable_bytes(std::span(totals)));
    for (std::size_t i = 0; i < totals.size(); ++i) {
      ImageSums& sums = candidates[begin + i].sums;
      sums.count = totals[i].sums.x;
      if (sums.count <= 0.0) continue;
      sums.depth = totals[i].sums.y;
      sums.position = glm::dvec2(totals[i].sums.z, totals[i].sums.w);
      sums.box = totals[i].box;
    }
    begin = end;
  }
}

void CandidateImages::measureVisibility(const GpuScene& gpu, const FocusSurface& surface,
                                        std::vector<Candidate>& candidates) {
  const Grid& grid = gpu.grid();
  const glm::dmat3 cellsFromWorld(grid.indexFromWorld());
  const glm::dmat3 steps(grid.worldFromIndex());
  std::vector<SurfacePoint> points;
  for (const FocusSurface::Point& point : surface.points) {
    // Lifted a little, and rays start a voxel towards the camera: the steps of a voxelised surface must not hide it
    // from itself.
    double extent = 0.0;
    for (int axis = 0; axis < 3; ++axis) extent += std::abs(glm::dot(steps[axis], point.normal));
    const glm::dvec3 lifted = point.index + cellsFromWorld * point.normal * (0.25 * extent) + 1.0;
    // facing · (cells per mm along d) = normal · d: the inverse transpose takes a normal along.
    const glm::dvec3 facing = glm::transpose(glm::inverse(cellsFromWorld)) * point.normal;
    points.push_back({glm::vec4(glm::vec3(lifted), 0.0f), glm::vec4(glm::vec3(facing), 0.0f)});
  }
  gl::ShaderProgram& program = visibility_.get({focusDefine(gpu)});
  setSphere(gpu, program);
  bindVolume(gpu, program);
  bindFocus(gpu, program);
  const gl::Buffer axes = axesBuffer(grid, candidates), list = bufferOf(points);
  axes.bind(candidatesBlock);
  list.bind(tilesBlock);
  const glm::ivec2 size(static_cast<int>(points.size()), static_cast<int>(candidates.size()));
  gl::Texture seen = gl::Texture::make2D(gl::Format::R8UI, size);
  seen.bindImage(0, gl::Access::Write);
  program.set("pointCount", size.x);
  program.set("clearance", static_cast<float>(std::max({grid.spacing.x, grid.spacing.y, grid.spacing.z})));
  program.dispatch(size);
  std::vector<std::uint8_t> bytes(points.size() * candidates.size());
  seen.readInto(std::span(bytes));
  const std::size_t words = (points.size() + 63) / 64;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    candidates[c].seen.assign(words, 0);
    for (std::size_t o = 0; o < points.size(); ++o)
      if (bytes[c * points.size() + o]) candidates[c].seen[o / 64] |= std::uint64_t{1} << (o % 64);
  }
}

}  // namespace fenestra::placement
