#pragma once
// Joins two studies that are open side by side: while linked, the crosshair of one goes where that of the other is, in
// patient coordinates (LPS, mm), and the cameras of both look the same way at the same scale. A pair of points, one in
// each study, gives the offset between the two; without one, the coordinates of both are taken to be the same.
//
// Whatever the link moves is no step to undo. Nothing is stored: a session is of one study.

#include <array>

#include <QObject>

#include <glm/glm.hpp>

namespace fenestra::viewer {

class SliceCursor;
class ViewLink;

class StudyLink : public QObject {
  Q_OBJECT
 public:
  static constexpr int sides = 2;  ///< 0: left, 1: right

  using QObject::QObject;

  /// The crosshair and the cameras of a side, which outlive this or are joined for as long as they are there.
  void join(int side, SliceCursor& cursor, ViewLink& cameras);

  /// Two studies stand side by side. What ends that ends the link, too.
  bool isCompared() const { return compared_; }
  void setCompared(bool compared);

  bool isLinked() const { return linked_; }
  /// Linking brings the other side to where `leader` is. Only while compared.
  void setLinked(bool linked, int leader);

  /// The present crosshairs become a pair, and both are linked by it. Only while compared.
  void match();
  /// Takes the pair back; where linked, the other side goes to where `leader` is.
  void forgetPair(int leader);
  bool isMatched() const { return matched_; }
  /// From a place of the left study to the same place of the right one, mm.
  glm::dvec3 offset() const { return offset_; }

  /// How far the crosshair of the other side is from the place that it should show, because its volume ends before; mm.
  /// 0 while not linked.
  double beyond() const;

  /// A study is about to go or to be another: unlinks, and forgets the pair.
  void end();

 Q_SIGNALS:
  /// Anything of the above, beyond() included.
  void changed();
  /// The other side than `leader` was brought to it.
  void aligned(int leader);

 private:
  struct Side {
    SliceCursor* cursor = nullptr;
    ViewLink* cameras = nullptr;
  };
  Side& side(int index) { return sides_[static_cast<std::size_t>(index)]; }
  void followCrosshair(int leader);
  void followCamera(int leader, int view);
  void align(int leader);

  std::array<Side, sides> sides_;
  glm::dvec3 offset_{0.0};
  double beyond_ = 0.0;
  bool compared_ = false, linked_ = false, matched_ = false;
  bool following_ = false;  ///< what moves now is moved by the link
};

}  // namespace fenestra::viewer
