#include "io/dicom/PackedFiles.h"

#include <array>
#include <cstring>

#include "io/base/ByteStream.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Whether it unpacks to a file with DICOM's preamble. One without a preamble is not worth unpacking to find out.
bool isPackedDicom(const fs::path& file) {
  if (!isGzip(file)) return false;
  constexpr std::size_t preamble = 128;
  std::array<char, preamble + 4> bytes{};
  try {
    openMaybeGzip(file)->readAll(reinterpret_cast<std::byte*>(bytes.data()), bytes.size(), file);
  } catch (const Error&) {
    return false;
  }
  return std::memcmp(bytes.data() + preamble, "DICM", 4) == 0;
}

}  // namespace

fs::path PackedFiles::contentOf(const fs::path& file) {
  if (!isPackedDicom(file)) return file;
  auto archive = std::make_unique<UnpackedArchive>(file);
  const fs::path content = fs::directory_iterator(archive->folder())->path();
  const std::scoped_lock lock(mutex_);
  unpacked_.insert({content.parent_path(), Unpacked{file, std::move(archive)}});
  return content;
}

fs::path PackedFiles::named(const fs::path& file) const {
  const auto at = unpacked_.find(file.parent_path());
  return at == unpacked_.end() ? file : at->second.packed;
}

}  // namespace fenestra::io
