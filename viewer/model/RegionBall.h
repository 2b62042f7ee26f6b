#pragma once
// The ball that is being drawn around a place, in all views alike, to bound the region that grows there.

#include <optional>

#include <QObject>

#include <glm/glm.hpp>

namespace fenestra::viewer {

class RegionBall : public QObject {
  Q_OBJECT
 public:
  struct Ball {
    glm::dvec3 centre;    ///< world, mm
    double radius = 0.0;  ///< mm
    bool operator==(const Ball&) const = default;
  };
  using QObject::QObject;

  const std::optional<Ball>& ball() const { return ball_; }
  void set(std::optional<Ball> ball) {
    if (ball == ball_) return;
    ball_ = ball;
    Q_EMIT changed();
  }

 Q_SIGNALS:
  void changed();

 private:
  std::optional<Ball> ball_;
};

}  // namespace fenestra::viewer
