#pragma once
// Cameras that go along the path of the curved reformat: both keep its place in the middle of their pictures while the
// user moves along it, and look from the same side at the same distance. So an opening that is wide, a lens at the
// crosshair, or a narrow field of view shows the place that the straightened picture shows.

#include <QObject>

namespace fenestra::viewer {

class Document;
class PathMode;
class ViewLink;
class ViewOptions;

class PathCameras : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    PathMode& path;
    ViewLink& cameras;
    ViewOptions& options;
  };
  /// All outlive this. While ViewOptions::followsPath(), the cameras go where PathMode::walked() says.
  explicit PathCameras(const Parts& parts);

  /// For the user: on, the cameras go to the path's present place, as a step of the history. Moves along the path, as
  /// turns of a view, are none.
  void setFollows(bool on);

 private:
  void goToPlace();

  Parts parts_;
};

}  // namespace fenestra::viewer
