#include "rendering/Enlargement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

constexpr std::size_t taps = 4;
constexpr std::size_t leastRows = 64;  ///< shown rows worth a thread

/// The pixels around a place along one side, and their weights.
struct Tap {
  std::array<std::size_t, taps> at;
  std::array<float, taps> weight;
};

/// Mitchell and Netravali's filter with B = C = 1/3, at a distance in pixels.
float weightAt(float x) {
  return x < 1.0f ? ((7.0f * x - 12.0f) * x * x + 16.0f / 3.0f) / 6.0f
                  : (((-7.0f / 3.0f * x + 12.0f) * x - 20.0f) * x + 32.0f / 3.0f) / 6.0f;
}

std::vector<Tap> tapsOf(int size, int shown) {
  std::vector<Tap> result(static_cast<std::size_t>(shown));
  for (int i = 0; i < shown; ++i) {
    Tap& tap = result[static_cast<std::size_t>(i)];
    const float position = (static_cast<float>(i) + 0.5f) / static_cast<float>(shown) * static_cast<float>(size) - 0.5f;
    const float first = std::floor(position);
    for (std::size_t k = 0; k < taps; ++k) {
      const int offset = static_cast<int>(k) - 1;
      tap.at[k] = static_cast<std::size_t>(std::clamp(static_cast<int>(first) + offset, 0, size - 1));
      tap.weight[k] = weightAt(std::abs(position - first - static_cast<float>(offset)));
    }
  }
  return result;
}

class Enlarger {
 public:
  Enlarger(std::span<const glm::vec4> picture, glm::ivec2 size, glm::ivec2 shown, const PlainBackground& background)
      : picture_(picture),
        width_(static_cast<std::size_t>(size.x)),
        background_(background),
        across_(tapsOf(size.x, shown.x)),
        down_(tapsOf(size.y, shown.y)) {}

  /// Shown rows from `begin` to `end`, into the bytes of all. Along columns first: of few pixels, and with the
  /// background, which depends on the row alone. Arrays of their own let compilers use vectors.
  void rows(std::size_t begin, std::size_t end, std::uint8_t* bytes) const {
    std::vector<glm::vec4> narrow(width_);
    std::vector<float> wide(4 * across_.size());
    for (std::size_t y = begin; y < end; ++y) {
      makeNarrow(y, narrow);
      for (std::size_t x = 0; x < across_.size(); ++x) {
        const Tap& tap = across_[x];
        std::array<float, 4> sum{};
        for (std::size_t k = 0; k < taps; ++k)
          for (int i = 0; i < 4; ++i) sum[static_cast<std::size_t>(i)] += tap.weight[k] * narrow[tap.at[k]][i];
        std::copy(sum.begin(), sum.end(), wide.begin() + static_cast<std::ptrdiff_t>(4 * x));
      }
      std::uint8_t* row = bytes + y * wide.size();
      for (std::size_t i = 0; i < wide.size(); ++i)
        row[i] = static_cast<std::uint8_t>(static_cast<int>(std::clamp(wide[i], 0.0f, 1.0f) * 255.0f + 0.5f));
    }
  }

 private:
  /// A shown row, as wide as the picture: blue, green, red, 1.
  void makeNarrow(std::size_t y, std::vector<glm::vec4>& row) const {
    const Tap& tap = down_[y];
    const float above = 1.0f - (static_cast<float>(y) + 0.5f) / static_cast<float>(down_.size());
    const glm::vec3 behind = background_.bottom + above * background_.rise;
    for (std::size_t x = 0; x < width_; ++x) {
      glm::vec4 sum(0.0f);
      for (std::size_t k = 0; k < taps; ++k) sum += tap.weight[k] * picture_[tap.at[k] * width_ + x];
      const glm::vec3 colour = glm::vec3(sum) + (1.0f - sum.a) * behind;
      row[x] = {colour.b, colour.g, colour.r, 1.0f};
    }
  }

  std::span<const glm::vec4> picture_;
  std::size_t width_;
  PlainBackground background_;
  std::vector<Tap> across_, down_;
};

}  // namespace

std::vector<std::uint8_t> enlarged(std::span<const glm::vec4> picture, glm::ivec2 size, glm::ivec2 shown,
                                   const PlainBackground& background) {
  std::vector<std::uint8_t> bytes(4 * static_cast<std::size_t>(shown.x) * static_cast<std::size_t>(shown.y));
  const Enlarger enlarger(picture, size, shown, background);
  parallelFor(static_cast<std::size_t>(shown.y), leastRows,
              [&](std::size_t begin, std::size_t end) { enlarger.rows(begin, end, bytes.data()); });
  return bytes;
}

}  // namespace fenestra
