#pragma once
// An archive server as a user describes it: where it is, who we are to it, and what bounds a conversation with it.
// Nothing here connects.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "io/base/Error.h"

namespace fenestra::io::archive {

/// Files of TLS, in PEM.
struct TlsFiles {
  std::filesystem::path authorities;  ///< certificates that may sign the server's, or the server's own; needed
  std::filesystem::path certificate;  ///< ours, where the server asks for one; empty: none
  std::filesystem::path key;          ///< of our certificate
};

/// What keeps a server, or whoever else connects, from filling memory or disk, or from holding us up. No limit bounds
/// the time of a whole transfer.
struct Limits {
  std::chrono::milliseconds connect{10'000};    ///< until the server's machine answers
  std::chrono::milliseconds silence{60'000};    ///< in which not one byte comes or goes
  std::chrono::milliseconds frameAhead{3'000};  ///< that an object must still take for one of its frames to be fetched
  std::uint64_t objectBytes = 8ull << 30;       ///< of one object
  std::uint64_t freeDiskBytes = 1ull << 30;     ///< that stay free where objects are written
  std::uint64_t cacheBytes = 50ull << 30;       ///< of all objects kept
  std::size_t answers = 100'000;                ///< of one query
  std::size_t answerBytes = 64u << 20;          ///< of one answer, or one page of answers
  std::size_t associations = 4;                 ///< at a time, with our provider
  std::size_t waitingConnections = 16;          ///< that have not yet said who they are
  std::chrono::milliseconds introduction{10'000};  ///< in which a connection must say who it is
  std::chrono::milliseconds commitment{300'000};   ///< until a server says whether it keeps what it was sent
};

/// A DICOM application entity (PS3.8).
struct Server {
  std::string host;
  int port = 104;
  std::string title;                  ///< its AE title, the called one
  std::string ownTitle = "FENESTRA";  ///< ours, the calling one, and where C-MOVE sends to
  /// Address and port of ours that C-MOVE's objects and storage commitments are received on. Port 0: none is set, so
  /// that C-MOVE is impossible, and a commitment must come over our own connection.
  std::string interface = "127.0.0.1";
  int ownPort = 0;
  std::optional<TlsFiles> tls;
  /// Specific Character Set (PS3.3 C.12.1.1.2) of queries that ASCII cannot say; empty: UTF-8, and where it finds
  /// nothing the sets of single bytes that can say it, because some servers compare bytes.
  std::string characterSet;
  Limits limits;

  /// For messages: "dicom://TITLE@HOST:PORT".
  std::string name() const;
};

/// Whether `title` is an AE title: 1 to 16 characters of ASCII, no control character or backslash (PS3.5 6.2).
bool isTitle(std::string_view title);

/// The server that "dicom://TITLE@HOST:PORT" names; "dicoms://" for TLS. Empty when the text has another form.
std::optional<Server> parseServer(std::string_view text);

/// The Error of a server; `cause` and `hint` as Error has them.
[[noreturn]] void refuse(const Server& server, const std::string& cause, const std::string& hint);

}  // namespace fenestra::io::archive
