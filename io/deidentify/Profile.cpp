#include "io/deidentify/Profile.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <string_view>
#include <vector>

#include "fenestra/resources.h"
#include "io/base/Text.h"

namespace fenestra::io::deidentify {
namespace {

/// "0010,0020", or "60xx,3000".
void readTag(std::string_view text, Row& row) {
  for (const char c : text) {
    if (c == ',') continue;
    const bool any = c == 'x';
    std::uint32_t digit = 0;
    if (!any) std::from_chars(&c, &c + 1, digit, 16);
    row.tag = row.tag << 4 | digit;
    row.mask = row.mask << 4 | (any ? 0u : 0xfu);
  }
}

std::vector<Row> readTable() {
  std::vector<Row> table;
  for (const std::string& line : split(resources::find("deidentify/profile.tsv"), '\n')) {
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string> fields = split(line, '\t');
    assert(fields.size() == 4 && "a damaged resource");
    Row row;
    readTag(fields[0], row);
    row.actions = fields[1];
    const auto has = [&](std::string_view option) { return fields[2].find(option) != std::string::npos; };
    row.dates = has("dates");
    row.uids = has("uids");
    row.descriptors = has("descriptors");
    row.graphics = has("graphics");
    row.keyword = fields[3];
    table.push_back(std::move(row));
  }
  std::sort(table.begin(), table.end(), [](const Row& a, const Row& b) { return a.tag < b.tag; });
  return table;
}

const std::vector<Row>& table() {
  static const std::vector<Row> rows = readTable();
  return rows;
}

}  // namespace

const char* wordOf(Action action) {
  switch (action) {
    case Action::Keep:
      return "keep";
    case Action::Remove:
      return "remove";
    case Action::Empty:
      return "empty";
    case Action::Dummy:
      return "dummy";
    case Action::NewUid:
      return "new uid";
    case Action::Clean:
      return "clean";
  }
  return "";
}

std::span<const Row> rows() { return table(); }

const Row* rowOf(std::uint16_t group, std::uint16_t element) {
  const std::uint32_t tag = std::uint32_t{group} << 16 | element;
  const auto at = std::lower_bound(table().begin(), table().end(), tag,
                                   [](const Row& row, std::uint32_t t) { return row.tag < t; });
  if (at != table().end() && at->tag == tag) return &*at;
  // Groups that repeat are even: an odd one is private.
  if (group % 2 != 0) return nullptr;
  for (const Row& row : table())
    if (row.mask != ~std::uint32_t{0} && (tag & row.mask) == row.tag) return &row;
  return nullptr;
}

Action basicAction(const Row& row) {
  const std::size_t slash = row.actions.rfind('/');
  switch (row.actions[slash == std::string::npos ? 0 : slash + 1]) {
    case 'X':
      return Action::Remove;
    case 'Z':
      return Action::Empty;
    case 'U':
      return Action::NewUid;
    default:
      return Action::Dummy;
  }
}

Action actionOf(const Row& row, const Options& options) {
  if ((row.dates && options.retainDates) || (row.uids && options.retainUids)) return Action::Keep;
  if ((row.descriptors && options.cleanDescriptors) || (row.graphics && options.cleanGraphics)) return Action::Clean;
  return basicAction(row);
}

}  // namespace fenestra::io::deidentify
