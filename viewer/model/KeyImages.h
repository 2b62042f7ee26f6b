#pragma once
// States of the window that a user keeps and returns to: the look with its focus, both cameras and frozen openings, the
// slices' window, their planes and slabs, and the crosshair. The data, labels and measures stay as they are. The list
// is the document's, so that its changes can be undone and sessions keep it.

#include <cstddef>
#include <optional>

#include <QByteArray>
#include <QImage>
#include <QObject>
#include <QString>

#include "io/session/Session.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer {

class Document;
class PlacementController;
class SliceCursor;
class SlicePlanes;

class KeyImages : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    SliceCursor& cursor;
    SlicePlanes& planes;
    ViewLink& cameras;
    PlacementController& placement;
  };
  /// All outlive this.
  explicit KeyImages(const Parts& parts);

  /// Keeps the present state at the end of the list, with a name by its number. `picture` is of the window, of any
  /// size, and must show no patient. False: there are KeyImage::most already.
  bool add(const QImage& picture);
  /// Goes back to a state: the look and the cameras as one step, where they are others. Labels that are no longer
  /// there are left out of its focus. The cameras are not placed anew, also where a region has to be grown first.
  void show(std::size_t index);
  /// An empty name changes nothing; a long one is cut.
  void rename(std::size_t index, const QString& name);
  void remove(std::size_t index);
  /// To another place of the list.
  void move(std::size_t from, std::size_t to);

  /// The small picture; null without one, and where the file's is damaged.
  static QImage pictureOf(const io::KeyImage& image);

 private:
  io::KeyImage present() const;
  void showCameras(const io::KeyImage& image);
  /// Cameras that the automatic placement must not move while the region of a state grows.
  void keepCameras();

  Parts parts_;
  std::optional<ViewLink::Pose> awaited_;
};

}  // namespace fenestra::viewer
