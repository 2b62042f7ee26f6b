#pragma once
// The words of choices about reading, in sessions and on the command line.

#include "io/base/Regularise.h"
#include "rendering/vocabulary/Word.h"
#include "rendering/volume/Slab.h"
#include "rendering/volume/Volume.h"

// Found by argument-dependent lookup, hence in the namespaces of what they are about.
namespace fenestra {

constexpr auto wordsOf(Modality) {
  return std::to_array<Word<Modality>>({{Modality::CT, "CT"},
                                        {Modality::MR, "MR"},
                                        {Modality::PT, "PT"},
                                        {Modality::US, "US"},
                                        {Modality::Unknown, "other"}});
}

constexpr auto wordsOf(SlabMode) {
  return std::to_array<Word<SlabMode>>(
      {{SlabMode::Maximum, "max"}, {SlabMode::Minimum, "min"}, {SlabMode::Mean, "mean"}});
}

namespace io {

constexpr auto wordsOf(Regularise) {
  return std::to_array<Word<Regularise>>({{Regularise::Automatic, "auto"},
                                          {Regularise::Linear, "linear"},
                                          {Regularise::Cubic, "cubic"},
                                          {Regularise::Off, "off"}});
}

}  // namespace io
}  // namespace fenestra
