#include "io/deidentify/Changes.h"

namespace fenestra::io::deidentify {

void Changes::add(std::uint32_t tag, Action action, const std::string& keyword, const std::string& value) {
  Change& change = all_[{tag, action}];
  change.keyword = keyword;
  ++change.count;
  if (values_ && !value.empty() && change.values.size() < mostValues)
    change.values.insert(value.substr(0, longestValue));
}

}  // namespace fenestra::io::deidentify
