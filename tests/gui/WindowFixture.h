#pragma once
// A window on a display with OpenGL that shows a ball of soft tissue with a green cube in it, and helpers that move the
// mouse, turn the wheel and press keys as a user does.

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <QPointF>

#include "tests/gui/Patience.h"
#include "viewer/MainWindow.h"
#include "viewer/views/ViewArea.h"

class QDockWidget;

namespace fenestra::viewer {

constexpr std::uint16_t body = 1, marker = 2;

/// Where the marker is: to the patient's left, anterior and superior of the middle.
inline const glm::dvec3 markerCentre(17.0, -17.0, 17.0);

/// A ball of soft tissue with a green cube of bone in it, 48³ voxels of 2 mm around the world's origin.
io::Study markedBall();

/// Preferences are stored in a folder of the test's own.
void useScratchSettings();

/// A window that shows the marked ball.
class Window : public testing::Test {
 protected:
  void SetUp() override;
  /// A window with nothing open in it.
  void makeWindow();

  void open(const io::Study& study);
  /// Drops files or a folder from another program, and waits until they are shown.
  void drop(const std::vector<std::filesystem::path>& paths);
  void waitUntilDrawn();
  /// Whether choosing a focus places the cameras. Off unless a test is about that.
  void setAutomatic(bool on);

  Document& document() { return window_->workspace().document; }
  SliceCursor& cursor() { return window_->workspace().cursor; }
  ViewLink& cameras() { return window_->workspace().cameras; }
  PlacementController& placement() { return window_->workspace().placement; }
  ViewOptions& options() { return window_->workspace().options; }
  Brush& brush() { return window_->workspace().brush; }
  ViewArea& views() { return window_->views(); }
  /// The window's only panel of that class.
  template <class Panel>
  Panel& panel() {
    return *window_->findChild<Panel*>();
  }
  /// Shows a dock's contents: before other tabs, and unfolded.
  QDockWidget* bringUp(const char* dock);
  VolumeView* volume(std::size_t index) { return views().volumeViews().at(index); }
  SliceView* slice(SlicePlane plane) { return views().sliceViews().at(static_cast<std::size_t>(plane)); }

  void drag(QWidget* widget, QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
            Qt::KeyboardModifiers modifiers = {});
  void wheel(QWidget* widget, int notches, Qt::KeyboardModifiers modifiers = {});

  /// The picture of a view in device pixels, without the outermost two device-independent pixels, where a frame marks
  /// the view that has the focus.
  QImage picture(QWidget* view) { return partOf(window_->picture(), view); }
  /// A view's part of a picture of the whole window.
  QImage partOf(const QImage& window, QWidget* view);
  /// Centre of the green pixels that a view shows, from -1 (left, top) to 1 (right, bottom); empty when there are few.
  /// The corner that names a slice's plane is left out.
  std::optional<QPointF> green(QWidget* view);

  const GlSupport gl_ = probeOpenGl();
  std::unique_ptr<MainWindow> window_;
};

}  // namespace fenestra::viewer
