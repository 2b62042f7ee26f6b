#include "viewer/actions/ViewCommands.h"

#include <memory>
#include <utility>

#include <QApplication>

#include "viewer/model/CamerasChange.h"
#include "viewer/model/Workspace.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {

ViewCommands::ViewCommands(Workspace& workspace, ViewArea& views, QObject* parent)
    : QObject(parent), workspace_(workspace), views_(views) {
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (const auto* view = qobject_cast<VolumeView*>(now)) lastCamera_ = view->index();
  });
}

void ViewCommands::moveCameras(const QString& step, const std::function<void()>& move) {
  ViewLink& cameras = workspace_.cameras;
  auto change = std::make_shared<CamerasChange>(cameras);
  const ViewLink::Pose before = cameras.pose();
  move();
  if (cameras.pose() != before) workspace_.document.history().push(step, std::move(change));
}

void ViewCommands::face(StandardView side) {
  moveCameras(tr("Standard view"), [&] { workspace_.cameras.face(lastCamera_, side); });
}

void ViewCommands::resetActiveView() {
  for (SliceView* view : views_.sliceViews())
    if (view->hasFocus()) {
      view->resetView();
      return;
    }
  moveCameras(tr("Reset view"), [this] { workspace_.cameras.reset(); });
}

void ViewCommands::resetAllViews() {
  for (SliceView* view : views_.sliceViews()) view->resetView();
  moveCameras(tr("Reset views"), [this] { workspace_.cameras.reset(); });
}

namespace {

class FrozenChange : public Change {
 public:
  FrozenChange(ViewLink& cameras, ViewLink::Frozen before) : cameras_(cameras), other_(std::move(before)) {}
  void undo() override { swap(); }
  void redo() override { swap(); }
  bool absorb(const Change&) override { return false; }
  bool isNothing() const override { return other_ == cameras_.frozen(); }
  std::size_t bytes() const override { return sizeof(*this); }

 private:
  void swap() {
    const ViewLink::Frozen now = cameras_.frozen();
    cameras_.setFrozen(std::exchange(other_, now));
  }

  ViewLink& cameras_;
  ViewLink::Frozen other_;
};

}  // namespace

void ViewCommands::freeze(bool on) {
  ViewLink& cameras = workspace_.cameras;
  if (on == cameras.isFrozen()) return;
  cameras.finishFlight();
  ViewLink::Frozen frozen;
  if (on)
    for (const VolumeView* view : views_.volumeViews()) {
      const View picture = view->restView();
      frozen[static_cast<std::size_t>(view->index())] = OpeningView{picture.camera, picture.size, picture.pixelScale};
    }
  auto change = std::make_shared<FrozenChange>(cameras, cameras.frozen());
  cameras.setFrozen(frozen);
  workspace_.document.history().push(tr("Freeze the opening"), std::move(change));
}

}  // namespace fenestra::viewer
