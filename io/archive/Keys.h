#pragma once
// The keys of a query as a data set, and answers as texts. Private to io/archive; include in .cpp files alone.

#include <memory>
#include <string>
#include <vector>

#include "io/archive/Records.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io::archive {

/// The level that an attribute belongs to (PS3.4 C.6); `level` where it is none of those above.
Level levelOf(const std::string& keyword, Level level);
/// Attributes that are asked for at a level beside the keys.
std::vector<std::string> wantedAt(Level level);

/// The identifier of a query or retrieval (PS3.4 C.4): its level, the keys, and `wanted` without values. In UTF-8 where
/// a value is not ASCII. Throws std::invalid_argument for a keyword that problemOf() refuses.
std::unique_ptr<DcmDataset> identifierOf(Level level, const Attributes& keys, const std::vector<std::string>& wanted);

/// The character sets to ask in, one after the other until something is found: those in which `keys` can be said.
std::vector<std::string> characterSetsFor(const Attributes& keys, const std::string& preferred);
/// False when the identifier cannot be said in a character set.
bool encode(DcmDataset& identifier, const std::string& characterSet);

/// The texts of an answer, in UTF-8.
Attributes attributesOf(DcmDataset& answer);

}  // namespace fenestra::io::archive
