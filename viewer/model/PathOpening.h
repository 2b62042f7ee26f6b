#pragma once
// The opening along the path of the curved reformat: while it is on, the focus is the tube around the path
// (PathTube.h), which goes along when the path changes (Document::setPath).

#include <QObject>

#include "rendering/settings/Focus.h"

namespace fenestra::viewer {

class Document;

class PathOpening : public QObject {
  Q_OBJECT
 public:
  /// The document outlives this.
  explicit PathOpening(Document& document);

  bool isOpen() const;
  /// Makes the tube the focus, as a step of the history; off, the focus before it comes back, or none where labels or
  /// study have changed. On without a path, nothing happens.
  void setOpen(bool on);
  /// mm; of the tube in focus, or of the next one.
  double radius() const;
  void setRadius(double mm);
  static constexpr double least = 1.0, most = 100.0;

 private:
  Document& document_;
  Focus before_;
  double radius_ = 10.0;
};

}  // namespace fenestra::viewer
