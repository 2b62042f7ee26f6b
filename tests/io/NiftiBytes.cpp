#include "tests/io/NiftiBytes.h"

#include <algorithm>
#include <iterator>

#include "tests/io/IoTesting.h"

namespace fenestra::tests {

std::string niftiHeader(const NiftiSpec& spec) {
  std::string bytes(spec.two ? 544 : 352, '\0');
  const auto put = [&](std::size_t at, auto value) {
    const std::string text = bytesOf(value, spec.swapped);
    bytes.replace(at, text.size(), text);
  };
  const auto real = [&](std::size_t base1, std::size_t base2, std::size_t index, double value) {
    if (spec.two)
      put(base2 + 8 * index, value);
    else
      put(base1 + 4 * index, static_cast<float>(value));
  };
  const auto length = [&](std::size_t index, std::int64_t value) {
    if (spec.two)
      put(16 + 8 * index, value);
    else
      put(40 + 2 * index, static_cast<std::int16_t>(value));
  };
  put(0, std::int32_t{spec.two ? 540 : 348});
  length(0, static_cast<std::int64_t>(spec.dims.size()));
  for (std::size_t i = 1; i < 8; ++i) length(i, i <= spec.dims.size() ? spec.dims[i - 1] : 1);
  put(spec.two ? 12 : 70, static_cast<std::int16_t>(spec.datatype));
  for (std::size_t i = 0; i < spec.pixdim.size(); ++i) real(76, 104, i, spec.pixdim[i]);
  if (spec.two)
    put(168, std::int64_t{spec.pair ? 0 : 544});
  else
    put(108, spec.pair ? 0.0f : 352.0f);
  real(112, 176, 0, spec.slope);
  real(116, 184, 0, spec.intercept);
  if (spec.two) {
    put(344, std::int32_t{spec.qform});
    put(348, std::int32_t{spec.sform});
    put(500, std::int32_t{spec.units});
  } else {
    put(252, static_cast<std::int16_t>(spec.qform));
    put(254, static_cast<std::int16_t>(spec.sform));
    bytes[123] = static_cast<char>(spec.units);
  }
  for (std::size_t i = 0; i < 6; ++i) real(256, 352, i, spec.quatern[i]);
  for (std::size_t i = 0; i < spec.srow.size(); ++i) real(280, 400, i, spec.srow[i]);
  const char magic[] = {'n', spec.pair ? 'i' : '+', spec.two ? '2' : '1'};
  std::copy(std::begin(magic), std::end(magic), bytes.begin() + (spec.two ? 4 : 344));
  return bytes;
}

}  // namespace fenestra::tests
