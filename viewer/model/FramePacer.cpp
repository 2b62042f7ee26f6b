#include "viewer/model/FramePacer.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

namespace fenestra::viewer {
namespace {

/// Weight of a new measurement: three frames follow a change of speed, one outlier does not make the picture jump.
constexpr double weight = 0.4;

void blend(std::optional<double>& average, double sample) {
  average = average ? *average + weight * (sample - *average) : sample;
}

}  // namespace

void FramePacer::setAtRest(Quality quality, std::optional<double> maxError) {
  const Effort rest{1.0, quality, maxError};
  if (rest == rest_) return;
  rest_ = rest;
  restCost_.reset();
}

QString nameOf(const Effort& effort) {
  const auto translated = [](const char* text) { return QCoreApplication::translate("FramePacer", text); };
  if (!effort.maxError && effort.quality == Quality::Draft) return translated("draft");
  if (!effort.maxError && effort.quality == Quality::Normal) return translated("normal");
  return translated("error ≤ %1/255").arg(effort.maxError.value_or(highQualityError));
}

Effort FramePacer::moving(int views) const {
  if (restCost_ && *restCost_ * views <= budget) return rest_;
  if (!draftCost_ && !restCost_) return {0.5, Quality::Draft};
  // Until a draft is measured, half the time of a picture at rest is a guess.
  const double cost = draftCost_ ? *draftCost_ : 0.5 * *restCost_;
  const double scale = std::sqrt(budget / (std::max(cost, 1e-3) * views));
  // In steps of a sixteenth, so that the renderer seldom has to allocate images of another size.
  const double stepped = std::floor(std::min(scale, 1.0) * 16.0) / 16.0;
  return {std::max(stepped, leastScale), Quality::Draft};
}

void FramePacer::begin(Effort effort, double now) {
  if (!frame_) frame_ = {.began = now, .effort = effort};
  frame_->mixed |= effort != frame_->effort;
  ++frame_->views;
}

void FramePacer::end(double now) {
  if (!frame_) return;
  const Frame frame = *frame_;
  frame_.reset();
  if (frame.mixed) return;
  last_ = {now - frame.began, frame.views, frame.effort};
  const double perView = (now - frame.began) / frame.views;
  if (frame.effort == rest_) blend(restCost_, perView);
  // A frame's time grows with its pixels.
  else
    blend(draftCost_, perView / (frame.effort.scale * frame.effort.scale));
}

}  // namespace fenestra::viewer
