#include "app/benchmark/ColourError.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fenestra::bench {
namespace {

/// CIELAB of an sRGB colour (IEC 61966-2-1), white point D65.
glm::dvec3 lab(glm::dvec3 srgb) {
  glm::dvec3 linear;
  for (int i = 0; i < 3; ++i) {
    const double c = std::clamp(srgb[i], 0.0, 1.0);
    linear[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  const glm::dvec3 xyz(glm::dot(glm::dvec3(0.4124564, 0.3575761, 0.1804375), linear) / 0.95047,
                       glm::dot(glm::dvec3(0.2126729, 0.7151522, 0.0721750), linear),
                       glm::dot(glm::dvec3(0.0193339, 0.1191920, 0.9503041), linear) / 1.08883);
  glm::dvec3 f;
  for (int i = 0; i < 3; ++i)
    f[i] = xyz[i] > 216.0 / 24389.0 ? std::cbrt(xyz[i]) : (24389.0 / 27.0 * xyz[i] + 16.0) / 116.0;
  return {116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z)};
}

}  // namespace

void Distribution::add(double value) {
  values_.push_back(std::isnan(value) ? std::numeric_limits<double>::infinity() : value);
  sorted_ = false;
}

void Distribution::add(const Distribution& other) {
  values_.insert(values_.end(), other.values_.begin(), other.values_.end());
  sorted_ = false;
}

double Distribution::percentile(double percent) const {
  if (values_.empty()) return 0.0;
  if (!sorted_) std::sort(values_.begin(), values_.end());
  sorted_ = true;
  return values_[static_cast<std::size_t>(std::ceil(percent / 100.0 * static_cast<double>(values_.size() - 1)))];
}

std::size_t Distribution::countAbove(double limit) const {
  return static_cast<std::size_t>(
      std::count_if(values_.begin(), values_.end(), [&](double value) { return value > limit; }));
}

double Distribution::rms() const {
  double sum = 0.0;
  for (const double value : values_) sum += value * value;
  return values_.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values_.size()));
}

void ColourErrors::add(glm::dvec4 here, glm::dvec4 truth, glm::dvec3 background) {
  if (here == glm::dvec4(0.0) && truth == glm::dvec4(0.0)) return;
  const glm::dvec3 a = glm::dvec3(here) + (1.0 - here.a) * background;
  const glm::dvec3 b = glm::dvec3(truth) + (1.0 - truth.a) * background;
  const glm::dvec3 difference = glm::abs(a - b) * 255.0;
  double worst = 0.0;
  for (int i = 0; i < 3; ++i)
    worst = std::isnan(difference[i]) ? std::numeric_limits<double>::infinity() : std::max(worst, difference[i]);
  channel.add(worst);
  squares.add(std::sqrt(glm::dot(difference, difference) / 3.0));
  deltaE.add(glm::distance(lab(a), lab(b)));
}

void ColourErrors::add(const ColourErrors& other) {
  channel.add(other.channel);
  squares.add(other.squares);
  deltaE.add(other.deltaE);
}

}  // namespace fenestra::bench
