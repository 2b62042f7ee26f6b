#include "viewer/model/StudyLink.h"

#include <cassert>

#include <QScopedValueRollback>

#include "viewer/model/SliceCursor.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer {

void StudyLink::join(int at, SliceCursor& cursor, ViewLink& cameras) {
  side(at) = {&cursor, &cameras};
  connect(&cursor, &SliceCursor::moved, this, [this, at] { followCrosshair(at); });
  connect(&cameras, &ViewLink::changed, this, [this, at](int view) { followCamera(at, view); });
}

void StudyLink::setCompared(bool compared) {
  if (compared == compared_) return;
  assert(!compared || (sides_[0].cursor && sides_[1].cursor));
  compared_ = compared;
  if (!compared) end();
  Q_EMIT changed();
}

void StudyLink::setLinked(bool linked, int leader) {
  if (linked == linked_ || !compared_) return;
  linked_ = linked;
  beyond_ = 0.0;
  if (linked) align(leader);
  Q_EMIT changed();
}

void StudyLink::match() {
  if (!compared_) return;
  offset_ = side(1).cursor->position() - side(0).cursor->position();
  matched_ = true;
  linked_ = true;
  align(0);
  Q_EMIT changed();
}

void StudyLink::forgetPair(int leader) {
  if (!matched_) return;
  matched_ = false;
  offset_ = {};
  if (linked_) align(leader);
  Q_EMIT changed();
}

double StudyLink::beyond() const { return beyond_; }

void StudyLink::end() {
  if (!linked_ && !matched_) return;
  linked_ = matched_ = false;
  offset_ = {};
  beyond_ = 0.0;
  Q_EMIT changed();
}

void StudyLink::align(int leader) {
  followCrosshair(leader);
  for (int view = 0; view < ViewLink::count; ++view) followCamera(leader, view);
  Q_EMIT aligned(leader);
}

void StudyLink::followCrosshair(int leader) {
  if (!linked_ || following_) return;
  const QScopedValueRollback<bool> guard(following_, true);
  const glm::dvec3 wanted = side(leader).cursor->position() + (leader == 0 ? offset_ : -offset_);
  SliceCursor& other = *side(1 - leader).cursor;
  other.moveTo(wanted);
  constexpr double rounding = 1e-3;  // mm: indices there and back
  double beyond = glm::distance(other.position(), wanted);
  if (beyond < rounding) beyond = 0.0;
  if (beyond == beyond_) return;
  beyond_ = beyond;
  Q_EMIT changed();
}

void StudyLink::followCamera(int leader, int view) {
  if (!linked_ || following_) return;
  const QScopedValueRollback<bool> guard(following_, true);
  side(1 - leader).cameras->lookAs(view, side(leader).cameras->camera(view));
}

}  // namespace fenestra::viewer
