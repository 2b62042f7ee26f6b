#pragma once
// The methods that pages and sheets compare, at their defaults.

#include <string>
#include <vector>

#include "rendering/scene/Settings.h"

namespace fenestra::bench {

struct MethodVariant {
  std::string name;     ///< for file names
  std::string caption;  ///< in English
  Method method;
};

/// Every method, and the importance-driven one in both of its ways.
inline std::vector<MethodVariant> methodVariants() {
  std::vector<MethodVariant> list;
  for (const auto& word : wordsOf(MethodKind{})) {
    Method method;
    method.kind = word.value;
    list.push_back({word.word, word.name, method});
    if (word.value != MethodKind::Importance) continue;
    method.importance = ImportanceMode::Average;
    list.push_back({"importance-average", std::string(word.name) + ", average", method});
  }
  return list;
}

}  // namespace fenestra::bench
