// Where the parts of an exploded view are: at rest, apart, deterministic, and as symmetric as the scene.

#include "rendering/scene/Explosion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::tests::explosionTest {
namespace {

constexpr int mostPlanes = 3;

/// A body's grid.
Grid body() { return gridOf({60, 40, 90}, {1.0, 1.5, 2.0}, {-30.0, 12.0, 400.0}); }

std::vector<Camera> cameras(const Grid& grid) {
  std::vector<Camera> found;
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
    for (const glm::dvec2 angles : {glm::dvec2(0.0, 0.0), {25.0, 15.0}, {-140.0, 70.0}, {90.0, 0.0}, {10.0, -89.0}})
      found.push_back(Camera::fromAngles(angles.x, angles.y, grid, projection));
  // Inside of the volume, and at the middle itself.
  found.push_back(lookAt(grid.centre() + glm::dvec3(3.0, 2.0, 1.0), grid.centre()));
  found.push_back(lookAt(grid.centre(), grid.centre() + glm::dvec3(0.0, 1.0, 0.0)));
  return found;
}

/// In the middle, off it, at a corner and outside of the volume.
std::vector<glm::dvec3> middles(const Grid& grid) {
  const glm::dvec3 corner = grid.corners()[0], centre = grid.centre();
  return {centre, glm::mix(centre, corner, glm::dvec3(0.3, 0.6, 0.1)), glm::mix(centre, corner, 0.999), corner,
          glm::mix(centre, corner, 1.2)};
}

template <class Use>
void forEachView(Use use) {
  const Grid grid = body();
  for (const glm::dvec3 middle : middles(grid))
    for (const Camera& camera : cameras(grid))
      for (const ExplosionAxes axes : {ExplosionAxes::Patient, ExplosionAxes::View})
        for (int planes = 1; planes <= mostPlanes; ++planes)
          for (const double degree : {1e-3, 0.3, 1.0}) {
            SCOPED_TRACE(testing::Message()
                         << planes << " planes along " << static_cast<int>(axes) << ", degree " << degree);
            const MethodStages::Explosion explosion{degree, planes, axes};
            use(explosion, grid, middle, camera);
          }
}

TEST(Explosion, PartsAreAtRest) {
  forEachView([](const MethodStages::Explosion& explosion, const Grid& grid, glm::dvec3 middle, const Camera& camera) {
    const ExplodedView view(explosion, grid, middle, camera);
    for (std::size_t i = 0; i < view.parts().size(); ++i) {
      const glm::dvec3 force = view.forceOn(i), moved = view.translation(i);
      for (int k = 0; k < 3; ++k) {
        // A plane that a part would cross holds it.
        const double outwards = k < explosion.planes ? (i >> k & 1u ? 1.0 : -1.0) : 0.0;
        const bool held = k < explosion.planes && moved[k] == 0.0;
        EXPECT_LE(held ? outwards * force[k] : std::abs(force[k]), ExplodedView::atRest) << i;
      }
    }
  });
}

TEST(Explosion, PartsStayOnTheirSidesAndMoveOutMostly) {
  int held = 0, all = 0;
  forEachView([&](const MethodStages::Explosion& explosion, const Grid& grid, glm::dvec3 middle, const Camera& camera) {
    const std::vector<ExplodedPart> parts = ExplodedView(explosion, grid, middle, camera).parts();
    ASSERT_EQ(parts.size(), std::size_t{1} << explosion.planes);
    for (const ExplodedPart& part : parts) {
      ASSERT_EQ(part.kept.size(), static_cast<std::size_t>(explosion.planes));
      for (const HalfSpace& half : part.kept) {
        EXPECT_NEAR(glm::length(half.normal), 1.0, 1e-12);
        EXPECT_NEAR(half.distance(middle), 0.0, 1e-9);
        // Rounding of a product with the plane's normal, of up to 1000 mm.
        EXPECT_GE(glm::dot(part.translation, half.normal), -1e-12 * grid.boundingRadius());
        held += glm::dot(part.translation, half.normal) < 1e-12 * grid.boundingRadius();
        ++all;
      }
    }
  });
  EXPECT_LT(held, all / 10);
}

/// Random points of any two parts: a plane of the cut separates them, so no translation brings them together.
TEST(Explosion, PartsAreDisjointAndInTheOrderOfEveryRay) {
  std::mt19937 random(5);
  forEachView([&](const MethodStages::Explosion& explosion, const Grid& grid, glm::dvec3 middle, const Camera& camera) {
    const std::vector<ExplodedPart> parts = ExplodedView(explosion, grid, middle, camera).parts();
    const double radius = grid.boundingRadius();
    for (int sample = 0; sample < 20; ++sample) {
      // A ray's interval in each part, by its half-spaces; intervals follow one another.
      const bool perspective = camera.projection == Projection::Perspective;
      const glm::dvec3 through = randomIn(random, middle - glm::dvec3(radius), middle + glm::dvec3(radius));
      const glm::dvec3 direction = perspective ? glm::normalize(through - camera.eye) : camera.axes().forward;
      const glm::dvec3 origin = perspective ? camera.eye : through - 3.0 * radius * direction;
      double last = 0.0;
      for (const ExplodedPart& part : parts) {
        double begin = 0.0, end = 10.0 * radius + glm::distance(origin, middle);
        for (const HalfSpace& half : part.kept) {
          const double slope = glm::dot(direction, half.normal), before = half.distance(origin - part.translation);
          if (slope > 0.0)
            begin = std::max(begin, -before / slope);
          else if (slope < 0.0 || before < 0.0)
            end = slope < 0.0 ? std::min(end, -before / slope) : begin;
        }
        if (end - begin < 1e-9 * radius) continue;  // along a plane that the eye lies on
        EXPECT_GE(begin, last - 1e-9 * radius);
        last = end;
      }
    }
  });
}

TEST(Explosion, TheSameTwiceToTheBit) {
  forEachView([](const MethodStages::Explosion& explosion, const Grid& grid, glm::dvec3 middle, const Camera& camera) {
    const ExplodedView once(explosion, grid, middle, camera), again(explosion, grid, middle, camera);
    for (std::size_t i = 0; i < once.parts().size(); ++i) EXPECT_EQ(once.translation(i), again.translation(i));
  });
}

TEST(Explosion, ASymmetricSceneHasASymmetricLayout) {
  const Grid grid = body();
  for (int planes = 1; planes <= mostPlanes; ++planes)
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
      // Along y: left and right of the plane are alike, and so are above and below.
      const Camera camera = Camera::fromAngles(0.0, 0.0, grid, projection);
      const ExplodedView view({0.8, planes, ExplosionAxes::Patient}, grid, grid.centre(), camera);
      for (std::size_t i = 0; i < view.parts().size(); ++i)
        for (int k = 0; k < std::min(planes, 2); ++k) {
          glm::dvec3 mirrored = view.translation(i);
          mirrored[k] = -mirrored[k];
          // The distance from rest at which the iteration stops, and rounding of the samples' means.
          EXPECT_LT(glm::distance(view.translation(i ^ (std::size_t{1} << k)), mirrored), 1e-6) << planes << ", " << i;
        }
    }
}

TEST(Explosion, MoreDegreesMoveFartherAndNoneMoveNothing) {
  const Grid grid = body();
  const Camera camera = Camera::fromAngles(20.0, 10.0, grid);
  for (int planes = 1; planes <= mostPlanes; ++planes) {
    std::vector<double> before;
    for (const double degree : {1e-9, 0.1, 0.4, 0.7, 1.0}) {
      const ExplodedView view({degree, planes, ExplosionAxes::Patient}, grid, grid.centre(), camera);
      for (std::size_t i = 0; i < view.parts().size(); ++i) {
        const double far = glm::length(view.translation(i));
        if (degree == 1e-9) {
          before.push_back(far);
          EXPECT_LT(far, 1e-6);
          continue;
        }
        EXPECT_GT(far, before[i]);
        before[i] = far;
      }
    }
    for (const double far : before) EXPECT_GT(far, 0.2 * grid.boundingRadius()) << "enough to look between them";
  }
}

/// Without the viewing force, the part before the focus would lie in the line of sight to it.
TEST(Explosion, PartsBeforeTheFocusMoveOutOfTheLineOfSight) {
  const Grid grid = body();
  const Camera camera = Camera::fromAngles(0.0, 0.0, grid, Projection::Orthographic);
  // Three planes whose third faces the camera: the four parts before the focus move aside more than those behind it.
  const ExplodedView view({1.0, 3, ExplosionAxes::View}, grid, grid.centre(), camera);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto aside = [&](std::size_t part) { return glm::length(glm::dvec2(view.translation(part))); };
    EXPECT_GT(aside(i), aside(i | 4u) + 0.02 * grid.boundingRadius());
  }
}

TEST(Explosion, PlanesLieAlongThePatientOrTheView) {
  const Grid grid = obliqueGrid({20, 30, 24});
  const Camera camera = Camera::fromAngles(33.0, -20.0, grid);
  const auto first = [&](ExplosionAxes axes, std::size_t plane) {
    return ExplodedView({0.5, 3, axes}, grid, grid.centre(), camera).parts()[0].kept[plane].normal;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const int along[] = {0, 2, 1};  // L, S and P
    glm::dvec3 axis(0.0);
    axis[along[k]] = 1.0;
    EXPECT_EQ(std::abs(glm::dot(first(ExplosionAxes::Patient, k), axis)), 1.0);
    const Camera::Axes view = camera.axes();
    const glm::dvec3 turned = k == 0 ? view.right : k == 1 ? view.up : view.forward;
    EXPECT_NEAR(std::abs(glm::dot(first(ExplosionAxes::View, k), turned)), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace fenestra::tests::explosionTest
