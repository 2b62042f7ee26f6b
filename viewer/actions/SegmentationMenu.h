#pragma once
// The segmentations that lie beside the open series, by name.

#include <cstdint>
#include <vector>

#include <QString>

#include "io/base/Reading.h"

class QMenu;

namespace fenestra::viewer {

class StudyLoader;

/// Full: with the description, or the file's name where there is none. Nameless: without either, because both may name
/// the patient.
enum class SegmentationTitle : std::uint8_t { Full, Nameless };
/// "Liver (SEG): liver, tumour and 3 more"; nameless "SEG: liver, tumour and 3 more".
QString titleOf(const io::SegmentationInfo& segmentation, SegmentationTitle kind);
/// An entry for each, which opens it as labels. Both outlive the menu.
void fillSegmentationMenu(QMenu& menu, const std::vector<io::SegmentationInfo>& segmentations, SegmentationTitle kind,
                          StudyLoader& loader);

}  // namespace fenestra::viewer
