#pragma once
// The options of `archive`, apart from the other commands.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/options/Options.h"
#include "io/archive/Query.h"
#include "io/archive/Server.h"
#include "io/archive/WebServer.h"

namespace fenestra::cli {

struct ArchiveOptions {
  enum class Action : std::uint8_t { Echo, Find, Get, Move, Send };
  Action action = Action::Echo;
  io::archive::Server server;
  std::optional<io::archive::WebServer> web;  ///< in place of `server`
  io::archive::Query query;
  std::vector<std::string> files;  ///< to send
  std::filesystem::path output, cache;
  bool commits = false;          ///< asks whether the server keeps what was sent
  std::filesystem::path secret;  ///< file of the password or token for `web`
};

void addArchiveOptions(app::Command command, ArchiveOptions& options);
/// Prints what the archive answered as JSON; false where objects to send were not accepted, or are not kept.
bool archive(const ArchiveOptions& options);

}  // namespace fenestra::cli
