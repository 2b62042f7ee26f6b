#pragma once
// Requests to a DICOMweb server by libcurl, with failures as one sentence each. Private to io/archive.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "io/archive/Task.h"
#include "io/archive/WebServer.h"

namespace fenestra::io::archive {

/// A connection that is kept from one request to the next.
class Http {
 public:
  /// Takes bytes of a body; false ends the request.
  using Sink = std::function<bool(std::string_view bytes)>;
  /// Fills at most `size` bytes of a request's body; 0 at its end.
  using Source = std::function<std::size_t(char* bytes, std::size_t size)>;

  struct Answer {
    long status = 0;
    std::string type;  ///< its Content-Type
    std::string body;  ///< where no sink took it
  };

  /// Throws Error where the secret would go over the network in clear.
  Http(const WebServer& server, Task& task);
  ~Http();
  Http(const Http&) = delete;
  Http& operator=(const Http&) = delete;

  /// Bodies in memory are at most Limits::answerBytes long, those of a sink `most`. Throws Error and Cancelled; answers
  /// of HTTP that are failures are answers.
  Answer get(const std::string& path, const std::string& accept);
  Answer get(const std::string& path, const std::string& accept, const std::function<Sink(const Answer&)>& sinkFor,
             std::uint64_t most);
  Answer post(const std::string& path, const std::string& type, const Source& body, std::uint64_t size);

  /// A text as a part of an address.
  std::string escaped(const std::string& text) const;

 private:
  struct Transfer;
  void prepare(const std::string& path, const std::vector<std::string>& headers, Transfer& transfer);
  void run(Transfer& transfer);
  [[noreturn]] void explain(int code, const Transfer& transfer);

  const WebServer& server_;
  Task& task_;
  void* easy_ = nullptr;
  void* multi_ = nullptr;
  void* headers_ = nullptr;
};

/// Throws the Error of an answer that is a failure, such as 401.
[[noreturn]] void refuseStatus(const WebServer& server, long status);

}  // namespace fenestra::io::archive
