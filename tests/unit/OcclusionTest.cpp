// Ambient occlusion and the soft shadow: the medium that casts them, and in the reference the integrals through it
// against closed forms. The media are cells of 1 mm.

#include <cmath>

#include <gtest/gtest.h>

#include "rendering/reference/Occlusion.h"
#include "tests/support/Scenes.h"

namespace fenestra::tests::occlusionTest {
namespace {

using reference::OccludingMedium;

/// Enough that their number does not show in 1e-3.
constexpr int manyDirections = 40'000;

OccludingMedium mediumOf(glm::ivec3 dims, const std::function<double(glm::ivec3)>& extinctionAt) {
  OccludingMedium medium{gridOf(dims), dims, glm::ivec3(1), {}};
  medium.extinction.resize(medium.grid.voxelCount());
  forEachVoxel(dims, [&](glm::ivec3 cell) { medium.extinction[medium.grid.offset(cell)] = extinctionAt(cell); });
  return medium;
}

/// Mean of f over 0..1 by the midpoint rule.
double meanOf(const std::function<double(double)>& f) {
  constexpr int steps = 20'000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) sum += f((i + 0.5) / steps);
  return sum / steps;
}

TEST(OcclusionWeight, IsTheIntegralOfItsRamps) {
  const occlusion::Weight weight = occlusion::nearWeight(2.0);
  double sum = 0.0;
  constexpr double step = 1e-4;
  for (double s = 0.5 * step; s < 30.0; s += step) {
    const double rise = std::clamp((s - 3.0) / 4.0, 0.0, 1.0), fall = std::clamp((s - 12.0) / 12.0, 0.0, 1.0);
    sum += step * (rise - fall);
    if (std::abs(std::remainder(s, 1.0)) < 0.6 * step) {
      EXPECT_NEAR(weight.upTo(s), sum, 1e-4) << s;
    }
  }
}

TEST(OcclusionDirections, AreSpreadEvenly) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3 each : occlusion::allAround(24)) {
    EXPECT_NEAR(glm::length(each), 1.0, 1e-12);
    sum += each;
  }
  EXPECT_LT(glm::length(sum) / 24.0, 0.02);
  const glm::dvec3 light = glm::normalize(glm::dvec3(-0.3, 0.9, 0.2));
  for (const glm::dvec3 each : occlusion::towards(light, 7.0, 8)) {
    EXPECT_NEAR(glm::length(each), 1.0, 1e-12);
    EXPECT_GE(glm::dot(each, light), std::cos(glm::radians(7.0)));
  }
}

TEST(OcclusionCrossings, AreThePlanesThroughTheCentresOfTheMediumsCells) {
  const glm::ivec3 dims(8), side(2);  // centres at 0.5, 2.5, 4.5, … voxels
  const reference::Occlusion occlusion({gridOf(side * dims), dims, side, std::vector<double>(512, 0.0)}, Shading{},
                                       {0.0, 0.0, 1.0});
  const reference::Piece piece{{4, 4, 6}, 0.0, 1.0, {0.2, 0.9, 0.5}, {1.0, 0.1, 0.5}};
  std::vector<double> places;
  occlusion.appendCrossings(piece, places);
  ASSERT_EQ(places.size(), 2u);
  EXPECT_NEAR(places[0], 0.375, 1e-12);
  EXPECT_NEAR(places[1], 0.5, 1e-12);  // along y the piece runs downwards
}

/// Under a slab of 6 mm of 0.3/mm light is as in closed form, at any slant.
TEST(Shadow, OfASlabIsItsTransmittance) {
  const OccludingMedium medium =
      mediumOf({64, 64, 40}, [](glm::ivec3 cell) { return cell.z >= 20 && cell.z < 26 ? 0.3 : 0.0; });
  const occlusion::Weight far = occlusion::farWeight(medium.sideLength());
  for (const double slant : {0.0, 17.0, 42.0}) {
    const double cosine = std::cos(glm::radians(slant)), sine = std::sin(glm::radians(slant));
    const glm::dvec3 light(0.6 * sine, 0.8 * sine, cosine);
    // Rounding alone: the medium is the slab itself.
    EXPECT_NEAR(medium.transmittance({20, 20, 5}, light, far), std::exp(-0.3 * 6.0 / cosine), 1e-12);
  }
  // The mean over the light's disc: over equal areas of a sphere's cap, which are equal parts of its height.
  const double least = std::cos(glm::radians(occlusion::lightRadius));
  const double truth = meanOf([&](double u) { return std::exp(-1.8 / glm::mix(1.0, least, u)); });
  for (const int count : {occlusion::Directions{}.towardsLight, manyDirections}) {
    const auto disc = occlusion::towards({0.0, 0.0, 1.0}, occlusion::lightRadius, count);
    EXPECT_NEAR(medium.meanTransmittance({20, 20, 5}, disc, far), truth, 1e-3) << count;
  }
}

/// Above and in a half space of 0.2/mm.
TEST(AmbientOcclusion, OfAHalfSpaceIsTheClosedForm) {
  constexpr double extinction = 0.2;
  constexpr int surface = 30;
  const OccludingMedium medium =
      mediumOf({61, 61, 61}, [](glm::ivec3 cell) { return cell.z < surface ? extinction : 0.0; });
  const occlusion::Weight near = occlusion::nearWeight(medium.sideLength());
  const auto many = occlusion::allAround(manyDirections);
  const double all = near.upTo(near.fadeTo);
  for (const int z : {44, 36, 33, 30, 29, 27, 22}) {
    const double height = z + 0.5 - surface;
    // A ray whose direction has cosine u to the plane's normal reaches the plane after |height| / u; the weight up to
    // there lies on this side of it.
    const auto passed = [&](double u) { return near.upTo(std::min(std::abs(height) / u, near.fadeTo)); };
    const double away = meanOf([&](double u) { return height > 0.0 ? 1.0 : std::exp(-extinction * passed(u)); });
    const double into =
        meanOf([&](double u) { return std::exp(-extinction * (height > 0.0 ? all - passed(u) : all)); });
    const double out = height > 0.0 ? 1.0 : away;
    const double truth = 0.5 * (out + into);
    EXPECT_NEAR(medium.meanTransmittance({30, 30, z}, many, near), truth, 1e-3) << z;
    // The error of few directions: the last figure of the definition's means.
    const auto few = occlusion::allAround(occlusion::Directions{}.around);
    EXPECT_NEAR(medium.meanTransmittance({30, 30, z}, few, near), truth, 0.02) << z;
  }
}

/// The definition's difference from the continuous integrals, for a half space whose surface lies inside a cell, which
/// the cells' means blur, and for few directions instead of many on the surface of a bumpy body with a pit. The limits
/// are the measured values, rounded up.
TEST(AmbientOcclusion, DiffersLittleFromTheContinuousIntegral) {
  for (const auto& [extinction, limit] : {std::pair(0.2, 0.02), std::pair(2.0, 0.09)}) {
    double worst = 0.0;
    for (const double share : {0.25, 0.5, 0.75}) {
      constexpr int surface = 30;
      const OccludingMedium medium = mediumOf({61, 61, 61}, [&, k = extinction](glm::ivec3 cell) {
        return cell.z < surface ? k : cell.z == surface ? share * k : 0.0;
      });
      const occlusion::Weight near = occlusion::nearWeight(medium.sideLength());
      const auto many = occlusion::allAround(4000);
      for (int z = 27; z < 36; ++z) {
        const double height = z + 0.5 - (surface + share), all = near.upTo(near.fadeTo);
        const auto passed = [&](double u) { return near.upTo(std::min(std::abs(height) / u, near.fadeTo)); };
        const auto through = [&, k = extinction](double u, bool up) {
          if (height > 0.0) return up ? 1.0 : std::exp(-k * (all - passed(u)));
          return std::exp(-k * (up ? passed(u) : all));
        };
        const double truth = 0.5 * meanOf([&](double u) { return through(u, true) + through(u, false); });
        worst = std::max(worst, std::abs(medium.meanTransmittance({30, 30, z}, many, near) - truth));
      }
    }
    EXPECT_LE(worst, limit) << extinction;
    RecordProperty("half_space_" + std::to_string(extinction), std::to_string(worst));
  }

  const OccludingMedium body = mediumOf(glm::ivec3(64), [](glm::ivec3 cell) {
    const glm::dvec3 p = (glm::dvec3(cell) - 31.5) / 31.5;
    const bool pit = glm::length(glm::dvec2(p.x - 0.1, p.z + 0.2)) < 0.2 && p.y < 0.1;
    const double inside = 0.8 - glm::length(p) + 0.05 * std::sin(9.0 * p.x) * std::cos(8.0 * p.y + 3.0 * p.z);
    return pit ? 0.0 : std::clamp(40.0 * inside, 0.0, 2.0);
  });
  const occlusion::Weight near = occlusion::nearWeight(1.0), far = occlusion::farWeight(1.0);
  const glm::dvec3 light = glm::normalize(glm::dvec3(0.4, -0.8, 0.5));
  const auto few = occlusion::allAround(occlusion::Directions{}.around), many = occlusion::allAround(1000);
  const auto fewOfLight = occlusion::towards(light, occlusion::lightRadius, occlusion::Directions{}.towardsLight),
             manyOfLight = occlusion::towards(light, occlusion::lightRadius, 300);
  double around = 0.0, towards = 0.0;
  int count = 0;
  forEachVoxel(body.dims, [&](glm::ivec3 cell) {
    if (!(body.at(cell) > 0.2 && body.at(cell) < 1.8) || (cell.x + cell.y + cell.z) % 16 != 0) return;
    const double a = 2.0 * (body.meanTransmittance(cell, few, near) - body.meanTransmittance(cell, many, near));
    const double s = body.meanTransmittance(cell, fewOfLight, far) - body.meanTransmittance(cell, manyOfLight, far);
    around += a * a;
    towards += s * s;
    ++count;
  });
  ASSERT_GT(count, 100);
  EXPECT_LE(std::sqrt(around / count), 0.06);
  EXPECT_LE(std::sqrt(towards / count), 0.05);
  RecordProperty("around", std::to_string(std::sqrt(around / count)));
  RecordProperty("towards", std::to_string(std::sqrt(towards / count)));
}

/// A ball of radius 16 mm and 0.034/mm over an opaque plane: light from all around and from straight above, against the
/// sum over directions of the transmittance along the ball's chords.
TEST(AmbientOcclusion, UnderABallOverAPlaneIsTheClosedForm) {
  constexpr double extinction = 0.034, radius = 16.0;
  constexpr int surface = 10;
  const glm::ivec3 dims(71, 71, 52);
  const glm::dvec3 centre(35.5, 35.5, 33.0);  // mm from the corner of the first cell
  const OccludingMedium medium = mediumOf(dims, [&](glm::ivec3 cell) {
    if (cell.z < surface) return 100.0;
    const double distance = glm::length(glm::dvec3(cell) + 0.5 - centre);
    if (std::abs(distance - radius) > 1.0) return distance < radius ? extinction : 0.0;
    constexpr int parts = 8;
    int inside = 0;
    forEachVoxel(glm::ivec3(parts), [&](glm::ivec3 part) {
      const glm::dvec3 at = glm::dvec3(cell) + (glm::dvec3(part) + 0.5) / double(parts);
      inside += glm::length(at - centre) < radius;
    });
    return extinction * inside / (parts * parts * parts);
  });
  const auto transmittance = [&](glm::dvec3 from, glm::dvec3 direction, const occlusion::Weight& weight) {
    const glm::dvec3 offset = from - centre;
    const double b = glm::dot(offset, direction), c = glm::dot(offset, offset) - radius * radius, d = b * b - c;
    const auto upTo = [&](double s) { return weight.upTo(std::clamp(s, 0.0, weight.fadeTo)); };
    double depth = d > 0.0 ? extinction * (upTo(-b + std::sqrt(d)) - upTo(-b - std::sqrt(d))) : 0.0;
    if (direction.z < 0.0) depth += 100.0 * (upTo(weight.fadeTo) - upTo((surface - from.z) / direction.z));
    return std::exp(-depth);
  };
  const auto near = occlusion::nearWeight(1.0), far = occlusion::farWeight(1.0);
  const auto around = occlusion::allAround(manyDirections);
  const auto disc = occlusion::towards({0.0, 0.0, 1.0}, 30.0, manyDirections);
  for (const glm::ivec3 cell : {glm::ivec3(35, 35, 12), glm::ivec3(43, 35, 12), glm::ivec3(50, 44, 15)}) {
    const glm::dvec3 at = glm::dvec3(cell) + 0.5;
    const auto truth = [&](const std::vector<glm::dvec3>& directions, const occlusion::Weight& weight) {
      double sum = 0.0;
      for (const glm::dvec3& each : directions) sum += transmittance(at, each, weight);
      return sum / static_cast<double>(directions.size());
    };
    EXPECT_NEAR(medium.meanTransmittance(cell, around, near), truth(around, near), 1e-3) << cell.x;
    EXPECT_NEAR(medium.meanTransmittance(cell, disc, far), truth(disc, far), 1e-3) << cell.x;
  }
}

/// The field is trilinear between the nodes, and continues the outermost ones to the volume's border.
TEST(OcclusionField, IsTrilinearBetweenNodes) {
  OccludingMedium medium = mediumOf({20, 20, 20}, [](glm::ivec3 cell) { return 0.4 * (cell.x % 3) + 0.1 * cell.z; });
  medium.side = {2, 1, 3};
  medium.grid = gridOf(medium.dims * medium.side, {0.5, 1.0, 0.4});
  Shading shading;
  shading.occlusion = 0.75;
  shading.shadow = 0.5;
  const reference::Occlusion occlusion(medium, shading, glm::normalize(glm::dvec3(0.3, 0.2, 1.0)));
  const auto nodeIndex = [&](glm::dvec3 cell) { return (cell + 0.5) * glm::dvec3(medium.side) - 0.5; };
  for (const glm::ivec3 cell : {glm::ivec3(0), glm::ivec3(7, 12, 3), glm::ivec3(18)}) {
    const glm::dvec2 node = occlusion.atNode(cell), next = occlusion.atNode(cell + glm::ivec3(1, 0, 0));
    EXPECT_NEAR(glm::length(occlusion.at(nodeIndex(cell)) - node), 0.0, 1e-12);
    const glm::dvec2 between = occlusion.at(nodeIndex(glm::dvec3(cell) + glm::dvec3(0.3, 0.0, 0.0)));
    EXPECT_NEAR(glm::length(between - (0.7 * node + 0.3 * next)), 0.0, 1e-12);
    EXPECT_GE(node.x, 1.0 - shading.occlusion);
    EXPECT_GE(node.y, 1.0 - shading.shadow);
    if (cell.x == 7) {
      EXPECT_LT(node.x, 1.0) << "not at the rim";
    }
  }
  EXPECT_EQ(occlusion.at(glm::dvec3(-0.5)), occlusion.atNode(glm::ivec3(0)));
}

/// A body of 1/mm in whose middle lies a ball of focus; a protected rod crosses it.
Scene body() {
  const Grid grid = gridOf({70, 40, 30});
  Scene scene;
  scene.volume = volumeOf<std::int16_t>(grid, [](glm::ivec3) { return 100; });
  const auto labels = labelsOf(grid, [](glm::ivec3 i) {
    return glm::length(glm::dvec3(i) - glm::dvec3(35, 20, 15)) < 6.0 ? 1 : std::abs(i.x - 20) < 3 ? 2 : 0;
  });
  labels->labels = {{1, "focus", {1.0, 0.4, 0.2}}, {2, "rod", {0.2, 0.5, 1.0}}};
  scene.labels = labels;
  scene.look.context.function = {{{0.0, {{1.0, 1.0, 1.0}, 0.0}}, {100.0, {{1.0, 1.0, 1.0}, 1.0}}}};
  return scene;
}

OccluderCells::Extinction extinctionAt(const OccluderCells& cells, glm::ivec3 voxel) {
  Grid lattice;
  lattice.dims = cells.dims;
  return cells.extinction[lattice.offset(voxel / cells.side)];
}

TEST(OccluderCells, HoldTheMeanOfWhatTheirVoxelsShow) {
  Scene scene = body();
  OccluderCells cells = occluderCells(scene);
  EXPECT_EQ(cells.side, glm::ivec3(2));
  EXPECT_EQ(cells.dims, glm::ivec3(35, 20, 15));
  // A table's step is 1/4096 of its function.
  EXPECT_NEAR(extinctionAt(cells, {35, 20, 15}).context, 1.0, 3e-4) << "nothing is in focus";
  scene.look.focus = LabelFocus{{1}};
  scene.look.focusAppearance.extinction = 3.0;
  cells = occluderCells(scene);
  EXPECT_EQ(extinctionAt(cells, {35, 20, 15}).context, 0.0f);
  EXPECT_FLOAT_EQ(extinctionAt(cells, {35, 20, 15}).kept, 3.0f);
  EXPECT_NEAR(extinctionAt(cells, {20, 4, 4}).context, 1.0, 3e-4);
  put(scene.look.labels, {.label = 2, .role = LabelRole::Protected});
  cells = occluderCells(scene);
  EXPECT_EQ(extinctionAt(cells, {20, 4, 4}).context, 0.0f);
  EXPECT_NEAR(extinctionAt(cells, {20, 4, 4}).kept, 1.0, 3e-4);
  put(scene.look.labels, {.label = 2, .role = LabelRole::Hidden});
  cells = occluderCells(scene);
  EXPECT_EQ(extinctionAt(cells, {20, 4, 4}).kept, 0.0f);
  put(scene.look.labels, {.label = 2, .opacity = 0.5});
  scene.look.clipping.exempt = {2};
  cells = occluderCells(scene);
  const float faint = extinctionAt(cells, {20, 4, 4}).context;
  EXPECT_GT(faint, 0.0f);
  EXPECT_LT(faint, 0.9f);
  EXPECT_EQ(extinctionAt(cells, {20, 4, 4}).exempt, faint);
}

TEST(OccluderCells, CountWhatOfTheFocusGivesWayToMoreImportantLabelsAsRemovable) {
  Scene scene = body();
  scene.look.focus = LabelFocus{{1, 2}};
  scene.look.focusAppearance.extinction = 3.0;
  put(scene.look.labels, {.label = 2, .importance = 1});
  EXPECT_FLOAT_EQ(extinctionAt(occluderCells(scene), {20, 4, 4}).kept, 3.0f) << "of another method";
  scene.look.method.kind = kindOf<methods::Importance>;
  const OccluderCells cells = occluderCells(scene);
  EXPECT_EQ(extinctionAt(cells, {20, 4, 4}).kept, 0.0f);
  EXPECT_FLOAT_EQ(extinctionAt(cells, {20, 4, 4}).context, 3.0f);
  EXPECT_FLOAT_EQ(extinctionAt(cells, {35, 20, 15}).kept, 3.0f);
}

TEST(OccluderCells, OfAFocusOfValuesKeepItsComponents) {
  Scene scene = body();
  scene.volume = volumeOf<float>(scene.volume->grid, [](glm::ivec3 i) {
    return glm::length(glm::dvec3(i) - glm::dvec3(35, 20, 15)) < 6.0 || i == glm::ivec3(4) ? 500.0f : 100.0f;
  });
  scene.look.focus = ValueFocus{{400.0, 600.0}, 100.0};
  const OccluderCells cells = occluderCells(scene);
  EXPECT_FLOAT_EQ(extinctionAt(cells, {35, 20, 15}).kept, float(scene.look.focusAppearance.extinction));
  EXPECT_EQ(extinctionAt(cells, {4, 4, 4}).kept, 0.0f) << "too small a component";
}

TEST(OccluderCells, AreNeverMoreThanTheirLimitAlongAnAxis) {
  for (const glm::ivec3 dims :
       {glm::ivec3(1), glm::ivec3(64), glm::ivec3(65), glm::ivec3(512, 512, 40), glm::ivec3(3000, 7, 1)}) {
    const glm::ivec3 side = occluderSide(gridOf(dims, {0.7, 0.7, 3.0}));
    const glm::ivec3 cells = (dims + side - 1) / side;
    EXPECT_LE(std::max({cells.x, cells.y, cells.z}), occlusion::mostCells);
  }
  EXPECT_EQ(occluderSide(gridOf({64, 30, 20})), glm::ivec3(1)) << "not coarser than needed";
}

/// Removed parts cast no shadow; protected and exempt labels do.
TEST(OccludingMedium, IsTheVolumeAsItIsCutOpen) {
  Scene scene = body();
  scene.look.focus = LabelFocus{{1}};
  scene.look.cutaway.openWidth = 30.0;
  const Grid& grid = scene.volume->grid;
  const Camera camera =
      lookAt(grid.centre() - glm::dvec3(0.0, 300.0, 0.0), grid.centre(), Projection::Orthographic, 60.0);
  const glm::ivec2 size(90, 60);
  const auto at = [&](glm::ivec3 voxel) {
    const reference::Stages stages = reference::geometricStages(scene, camera, size);
    const OccludingMedium medium =
        reference::occludingMedium(scene, camera, size, hasCutaway(scene) ? &stages : nullptr);
    return medium.at(voxel / medium.side);
  };
  const glm::ivec3 before(35, 6, 15), beside(4, 6, 15), rod(20, 4, 15), behind(35, 36, 15);
  EXPECT_EQ(at(before), 0.0) << "removed in front of the focus";
  EXPECT_NEAR(at(beside), 1.0, 3e-4);
  EXPECT_NEAR(at(behind), 1.0, 3e-4);
  EXPECT_LT(at(rod), 0.9) << "within the opening";
  put(scene.look.labels, {.label = 2, .role = LabelRole::Protected});
  EXPECT_NEAR(at(rod), 1.0, 3e-4);
  scene.look.cutaway.enabled = false;
  EXPECT_NEAR(at(before), 1.0, 3e-4);
  scene.look.clipping.planes = {{{0.0, 1.0, 0.0}, 20.0}};
  EXPECT_EQ(at(before), 0.0) << "clipped";
  EXPECT_EQ(at(rod), 0.0);
  scene.look.clipping.exempt = {2};
  EXPECT_NEAR(at(rod), 1.0, 3e-4);
}

}  // namespace
}  // namespace fenestra::tests::occlusionTest
