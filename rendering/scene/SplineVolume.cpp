#include "rendering/scene/SplineVolume.h"

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>

#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// Lines along an axis, side by side: element i of line k is first[i · stride + k]. Elements 0 and count + 1 lie beyond
/// the voxels.
struct Lines {
  double* first;
  std::size_t stride;
  int count;  ///< voxels along a line
  std::size_t width;

  double& at(int i, std::size_t k) const { return first[static_cast<std::size_t>(i) * stride + k]; }
};

/// Turns the values of four voxels or more into interpolating coefficients. With c₋₁ … c₃ on a cubic, the first three
/// equations c_(i-1) + 4c_i + c_(i+1) = 6f_i give c₁ alone; likewise at the other end. Gauss's elimination gives those
/// between.
void interpolateLong(const Lines& lines) {
  const int n = lines.count;
  std::vector<double> pivot(static_cast<std::size_t>(n) + 2, 0.0);
  for (int i = 3; i <= n - 2; ++i)
    pivot[static_cast<std::size_t>(i)] = 1.0 / (4.0 - pivot[static_cast<std::size_t>(i) - 1]);
  for (std::size_t k = 0; k < lines.width; ++k) {
    const auto c = [&](int i) -> double& { return lines.at(i, k); };
    const double first = c(1), last = c(n), second = c(2), beforeLast = c(n - 1);
    c(2) = (8.0 * second - first - c(3)) / 6.0;
    const double end = (8.0 * beforeLast - last - (n == 4 ? second : c(n - 2))) / 6.0;
    c(n - 1) = end;
    for (int i = 3; i <= n - 2; ++i)
      c(i) = (6.0 * c(i) - c(i - 1) - (i == n - 2 ? end : 0.0)) * pivot[static_cast<std::size_t>(i)];
    for (int i = n - 3; i >= 3; --i) c(i) -= pivot[static_cast<std::size_t>(i)] * c(i + 1);
    c(1) = 6.0 * second - 4.0 * c(2) - c(3);
    c(n) = 6.0 * beforeLast - 4.0 * c(n - 1) - c(n - 2);
    c(0) = 6.0 * first - 4.0 * c(1) - c(2);
    c(n + 1) = 6.0 * last - 4.0 * c(n) - c(n - 1);
  }
}

void interpolate(const Lines& lines) {
  if (lines.count >= 4) return interpolateLong(lines);
  for (std::size_t k = 0; k < lines.width; ++k) {
    const auto c = [&](int i) -> double& { return lines.at(i, k); };
    if (lines.count == 3) {
      const double bend = c(1) - 2.0 * c(2) + c(3);
      for (int i = 1; i <= 3; ++i) c(i) -= bend / 6.0;
      c(0) = 3.0 * (c(1) - c(2)) + c(3);
      c(4) = 3.0 * (c(3) - c(2)) + c(1);
    } else if (lines.count == 2) {
      c(0) = 2.0 * c(1) - c(2);
      c(3) = 2.0 * c(2) - c(1);
    } else {
      c(0) = c(2) = c(3) = c(1);
    }
  }
}

void extend(const Lines& lines, SplineVolume::Ends ends) {
  const int n = lines.count;
  const bool even = ends == SplineVolume::Ends::Even && n > 1;
  for (std::size_t k = 0; k < lines.width; ++k) {
    const auto c = [&](int i) -> double& { return lines.at(i, k); };
    c(0) = even ? 2.0 * c(1) - c(2) : c(1);
    c(n + 1) = even ? 2.0 * c(n) - c(n - 1) : c(n);
    if (n == 1) c(3) = c(1);
  }
}

/// Means with the weights 1, 2, 1; elements beyond the voxels count as extend() leaves them.
void average(const Lines& lines) {
  for (std::size_t k = 0; k < lines.width; ++k) {
    double before = lines.at(0, k);
    for (int i = 1; i <= lines.count; ++i) {
      const double own = lines.at(i, k);
      lines.at(i, k) = 0.25 * (before + 2.0 * own + lines.at(i + 1, k));
      before = own;
    }
  }
}

void computeCoefficients(const Lines& lines, Reconstruction kind, SplineVolume::Ends ends) {
  if (kind == Reconstruction::Cubic) return interpolate(lines);
  extend(lines, ends);
  if (kind != Reconstruction::Smoother) return;
  for (int pass = 0; pass < 2; ++pass) {  // twice 1, 2, 1 is 1, 4, 6, 4, 1
    average(lines);
    extend(lines, ends);
  }
}

/// Coefficients along an axis; one voxel has four, so that any position has four around it.
glm::ivec3 coefficientCount(glm::ivec3 dims) { return glm::max(dims + 2, 4); }

}  // namespace

SplineWeights::SplineWeights(double t) {
  const double s = 1.0 - t;
  value = glm::dvec4(s * s * s, 4.0 - 3.0 * t * t * (2.0 - t), 4.0 - 3.0 * s * s * (2.0 - s), t * t * t) / 6.0;
  slope = glm::dvec4(-s * s, t * (3.0 * t - 4.0), s * (4.0 - 3.0 * s), t * t) * 0.5;
  bend = glm::dvec4(s, 3.0 * t - 2.0, 3.0 * s - 2.0, t);
}

SplinePlace::SplinePlace(double index, int count) {
  const double inside = std::clamp(index, 0.0, static_cast<double>(count - 1));
  voxel = std::min(static_cast<int>(inside), std::max(count - 2, 0));
  t = inside - voxel;
}

SplineVolume::SplineVolume(const ShownVolume& shown, Ends ends)
    : dims_(shown.volume->grid.dims),
      size_(coefficientCount(dims_)),
      coefficients_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) *
                    static_cast<std::size_t>(size_.z)) {
  const Volume& volume = *shown.volume;
  volume.voxels.visit([&](auto scalars) {
    parallelFor(static_cast<std::size_t>(dims_.z), 1, [&](std::size_t begin, std::size_t end) {
      for (int z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
        for (int y = 0; y < dims_.y; ++y) {
          const auto* stored = scalars.data() + volume.grid.offset({0, y, z});
          std::transform(stored, stored + dims_.x, const_cast<double*>(row(y, z)) + 1,
                         [&](auto scalar) { return realValue(volume, scalar); });
        }
    });
  });
  filter(shown.reconstruction, ends);
  hide(shown);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::mutex mutex;
  parallelFor(coefficients_.size(), 1 << 18, [&](std::size_t begin, std::size_t end) {
    const auto [least, greatest] = std::minmax_element(coefficients_.begin() + static_cast<std::ptrdiff_t>(begin),
                                                       coefficients_.begin() + static_cast<std::ptrdiff_t>(end));
    const std::scoped_lock lock(mutex);
    low = std::min(low, *least);
    high = std::max(high, *greatest);
  });
  range_ = {low, high};
}

void SplineVolume::filter(Reconstruction kind, Ends ends) {
  const auto each = [&](const Lines& lines) { computeCoefficients(lines, kind, ends); };
  const auto width = static_cast<std::size_t>(size_.x), plane = width * static_cast<std::size_t>(size_.y);
  parallelFor(static_cast<std::size_t>(dims_.z), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t z = begin + 1; z <= end; ++z) {
      interruptionPoint();
      double* first = coefficients_.data() + z * plane;
      for (std::size_t y = 1; y <= static_cast<std::size_t>(dims_.y); ++y) each({first + y * width, 1, dims_.x, 1});
      each({first, width, dims_.y, width});
    }
  });
  // A few lines at a time: their planes' rows stay in the cache.
  constexpr std::size_t together = 64;
  parallelFor((plane + together - 1) / together, 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      interruptionPoint();
      each({coefficients_.data() + i * together, plane, dims_.z, std::min(together, plane - i * together)});
    }
  });
}

void SplineVolume::hide(const ShownVolume& shown) {
  const ShownVoxels voxels(shown);
  if (voxels.hidesNothing()) return;
  const double air = voxels.air();
  parallelFor(static_cast<std::size_t>(size_.z), 1, [&](std::size_t begin, std::size_t end) {
    for (int z = static_cast<int>(begin) - 1; z < static_cast<int>(end) - 1; ++z)
      for (int y = -1; y < size_.y - 1; ++y) {
        double* coefficients = const_cast<double*>(row(y, z));
        for (int x = -1; x < size_.x - 1; ++x)
          if (double& c = coefficients[x + 1]; c > air)
            c = ShownVoxels::mixed(c, air, voxels.airShare(glm::clamp(glm::ivec3(x, y, z), glm::ivec3(0), dims_ - 1)));
      }
  });
}

const double* SplineVolume::row(int y, int z) const {
  return coefficients_.data() +
         static_cast<std::size_t>(size_.x) *
             (static_cast<std::size_t>(y + 1) + static_cast<std::size_t>(size_.y) * static_cast<std::size_t>(z + 1));
}

template <class Use>
void SplineVolume::around(glm::dvec3 index, Use&& use) const {
  const SplinePlace x(index.x, dims_.x), y(index.y, dims_.y), z(index.z, dims_.z);
  const SplineWeights wx(x.t), wy(y.t), wz(z.t);
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      const double* c = row(y.voxel + j - 1, z.voxel + k - 1) + x.voxel;
      use(glm::dvec4(c[0], c[1], c[2], c[3]), wx, wy, wz, j, k);
    }
}

double SplineVolume::value(glm::dvec3 index) const {
  double sum = 0.0;
  around(index, [&](glm::dvec4 c, const SplineWeights& x, const SplineWeights& y, const SplineWeights& z, int j,
                    int k) { sum += glm::dot(c, x.value) * y.value[j] * z.value[k]; });
  return sum;
}

glm::dvec3 SplineVolume::gradient(glm::dvec3 index) const {
  glm::dvec3 sum(0.0);
  around(index,
         [&](glm::dvec4 c, const SplineWeights& x, const SplineWeights& y, const SplineWeights& z, int j, int k) {
           const double value = glm::dot(c, x.value);
           sum += glm::dvec3(glm::dot(c, x.slope) * y.value[j] * z.value[k], value * y.slope[j] * z.value[k],
                             value * y.value[j] * z.slope[k]);
         });
  return sum;
}

ValueRange SplineVolume::range(glm::ivec3 cell) const {
  const glm::ivec3 base = glm::clamp(cell, glm::ivec3(0), glm::max(dims_ - 2, 0));
  ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      const double* c = row(base.y + j - 1, base.z + k - 1) + base.x;
      for (int i = 0; i < 4; ++i) range = {std::min(range.low, c[i]), std::max(range.high, c[i])};
    }
  return range;
}

}  // namespace fenestra
