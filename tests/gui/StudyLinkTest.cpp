// Two studies side by side, without a window: what the link moves, and what it leaves.

#include <array>

#include <QSignalSpy>

#include <gtest/gtest.h>

#include "viewer/model/SliceCursor.h"
#include "viewer/model/StudyLink.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer::studyLinkTest {
namespace {

/// The left study has voxels of 1 mm in a box of 100 mm, the right one of 0.7 × 0.7 × 5 mm in a lower one.
class TwoStudies : public testing::Test {
 protected:
  void SetUp() override {
    cursors_[0].setGrid({.dims = {101, 101, 101}, .spacing = {1.0, 1.0, 1.0}, .origin = {-50.0, -50.0, -50.0}});
    cursors_[1].setGrid({.dims = {201, 201, 11}, .spacing = {0.7, 0.7, 5.0}, .origin = {-70.0, -70.0, -25.0}});
    for (int side = 0; side < StudyLink::sides; ++side) {
      ViewLink& cameras = cameras_[static_cast<std::size_t>(side)];
      cameras.setAnimated(false);
      Camera camera;
      camera.target = {side * 10.0, 0.0, 0.0};
      camera.eye = camera.target + glm::dvec3(0.0, -300.0 - 50.0 * side, 0.0);
      camera.up = {0.0, 0.0, 1.0};
      cameras.place({camera, camera.rotated(glm::dmat3(0, 1, 0, -1, 0, 0, 0, 0, 1))});
      link_.join(side, cursors_[static_cast<std::size_t>(side)], cameras);
    }
    link_.setCompared(true);
  }
  SliceCursor& left() { return cursors_[0]; }
  SliceCursor& right() { return cursors_[1]; }

  // Indices there and back round in the last digits; mm.
  static constexpr double rounding = 1e-9;
  std::array<SliceCursor, 2> cursors_;
  std::array<ViewLink, 2> cameras_;
  StudyLink link_;
};

void expectSameDirection(const Camera& one, const Camera& other) {
  constexpr double turned = 1e-12;  // of unit vectors
  EXPECT_LT(glm::distance(one.axes().forward, other.axes().forward), turned);
  EXPECT_LT(glm::distance(one.axes().up, other.axes().up), turned);
}

}  // namespace

TEST_F(TwoStudies, GoTheirOwnWaysUntilTheyAreLinked) {
  const glm::dvec3 before = right().position();
  const Camera camera = cameras_[1].camera(0);
  left().moveTo({10, 20, 5});
  cameras_[0].orbit(0, 0.3, 0.1);
  EXPECT_EQ(right().position(), before);
  EXPECT_EQ(cameras_[1].camera(0), camera);
}

TEST_F(TwoStudies, LinkedHaveTheirCrosshairsAtTheSameMillimetre) {
  right().moveTo({-20, -20, 20});
  left().moveTo({10, 20, 5});
  link_.setLinked(true, 0);
  EXPECT_LT(glm::distance(right().position(), glm::dvec3(10, 20, 5)), rounding) << "the leader's place";
  left().moveTo({-3.3, 7, -12.4});
  EXPECT_LT(glm::distance(right().position(), glm::dvec3(-3.3, 7, -12.4)), rounding);
  right().moveTo({1, 2, 3});
  EXPECT_LT(glm::distance(left().position(), glm::dvec3(1, 2, 3)), rounding) << "both ways";
  link_.setLinked(false, 0);
  left().moveTo({0, 0, 0});
  EXPECT_LT(glm::distance(right().position(), glm::dvec3(1, 2, 3)), rounding);
}

TEST_F(TwoStudies, SayWhereTheOtherEnds) {
  left().moveTo({0, 0, 0});
  link_.setLinked(true, 0);
  EXPECT_EQ(link_.beyond(), 0.0);
  left().moveTo({0, 0, 40});
  EXPECT_LT(glm::distance(left().position(), glm::dvec3(0, 0, 40)), rounding) << "the other's end is not its own";
  EXPECT_NEAR(right().position().z, 25.0, rounding);
  EXPECT_NEAR(link_.beyond(), 15.0, rounding);
  left().moveTo({0, 0, 10});
  EXPECT_EQ(link_.beyond(), 0.0);
}

TEST_F(TwoStudies, KeepTheOffsetOfAPairOfPoints) {
  left().moveTo({10, 0, 0});
  right().moveTo({-5, 3, 8});
  link_.match();
  EXPECT_TRUE(link_.isLinked());
  EXPECT_LT(glm::distance(link_.offset(), glm::dvec3(-15, 3, 8)), rounding);
  left().moveTo({20, 5, -10});
  EXPECT_LT(glm::distance(right().position(), glm::dvec3(5, 8, -2)), rounding);
  right().moveTo({0, 0, 0});
  EXPECT_LT(glm::distance(left().position(), glm::dvec3(15, -3, -8)), rounding);
  // Unlinking keeps the pair: one may look around and come back.
  link_.setLinked(false, 0);
  right().moveTo({-30, -30, -20});
  link_.setLinked(true, 0);
  EXPECT_LT(glm::distance(right().position(), glm::dvec3(0, 0, 0)), rounding);
  link_.forgetPair(0);
  EXPECT_FALSE(link_.isMatched());
  EXPECT_EQ(link_.offset(), glm::dvec3(0.0));
  EXPECT_LT(glm::distance(right().position(), left().position()), rounding);
}

TEST_F(TwoStudies, TurnAndZoomTogetherAboutTheirOwnTargets) {
  link_.setLinked(true, 0);
  const glm::dvec3 target = cameras_[1].camera(0).target;
  cameras_[0].orbit(0, 0.4, -0.2);
  cameras_[0].zoom(0, 1.5);
  for (int view = 0; view < ViewLink::count; ++view) {
    const Camera &one = cameras_[0].camera(view), &other = cameras_[1].camera(view);
    expectSameDirection(one, other);
    EXPECT_NEAR(glm::distance(one.eye, one.target), glm::distance(other.eye, other.target), rounding) << "same scale";
  }
  EXPECT_EQ(cameras_[1].camera(0).target, target);
  // A parallel one beside a perspective one: as many millimetres from the bottom to the top at the target.
  cameras_[1].setProjection(Projection::Orthographic);
  EXPECT_EQ(cameras_[0].projection(), Projection::Perspective);
  cameras_[0].zoom(0, 2.0);
  const Camera& from = cameras_[0].camera(0);
  EXPECT_NEAR(cameras_[1].camera(0).orthographicHeight,
              2.0 * std::tan(glm::radians(from.verticalFov) / 2.0) * glm::distance(from.eye, from.target), rounding);
  cameras_[1].orbit(1, 0.2, 0.0);
  expectSameDirection(cameras_[0].camera(1), cameras_[1].camera(1));
}

TEST_F(TwoStudies, EndTheLinkWithTheComparison) {
  left().moveTo({10, 0, 0});
  link_.match();
  QSignalSpy changed(&link_, &StudyLink::changed);
  link_.setCompared(false);
  EXPECT_GT(changed.count(), 0);
  EXPECT_FALSE(link_.isLinked());
  EXPECT_FALSE(link_.isMatched());
  link_.setLinked(true, 0);
  link_.match();
  EXPECT_FALSE(link_.isLinked()) << "there is nothing to link";
}

}  // namespace fenestra::viewer::studyLinkTest
