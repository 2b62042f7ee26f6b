#include "viewer/model/FramePacer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QCoreApplication>

namespace fenestra::viewer {
namespace {

/// Weight of a new measurement: three frames follow a change of speed, one outlier does not make the picture jump.
constexpr double weight = 0.4;

/// The first picture of all: the fewest pixels, and the sampling that needs the fewest programs, because they are
/// compiled meanwhile.
const Effort firstEffort{FramePacer::leastScale, Quality::Normal};

/// A frame that holds both views may take so many times the budget; a longer one leaves out the view that follows.
constexpr double latest = 1.2;

/// Share of the budget that a frame is planned for, because some frames take longer.
constexpr double planned = 0.92;

/// Scales are multiples of 1/64, and follow times only when these have changed by so large a share: in pictures of the
/// size of those before, the renderer allocates no images and keeps the stages that have not changed.
constexpr double scaleSteps = 64.0;
constexpr double steady = 0.06;

/// For a pixel, a picture at rest takes such a share of what the first pictures take, which are small (measured: 0.4 to
/// 0.5).
constexpr double restOfFirst = 0.5;

/// Scales that give way to half the resolution, which shows more than they do. A picture of the least of them takes
/// 0.88 of its time, which is what a frame is planned for.
constexpr double leastForHalf = 0.47, mostForHalf = 0.578;

/// Share of two pictures' time that the view gets which the user turns: it shows more detail than the one that follows.
constexpr double leaderShare = 0.6;

void blend(std::optional<double>& average, double sample) {
  average = average ? *average + weight * (sample - *average) : sample;
}

double steppedDown(double scale) { return std::floor(std::min(scale, 1.0) * scaleSteps) / scaleSteps; }

double orHalf(double scale) {
  return scale >= leastForHalf && scale < mostForHalf ? FramePacer::halfScale : steppedDown(scale);
}

double leadersShareOf(int views) { return views == 1 ? 1.0 : leaderShare; }

}  // namespace

void FramePacer::setAtRest(Quality quality, std::optional<double> maxError) {
  const Effort rest{1.0, quality, maxError};
  if (rest == rest_) return;
  rest_ = rest;
  restCost_.reset();
}

QString nameOf(const Effort& effort) {
  if (!effort.maxError && effort.quality == Quality::Draft) return QCoreApplication::translate("FramePacer", "draft");
  if (!effort.maxError && effort.quality == Quality::Normal) return QCoreApplication::translate("FramePacer", "normal");
  return QCoreApplication::translate("FramePacer", "error ≤ %1/255").arg(effort.maxError.value_or(highQualityError));
}

/// Milliseconds that the pictures of a frame may take together.
double FramePacer::timeForPictures() const {
  // However slow the rest of a frame is, pictures get a part of it.
  return std::max(planned * budget_ - plannedOverhead_, 0.4 * budget_);
}

/// Milliseconds for drafts of which one of the whole resolution takes `cost`: fewer where the leading one is sharp even
/// so.
double FramePacer::timeForDrafts(double cost, int count) const {
  const double quick = planned * quickShare * budget_ - plannedOverhead_;
  const bool isSharp = quick * leadersShareOf(count) >= cost * halfScale * halfScale;
  return isSharp ? quick : timeForPictures();
}

Effort FramePacer::moving(int count, bool leads) const {
  if (restCost_ && *restCost_ * count <= timeForPictures()) return rest_;
  if (!restCost_ && (!draftCost_ || drawn_ < views)) return firstEffort;
  // Until a draft is measured, half the time of a picture at rest is a guess.
  const double cost = plannedCost_ ? *plannedCost_ : 0.5 * *restCost_;
  const double share = count == 1 || leads ? leadersShareOf(count) : 1.0 - leaderShare;
  const double scale = orHalf(std::sqrt(timeForDrafts(cost, count) * share / std::max(cost, 1e-3)));
  return {std::max(scale, count == 1 || leads ? leastScale : leastFollowingScale), Quality::Draft};
}

int FramePacer::framesPerFollowing() const {
  const Effort leader = moving(views, true), follower = moving(views, false);
  if (!draftCost_ || leader == rest_) return 1;
  const auto costOf = [&](const Effort& effort) { return *draftCost_ * effort.scale * effort.scale; };
  const double frame = overhead_.value_or(0.0) + costOf(leader) + costOf(follower);
  // In every second frame at least: a view that is drawn in every third one seems to stand still.
  return frame <= latest * budget_ ? 1 : 2;
}

std::optional<Effort> FramePacer::beforeRest() const {
  if (!restCost_ && !draftCost_) return std::nullopt;
  if (restCost_ && *restCost_ <= 2.0 * firstAtRest) return std::nullopt;
  // First pictures say little: a draft, whose programs are not compiled yet, would have to gain twice as much.
  const bool isQuick = rest_.quality != Quality::High && !rest_.maxError;
  if (!restCost_ && isQuick && *draftCost_ * restOfFirst <= 4.0 * firstAtRest) return std::nullopt;
  const double cost = draftCost_ ? *draftCost_ : 0.5 * *restCost_;
  const double scale = steppedDown(std::sqrt(firstAtRest / std::max(cost, 1e-3)));
  const Effort draft{std::max(scale, leastScale), Quality::Draft};
  return draft == rest_ || scale <= moving(views).scale ? std::nullopt : std::optional(draft);
}

void FramePacer::begin(Effort effort, double now) {
  if (!frame_) frame_ = {.began = now, .effort = effort};
  // A frame goes by the name of its larger picture.
  if (effort.scale > frame_->effort.scale) frame_->effort = effort;
  ++frame_->views;
}

void FramePacer::drew(Effort effort, double milliseconds, bool usual) {
  drawn_ = std::min(drawn_ + 1, views);
  if (frame_) {
    frame_->drawing += milliseconds;
    frame_->usual &= usual;
  }
  if (usual) note(effort, milliseconds);
}

void FramePacer::refined(Effort effort, double milliseconds, bool usual) {
  last_ = {milliseconds, 1, effort};
  if (usual) note(effort, milliseconds);
}

void FramePacer::note(Effort effort, double milliseconds) {
  if (effort == rest_) blend(restCost_, milliseconds);
  // A picture's time grows with its pixels.
  else
    blend(draftCost_, milliseconds / (effort.scale * effort.scale));
  if (draftCost_ && (!plannedCost_ || std::abs(*draftCost_ - *plannedCost_) > steady * *plannedCost_))
    plannedCost_ = draftCost_;
}

void FramePacer::end(double now) {
  if (!frame_) return;
  const Frame frame = *frame_;
  frame_.reset();
  ++frames_;
  last_ = {now - frame.began, frame.views, frame.effort};
  if (frame.usual) blend(overhead_, now - frame.began - frame.drawing);
  if (std::abs(overhead_.value_or(0.0) - plannedOverhead_) > steady * budget_) plannedOverhead_ = *overhead_;
}

bool FramePacer::mayRefine(int view) const {
  const auto rank = [this](int of) {
    const std::optional<int>& level = levels_[static_cast<std::size_t>(of)];
    return level ? 2 * views * *level + (leads(of) ? 0 : 1 + of) : std::numeric_limits<int>::max();
  };
  for (int other = 0; other < views; ++other)
    if (rank(other) < rank(view)) return false;
  return true;
}

}  // namespace fenestra::viewer
