#include "io/archive/Server.h"

#include <algorithm>

#include "io/base/Text.h"

namespace fenestra::io::archive {

std::string Server::name() const {
  return (tls ? "dicoms://" : "dicom://") + title + "@" + host + ":" + std::to_string(port);
}

bool isTitle(std::string_view title) {
  return !title.empty() && title.size() <= 16 && title.find_first_not_of(' ') != std::string_view::npos &&
         std::all_of(title.begin(), title.end(), [](char c) { return c >= 0x20 && c < 0x7f && c != '\\'; });
}

std::optional<Server> parseServer(std::string_view text) {
  Server server;
  if (text.starts_with("dicoms://")) {
    server.tls.emplace();
    server.port = 2762;  // the well-known port of DICOM over TLS (PS3.8 9.1.1)
    text.remove_prefix(9);
  } else if (text.starts_with("dicom://")) {
    text.remove_prefix(8);
  } else {
    return std::nullopt;
  }
  const std::size_t at = text.find('@');
  if (at == std::string_view::npos || !isTitle(text.substr(0, at))) return std::nullopt;
  server.title = text.substr(0, at);
  text.remove_prefix(at + 1);
  if (text.ends_with('/')) text.remove_suffix(1);
  if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
    const std::optional<int> port = numberIn<int>(text.substr(colon + 1));
    if (!port || *port < 1 || *port > 65535) return std::nullopt;
    server.port = *port;
    text = text.substr(0, colon);
  }
  // DCMTK's address of a host has 127 characters.
  if (text.empty() || text.size() > 127 || text.find_first_of("/@ :[]") != std::string_view::npos) return std::nullopt;
  server.host = text;
  return server;
}

void refuse(const Server& server, const std::string& cause, const std::string& hint) {
  throw Error(server.name(), cause, hint);
}

}  // namespace fenestra::io::archive
