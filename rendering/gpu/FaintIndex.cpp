#include "rendering/gpu/FaintIndex.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <span>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

constexpr std::uint8_t differ = 128;
static_assert(FaintLabels::most < differ);

struct Box {
  glm::ivec3 low, high;
};

/// The voxels whose labels have a number.
template <class Values>
std::optional<Box> boxOf(Values values, const Grid& grid, const std::vector<std::uint8_t>& numbers) {
  std::optional<Box> box;
  std::mutex mutex;
  parallelFor(static_cast<std::size_t>(grid.dims.z), 4, [&](std::size_t begin, std::size_t end) {
    std::optional<Box> own;
    for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
      for (int y = 0; y < grid.dims.y; ++y) {
        const auto* row = values.data() + grid.offset({0, y, z});
        const auto isFaint = [&](int x) { return numbers[static_cast<std::uint16_t>(row[x])] != 0; };
        int first = 0, last = grid.dims.x - 1;
        while (first <= last && !isFaint(first)) ++first;
        if (first > last) continue;
        while (!isFaint(last)) --last;
        if (!own) own = Box{{first, y, z}, {last, y, z}};
        *own = {glm::min(own->low, glm::ivec3(first, y, z)), glm::max(own->high, glm::ivec3(last, y, z))};
      }
    if (!own) return;
    const std::scoped_lock lock(mutex);
    box = box ? Box{glm::min(box->low, own->low), glm::max(box->high, own->high)} : *own;
  });
  return box;
}

/// The number of a voxel where labels are drawn alone; `isKept` by label.
template <class Values>
std::uint8_t numberBeside(Values values, const Grid& grid, const std::vector<std::uint8_t>& numbers,
                          const std::vector<bool>& isKept, glm::ivec3 voxel) {
  const auto labelAt = [&](glm::ivec3 at) { return static_cast<std::uint16_t>(values[grid.offset(at)]); };
  if (const std::uint16_t own = labelAt(voxel); isKept[own]) return numbers[own];
  for (int n = 0; n < 27; ++n) {
    const glm::ivec3 beside = voxel + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
    if (grid.contains(beside) && isKept[labelAt(beside)]) return numbers[labelAt(beside)];
  }
  return 0;
}

/// The texels from `origin` on; `numberAt` of a voxel.
template <class NumberAt>
std::vector<std::uint8_t> texelsOf(const NumberAt& numberAt, const Grid& grid, glm::ivec3 origin, glm::ivec3 size) {
  const auto width = static_cast<std::size_t>(size.x), height = static_cast<std::size_t>(size.y);
  std::vector<std::uint8_t> texels(width * height * static_cast<std::size_t>(size.z));
  parallelFor(static_cast<std::size_t>(size.z), 4, [&](std::size_t begin, std::size_t end) {
    // The row of a texel, and the next ones along y and z.
    std::array<std::vector<std::uint8_t>, 4> rows;
    for (std::size_t z = begin; z < end; ++z)
      for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t k = 0; k < 4; ++k) {
          rows[k].resize(width + 1);
          const glm::ivec3 first = origin + glm::ivec3(0, y + k % 2, z + k / 2);
          for (int x = 0; x <= size.x; ++x) {
            const glm::ivec3 voxel = glm::clamp(first + glm::ivec3(x, 0, 0), glm::ivec3(0), grid.dims - 1);
            rows[k][static_cast<std::size_t>(x)] = numberAt(voxel);
          }
        }
        for (std::size_t x = 0; x < width; ++x) {
          const std::uint8_t own = rows[0][x];
          const bool same = std::all_of(rows.begin(), rows.end(),
                                        [&](const auto& row) { return row[x] == own && row[x + 1] == own; });
          texels[x + width * (y + height * z)] = same ? own : static_cast<std::uint8_t>(own | differ);
        }
      }
  });
  return texels;
}

}  // namespace

bool FaintIndex::update(const FaintLabels& faint, const std::shared_ptr<const LabelMap>& labels,
                        const std::vector<std::uint16_t>& kept) {
  FaintLabels listed = faint;
  if (!kept.empty())
    std::erase_if(listed.numbers,
                  [&](const auto& each) { return !std::binary_search(kept.begin(), kept.end(), each.first); });
  const std::shared_ptr<const LabelMap> map = listed.any() ? labels : nullptr;
  if (listed.numbers == numbers_ && map == map_ && kept == kept_) return false;
  const bool had = any();
  texture_ = {};
  numbers_ = listed.numbers;
  kept_ = kept;
  map_ = map;
  if (!map) return had;
  const std::vector<std::uint8_t> numbers = listed.numberOfLabel();
  std::vector<bool> isKept(numbers.size(), false);
  for (const std::uint16_t label : kept) isKept[label] = true;
  map->voxels.visit([&](auto values) {
    if constexpr (std::is_unsigned_v<typename decltype(values)::value_type>) {
      const std::optional<Box> box = boxOf(values, map->grid, numbers);
      if (!box) return;
      // One voxel more below: the cells there reach into the labels.
      const Grid& grid = map->grid;
      origin_ = kept.empty() ? box->low - 1 : box->low - 2;
      const glm::ivec3 size = (kept.empty() ? box->high : box->high + 1) - origin_ + 1;
      texture_ = gl::Texture::make3D(gl::Format::R8UI, size);
      const auto numberAt = [&](glm::ivec3 voxel) {
        return kept.empty() ? numbers[static_cast<std::uint16_t>(values[grid.offset(voxel)])]
                            : numberBeside(values, grid, numbers, isKept, voxel);
      };
      texture_.upload(std::span<const std::uint8_t>(texelsOf(numberAt, grid, origin_, size)));
    }
  });
  return had || any();
}

}  // namespace fenestra
