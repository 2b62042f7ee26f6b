#pragma once
// Plays the slices of a view one after another, from the last on to the first.

#include <QObject>
#include <QPointer>
#include <QTimer>

#include "viewer/views/SliceView.h"

namespace fenestra::viewer {

class SliceCursor;

class Cine : public QObject {
  Q_OBJECT
 public:
  static constexpr int slowest = 1, fastest = 60;  ///< slices a second

  /// `cursor` outlives this.
  explicit Cine(SliceCursor& cursor, QObject* parent = nullptr);

  bool isPlaying() const { return timer_.isActive(); }
  void play(SliceView& view);
  /// True where it played.
  bool stop();
  int slicesPerSecond() const { return speed_; }
  void setSlicesPerSecond(int count);
  /// To the next of the usual speeds, or with -1 to the one before.
  void changeSpeed(int step);

 Q_SIGNALS:
  /// Played, stopped, or at another speed.
  void changed();

 private:
  void step();

  SliceCursor& cursor_;
  QPointer<SliceView> view_;
  QTimer timer_;
  int speed_ = 10;  ///< what viewers begin with
};

}  // namespace fenestra::viewer
