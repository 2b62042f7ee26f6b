#include "io/archive/Wanted.h"

namespace fenestra::io::archive {

std::vector<Wanted> wantedIn(const std::vector<Attributes>& images, const std::string& study) {
  std::map<std::string, Wanted> bySeries;
  for (const Attributes& record : images) {
    const std::string object = valueOf(record, "SOPInstanceUID"), series = valueOf(record, "SeriesInstanceUID");
    if (object.empty() || series.empty()) continue;
    Wanted& wanted = bySeries[series];
    wanted.study = study;
    wanted.series = series;
    wanted.objects[object] = valueOf(record, "SOPClassUID");
  }
  std::vector<Wanted> all;
  for (auto& [uid, wanted] : bySeries) all.push_back(std::move(wanted));
  return all;
}

Wanted missingOf(const Wanted& wanted, const Cache& cache) {
  const std::set<std::string> held = cache.held(wanted.study, wanted.series);
  Wanted missing{wanted.study, wanted.series, {}};
  for (const auto& object : wanted.objects)
    if (!held.contains(cacheName(object.first))) missing.objects.insert(object);
  return missing;
}

void makeRoom(const std::vector<Wanted>& all, const Cache& cache, const Limits& limits) {
  std::set<std::filesystem::path> kept;
  for (const Wanted& each : all) {
    kept.insert(cache.folderOf(each.study, each.series));
    kept.insert(cache.partOf(each.study, each.series));
  }
  cache.trim(limits.cacheBytes, kept);
}

}  // namespace fenestra::io::archive
