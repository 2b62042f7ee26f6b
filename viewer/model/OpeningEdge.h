#pragma once
// Where the rays of C1 start, for the slices to draw the opening's edge.

#include <memory>
#include <utility>

#include <QObject>

#include "rendering/scene/Opening.h"

namespace fenestra::viewer {

class OpeningEdge : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Null while C1 moves, and where nothing is opened.
  const std::shared_ptr<const RayStarts>& starts() const { return starts_; }
  void set(std::shared_ptr<const RayStarts> starts) {
    if (!starts && !starts_) return;
    starts_ = std::move(starts);
    Q_EMIT changed();
  }

 Q_SIGNALS:
  void changed();

 private:
  std::shared_ptr<const RayStarts> starts_;
};

}  // namespace fenestra::viewer
