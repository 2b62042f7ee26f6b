#include "io/archive/Wanted.h"

#include <algorithm>
#include <charconv>
#include <deque>

namespace fenestra::io::archive {

namespace {

/// 0 where the attribute holds no whole number that fits.
int wholeNumberOf(const Attributes& record, const std::string& keyword) {
  const std::string text = valueOf(record, keyword);
  int count = 0;
  const bool isNumber = std::from_chars(text.data(), text.data() + text.size(), count).ec == std::errc();
  return isNumber ? std::max(count, 0) : 0;
}

Frames framesOf(const Attributes& record) {
  Frames frames{wholeNumberOf(record, "NumberOfFrames"), 0};
  constexpr int mostSide = 65535, mostBits = 64;
  const int rows = wholeNumberOf(record, "Rows"), columns = wholeNumberOf(record, "Columns"),
            bits = wholeNumberOf(record, "BitsAllocated");
  if (rows <= mostSide && columns <= mostSide && bits <= mostBits)
    frames.bytes = static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(columns) *
                   static_cast<std::uint64_t>(bits) / 8 * static_cast<std::uint64_t>(frames.count);
  return frames;
}

}  // namespace

std::vector<Wanted> wantedIn(const std::vector<Attributes>& images, const std::string& study) {
  std::map<std::string, Wanted> bySeries;
  for (const Attributes& record : images) {
    const std::string object = valueOf(record, "SOPInstanceUID"), series = valueOf(record, "SeriesInstanceUID");
    if (object.empty() || series.empty()) continue;
    Wanted& wanted = bySeries[series];
    wanted.study = study;
    wanted.series = series;
    wanted.objects[object] = valueOf(record, "SOPClassUID");
    const std::string text = valueOf(record, "InstanceNumber");
    int number = 0;
    if (std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc())
      wanted.numbers[object] = number;
    if (const Frames frames = framesOf(record); frames.count > 1) wanted.frames[object] = frames;
  }
  std::vector<Wanted> all;
  for (auto& [uid, wanted] : bySeries) all.push_back(std::move(wanted));
  return all;
}

Wanted missingOf(const Wanted& wanted, const Cache& cache) {
  const std::set<std::string> held = cache.held(wanted.study, wanted.series);
  Wanted missing{wanted.study, wanted.series, {}, wanted.numbers};
  for (const auto& object : wanted.objects)
    if (!held.contains(cacheName(object.first))) missing.objects.insert(object);
  return missing;
}

std::vector<std::string> middleFirst(const Wanted& wanted) {
  std::vector<std::pair<int, std::string>> byNumber;
  for (const auto& [object, objectClass] : wanted.objects) {
    const auto at = wanted.numbers.find(object);
    byNumber.emplace_back(at == wanted.numbers.end() ? 0 : at->second, object);
  }
  std::sort(byNumber.begin(), byNumber.end());
  std::vector<std::string> order;
  std::deque<std::pair<std::size_t, std::size_t>> gaps{{0, byNumber.size()}};  // from, and behind the last
  for (; !gaps.empty(); gaps.pop_front()) {
    const auto [from, end] = gaps.front();
    if (from == end) continue;
    const std::size_t middle = from + (end - from) / 2;
    order.push_back(byNumber[middle].second);
    gaps.emplace_back(from, middle);
    gaps.emplace_back(middle + 1, end);
  }
  return order;
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
