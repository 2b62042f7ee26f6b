#pragma once
// What a run changed, by attribute.

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "io/deidentify/Profile.h"

namespace fenestra::io::deidentify {

struct Change {
  std::string keyword;  ///< "private" and "unknown" where the standard has none
  std::size_t count = 0;
  std::set<std::string> values;  ///< some that were there; only where they are asked for
};

class Changes {
 public:
  static constexpr std::size_t mostValues = 20, longestValue = 64;  ///< of an attribute; bytes of each

  /// With `values`, what was there is kept, too: it names patients.
  explicit Changes(bool values) : values_(values) {}

  bool keepsValues() const { return values_; }
  void add(std::uint32_t tag, Action action, const std::string& keyword, const std::string& value);
  /// By tag (group · 65536 + element) and what was done; an attribute may be treated differently in other places.
  const std::map<std::pair<std::uint32_t, Action>, Change>& all() const { return all_; }

 private:
  bool values_;
  std::map<std::pair<std::uint32_t, Action>, Change> all_;
};

}  // namespace fenestra::io::deidentify
