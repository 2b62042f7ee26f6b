#pragma once
// What is left to do of a picture: dispatches over parts of it, cut into tiles, so that no dispatch takes long and a
// picture can be drawn a little at a time or dropped half way.

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "rendering/gl/ShaderProgram.h"

namespace fenestra {

using Regions = std::span<const gl::Region>;

class Steps {
 public:
  /// Runs over one tile of a step. Everything that it refers to must live until the step is done. Called with the
  /// context current, after everything that was added before.
  using Tile = std::function<void(Regions)>;
  /// A tile that runs without a limit on the time of all, and one that runs within a limit, takes about so long.
  static constexpr double longTile = 50.0, shortTile = 12.0;  // milliseconds

  /// The steps added from now on are the pass's, a small number: passes and their steps differ in speed.
  void beginPass(std::size_t pass);
  /// A step over regions, each cut at multiples of 8 pixels from its origin: `run` gets every region in one piece or in
  /// several. The result must not depend on the cut.
  void add(Regions regions, Tile run);
  /// A step over all pixels of a picture.
  void add(glm::ivec2 size, Tile run);
  /// What to do between steps.
  void then(std::function<void()> action);

  /// Runs steps for about so many milliseconds, at least one tile; all steps without a limit. True when all are done.
  /// Waits for the GPU where it takes times. Whatever a step throws passes through; drop() then.
  bool advance(std::optional<double> milliseconds = std::nullopt);
  bool isDone() const { return steps_.empty(); }
  /// Forgets the steps that are left, but not how fast they were.
  void drop() { steps_.clear(); }

 private:
  struct Step {
    std::size_t pace = 0;
    std::deque<gl::Region> left;
    Tile run;
    std::function<void()> action;
  };
  /// Milliseconds per invocation of the slowest tile: of the last run, and of the present one so far. Tiles of a
  /// picture differ much, and the next one may be as slow as the slowest.
  struct Pace {
    double last = 0.0, now = 0.0;
  };
  void runTile(Step& step, double aim, bool limited);
  void runActions();
  /// Invocations that a tile may have.
  double mostIn(const Step& step, double milliseconds) const;

  std::deque<Step> steps_;
  std::map<std::size_t, Pace> paces_;
  std::size_t pass_ = 0, added_ = 0;
};

}  // namespace fenestra
