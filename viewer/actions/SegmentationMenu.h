#pragma once
// The segmentations that lie beside the open series, by name.

#include <cstdint>
#include <vector>

#include <QString>

#include "io/base/Reading.h"

class QMenu;

namespace fenestra::viewer {

class StudyLoader;

/// How a segmentation is called: by its description, or the file's name where it has none; or, because either may name
/// the patient, by neither.
enum class SegmentationTitle : std::uint8_t { Full, Nameless };
/// "Liver (SEG): liver, tumour and 3 more"; nameless "SEG: liver, tumour and 3 more".
QString titleOf(const io::SegmentationInfo& segmentation, SegmentationTitle kind);
/// An entry for each, which opens it as labels. Both outlive the menu.
void fillSegmentationMenu(QMenu& menu, const std::vector<io::SegmentationInfo>& segmentations, SegmentationTitle kind,
                          StudyLoader& loader);

}  // namespace fenestra::viewer
