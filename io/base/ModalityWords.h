#pragma once
// What modalities are called in sessions and on the command line.

#include "rendering/scene/Settings.h"
#include "rendering/scene/Volume.h"

// Found by argument-dependent lookup, hence the scene's own namespace.
namespace fenestra {

constexpr auto wordsOf(Modality) {
  return std::to_array<Word<Modality>>({{Modality::CT, "CT"}, {Modality::MR, "MR"}, {Modality::Unknown, "other"}});
}

}  // namespace fenestra
