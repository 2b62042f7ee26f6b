#include "io/base/Contents.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <mutex>
#include <system_error>

#include <openssl/evp.h>

#include "rendering/volume/Threads.h"

namespace fenestra::io {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t chunk = std::size_t{1} << 20;

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), EVP_MD_CTX_free) {
    if (!context_ || !EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr)) throw std::bad_alloc();
  }
  void add(const char* bytes, std::size_t size) { EVP_DigestUpdate(context_.get(), bytes, size); }
  /// In hexadecimal.
  std::string end() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned size = 0;
    EVP_DigestFinal_ex(context_.get(), digest.data(), &size);
    std::string hex;
    for (unsigned i = 0; i < size; ++i)
      for (const int nibble : {digest[i] >> 4, digest[i] & 15}) hex += "0123456789abcdef"[nibble];
    return hex;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_;
};

std::string named(const std::string& hex) { return "sha256:" + hex; }

}  // namespace

Contents contentsOf(const std::vector<fs::path>& files, const Progress& progress) {
  Contents contents;
  contents.files = files.size();
  for (const fs::path& file : files) {
    std::error_code failure;
    const std::uintmax_t size = fs::file_size(file, failure);
    if (failure) throw Error(file, "cannot be read: " + failure.message(), "check the path and its permissions");
    contents.bytes += size;
  }

  std::vector<std::string> hashes(files.size());
  std::mutex mutex;
  std::uint64_t done = 0;
  const auto advance = [&](std::size_t bytes) {
    const std::scoped_lock lock(mutex);
    done += bytes;
    const double fraction =
        std::min(1.0, static_cast<double>(done) / static_cast<double>(std::max<std::uint64_t>(contents.bytes, 1)));
    if (progress && !progress(fraction, "comparing contents")) throw Cancelled();
  };
  parallelFor(files.size(), 1, [&](std::size_t begin, std::size_t end) {
    const auto buffer = std::make_unique_for_overwrite<char[]>(chunk);
    for (std::size_t i = begin; i < end; ++i) {
      std::ifstream stream(files[i], std::ios::binary);
      Sha256 hash;
      while (stream.read(buffer.get(), chunk), stream.gcount() > 0) {
        hash.add(buffer.get(), static_cast<std::size_t>(stream.gcount()));
        advance(static_cast<std::size_t>(stream.gcount()));
      }
      if (!stream.eof()) throw Error(files[i], "cannot be read", "check its permissions");
      hashes[i] = hash.end();
    }
  });
  if (hashes.size() == 1) {
    contents.hash = named(hashes.front());
    return contents;
  }
  std::sort(hashes.begin(), hashes.end());
  std::string list;
  for (const std::string& hash : hashes) list.append(hash).append("\n");
  contents.hash = hashOf(list);
  return contents;
}

std::string hashOf(std::string_view text) {
  Sha256 hash;
  hash.add(text.data(), text.size());
  return named(hash.end());
}

std::string seriesKey(const std::string& id) { return hashOf(id); }

}  // namespace fenestra::io
