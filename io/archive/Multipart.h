#pragma once
// The parts of a message of type multipart/related (RFC 2046 5.1, RFC 2387), as its bytes come. A part is handed on in
// pieces, so that none is in memory as a whole. Private to io/archive.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace fenestra::io::archive {

/// The boundary that a Content-Type names; empty when it is no multipart type.
std::optional<std::string> boundaryIn(std::string_view contentType);

class Multipart {
 public:
  struct Handler {
    std::function<void()> begin;
    std::function<void(std::string_view bytes)> add;
    std::function<void()> end;  ///< of a part that came whole
  };

  Multipart(const std::string& boundary, Handler handler)
      : delimiter_("\r\n--" + boundary), handler_(std::move(handler)) {}

  /// False when the bytes are not of that form; nothing more is to come then.
  bool push(std::string_view bytes);
  /// Whether the last delimiter came.
  bool isComplete() const { return state_ == State::Done; }

 private:
  enum class State : std::uint8_t { Preamble, AfterDelimiter, Headers, Body, Done, Failed };

  bool step();
  bool skipPreamble();
  bool readDelimiter();
  bool skipHeaders();
  bool readBody();

  std::string delimiter_;
  Handler handler_;
  std::string pending_ = "\r\n";  ///< the first delimiter may begin the message, without a line before it
  State state_ = State::Preamble;
};

}  // namespace fenestra::io::archive
