#include "io/archive/Descent.h"

#include <utility>

#include "io/archive/Keys.h"

namespace fenestra::io::archive {
namespace {

/// What is at a level below each of `parents`; `identity` is the attribute that names one of the level, or null.
std::vector<Attributes> allAt(Level level, const Query& query, const std::vector<Attributes>& parents,
                              const char* identity, const Ask& ask) {
  Attributes own;
  for (const auto& [keyword, value] : query.keys) {
    const Level of = levelOf(keyword, query.level);
    const bool isPatients = of == Level::Patient && level == Level::Study;  // one level in the study root model
    if (of == level || isPatients) own[keyword] = value;
  }
  const std::string named = identity ? valueOf(own, identity) : std::string();
  const bool isKnown = own.size() == 1 && !named.empty() && named.find_first_of("*?\\") == std::string::npos;
  std::vector<Attributes> found;
  for (const Attributes& parent : parents) {
    if (isKnown) {
      found.push_back(parent);
      found.back().insert(own.begin(), own.end());
      continue;
    }
    Attributes keys = own;
    for (const char* each : {"StudyInstanceUID", "SeriesInstanceUID"})
      if (const std::string uid = valueOf(parent, each); !uid.empty()) keys[each] = uid;
    for (Attributes& record : ask(level, keys)) {
      record.insert(parent.begin(), parent.end());
      found.push_back(std::move(record));
    }
  }
  return found;
}

}  // namespace

std::vector<Attributes> descend(const Query& query, const Ask& ask) {
  std::vector<Attributes> parents{{}};
  if (query.level > Level::Study) parents = allAt(Level::Study, query, parents, "StudyInstanceUID", ask);
  if (query.level > Level::Series) parents = allAt(Level::Series, query, parents, "SeriesInstanceUID", ask);
  return allAt(query.level, query, parents, nullptr, ask);
}

}  // namespace fenestra::io::archive
