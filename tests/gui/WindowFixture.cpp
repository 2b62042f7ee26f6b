#include "tests/gui/WindowFixture.h"

#include <cmath>

#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QUrl>
#include <QWheelEvent>

#include "tests/support/TestData.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/model/Paths.h"

namespace fenestra::viewer {

void useScratchSettings() {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                     QString::fromStdString(tests::scratchFolder().string()));
  QCoreApplication::setOrganizationName(QStringLiteral("Fenestra tests"));
}

io::Study markedBall() {
  auto volume = std::make_shared<Volume>();
  auto labels = std::make_shared<LabelMap>();
  volume->grid = labels->grid = {.dims = glm::ivec3(48), .spacing = glm::dvec3(2.0), .origin = glm::dvec3(-47.0)};
  volume->modality = Modality::CT;
  volume->unit = "HU";
  volume->windows = {{400.0, 40.0}};
  volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
  labels->voxels = Voxels(ScalarType::UInt8, volume->grid.voxelCount());
  auto values = volume->voxels.as<std::int16_t>();
  auto marks = labels->voxels.as<std::uint8_t>();
  for (int z = 0; z < 48; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x) {
        const glm::dvec3 world = volume->grid.origin + 2.0 * glm::dvec3(x, y, z);
        const glm::dvec3 offset = glm::abs(world - markerCentre);
        const bool isMarker = std::max({offset.x, offset.y, offset.z}) < 7.0, isBody = glm::length(world) < 44.0;
        const std::size_t at = volume->grid.offset({x, y, z});
        values[at] = static_cast<std::int16_t>(isMarker ? 900 : isBody ? 40 : -1000);
        marks[at] = static_cast<std::uint8_t>(isMarker ? marker : isBody ? body : 0);
      }
  volume->computeRange();
  labels->labels = {{body, "body", {0.9, 0.6, 0.5}}, {marker, "marker", {0.1, 1.0, 0.1}}};
  io::Study study;
  study.scene.volume = volume;
  study.scene.labels = labels;
  study.scene.look.context.function.nodes = {{-200.0, {{0.9, 0.6, 0.5}, 0.0}}, {0.0, {{0.9, 0.6, 0.5}, 1.0}}};
  return study;
}

QDockWidget* Window::bringUp(const char* dock) {
  auto* found = window_->findChild<QDockWidget*>(QLatin1String(dock));
  found->show();
  found->raise();
  if (found->widget()->isHidden()) found->findChild<QToolButton*>(QStringLiteral("fold"))->click();
  return found;
}

void Window::SetUp() {
  makeWindow();
  if (HasFatalFailure()) return;
  open(markedBall());
}

void Window::makeWindow() {
  ASSERT_TRUE(gl_.available) << gl_.problem.toStdString();
  // Draft, because what is tested here does not depend on the sampling and the machine may have no GPU.
  window_ = std::make_unique<MainWindow>(
      MainWindow::Setup{.gl = gl_, .atRest = Effort{.quality = Quality::Draft}, .remember = false});
  window_->resize(1280, 800);
  window_->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get(), patience));
  QApplication::setActiveWindow(window_.get());  // Xvfb has no window manager to do it; keys need it
  setAutomatic(false);
}

void Window::drop(const std::vector<std::filesystem::path>& paths) {
  QList<QUrl> urls;
  for (const std::filesystem::path& path : paths) urls << QUrl::fromLocalFile(toQString(path));
  QMimeData files;
  files.setUrls(urls);
  QDragEnterEvent enter(QPoint(400, 300), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &enter);
  ASSERT_TRUE(enter.isAccepted());
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  QDropEvent event(QPointF(400, 300), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &event);
  ASSERT_TRUE(opened.count() > 0 || opened.wait(patience))
      << window_->notices().texts().join(QStringLiteral("; ")).toStdString();
  waitUntilDrawn();
}

void Window::open(const io::Study& study) {
  QSignalSpy opened(window_.get(), &MainWindow::opened);
  window_->open([study](const io::Progress&) { return study; });
  ASSERT_TRUE(opened.wait(patience));
  waitUntilDrawn();
}

void Window::waitUntilDrawn() {
  bool drawn = false;
  window_->whenDrawn([&] { drawn = true; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return drawn; }, patience));
}

void Window::setAutomatic(bool on) {
  PlacementSettings settings = placement().settings();
  settings.automatic = on;
  placement().setSettings(settings);
}

void Window::drag(QWidget* widget, QPoint from, QPoint to, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
  QTest::mousePress(widget, button, modifiers, from);
  constexpr int steps = 4;
  for (int step = 1; step <= steps; ++step) {
    const QPoint at = from + (to - from) * step / steps;
    QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, button, modifiers);
    QApplication::sendEvent(widget, &move);
  }
  QTest::mouseRelease(widget, button, modifiers, to);
}

void Window::wheel(QWidget* widget, int notches, Qt::KeyboardModifiers modifiers) {
  const QPointF at = widget->rect().center();
  QWheelEvent event(at, widget->mapToGlobal(at), {}, {0, 120 * notches}, Qt::NoButton, modifiers, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(widget, &event);
}

QImage Window::partOf(const QImage& window, QWidget* view) {
  const double ratio = window.devicePixelRatio();
  constexpr int frame = 2;
  const QRect area =
      QRect(view->mapTo(window_.get(), QPoint(0, 0)), view->size()).adjusted(frame, frame, -frame, -frame);
  return window.copy(QRect(QPoint(std::lround(area.x() * ratio), std::lround(area.y() * ratio)),
                           QSize(std::lround(area.width() * ratio), std::lround(area.height() * ratio))));
}

std::optional<QPointF> Window::green(QWidget* view) {
  const QImage seen = picture(view);
  QPointF sum;
  int count = 0;
  const QRect name(QPoint(0, 0), QSize(120, 24) * view->devicePixelRatioF());  // the coronal plane's is green, too
  for (int y = 0; y < seen.height(); ++y)
    for (int x = 0; x < seen.width(); ++x) {
      if (name.contains(x, y)) continue;
      const QColor colour = seen.pixelColor(x, y);
      if (colour.green() < colour.red() + 60 || colour.green() < colour.blue() + 60) continue;
      sum += QPointF(x, y);
      ++count;
    }
  if (count < 30) return std::nullopt;
  const QPointF mean = sum / count - QRectF(seen.rect()).center();
  return QPointF(2.0 * mean.x() / seen.width(), 2.0 * mean.y() / seen.height());
}

}  // namespace fenestra::viewer
