#pragma once
// Repaints of a window while its 3-D views draw. Any repaint, of a single label too, puts the whole window together
// anew, which takes software OpenGL as long as a moving picture: one round of pictures needs one repaint, not several.

#include <memory>

#include <QObject>

class QWidget;

namespace fenestra::viewer {

class DrawingTurns;

class RepaintsByRound : public QObject {
  Q_OBJECT
 public:
  /// While a round of `turns` is under way, what asks for a repaint of `window` waits for the round's end. Belongs to
  /// the window.
  RepaintsByRound(QWidget& window, std::shared_ptr<const DrawingTurns> turns);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  std::shared_ptr<const DrawingTurns> turns_;
  bool isHeld_ = false;   ///< a repaint waits
  bool mayPass_ = false;  ///< a round has ended since the last repaint
};

}  // namespace fenestra::viewer
