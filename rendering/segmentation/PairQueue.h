#pragma once
// Pairs of tissues, or of parts of bones, by the cost of their merge, the cheapest first.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace fenestra::segmentation {

struct MergePair {
  float cost;  ///< not negative
  std::uint32_t a, b;
  /// The cheapest last; ties by number.
  bool operator<(const MergePair& other) const { return std::tie(other.cost, other.a, other.b) < std::tie(cost, a, b); }
};

/// One heap for each hundredth of an octave of cost, made when its turn comes: a heap of all pairs, some millions,
/// would leave the processor's cache.
class PairQueue {
 public:
  PairQueue() : buckets_(std::size_t{1} << 16) {}

  void push(const MergePair& pair) {
    // Numbers of IEEE 754 that are not negative are ordered as their bits are.
    const std::size_t number = std::bit_cast<std::uint32_t>(pair.cost) >> 16;
    Bucket& bucket = buckets_[number];
    bucket.pairs.push_back(pair);
    if (bucket.isHeap) std::push_heap(bucket.pairs.begin(), bucket.pairs.end());
    lowest_ = std::min(lowest_, number);
  }

  std::optional<MergePair> pop() {
    while (lowest_ < buckets_.size() && buckets_[lowest_].pairs.empty()) buckets_[lowest_++] = {};
    if (lowest_ == buckets_.size()) return std::nullopt;
    Bucket& bucket = buckets_[lowest_];
    if (!std::exchange(bucket.isHeap, true)) std::make_heap(bucket.pairs.begin(), bucket.pairs.end());
    std::pop_heap(bucket.pairs.begin(), bucket.pairs.end());
    const MergePair pair = bucket.pairs.back();
    bucket.pairs.pop_back();
    return pair;
  }

 private:
  struct Bucket {
    std::vector<MergePair> pairs;
    bool isHeap = false;
  };
  std::vector<Bucket> buckets_;  ///< by the upper half of the cost's bits
  std::size_t lowest_ = 0;       ///< no bucket before it holds a pair
};

}  // namespace fenestra::segmentation
