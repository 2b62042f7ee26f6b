#pragma once
// What a random sample of its pixels proves about the error of a finished picture. The exact colours of the sample come
// from the reference (Picture.h); the bound on the share of all pixels is the one-sided one of Clopper and Pearson
// (Biometrika 26, 1934), which holds for any picture.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "rendering/reference/Reference.h"

namespace fenestra::reference {

struct CertificateOptions {
  /// Sampled without replacement, which makes the bound a little stricter than it says; from so many on, all of them.
  int pixels = 10000;
  std::uint64_t seed = 1;
  /// Greatest difference of a channel that counts as right, in 1/255. Empty: the least with which the wanted share can
  /// be stated.
  std::optional<double> within{};
};

/// "With `confidence`, at least `share` of all pixels are within `within`/255 of the exact picture."
struct Certificate {
  double within = 0.0;      ///< 1/255, of the worst channel over the scene's background
  double share = 0.0;       ///< 0..1; the wanted share where that can be stated, else the greatest that can
  double confidence = 1.0;  ///< 1 where every pixel was measured
  int pixels = 0;           ///< measured
  int exceeding = 0;        ///< of those, further from the exact picture than `within`
  std::uint64_t seed = 0;
  double greatest = 0.0;  ///< difference of a measured pixel, 1/255
};
inline constexpr double wantedShare = 0.999, wantedConfidence = 0.95;

/// The share of all pixels that are right with `confidence`, when `exceeding` of `pixels` measured ones were not: the
/// lower limit of Clopper and Pearson.
double leastShare(int pixels, int exceeding, double confidence);

/// `picture`: premultiplied RGBA before rounding to 8 bits, row by row from the top, of the view's size. What is not a
/// number is infinitely wrong. Takes from seconds to minutes: within an Interruptible (rendering/volume/Threads.h) it
/// can be stopped.
Certificate certify(std::span<const glm::vec4> picture, const Scene& scene, const View& view,
                    const CertificateOptions& options = {});

/// One sentence in English.
std::string statementOf(const Certificate& certificate);

}  // namespace fenestra::reference
