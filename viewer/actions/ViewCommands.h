#pragma once
// Standard views and resets. Each that moves the cameras is a step that can be undone.

#include <functional>

#include <QObject>

#include "rendering/settings/Camera.h"

class QString;

namespace fenestra::viewer {

class ViewArea;
struct Workspace;

class ViewCommands : public QObject {
  Q_OBJECT
 public:
  /// Both outlive this.
  ViewCommands(Workspace& workspace, ViewArea& views, QObject* parent = nullptr);

  /// Turns the 3-D view that was used last to look from a side of the patient.
  void face(StandardView side);
  /// Resets the slice that has the keyboard focus, or else both cameras.
  void resetActiveView();
  void resetAllViews();
  /// Freezes both views' openings for the cameras as they are, or lets them follow the cameras again; a step.
  void freeze(bool on);

 private:
  void moveCameras(const QString& step, const std::function<void()>& move);

  Workspace& workspace_;
  ViewArea& views_;
  int lastCamera_ = 0;  ///< the camera of the 3-D view that was used last
};

}  // namespace fenestra::viewer
