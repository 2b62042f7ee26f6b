#pragma once
// Seeds from the tables of defects: each new way to be damaged, and each new form of file, is a place to fuzz from.

#include <string>
#include <vector>

#include "tests/fuzz/Targets.h"
#include "tests/io/Defects.h"

namespace fenestra::fuzz {

/// The bytes of the rows' files that the target opens: a folder packed as packFolder() says, or a file of the target's
/// kind. Rows that need real data which is not here, and files of more than a million bytes, are left out.
std::vector<std::string> tableSeeds(const Target& target, const std::vector<tests::Defect>& rows);

}  // namespace fenestra::fuzz
