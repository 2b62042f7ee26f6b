#pragma once
// An archive server as the user entered it, kept in the preferences. It holds no secret: a password or token is asked
// for when it is needed, and stays in memory or, where the user says so, in the desktop's key ring (KeyRing.h).

#include <cstdint>
#include <optional>
#include <variant>

#include <QCoreApplication>
#include <QString>
#include <QVariantMap>

#include "io/archive/WebServer.h"

namespace fenestra::viewer {

struct ServerEntry {
  enum class Kind : std::uint8_t { Dicom, DicomTls, Web };
  enum class Login : std::uint8_t { None, Password, Token };

  QString id;    ///< tells entries apart; made by newServerEntry()
  QString name;  ///< as the user calls it
  Kind kind = Kind::Dicom;

  // DICOM's own protocol.
  QString host;
  int port = 104;
  QString title, ownTitle = QStringLiteral("FENESTRA");  ///< AE titles
  bool moves = false;                                    ///< retrieves by C-MOVE rather than C-GET
  QString interface = QStringLiteral("127.0.0.1");       ///< address of ours that C-MOVE's objects come to,
  int ownPort = 11112;                                   ///< and port; storage commitments, too
  QString certificate, key;                              ///< ours, PEM files; empty: none

  // DICOMweb.
  QString url;  ///< of the service's root
  Login login = Login::None;
  QString user;
  bool keepsSecret = false;  ///< its password or token, in the key ring

  QString authorities;  ///< PEM file of certificates that may sign the server's; TLS needs it

  bool operator==(const ServerEntry&) const = default;

  Q_DECLARE_TR_FUNCTIONS(ServerEntry)
};

/// With an id of its own.
ServerEntry newServerEntry();

/// For the preferences, and out of them; empty for what is no entry.
QVariantMap toMap(const ServerEntry& entry);
std::optional<ServerEntry> serverEntryOf(const QVariantMap& map);

/// What is wrong with an entry and what to do, as a sentence; empty: nothing.
QString problemOf(const ServerEntry& entry);

/// How io/archive reaches it; `limits` bounds the conversation. The entry has no problem.
using AnyServer = std::variant<io::archive::Server, io::archive::WebServer>;
AnyServer serverOf(const ServerEntry& entry, const io::archive::Secret& secret, const io::archive::Limits& limits);

}  // namespace fenestra::viewer
