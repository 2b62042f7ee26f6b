#include "tests/archive/Servers.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>

#include <nlohmann/json.hpp>

namespace fenestra::tests {
namespace fs = std::filesystem;
namespace {

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  return address;
}

/// A socket that is bound to `port`, which becomes the one chosen where it is 0.
int boundSocket(int& port) {
  const int made = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const int on = 1;
  setsockopt(made, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address = loopback(port);
  socklen_t size = sizeof address;
  EXPECT_EQ(bind(made, reinterpret_cast<sockaddr*>(&address), size), 0);
  getsockname(made, reinterpret_cast<sockaddr*>(&address), &size);
  port = ntohs(address.sin_port);
  return made;
}

bool answers(int port) {
  const int made = connectTo(port);
  if (made >= 0) close(made);
  return made >= 0;
}

std::unique_ptr<RunningServer> started(std::unique_ptr<RunningServer> running, const std::vector<std::string>& words,
                                       const fs::path& folder) {
  running->program = std::make_unique<Program>(words, folder / "log");
  const int web =
      running->web.empty() ? running->server.port : std::stoi(running->web.substr(running->web.rfind(':') + 1));
  const bool up =
      eventually([&] { return (answers(running->server.port) && answers(web)) || !running->program->isRunning(); });
  return up && running->program->isRunning() ? std::move(running) : nullptr;
}

}  // namespace

int freePort() {
  // Below the ports that the system gives to outgoing connections, one of which could take it meanwhile.
  static std::mt19937 engine(static_cast<unsigned>(getpid()));
  for (;;) {
    int port = std::uniform_int_distribution(12'000, 31'999)(engine);
    const int made = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = loopback(port);
    const bool isFree = bind(made, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    close(made);
    if (isFree) return port;
  }
}

int listeningSocket(int& port) {
  const int made = boundSocket(port);
  ::listen(made, 8);
  return made;
}

int connectTo(int port) {
  const int made = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const sockaddr_in address = loopback(port);
  if (connect(made, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return made;
  close(made);
  return -1;
}

bool isThere(const std::string& program) {
  for (const char* folder : {"/usr/bin", "/usr/sbin", "/usr/local/bin"})
    if (fs::exists(fs::path(folder) / program)) return true;
  return false;
}

bool eventually(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (std::chrono::steady_clock::now() < end) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

Program::Program(const std::vector<std::string>& words, const fs::path& output) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const std::string log = output.string();
  pid_ = fork();
  if (pid_ != 0) return;
  setpgid(0, 0);
  const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), in = open("/dev/null", O_RDONLY);
  dup2(in, 0);
  dup2(out, 1);
  dup2(out, 2);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

void Program::kill() {
  if (pid_ <= 0) return;
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);  // its group may not be made yet
  waitpid(pid_, nullptr, 0);
  pid_ = -1;
}

bool Program::isRunning() {
  if (pid_ > 0 && waitpid(pid_, nullptr, WNOHANG) != 0) pid_ = -1;
  return pid_ > 0;
}

std::unique_ptr<RunningServer> startDcmqrscp(const fs::path& folder) {
  auto running = std::make_unique<RunningServer>();
  io::archive::Server& server = running->server;
  server.host = "127.0.0.1";
  server.port = freePort();
  server.title = "DCMQRSCP";
  server.ownPort = freePort();
  fs::create_directories(folder / "store");
  std::ofstream(folder / "config")
      << "NetworkTCPPort = " << server.port
      << "\nMaxPDUSize = 16384\nMaxAssociations = 16\nHostTable BEGIN\nus = (FENESTRA, 127.0.0.1, " << server.ownPort
      << ")\nHostTable END\nVendorTable BEGIN\nVendorTable END\nAETable BEGIN\nDCMQRSCP " << (folder / "store").string()
      << " RW (200, 1024mb) ANY\nAETable END\n";
  return started(std::move(running), {"dcmqrscp", "-c", (folder / "config").string(), std::to_string(server.port)},
                 folder);
}

Certificate makeCertificate(const fs::path& folder, const std::string& name) {
  const Certificate made{folder / (name + ".pem"), folder / (name + ".key")};
  const std::string command = "openssl req -x509 -newkey rsa:2048 -nodes -days 2 -subj /CN=" + name +
                              " -addext 'subjectAltName=IP:127.0.0.1' -keyout '" + made.key.string() + "' -out '" +
                              made.certificate.string() + "' 2>/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  return made;
}

std::unique_ptr<RunningServer> startOrthanc(const fs::path& folder, const Certificate& own, const Certificate& client) {
  auto running = std::make_unique<RunningServer>();
  io::archive::Server& server = running->server;
  server.host = "127.0.0.1";
  server.port = freePort();
  server.title = "ORTHANC";
  server.ownPort = freePort();
  const int web = freePort();
  running->web = "http://127.0.0.1:" + std::to_string(web) + "/dicom-web";
  nlohmann::json config{{"Name", "test"},
                        {"StorageDirectory", (folder / "store").string()},
                        {"IndexDirectory", (folder / "store").string()},
                        {"DicomAet", server.title},
                        {"DefaultEncoding", "Utf8"},  // of its answers; it drops what another set lacks
                        {"DicomPort", server.port},
                        {"DicomCheckCalledAet", true},
                        {"DicomCheckModalityHost", false},
                        {"DicomAlwaysAllowGet", true},
                        {"DicomAlwaysAllowFind", true},
                        {"DicomAlwaysAllowMove", true},
                        {"DicomModalities", {{"us", {"FENESTRA", "127.0.0.1", server.ownPort}}}},
                        {"HttpPort", web},
                        {"RemoteAccessAllowed", false},
                        {"AuthenticationEnabled", true},
                        {"RegisteredUsers", {{"reader", "secret word"}}},
                        {"Plugins", {"/usr/share/orthanc/plugins"}},
                        {"DicomWeb", {{"Enable", true}, {"Root", "/dicom-web/"}}}};
  if (!own.key.empty()) {
    server.tls = io::archive::TlsFiles{own.certificate, client.certificate, client.key};
    config.update({{"DicomTlsEnabled", true},
                   {"DicomTlsCertificate", own.certificate.string()},
                   {"DicomTlsPrivateKey", own.key.string()},
                   {"DicomTlsTrustedCertificates", client.certificate.string()}});
    config["DicomModalities"]["us"] = {
        {"AET", "FENESTRA"}, {"Host", "127.0.0.1"}, {"Port", server.ownPort}, {"UseDicomTls", true}};
  }
  fs::create_directories(folder);
  std::ofstream(folder / "config.json") << config;
  return started(std::move(running), {"Orthanc", (folder / "config.json").string()}, folder);
}

Answering::Answering(AnswerTo answerTo) : answerTo_(std::move(answerTo)), socket_(listeningSocket(port_)) {
  thread_ = std::thread([this] {
    while (!stops_) {
      pollfd waited{socket_, POLLIN, 0};
      if (poll(&waited, 1, 10) <= 0) continue;
      const int client = accept(socket_, nullptr, nullptr);
      std::string request(4096, '\0');
      const ssize_t got = recv(client, request.data(), request.size(), 0);
      if (got > 0) {
        request.resize(static_cast<std::size_t>(got));
        const std::string answer = answerTo_(request);
        send(client, answer.data(), answer.size(), MSG_NOSIGNAL);
      }
      shutdown(client, SHUT_WR);
      close(client);
    }
  });
}

Answering::~Answering() {
  stops_ = true;
  thread_.join();
  close(socket_);
}

io::archive::WebServer Answering::server() const {
  return io::archive::parseWebServer("http://127.0.0.1:" + std::to_string(port_) + "/dicom-web").value();
}

std::string answerOf(const std::string& status, const std::string& type, const std::string& body) {
  return "HTTP/1.1 " + status + "\r\nContent-Type: " + type + "\r\nContent-Length: " + std::to_string(body.size()) +
         "\r\n\r\n" + body;
}

Proxy::Proxy(int serverPort, Fault fault) : serverPort_(serverPort), fault_(fault) {
  listening_ = listeningSocket(port_);
  thread_ = std::thread([this] { run(); });
}

Proxy::~Proxy() {
  stops_ = true;
  thread_.join();
  for (std::thread& each : threads_) each.join();
  close(listening_);
}

void Proxy::run() {
  while (!stops_) {
    pollfd waited{listening_, POLLIN, 0};
    if (poll(&waited, 1, 10) <= 0) continue;
    const int client = accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
    if (client >= 0) threads_.emplace_back([this, client] { pass(client); });
  }
}

bool Proxy::passSlowly(int client, std::string_view bytes, std::size_t step) const {
  while (!bytes.empty() && !stops_) {
    const std::string_view piece = bytes.substr(0, step);
    if (send(client, piece.data(), piece.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(piece.size())) return false;
    bytes.remove_prefix(piece.size());
    if (fault_.slow > 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

void Proxy::pass(int client) {
  const int server = connectTo(serverPort_);
  std::array<char, 4096> bytes;
  std::size_t passed = 0;
  bool isStalled = false;
  while (!stops_ && server >= 0) {
    pollfd waited[]{{client, POLLIN, 0}, {isStalled ? -1 : server, POLLIN, 0}};
    if (poll(waited, 2, 10) <= 0) continue;
    const bool fromServer = waited[1].revents != 0;
    const ssize_t got = recv(fromServer ? server : client, bytes.data(), bytes.size(), 0);
    if (got <= 0) break;
    if (!fromServer) {
      if (send(server, bytes.data(), static_cast<std::size_t>(got), MSG_NOSIGNAL) != got) break;
      continue;
    }
    if (fault_.slow > 0 || (fault_.doubles && passed >= fault_.after)) {
      const std::size_t step = fault_.slow > 0 ? fault_.slow : static_cast<std::size_t>(got);
      if (!passSlowly(client, {bytes.data(), static_cast<std::size_t>(got)}, step)) break;
      if (fault_.doubles && !passSlowly(client, {bytes.data(), static_cast<std::size_t>(got)}, step)) break;
      continue;
    }
    const std::size_t count = std::min(static_cast<std::size_t>(got), fault_.after - passed);
    if (count > 0 && send(client, bytes.data(), count, MSG_NOSIGNAL) != static_cast<ssize_t>(count)) break;
    passed += count;
    if (passed < fault_.after || fault_.doubles) continue;
    if (!fault_.stalls) break;
    isStalled = true;
  }
  if (server >= 0) close(server);
  close(client);
}

}  // namespace fenestra::tests
