#pragma once
// Whether an unlit picture of normal quality is drawn within a bound on its error.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "rendering/scene/Scene.h"
#include "rendering/scene/ShownVolume.h"
#include "rendering/scene/View.h"

namespace fenestra {

/// Normal quality takes the value along a ray to change evenly over each cell. Where voxels are coarse and the
/// context's function is steep, that is wrong by more than normal quality may be; such pictures are drawn within a
/// bound, which takes three to four times as long. The choice is one for the whole picture, so that no cut of it shows,
/// and depends on neither camera nor size. The answer is kept until the volume or the function changes.
class BoundChoice {
 public:
  /// In 1/255. Within it the RMS is below a quarter on the volumes of tests/bench/results/random.md.
  static constexpr double bound = 2.0;

  /// The bound of the picture where it is drawn within one that nobody asked for, in 1/255. Lit pictures, those that
  /// have a bound or another quality, and splines, whose cells have a third of the side, never are; nothing is
  /// computed for them.
  std::optional<double> boundFor(const Scene& scene, const View& view);

  /// Estimated error of a pixel (RMS, of a channel, 0 to 1) where the value is taken to change evenly over each cell,
  /// against one that is even over each quarter: adaptive quadrature compares a rule with itself on parts of the
  /// interval (Gander and Gautschi, "Adaptive quadrature – revisited", BIT 40, 2000). `context` is shifted. A ray's
  /// errors add up under the transmittance T before them: with a cell's error d and opacity a, that is E[d²] · Σ T²,
  /// where Σ T² = 1 / E[a (2 - a)] until the ray is absorbed or has left the volume, and for the part that all cells
  /// have in common (E[d] · Σ T)², where Σ T = 1 / E[a].
  static double errorOf(const ShownVolume& shown, const TransferFunction& context);

 private:
  /// What the volume holds along a chord from face to face of a cell, at its ends and between its quarters.
  struct Chord {
    std::array<double, 5> values;
    double length;  ///< mm
  };
  /// Spread over all of the volume.
  static std::vector<Chord> chordsOf(const ShownVolume& shown);
  /// `most`: the most cells that a ray meets.
  static double errorOf(const std::vector<Chord>& chords, double most, const TransferFunction& context);
  bool exceeds(const ShownVolume& shown, const TransferFunction& context);

  std::weak_ptr<const Volume> volume_;
  ShownVolume shown_;  ///< what the chords lie in, without its volume, which the choice must not keep alive
  std::vector<Chord> chords_;
  std::optional<TransferFunction> context_;
  bool exceeds_ = false;
};

}  // namespace fenestra
