#include "app/cli/ArchiveCommand.h"

#include <algorithm>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/cli/Report.h"
#include "app/options/Numbers.h"
#include "app/options/WordOptions.h"
#include "io/archive/Cache.h"
#include "io/archive/Commitment.h"
#include "io/archive/Retrieve.h"
#include "io/archive/Send.h"
#include "io/archive/WebArchive.h"

namespace fenestra::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Action = ArchiveOptions::Action;

void addServer(app::Command command, ArchiveOptions& options) {
  app::addChoice<Action>(command, "ACTION", "echo, find, get, move or send",
                         {{"echo", Action::Echo},
                          {"find", Action::Find},
                          {"get", Action::Get},
                          {"move", Action::Move},
                          {"send", Action::Send}},
                         options.action)
      .required()
      .as("");
  command
      .add("SERVER", "dicom://TITLE@HOST:PORT or http(s)://HOST/ROOT",
           "dicom://TITLE@HOST:PORT with the server's AE title, dicoms:// for TLS; or http(s)://HOST/ROOT of DICOMweb",
           [&options](const std::string& text) {
             options.web = io::archive::parseWebServer(text);
             if (const auto server = io::archive::parseServer(text)) options.server = *server;
             return options.web || !options.server.host.empty();
           })
      .required()
      .as("");
  command.addValue("PATH", options.files, "send: DICOM files, and folders that hold some").as("");
}

void addKeys(app::Command command, ArchiveOptions& options) {
  command.group("What to find or retrieve");
  app::addWords<io::archive::Level>(command, "--level", "find: what an answer is about, default study",
                                    options.query.level);
  command
      .addRepeated("--key", "ATTRIBUTE=VALUE",
                   "such as PatientName=Smith*, PatientID=123, StudyDate=20240101-20241231 or StudyInstanceUID=UID; * "
                   "stands for any text, ? for a character. get and move need StudyInstanceUID, and take "
                   "SeriesInstanceUID",
                   [&options](const std::vector<std::string>& texts) {
                     for (const std::string& text : texts) {
                       const std::size_t equals = text.find('=');
                       if (equals == std::string::npos)
                         throw app::WrongValue{"\"" + text + "\" is not ATTRIBUTE=VALUE"};
                       const std::string keyword = text.substr(0, equals), value = text.substr(equals + 1);
                       const std::string problem = io::archive::problemOf(keyword, value);
                       if (!problem.empty()) throw app::WrongValue{problem};
                       options.query.keys[keyword] = value;
                     }
                   })
      .oneEach();
  command
      .addValue("--character-set", options.server.characterSet,
                "of keys beyond ASCII, as ISO_IR 100; UTF-8 otherwise, and then the sets that can say them")
      .as("SET");
}

void addConversation(app::Command command, ArchiveOptions& options) {
  io::archive::Server& server = options.server;
  command.group("Connection");
  command.add("--calling", "TITLE", "our own AE title, default FENESTRA, which the server must know",
              [&server](const std::string& text) {
                server.ownTitle = text;
                return io::archive::isTitle(text);
              });
  command
      .addValue("--interface", server.interface,
                "move, --commit: address of this machine that the server sends to, default 127.0.0.1")
      .as("ADDRESS");
  command
      .addValue("--port", server.ownPort,
                "move, --commit: port of this machine that the server sends to; open only meanwhile")
      .as("PORT")
      .within(1, 65535);
  command.add("--silence", "SECONDS", "how long the server may be silent, default 60; a transfer may take any time",
              [&options, &server](const std::string& text) {
                const std::optional<double> seconds = app::parseNumber<double>(text);
                if (!seconds || *seconds < 0.1 || *seconds > 86400) return false;
                server.limits.silence = std::chrono::milliseconds(std::lround(*seconds * 1000));
                if (options.web) options.web->limits.silence = server.limits.silence;
                return true;
              });
}

void addTls(app::Command command, ArchiveOptions& options) {
  using io::archive::TlsFiles;
  const auto file = [&](const char* name, const char* description, fs::path TlsFiles::*member) {
    return command.add(name, "FILE", description, [&options, member](const std::string& text) {
      const bool isWeb = options.web && options.web->isEncrypted() && member == &TlsFiles::authorities;
      if (!isWeb && !options.server.tls)
        throw app::WrongValue{"the server is not named dicoms:// or, for --tls-authorities, https://"};
      if (isWeb)
        options.web->authorities = text;
      else
        *options.server.tls.*member = text;
      return !text.empty();
    });
  };
  file("--tls-authorities", "certificates in PEM that may sign the server's, or its own; needed for dicoms://",
       &TlsFiles::authorities);
  const app::Option certificate =
      file("--tls-certificate", "ours in PEM, where the server asks for one", &TlsFiles::certificate);
  const app::Option key = file("--tls-key", "of our certificate, in PEM", &TlsFiles::key);
  certificate.needs(key);
  key.needs(certificate);
  command.add("--user", "NAME", "DICOMweb: who we are, with the password of --secret",
              [&options](const std::string& text) {
                if (!options.web) throw app::WrongValue{"the server is not named http:// or https://"};
                options.web->user = text;
                return !text.empty();
              });
  command.add("--secret", "FILE",
              "DICOMweb: whose first line is the password, or without --user a bearer token; - reads "
              "standard input",
              [&options](const std::string& text) {
                if (!options.web) throw app::WrongValue{"the server is not named http:// or https://"};
                options.secret = text;
                return !text.empty();
              });
}

void addCommitment(app::Command command, ArchiveOptions& options) {
  command.group("Sending");
  const app::Option commit = command.addFlag(
      "--commit", options.commits,
      "ask the server to confirm that it keeps the objects (storage commitment); most servers need --port for that");
  command
      .add("--wait", "SECONDS", "how long to wait for the confirmation, default 300",
           [&options](const std::string& text) {
             const std::optional<double> seconds = app::parseNumber<double>(text);
             if (!seconds || *seconds < 0.1 || *seconds > 86400) return false;
             options.server.limits.commitment = std::chrono::milliseconds(std::lround(*seconds * 1000));
             return true;
           })
      .needs(commit);
}

/// What an action needs.
void checkAction(const ArchiveOptions& options) {
  const bool retrieves = options.action == Action::Get || options.action == Action::Move;
  if (options.web && options.action == Action::Move) throw app::WrongValue{"DICOMweb has no move; use archive get"};
  if (options.web && options.secret.empty() && !options.web->user.empty())
    throw app::MissingOption{"--secret", "--user"};
  if (options.server.tls && options.server.tls->authorities.empty())
    throw app::MissingOption{"--tls-authorities", "dicoms://"};
  if (options.commits && options.action != Action::Send) throw app::WrongValue{"only archive send takes --commit"};
  if (options.commits && options.web)
    throw app::WrongValue{"DICOMweb has no storage commitment; name the server dicom:// or dicoms://"};
  if (options.action == Action::Send && options.files.empty()) throw app::MissingOption{"PATH", "archive send"};
  if (options.action != Action::Send && !options.files.empty()) throw app::WrongValue{"only archive send takes PATH"};
  if (!retrieves) return;
  if (!options.query.keys.contains("StudyInstanceUID"))
    throw app::MissingOption{"--key StudyInstanceUID=UID", "archive get"};
  for (const auto& [keyword, value] : options.query.keys)
    if (keyword != "StudyInstanceUID" && keyword != "SeriesInstanceUID")
      throw app::WrongValue{"get and move take the keys StudyInstanceUID and SeriesInstanceUID alone"};
  if (options.action == Action::Move && options.server.ownPort == 0) throw app::MissingOption{"--port", "archive move"};
}

/// What `act` makes of the server, whichever it speaks.
template <class Act>
auto withServer(const ArchiveOptions& options, const Act& act) {
  if (!options.web) return act(options.server);
  io::archive::WebServer server = *options.web;
  if (!options.secret.empty()) server.secret = io::archive::readSecret(options.secret);
  return act(server);
}

std::string nameOf(const ArchiveOptions& options) { return options.web ? options.web->name() : options.server.name(); }

Json echoed(const ArchiveOptions& options) {
  const auto taken =
      withServer(options, [](const auto& server) { return io::archive::echo(server, progressOnTerminal()); });
  return {{"source", nameOf(options)}, {"answer_ms", taken.count()}};
}

Json found(const ArchiveOptions& options) {
  const io::archive::Answers answers = withServer(
      options, [&](const auto& server) { return io::archive::find(server, options.query, progressOnTerminal()); });
  if (answers.ignoresKeys)
    printWarnings({{io::Warning::Kind::Other, "the server does not match by some of the keys", {}, {}}});
  Json records = Json::array();
  for (const io::archive::Attributes& record : answers.records) records.push_back(record);
  return {{"source", nameOf(options)},
          {"level", wordOf(options.query.level).word},
          {"complete", answers.complete},
          {"results", std::move(records)}};
}

Json retrieved(const ArchiveOptions& options) {
  const fs::path root = options.cache.empty() ? io::archive::defaultCacheFolder() : options.cache;
  if (root.empty())
    throw io::Error(nameOf(options), "there is neither a home nor a cache folder", "name one with --cache");
  const io::archive::Cache cache(root);
  const io::archive::Retrieval retrieval{
      io::archive::valueOf(options.query.keys, "StudyInstanceUID"),
      io::archive::valueOf(options.query.keys, "SeriesInstanceUID"),
      options.action == Action::Move ? io::archive::Way::Move : io::archive::Way::Get};
  const io::archive::Retrieved got = withServer(options, [&](const auto& server) {
    return io::archive::retrieve(server, retrieval, cache, progressOnTerminal());
  });
  Json series = Json::array();
  std::vector<fs::path> folders;
  for (const io::archive::RetrievedSeries& each : got.series) {
    folders.push_back(each.folder);
    series.push_back({{"series", each.series},
                      {"objects", each.objects},
                      {"received", each.received},
                      {"cache", each.folder.string()}});
  }
  if (!options.output.empty()) io::archive::layOut(folders, options.output);
  Json json{{"source", nameOf(options)}, {"study", retrieval.study}, {"series", std::move(series)}};
  json["folder"] = options.output.empty() ? Json(nullptr) : Json(options.output.string());
  const io::archive::Refusals& refused = got.refusals;
  json["refused"] = {{"connections", refused.connections},
                     {"titles", refused.titles},
                     {"classes", refused.classes},
                     {"objects", refused.objects}};
  return json;
}

using Commitments = std::map<std::string, io::archive::Commitment>;

/// Null where the server says nothing of an object.
Json committed(const Commitments& commitments, const std::string& object) {
  using Verdict = io::archive::Commitment::Verdict;
  const auto at = commitments.find(object);
  if (at == commitments.end() || at->second.verdict == Verdict::Unsaid) return nullptr;
  return at->second.verdict == Verdict::Kept;
}

Json sent(const ArchiveOptions& options, const std::vector<io::archive::Sent>& all, const Commitments& commitments) {
  Json objects = Json::array();
  std::size_t accepted = 0, kept = 0;
  for (const io::archive::Sent& each : all) {
    accepted += each.accepted ? 1 : 0;
    Json object{{"file", each.file.string()}, {"object", each.object}, {"accepted", each.accepted}};
    object["status"] = each.status;
    if (!each.text.empty()) object["text"] = each.text;
    if (options.commits) {
      object["committed"] = committed(commitments, each.object);
      kept += object["committed"] == true ? 1 : 0;
      const auto at = commitments.find(each.object);
      if (at != commitments.end() && !at->second.text.empty()) object["text"] = at->second.text;
    }
    objects.push_back(std::move(object));
  }
  Json json{{"source", nameOf(options)}, {"accepted", accepted}};
  if (options.commits) json["committed"] = kept;
  json["objects"] = std::move(objects);
  return json;
}

/// Says how many of the objects there is something wrong with; true: none.
bool tellMissing(const ArchiveOptions& options, const Json& json, const char* count, const char* what) {
  const std::size_t left = json["objects"].size() - json[count].get<std::size_t>();
  if (left == 0) return true;
  std::cerr << oneLine("fenestra-cli: " + nameOf(options) + ": " + std::to_string(left) + " of " +
                       std::to_string(json["objects"].size()) + " objects " + what +
                       "; standard output says why for each")
            << '\n';
  return false;
}

bool send(const ArchiveOptions& options) {
  const std::vector<fs::path> files = io::archive::filesToSend({options.files.begin(), options.files.end()});
  if (files.empty())
    throw io::Error(options.files.front(), "holds no DICOM objects", "name DICOM files, or folders that hold some");
  const std::vector<io::archive::Sent> all =
      withServer(options, [&](const auto& server) { return io::archive::send(server, files, progressOnTerminal()); });
  Commitments commitments;
  if (options.commits) {
    try {
      commitments = io::archive::commit(options.server, all, progressOnTerminal());
    } catch (...) {  // what was accepted is told in any case
      printJson(sent(options, all, commitments));
      throw;
    }
  }
  const Json json = sent(options, all, commitments);
  printJson(json);
  if (!tellMissing(options, json, "accepted", "were not accepted")) return false;
  return !options.commits || tellMissing(options, json, "committed", "are not confirmed to be kept");
}

}  // namespace

void addArchiveOptions(app::Command command, ArchiveOptions& options) {
  addServer(command, options);
  addKeys(command, options);
  addConversation(command, options);
  addTls(command, options);
  addCommitment(command, options);
  command.group("Options");
  command
      .addValue("-o,--output", options.output,
                "get, move: a new or empty folder for the objects; else the cache's alone")
      .as("FOLDER");
  command.addValue("--cache", options.cache, "where objects are kept, default ~/.cache/fenestra/archive").as("FOLDER");
  command.atLast([&options] { checkAction(options); });
}

bool archive(const ArchiveOptions& options) {
  switch (options.action) {
    case Action::Echo:
      printJson(echoed(options));
      return true;
    case Action::Find:
      printJson(found(options));
      return true;
    case Action::Get:
    case Action::Move:
      printJson(retrieved(options));
      return true;
    case Action::Send:
      break;
  }
  return send(options);
}

}  // namespace fenestra::cli
