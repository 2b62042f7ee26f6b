#pragma once
// The methods that pages and sheets compare, at their defaults.

#include <concepts>
#include <string>
#include <vector>

#include "rendering/methods/Method.h"

namespace fenestra::bench {

struct MethodVariant {
  std::string name;     ///< for file names
  std::string caption;  ///< in English
  Method method;
  /// Whether it moves the context instead of removing some, or shows one of its values a ray. What it keeps is then not
  /// told along the rays of its picture (ContextMeasures.h).
  bool moves = false;
};

/// One row a method, the adaptive cutaway first; those that need a user's hand are left out.
inline std::vector<MethodVariant> methodVariants() {
  std::vector<MethodVariant> list;
  const auto add = [&]<class M>(const M& parameters, const std::string& way = {}) {
    const MethodStages stages = parameters.stages();
    list.push_back({.name = M::word + (way.empty() ? "" : "-" + way),
                    .caption = M::name + (way.empty() ? "" : ", " + way),
                    .method = parameters,
                    .moves = stages.explosion || stages.peel || stages.maximum});
  };
  forEachMethod([&]<class M>() {
    if (!carves(kindOf<M>)) add(M{});
    if constexpr (std::same_as<M, methods::Importance>)
      add(methods::Importance{.mode = ImportanceMode::Average}, "average");
  });
  return list;
}

}  // namespace fenestra::bench
