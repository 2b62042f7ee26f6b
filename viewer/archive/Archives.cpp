#include "viewer/archive/Archives.h"

#include <algorithm>

#include "io/archive/Cache.h"
#include "viewer/archive/KeyRing.h"
#include "viewer/model/Paths.h"
#include "viewer/model/Preferences.h"

namespace fenestra::viewer {

QThreadPool& archiveThreads() {
  static QThreadPool threads;
  constexpr int most = 8;  // they wait for the network most of the time
  threads.setMaxThreadCount(most);
  return threads;
}

Archives::Archives(Preferences& preferences, QObject* parent) : QObject(parent), preferences_(preferences) {
  for (const QVariant& stored : preferences_.archiveServers())
    if (const std::optional<ServerEntry> entry = serverEntryOf(stored.toMap())) servers_.push_back(*entry);
}

const ServerEntry* Archives::find(const QString& id) const {
  const auto at =
      std::find_if(servers_.begin(), servers_.end(), [&](const ServerEntry& each) { return each.id == id; });
  return at == servers_.end() ? nullptr : &*at;
}

void Archives::put(const ServerEntry& entry) {
  const auto at =
      std::find_if(servers_.begin(), servers_.end(), [&](const ServerEntry& each) { return each.id == entry.id; });
  if (at == servers_.end()) {
    servers_.push_back(entry);
  } else {
    // A secret never goes to another address than the one that it was given for.
    if (*at != entry) forgetSecret(*at);
    *at = entry;
  }
  store();
}

void Archives::remove(const QString& id) {
  forgetSecret(id);
  std::erase_if(servers_, [&](const ServerEntry& each) { return each.id == id; });
  store();
}

void Archives::store() {
  QVariantList list;
  for (const ServerEntry& each : servers_) list << toMap(each);
  preferences_.setArchiveServers(list);
  Q_EMIT serversChanged();
}

std::optional<AnyServer> Archives::reach(const ServerEntry& entry, Asking asking) {
  io::archive::Limits limits;
  limits.cacheBytes = static_cast<std::uint64_t>(preferences_.value(Preference::ArchiveGigabytes)) << 30;
  if (entry.kind == ServerEntry::Kind::Web && entry.login != ServerEntry::Login::None && !secrets_.contains(entry.id)) {
    const std::optional<QString> given = asking == Asking::Allowed ? secretOf(ServerEntry(entry)) : std::nullopt;
    if (!given || given->isEmpty()) return std::nullopt;
    secrets_.insert(entry.id, io::archive::Secret(given->toStdString()));
  }
  return serverOf(entry, secrets_.value(entry.id), limits);
}

std::optional<QString> Archives::secretOf(const ServerEntry& entry) {
  bool canKeep = entry.keepsSecret;
  if (entry.keepsSecret) {
    const KeyRingAnswer kept = readKeyRing(entry, window_);
    if (kept.secret && !kept.secret->isEmpty()) return kept.secret;
    canKeep = kept.problem.isEmpty();
    if (!canKeep) Q_EMIT keyRingFailed(kept.problem);
  }
  const std::optional<QString> given = askSecret_ ? askSecret_(entry) : std::nullopt;
  if (given && !given->isEmpty() && canKeep)
    writeKeyRing(entry, *given, this, [this](const QString& problem) { Q_EMIT keyRingFailed(problem); });
  return given;
}

void Archives::forgetSecret(const QString& id) {
  if (const ServerEntry* entry = find(id)) forgetSecret(*entry);
}

void Archives::forgetSecret(const ServerEntry& entry) {
  secrets_.remove(entry.id);
  if (entry.keepsSecret)
    removeFromKeyRing(entry, this, [this](const QString& problem) { Q_EMIT keyRingFailed(problem); });
}

std::filesystem::path Archives::cacheFolder() const {
  const std::filesystem::path chosen = preferences_.archiveFolder();
  return chosen.empty() ? io::archive::defaultCacheFolder() : chosen;
}

}  // namespace fenestra::viewer
