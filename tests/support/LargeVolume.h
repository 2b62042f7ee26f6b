#pragma once
// A volume of 1 GB as a file of raw voxels, to measure the memory that opening it takes.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

namespace fenestra::tests::large {

inline constexpr int side = 512, slices = 2000;
inline constexpr double volumeBytes = 2.0 * side * side * slices;
/// The program, its libraries and the driver.
inline constexpr double programBytes = 300e6;

/// A body of soft tissue with organs of bone's density and noise: nothing that packs well or is mostly air.
inline std::vector<std::int16_t> sliceOf(int z) {
  std::vector<std::int16_t> values;
  std::minstd_rand random(static_cast<unsigned>(z + 1));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const double across = (x - 256) / 220.0, down = (y - 256) / 180.0;
      const bool isAir = across * across + down * down > 1.0;
      const bool isOrgan = std::abs(std::sin(0.05 * x) * std::sin(0.06 * y) * std::sin(0.02 * z)) > 0.6;
      const int noise = static_cast<int>(random() % 32) - 16;
      values.push_back(static_cast<std::int16_t>((isAir ? -1000 : isOrgan ? 900 : 40) + noise));
    }
  return values;
}

inline void writeRaw(const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  for (int z = 0; z < slices; ++z) out.write(reinterpret_cast<const char*>(sliceOf(z).data()), 2L * side * side);
}

}  // namespace fenestra::tests::large
