#include "viewer/ViewCommands.h"

#include <memory>

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

}  // namespace fenestra::viewer
