#pragma once
// The archive servers of one window: their entries, the logins of this run, and where their objects are kept. Nothing
// here connects; workers do, on threads of their own (archiveThreads), because waiting for a network must not hold up
// the reading of files.

#include <filesystem>
#include <functional>
#include <vector>

#include <QHash>
#include <QObject>
#include <QPointer>
#include <QStringList>
#include <QThreadPool>
#include <QWidget>

#include "viewer/archive/ServerEntry.h"

namespace fenestra::viewer {

class Preferences;

/// Started with the first task.
QThreadPool& archiveThreads();

class Archives : public QObject {
  Q_OBJECT
 public:
  /// `preferences` outlives this.
  explicit Archives(Preferences& preferences, QObject* parent = nullptr);

  const std::vector<ServerEntry>& servers() const { return servers_; }
  /// Null: there is none any more.
  const ServerEntry* find(const QString& id) const;
  /// Adds the entry, or replaces the one with its id; the secret of a changed one is forgotten.
  void put(const ServerEntry& entry);
  void remove(const QString& id);

  /// Asks the user for a server's password or token; empty: not given. Replaced in tests.
  using AskSecret = std::function<std::optional<QString>(const ServerEntry&)>;
  void setAskSecret(AskSecret ask) { askSecret_ = std::move(ask); }
  /// The window that is blocked while the key ring is waited for.
  void setWindow(QWidget* window) { window_ = window; }
  /// What a worker needs to reach the server. Where it has a secret that is not known, the key ring or the user is
  /// asked, if that is allowed; empty when none is given.
  enum class Asking : std::uint8_t { Allowed, Never };
  std::optional<AnyServer> reach(const ServerEntry& entry, Asking asking = Asking::Allowed);
  /// To be asked for anew, as after a failed login; the key ring forgets it, too.
  void forgetSecret(const QString& id);

  Preferences& preferences() { return preferences_; }
  /// Where objects are kept: as the settings say, or else the cache of the user. Empty where there is no home.
  std::filesystem::path cacheFolder() const;

 Q_SIGNALS:
  void serversChanged();
  /// The key ring cannot be used; what is asked for meanwhile stays in memory.
  void keyRingFailed(const QString& problem);

 private:
  void store();
  /// The secret of an entry that has one, from the key ring or the user.
  std::optional<QString> secretOf(const ServerEntry& entry);
  void forgetSecret(const ServerEntry& entry);

  Preferences& preferences_;
  std::vector<ServerEntry> servers_;
  QHash<QString, io::archive::Secret> secrets_;
  AskSecret askSecret_;
  QPointer<QWidget> window_;
};

}  // namespace fenestra::viewer
