#pragma once
// The user's presets of looks: files of a folder, one each (io/session/LookFile.h). Nothing is cached beyond what the
// list shows; a file that somebody puts there by hand is found at the next reload().

#include <filesystem>
#include <vector>

#include <QObject>
#include <QString>

#include "io/session/LookFile.h"

namespace fenestra::viewer {

class LookLibrary : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    std::filesystem::path file;
    io::LookPreset preset;
  };

  /// An empty folder: presets can neither be kept nor listed. It is made when the first one is kept.
  explicit LookLibrary(std::filesystem::path folder, QObject* parent = nullptr);

  bool canKeep() const { return !folder_.empty(); }
  /// By name, as people sort names.
  const std::vector<Entry>& entries() const { return entries_; }
  const Entry* find(const QString& name) const;
  /// What is wrong with files of the folder that cannot be read, a line each.
  const std::vector<std::string>& problems() const { return problems_; }
  void reload();

  /// Keeps a preset under its name, in place of one that has the name already. Throws io::Error.
  void keep(const io::LookPreset& preset);
  /// Reads a file and keeps its preset; where the name is taken, under "NAME 2". The name that it has then.
  /// Throws io::Error.
  QString import(const std::filesystem::path& file);
  /// Throws io::Error. What is under the new name already is replaced.
  void rename(const QString& name, const QString& to);
  void remove(const QString& name);

 Q_SIGNALS:
  void changed();

 private:
  std::filesystem::path fileFor(const QString& name) const;

  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::vector<std::string> problems_;
};

}  // namespace fenestra::viewer
