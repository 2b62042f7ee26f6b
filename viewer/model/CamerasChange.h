#pragma once
// A step that undoes a camera move that the user asked for: a standard view, a reset, placing the cameras for the
// focus. Turning a view by hand is not a step: turning it back is as quick as undoing.

#include <utility>

#include "viewer/model/History.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer {

/// Undo restores the poses at construction, redo the poses at the undo. The chosen projection stays.
class CamerasChange : public Change {
 public:
  /// To be made before the cameras move. `cameras` outlives this.
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
