#include "io/base/AtomicFile.h"

#include <fcntl.h>
#include <unistd.h>
#include <atomic>
#include <cstdio>
#include <sstream>

#include "io/base/ByteStream.h"
#include "io/base/Error.h"

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

/// Data reach the disk before the name does, so that a crash leaves the old file or the new one.
void syncToDisk(const fs::path& file, const fs::path& named) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) failToWrite(named);
  const bool synced = ::fsync(descriptor) == 0;
  ::close(descriptor);
  if (!synced) failToWrite(named);
}

}  // namespace

[[noreturn]] void failToWrite(const fs::path& path) {
  throw Error(path, "cannot be written: " + systemCause(), "check the folder, its permissions and the free space");
}

void writeBytes(const fs::path& path, std::initializer_list<std::pair<const void*, std::size_t>> pieces) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) failToWrite(path);
  bool written = true;
  for (const auto& [bytes, size] : pieces) written = written && std::fwrite(bytes, 1, size, file) == size;
  if (std::fclose(file) != 0 || !written) failToWrite(path);
}

void writeAtomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  static std::atomic<unsigned> counter = 0;
  std::error_code failure;
  // A link stays a link: what it points at is replaced.
  const fs::path target = fs::is_symlink(path, failure) ? fs::weakly_canonical(path, failure) : path;
  // A device or a pipe, such as /dev/null, would be gone after a rename.
  const fs::file_status status = fs::status(target, failure);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) return write(target);
  fs::path temporary = target;
  std::ostringstream name;
  name << '.' << target.filename().string() << '.' << ::getpid() << '-' << counter++ << ".part";
  temporary.replace_filename(name.str());
  try {
    write(temporary);
    syncToDisk(temporary, path);
    if (std::rename(temporary.c_str(), target.c_str()) != 0) failToWrite(path);
  } catch (const Error& error) {
    fs::remove(temporary, failure);
    // The message names the file that the caller named.
    if (error.file() == temporary) throw Error(path, error.cause(), error.hint());
    throw;
  } catch (...) {
    fs::remove(temporary, failure);
    throw;
  }
}

void writeText(const fs::path& path, const std::string& text) {
  writeAtomically(path, [&](const fs::path& temporary) { writeBytes(temporary, {{text.data(), text.size()}}); });
}

}  // namespace fenestra::io
