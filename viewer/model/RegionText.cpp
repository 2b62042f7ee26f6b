#include "viewer/model/RegionText.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "viewer/model/NumberText.h"

namespace fenestra::viewer {
namespace {

using segmentation::Border;
using segmentation::RegionFacts;

constexpr double secondShare = 0.5;  ///< of the direction's greatest component: less is not said

struct RegionWords {
  Q_DECLARE_TR_FUNCTIONS(Region)
};

/// Whole numbers, or as many digits as `scale`, a spread of the values, gives sense to.
QString number(double value, double scale) {
  const int decimals = scale > 0.0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(scale))), 0, 6) : 0;
  return numberText(value, decimals);
}

QString borderSentence(const RegionFacts& facts, const QString& unit) {
  const QString step = number(facts.contrast, 10.0 * facts.contrast) + unit;
  switch (*facts.border) {
    case Border::Clear:
      return RegionWords::tr("Its border is clear: values change by %1 there.").arg(step);
    case Border::Fair:
      return RegionWords::tr("Its border is fair: values change by %1 there.").arg(step);
    case Border::Doubtful:
      if (facts.isPassing)
        return RegionWords::tr(
            "It is doubtful: nearly any other tolerance makes it far larger or smaller. Check its outline on the "
            "slices.");
      if (facts.isRivalled)
        return RegionWords::tr(
            "It is doubtful: another region here, far larger or smaller, is nearly as clear. Check its outline on the "
            "slices.");
      if (facts.sprawls)
        return RegionWords::tr(
            "It is doubtful: it spreads from a thin part at the click into a thicker one. Check its outline on the "
            "slices.");
      if (facts.isFlat)
        return RegionWords::tr(
            "It is doubtful: it is a flat tube, as two vessels side by side are. Check its outline on the slices.");
      return RegionWords::tr(
                 "It is doubtful: values change by only %1 along its border. Check its outline on the slices.")
          .arg(step);
  }
  return {};
}

/// The part of a direction along an axis of the patient.
QString sideText(int axis, bool positive) {
  switch (axis) {
    case 0:
      return positive ? RegionWords::tr("the left") : RegionWords::tr("the right");
    case 1:
      return positive ? RegionWords::tr("the back") : RegionWords::tr("the front");
    default:
      return positive ? RegionWords::tr("the head") : RegionWords::tr("the feet");
  }
}

}  // namespace

QString directionText(glm::dvec3 towards) {
  const glm::dvec3 length = glm::abs(towards);
  int first = length.x >= length.y ? 0 : 1;
  if (length.z > length[first]) first = 2;
  if (length[first] == 0.0) return RegionWords::tr("on all sides");
  const int next = (first + 1) % 3, last = (first + 2) % 3, second = length[next] >= length[last] ? next : last;
  const QString side = sideText(first, towards[first] > 0.0);
  if (length[second] < secondShare * length[first]) return RegionWords::tr("towards %1").arg(side);
  return RegionWords::tr("towards %1 and %2").arg(side, sideText(second, towards[second] > 0.0));
}

QStringList regionSentences(const RegionFacts& facts, const std::string& unit) {
  const QString suffix = unitSuffix(unit);
  QStringList sentences{
      RegionWords::tr("Values: %1 ± %2.")
          .arg(number(facts.mean, 10.0 * facts.deviation), number(facts.deviation, 10.0 * facts.deviation) + suffix)};
  if (facts.border) sentences << borderSentence(facts, suffix);
  if (facts.leak)
    sentences << RegionWords::tr("Next leak: at %1 to %2, %3.")
                     .arg(number(facts.leak->tolerance, facts.leak->tolerance) + suffix,
                          volumeText(facts.leak->volume / mm3PerMl), directionText(facts.leak->towards));
  return sentences;
}

}  // namespace fenestra::viewer
