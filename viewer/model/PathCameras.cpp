#include "viewer/model/PathCameras.h"

#include <memory>
#include <utility>

#include "viewer/model/CamerasChange.h"
#include "viewer/model/Document.h"
#include "viewer/model/PathMode.h"
#include "viewer/model/ViewLink.h"
#include "viewer/model/ViewOptions.h"

namespace fenestra::viewer {

PathCameras::PathCameras(const Parts& parts) : parts_(parts) {
  connect(&parts_.path, &PathMode::walked, this, [this] {
    if (parts_.options.followsPath()) goToPlace();
  });
}

void PathCameras::setFollows(bool on) {
  parts_.options.setFollowsPath(on);
  if (!on || !parts_.path.hasPath()) return;
  auto change = std::make_shared<CamerasChange>(parts_.cameras);
  const ViewLink::Pose before = parts_.cameras.pose();
  goToPlace();
  if (parts_.cameras.pose() != before) parts_.document.history().push(tr("Cameras follow the path"), std::move(change));
}

void PathCameras::goToPlace() {
  const glm::dvec3 place = parts_.path.curve().place(parts_.path.place()).point;
  ViewLink::Pose pose = parts_.cameras.pose();
  for (Camera& camera : pose.cameras) {
    camera.eye += place - camera.target;
    camera.target = place;
  }
  parts_.cameras.setPose(pose);
}

}  // namespace fenestra::viewer
