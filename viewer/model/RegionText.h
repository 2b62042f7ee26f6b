#pragma once
// What a grown region is, in words.

#include <string>

#include <QStringList>

#include <glm/glm.hpp>

#include "rendering/segmentation/RegionFacts.h"

namespace fenestra::viewer {

/// Its mean and standard deviation, how sure its border is, and where it would leak next: a sentence each.
QStringList regionSentences(const segmentation::RegionFacts& facts, const std::string& unit);

/// A direction in the patient, world (LPS): "towards the head and the left"; "on all sides" for 0.
QString directionText(glm::dvec3 towards);

}  // namespace fenestra::viewer
