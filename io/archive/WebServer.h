#pragma once
// An archive that speaks DICOMweb (PS3.18): where it is, and how we say who we are. Nothing here connects.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "io/archive/Server.h"

namespace fenestra::io::archive {

/// A password or token. It is used for a request, and never printed, written or compared.
class Secret {
 public:
  Secret() = default;
  explicit Secret(std::string text) : text_(std::move(text)) {}
  bool empty() const { return text_.empty(); }
  const std::string& reveal() const { return text_; }

 private:
  std::string text_;
};

/// The server does not let us in with the login that it was given, or wants one.
class LoginRefused : public Error {
 public:
  using Error::Error;
};

struct WebServer {
  std::string url;   ///< of the service's root, without a slash at its end: "https://host/dicom-web"
  std::string user;  ///< of basic authorisation; empty: the secret is a bearer token, if there is one
  Secret secret;
  std::filesystem::path authorities;  ///< certificates in PEM that may sign the server's; empty: those of the system
  Limits limits;

  const std::string& name() const { return url; }  ///< for messages
  bool isEncrypted() const { return url.starts_with("https://"); }
};

/// The server that "http://…" or "https://…" names; empty when the text has another form. An address with a user or a
/// password in it is none.
std::optional<WebServer> parseWebServer(std::string_view text);
/// The secret in the first line of a file, or of the standard input for "-". Throws Error.
Secret readSecret(const std::filesystem::path& file);
[[noreturn]] void refuse(const WebServer& server, const std::string& cause, const std::string& hint);

}  // namespace fenestra::io::archive
