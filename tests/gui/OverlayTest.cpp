// Text over pictures is readable on bright tissue, too, at both densities of a display.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include "viewer/style/Overlay.h"

namespace fenestra::viewer {
namespace {

/// Relative luminance of an sRGB colour (WCAG 2.1).
double luminance(QRgb pixel) {
  const auto linear = [](int channel) {
    const double value = channel / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(qRed(pixel)) + 0.7152 * linear(qGreen(pixel)) + 0.0722 * linear(qBlue(pixel));
}

double contrast(double a, double b) { return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05); }

QImage corner(const QColor& background, double ratio) {
  QImage image(QSize(160, 60) * ratio, QImage::Format_RGB32);
  image.setDevicePixelRatio(ratio);
  image.fill(background);
  QPainter painter(&image);
  drawCorner(painter, {0, 0, 160, 60}, Qt::AlignTop | Qt::AlignLeft, {"Axial", "W 400  L 40"}, overlayGrey);
  return image;
}

TEST(Overlay, TextStandsOutFromBrightTissueAtBothDensities) {
  for (const double ratio : {1.0, 2.0})
    for (const QColor& background :
         {QColor(Qt::white), QColor(190, 190, 190), QColor(225, 205, 160), QColor(Qt::black)}) {
      SCOPED_TRACE(background.name().toStdString() + " at " + std::to_string(ratio));
      const QImage image = corner(background, ratio), onBlack = corner(Qt::black, ratio);
      // Letters: what is bright over black as well.
      const auto isLetter = [&](int x, int y) {
        return onBlack.rect().contains(x, y) && luminance(onBlack.pixel(x, y)) > 0.4;
      };
      // Beside each letter: from 0.75 device-independent pixels on, where its smoothing has ended, to 1.5.
      const int reach = static_cast<int>(std::lround(2.0 * ratio));
      double letters = 0.0, beside = 0.0;
      int letterCount = 0, besideCount = 0;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
          if (isLetter(x, y)) {
            letters += luminance(image.pixel(x, y));
            ++letterCount;
            continue;
          }
          double nearest = reach;
          for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx)
              if (isLetter(x + dx, y + dy)) nearest = std::min(nearest, std::hypot(dx, dy) / ratio);
          if (nearest < 0.75 || nearest > 1.5) continue;
          beside += luminance(image.pixel(x, y));
          ++besideCount;
        }
      ASSERT_GT(letterCount, 50);
      ASSERT_GT(besideCount, 50);
      // 4.5 is what WCAG 2.1 asks of text (success criterion 1.4.3). Smoothing lowers what is reached, at single
      // density to 6.5 even over black.
      EXPECT_GT(contrast(letters / letterCount, beside / besideCount), 4.5);
    }
}

TEST(Overlay, LongCornerTextsAreWholeAndLeaveTheLettersAlone) {
  constexpr int width = 230, height = 200;
  constexpr int letter = 10, letterRow = 20;  // half a letter with its halo, and the height of its line with the margin
  const QString text = QStringLiteral("Interpolated contouring instructions");
  const auto draw = [&](Qt::Alignment corner, const QStringList& lines, int imageWidth) {
    QImage image(imageWidth, height, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    drawCorner(painter, image.rect(), corner, lines, Qt::white);
    return image;
  };
  const auto lit = [](const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) != qRgb(0, 0, 0);
    return count;
  };
  for (const Qt::Alignment corner :
       {Qt::AlignTop | Qt::AlignLeft, Qt::AlignTop | Qt::AlignRight, Qt::AlignBottom | Qt::AlignLeft}) {
    const QImage image = draw(corner, {text}, width);
    // The letters stand in the middle of the edges.
    EXPECT_EQ(lit(image.copy(width / 2 - letter, 0, 2 * letter, letterRow)), 0);
    EXPECT_EQ(lit(image.copy(width / 2 - letter, height - letterRow, 2 * letter, letterRow)), 0);
    EXPECT_GT(lit(image), 0);
    // Each of the words takes a line of its own.
    int apart = 0;
    for (const QString& word : text.split(QLatin1Char(' '))) apart += lit(draw(corner, {word}, 10 * width));
    EXPECT_EQ(lit(image), apart) << "no word is cut";
  }
  // A word that is wider than the view ends in dots.
  const QImage wide = draw(Qt::AlignTop | Qt::AlignLeft, {QString(60, QLatin1Char('W'))}, width);
  EXPECT_GT(lit(wide), 0);
  EXPECT_EQ(lit(wide.copy(width / 2 - letter, 0, 2 * letter, letterRow)), 0);
  EXPECT_EQ(lit(wide.copy(width - 5, 0, 5, height)), 0);
}

}  // namespace
}  // namespace fenestra::viewer
