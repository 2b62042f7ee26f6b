#include "io/base/Memory.h"

#include <unistd.h>
#include <limits>
#include <string>

namespace fenestra::io {
namespace fs = std::filesystem;
namespace {

std::string megabytes(std::uint64_t bytes) {
  return std::to_string(bytes / 1000000) + (bytes < 1000000 ? " MB (" + std::to_string(bytes) + " bytes)" : " MB");
}

}  // namespace

void checkMemory(const fs::path& path, std::uint64_t bytes) {
  const std::uint64_t memory = saturatingProduct(static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)),
                                                 static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)));
  if (bytes > memory)
    throw Error(
        path,
        "describes a volume of " + megabytes(bytes) + ", larger than this machine's memory of " + megabytes(memory),
        "the header is damaged, or the volume must be made smaller first");
}

std::uint64_t saturatingProduct(std::uint64_t a, std::uint64_t b) {
  std::uint64_t product = 0;
  return __builtin_mul_overflow(a, b, &product) ? std::numeric_limits<std::uint64_t>::max() : product;
}

}  // namespace fenestra::io
