#include "io/base/Archive.h"

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <archive.h>
#include <archive_entry.h>

#include "io/base/ByteStream.h"
#include "io/base/Error.h"
#include "io/base/Text.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

using Reader = std::unique_ptr<archive, decltype([](archive* reader) { archive_read_free(reader); })>;

[[noreturn]] void refuseDamaged(const fs::path& archive, ::archive* reader) {
  const char* cause = archive_error_string(reader);
  throw Error(archive, std::string("cannot be unpacked: ") + (cause ? cause : "damaged"),
              "get the file again from its source, or unpack it yourself");
}

/// The name of a single packed file without the packer's ending.
fs::path unpackedName(const fs::path& archive) {
  const std::string ending = lowered(archive.extension().string());
  return ending == ".gz" || ending == ".bz2" || ending == ".xz" ? archive.stem() : archive.filename();
}

/// An entry's path below the folder; empty for paths that lead out of it, and for what macOS adds to archives.
fs::path entryPath(archive_entry* entry, const fs::path& archive, bool isSingleFile, std::size_t number) {
  if (isSingleFile) return unpackedName(archive);
  const char* name = archive_entry_pathname_utf8(entry);
  if (!name) name = archive_entry_pathname(entry);
  if (!name) return "file" + std::to_string(number);
  const fs::path path = fs::path(name).lexically_normal();
  if (path.empty() || path.is_absolute() || *path.begin() == ".." || *path.begin() == "__MACOSX" ||
      path.filename().string().starts_with("._"))
    return {};
  return path;
}

fs::path makePrivateFolder(const fs::path& archive) {
  std::error_code failure;
  const fs::path parent = fs::temp_directory_path(failure);
  std::string name = (parent / "fenestra-XXXXXX").string();
  if (failure || !::mkdtemp(name.data()))
    throw Error(archive, "cannot be unpacked: no folder can be made in " + parent.string(),
                "set TMPDIR to a folder that can be written");
  return name;
}

}  // namespace

bool looksLikeArchive(const FileStart& start) {
  const std::span<const std::byte> bytes = start.stored();
  const auto startsWith = [&](std::string_view magic, std::size_t at = 0) {
    return bytes.size() >= at + magic.size() && std::memcmp(bytes.data() + at, magic.data(), magic.size()) == 0;
  };
  return startsWith("PK\x03\x04") || startsWith("PK\x05\x06") || startsWith("\x1f\x8b") || startsWith("BZh") ||
         startsWith(
             "\xfd"
             "7zXZ") ||
         startsWith("ustar", 257);
}

UnpackedArchive::UnpackedArchive(fs::path archive, const Progress& progress)
    : archive_(std::move(archive)), folder_(makePrivateFolder(archive_)) {
  try {
    unpack(progress);
  } catch (...) {
    std::error_code unknown;
    fs::remove_all(folder_, unknown);
    throw;
  }
}

UnpackedArchive::~UnpackedArchive() {
  std::error_code unknown;
  fs::remove_all(folder_, unknown);
}

fs::path UnpackedArchive::named(const fs::path& unpacked) const {
  const fs::path inside = unpacked.lexically_relative(folder_);
  if (inside.empty() || *inside.begin() == "..") return unpacked;
  return inside == "." ? archive_ : archive_ / inside;
}

void UnpackedArchive::unpack(const Progress& progress) {
  const Reader reader(archive_read_new());
  archive_read_support_filter_gzip(reader.get());
  archive_read_support_filter_bzip2(reader.get());
  archive_read_support_filter_xz(reader.get());
  archive_read_support_format_zip(reader.get());
  archive_read_support_format_tar(reader.get());
  archive_read_support_format_raw(reader.get());
  constexpr std::size_t blockBytes = 1u << 18;
  if (archive_read_open_filename(reader.get(), archive_.c_str(), blockBytes) != ARCHIVE_OK)
    refuseDamaged(archive_, reader.get());

  const std::uint64_t packed = fs::file_size(archive_);
  const std::uint64_t most = std::max(freely, packed * mostGrowth);
  std::uint64_t written = 0;
  std::size_t files = 0;
  std::vector<char> block(blockBytes);
  archive_entry* entry = nullptr;
  int status = ARCHIVE_OK;
  while ((status = archive_read_next_header(reader.get(), &entry)) == ARCHIVE_OK || status == ARCHIVE_WARN) {
    const bool isSingleFile = archive_format(reader.get()) == ARCHIVE_FORMAT_RAW;
    if (!isSingleFile && archive_entry_filetype(entry) != AE_IFREG) continue;
    if (archive_entry_is_data_encrypted(entry))
      throw Error(archive_, "is encrypted", "unpack it with its password first");
    if (++files > mostFiles)
      throw Error(archive_, "holds more than " + std::to_string(mostFiles) + " files", "unpack it yourself");
    const fs::path inside = entryPath(entry, archive_, isSingleFile, files);
    if (inside.empty()) continue;
    std::error_code failure;
    fs::create_directories((folder_ / inside).parent_path(), failure);
    std::ofstream file(folder_ / inside, std::ios::binary);
    if (!file) {
      // A name that this file system refuses: messages lose it, the data do not.
      file.clear();
      file.open(folder_ / ("file" + std::to_string(files)), std::ios::binary);
    }
    la_ssize_t got = 0;
    while ((got = archive_read_data(reader.get(), block.data(), block.size())) > 0) {
      written += static_cast<std::uint64_t>(got);
      if (written > most)
        throw Error(
            archive_,
            "unpacks to over " + std::to_string(mostGrowth) + " times its size of " + std::to_string(packed) + " bytes",
            "unpack it yourself if you trust it");
      if (!file.write(block.data(), got))
        throw Error(archive_, "cannot be unpacked: " + folder_.parent_path().string() + " is full",
                    "free some space, or set TMPDIR to a folder with more");
      const double done = static_cast<double>(archive_filter_bytes(reader.get(), -1)) / static_cast<double>(packed);
      if (progress && !progress(std::min(done, 1.0), "unpacking")) throw Cancelled();
    }
    if (got < 0) refuseDamaged(archive_, reader.get());
  }
  if (status != ARCHIVE_EOF) refuseDamaged(archive_, reader.get());
  if (files == 0) throw Error(archive_, "is an archive without files", "get the file again from its source");
}

std::optional<ArchiveMember> archiveMember(const fs::path& path) {
  std::error_code unknown;
  for (fs::path parent = path.parent_path(); parent.has_relative_path(); parent = parent.parent_path()) {
    if (fs::is_regular_file(parent, unknown)) return ArchiveMember{parent, path.lexically_relative(parent)};
    if (fs::exists(parent, unknown)) break;
  }
  return std::nullopt;
}

void renameFiles(std::vector<Warning>& warnings, const FileNames& named) {
  for (Warning& warning : warnings)
    for (fs::path& file : warning.files) file = named(file);
}

void renameFiles(OpenedVolume& opened, const FileNames& named) {
  renameFiles(opened.warnings, named);
  if (opened.geometry) renameFiles(opened.geometry->findings, named);
  for (fs::path& file : opened.series.files) file = named(file);
  for (SeriesInfo& series : opened.otherSeries)
    for (fs::path& file : series.files) file = named(file);
  for (SegmentationInfo& segmentation : opened.segmentations) segmentation.file = named(segmentation.file);
}

}  // namespace fenestra::io
