#pragma once
// Headers of Analyze 7.5 of known content.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/io/IoTesting.h"

namespace fenestra::tests {

/// An Analyze 7.5 header, field by field at the offsets of its struct dsr.
struct AnalyzeSpec {
  bool swapped = false;
  std::vector<std::int16_t> dims{2, 3, 4};
  std::int16_t datatype = 4;
  std::array<float, 3> spacing{1, 2, 3};
  float slope = 0, offset = 0;
  char orientation = 0;
  std::array<std::int16_t, 3> origin{0, 0, 0};
  std::string unit{};  ///< of up to three characters
};

inline std::string analyzeHeader(const AnalyzeSpec& spec) {
  std::string bytes(348, '\0');
  const auto put = [&](std::size_t at, auto value) {
    const std::string text = bytesOf(value, spec.swapped);
    bytes.replace(at, text.size(), text);
  };
  put(0, std::int32_t{348});
  put(32, std::int32_t{16384});
  bytes[38] = 'r';
  put(40, static_cast<std::int16_t>(spec.dims.size()));
  for (std::size_t i = 0; i < spec.dims.size(); ++i) put(42 + 2 * i, spec.dims[i]);
  std::copy(spec.unit.begin(), spec.unit.end(), bytes.begin() + 56);
  put(70, spec.datatype);
  for (std::size_t i = 0; i < 3; ++i) put(80 + 4 * i, spec.spacing[i]);
  put(108, spec.offset);
  put(112, spec.slope);
  bytes[252] = spec.orientation;
  for (std::size_t i = 0; i < 3; ++i) put(253 + 2 * i, spec.origin[i]);
  return bytes;
}

}  // namespace fenestra::tests
