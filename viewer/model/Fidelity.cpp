#include "viewer/model/Fidelity.h"

#include <algorithm>

#include <QCoreApplication>

#include "rendering/scene/Explosion.h"
#include "rendering/scene/Peel.h"
#include "viewer/model/FramePacer.h"
#include "viewer/model/NumberText.h"

namespace fenestra::viewer {
namespace {

using Causes = std::vector<FidelityCause>;

struct FidelityWords {
  Q_DECLARE_TR_FUNCTIONS(Fidelity)
};

QString counted(std::size_t count, const QString& one, const QString& many) {
  return count == 1 ? one : many.arg(count);
}

void alter(Causes& causes, const QString& text) { causes.push_back({Fidelity::Altered, text}); }

/// What every new study opens with must not warn, or nobody would look at the warning that matters.
void approximate(Causes& causes, const QString& text) { causes.push_back({Fidelity::Approximate, text}); }

QString mm(double length) { return numberText(length, 3, 'g'); }

/// What was done to the slices of an irregular series.
void addGeometry(Causes& causes, const io::GeometryReport& report, const PictureState& state) {
  if (report.applied == io::Regularise::Off) {
    if (report.displacement > io::GeometryReport::tolerance)
      alter(causes,
            FidelityWords::tr("slices are shown up to %1 mm from their true places").arg(mm(report.displacement)));
  } else {
    alter(causes, (report.sheared ? FidelityWords::tr("tilt is made straight: %1 slices are resampled onto %2 planes")
                                  : FidelityWords::tr("%1 slices are resampled onto %2 even planes"))
                      .arg(report.slices)
                      .arg(report.planes));
  }
  if (const auto filled = report.interpolatedPlanes.size(); filled > 0)
    alter(causes,
          state.isInterpolated
              ? FidelityWords::tr("this plane was not scanned: it is interpolated across a gap")
              : FidelityWords::tr("%1 of %2 planes are interpolated across gaps").arg(filled).arg(report.planes));
}

/// What a reader's warning means for pictures; empty: it does not alter them, or the geometry's report tells it.
QString alterationBy(io::Warning::Kind kind) {
  using Kind = io::Warning::Kind;
  switch (kind) {
    case Kind::NoGeometry:
      return FidelityWords::tr("places or sizes are assumed, because the file does not give them");
    case Kind::DamagedPixels:
      return FidelityWords::tr("some values are outside of what the file's header allows");
    case Kind::PrecisionLoss:
      return FidelityWords::tr("values are rounded to the precision of the program's numbers");
    case Kind::MissingSlices:
      return FidelityWords::tr("slices are missing");
    case Kind::UnreadableFiles:
      return FidelityWords::tr("files were left out");
    case Kind::DuplicateSlices:
      return FidelityWords::tr("slices of one place were left out");
    case Kind::MixedSizes:
    case Kind::MixedOrientations:
      return FidelityWords::tr("slices of another size or direction are shown as the first one");
    case Kind::ChangedData:
      return FidelityWords::tr("the data differ from those of the session");
    default:
      return {};
  }
}

void addWarnings(Causes& causes, const io::Study& study) {
  for (const io::Warning& warning : study.warnings) {
    if (study.geometry && std::find(study.geometry->findings.begin(), study.geometry->findings.end(), warning) !=
                              study.geometry->findings.end())
      continue;
    QString text = alterationBy(warning.kind);
    if (text.isEmpty()) continue;
    if (!warning.files.empty())
      text += QStringLiteral(" (%1)").arg(
          counted(warning.files.size(), FidelityWords::tr("1 file"), FidelityWords::tr("%1 files")));
    const FidelityCause cause{Fidelity::Altered, text};
    if (std::find(causes.begin(), causes.end(), cause) == causes.end()) causes.push_back(cause);
  }
}

/// What the look leaves out or moves.
void addParts(Causes& causes, const Scene& scene) {
  const Look& look = scene.look;
  if (const auto count = halfSpaces(look.clipping, scene.volume->grid).size(); count > 0)
    alter(causes, counted(count, FidelityWords::tr("a part of the volume is clipped, by 1 plane"),
                          FidelityWords::tr("a part of the volume is clipped, by %1 planes")));
  if (const auto count = labelsWith(LabelRole::Hidden, scene).size(); count > 0)
    alter(causes,
          counted(count, FidelityWords::tr("1 structure is hidden"), FidelityWords::tr("%1 structures are hidden")));
  if (scene.removed) alter(causes, FidelityWords::tr("a part of the volume is carved away"));
  if (look.hideTable && scene.table && scene.table->count > 0)
    alter(causes, FidelityWords::tr("the scanner's table is left out"));
  if (explosionOf(look)) alter(causes, FidelityWords::tr("parts are moved apart: distances between them do not hold"));
  if (peelOf(look)) alter(causes, FidelityWords::tr("a layer is rolled up: distances on it do not hold"));
}

void addDraft(Causes& causes, const PictureState& state) {
  alter(causes,
        FidelityWords::tr("a draft while something moves, %1 % of the size").arg(100.0 * state.scale, 0, 'f', 0));
}

/// How a turned or thick slice comes from the voxels.
void addPlane(Causes& causes, const PictureState& state) {
  if (state.isDraft) addDraft(causes, state);
  if (state.slab.thickness > 0.0) {
    const QString thickness = mm(state.slab.thickness);
    switch (state.slab.mode) {
      case SlabMode::Maximum:
        alter(causes, FidelityWords::tr("a slab: only the highest value of %1 mm shows").arg(thickness));
        break;
      case SlabMode::Minimum:
        alter(causes, FidelityWords::tr("a slab: only the lowest value of %1 mm shows").arg(thickness));
        break;
      case SlabMode::Mean:
        alter(causes, FidelityWords::tr("a slab: the mean of %1 mm shows").arg(thickness));
        break;
    }
  }
  if (state.isTurned || state.slab.thickness > 0.0)
    causes.push_back({Fidelity::Faithful, FidelityWords::tr("values between voxels are interpolated linearly")});
}

void addSampling(Causes& causes, const Scene& scene, const PictureState& state) {
  const Look& look = scene.look;
  if (!state.reduction.isEmpty()) alter(causes, state.reduction);
  switch (reconstructionOf(scene)) {
    case Reconstruction::Smooth:
      approximate(causes, FidelityWords::tr("values are smoothed between voxels"));
      break;
    case Reconstruction::Smoother:
      approximate(causes, FidelityWords::tr("values are smoothed over several voxels"));
      break;
    case Reconstruction::Cubic:
      approximate(causes, FidelityWords::tr("values between voxels follow a cubic spline, which may overshoot"));
      break;
    case Reconstruction::Linear:
    case Reconstruction::Auto:
      break;
  }
  if (look.labelSmoothing != LabelSmoothing::Off && std::holds_alternative<LabelFocus>(look.focus))
    approximate(causes, look.labelSmoothing == LabelSmoothing::Light
                            ? FidelityWords::tr("the surface of labels is smoothed lightly")
                            : FidelityWords::tr("the surface of labels is smoothed strongly"));
  if (state.isDraft) {
    addDraft(causes, state);
  } else if (!state.maxError) {
    approximate(causes, FidelityWords::tr("the sampling error has no bound (quality: %1)")
                            .arg(nameOf(Effort{.quality = state.quality})));
  } else {
    causes.push_back({*state.maxError > invisibleError ? Fidelity::Bounded : Fidelity::Faithful,
                      FidelityWords::tr("the sampling error is at most %1/255").arg(*state.maxError)});
  }
  causes.push_back({Fidelity::Faithful, state.verified.isEmpty()
                                            ? FidelityWords::tr("not verified")
                                            : FidelityWords::tr("verified: %1").arg(state.verified)});
}

}  // namespace

std::vector<FidelityCause> fidelityOf(const io::Study& study, const Scene& scene, const PictureState& state) {
  Causes causes;
  if (!scene.volume) return causes;
  if (!state.isCurrent) alter(causes, FidelityWords::tr("not yet what was asked for"));
  if (study.geometry) addGeometry(causes, *study.geometry, state);
  addWarnings(causes, study);
  if (state.is3D) {
    addParts(causes, scene);
    addSampling(causes, scene, state);
  } else {
    addPlane(causes, state);
  }
  std::stable_sort(causes.begin(), causes.end(),
                   [](const FidelityCause& a, const FidelityCause& b) { return a.grade > b.grade; });
  return causes;
}

Fidelity gradeOf(const std::vector<FidelityCause>& causes) {
  Fidelity worst = Fidelity::Faithful;
  for (const FidelityCause& cause : causes) worst = std::max(worst, cause.grade);
  return worst;
}

QString nameOf(Fidelity grade) {
  return grade == Fidelity::Faithful      ? FidelityWords::tr("faithful")
         : grade == Fidelity::Bounded     ? FidelityWords::tr("bounded")
         : grade == Fidelity::Approximate ? FidelityWords::tr("approximate")
                                          : FidelityWords::tr("altered");
}

QString symbolOf(Fidelity grade) {
  return grade == Fidelity::Faithful      ? QStringLiteral("=")
         : grade == Fidelity::Bounded     ? QStringLiteral("≤")
         : grade == Fidelity::Approximate ? QStringLiteral("≈")
                                          : QStringLiteral("≠");
}

QStringList linesOf(const std::vector<FidelityCause>& causes) {
  QStringList lines{nameOf(gradeOf(causes))};
  for (const FidelityCause& cause : causes) lines << cause.text;
  return lines;
}

}  // namespace fenestra::viewer
