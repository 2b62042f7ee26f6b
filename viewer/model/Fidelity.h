#pragma once
// What makes a picture less than exact, as a list of causes with their sizes. The chip in each view, its tool tip and
// the texts of exported pictures are made from it (resources/guide/exactness.md).

#include <cstdint>
#include <optional>
#include <vector>

#include <QString>
#include <QStringList>

#include "io/study/Study.h"
#include "rendering/scene/Scene.h"
#include "rendering/scene/View.h"
#include "rendering/volume/Slab.h"

namespace fenestra::viewer {

/// How far a cause takes the picture from the data; a picture has the grade of its worst cause.
enum class Fidelity : std::uint8_t {
  Faithful,     ///< the data as they are in the file, to half a step of a screen's colours
  Bounded,      ///< a known bound holds
  Approximate,  ///< all data show in their places, smoothed or sampled without a bound, as the settings say
  Altered       ///< data are hidden, moved, missing or wrong, or the picture is not the one that was asked for
};

struct FidelityCause {
  Fidelity grade = Fidelity::Faithful;
  QString text;  ///< one clause with figures, without a full stop
  bool operator==(const FidelityCause&) const = default;
};

/// How a picture was made, beside its scene.
struct PictureState {
  bool is3D = true;
  bool isCurrent = true;                ///< false: it shows what was asked for before
  bool isDraft = false;                 ///< drawn while something moves, or not yet refined
  double scale = 1.0;                   ///< its pixels along a side for each of the screen's
  Quality quality{};                    ///< 3-D
  std::optional<double> maxError = {};  ///< 3-D, in 1/255
  QString reduction = {};               ///< 3-D: GpuScene::reductionNotice()
  bool isInterpolated = false;          ///< slice: a plane that was not scanned
  bool isTurned = false;                ///< slice: none of the volume's own
  Slab slab = {};                       ///< slice
  QString verified = {};  ///< 3-D: what a certificate states of this very picture; empty: it was not verified
};

/// A bound up to which no screen shows the difference, in 1/255.
inline constexpr double invisibleError = 0.5;

/// All causes, the worst first, and what is known of the bound and the proof of a 3-D picture. `scene` is the one that
/// the picture shows of `study`.
std::vector<FidelityCause> fidelityOf(const io::Study& study, const Scene& scene, const PictureState& state);
/// The worst; Faithful without a cause.
Fidelity gradeOf(const std::vector<FidelityCause>& causes);
/// "faithful", "bounded", "approximate", "altered".
QString nameOf(Fidelity grade);
/// One character: "=", "≤", "≈", "≠".
QString symbolOf(Fidelity grade);
/// The grade, then a line for each cause.
QStringList linesOf(const std::vector<FidelityCause>& causes);

}  // namespace fenestra::viewer
