// Brush strokes on the picture, against a projection by matrices and an evaluation of every pixel.

#include "rendering/gpu/StrokeLines.h"

#include <functional>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/Scenes.h"

namespace fenestra::tests::strokeLinesTest {
namespace {

constexpr glm::ivec2 size(150, 100);

/// A camera as OpenGL's fixed pipeline has it.
class Matrices {
 public:
  explicit Matrices(const Camera& camera) : view_(glm::lookAt(camera.eye, camera.target, camera.up)), projection_(1.0) {
    const double aspect = static_cast<double>(size.x) / size.y, half = 0.5 * camera.orthographicHeight;
    projection_ = camera.projection == Projection::Perspective
                      ? glm::perspective(glm::radians(camera.verticalFov), aspect, 0.1, 1e4)
                      : glm::ortho(-half * aspect, half * aspect, -half, half, 0.1, 1e4);
  }
  /// x and y in pixels from the top left, radius in pixels, view depth in mm.
  glm::dvec4 spot(glm::dvec3 world, double radius) const {
    const glm::dvec3 up(view_[0].y, view_[1].y, view_[2].y);
    const glm::dvec2 middle = pixelOf(world);
    return {middle, glm::distance(middle, pixelOf(world + radius * up)), -(view_ * glm::dvec4(world, 1.0)).z};
  }

 private:
  glm::dvec2 pixelOf(glm::dvec3 world) const {
    const glm::dvec3 at = glm::project(world, view_, projection_, glm::dvec4(0.0, 0.0, size));
    return {at.x, size.y - at.y};
  }
  glm::dmat4 view_, projection_;
};

constexpr glm::dvec3 target(1.0, -2.0, 3.0);

Camera cameraAt(glm::dvec3 eye, Projection projection) {
  Camera camera = lookAt(eye, target, projection, 60.0);
  camera.up = {0.0, 0.0, 1.0};
  return camera;
}

BrushStroke strokeThrough(std::vector<glm::dvec3> anchors, double radius = 3.0) {
  BrushStroke stroke;
  stroke.anchors = std::move(anchors);
  stroke.radius = radius;
  return stroke;
}

/// The nearest point of a line to a pixel's centre: where, the radius and the depth there.
glm::dvec4 nearestOn(glm::dvec4 from, glm::dvec4 to, glm::dvec2 pixel) {
  const glm::dvec2 along(to - from);
  const double size2 = glm::dot(along, along);
  const double u = size2 > 0.0 ? std::clamp(glm::dot(pixel - glm::dvec2(from), along) / size2, 0.0, 1.0) : 0.0;
  return glm::mix(from, to, u);
}

template <class F>
void forEachPixel(F&& f) {
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) f(glm::ivec2(x, y), glm::dvec2(x + 0.5, y + 0.5));
}

void expectBesidePicture(glm::dvec4 from, glm::dvec4 to) {
  forEachPixel([&](glm::ivec2, glm::dvec2 centre) {
    const glm::dvec4 nearest = nearestOn(from, to, centre);
    EXPECT_GT(glm::distance(glm::dvec2(nearest), centre), nearest.z) << centre.x << ' ' << centre.y;
  });
}

/// Clipping leaves every pixel that the brush can reach its nearest point, with radius and depth.
void expectSameOnPicture(const StrokeLine& line, glm::dvec4 from, glm::dvec4 to) {
  forEachPixel([&](glm::ivec2, glm::dvec2 centre) {
    const glm::dvec4 expected = nearestOn(from, to, centre);
    if (glm::distance(glm::dvec2(expected), centre) > std::max(from.z, to.z)) return;
    // The line is float32: some 1e-7 of a few hundred pixels and mm, and as much in the direction.
    EXPECT_LT(glm::length(nearestOn(line.from, line.to, centre) - expected), 1e-3) << centre.x << ' ' << centre.y;
  });
}

TEST(StrokeLines, AreTheirAnchorsProjected) {
  std::mt19937 random(11);
  const Grid grid = obliqueGrid({20, 20, 20});
  int lines = 0;
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
    for (int round = 0; round < 100; ++round) {
      const Camera camera = cameraAt(target + 80.0 * randomUnit(random), projection);
      const RayFrame rays(camera, size, grid);
      // Many lines leave the picture, some lie beside it.
      const glm::dvec3 a = randomIn(random, glm::dvec3(-40.0), glm::dvec3(40.0)),
                       b = round % 10 ? randomIn(random, glm::dvec3(-40.0), glm::dvec3(40.0)) : a;
      const BrushStroke stroke = strokeThrough({a, b});
      const ProjectedStrokes projected = project({stroke}, rays);
      ASSERT_EQ(projected.size(), 1u);
      EXPECT_EQ(projected[0].radius, 3.0f);
      const Matrices matrices(camera);
      const glm::dvec4 anchorPlane(0.0, 0.0, 0.0, rays.distance());
      const glm::dvec4 from = matrices.spot(a, stroke.radius) - anchorPlane,
                       to = matrices.spot(b, stroke.radius) - anchorPlane;
      ASSERT_LE(projected[0].lines.size(), 1u);
      if (projected[0].lines.empty())
        expectBesidePicture(from, to);
      else
        expectSameOnPicture(projected[0].lines[0], from, to);
      lines += static_cast<int>(projected[0].lines.size());
    }
  EXPECT_GT(lines, 100);
  EXPECT_LT(lines, 200) << "some lie beside the picture";
}

TEST(StrokeLines, AnchorsBehindTheCameraBreakThePolyline) {
  const Camera perspective = lookAt({0.0, -50.0, 0.0}, glm::dvec3(0.0));
  const Camera parallel = lookAt({0.0, -50.0, 0.0}, glm::dvec3(0.0), Projection::Orthographic, 60.0);
  const Grid grid = gridOf({20, 20, 20});
  const glm::dvec3 a(-2.0, 0.0, 1.0), b(2.0, 5.0, 0.0), behind(0.0, -60.0, 0.0), near(0.0, -48.0, 0.0);
  struct Case {
    std::vector<glm::dvec3> anchors;
    std::size_t lines, dabs;
  };
  for (const Camera& camera : {perspective, parallel})
    for (const Case& c :
         {Case{{a}, 0, 1}, Case{{behind}, 0, 0}, Case{{a, b}, 1, 0}, Case{{a, b, a}, 2, 0}, Case{{a, behind, b}, 0, 2},
          Case{{a, b, behind, a}, 1, 1}, Case{{behind, a, b, behind}, 1, 0}, Case{{behind, a}, 0, 1}}) {
      const ProjectedStrokes projected = project({strokeThrough(c.anchors)}, RayFrame(camera, size, grid));
      ASSERT_EQ(projected.size(), 1u);
      std::size_t dabs = 0;
      for (const StrokeLine& line : projected[0].lines) dabs += line.from == line.to;
      EXPECT_EQ(dabs, c.dabs);
      EXPECT_EQ(projected[0].lines.size() - dabs, c.lines);
    }
  const std::vector<StrokeLine> lines = project({strokeThrough({a, b, a})}, RayFrame(perspective, size, grid))[0].lines;
  EXPECT_EQ(lines[0].from, lines[1].to);
  EXPECT_EQ(lines[0].to, lines[1].from);
  // Two mm before the eye, a brush of three reaches behind it; a parallel camera has no eye.
  EXPECT_TRUE(project({strokeThrough({near})}, RayFrame(perspective, size, grid))[0].lines.empty());
  EXPECT_EQ(project({strokeThrough({near}, 1.5)}, RayFrame(perspective, size, grid))[0].lines.size(), 1u);
  EXPECT_EQ(project({strokeThrough({near})}, RayFrame(parallel, size, grid))[0].lines.size(), 1u);
}

TEST(StrokeLines, StrokesWithoutAnEffectAreLeftOut) {
  const RayFrame rays(lookAt({0.0, -50.0, 0.0}, glm::dvec3(0.0)), size, gridOf({20, 20, 20}));
  BrushStroke fade = strokeThrough({glm::dvec3(0.0)}), hidden = fade, beside = strokeThrough({glm::dvec3(900.0, 0, 0)});
  fade.mode = BrushMode::Fade;
  fade.depth = 0.0;
  fade.amount = 0.25;
  fade.softness = 0.75;
  fade.coversFocus = true;
  hidden.hidden = true;
  const ProjectedStrokes projected = project({hidden, fade, beside}, rays);
  ASSERT_EQ(projected.size(), 2u);
  EXPECT_EQ(projected[0].mode, BrushMode::Fade);
  EXPECT_EQ(projected[0].effect, 0.25f);
  EXPECT_EQ(projected[0].softness, 0.75f);
  EXPECT_TRUE(projected[0].coversFocus);
  EXPECT_EQ(projected[1].mode, BrushMode::Restore);
  EXPECT_EQ(projected[1].effect, 10.0f);
  EXPECT_TRUE(projected[1].lines.empty()) << "out of view";
}

StrokeLine lineOf(glm::vec2 from, glm::vec2 to, float radiusFrom, float radiusTo) {
  return {glm::vec4(from, radiusFrom, 0.0f), glm::vec4(to, radiusTo, 0.0f)};
}

StrokeLine randomLine(std::mt19937& random) {
  const auto in = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  const glm::vec2 from(in(-40, 190), in(-40, 140)), to(in(-40, 190), in(-40, 140));
  return lineOf(from, random() % 5 ? to : from, in(0.5, 12), in(0.5, 12));
}

TEST(StrokeLines, TilesReachedAreThoseThatALineOrItsRimMeets) {
  std::mt19937 random(12);
  for (int round = 0; round < 200; ++round) {
    const StrokeLine line = randomLine(random);
    const int tile = round % 2 ? 16 : 32;
    const float margin = round % 3 ? 0.0f : 2.0f;
    const glm::ivec2 count = (size + tile - 1) / tile;
    std::set<std::pair<int, int>> reached;
    forEachTileReached(line, tile, count, margin, [&](int i, int j) {
      EXPECT_TRUE(reached.emplace(i, j).second) << "twice";
      EXPECT_TRUE(i >= 0 && j >= 0 && i < count.x && j < count.y);
    });
    for (int j = 0; j < count.y; ++j)
      for (int i = 0; i < count.x; ++i) {
        double nearest = infinity;
        constexpr int steps = 2000;
        for (int step = 0; step <= steps; ++step) {
          const glm::dvec2 at(glm::mix(glm::dvec4(line.from), glm::dvec4(line.to), step / double{steps}));
          const glm::dvec2 low(i * tile, j * tile);
          nearest = std::min(nearest, glm::distance(at, glm::clamp(at, low, low + double(tile))));
        }
        const double reach = std::max(line.from.z, line.to.z) + margin;
        const bool isReached = reached.contains({i, j});
        EXPECT_TRUE(isReached || nearest > reach) << round << ": " << i << ' ' << j;
        // A tile counts as the circle around it and a pixel more.
        EXPECT_TRUE(!isReached || nearest <= reach + 1.01 + 0.21 * tile) << round << ": " << i << ' ' << j;
      }
  }
}

/// The effect of the strokes at a pixel: which of them reach it, in order, and how near to its lines it lies.
std::vector<std::pair<const ProjectedStroke*, double>> effectAt(const ProjectedStrokes& strokes, glm::dvec2 pixel) {
  std::vector<std::pair<const ProjectedStroke*, double>> effect;
  for (const ProjectedStroke& stroke : strokes) {
    double least = infinity;
    for (const StrokeLine& line : stroke.lines) {
      const glm::dvec4 nearest = nearestOn(line.from, line.to, pixel);
      least = std::min(least, glm::distance(glm::dvec2(nearest), pixel) / nearest.z);
    }
    if (least <= 1.0) effect.emplace_back(&stroke, least);
  }
  return effect;
}

bool sameEffect(const ProjectedStrokes& a, const ProjectedStrokes& b, glm::dvec2 pixel) {
  const auto atA = effectAt(a, pixel), atB = effectAt(b, pixel);
  return std::equal(atA.begin(), atA.end(), atB.begin(), atB.end(), [](const auto& p, const auto& q) {
    ProjectedStroke other = *q.first;
    other.lines = p.first->lines;
    return p.second == q.second && *p.first == other;
  });
}

/// Every pixel that changes lies in one region, `margin` pixels around included; regions do not overlap and are made
/// of whole groups of 8×8 pixels. Returns the pixels in regions.
int expectCovers(const ProjectedStrokes& before, const ProjectedStrokes& after, int margin) {
  std::vector<int> covered(static_cast<std::size_t>(size.x * size.y), 0);
  const auto at = [&](glm::ivec2 pixel) -> int& {
    return covered[static_cast<std::size_t>(pixel.y * size.x + pixel.x)];
  };
  for (const gl::Region& region : changedRegions(before, after, size, margin)) {
    for (int axis = 0; axis < 2; ++axis) {
      const int end = region.origin[axis] + region.size[axis];
      EXPECT_EQ(region.origin[axis] % 8, 0);
      EXPECT_TRUE(end == size[axis] || end % 8 == 0);
      if (region.origin[axis] < 0 || end > size[axis]) {
        ADD_FAILURE() << "a region leaves the picture";
        return -1;
      }
    }
    for (int y = 0; y < region.size.y; ++y)
      for (int x = 0; x < region.size.x; ++x) ++at(region.origin + glm::ivec2(x, y));
  }
  int pixels = 0;
  for (const int times : covered) {
    EXPECT_LE(times, 1);
    pixels += times;
  }
  forEachPixel([&](glm::ivec2 pixel, glm::dvec2 centre) {
    if (sameEffect(before, after, centre)) return;
    const glm::ivec2 low = glm::max(pixel - margin, 0), high = glm::min(pixel + margin, size - 1);
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) EXPECT_EQ(at({x, y}), 1) << x << ' ' << y;
  });
  return pixels;
}

TEST(StrokeLines, ChangedRegionsHoldEveryPixelThatChanges) {
  std::mt19937 random(13);
  const auto randomStrokes = [&](std::size_t count) {
    ProjectedStrokes strokes(count);
    for (ProjectedStroke& stroke : strokes) {
      stroke.effect = static_cast<float>(random() % 3);
      for (std::size_t i = 0; i < 1 + random() % 3; ++i) stroke.lines.push_back(randomLine(random));
    }
    return strokes;
  };
  const std::vector<std::function<void(ProjectedStroke&)>> changes{
      [](ProjectedStroke& stroke) { stroke.mode = BrushMode::Open; },
      [](ProjectedStroke& stroke) { stroke.coversFocus = true; },
      [](ProjectedStroke& stroke) { stroke.toSurface = true; },
      [](ProjectedStroke& stroke) { stroke.radius += 1.0f; },
      [](ProjectedStroke& stroke) { stroke.softness += 0.5f; },
      [](ProjectedStroke& stroke) { stroke.effect += 1.0f; }};
  for (int round = 0; round < 20; ++round) {
    const int margin = static_cast<int>(random() % 3);
    const ProjectedStrokes before = randomStrokes(3);
    EXPECT_EQ(expectCovers(before, before, margin), 0);
    ProjectedStrokes after = before;
    after[1].lines.push_back(randomLine(random));
    expectCovers(before, after, margin);
    expectCovers(after, before, margin);
    for (const auto& change : changes) {
      after = before;
      change(after[1]);
      expectCovers(before, after, margin);
    }
    after = before;
    after.erase(after.begin() + 1);
    expectCovers(before, after, margin);
    after = before;
    std::swap(after[0], after[2]);
    expectCovers(before, after, margin);
    after = before;
    after.push_back(randomStrokes(1).front());
    expectCovers(before, after, margin);
    expectCovers({}, before, margin);
    expectCovers(before, randomStrokes(2), margin);
  }
}

TEST(StrokeLines, AGrowingStrokeChangesNothingAroundItsOldLines) {
  ProjectedStroke stroke;
  for (int x = 10; x < 100; x += 10) stroke.lines.push_back(lineOf({x, 20}, {x + 10, 20}, 4.0f, 4.0f));
  ProjectedStroke longer = stroke;
  longer.lines.push_back(lineOf({100, 20}, {110, 20}, 4.0f, 4.0f));
  // The new line and its rim span 96…114 × 16…24: two tiles of 16 pixels of the eight that the stroke lies in.
  EXPECT_EQ(expectCovers({stroke}, {longer}, 0), 2 * 16 * 16);
  EXPECT_EQ(expectCovers({}, {longer}, 0), 8 * 16 * 16);
}

}  // namespace
}  // namespace fenestra::tests::strokeLinesTest
