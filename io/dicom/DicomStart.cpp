#include "io/dicom/DicomStart.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "io/base/Error.h"
#include "io/dicom/DicomHeader.h"

namespace fenestra::io {

bool looksLikeDicom(const FileStart& start) {
  constexpr std::size_t preamble = 128;
  std::array<char, preamble + 4> bytes{};
  const std::size_t got = std::min(start.stored().size(), bytes.size());
  std::memcpy(bytes.data(), start.stored().data(), got);
  if (got == bytes.size() && std::memcmp(bytes.data() + preamble, "DICM", 4) == 0) return true;
  // Without the preamble a dataset starts with an even, small group: 0002 or 0008, either byte order.
  const bool little = (bytes[0] == 2 || bytes[0] == 8) && bytes[1] == 0 && bytes[3] == 0;
  const bool big = bytes[0] == 0 && bytes[1] == 8 && bytes[2] == 0;
  if (got < 8 || !(little || big)) return false;
  try {
    const DicomFile file = readDicomHeader(start.path());
    return !file.instance.empty() || file.acrNema;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace fenestra::io
