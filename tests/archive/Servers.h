#pragma once
// Archive servers that a test starts on the loopback interface, on ports that are free, and that end with it.

#include <sys/types.h>
#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "io/archive/Server.h"
#include "io/archive/WebServer.h"

namespace fenestra::tests {

/// A port of 127.0.0.1 that nothing listens on.
int freePort();
/// Whether Debian's packages brought a program.
bool isThere(const std::string& program);
/// Waits until `holds`; false after half a minute.
bool eventually(const std::function<bool()>& holds);

/// A program in a process group of its own, whose output goes to a file.
class Program {
 public:
  Program(const std::vector<std::string>& words, const std::filesystem::path& output);
  ~Program() { kill(); }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// At once, with all that it started.
  void kill();
  bool isRunning();

 private:
  pid_t pid_ = -1;
};

/// A server with what it takes to reach it.
struct RunningServer {
  io::archive::Server server;  ///< its ownPort is where it sends to
  std::string web;             ///< the address of its DICOMweb; empty: none
  std::unique_ptr<Program> program;
};

/// DCMTK's server, its AE title "DCMQRSCP"; null after a failed start.
std::unique_ptr<RunningServer> startDcmqrscp(const std::filesystem::path& folder);
/// Files of TLS for a server, signed by themselves.
struct Certificate {
  std::filesystem::path certificate, key;
};
/// Made by openssl, below `folder`.
Certificate makeCertificate(const std::filesystem::path& folder, const std::string& name);

/// Orthanc with DICOMweb, its AE title "ORTHANC"; null after a failed start. With a certificate it takes TLS alone, and
/// from those alone whose certificate is `client`.
std::unique_ptr<RunningServer> startOrthanc(const std::filesystem::path& folder, const Certificate& own = {},
                                            const Certificate& client = {});

/// Passes bytes between one client at a time and a server, with a fault.
class Proxy {
 public:
  struct Fault {
    std::size_t after = 0;  ///< bytes of the server that pass
    bool stalls = false;    ///< then nothing passes; otherwise the connection is cut
    bool doubles = false;   ///< then all passes twice, in place of a cut
    std::size_t slow = 0;   ///< all passes, so many bytes of the server every 5 ms; 0: as it comes
  };
  Proxy(int serverPort, Fault fault);
  ~Proxy();
  int port() const { return port_; }

 private:
  void run();
  void pass(int client);
  bool passSlowly(int client, std::string_view bytes, std::size_t step) const;

  int serverPort_, port_ = 0, listening_ = -1;
  Fault fault_;
  std::atomic<bool> stops_ = false;
  std::vector<std::thread> threads_;
  std::thread thread_;
};

/// A web server that answers each request by a function of it, and closes the connection.
class Answering {
 public:
  using AnswerTo = std::function<std::string(const std::string& request)>;
  explicit Answering(AnswerTo answerTo);
  ~Answering();
  io::archive::WebServer server() const;

 private:
  AnswerTo answerTo_;
  int port_ = 0, socket_ = -1;
  std::atomic<bool> stops_ = false;
  std::thread thread_;
};
/// The bytes of an answer of HTTP.
std::string answerOf(const std::string& status, const std::string& type, const std::string& body);

/// A socket that listens on a free port of 127.0.0.1, which `port` becomes.
int listeningSocket(int& port);
/// A connection to a port of 127.0.0.1; -1 when there is none.
int connectTo(int port);

}  // namespace fenestra::tests

/// Skips the test where a program is missing, with the package that holds it.
#define FENESTRA_PROGRAM_OR_SKIP(program, package) \
  if (!::fenestra::tests::isThere(program))        \
  GTEST_SKIP() << "needs " << (program) << " of Debian's package " << (package)
