#include "io/archive/Cache.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <optional>
#include <system_error>

#include "io/base/Contents.h"
#include "io/base/Error.h"

namespace fenestra::io::archive {
namespace {

namespace fs = std::filesystem;

/// A folder that its owner alone can enter. Throws Error.
void makePrivate(const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!failure) fs::permissions(folder, fs::perms::owner_all, failure);
  if (failure) throw Error(folder, "cannot be made: " + failure.message(), "name a folder that can be written to");
}

std::vector<fs::path> objectsIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code failure;
  for (fs::directory_iterator entry(folder, failure); !failure && entry != fs::directory_iterator();
       entry.increment(failure))
    if (entry->path().extension() == ".dcm") files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  return files;
}

/// A series of the cache, for trimming.
struct KeptSeries {
  fs::path folder;
  fs::file_time_type used;
  std::uint64_t bytes = 0;
};

std::vector<KeptSeries> seriesIn(const fs::path& root) {
  std::vector<KeptSeries> all;
  std::error_code failure;
  for (const auto& study : fs::directory_iterator(root, failure)) {
    if (!study.is_directory(failure)) continue;
    for (const auto& series : fs::directory_iterator(study.path(), failure)) {
      if (!series.is_directory(failure)) continue;
      KeptSeries kept{series.path(), fs::last_write_time(series.path(), failure)};
      for (const auto& file : fs::directory_iterator(series.path(), failure)) kept.bytes += file.file_size(failure);
      all.push_back(std::move(kept));
    }
  }
  return all;
}

/// False: it is being written, and stays.
bool removeSeries(const fs::path& folder) {
  std::error_code failure;
  {
    const std::optional<SeriesLock> lock = SeriesLock::tryTake(folder);
    if (!lock) return false;
    fs::remove_all(folder, failure);
  }
  fs::remove(folder.parent_path(), failure);  // of a study that holds no more series
  return true;
}

}  // namespace

fs::path defaultCacheFolder() {
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    return fs::path(value ? value : "");
  };
  fs::path cache = folder("XDG_CACHE_HOME");
  if (!cache.is_absolute() && !folder("HOME").empty()) cache = folder("HOME") / ".cache";
  return cache.is_absolute() ? cache / "fenestra" / "archive" : fs::path();
}

std::string cacheName(const std::string& uid) {
  constexpr std::size_t scheme = 7, digits = 32;  // "sha256:", and enough of it that no two UIDs meet
  return hashOf(uid).substr(scheme, digits);
}

Cache::Cache(fs::path root) : root_(std::move(root)) { makePrivate(root_); }

fs::path Cache::folderOf(const std::string& study, const std::string& series) const {
  return root_ / cacheName(study) / cacheName(series);
}

fs::path Cache::partOf(const std::string& study, const std::string& series) const {
  fs::path part = folderOf(study, series);
  makePrivate(part.parent_path());
  part += ".part";
  makePrivate(part);
  return part;
}

SeriesLock Cache::lock(const std::string& study, const std::string& series, const std::function<void()>& wait) const {
  const fs::path folder = folderOf(study, series);
  makePrivate(folder.parent_path());
  return {folder, wait};
}

std::set<std::string> Cache::held(const std::string& study, const std::string& series) const {
  fs::path part = folderOf(study, series);
  std::set<std::string> names;
  for (const fs::path& file : objectsIn(part)) names.insert(file.stem().string());
  part += ".part";
  for (const fs::path& file : objectsIn(part)) names.insert(file.stem().string());
  return names;
}

void Cache::complete(const std::string& study, const std::string& series) const {
  const fs::path whole = folderOf(study, series), part = partOf(study, series);
  if (fs::exists(whole)) {
    for (const fs::path& file : objectsIn(part)) fs::rename(file, whole / file.filename());
    fs::remove_all(part);
  } else {
    // A program that was ended left what it was receiving, which is no object of the series.
    for (const auto& entry : fs::directory_iterator(part))
      if (entry.path().extension() != ".dcm") fs::remove_all(entry.path());
    fs::rename(part, whole);
  }
  std::error_code failure;
  fs::last_write_time(whole, fs::file_time_type::clock::now(), failure);  // used now, for trim()
}

std::uint64_t Cache::bytes() const {
  std::uint64_t bytes = 0;
  for (const KeptSeries& each : seriesIn(root_)) bytes += each.bytes;
  return bytes;
}

void Cache::trim(std::uint64_t most, const std::set<fs::path>& kept) const {
  std::vector<KeptSeries> all = seriesIn(root_);
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.used < b.used; });
  std::uint64_t bytes = 0;
  for (const KeptSeries& each : all) bytes += each.bytes;
  for (const KeptSeries& each : all) {
    if (bytes <= most) return;
    if (kept.contains(each.folder)) continue;
    if (removeSeries(each.folder)) bytes -= each.bytes;
  }
}

void Cache::clear() const {
  for (const KeptSeries& each : seriesIn(root_)) removeSeries(each.folder);
  std::error_code failure;
  for (const auto& study : fs::directory_iterator(root_, failure)) {
    std::error_code ignored;
    fs::remove(study.path(), ignored);  // where it is empty, as after a crash
  }
}

std::size_t layOut(const std::vector<fs::path>& series, const fs::path& folder) {
  std::error_code failure;
  if (fs::exists(folder, failure) && !fs::is_empty(folder, failure))
    throw Error(folder, "holds files", "name a folder that does not exist or is empty");
  const fs::path target = folder.has_filename() ? folder : folder.parent_path();
  if (target.has_parent_path()) fs::create_directories(target.parent_path(), failure);
  // Beside the folder under a name that nobody else has; for its owner alone.
  std::string name = target.string() + ".XXXXXX";
  if (!::mkdtemp(name.data()))
    throw Error(folder, "cannot be made: " + std::generic_category().message(errno),
                "name a folder that can be written to");
  const fs::path made = name;
  std::size_t count = 0;
  for (const fs::path& each : series)
    for (const fs::path& file : objectsIn(each)) {
      fs::create_hard_link(file, made / file.filename(), failure);
      if (failure) fs::copy_file(file, made / file.filename(), failure);
      if (failure) break;
      ++count;
    }
  if (!failure) fs::rename(made, target, failure);
  if (!failure) return count;
  const std::string why = failure.message();
  fs::remove_all(made, failure);
  throw Error(folder, "cannot be written: " + why, "choose a place with space that can be written to");
}

}  // namespace fenestra::io::archive
