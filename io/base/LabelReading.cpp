#include "io/base/LabelReading.h"

#include <algorithm>
#include <numeric>

namespace fenestra::io {

void LabelOverlap::add(std::uint16_t label, std::uint64_t voxels) {
  structures_.emplace_back(voxels, label);
  ranked_ = false;
}

std::uint16_t LabelOverlap::keep(std::uint16_t present, std::uint16_t added) {
  if (added == 0 || added == present) return present;
  if (present == 0) return added;
  if (!ranked_) {
    // Larger ones first, so that a higher rank stays.
    std::stable_sort(structures_.begin(), structures_.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t i = 0; i < structures_.size(); ++i) rank_[structures_[i].second] = i + 1;
    ranked_ = true;
  }
  const bool stays = rank_[present] > rank_[added];
  const std::pair pair = stays ? std::pair(present, added) : std::pair(added, present);
  // Neighbouring voxels mostly hide the same.
  if (last_ == hidden_.end() || last_->first != pair) last_ = hidden_.try_emplace(pair, 0).first;
  ++last_->second;
  return pair.first;
}

void LabelOverlap::warn(const std::filesystem::path& file, const std::vector<Label>& labels,
                        std::vector<Warning>& warnings) const {
  if (hidden_.empty()) return;
  const auto nameOf = [&](std::uint16_t value) {
    const auto at =
        std::find_if(labels.begin(), labels.end(), [&](const Label& label) { return label.value == value; });
    return at == labels.end() || at->name.empty() ? "label " + std::to_string(value) : at->name;
  };
  std::vector<std::pair<std::uint64_t, std::pair<std::uint16_t, std::uint16_t>>> pairs;
  std::uint64_t count = 0;
  for (const auto& [pair, voxels] : hidden_) {
    pairs.emplace_back(voxels, pair);
    count += voxels;
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  constexpr std::size_t shown = 3;
  std::string examples;
  for (std::size_t i = 0; i < std::min(shown, pairs.size()); ++i)
    examples += (i ? ", " : "") + nameOf(pairs[i].second.first) + " over " + nameOf(pairs[i].second.second) + " at " +
                std::to_string(pairs[i].first);
  if (pairs.size() > shown) examples += ", and " + std::to_string(pairs.size() - shown) + " other pairs";
  warnings.push_back({Warning::Kind::Other,
                      "labels overlap at " + std::to_string(count) + (count == 1 ? " voxel" : " voxels") +
                          "; the smaller structure's label is kept there (" + examples + ")",
                      {file}});
}

std::uint64_t labelledVoxels(std::span<const std::uint16_t> values) {
  return values.size() - static_cast<std::uint64_t>(std::count(values.begin(), values.end(), std::uint16_t{0}));
}

void warnOfPlacement(const std::filesystem::path& file, std::uint64_t before, std::uint64_t after, bool sameLattice,
                     std::vector<Warning>& warnings) {
  const auto warn = [&](const std::string& text) { warnings.push_back({Warning::Kind::Other, text, {file}}); };
  if (before > 0 && after == 0)
    warn("every label lies outside the volume; is this the volume's label map?");
  else if (!sameLattice)
    warn("the label map was resampled to the volume's grid by nearest label");
  else if (after < before)
    warn(std::to_string(before - after) + " of " + std::to_string(before) + " labelled voxels lie outside the volume");
}

bool isVoxelCentre(const glm::dvec3& index) {
  return glm::all(glm::lessThanEqual(glm::abs(index - glm::round(index)), glm::dvec3(0.05)));
}

}  // namespace fenestra::io
