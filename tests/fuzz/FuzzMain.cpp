// libFuzzer's entry point; FENESTRA_FUZZ_TARGET names the target.

#include <cstdint>

#include "tests/fuzz/Targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fenestra::fuzz::Target& target = fenestra::fuzz::targetNamed(FENESTRA_FUZZ_TARGET);
  fenestra::fuzz::run(target, std::as_bytes(std::span(data, size)));
  return 0;
}
