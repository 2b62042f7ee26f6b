#include "io/archive/WebServer.h"

#include <algorithm>
#include <fstream>
#include <iostream>

#include "io/base/Text.h"

namespace fenestra::io::archive {

std::optional<WebServer> parseWebServer(std::string_view text) {
  const std::size_t scheme = text.starts_with("https://") ? 8 : text.starts_with("http://") ? 7 : 0;
  const std::string_view rest = text.substr(scheme);
  const bool isPlain = std::all_of(rest.begin(), rest.end(), [](char c) { return c > 0x20 && c < 0x7f; });
  // A user in the address would show in messages; a question or fragment cannot be a root.
  if (scheme == 0 || rest.empty() || !isPlain || rest.front() == '/' || rest.find_first_of("@?#\\\"") != rest.npos)
    return std::nullopt;
  WebServer server;
  server.url = text;
  while (server.url.ends_with('/')) server.url.pop_back();
  return server;
}

Secret readSecret(const std::filesystem::path& file) {
  std::string line;
  if (file == "-") {
    std::getline(std::cin, line);
  } else {
    std::ifstream stream(file);
    if (!stream) throw Error(file, "cannot be read", "name a file that holds the password or token alone");
    std::getline(stream, line);
  }
  line = trimmed(line);
  constexpr std::size_t most = 16384;
  if (line.empty() || line.size() > most)
    throw Error(file, "holds no password or token", "write it into the first line");
  return Secret(line);
}

void refuse(const WebServer& server, const std::string& cause, const std::string& hint) {
  throw Error(server.name(), cause, hint);
}

}  // namespace fenestra::io::archive
