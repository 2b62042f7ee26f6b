#include "rendering/reference/Certificate.h"

#include <algorithm>
#include <functional>
#include <random>
#include <set>

#include <boost/math/distributions/binomial.hpp>

#include "rendering/reference/Picture.h"

namespace fenestra::reference {
namespace {

/// Floyd's algorithm (Bentley and Floyd, CACM 30, 1987): every set of that many pixels is as likely.
std::vector<glm::ivec2> sampledPixels(glm::ivec2 size, const CertificateOptions& options) {
  const std::int64_t all = std::int64_t{size.x} * size.y;
  const std::int64_t count = std::clamp<std::int64_t>(options.pixels, 0, all);
  std::mt19937_64 random(options.seed);
  std::set<std::int64_t> chosen;
  for (std::int64_t last = all - count; last < all; ++last) {
    const std::int64_t drawn = std::uniform_int_distribution<std::int64_t>(0, last)(random);
    if (!chosen.insert(drawn).second) chosen.insert(last);
  }
  std::vector<glm::ivec2> pixels;
  for (const std::int64_t at : chosen) pixels.emplace_back(at % size.x, at / size.x);
  return pixels;
}

glm::dvec3 overBackground(glm::dvec4 premultiplied, glm::dvec3 background) {
  return glm::dvec3(premultiplied) + (1.0 - premultiplied.a) * background;
}

/// Greatest difference of a channel at each sampled pixel, over the background, in 1/255; infinite where a value is
/// NaN.
std::vector<double> differences(std::span<const glm::vec4> picture, const std::vector<glm::dvec4>& exact,
                                const std::vector<glm::ivec2>& pixels, glm::ivec2 size, const Look& look) {
  std::vector<double> result;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto at = static_cast<std::size_t>(pixels[i].y) * static_cast<std::size_t>(size.x) +
                    static_cast<std::size_t>(pixels[i].x);
    const glm::dvec3 background = backgroundAt(look, 1.0 - (pixels[i].y + 0.5) / size.y);
    const glm::dvec3 difference =
        glm::abs(overBackground(picture[at], background) - overBackground(exact[i], background));
    const double worst = 255.0 * std::max({difference.r, difference.g, difference.b});
    const bool isNumber = !std::isnan(difference.r) && !std::isnan(difference.g) && !std::isnan(difference.b);
    result.push_back(isNumber ? worst : std::numeric_limits<double>::infinity());
  }
  return result;
}

/// A decimal number with at most `digits` digits that is no less than `value`, so that what is said stays true.
double roundedUp(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::ceil(value * scale) / scale;
}

/// The least difference that the wanted share of all pixels keeps to. It is one of the measured differences: no more of
/// these may exceed it than leastShare allows.
double leastWithin(std::vector<double> measured, bool all) {
  if (measured.empty()) return 0.0;
  std::sort(measured.begin(), measured.end(), std::greater());
  std::size_t exceeding = 0;
  const auto count = static_cast<int>(measured.size());
  const auto isEnough = [&](std::size_t more) {
    return leastShare(count, static_cast<int>(more), wantedConfidence) >= wantedShare;
  };
  while (!all && exceeding + 1 < measured.size() && isEnough(exceeding + 1)) ++exceeding;
  return roundedUp(measured[exceeding], 3);
}

std::string decimal(double value, int digits) {
  std::string text(32, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.*f", digits, value)));
  while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) {
    const bool point = text.back() == '.';
    text.pop_back();
    if (point) break;
  }
  return text;
}

}  // namespace

double leastShare(int pixels, int exceeding, double confidence) {
  if (pixels <= 0) return 0.0;
  return boost::math::binomial_distribution<>::find_lower_bound_on_p(pixels, pixels - exceeding, 1.0 - confidence);
}

Certificate certify(std::span<const glm::vec4> picture, const Scene& scene, const View& view,
                    const CertificateOptions& options) {
  const glm::ivec2 size = view.size;
  const std::vector<glm::ivec2> pixels = sampledPixels(size, options);
  Certificate certificate;
  certificate.pixels = static_cast<int>(pixels.size());
  certificate.seed = options.seed;
  if (pixels.empty()) return certificate;

  const PictureOptions exactly{.pixelScale = view.pixelScale, .pixels = pixels, .slices = view.slices};
  const Stages stages = hasCutaway(scene) ? geometricStages(scene, view) : Stages{};
  const std::vector<glm::dvec4> exact =
      reference::picture(asDrawn(scene, view), view.camera, size, stages, exactly).final;
  const std::vector<double> measured = differences(picture, exact, pixels, size, scene.look);
  certificate.greatest = *std::max_element(measured.begin(), measured.end());
  const bool all = std::int64_t{size.x} * size.y == std::int64_t{certificate.pixels};
  certificate.within = options.within.value_or(leastWithin(measured, all));
  certificate.exceeding = static_cast<int>(
      std::count_if(measured.begin(), measured.end(), [&](double each) { return each > certificate.within; }));
  if (all) {
    certificate.share = 1.0 - static_cast<double>(certificate.exceeding) / certificate.pixels;
    return certificate;
  }
  certificate.confidence = wantedConfidence;
  certificate.share = std::min(wantedShare, leastShare(certificate.pixels, certificate.exceeding, wantedConfidence));
  return certificate;
}

std::string statementOf(const Certificate& certificate) {
  // Rounded down, so that what is said stays true.
  const double percent = std::floor(certificate.share * 1e4 + 1e-9) / 100.0;
  const std::string pixels = std::to_string(certificate.pixels), within = decimal(certificate.within, 3);
  if (certificate.confidence >= 1.0)
    return decimal(percent, 2) + " % of the pixels are within " + within + "/255 of the exact picture (all " + pixels +
           " were measured)";
  return "at least " + decimal(percent, 2) + " % of the pixels are within " + within +
         "/255 of the exact picture, with " + decimal(100.0 * certificate.confidence, 1) + " % confidence (" +
         std::to_string(certificate.exceeding) + " of " + pixels + " random pixels exceed it, seed " +
         std::to_string(certificate.seed) + ")";
}

}  // namespace fenestra::reference
