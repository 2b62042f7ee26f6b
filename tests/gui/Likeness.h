#pragma once
// How alike two pictures of the window are in structure: the same panels, views and shapes, whatever the fonts, the
// rounding of the driver and the milliseconds in the status bar.

#include <algorithm>
#include <vector>

#include <QImage>

namespace fenestra::viewer {

/// Structural similarity (Wang, Bovik, Sheikh, Simoncelli, IEEE TIP 13(4), 2004, eq. 13) of the luminance, both
/// pictures reduced to an eighth, of the least similar window of 12×12 reduced pixels: 1 for equal pictures. 0 where
/// the sizes differ.
inline double likeness(const QImage& a, const QImage& b) {
  if (a.size() != b.size() || a.isNull()) return 0.0;
  const QSize small = a.size() / 8;
  const auto reduced = [&](const QImage& picture) {
    return picture.convertToFormat(QImage::Format_RGB32)
        .scaled(small, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
        .convertToFormat(QImage::Format_Grayscale8);
  };
  const QImage first = reduced(a), second = reduced(b);
  const int side = std::min({12, small.width(), small.height()});
  constexpr double c1 = 0.01 * 255.0 * 0.01 * 255.0, c2 = 0.03 * 255.0 * 0.03 * 255.0;  // the paper's
  double least = 1.0;
  const int step = std::max(1, side / 3);
  for (int top = 0; top + side <= small.height(); top += step)
    for (int left = 0; left + side <= small.width(); left += step) {
      double sumA = 0.0, sumB = 0.0, squaresA = 0.0, squaresB = 0.0, products = 0.0;
      for (int y = top; y < top + side; ++y)
        for (int x = left; x < left + side; ++x) {
          const double valueA = first.constScanLine(y)[x], valueB = second.constScanLine(y)[x];
          sumA += valueA;
          sumB += valueB;
          squaresA += valueA * valueA;
          squaresB += valueB * valueB;
          products += valueA * valueB;
        }
      const double n = static_cast<double>(side) * side, meanA = sumA / n, meanB = sumB / n;
      const double varianceA = squaresA / n - meanA * meanA, varianceB = squaresB / n - meanB * meanB;
      const double covariance = products / n - meanA * meanB;
      least = std::min(least, (2.0 * meanA * meanB + c1) * (2.0 * covariance + c2) /
                                  ((meanA * meanA + meanB * meanB + c1) * (varianceA + varianceB + c2)));
    }
  return least;
}

}  // namespace fenestra::viewer
