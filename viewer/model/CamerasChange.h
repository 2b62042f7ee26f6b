#pragma once
// A step that brings the cameras back to where they were before something moved them on request: a standard view, a
// reset, placing them for the focus. Turning a view by hand is no step: the way back from it is as short.

#include <utility>

#include "viewer/model/History.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer {

/// Undone, the cameras are where they were when it was made; redone, where they were when it was undone. The projection
/// stays the one that is chosen.
class CamerasChange : public Change {
 public:
  /// Before the cameras move. `cameras` outlives this.
  explicit CamerasChange(ViewLink& cameras) : cameras_(cameras), other_(cameras.pose()) {}

  void undo() override { swap(); }
  void redo() override { swap(); }
  bool absorb(const Change&) override { return false; }
  bool isNothing() const override { return false; }
  std::size_t bytes() const override { return sizeof(*this); }

 private:
  void swap() {
    const Projection projection = cameras_.projection();
    cameras_.setPose(std::exchange(other_, cameras_.pose()));
    cameras_.setProjection(projection);
  }

  ViewLink& cameras_;
  ViewLink::Pose other_;
};

}  // namespace fenestra::viewer
