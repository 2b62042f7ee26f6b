#include "io/archive/WholeObject.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "io/dicom/Dataset.h"

namespace fenestra::io::archive {
namespace {

namespace fs = std::filesystem;

bool isZeroFrom(const fs::path& file, std::uint64_t offset) {
  std::ifstream bytes(file, std::ios::binary);
  bytes.seekg(static_cast<std::streamoff>(offset));
  return std::all_of(std::istreambuf_iterator<char>(bytes), {}, [](char each) { return each == 0; });
}

/// Whether all of the file can be read, with its elements in their order (PS3.5 7.1).
bool isInOrder(const fs::path& file) {
  DcmFileFormat whole;
  constexpr Uint32 longest = 4096;  // bytes of a value that is read; longer ones are passed over
  if (whole.loadFile(OFFilename(file.c_str()), EXS_Unknown, EGL_noChange, longest).bad()) return false;
  DcmTagKey last(0, 0);
  DcmDataset& dataset = *whole.getDataset();
  for (DcmObject* next = nullptr; (next = dataset.nextInContainer(next));) {
    if (next->getTag() <= last) return false;
    last = next->getTag();
  }
  return true;
}

}  // namespace

bool isWholeObject(DcmDataset& header, const fs::path& file) {
  std::error_code unknown;
  const std::uintmax_t size = fs::file_size(file, unknown);
  const auto pixels = pixelsOf(header, file);
  if (!pixels || pixels->encapsulated || pixels->deflated) return isInOrder(file);
  const std::uintmax_t end = pixels->offset + pixels->length;
  return end == size || (end < size && (isZeroFrom(file, end) || isInOrder(file)));
}

}  // namespace fenestra::io::archive
