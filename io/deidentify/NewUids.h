#pragma once
// New UIDs in place of those of an object, the same for the same everywhere in a run.

#include <array>
#include <map>
#include <string>
#include <string_view>

namespace fenestra::io::deidentify {

/// A new UID is a keyed hash (HMAC-SHA-256) of the old one under "2.25" (PS3.5 B.2). The key is random and lives no
/// longer than this object, so that nobody can find the old UID by trying those that he knows.
class NewUids {
 public:
  /// Throws std::runtime_error where the system has no random numbers.
  NewUids();
  ~NewUids();
  NewUids(const NewUids&) = delete;
  NewUids& operator=(const NewUids&) = delete;

  /// What to write in place of `uid`; UIDs of the standard's own (1.2.840.10008) stay, and so does an empty text.
  std::string of(std::string_view uid);
  /// A number in place of a patient's, of twelve letters: objects of one patient stay together, and those of two apart.
  std::string patientFor(std::string_view id);
  /// All that were asked for, by the old one.
  const std::map<std::string, std::string, std::less<>>& all() const { return given_; }

 private:
  using Hash = std::array<unsigned char, 64>;  // as large as OpenSSL's largest
  Hash hashOf(std::string_view text) const;

  std::array<unsigned char, 32> key_{};
  std::map<std::string, std::string, std::less<>> given_;
};

}  // namespace fenestra::io::deidentify
