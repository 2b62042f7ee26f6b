#pragma once
// The turns in which the 3-D views of a window draw changed pictures. Each view draws in an event of its own, so that
// the window answers in between. The pictures of a round come onto the screen together: putting the window together
// takes as long for one new picture as for several.

#include <array>

#include <QObject>
#include <QTimer>

#include "viewer/model/FramePacer.h"

namespace fenestra::viewer {

class DrawingTurns : public QObject {
  Q_OBJECT
 public:
  /// `pacer` says which view leads, and outlives this.
  explicit DrawingTurns(const FramePacer& pacer);

  /// A view has something to draw. It gets one turn in a round, the leader the first one, so that no view waits for
  /// longer than the others take to draw once.
  void ask(int view);

 Q_SIGNALS:
  /// The first view of a round draws now; the pictures of the round before are on the screen.
  void roundBegins();
  /// The view may draw now.
  void turn(int view);
  /// Every view that asked has had its turn; their pictures are to be shown now.
  void roundEnded();

 private:
  void next();
  /// The first view that waits for its turn in this round; -1: none does.
  int firstWaiting() const;

  const FramePacer& pacer_;
  std::array<bool, FramePacer::views> waiting_{},
      served_{};  ///< for each view: it has asked; it had its turn in this round
  QTimer timer_;
};

}  // namespace fenestra::viewer
