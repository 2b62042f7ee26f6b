#include "rendering/placement/CandidateImages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "rendering/gpu/RayFrame.h"
#include "rendering/gpu/SceneBinding.h"
#include "rendering/viewpoints/Sphere.h"

namespace fenestra::placement {
namespace {

enum Block : unsigned {
  viewsBlock = 2,
  tilesBlock = 3,
  hitsBlock = 4,
  pointsBlock = 3,
  rangesBlock = 3,
  partialsBlock = 4,
  sumsBlock = 5,
  crossedBlock = 6,
  endsBlock = 6,
  crossingsBlock = 7
};

/// As the shaders declare them (std430).
struct View {
  glm::vec4 right, up, forward;
};
struct Tile {
  unsigned view;
  int x, y;
  unsigned neighbours;
};
struct Sums {
  glm::vec4 sums, more;
  glm::ivec4 box;
};
struct SurfacePoint {
  glm::vec4 position, facing;
};

/// Tiles of one dispatch: 1.5 KiB of hits and edges each. Short enough that no window system takes the GPU for hung.
constexpr std::size_t tilesPerBatch = 1 << 15;
constexpr int tileSide = 8;
constexpr std::size_t pixelsPerTile = tileSide * tileSide, edgesPerTile = 2 * pixelsPerTile;
/// Work groups in a row of a dispatch; the shaders use the same number.
constexpr int groupsPerRow = 1024;
/// Bisections between two pixel centres to locate the outline: the middle of the last interval is within 1/32 of a
/// pixel.
constexpr int outlineHalvings = 4;
/// The diagonal of the focus's box spans at least this many pixels, unless an image would have to be refined by more
/// than `mostFiner`.
constexpr double leastSpan = 48.0;
constexpr int mostFiner = 64;

glm::ivec2 groupsFor(std::size_t count) {
  const int groups = static_cast<int>(count);
  return {std::min(groups, groupsPerRow), (groups + groupsPerRow - 1) / groupsPerRow};
}

template <class T>
gl::Buffer bufferOf(const std::vector<T>& values) {
  return gl::Buffer(std::as_bytes(std::span(values)));
}

View viewOf(const Grid& grid, glm::dvec3 direction, bool twoSided) {
  const glm::dmat3 cellsFromWorld(grid.indexFromWorld());
  const Camera::Axes world = axesAt(direction);
  return {glm::vec4(cellsFromWorld * world.right, twoSided ? 1.0 : 0.0), glm::vec4(cellsFromWorld * world.up, 0.0),
          glm::vec4(cellsFromWorld * world.forward, 0.0)};
}

/// First and last pixel (column and row) around the projection of the focus's box, which is widened by half a voxel
/// around its voxels because the 0.5 level reaches no farther. One more pixel at the start, where the first marching
/// square begins.
struct PixelRange {
  glm::ivec2 low{0}, high{-1};
};
PixelRange pixelsOf(const Grid& grid, const IndexBox& box, const Camera::Axes& axes, int side) {
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
        (glm::dvec2(glm::dot(offset, axes.right), -glm::dot(offset, axes.up)) / radius + 1.0) * (0.5 * side) - 0.5;
    low = glm::min(low, pixel);
    high = glm::max(high, pixel);
  }
  return {glm::clamp(glm::ivec2(glm::floor(low)) - 1, -tileSide, side - 1),
          glm::clamp(glm::ivec2(glm::floor(high)) + 1, 0, side - 1)};
}

glm::ivec2 tilesOver(const PixelRange& pixels) { return (pixels.high - pixels.low) / tileSide + 1; }

void addTiles(std::vector<Tile>& tiles, unsigned view, const PixelRange& pixels) {
  const glm::ivec2 count = tilesOver(pixels);
  for (int row = 0; row < count.y; ++row)
    for (int column = 0; column < count.x; ++column)
      tiles.push_back(
          {view, pixels.low.x + column * tileSide, pixels.low.y + row * tileSide,
           (column + 1 < count.x ? 1u : 0u) | (row + 1 < count.y ? static_cast<unsigned>(count.x) << 1 : 0u)});
}

ImageSums fromFront(const Sums& total) {
  ImageSums sums;
  sums.count = total.sums.x;
  sums.depth = total.sums.y;
  sums.position = glm::dvec2(total.sums.z, total.sums.w);
  sums.ends = total.more.y;
  sums.box = total.box;
  return sums;
}

/// The sums of the opposite camera, whose outline is the mirror image.
ImageSums fromBehind(const ImageSums& front, glm::vec4 more, const Camera::Axes& axes, const Camera::Axes& opposite,
                     int side) {
  ImageSums sums = front;
  sums.depth = more.x;
  sums.ends = more.z;
  const glm::dvec3 world = front.position.x * axes.right + front.position.y * axes.up;
  sums.position = {glm::dot(world, opposite.right), glm::dot(world, opposite.up)};
  sums.box = {side - 1 - front.box.z, front.box.y, side - 1 - front.box.x, front.box.w};
  return sums;
}

void dispatchTiles(gl::ShaderProgram& program, std::size_t tiles, int side, glm::ivec2 groups) {
  program.set("tileCount", static_cast<int>(tiles));
  program.set("side", side);
  program.dispatch(groups, {1, 1});
}

/// Whether a depth is the shaders' mark for no hit.
bool isNone(float depth) { return depth < -1e29f; }

}  // namespace

/// Images of some views: where their rays meet the focus, and where the outlines between them run.
struct CandidateImages::Traced {
  std::size_t tileCount;
  gl::Buffer views, tiles, hits, crossed, crossings;

  Traced(const std::vector<View>& viewList, const std::vector<Tile>& tileList)
      : tileCount(tileList.size()),
        views(bufferOf(viewList)),
        tiles(bufferOf(tileList)),
        hits(gl::Buffer::zeroed(tileCount * pixelsPerTile * sizeof(glm::vec2))),
        crossed(gl::Buffer::zeroed((1 + tileCount * edgesPerTile) * sizeof(unsigned))),
        crossings(gl::Buffer::zeroed(tileCount * edgesPerTile * sizeof(float))) {}
};

int CandidateImages::sideFor(const GpuScene& gpu, int least) {
  if (!gpu.focus().box) return least;
  const Grid& grid = gpu.grid();
  const glm::dvec3 extent =
      glm::dmat3(grid.worldFromIndex()) * glm::dvec3(gpu.focus().box->high - gpu.focus().box->low + 1);
  const double pixels = glm::length(extent) * least / (2.0 * grid.boundingRadius());
  return least * std::clamp(static_cast<int>(std::ceil(leastSpan / pixels)), 1, mostFiner);
}

std::vector<Candidate> CandidateImages::measure(const GpuScene& gpu, const std::vector<glm::dvec3>& directions,
                                                const FocusSurface& surface, int side, bool endFaces,
                                                const std::vector<HalfSpace>& kept) {
  clip_ = {kept};
  std::vector<Candidate> candidates(directions.size());
  for (std::size_t i = 0; i < directions.size(); ++i) candidates[i].direction = directions[i];
  if (gpu.focus().box && !directions.empty()) {
    measureImages(gpu, candidates, side, endFaces);
    if (!surface.points.empty()) measureVisibility(gpu, surface, candidates);
  }
  for (Candidate& candidate : candidates) candidate.descriptors = describe(candidate.sums, side, candidate.direction);
  return candidates;
}

gl::ShaderProgram& CandidateImages::prepared(gl::ShaderVariants& programs, const GpuScene& gpu) {
  gl::ShaderProgram& program =
      programs.get(gl::Variant{{}, {scheduleChoice(gpu.schedule()), focusChoice(gpu), opaqueChoice(), clip_.choice()}} +
                   searchVariant(gpu));
  bindFirstHit(gpu, program);
  const Grid grid = gpu.drawnGrid();
  if (!clip_.kept.empty()) program.set(clip_.uniforms(grid));
  // The box widened by a voxel and clipped to the volume: the 0.5 level lies at most half a voxel outside the box.
  const glm::vec3 low(gpu.drawnCells(glm::dvec3(gpu.focus().box->low))),
      high(gpu.drawnCells(glm::dvec3(gpu.focus().box->high + 2)));
  program.set(CandidateUniforms{(glm::vec3(grid.dims) + 1.0f) * 0.5f,  // index (dims-1)/2 in the cell frame
                                static_cast<float>(grid.boundingRadius()), glm::max(low, 0.5f),
                                glm::min(high, glm::vec3(grid.dims) + 0.5f)});
  return program;
}

void CandidateImages::trace(const GpuScene& gpu, const Traced& traced, int side) {
  traced.views.bind(viewsBlock);
  traced.tiles.bind(tilesBlock);
  traced.hits.bind(hitsBlock);
  traced.crossed.bind(crossedBlock);
  traced.crossings.bind(crossingsBlock);
  const glm::ivec2 groupPerTile = groupsFor(traced.tileCount);
  dispatchTiles(prepared(hits_, gpu), traced.tileCount, side, groupPerTile);
  dispatchTiles(edges_.get(), traced.tileCount, side, groupPerTile);
  unsigned count = 0;
  traced.crossed.read(std::as_writable_bytes(std::span(&count, 1)));
  gl::ShaderProgram& outlines = prepared(outlines_, gpu);
  outlines.set("halvings", outlineHalvings);
  dispatchTiles(outlines, traced.tileCount, side, groupsFor((count + pixelsPerTile - 1) / pixelsPerTile));
}

FocusImage CandidateImages::image(const GpuScene& gpu, glm::dvec3 direction, int side,
                                  const std::vector<HalfSpace>& kept) {
  FocusImage image;
  if (!gpu.focus().box) return image;
  clip_ = {kept};
  const PixelRange pixels = pixelsOf(gpu.grid(), *gpu.focus().box, axesAt(direction), side);
  std::vector<Tile> tiles;
  addTiles(tiles, 0, pixels);
  const Traced traced({viewOf(gpu.drawnGrid(), direction, false)}, tiles);
  trace(gpu, traced, side);
  std::vector<glm::vec2> hits(tiles.size() * pixelsPerTile);
  traced.hits.read(std::as_writable_bytes(std::span(hits)));
  std::vector<float> crossings(tiles.size() * edgesPerTile);
  traced.crossings.read(std::as_writable_bytes(std::span(crossings)));

  const double diameter = 2.0 * gpu.grid().boundingRadius();
  const glm::ivec2 count = tilesOver(pixels);
  // The rows and columns around the tiles see nothing, so that the outlines close there.
  image.size = count * tileSide + 2;
  image.pixel = diameter / side;
  const std::size_t size = static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y);
  image.depth.assign(size, std::numeric_limits<float>::quiet_NaN());
  image.right.assign(size, 0.5f);
  image.below.assign(size, 0.5f);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const int tile = static_cast<int>(i / pixelsPerTile), within = static_cast<int>(i % pixelsPerTile);
    const std::size_t at = image.offset(glm::ivec2(tile % count.x, tile / count.x) * tileSide +
                                        glm::ivec2(within % tileSide, within / tileSide) + 1);
    if (!isNone(hits[i].x)) image.depth[at] = static_cast<float>((hits[i].x - 0.5) * diameter);
    image.right[at] = crossings[2 * i];
    image.below[at] = crossings[2 * i + 1];
  }
  return image;
}

void CandidateImages::measureImages(const GpuScene& gpu, std::vector<Candidate>& candidates, int side, bool endFaces) {
  // Opposite candidates share an image.
  std::vector<glm::dvec3> directions;
  for (const Candidate& candidate : candidates) directions.push_back(candidate.direction);
  const std::vector<std::optional<std::size_t>> opposites = oppositesOf(directions);
  // A software rasteriser gives each of two cores one half of a dispatch. Neighbouring images cost about the same, so
  // they go to different halves.
  std::vector<std::size_t> traced, others;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (!opposites[i] || *opposites[i] > i) (traced.size() > others.size() ? others : traced).push_back(i);
  traced.insert(traced.end(), others.begin(), others.end());

  for (std::size_t begin = 0; begin < traced.size();) {
    // Whole images, until a batch is full.
    std::vector<View> views;
    std::vector<Tile> tiles;
    std::vector<glm::uvec2> ranges;
    for (std::size_t i = begin; i < traced.size() && (views.empty() || tiles.size() < tilesPerBatch); ++i) {
      const std::size_t first = tiles.size();
      const glm::dvec3 direction = directions[traced[i]];
      addTiles(tiles, static_cast<unsigned>(views.size()),
               pixelsOf(gpu.grid(), *gpu.focus().box, axesAt(direction), side));
      ranges.emplace_back(static_cast<unsigned>(first), static_cast<unsigned>(tiles.size() - first));
      views.push_back(viewOf(gpu.drawnGrid(), direction, opposites[traced[i]].has_value()));
    }
    const Traced images(views, tiles);
    const gl::Buffer partials = gl::Buffer::zeroed(tiles.size() * sizeof(Sums));
    partials.bind(sumsBlock);
    trace(gpu, images, side);
    const gl::Buffer ends =
        endFaces ? gl::Buffer::zeroed(tiles.size() * pixelsPerTile * sizeof(unsigned)) : gl::Buffer();
    if (endFaces) {
      ends.bind(endsBlock);
      dispatchTiles(prepared(ends_, gpu), tiles.size(), side, groupsFor(tiles.size()));
    }
    const gl::Variant summed{{}, {{"ends", endFaces ? "lib/ends/Faces.glsl" : "lib/ends/None.glsl"}}};
    dispatchTiles(areas_.get(summed), tiles.size(), side, groupsFor((tiles.size() + tileSide - 1) / tileSide));

    std::vector<Sums> totals(ranges.size());
    const gl::Buffer rangeList = bufferOf(ranges), result = gl::Buffer::zeroed(totals.size() * sizeof(Sums));
    gl::ShaderProgram& program = sums_.get(summed);
    rangeList.bind(rangesBlock);
    partials.bind(partialsBlock);
    result.bind(sumsBlock);
    program.set("viewCount", static_cast<int>(ranges.size()));
    program.dispatch(groupsFor(ranges.size()), {1, 1});
    result.read(std::as_writable_bytes(std::span(totals)));
    for (std::size_t i = 0; i < totals.size(); ++i) {
      if (totals[i].sums.x <= 0.0f) continue;
      const std::size_t front = traced[begin + i];
      const ImageSums& sums = candidates[front].sums = fromFront(totals[i]);
      if (const auto behind = opposites[front])
        candidates[*behind].sums =
            fromBehind(sums, totals[i].more, axesAt(directions[front]), axesAt(directions[*behind]), side);
    }
    begin += totals.size();
  }
}

void CandidateImages::measureVisibility(const GpuScene& gpu, const FocusSurface& surface,
                                        std::vector<Candidate>& candidates) {
  const Grid grid = gpu.drawnGrid();
  const glm::dmat3 cellsFromWorld(grid.indexFromWorld());
  const glm::dmat3 steps(gpu.grid().worldFromIndex());
  std::vector<SurfacePoint> points;
  for (const FocusSurface::Point& point : surface.points) {
    // The point's place along its normal is known to half a voxel, as the surface's is.
    double extent = 0.0;
    for (int axis = 0; axis < 3; ++axis) extent += std::abs(glm::dot(steps[axis], point.normal));
    // facing · (cells per mm along d) = normal · d: normals transform by the inverse transpose.
    const glm::dvec3 facing = glm::transpose(glm::inverse(cellsFromWorld)) * point.normal;
    points.push_back({glm::vec4(glm::vec3(gpu.drawnCells(point.index + 1.0)), static_cast<float>(extent)),
                      glm::vec4(glm::vec3(facing), 0.0f)});
  }
  std::vector<View> views;
  for (const Candidate& candidate : candidates) views.push_back(viewOf(grid, candidate.direction, false));
  gl::ShaderProgram& program = prepared(visibility_, gpu);
  const gl::Buffer viewList = bufferOf(views), list = bufferOf(points);
  viewList.bind(viewsBlock);
  list.bind(pointsBlock);
  const glm::ivec2 size(static_cast<int>(points.size()), static_cast<int>(candidates.size()));
  gl::Texture seen = gl::Texture::make2D(gl::Format::R8UI, size);
  program.bind("seen", seen, gl::Access::Write);
  program.set("pointCount", size.x);
  program.dispatch(size, {64, 1});
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
