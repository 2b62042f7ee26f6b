#pragma once
// Passwords and tokens of archive servers in the desktop's key ring: the Secret Service (GNOME, KeePassXC) or KWallet,
// whichever runs. Never anywhere else: without one, nothing is kept.

#include <functional>
#include <optional>

#include <QString>

class QObject;
class QWidget;

namespace fenestra::viewer {

struct ServerEntry;

/// What came of reading.
struct KeyRingAnswer {
  std::optional<QString> secret;  ///< none: nothing is kept of that server, or see below
  QString problem;                ///< why the ring cannot be read, as a sentence; empty: it can
};

/// The secret of a server. A locked ring asks the user to open it, which this waits for; the user can go on without.
/// `parent` is blocked meanwhile, and gets no answer once it is gone.
KeyRingAnswer readKeyRing(const ServerEntry& entry, QWidget* parent);

/// Called with a sentence where it failed, while `context` lives.
using KeyRingFailure = std::function<void(const QString& problem)>;
void writeKeyRing(const ServerEntry& entry, const QString& secret, QObject* context, KeyRingFailure failed);
/// Silent where there is nothing to remove.
void removeFromKeyRing(const ServerEntry& entry, QObject* context, KeyRingFailure failed);

/// What the ring calls the secret: who we are and where. An entry that is changed to another address finds no secret of
/// the one before.
QString keyRingName(const ServerEntry& entry);

}  // namespace fenestra::viewer
