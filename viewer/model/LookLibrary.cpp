#include "viewer/model/LookLibrary.h"

#include <algorithm>
#include <utility>

#include <QCollator>
#include <QUrl>

#include "viewer/model/Paths.h"

namespace fenestra::viewer {
namespace {

namespace fs = std::filesystem;

constexpr const char* ending = ".json";
constexpr qsizetype longestName = 100;  ///< bytes of a file's name; file systems commonly allow 255

QString entryName(const LookLibrary::Entry& entry) { return QString::fromStdString(entry.preset.name); }

void removeFile(const fs::path& file) {
  std::error_code failure;
  if (!fs::remove(file, failure) && failure)
    throw io::Error(file, "cannot be deleted", "check the permissions of its folder");
}

}  // namespace

LookLibrary::LookLibrary(fs::path folder, QObject* parent) : QObject(parent), folder_(std::move(folder)) { reload(); }

const LookLibrary::Entry* LookLibrary::find(const QString& name) const {
  const auto at =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& each) { return entryName(each) == name; });
  return at == entries_.end() ? nullptr : &*at;
}

void LookLibrary::reload() {
  entries_.clear();
  problems_.clear();
  std::error_code failure;
  for (fs::directory_iterator file(folder_, failure), end; !failure && file != end; file.increment(failure)) {
    if (file->path().extension() != ending) continue;
    try {
      Entry entry{file->path(), io::readLook(file->path())};
      // A file copied by hand holds its original's name.
      if (find(entryName(entry))) entry.preset.name = file->path().stem().string();
      if (!find(entryName(entry))) entries_.push_back(std::move(entry));
    } catch (const io::Error& error) {
      problems_.emplace_back(error.what());
    }
  }
  QCollator collator;
  collator.setNumericMode(true);
  std::sort(entries_.begin(), entries_.end(),
            [&](const Entry& a, const Entry& b) { return collator.compare(entryName(a), entryName(b)) < 0; });
  Q_EMIT changed();
}

fs::path LookLibrary::fileFor(const QString& name) const {
  if (const Entry* entry = find(name)) return entry->file;
  // Letters that any file system takes; percent signs stand for the rest.
  QByteArray letters = QUrl::toPercentEncoding(name, " ", ".~");
  letters.truncate(longestName);
  fs::path file = folder_ / (letters.toStdString() + ending);
  for (int number = 2; fs::exists(file); ++number)
    file = folder_ / (letters.toStdString() + " " + std::to_string(number) + ending);
  return file;
}

void LookLibrary::keep(const io::LookPreset& preset) {
  if (!canKeep()) throw io::Error({}, "there is no folder for presets", "export the preset to a file of your own");
  std::error_code failure;
  fs::create_directories(folder_, failure);
  if (failure) throw io::Error(folder_, "cannot be made", "check the permissions of the folder above it");
  io::writeLook(fileFor(QString::fromStdString(preset.name)), preset);
  reload();
}

QString LookLibrary::import(const fs::path& file) {
  io::LookPreset preset = io::readLook(file);
  const std::string own = preset.name;
  for (int number = 2; find(QString::fromStdString(preset.name)); ++number)
    preset.name = own + " " + std::to_string(number);
  keep(preset);
  return QString::fromStdString(preset.name);
}

void LookLibrary::rename(const QString& name, const QString& to) {
  const Entry* entry = find(name);
  if (!entry || name == to) return;
  const fs::path old = entry->file;
  io::LookPreset preset = entry->preset;
  preset.name = to.toStdString();
  keep(preset);
  removeFile(old);
  reload();
}

void LookLibrary::remove(const QString& name) {
  const Entry* entry = find(name);
  if (!entry) return;
  removeFile(entry->file);
  reload();
}

}  // namespace fenestra::viewer
