#include "viewer/archive/ServerEntry.h"

#include <QUuid>

#include "viewer/model/Paths.h"

namespace fenestra::viewer {
namespace {

struct EntryText {
  const char* key;
  QString ServerEntry::*member;
};
constexpr EntryText entryTexts[]{{"id", &ServerEntry::id},
                                 {"name", &ServerEntry::name},
                                 {"host", &ServerEntry::host},
                                 {"title", &ServerEntry::title},
                                 {"ownTitle", &ServerEntry::ownTitle},
                                 {"interface", &ServerEntry::interface},
                                 {"certificate", &ServerEntry::certificate},
                                 {"key", &ServerEntry::key},
                                 {"url", &ServerEntry::url},
                                 {"user", &ServerEntry::user},
                                 {"authorities", &ServerEntry::authorities}};

bool isPort(int port) { return port >= 1 && port <= 65535; }

std::string dicomAddress(const ServerEntry& entry) {
  return QStringLiteral("%1://%2@%3:%4")
      .arg(entry.kind == ServerEntry::Kind::DicomTls ? QStringLiteral("dicoms") : QStringLiteral("dicom"), entry.title,
           entry.host)
      .arg(entry.port)
      .toStdString();
}

QString dicomProblem(const ServerEntry& entry) {
  if (!io::archive::isTitle(entry.title.toStdString()))
    return ServerEntry::tr("The server's AE title has 1 to 16 letters and digits; its administrator knows it.");
  if (!io::archive::isTitle(entry.ownTitle.toStdString()))
    return ServerEntry::tr("Our AE title has 1 to 16 letters and digits; the server must know it.");
  if (!isPort(entry.port) || !io::archive::parseServer(dicomAddress(entry)))
    return ServerEntry::tr("The host is a name or an address, such as pacs.hospital or 192.168.1.5.");
  if (entry.moves && !isPort(entry.ownPort))
    return ServerEntry::tr("C-MOVE needs a port of ours that is entered at the server.");
  if (entry.kind != ServerEntry::Kind::DicomTls) return {};
  if (entry.authorities.isEmpty())
    return ServerEntry::tr("TLS needs the file of the certificates that may sign the server's, in PEM.");
  if (entry.certificate.isEmpty() != entry.key.isEmpty())
    return ServerEntry::tr("Our certificate needs its key, and the key its certificate.");
  return {};
}

}  // namespace

ServerEntry newServerEntry() {
  ServerEntry entry;
  entry.id = QUuid::createUuid().toString(QUuid::WithoutBraces);
  return entry;
}

QVariantMap toMap(const ServerEntry& entry) {
  QVariantMap map{{QStringLiteral("kind"), static_cast<int>(entry.kind)},
                  {QStringLiteral("port"), entry.port},
                  {QStringLiteral("moves"), entry.moves},
                  {QStringLiteral("ownPort"), entry.ownPort},
                  {QStringLiteral("keepsSecret"), entry.keepsSecret},
                  {QStringLiteral("login"), static_cast<int>(entry.login)}};
  for (const EntryText& text : entryTexts) map.insert(QLatin1String(text.key), entry.*text.member);
  return map;
}

std::optional<ServerEntry> serverEntryOf(const QVariantMap& map) {
  // The file may have been edited by hand.
  const auto number = [&map](const char* key) { return map.value(QLatin1String(key)).toInt(); };
  const int kind = number("kind"), login = number("login");
  if (kind < 0 || kind > static_cast<int>(ServerEntry::Kind::Web)) return std::nullopt;
  if (login < 0 || login > static_cast<int>(ServerEntry::Login::Token)) return std::nullopt;
  ServerEntry entry;
  entry.kind = static_cast<ServerEntry::Kind>(kind);
  entry.login = static_cast<ServerEntry::Login>(login);
  entry.port = number("port");
  entry.moves = map.value(QStringLiteral("moves")).toBool();
  entry.ownPort = number("ownPort");
  entry.keepsSecret = map.value(QStringLiteral("keepsSecret")).toBool();
  for (const EntryText& text : entryTexts) entry.*text.member = map.value(QLatin1String(text.key)).toString();
  return entry.id.isEmpty() || !problemOf(entry).isEmpty() ? std::nullopt : std::optional(entry);
}

QString problemOf(const ServerEntry& entry) {
  if (entry.kind != ServerEntry::Kind::Web) return dicomProblem(entry);
  if (!io::archive::parseWebServer(entry.url.toStdString()))
    return ServerEntry::tr("The address is that of DICOMweb's root, such as https://pacs.hospital/dicom-web.");
  if (entry.login == ServerEntry::Login::Password && entry.user.isEmpty())
    return ServerEntry::tr("A login with a password needs the user's name.");
  return {};
}

AnyServer serverOf(const ServerEntry& entry, const io::archive::Secret& secret, const io::archive::Limits& limits) {
  if (entry.kind == ServerEntry::Kind::Web) {
    io::archive::WebServer web = io::archive::parseWebServer(entry.url.toStdString()).value();
    if (entry.login == ServerEntry::Login::Password) web.user = entry.user.toStdString();
    if (entry.login != ServerEntry::Login::None) web.secret = secret;
    web.authorities = toPath(entry.authorities);
    web.limits = limits;
    return web;
  }
  io::archive::Server server = io::archive::parseServer(dicomAddress(entry)).value();
  server.ownTitle = entry.ownTitle.toStdString();
  server.interface = entry.interface.toStdString();
  server.ownPort = entry.ownPort;
  if (server.tls) *server.tls = {toPath(entry.authorities), toPath(entry.certificate), toPath(entry.key)};
  server.limits = limits;
  return server;
}

}  // namespace fenestra::viewer
