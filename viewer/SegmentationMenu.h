#pragma once
// The segmentations that lie beside the open series, by name.

#include <vector>

#include <QString>

#include "io/base/Reading.h"

class QMenu;

namespace fenestra::viewer {

class StudyLoader;

/// "Liver (SEG): liver, tumour and 3 more"; the file's name where it has no description.
QString titleOf(const io::SegmentationInfo& segmentation);
/// An entry for each, which opens it as labels. Both outlive the menu.
void fillSegmentationMenu(QMenu& menu, const std::vector<io::SegmentationInfo>& segmentations, StudyLoader& loader);

}  // namespace fenestra::viewer
