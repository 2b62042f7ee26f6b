#pragma once
// The methods that pages and sheets compare, at their defaults.

#include <functional>
#include <string>
#include <vector>

#include "rendering/settings/Settings.h"

namespace fenestra::bench {

struct MethodVariant {
  std::string name;     ///< for file names
  std::string caption;  ///< in English
  Method method;
  /// Whether it moves the context instead of removing some. What it keeps is then not told along the rays of its
  /// picture (ContextMeasures.h).
  bool moves = false;
};

/// One row a method, the adaptive cutaway first; those that need a user's hand are left out.
inline std::vector<MethodVariant> methodVariants() {
  std::vector<MethodVariant> list;
  const auto add = [&](MethodKind kind, const std::string& way = {}, const std::function<void(Method&)>& change = {}) {
    Method method;
    method.kind = kind;
    if (change) change(method);
    for (const auto& word : wordsOf(kind))
      if (word.value == kind)
        list.push_back({std::string(word.word) + (way.empty() ? "" : "-" + way),
                        std::string(word.name) + (way.empty() ? "" : ", " + way), method});
  };
  add(MethodKind::Adaptive);
  add(MethodKind::Cone);
  add(MethodKind::Importance);
  add(MethodKind::Importance, "average", [](Method& method) { method.importance = ImportanceMode::Average; });
  add(MethodKind::ClearView);
  add(MethodKind::ContextPreserving);
  add(MethodKind::FocalRegion);
  for (const MethodKind kind : {MethodKind::Walls, MethodKind::Explode, MethodKind::Selection, MethodKind::Peel}) {
    add(kind);
    list.back().moves = kind == MethodKind::Explode || kind == MethodKind::Peel;
  }
  return list;
}

}  // namespace fenestra::bench
