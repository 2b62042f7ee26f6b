#include "io/study/LabelNames.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <optional>

#include "io/base/Error.h"
#include "io/base/Text.h"

namespace fenestra::io {
namespace {

/// Number of insertions, deletions and replacements that turn a into b (Levenshtein).
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string described(const Label& label) { return std::to_string(label.value) + " " + label.name; }

/// The labels most like `wanted`: by name, or by value when it is a number.
std::string nearestLabels(const LabelMap& labels, const std::string& wanted) {
  const std::optional<long> number = numberIn<long>(wanted);
  const auto distance = [&](const Label& label) -> std::size_t {
    if (number) return static_cast<std::size_t>(std::abs(*number - static_cast<long>(label.value)));
    const std::string name = lowered(label.name), part = lowered(wanted);
    return name.find(part) != std::string::npos ? 0 : editDistance(name, part);
  };
  std::vector<const Label*> order;
  for (const Label& label : labels.labels) order.push_back(&label);
  std::stable_sort(order.begin(), order.end(), [&](auto* a, auto* b) { return distance(*a) < distance(*b); });
  std::string text;
  constexpr std::size_t shown = 3;
  for (std::size_t i = 0; i < std::min(shown, order.size()); ++i) text += (i ? ", " : "") + described(*order[i]);
  return text;
}

}  // namespace

std::vector<std::uint16_t> resolveLabels(const LabelMap& labels, const std::vector<std::string>& wanted,
                                         const std::filesystem::path& file) {
  std::vector<std::uint16_t> values;
  for (const std::string& text : wanted) {
    const std::string name = lowered(text);
    const std::optional<std::uint16_t> number = numberIn<std::uint16_t>(text);
    const auto at = std::find_if(labels.labels.begin(), labels.labels.end(), [&](const Label& label) {
      return number ? label.value == *number : lowered(label.name) == name;
    });
    if (at == labels.labels.end()) {
      const std::string nearest = nearestLabels(labels, text);
      throw Error(file, "there is no label \"" + text + "\"",
                  nearest.empty() ? "the label map is empty" : "the nearest are " + nearest);
    }
    values.push_back(at->value);
  }
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

}  // namespace fenestra::io
