// What a 3-D view does while its picture is not the one that was asked for.

#include "viewer/model/Document.h"
#include "viewer/model/ViewLink.h"
#include "viewer/views/PictureSurface.h"
#include "viewer/views/RefinedPicture.h"
#include "viewer/views/ScenePreparation.h"
#include "viewer/views/VolumeView.h"

#include <QMouseEvent>

namespace fenestra::viewer {

void VolumeView::forgetStudy() {
  problem_.clear();  // another volume may fit where the last one did not
  shared_.preparation->forgetFailure();
  reduction_.clear();
  verified_.clear();
  hover_.stop();
  waiting_.clear();  // a stroke was not meant for another volume
  tools_.abandon();
  beforeClick_.reset();
  dragging_ = true;  // so that the release of a click on the study before is no click on this one
  stopRefining();
  forgetStarts();
  if (picture_) picture_->forget();
  isNew_ = isUnpainted_ = isUnseen_ = isTimed_ = settled_ = false;
  due_ = Due::Motion;
  shownStep_ = 0;
  shownFrozen_ = {};
  checkLate();
  repaintSurface();
}

bool VolumeView::hasPicture() const { return picture_ && picture_->isShown(); }

bool VolumeView::isBehind() const {
  if (!problem_.isEmpty() || !document_.hasVolume() || !isVisible()) return false;
  return isOld_ || !hasPicture() || awaitsOthers();
}

void VolumeView::checkLate() {
  const bool behind = isBehind();
  lateness_.setBehind(behind);
  if (behind) return;
  shownStep_ = document_.undoStack().index();
  shownFrozen_ = cameras_.frozen();
}

void VolumeView::becomeOld() {
  isOld_ = true;
  verified_.clear();
  checkLate();
}

bool VolumeView::awaitsOthers() const { return awaits_ || document_.awaitsGrowth(); }

void VolumeView::setAwaits(bool awaits) {
  awaits_ = awaits;
  checkLate();
}

void VolumeView::takeBackWhatIsAwaited() {
  shared_.preparation->glContext().askToStop();
  cameras_.setFrozen(shownFrozen_);
  while (document_.undoStack().index() > shownStep_ && document_.undoStack().canUndo()) document_.undoStack().undo();
}

}  // namespace fenestra::viewer
