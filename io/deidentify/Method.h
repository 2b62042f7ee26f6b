#pragma once
// What an object says of its de-identification. Include in .cpp files alone.

#include <string>
#include <vector>

#include "io/deidentify/Profile.h"
#include "io/dicom/Dcmtk.h"

namespace fenestra::io::deidentify {

/// A code of PS3.16 context group 7050.
struct MethodCode {
  const char* value;
  const char* meaning;
};
/// The profile and the options, in this order. `keepsPrivate`: private attributes known to be safe stay.
std::vector<MethodCode> methodCodes(const Options& options, bool keepsPrivate);
/// Writes (0012,0062), (0012,0063), (0012,0064) and (0028,0303), in place of earlier ones. Throws std::bad_alloc.
void writeMethod(DcmItem& object, const Options& options, bool keepsPrivate);

}  // namespace fenestra::io::deidentify
