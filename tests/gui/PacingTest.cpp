// Which resolution pictures in motion have, and when a frame is told to have ended.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QObject>

#include "viewer/model/DrawingTurns.h"
#include "viewer/model/FramePacer.h"

namespace fenestra::viewer::pacingTest {
namespace {

/// After frames of a drag of both views, on a machine that needs `full` ms for a draft of a whole view.
FramePacer pacedFor(double full) {
  FramePacer pacer;
  double now = 0.0;
  for (int frame = 0; frame < 12; ++frame) {
    for (const bool leads : {true, false}) {
      const Effort effort = pacer.moving(2, leads);
      const double milliseconds = full * effort.scale * effort.scale;
      pacer.begin(effort, now);
      pacer.drew(effort, milliseconds);
      now += milliseconds;
    }
    pacer.end(now);
  }
  return pacer;
}

double frameOf(const FramePacer& pacer, double full) {
  const double leader = pacer.moving(2, true).scale, follower = pacer.moving(2, false).scale;
  return full * (leader * leader + follower * follower);
}

TEST(Pacing, ScalesNearHalfGiveWayToHalfWithinTheBudget) {
  int halves = 0, others = 0;
  for (double full = 120.0; full < 300.0; full *= 1.03) {
    const FramePacer pacer = pacedFor(full);
    const double scale = pacer.moving(2).scale;
    EXPECT_TRUE(scale == FramePacer::halfScale || scale < 0.47 || scale >= 0.57) << scale;
    // Every one of the pictures of half the resolution in 12 a second or more.
    const bool isHalf = scale == FramePacer::halfScale;
    EXPECT_LE(isHalf ? frameOf(pacer, full) : 0.0, FramePacer::budget) << full;
    ++(isHalf ? halves : others);
  }
  EXPECT_GT(halves, 0);
  EXPECT_GT(others, 0);
}

TEST(Pacing, PicturesThatAreSharpEvenSoComeTwentyTimesASecond) {
  // 0.92 of 50 ms, of which the leader's half of the resolution takes 0.6.
  const double sharpest = 0.92 * 50.0 * 0.6 / 0.25;
  const FramePacer quick = pacedFor(0.97 * sharpest), slow = pacedFor(1.1 * sharpest);
  EXPECT_LE(frameOf(quick, 0.97 * sharpest), 50.0);
  EXPECT_GE(quick.moving(2).scale, FramePacer::halfScale);
  EXPECT_GT(frameOf(slow, 1.1 * sharpest), 50.0);
  EXPECT_LE(frameOf(slow, 1.1 * sharpest), FramePacer::budget);
  EXPECT_GT(slow.moving(2).scale, FramePacer::halfScale) << "sharper at the lower rate";
}

/// After the first pictures of both views, each of so many ms.
FramePacer firstOf(double milliseconds, Quality atRest = Quality::Normal) {
  FramePacer pacer({.quality = atRest});
  for (const bool leads : {true, false}) {
    pacer.begin(pacer.moving(2, leads), 0.0);
    pacer.drew(pacer.moving(2, leads), milliseconds);
  }
  return pacer;
}

TEST(Pacing, FirstPicturesOfBothViewsRunTheSamePrograms) {
  FramePacer pacer;
  const Effort first = pacer.moving(2, true);
  EXPECT_EQ(first.quality, Quality::Normal);
  pacer.begin(first, 0.0);
  pacer.drew(first, 40.0);
  EXPECT_EQ(pacer.moving(2, false), first);
  pacer.drew(first, 40.0);
  EXPECT_EQ(pacer.moving(2, true).quality, Quality::Draft);
  EXPECT_EQ(pacer.moving(2, false).quality, Quality::Draft);
}

TEST(Pacing, NoDraftComesBeforeTheFirstPicturesAtRestUnlessTheyAreSlow) {
  // A picture of a sixteenth of the pixels; the one at rest takes half of its time for a pixel, 600 ms at most.
  const double most = 4.0 * FramePacer::firstAtRest / 16.0 / 0.5;
  EXPECT_FALSE(firstOf(0.95 * most).beforeRest());
  EXPECT_TRUE(firstOf(1.05 * most).beforeRest());
  EXPECT_TRUE(firstOf(0.95 * most, Quality::High).beforeRest()) << "those take many times as long";
}

TEST(Pacing, ALinkedViewThatIsDrawnAloneGetsAllOfTheTime) {
  const FramePacer pacer = pacedFor(200.0);
  EXPECT_EQ(pacer.moving(1, false), pacer.moving(1, true));
}

TEST(Pacing, ARoundBeginsOnceBeforeItsFirstView) {
  FramePacer pacer;
  DrawingTurns turns(pacer);
  QObject context;
  std::vector<int> told;  // a view's number; -2 and -1 where a round begins and ends
  QObject::connect(&turns, &DrawingTurns::roundBegins, &context, [&] { told.push_back(-2); });
  QObject::connect(&turns, &DrawingTurns::turn, &context, [&](int view) { told.push_back(view); });
  QObject::connect(&turns, &DrawingTurns::roundEnded, &context, [&] { told.push_back(-1); });
  for (int round = 0; round < 2; ++round) {
    told.clear();
    turns.ask(0);
    turns.ask(1);
    while (told.empty() || told.back() != -1) QCoreApplication::processEvents();
    EXPECT_EQ(told, (std::vector<int>{-2, 0, 1, -1})) << round;
  }
}

}  // namespace
}  // namespace fenestra::viewer::pacingTest
