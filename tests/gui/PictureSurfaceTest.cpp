// A picture looks the same on either kind of surface.

#include <algorithm>
#include <cstdlib>
#include <optional>

#include <gtest/gtest.h>

#include <QPainter>
#include <QTest>

#include "rendering/Renderer.h"
#include "rendering/gpu/GpuScene.h"
#include "tests/gui/WindowFixture.h"
#include "tests/support/Scenes.h"
#include "viewer/views/GlContext.h"
#include "viewer/views/PictureSurface.h"

namespace fenestra::viewer::pictureSurfaceTest {
namespace {

/// A ball away from the middle, over a background that changes from bottom to top: no picture of it is symmetric.
Scene ballInCorner() {
  Scene scene = tests::valueScene(
      tests::gridOf(glm::ivec3(32)),
      [](glm::ivec3 voxel) { return 100.0 - glm::distance(glm::dvec3(voxel), glm::dvec3(8.0, 16.0, 22.0)); }, 93.0);
  scene.look.backdrop = Backdrop::Gradient;
  scene.look.background = glm::dvec3(0.1, 0.2, 0.3);
  scene.look.backgroundTop = glm::dvec3(0.8, 0.5, 0.2);
  return scene;
}

/// A view with nothing but a surface.
struct SurfaceWindow : QWidget {
  SurfaceWindow(bool software, Renderer& picture)
      : surface(PictureSurface::make(software, *this,
                                     {.paint =
                                          [this, &picture] {
                                            surface->show(picture);
                                            QPainter(&surface->widget()).fillRect(mark, Qt::red);
                                          },
                                      .shown = [this] { ++shown; }})) {}
  void resizeEvent(QResizeEvent*) override { surface->widget().setGeometry(rect()); }

  static constexpr QRect mark{3, 5, 10, 4};
  PictureSurface* surface;
  int shown = 0;
};

struct Surfaces : testing::Test {
  ~Surfaces() override {
    context.run([this] { renderer.reset(); });
  }

  /// The picture of so many pixels on a surface; its camera is that of a surface of `covered` pixels.
  QImage on(bool software, glm::ivec2 size, glm::ivec2 shown = {120, 90}, std::optional<glm::ivec2> covered = {}) {
    Renderer* picture = nullptr;
    context.run([&] {
      renderer.emplace(std::make_shared<GpuScene>());
      const Scene scene = ballInCorner();
      Camera camera = Camera::standard(StandardView::Anterior, scene.volume->grid);
      if (covered) camera = camera.widened(shown, *covered);
      renderer->render(scene, {.camera = camera, .size = size});
      whole = renderer->readPicture();
      picture = &*renderer;
    });
    SurfaceWindow window(software, *picture);
    window.resize(shown.x, shown.y);
    window.show();
    if (!QTest::qWaitForWindowExposed(&window, patience)) ADD_FAILURE() << "no window";
    context.run([&] { window.surface->take(*picture); });
    const int before = window.shown;
    window.surface->widget().update();
    EXPECT_TRUE(QTest::qWaitFor([&] { return window.shown > before; }, patience));
    return window.surface->grab().convertToFormat(QImage::Format_RGB32);
  }

  GlContext context;
  std::optional<Renderer> renderer;
  std::vector<std::uint8_t> whole;  ///< the last picture
};

int greatestDifference(const QImage& a, const QImage& b) {
  EXPECT_EQ(a.size(), b.size());
  int greatest = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      greatest = std::max(
          {greatest, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
    }
  return greatest;
}

TEST_F(Surfaces, ShowThePictureWithWhatIsPaintedOverIt) {
  for (const bool software : {false, true}) {
    SCOPED_TRACE(software);
    const QImage seen = on(software, {120, 90});
    QImage expected = QImage(whole.data(), 120, 90, QImage::Format_RGBX8888).convertToFormat(QImage::Format_RGB32);
    QPainter(&expected).fillRect(SurfaceWindow::mark, Qt::red);
    // Both round a colour to 8 bits, one by the driver and one by hand.
    EXPECT_LE(greatestDifference(seen, expected), 1);
  }
}

TEST_F(Surfaces, EnlargeAPictureOfFewPixelsInTheSameWay) {
  const QImage card = on(false, {40, 30}), raster = on(true, {40, 30});
  // A driver computes the one, the CPU the other; both round to 8 bits.
  EXPECT_LE(greatestDifference(card, raster), 1);
  EXPECT_NE(card.pixel(60, 1), card.pixel(60, 88)) << "there is a picture";
}

TEST_F(Surfaces, Thorough_APictureOfHalfTheResolutionCoversAnEvenNumberOfPixels) {
  const glm::ivec2 shown(119, 89), covered = coveredAtHalf(shown);
  EXPECT_EQ(covered, glm::ivec2(120, 90));
  const QImage truth = on(true, shown, shown);
  const auto meanDifference = [&](const QImage& half) {
    double sum = 0.0;
    for (int y = 0; y < shown.y; ++y)
      for (int x = 0; x < shown.x; ++x) sum += std::abs(qRed(half.pixel(x, y)) - qRed(truth.pixel(x, y)));
    return sum / (shown.x * shown.y);
  };
  for (const bool software : {false, true}) {
    SCOPED_TRACE(software);
    const double aligned = meanDifference(on(software, covered / 2, shown, covered));
    // Without the camera of what is covered, the picture lies half a shown pixel aside.
    const double aside = meanDifference(on(software, covered / 2, shown));
    EXPECT_LT(aligned, 0.9 * aside);
  }
}

TEST_F(Surfaces, TellOnceThatAPictureIsOnScreen) {
  Renderer* picture = nullptr;
  context.run([&] {
    renderer.emplace(std::make_shared<GpuScene>());
    picture = &*renderer;
  });
  SurfaceWindow window(true, *picture);
  window.resize(20, 20);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, patience));
  QCoreApplication::processEvents();
  window.shown = 0;
  window.surface->widget().repaint();
  EXPECT_EQ(window.shown, 0);
  window.surface->tellShown();
  EXPECT_EQ(window.shown, 1);
  QCoreApplication::sendPostedEvents();
  EXPECT_EQ(window.shown, 1);
}

}  // namespace
}  // namespace fenestra::viewer::pictureSurfaceTest
