// How slices lie, without a window.

#include <memory>

#include <QSignalSpy>
#include <QTest>

#include <glm/gtc/constants.hpp>

#include "tests/gui/Patience.h"
#include "viewer/model/Document.h"
#include "viewer/model/Fidelity.h"
#include "viewer/model/SlabText.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/SlicePlanes.h"
#include "viewer/model/ViewLink.h"

#include <gtest/gtest.h>

namespace fenestra::viewer::slicePlanesTest {
namespace {

constexpr double degree = glm::pi<double>() / 180.0;

class SlicePlanesModel : public testing::Test {
 protected:
  /// Voxels of 0.5 × 1 × 3 mm.
  void SetUp() override {
    auto volume = std::make_shared<Volume>();
    volume->grid = {.dims = {60, 40, 20}, .spacing = {0.5, 1.0, 3.0}, .origin = {-10.0, 5.0, 100.0}};
    volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
    volume->computeRange();
    io::Study study;
    study.scene.volume = volume;
    document_.open(std::move(study));
    cursor_.setGrid(volume->grid);
  }

  /// How far the crosshair is from the slice that a plane shows, mm.
  double offPlane(SlicePlane plane) const {
    const SliceGeometry geometry = planes_.geometry(plane);
    const glm::dvec3 pixel = geometry.pixelFromWorld(cursor_.position());
    return std::abs(pixel.z - cursor_.slice(geometry)) * glm::length(geometry.normal);
  }

  Document document_;
  SliceCursor cursor_;
  ViewLink cameras_;
  SlicePlanes planes_{document_, cursor_, cameras_};
};

TEST_F(SlicePlanesModel, AreTheVolumesOwnSlicesUntilTheyAreTurned) {
  for (const SlicePlane plane : SlicePlanes::all) {
    EXPECT_FALSE(planes_.isTurned(plane));
    EXPECT_EQ(planes_.geometry(plane).axis, sliceGeometry(document_.scene().volume->grid, plane).axis);
    EXPECT_EQ(planes_.tilt(plane).degrees, 0.0);
    EXPECT_EQ(planes_.tilt(plane).from, plane);
  }
}

TEST_F(SlicePlanesModel, ATurnedPlanePassesThroughTheCrosshairAndStepsAlongItsOwnNormal) {
  const glm::dvec3 about = glm::normalize(glm::dvec3(0.3, -0.5, 0.8));
  planes_.setAxes(SlicePlane::Coronal, turned(planes_.axes(SlicePlane::Coronal), about, 0.7));
  const glm::dvec3 normal = planes_.axes(SlicePlane::Coronal).normal;
  for (const glm::dvec3 place : {glm::dvec3(0.0, 20.0, 120.0), glm::dvec3(3.21, 17.7, 131.3)}) {
    cursor_.moveTo(place);
    // Coordinates of 100 mm carry 14 digits.
    EXPECT_LT(offPlane(SlicePlane::Coronal), 1e-9);
    const SliceGeometry geometry = planes_.geometry(SlicePlane::Coronal);
    const int before = cursor_.slice(geometry);
    cursor_.step(geometry, 2);
    const glm::dvec3 moved = cursor_.position() - place;
    EXPECT_LT(glm::distance(moved, 2.0 * voxelLength(document_.scene().volume->grid, normal) * normal), 1e-9);
    EXPECT_EQ(cursor_.slice(planes_.geometry(SlicePlane::Coronal)), before + 2);
  }
}

TEST_F(SlicePlanesModel, StepsReachBothEndsOfATurnedPlaneAndStayThere) {
  planes_.setAxes(SlicePlane::Axial, turned(planes_.axes(SlicePlane::Axial), {1, 0, 0}, 35.0 * degree));
  planes_.setAxes(SlicePlane::Axial, turned(planes_.axes(SlicePlane::Axial), {0, 1, 0}, 25.0 * degree));
  const Grid& grid = document_.scene().volume->grid;
  const glm::dvec3 normal = planes_.axes(SlicePlane::Axial).normal;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 index = glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * glm::dvec3(grid.dims - 1);
    const double along = glm::dot(glm::dvec3(grid.worldFromIndex() * glm::dvec4(index, 1.0)), normal);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  for (const int way : {1, -1}) {
    double last = glm::dot(cursor_.position(), normal);
    for (int step = 0; step < 200; ++step) {
      cursor_.step(planes_.geometry(SlicePlane::Axial), way);
      const double now = glm::dot(cursor_.position(), normal);
      EXPECT_GE(way * (now - last), -1e-4) << "never back";
      EXPECT_LT(offPlane(SlicePlane::Axial), 1e-9);
      last = now;
    }
    // The last slice that holds a voxel's centre, at most a step from the corner.
    EXPECT_LT(std::abs(last - (way > 0 ? high : low)), voxelLength(grid, normal) + 1e-6);
  }
}

TEST_F(SlicePlanesModel, PixelsKeepTheirPlacesWhileTheCrosshairMoves) {
  planes_.setAxes(SlicePlane::Axial, turned(planes_.axes(SlicePlane::Axial), {1, 0, 0}, 20.0 * degree));
  const SliceGeometry before = planes_.geometry(SlicePlane::Axial);
  cursor_.moveTo(cursor_.position() + glm::dvec3(2.3, -4.1, 5.7));
  const SliceGeometry after = planes_.geometry(SlicePlane::Axial);
  EXPECT_EQ(after.width, before.width);
  EXPECT_EQ(after.height, before.height);
  const glm::dvec3 pixel = before.pixelFromWorld(after.origin);
  EXPECT_NEAR(pixel.x, 0.0, 1e-9);
  EXPECT_NEAR(pixel.y, 0.0, 1e-9);
}

TEST_F(SlicePlanesModel, SayHowFarTheyAreFromTheNearestAnatomicalPlane) {
  const PlaneAxes axial = planes_.axes(SlicePlane::Axial);
  planes_.setAxes(SlicePlane::Axial, turned(axial, {1, 0, 0}, 30.0 * degree));
  EXPECT_NEAR(planes_.tilt(SlicePlane::Axial).degrees, 30.0, 1e-9);
  EXPECT_EQ(planes_.tilt(SlicePlane::Axial).from, SlicePlane::Axial);
  planes_.setAxes(SlicePlane::Axial, turned(axial, {1, 0, 0}, -70.0 * degree));
  EXPECT_NEAR(planes_.tilt(SlicePlane::Axial).degrees, 20.0, 1e-9);
  EXPECT_EQ(planes_.tilt(SlicePlane::Axial).from, SlicePlane::Coronal);
  planes_.setAxes(SlicePlane::Axial, turned(axial, {0, 1, 0}, 88.0 * degree));
  EXPECT_NEAR(planes_.tilt(SlicePlane::Axial).degrees, 2.0, 1e-9);
  EXPECT_EQ(planes_.tilt(SlicePlane::Axial).from, SlicePlane::Sagittal);
}

TEST_F(SlicePlanesModel, AThousandTurnsStayPerpendicular) {
  PlaneAxes axes = planes_.axes(SlicePlane::Sagittal);
  for (int i = 0; i < 1000; ++i) axes = turned(axes, glm::normalize(glm::dvec3(i % 3, 1, i % 7)), 0.1);
  const glm::dmat3 matrix(axes.right, axes.down, axes.normal);
  EXPECT_NEAR(glm::determinant(matrix), -1.0, 1e-12) << "sagittal pictures are left-handed and stay so";
  EXPECT_TRUE(isPerpendicular(axes));
}

TEST_F(SlicePlanesModel, FaceACameraUntilTheyAreTurnedByHand) {
  planes_.setFollow(SlicePlane::Axial, PlaneFollow::C1);
  planes_.setFollow(SlicePlane::Coronal, PlaneFollow::C2);
  QSignalSpy changed(&planes_, &SlicePlanes::changed);
  for (int i = 0; i < 3; ++i) {
    cameras_.orbit(0, 0.4, 0.2);
    EXPECT_EQ(planes_.axes(SlicePlane::Axial), axesFacing(cameras_.camera(0)));
    EXPECT_EQ(planes_.axes(SlicePlane::Coronal), axesFacing(cameras_.camera(1)));
    EXPECT_TRUE(planes_.isMoving(SlicePlane::Axial));
    EXPECT_FALSE(planes_.isMoving(SlicePlane::Sagittal));
    EXPECT_LT(offPlane(SlicePlane::Axial), 1e-9);
  }
  const PlaneAxes axes = planes_.axes(SlicePlane::Axial);
  const Camera::Axes camera = cameras_.camera(0).axes();
  EXPECT_EQ(axes.right, camera.right);
  EXPECT_EQ(axes.down, -camera.up);
  EXPECT_EQ(axes.normal, camera.forward);
  changed.clear();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !planes_.isMoving(SlicePlane::Axial); }, patience));
  EXPECT_FALSE(changed.isEmpty()) << "so that views draw the picture at rest";

  planes_.setAxes(SlicePlane::Axial, turned(axes, {0, 0, 1}, 0.1));
  EXPECT_EQ(planes_.pose(SlicePlane::Axial).follow, PlaneFollow::None);
  const PlaneAxes byHand = planes_.axes(SlicePlane::Axial);
  cameras_.orbit(0, 0.4, 0.2);
  EXPECT_EQ(planes_.axes(SlicePlane::Axial), byHand);
  planes_.setFollow(SlicePlane::Coronal, PlaneFollow::None);
  EXPECT_TRUE(planes_.isTurned(SlicePlane::Coronal)) << "stays as it lies";
  planes_.resetAll();
  for (const SlicePlane plane : SlicePlanes::all) EXPECT_FALSE(planes_.isTurned(plane));
}

TEST_F(SlicePlanesModel, AnUnturnedPlaneHearsNothingOfTheCameras) {
  QSignalSpy changed(&planes_, &SlicePlanes::changed);
  cameras_.orbit(0, 0.4, 0.2);
  EXPECT_TRUE(changed.isEmpty());
}

TEST_F(SlicePlanesModel, SlabsGoThroughTheThicknessesAndStayInRange) {
  const SlicePlane plane = SlicePlane::Axial;
  planes_.stepSlab(plane, -1);
  EXPECT_EQ(planes_.pose(plane).slab.thickness, 0.0);
  planes_.stepSlab(plane, 2);
  EXPECT_EQ(planes_.pose(plane).slab.thickness, 2.0);
  planes_.setSlab(plane, {2.4, SlabMode::Mean});
  planes_.stepSlab(plane, 1);
  EXPECT_EQ(planes_.pose(plane).slab, (Slab{3.0, SlabMode::Mean}));
  planes_.setSlab(plane, {2.4, SlabMode::Mean});
  planes_.stepSlab(plane, -1);
  EXPECT_EQ(planes_.pose(plane).slab.thickness, 2.0);
  planes_.stepSlab(plane, 50);
  EXPECT_EQ(planes_.pose(plane).slab.thickness, io::mostSlab);
  planes_.setSlab(plane, {1e9, SlabMode::Mean});
  EXPECT_EQ(planes_.pose(plane).slab.thickness, io::mostSlab);
  planes_.reset(plane);
  EXPECT_EQ(planes_.pose(plane).slab.thickness, io::mostSlab) << "a plane's reset is no matter of its slab";
  EXPECT_EQ(slabText({10.0, SlabMode::Maximum}), QStringLiteral("MIP 10 mm"));
  EXPECT_EQ(slabText({2.5, SlabMode::Minimum}), QStringLiteral("MinIP 2.5 mm"));
}

TEST_F(SlicePlanesModel, AnotherVolumeResetsThem) {
  planes_.setFollow(SlicePlane::Axial, PlaneFollow::C1);
  planes_.setSlab(SlicePlane::Coronal, {5.0, SlabMode::Mean});
  SetUp();
  EXPECT_EQ(planes_.poses(), (std::array<PlanePose, 3>()));
}

TEST_F(SlicePlanesModel, AnIndexPlaneOfAStudyIsFaithfulAndASlabIsNot) {
  const auto grade = [&](PictureState state) {
    state.is3D = false;
    return gradeOf(fidelityOf(document_.study(), document_.scene(), state));
  };
  EXPECT_EQ(grade({.isTurned = true}), Fidelity::Faithful);
  EXPECT_EQ(grade({.isDraft = true, .isTurned = true}), Fidelity::Altered);
  for (const SlabMode mode : {SlabMode::Maximum, SlabMode::Minimum, SlabMode::Mean})
    EXPECT_EQ(grade({.slab = {10.0, mode}}), Fidelity::Altered);
  EXPECT_TRUE(linesOf(fidelityOf(document_.study(), document_.scene(), {.is3D = false, .slab = {10.0, SlabMode::Mean}}))
                  .contains(QStringLiteral("a slab: the mean of 10 mm shows")));
}

}  // namespace
}  // namespace fenestra::viewer::slicePlanesTest
