#pragma once
// Size and sampling of the 3-D views while something moves, from measured times: smaller pictures on a slow machine,
// full ones on a fast one. It also decides which view is drawn first.

#include <array>
#include <optional>

#include <QString>

#include "rendering/settings/Quality.h"

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
  /// Milliseconds that a frame of all moving views may take, unless setBudget() says otherwise: 12 frames a second.
  static constexpr double budget = 1000.0 / 12.0;
  /// Below a quarter of the resolution anatomy is hard to recognise.
  static constexpr double leastScale = 0.25;
  /// Least scale of the linked view, which may be coarser: users look at the view that they turn.
  static constexpr double leastFollowingScale = 0.1875;
  /// At half the resolution every shown pixel lies a quarter of a rendered one from the nearest ray along both sides,
  /// at others up to half of one: such pictures are as sharp as those of a scale of 0.57.
  static constexpr double halfScale = 0.5;
  /// Share of the budget that frames get whose leading picture has half the resolution even so: 20 a second.
  static constexpr double quickShare = 0.6;
  /// Milliseconds that a first picture at rest may take. Where one at full quality takes more than twice as long, a
  /// draft comes before it; otherwise a draft would be on screen for less time than it delays that picture.
  static constexpr double firstAtRest = 150.0;
  static constexpr int views = 2;

  /// The last frame that was measured.
  struct Measured {
    double milliseconds = 0.0;  ///< until it was on screen
    int views = 0;              ///< number of views drawn
    Effort effort;
  };

  explicit FramePacer(const Effort& atRest = {}) : rest_(atRest) {}

  void setBudget(double milliseconds) { budget_ = milliseconds; }
  Effort atRest() const { return rest_; }
  void setAtRest(Quality quality, std::optional<double> maxError);
  /// The effort for the next frame of a drag that redraws so many views. The view that leads gets more of the time.
  Effort moving(int views, bool leads = true) const;
  /// What a view draws first when it comes to rest; unset where that is the picture at full quality. Until one of those
  /// is measured, the first pictures tell whether it takes long.
  std::optional<Effort> beforeRest() const;

  /// The view that the user turns: it is drawn first. A linked view follows: in every so many frames.
  void lead(int view) { leader_ = view; }
  bool leads(int view) const { return view == leader_; }
  int framesPerFollowing() const;

  /// A view begins to draw its part of a frame; times are in ms on one steady clock.
  void begin(Effort effort, double now);
  /// A picture of the frame took so long to draw; `usual` where that tells how long the next one will take.
  void drew(Effort effort, double milliseconds, bool usual = true);
  /// The frame with all parts begun is on screen.
  void end(double now);
  /// A picture that was refined between frames took so long.
  void refined(Effort effort, double milliseconds, bool usual = true);
  const std::optional<Measured>& last() const { return last_; }
  long frames() const { return frames_; }  ///< so many frames have ended

  /// Views refine their pictures one after the other, the leader first: a level of all before the next level of one.
  /// `level`: what a view works on, 0 first; unset when it is done.
  void refine(int view, std::optional<int> level) { levels_[static_cast<std::size_t>(view)] = level; }
  bool mayRefine(int view) const;

 private:
  struct Frame {
    double began = 0.0;
    Effort effort;
    int views = 0;
    double drawing = 0.0;  ///< ms of all its pictures
    bool usual = true;
  };

  double timeForPictures() const;
  double timeForDrafts(double cost, int views) const;
  void note(Effort effort, double milliseconds);

  double budget_ = budget;
  Effort rest_;
  int leader_ = 0;
  std::array<std::optional<int>, views> levels_;
  std::optional<Frame> frame_;
  std::optional<Measured> last_;
  long frames_ = 0;
  int drawn_ = 0;                    ///< pictures, counted up to the number of views
  std::optional<double> restCost_;   ///< ms per view at rest
  std::optional<double> draftCost_;  ///< ms per view for a draft of scale 1
  std::optional<double> overhead_;   ///< ms of a frame besides its pictures: overlays, putting the window together
  // What scales are planned from; they follow the times above only where these have changed for good.
  std::optional<double> plannedCost_;
  double plannedOverhead_ = 0.0;
};

}  // namespace fenestra::viewer
