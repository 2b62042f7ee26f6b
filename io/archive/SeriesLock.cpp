#include "io/archive/SeriesLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <chrono>
#include <thread>

namespace fenestra::io::archive {
namespace {

namespace fs = std::filesystem;

/// One for the series' folder and for its part.
fs::path lockOf(const fs::path& series) { return series.parent_path() / (series.stem().string() + ".lock"); }

}  // namespace

SeriesLock::SeriesLock(const fs::path& series, const std::function<void()>& wait) : SeriesLock(lockOf(series)) {
  constexpr auto step = std::chrono::milliseconds(50);
  while (take() == Took::No) {
    wait();
    std::this_thread::sleep_for(step);
  }
}

std::optional<SeriesLock> SeriesLock::tryTake(const fs::path& series) {
  SeriesLock lock(lockOf(series));
  if (lock.take() == Took::No) return std::nullopt;
  return lock;
}

SeriesLock::~SeriesLock() {
  if (handle_ < 0) return;
  // While it is held: whoever opened the file meanwhile sees that it is gone, and makes a new one.
  unlink(file_.c_str());
  close(handle_);
}

SeriesLock::Took SeriesLock::take() {
  for (;;) {
    const int handle = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR);
    if (handle < 0) return Took::Yes;  // what cannot be written says so when objects come
    int result = 0;
    while ((result = flock(handle, LOCK_EX | LOCK_NB)) != 0 && errno == EINTR) {
    }
    if (result != 0) {
      const bool isHeld = errno == EWOULDBLOCK;
      close(handle);
      return isHeld ? Took::No : Took::Yes;
    }
    struct stat held {
    }, named{};
    if (fstat(handle, &held) == 0 && stat(file_.c_str(), &named) == 0 && held.st_ino == named.st_ino &&
        held.st_dev == named.st_dev) {
      handle_ = handle;
      return Took::Yes;
    }
    close(handle);  // it was removed between open and lock
  }
}

}  // namespace fenestra::io::archive
