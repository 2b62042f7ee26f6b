// Text over pictures is readable on bright tissue, too, at both densities of a display.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <QImage>
#include <QLabel>
#include <QPainter>
#include <QStatusBar>
#include <QTest>

#include "tests/gui/WindowFixture.h"
#include "viewer/style/Overlay.h"

namespace fenestra::viewer::overlayTest {
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
      // Letters are the pixels that are bright over black as well.
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
      // WCAG 2.1 asks for a contrast of 4.5 (success criterion 1.4.3). Smoothing lowers the contrast: at single density
      // to 6.5 even over black.
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

/// Pixels of the longest horizontal line in the colour of a scale bar; 0 where none is longer than a letter's.
int barLength(const QImage& image) {
  constexpr int letter = 12;
  int longest = 0;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0, run = 0; x < image.width(); ++x) {
      run = image.pixel(x, y) == overlayGrey.rgb() ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  return longest > letter ? longest : 0;
}

/// The distance of a length in mm to the nearest 1, 2 or 5 times a power of ten, as a share of it.
double roundness(double mm) {
  const double power = std::pow(10.0, std::floor(std::log10(mm)));
  double nearest = 1.0;
  for (const double each : {1.0, 2.0, 5.0, 10.0}) nearest = std::min(nearest, std::abs(each * power - mm) / mm);
  return nearest;
}

TEST(Overlay, AScaleBarIsARoundNumberOfMillimetresLong) {
  for (const double mmPerPixel : {0.03, 0.11, 0.5, 0.83, 2.7}) {
    SCOPED_TRACE(mmPerPixel);
    QImage image(600, 80, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    drawScaleBar(painter, image.rect(), mmPerPixel);
    painter.end();
    const int pixels = barLength(image);
    EXPECT_LE(pixels, 151) << "a quarter of the view, and its last pixel";
    EXPECT_GE(pixels, 600 / 4 / 2.5) << "the next longer one would not fit";
    EXPECT_LT(roundness((pixels - 1) * mmPerPixel), 1.0 / (pixels - 1)) << "to a pixel";
  }
}

TEST(Overlay, EachEdgeHasTheLetterOfItsSide) {
  const auto draw = [](glm::dvec3 right, glm::dvec3 down) {
    QImage image(200, 100, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    drawEdgeLetters(painter, image.rect(), right, down);
    return image;
  };
  const QRect left(0, 30, 60, 40), right(140, 30, 60, 40), top(70, 0, 60, 30), bottom(70, 70, 60, 30);
  const glm::dvec3 toLeft(1, 0, 0), toPosterior(0, 1, 0), toInferior(0, 0, -1), oblique(0.6, 0.8, 0.0);
  const QImage axial = draw(toLeft, toPosterior), mirrored = draw(-toLeft, toPosterior);
  EXPECT_EQ(axial.copy(top), mirrored.copy(top));
  EXPECT_EQ(axial.copy(bottom), mirrored.copy(bottom));
  EXPECT_NE(axial.copy(left), mirrored.copy(left));
  EXPECT_NE(axial.copy(right), mirrored.copy(right));
  const QImage coronal = draw(toLeft, toInferior);
  EXPECT_EQ(axial.copy(left), coronal.copy(left));
  EXPECT_NE(axial.copy(bottom), coronal.copy(bottom));
  EXPECT_NE(draw(oblique, toInferior).copy(right), coronal.copy(right)) << "two letters";
}

TEST_F(Window, AScaleBarStandsInParallelViewsAlone) {
  options().setCrosshair(false);
  waitUntilDrawn();
  const auto expectBar = [&](QWidget* view, double pixelsPerMm) {
    SCOPED_TRACE(view->objectName().toStdString());
    const int pixels = barLength(picture(view));
    ASSERT_GT(pixels, 0);
    // Device pixels; either end may be off by one.
    const double mm = (pixels - 1) / (pixelsPerMm * window_->devicePixelRatioF());
    EXPECT_LT(roundness(mm), 2.0 / (pixels - 1)) << mm << " mm";
  };
  constexpr double tenMm = 10.0;
  for (SliceView* view : views().sliceViews()) {
    const glm::dvec3 superior(0.0, 0.0, tenMm), left(tenMm, 0.0, 0.0);
    const glm::dvec3 step = view == slice(SlicePlane::Axial) ? left : superior;
    const QPointF by = view->widgetFromWorld(step) - view->widgetFromWorld(glm::dvec3(0.0));
    expectBar(view, std::hypot(by.x(), by.y()) / tenMm);
  }
  for (VolumeView* view : views().volumeViews()) EXPECT_EQ(barLength(picture(view)), 0) << "in perspective";
  QTest::keyClick(window_.get(), Qt::Key_P, Qt::ControlModifier);
  waitUntilDrawn();
  for (VolumeView* view : views().volumeViews()) {
    const QPointF by = *view->widgetFromWorld({0.0, 0.0, tenMm}) - *view->widgetFromWorld(glm::dvec3(0.0));
    expectBar(view, std::hypot(by.x(), by.y()) / tenMm);
  }
}

TEST_F(Window, ACubeShowsHowThePatientLiesIn3D) {
  const auto cube = [&](int view) {
    waitUntilDrawn();
    const QImage whole = picture(volume(static_cast<std::size_t>(view)));
    const int side = static_cast<int>(60 * window_->devicePixelRatioF());
    return whole.copy(0, whole.height() - side, side, side);
  };
  cameras().face(0, StandardView::Anterior);
  const QImage anterior = cube(0);
  EXPECT_NE(anterior.pixel(anterior.rect().center()), qRgb(0, 0, 0));
  cameras().face(0, StandardView::Left);
  const QImage left = cube(0);
  EXPECT_NE(left, anterior);
  cameras().face(0, StandardView::Superior);
  EXPECT_NE(cube(0), anterior);
  EXPECT_NE(cube(0), left);
  cameras().setLinked(false);
  cameras().face(1, StandardView::Left);
  EXPECT_EQ(cube(1), left) << "the same in both views";
}

TEST_F(Window, TheRadiologicalConventionIsNamedOnScreen) {
  bool named = false;
  for (const QLabel* label : window_->statusBar()->findChildren<QLabel*>())
    named |= label->isVisible() && label->text() == QStringLiteral("Radiological convention");
  EXPECT_TRUE(named);
  // On the slices where left and right could be mistaken: their top right corner.
  const auto corner = [&](SlicePlane plane) {
    const QImage whole = picture(slice(plane));
    const int width = whole.width() / 3, height = static_cast<int>(24 * window_->devicePixelRatioF());
    return whole.copy(whole.width() - width, 0, width, height);
  };
  for (const SlicePlane plane : {SlicePlane::Axial, SlicePlane::Coronal}) {
    const QImage with = corner(plane);
    options().setText(false);
    EXPECT_NE(corner(plane), with);
    options().setText(true);
  }
}

/// Where the lines of a slice's crosshair cross, or the middle of a 3-D view's mark, from -1 (left, top) to 1: what
/// differs between two pictures of a view. A column or row that differs over more than half of its length is a line.
std::optional<QPointF> crosshairIn(const QImage& with, const QImage& without, bool lines) {
  std::vector<int> columns(static_cast<std::size_t>(with.width())), rows(static_cast<std::size_t>(with.height()));
  for (int y = 0; y < with.height(); ++y)
    for (int x = 0; x < with.width(); ++x)
      if (with.pixel(x, y) != without.pixel(x, y)) {
        ++columns[static_cast<std::size_t>(x)];
        ++rows[static_cast<std::size_t>(y)];
      }
  const auto middle = [&](const std::vector<int>& counts, int length) -> std::optional<double> {
    double sum = 0.0, weight = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (lines && counts[i] < length / 2) continue;
      sum += counts[i] * static_cast<double>(i);
      weight += counts[i];
    }
    if (weight == 0.0) return std::nullopt;
    return 2.0 * (sum / weight - 0.5 * (static_cast<double>(counts.size()) - 1.0)) / static_cast<double>(counts.size());
  };
  const auto x = middle(columns, with.height()), y = middle(rows, with.width());
  if (!x || !y) return std::nullopt;
  return QPointF(*x, *y);
}

TEST_F(Window, TheCrosshairIsOverTheSamePointInAllFiveViews) {
  document().focusOn(marker);
  cursor().moveTo(markerCentre);
  options().setText(false);
  waitUntilDrawn();
  const auto expectOverMarker = [&](QWidget* view, bool lines, double tolerance) {
    SCOPED_TRACE(view->objectName().toStdString());
    const QImage with = picture(view);
    options().setCrosshair(false);
    const std::optional<QPointF> seen = green(view), at = crosshairIn(with, picture(view), lines);
    options().setCrosshair(true);
    ASSERT_TRUE(seen) << "the marker is not seen";
    ASSERT_TRUE(at) << "there is no crosshair";
    EXPECT_NEAR(at->x(), seen->x(), tolerance);
    EXPECT_NEAR(at->y(), seen->y(), tolerance);
  };
  // A slice cuts the cube through its centre; a view shows some 50 voxels, and voxels cut in two move the edge by half
  // of one.
  for (SliceView* view : views().sliceViews()) expectOverMarker(view, true, 0.02);
  // In 3-D the cube is seen from outside: its near face is 9 mm closer to the eye, and off the view's middle by a
  // third.
  for (int index : {0, 1}) expectOverMarker(volume(index), false, 0.06);
}

/// Rows of an image that hold light pixels, in runs: the lines of text.
int linesIn(const QImage& image) {
  int lines = 0;
  bool before = false;
  for (int y = 0; y < image.height(); ++y) {
    bool text = false;
    for (int x = 0; x < image.width() && !text; ++x) text = qGray(image.pixel(x, y)) > 120;
    lines += text && !before;
    before = text;
  }
  return lines;
}

TEST(Overlay, ALineOfTheStudyStaysOneLineWhateverItsLength) {
  for (int width = 150; width < 420; width += 3) {
    QImage image(width, 160, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    drawStudyText(painter, image.rect(), {QStringLiteral("IX LXXX-XXXX-0000")}, 1);
    painter.end();
    EXPECT_EQ(linesIn(image), 1) << width;
  }
}

TEST(Overlay, TextOfTheStudyStaysInTheUpperThirdOfAView) {
  for (const int height : {120, 160, 240, 400}) {
    QImage image(300, height, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    drawStudyText(painter, image.rect(), QStringList(12, QStringLiteral("XXXX")), 1);
    painter.end();
    EXPECT_EQ(linesIn(image.copy(0, height / 3, image.width(), height - height / 3)), 0) << height;
    EXPECT_GT(linesIn(image), 0) << height;
  }
}

}  // namespace
}  // namespace fenestra::viewer::overlayTest
