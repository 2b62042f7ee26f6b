#pragma once
// Size and sampling of the 3-D views while something moves, from measured frame times: smaller pictures on a slow
// machine, full ones on a fast one.

#include <optional>

#include <QString>

#include "rendering/scene/Quality.h"

namespace fenestra::viewer {

/// How a picture is drawn: rendered pixels per device pixel along one side, and the sampling.
struct Effort {
  double scale = 1.0;
  Quality quality = Quality::Normal;
  std::optional<double> maxError = {};  ///< see View
  bool operator==(const Effort&) const = default;
};

/// "draft", "normal", or the bound on the error: "error ≤ 1/255".
QString nameOf(const Effort& effort);

class FramePacer {
 public:
  /// Milliseconds that a frame of all moving views may take: 12 frames a second.
  static constexpr double budget = 1000.0 / 12.0;
  /// Below a quarter of the resolution anatomy is hard to recognise.
  static constexpr double leastScale = 0.25;

  /// The last frame that was measured.
  struct Measured {
    double milliseconds = 0.0;  ///< until it was on screen
    int views = 0;              ///< number of views drawn
    Effort effort;
  };

  explicit FramePacer(const Effort& atRest = {}) : rest_(atRest) {}

  Effort atRest() const { return rest_; }
  void setAtRest(Quality quality, std::optional<double> maxError);
  /// For the next frame of a drag that redraws `views` views.
  Effort moving(int views) const;

  /// A view begins to draw its part of a frame; times are in ms on one steady clock.
  void begin(Effort effort, double now);
  /// The frame with all parts begun is on screen.
  void end(double now);
  const std::optional<Measured>& last() const { return last_; }

 private:
  struct Frame {
    double began = 0.0;
    Effort effort;
    int views = 0;
    bool mixed = false;  ///< its views were drawn with different efforts, so its time is not used
  };

  Effort rest_;
  std::optional<Frame> frame_;
  std::optional<Measured> last_;
  std::optional<double> restCost_;   ///< ms per view at rest
  std::optional<double> draftCost_;  ///< ms per view for a draft of scale 1
};

}  // namespace fenestra::viewer
