#include "io/archive/Multipart.h"

#include <algorithm>

#include "io/base/Text.h"

namespace fenestra::io::archive {
namespace {

constexpr std::size_t mostBoundary = 70;  // RFC 2046 5.1.1
constexpr std::size_t mostHeaders = 16384, mostPreamble = 65536;

}  // namespace

std::optional<std::string> boundaryIn(std::string_view contentType) {
  if (!lowered(std::string(contentType)).starts_with("multipart/related")) return std::nullopt;
  for (const std::string& part : split(contentType, ';')) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos || lowered(trimmed(part.substr(0, equals))) != "boundary") continue;
    std::string boundary = trimmed(part.substr(equals + 1));
    if (boundary.size() >= 2 && boundary.front() == '"' && boundary.back() == '"')
      boundary = boundary.substr(1, boundary.size() - 2);
    if (!boundary.empty() && boundary.size() <= mostBoundary) return boundary;
  }
  return std::nullopt;
}

bool Multipart::push(std::string_view bytes) {
  pending_ += bytes;
  while (state_ != State::Done && state_ != State::Failed && step()) {
  }
  return state_ != State::Failed;
}

/// False where more bytes are needed.
bool Multipart::step() {
  switch (state_) {
    case State::Preamble:
      return skipPreamble();
    case State::AfterDelimiter:
      return readDelimiter();
    case State::Headers:
      return skipHeaders();
    case State::Body:
      return readBody();
    default:
      return false;
  }
}

bool Multipart::skipPreamble() {
  const std::size_t at = pending_.find(delimiter_);
  if (at == std::string::npos) {
    if (pending_.size() > mostPreamble) state_ = State::Failed;
    return false;
  }
  pending_.erase(0, at + delimiter_.size());
  state_ = State::AfterDelimiter;
  return true;
}

bool Multipart::readDelimiter() {
  if (pending_.size() < 2) return false;
  if (pending_.starts_with("--")) {
    state_ = State::Done;
    return false;
  }
  const std::size_t line = pending_.find("\r\n");
  if (line == std::string::npos) {
    if (pending_.size() > mostHeaders) state_ = State::Failed;
    return false;
  }
  pending_.erase(0, line);  // blanks may follow a delimiter; the line's end may also be that of no headers
  state_ = State::Headers;
  return true;
}

bool Multipart::skipHeaders() {
  const std::size_t end = pending_.find("\r\n\r\n");
  if (end == std::string::npos) {
    if (pending_.size() > mostHeaders) state_ = State::Failed;
    return false;
  }
  pending_.erase(0, end + 4);
  handler_.begin();
  state_ = State::Body;
  return true;
}

bool Multipart::readBody() {
  const std::size_t at = pending_.find(delimiter_);
  if (at == std::string::npos) {
    // The last bytes may be the start of the delimiter.
    const std::size_t kept = std::min(pending_.size(), delimiter_.size() - 1);
    const std::size_t count = pending_.size() - kept;
    if (count > 0) handler_.add(std::string_view(pending_).substr(0, count));
    pending_.erase(0, count);
    return false;
  }
  handler_.add(std::string_view(pending_).substr(0, at));
  handler_.end();
  pending_.erase(0, at + delimiter_.size());
  state_ = State::AfterDelimiter;
  return true;
}

}  // namespace fenestra::io::archive
