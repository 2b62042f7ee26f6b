#include "io/deidentify/NewUids.h"

#include <memory>
#include <new>
#include <stdexcept>
#include <tuple>

#include <openssl/bn.h>
#include <openssl/crypto.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <openssl/rand.h>

namespace fenestra::io::deidentify {
namespace {

/// The decimal form of a UUID's 128 bits behind the root for them.
std::string uidOf(const unsigned char* uuid) {
  const std::unique_ptr<BIGNUM, void (*)(BIGNUM*)> number(BN_bin2bn(uuid, 16, nullptr), BN_free);
  if (!number) throw std::bad_alloc();
  const std::unique_ptr<char, void (*)(char*)> decimal(BN_bn2dec(number.get()), [](char* text) { OPENSSL_free(text); });
  if (!decimal) throw std::bad_alloc();
  return std::string("2.25.") + decimal.get();
}

}  // namespace

NewUids::NewUids() {
  if (RAND_bytes(key_.data(), static_cast<int>(key_.size())) != 1)
    throw std::runtime_error("the system has no random numbers for new UIDs");
}

NewUids::~NewUids() { OPENSSL_cleanse(key_.data(), key_.size()); }

NewUids::Hash NewUids::hashOf(std::string_view text) const {
  static_assert(std::tuple_size_v<Hash> >= EVP_MAX_MD_SIZE);
  Hash hash{};
  unsigned size = 0;
  if (!HMAC(EVP_sha256(), key_.data(), static_cast<int>(key_.size()),
            reinterpret_cast<const unsigned char*>(text.data()), text.size(), hash.data(), &size))
    throw std::bad_alloc();
  return hash;
}

std::string NewUids::of(std::string_view uid) {
  constexpr std::string_view standard = "1.2.840.10008.";
  if (uid.empty() || uid.starts_with(standard)) return std::string(uid);
  if (const auto at = given_.find(uid); at != given_.end()) return at->second;
  Hash hash = hashOf(uid);
  // Version 8 (of one's own making) and the variant of RFC 9562.
  hash[6] = static_cast<unsigned char>((hash[6] & 0x0f) | 0x80);
  hash[8] = static_cast<unsigned char>((hash[8] & 0x3f) | 0x80);
  return given_.emplace(uid, uidOf(hash.data())).first->second;
}

std::string NewUids::patientFor(std::string_view id) {
  // Apart from UIDs of the same text.
  const std::string text = "patient " + std::string(id);
  if (const auto at = given_.find(text); at != given_.end()) return at->second;
  const Hash hash = hashOf(text);
  std::string number;
  for (std::size_t i = 0; i < 6; ++i)
    for (const int nibble : {hash[i] >> 4, hash[i] & 15}) number += static_cast<char>('A' + nibble);
  return given_.emplace(text, number).first->second;
}

}  // namespace fenestra::io::deidentify
