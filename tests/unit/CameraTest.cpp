#include "rendering/settings/FlatStack.h"

#include <gtest/gtest.h>

#include "tests/support/Scenes.h"

namespace fenestra::cameraTest {
namespace {

using namespace tests;

constexpr double rounding = 1e-12;  // a handful of operations on numbers near 1

void expectNear(glm::dvec3 actual, glm::dvec3 expected, double tolerance) {
  EXPECT_NEAR(actual.x, expected.x, tolerance);
  EXPECT_NEAR(actual.y, expected.y, tolerance);
  EXPECT_NEAR(actual.z, expected.z, tolerance);
}

void expectOrthonormal(const Camera& camera) {
  const Camera::Axes a = camera.axes();
  EXPECT_NEAR(glm::length(a.right), 1.0, rounding);
  EXPECT_NEAR(glm::length(a.up), 1.0, rounding);
  EXPECT_NEAR(glm::length(a.forward), 1.0, rounding);
  expectNear(glm::cross(a.right, a.up), -a.forward, rounding);
}

TEST(Camera, aimedHasAPointInTheMiddle) {
  const glm::dvec3 point(12.0, 3.0, -7.0);
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    const Camera camera = lookAt({40.0, -60.0, 15.0}, {1.0, 2.0, 3.0}, projection);
    const auto aimed = camera.aimedAt(point);
    ASSERT_TRUE(aimed);
    const Camera::Axes a = aimed->axes();
    const double depth = glm::dot(point - aimed->eye, a.forward);
    expectNear(aimed->eye + depth * a.forward, point, 1e-12 * 100.0);
    if (projection == Projection::Perspective) {
      EXPECT_EQ(aimed->eye, camera.eye);
    } else {
      expectNear(a.forward, camera.axes().forward, rounding);
      // The point stays in its plane, so that positions along rays do not change.
      EXPECT_NEAR(depth, glm::dot(point - camera.eye, camera.axes().forward), 1e-12 * 100.0);
    }
    EXPECT_FALSE(camera.aimedAt(camera.eye - (point - camera.eye)));
    EXPECT_FALSE(camera.aimedAt(camera.eye));
  }
}

TEST(Camera, standardViewsPutThePatientsSidesRight) {
  const Grid grid = gridOf({10, 20, 30});
  const glm::dvec3 left(1, 0, 0), right(-1, 0, 0), posterior(0, 1, 0), anterior(0, -1, 0), superior(0, 0, 1);
  const struct {
    StandardView view;
    glm::dvec3 rightOfPicture, topOfPicture;
  } cases[] = {
      {StandardView::Anterior, left, superior},  {StandardView::Posterior, right, superior},
      {StandardView::Left, posterior, superior}, {StandardView::Right, anterior, superior},
      {StandardView::Superior, right, anterior}, {StandardView::Inferior, left, anterior},
  };
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
    for (const auto& c : cases) {
      const Camera camera = Camera::standard(c.view, grid, projection);
      expectNear(camera.axes().right, c.rightOfPicture, rounding);
      expectNear(camera.axes().up, c.topOfPicture, rounding);
    }
}

TEST(Camera, thePatientIsUprightFromEveryDirection) {
  const Grid grid = gridOf({10, 20, 30});
  for (double elevation = -90.0; elevation <= 90.0; elevation += 5.0)
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 45.0) {
      const double el = glm::radians(elevation), az = glm::radians(azimuth);
      const glm::dvec3 direction(std::cos(el) * std::sin(az), -std::cos(el) * std::cos(az), std::sin(el));
      const Camera camera = Camera::fromDirection(direction, grid);
      expectOrthonormal(camera);
      // Superior points up in the picture, or anterior where the camera looks along the body.
      const glm::dvec3 up = std::abs(elevation) > 75.0 ? glm::dvec3(0, -1, 0) : glm::dvec3(0, 0, 1);
      EXPECT_GT(glm::dot(camera.axes().up, up), 0.25) << azimuth << ' ' << elevation;
      EXPECT_NEAR(glm::dot(camera.axes().right, up), 0.0, rounding);
    }
  for (const StandardView view : {StandardView::Anterior, StandardView::Posterior, StandardView::Left,
                                  StandardView::Right, StandardView::Superior, StandardView::Inferior}) {
    const Camera standard = Camera::standard(view, grid);
    expectNear(Camera::fromDirection(-standard.axes().forward, grid).axes().up, standard.axes().up, rounding);
  }
}

TEST(Camera, anglesMeetTheStandardViews) {
  const Grid grid = gridOf({10, 20, 30});
  const struct {
    double azimuth, elevation;
    StandardView view;
  } cases[] = {{0, 0, StandardView::Anterior},
               {90, 0, StandardView::Left},
               {180, 0, StandardView::Posterior},
               {-90, 0, StandardView::Right},
               {0, -90, StandardView::Inferior}};
  for (const auto& c : cases) {
    const Camera a = Camera::fromAngles(c.azimuth, c.elevation, grid), b = Camera::standard(c.view, grid);
    expectNear(a.axes().forward, b.axes().forward, rounding);
    expectNear(a.eye, b.eye, 1e-9);
  }
}

TEST(Camera, anglesAreContinuousUpToThePoles) {
  const Grid grid = gridOf({10, 20, 30});
  for (const double azimuth : {0.0, 37.0, 190.0})
    for (const double pole : {90.0, -90.0}) {
      const Camera at = Camera::fromAngles(azimuth, pole, grid);
      const Camera near = Camera::fromAngles(azimuth, pole * (1.0 - 1e-5), grid);
      expectOrthonormal(at);
      expectNear(at.axes().up, near.axes().up, 1e-4);  // the tilt between them is 1.6e-5 rad
    }
}

TEST(Camera, framedVolumeLiesInsideTheSquarePicture) {
  const Grid grid = obliqueGrid({40, 30, 20});
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
    for (double azimuth = 0.0; azimuth < 360.0; azimuth += 30.0)
      for (const double elevation : {-90.0, -30.0, 0.0, 45.0, 90.0}) {
        const Camera camera = Camera::fromAngles(azimuth, elevation, grid, projection);
        const glm::dmat4 clipFromWorld = camera.clipFromWorld(1.0, grid);
        double reach = 0.0;
        for (const glm::dvec3& corner : grid.corners()) {
          const glm::dvec4 clip = clipFromWorld * glm::dvec4(corner, 1.0);
          const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
          reach = std::max({reach, std::abs(ndc.x), std::abs(ndc.y)});
          EXPECT_LE(std::abs(ndc.z), 1.0 + 1e-9);
        }
        EXPECT_LE(reach, 1.0);
        EXPECT_GE(reach, 0.9);  // and fills it
      }
}

TEST(Camera, degenerateUpStillGivesAxes) {
  Camera camera = lookAt({0, -100, 0}, {0, 0, 0});
  for (const glm::dvec3 up : {glm::dvec3(0, 1, 0), glm::dvec3(0, -5, 0), glm::dvec3(0), glm::dvec3(1e-9, 1, 0)}) {
    camera.up = up;
    expectOrthonormal(camera);
  }
  camera.eye = camera.target;
  expectOrthonormal(camera);
}

TEST(Camera, viewFromWorldLooksAlongMinusZ) {
  const Camera camera = lookAt({3, -40, 10}, {1, 2, 3});
  const glm::dvec3 target(camera.viewFromWorld() * glm::dvec4(camera.target, 1.0));
  expectNear(target, {0, 0, -glm::distance(camera.eye, camera.target)}, 1e-12);
  const glm::dvec3 eye(camera.viewFromWorld() * glm::dvec4(camera.eye, 1.0));
  expectNear(eye, glm::dvec3(0.0), 1e-12);
}

TEST(Camera, orthographicNearPlaneIsThePlaneThroughTheEye) {
  const Grid grid = gridOf({10, 10, 10});
  const Camera camera = Camera::standard(StandardView::Left, grid, Projection::Orthographic);
  const glm::dvec4 clip = camera.clipFromWorld(1.5, grid) * glm::dvec4(camera.eye, 1.0);
  EXPECT_NEAR(clip.z / clip.w, -1.0, rounding);
}

TEST(Camera, orbitKeepsTheDistanceAndTheTarget) {
  Camera camera = Camera::standard(StandardView::Anterior, gridOf({10, 20, 30}));
  const double distance = glm::distance(camera.eye, camera.target);
  for (int i = 0; i < 100; ++i) camera = camera.orbited(0.3, 0.17);
  expectOrthonormal(camera);
  EXPECT_NEAR(glm::distance(camera.eye, camera.target), distance, 1e-9 * distance);
  const Camera turned = Camera::standard(StandardView::Anterior, gridOf({10, 20, 30})).orbited(glm::radians(90.0), 0.0);
  expectNear(turned.axes().forward, Camera::standard(StandardView::Left, gridOf({10, 20, 30})).axes().forward,
             rounding);
}

TEST(Camera, rotatedCameraSeesTheRotatedWorldAsBefore) {
  const Camera camera = lookAt({30, -40, 10}, {1, 2, 3});
  const glm::dmat3 turn(glm::rotate(glm::dmat4(1.0), 1.1, glm::normalize(glm::dvec3(0.3, -1.0, 0.6))));
  const Camera rotated = camera.rotated(turn);
  const glm::dvec3 point(7, -3, 9), moved = camera.target + turn * (point - camera.target);
  expectNear(glm::dvec3(rotated.viewFromWorld() * glm::dvec4(moved, 1.0)),
             glm::dvec3(camera.viewFromWorld() * glm::dvec4(point, 1.0)), 1e-12 * 100);
}

TEST(Camera, zoomAndPan) {
  const Camera camera = lookAt({0, -100, 0}, {0, 0, 0});
  const Camera closer = camera.zoomed(2.0);
  EXPECT_DOUBLE_EQ(glm::distance(closer.eye, closer.target), 50.0);
  EXPECT_DOUBLE_EQ(closer.orthographicHeight, 0.5 * camera.orthographicHeight);
  const Camera panned = camera.panned(3.0, 4.0);
  expectNear(panned.eye - camera.eye, {3, 0, 4}, rounding);
  expectNear(panned.target - camera.target, {3, 0, 4}, rounding);
  Camera parallel = camera;
  parallel.projection = Projection::Orthographic;
  EXPECT_EQ(parallel.zoomed(2.0).eye, parallel.eye);
}

TEST(Camera, AWiderPictureBeginsWithTheSamePixels) {
  const Grid grid = gridOf(glm::ivec3(40));
  const glm::ivec2 from(611, 487), to(612, 488);
  for (const Projection projection : {Projection::Perspective, Projection::Orthographic}) {
    const Camera camera = Camera::standard(StandardView::Anterior, grid, projection);
    const Camera wider = camera.widened(from, to);
    const auto place = [&](const Camera& of, glm::ivec2 size, glm::dvec3 point) {
      const glm::dvec4 clip = of.clipFromWorld(double(size.x) / size.y, grid) * glm::dvec4(point, 1.0);
      return glm::dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * glm::dvec2(size);
    };
    for (const glm::dvec3 corner : {glm::dvec3(0.0), {20, 0, 20}, {-20, 20, -20}, {20, -20, -20}, {-20, -20, 20}}) {
      const glm::dvec3 point = camera.target + corner;
      // Half a pixel's turn about the eye shifts what is 15° aside by 7 % of it; the picture's own middle by nothing.
      EXPECT_LT(glm::distance(place(camera, from, point), place(wider, to, point)), 0.1);
    }
    EXPECT_LT(glm::distance(place(camera, from, camera.target), place(wider, to, camera.target)), 0.01);
  }
}

TEST(Camera, AFlatVolumeIsFirstSeenFromWhereItsSlicesAre) {
  const Projection projection = Projection::Perspective;
  const glm::dvec3 left(1, 0, 0), anterior(0, -1, 0), inferior(0, 0, -1);
  const struct {
    glm::dvec3 front, aside, up, upAside;
  } expected[] = {{left, anterior, -inferior, -inferior},
                  {anterior, left, -inferior, -inferior},
                  {inferior, anterior, anterior, -inferior}};
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 dims(40);
    dims[axis] = 3;
    const Grid grid = gridOf(dims);
    const Camera first = firstCamera(grid, grid, projection), second = secondCamera(first, grid);
    expectNear(-first.axes().forward, expected[axis].front, rounding);
    expectNear(first.up, expected[axis].up, rounding);
    expectNear(-second.axes().forward, glm::normalize(expected[axis].front + expected[axis].aside), rounding);
    expectNear(second.up, expected[axis].upAside, rounding);
    expectOrthonormal(second);
    EXPECT_EQ(second.target, first.target);
    EXPECT_NEAR(glm::distance(second.eye, second.target), glm::distance(first.eye, first.target), rounding * 1e3);
    // A view that somebody chose has its partner beside it.
    const Camera chosen = Camera::fromAngles(30.0, 20.0, grid);
    EXPECT_EQ(secondCamera(chosen, grid), chosen.beside());
  }
}

TEST(Camera, AVolumeThatIsNotFlatIsFirstSeenFromTheFrontAndTheLeft) {
  for (const glm::ivec3 dims : {glm::ivec3(40), glm::ivec3(40, 40, 20), glm::ivec3(8, 8, 3)}) {
    const Grid grid = gridOf(dims);
    const Camera first = firstCamera(grid, grid, Projection::Orthographic);
    EXPECT_EQ(first, Camera::standard(StandardView::Anterior, grid, Projection::Orthographic));
    EXPECT_EQ(secondCamera(first, grid), first.beside());
    expectNear(-first.beside().axes().forward, {1, 0, 0}, rounding);
  }
}

}  // namespace
}  // namespace fenestra::cameraTest
