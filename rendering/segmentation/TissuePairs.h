#pragma once
// Finds the contact of two tissues: a hash table from pairs of numbers to numbers.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace fenestra::segmentation {

/// Open addressing with linear probing, at most half full: a look-up touches one line of the cache, where a map of the
/// library follows three pointers. Entries are never removed.
class TissuePairs {
 public:
  static constexpr std::uint32_t none = UINT32_MAX;

  explicit TissuePairs(std::size_t expected) : entries_(std::bit_ceil(std::max<std::size_t>(16, 2 * expected))) {}

  /// The number of a pair, in either order; it may be set. `none` where the pair is new, and has to be set then.
  std::uint32_t& operator()(std::uint32_t a, std::uint32_t b) {
    if (2 * used_ >= entries_.size()) grow();
    Entry& entry = find(entries_, keyOf(a, b));
    if (entry.number == none) {
      entry.key = keyOf(a, b);
      ++used_;
    }
    return entry.number;
  }

 private:
  struct Entry {
    std::uint64_t key = 0;
    std::uint32_t number = none;
  };

  static std::uint64_t keyOf(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }

  /// The entry of a key, or the free one where it belongs.
  static Entry& find(std::vector<Entry>& entries, std::uint64_t key) {
    // Fibonacci hashing (Knuth, The Art of Computer Programming 3, 6.4): the product's upper bits.
    const int shift = 64 - std::countr_zero(entries.size());
    std::size_t at = static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> shift);
    while (entries[at].number != none && entries[at].key != key) at = (at + 1) & (entries.size() - 1);
    return entries[at];
  }

  void grow() {
    std::vector<Entry> larger(2 * entries_.size());
    for (const Entry& entry : entries_)
      if (entry.number != none) find(larger, entry.key) = entry;
    entries_ = std::move(larger);
  }

  std::vector<Entry> entries_;
  std::size_t used_ = 0;
};

}  // namespace fenestra::segmentation
