#pragma once
// Who writes a series of the cache: one retrieval at a time, of this program and of others. Private to io/archive.

#include <filesystem>
#include <functional>
#include <optional>
#include <utility>

namespace fenestra::io::archive {

/// Holds SERIES.lock beside the folder of a series. The system lets go of it when the program ends, however it ends, so
/// that a file that a crash left behind locks nothing. On a file system that knows no locks nobody is kept out.
class SeriesLock {
 public:
  /// Waits until nobody else holds it, and calls `wait` every 50 ms meanwhile, which ends the wait by throwing.
  /// `series` is the folder of the series, whole or its part; the folder above it exists.
  SeriesLock(const std::filesystem::path& series, const std::function<void()>& wait);
  /// Empty while another holds it.
  static std::optional<SeriesLock> tryTake(const std::filesystem::path& series);

  SeriesLock(SeriesLock&& from) noexcept : file_(std::move(from.file_)), handle_(std::exchange(from.handle_, -1)) {}
  SeriesLock& operator=(SeriesLock&&) = delete;
  ~SeriesLock();

 private:
  enum class Took : bool { No, Yes };
  explicit SeriesLock(std::filesystem::path file) : file_(std::move(file)) {}
  Took take();

  std::filesystem::path file_;
  int handle_ = -1;  ///< -1: not held, or a file system without locks
};

}  // namespace fenestra::io::archive
