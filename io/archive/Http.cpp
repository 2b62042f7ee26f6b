#include "io/archive/Http.h"

#include <arpa/inet.h>
#include <curl/curl.h>
#include <netinet/in.h>

#include <exception>
#include <memory>
#include <mutex>
#include <new>

namespace fenestra::io::archive {
namespace {

/// Whether an address is of this machine, so that what is sent to it does not leave it. A name that only begins like a
/// number of the machine's own, such as 127.example.org, is another's.
bool isLoopback(const std::string& url) {
  std::string host = url.substr(url.find("//") + 2);
  host = host.substr(0, host.find_first_of("/:"));
  in_addr number{};
  constexpr std::uint32_t own = 127;  // RFC 1122 3.2.1.3
  return host == "localhost" || (inet_pton(AF_INET, host.c_str(), &number) == 1 && ntohl(number.s_addr) >> 24 == own);
}

}  // namespace

struct Http::Transfer {
  Task* task = nullptr;
  CURL* easy = nullptr;
  Answer answer;
  std::function<Sink(const Answer&)> sinkFor;
  Sink sink;
  const Source* source = nullptr;
  std::uint64_t mostInMemory = 0;
  bool isTooLarge = false;

  std::exception_ptr thrown;  ///< by what takes and gives bytes: exceptions must not pass through libcurl

  template <class Act>
  std::size_t guarded(const Act& act, std::size_t failed) {
    try {
      return act();
    } catch (...) {
      thrown = std::current_exception();
      return failed;
    }
  }
  static std::size_t receive(char* bytes, std::size_t, std::size_t count, void* self) {
    auto& transfer = *static_cast<Transfer*>(self);
    return transfer.guarded([&] { return transfer.take({bytes, count}) ? count : 0; }, 0);
  }
  static std::size_t give(char* bytes, std::size_t, std::size_t size, void* self) {
    auto& transfer = *static_cast<Transfer*>(self);
    transfer.task->watch().sent();
    return transfer.guarded([&] { return (*transfer.source)(bytes, size); }, CURL_READFUNC_ABORT);
  }

  void readHead() {
    curl_easy_getinfo(easy, CURLINFO_RESPONSE_CODE, &answer.status);
    const char* type = nullptr;
    curl_easy_getinfo(easy, CURLINFO_CONTENT_TYPE, &type);
    answer.type = type ? type : "";
  }
  bool take(std::string_view bytes) {
    if (!task->watch().count(bytes.size())) return false;
    if (answer.status == 0) {
      readHead();
      if (sinkFor && answer.status / 100 == 2) sink = sinkFor(answer);
    }
    if (sink) return sink(bytes);
    isTooLarge = bytes.size() > mostInMemory - answer.body.size();
    if (!isTooLarge) answer.body += bytes;
    return !isTooLarge;
  }
};

Http::Http(const WebServer& server, Task& task) : server_(server), task_(task) {
  if (!server.secret.empty() && !server.isEncrypted() && !isLoopback(server.url))
    refuse(server, "the password or token would go over the network in clear", "name the server by https://");
  static std::once_flag once;
  std::call_once(once, [] { curl_global_init(CURL_GLOBAL_DEFAULT); });
  easy_ = curl_easy_init();
  multi_ = curl_multi_init();
  if (!easy_ || !multi_) throw std::bad_alloc();
}

Http::~Http() {
  curl_easy_cleanup(easy_);
  curl_multi_cleanup(multi_);
  curl_slist_free_all(static_cast<curl_slist*>(headers_));
}

std::string Http::escaped(const std::string& text) const {
  char* const made = curl_easy_escape(easy_, text.c_str(), static_cast<int>(text.size()));
  if (!made) throw std::bad_alloc();
  std::string result = made;
  curl_free(made);
  return result;
}

void Http::prepare(const std::string& path, const std::vector<std::string>& headers, Transfer& transfer) {
  curl_easy_reset(easy_);  // the connection stays
  transfer.task = &task_;
  transfer.easy = easy_;
  transfer.mostInMemory = server_.limits.answerBytes;
  curl_slist_free_all(static_cast<curl_slist*>(headers_));
  curl_slist* list = nullptr;
  for (const std::string& each : headers) list = curl_slist_append(list, each.c_str());
  headers_ = list;
  curl_easy_setopt(easy_, CURLOPT_URL, (server_.url + path).c_str());
  curl_easy_setopt(easy_, CURLOPT_HTTPHEADER, list);
  curl_easy_setopt(easy_, CURLOPT_PROTOCOLS_STR, "http,https");
  // No CURLOPT_FOLLOWLOCATION: a redirection must not carry a secret elsewhere.
  curl_easy_setopt(easy_, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(easy_, CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(server_.limits.connect.count()));
  curl_easy_setopt(easy_, CURLOPT_WRITEFUNCTION, &Transfer::receive);
  curl_easy_setopt(easy_, CURLOPT_WRITEDATA, &transfer);
  if (!server_.authorities.empty()) curl_easy_setopt(easy_, CURLOPT_CAINFO, server_.authorities.c_str());
  if (server_.secret.empty()) return;
  if (server_.user.empty()) {
    curl_easy_setopt(easy_, CURLOPT_HTTPAUTH, CURLAUTH_BEARER);
    curl_easy_setopt(easy_, CURLOPT_XOAUTH2_BEARER, server_.secret.reveal().c_str());
  } else {
    curl_easy_setopt(easy_, CURLOPT_HTTPAUTH, CURLAUTH_BASIC);
    curl_easy_setopt(easy_, CURLOPT_USERNAME, server_.user.c_str());
    curl_easy_setopt(easy_, CURLOPT_PASSWORD, server_.secret.reveal().c_str());
  }
}

void Http::run(Transfer& transfer) {
  task_.activity().note();
  curl_multi_add_handle(multi_, easy_);
  const std::unique_ptr<void, std::function<void(void*)>> removing(
      easy_, [this](void* easy) { curl_multi_remove_handle(multi_, easy); });
  CURLcode code = CURLE_OK;
  for (int running = 1; running > 0;) {
    task_.checkCancelled();
    if (curl_multi_perform(multi_, &running) != CURLM_OK) throw std::bad_alloc();
    int left = 0;
    while (const CURLMsg* message = curl_multi_info_read(multi_, &left))
      if (message->msg == CURLMSG_DONE) code = message->data.result;
    constexpr int step = 50;  // ms; as Watch has it
    if (running > 0) curl_multi_poll(multi_, nullptr, 0, step, nullptr);
    if (running > 0 && task_.activity().idle() > task_.watch().silence())
      refuse(server_, "the server was silent for " + std::to_string(task_.watch().silence().count() / 1000) + " s",
             "try again; what came is kept");
  }
  if (transfer.thrown) std::rethrow_exception(transfer.thrown);
  if (code != CURLE_OK) explain(code, transfer);
  if (transfer.answer.status == 0) transfer.readHead();
}

void Http::explain(int code, const Transfer& transfer) {
  if (transfer.isTooLarge || task_.watch().end() == Watch::End::TooLarge)
    refuse(server_, "the server sends more than an answer may hold", "it may be no DICOMweb server");
  switch (code) {
    case CURLE_COULDNT_RESOLVE_HOST:
      refuse(server_, "there is no such host", "check the host's name, and that the network is connected");
    case CURLE_COULDNT_CONNECT:
      refuse(server_, "nothing listens there", "check host and port, and that the server runs");
    case CURLE_OPERATION_TIMEDOUT:
      refuse(server_, "the host does not answer", "check host and port; a firewall may be between");
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CACERT_BADFILE:
      refuse(server_, "the server's certificate is not trusted",
             "name the authority that signed it, and check that it is for this host");
    case CURLE_SSL_CONNECT_ERROR:
      refuse(server_, "no secure connection can be made", "check the port; a server without TLS is named http://");
    case CURLE_WRITE_ERROR:
      refuse(server_, "the answer is not what was asked for", "check that the address is the root of DICOMweb");
    case CURLE_UNSUPPORTED_PROTOCOL:
    case CURLE_WEIRD_SERVER_REPLY:
    case CURLE_GOT_NOTHING:
      if (transfer.answer.status == 0)
        refuse(server_, "what listens there is no web server",
               "check the port; DICOM's own protocol is named dicom://");
      [[fallthrough]];
    default:
      refuse(server_, std::string("the connection broke: ") + curl_easy_strerror(static_cast<CURLcode>(code)),
             "try again; what came is kept");
  }
}

Http::Answer Http::get(const std::string& path, const std::string& accept) {
  return get(path, accept, {}, server_.limits.answerBytes);
}

Http::Answer Http::get(const std::string& path, const std::string& accept,
                       const std::function<Sink(const Answer&)>& sinkFor, std::uint64_t most) {
  Transfer transfer;
  transfer.sinkFor = sinkFor;
  prepare(path, {"Accept: " + accept}, transfer);
  task_.watch().beginMessage(most);
  run(transfer);
  return std::move(transfer.answer);
}

Http::Answer Http::post(const std::string& path, const std::string& type, const Source& body, std::uint64_t size) {
  Transfer transfer;
  transfer.source = &body;
  // Without "Expect", for which servers that do not know it are waited for.
  prepare(path, {"Accept: application/dicom+json", "Content-Type: " + type, "Expect:"}, transfer);
  curl_easy_setopt(easy_, CURLOPT_POST, 1L);
  curl_easy_setopt(easy_, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(size));
  curl_easy_setopt(easy_, CURLOPT_READFUNCTION, &Transfer::give);
  curl_easy_setopt(easy_, CURLOPT_READDATA, &transfer);
  task_.watch().beginMessage(server_.limits.answerBytes);
  run(transfer);
  return std::move(transfer.answer);
}

void refuseStatus(const WebServer& server, long status) {
  const std::string answer = "the server answers with HTTP " + std::to_string(status);
  if (status == 401 || status == 403)
    throw LoginRefused(server.name(), "the server does not let us in (HTTP " + std::to_string(status) + ")",
                       "give the user and password, or the token, that the server knows");
  if (status == 404)
    refuse(server, "the server has nothing there (HTTP 404)",
           "check that the address is the root of DICOMweb, and that the study is there");
  if (status / 100 == 3)
    refuse(server, "the server sends us elsewhere (HTTP " + std::to_string(status) + ")", "give the new address");
  refuse(server, answer, status / 100 == 5 ? "try again later" : "ask its administrator, or try other keys");
}

}  // namespace fenestra::io::archive
