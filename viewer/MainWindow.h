#pragma once
// The window: five views, panels, and the ways to open data.

#include <functional>

#include <QMainWindow>

#include "viewer/jobs/LoadJob.h"
#include "viewer/jobs/ReadStudy.h"
#include "viewer/model/Brush.h"
#include "viewer/model/Document.h"
#include "viewer/model/PlacementController.h"
#include "viewer/model/Preferences.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/ViewLink.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/views/GlSupport.h"
#include "viewer/views/ViewArea.h"

class QLabel;
class QProgressBar;
class QStackedWidget;

namespace fenestra::viewer {

class Actions;
class AppearancePanel;
class BrushPanel;
class CamerasPanel;
class ContextLayerPanel;
class CutawayPanel;
class FocusPanel;
class NoticeBar;
class Sessions;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// Reads a study on another thread.
  using Reader = std::function<Study(const io::Progress&)>;
  struct Setup {
    GlSupport gl;
    std::optional<Effort> atRest = {};  ///< of the 3-D views when nothing moves; unset: as remembered
    bool remember = true;               ///< restore and save layout, recent files and the above
  };

  explicit MainWindow(const Setup& setup, QWidget* parent = nullptr);

  /// Reads and shows; what is open stays until the new study is there. `missing` is called when the reader did not find
  /// a session's data.
  void open(Reader read, std::function<void(const io::DataMissing&)> missing = {});
  /// As dropped: a session, a volume, a volume and its label map, or slices of one folder. Asks before unsaved work
  /// goes.
  void open(const std::vector<std::filesystem::path>& paths);
  void openLabels(const std::filesystem::path& path);
  /// An entry in the File menu for data that comes with the program.
  void addSample(const QString& name, Reader read);

  /// Calls `done` once, when nothing is being read and all views show the scene at full quality.
  void whenDrawn(std::function<void()> done);

  /// The whole window in device pixels, 3-D views with what is drawn over them included.
  QImage picture();

  void chooseFile();
  void chooseFolder();
  void chooseLabels();
  void chooseSeries();
  /// Of the view that was used last.
  void resetActiveView();
  void resetAllViews();
  void face(StandardView side);
  /// What is being read or measured is given up, or else the brush laid down, or else all views are shown.
  void stop();

  /// Of the 3-D views when nothing moves; remembered, unless this window remembers nothing.
  void setAtRest(const Effort& effort);
  /// In the File menu's list, unless this window remembers nothing.
  void rememberRecent(const std::filesystem::path& path);

  const GlSupport& gl() const { return setup_.gl; }
  Document& document() { return document_; }
  SliceCursor& cursor() { return cursor_; }
  ViewLink& cameras() { return cameras_; }
  PlacementController& placement() { return placement_; }
  ViewOptions& options() { return options_; }
  Brush& brush() { return brush_; }
  Preferences& preferences() { return preferences_; }
  Sessions& sessions() { return *sessions_; }
  ViewArea& views() { return *views_; }
  NoticeBar& notices() { return *notices_; }
  FocusPanel& focusPanel() { return *focusPanel_; }
  AppearancePanel& appearancePanel() { return *appearancePanel_; }
  CutawayPanel& cutawayPanel() { return *cutawayPanel_; }
  ContextLayerPanel& contextLayerPanel() { return *contextLayerPanel_; }
  CamerasPanel& camerasPanel() { return *camerasPanel_; }
  BrushPanel& brushPanel() { return *brushPanel_; }

 Q_SIGNALS:
  /// A study is on show.
  void opened();
  /// Reading came to nothing; the message is one line.
  void failed(const QString& message);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeDocks();
  void makeStatusBar();
  QWidget* makeWelcome();
  QWidget* makeLoadingBar();
  void showStudy(Study study);
  void showWarnings(const std::vector<io::Warning>& warnings);
  void showError(const QString& message);
  void openSeries(const std::string& series);
  void pointAt(glm::dvec3 world);
  void showMenu(glm::dvec3 world, QPoint globalPosition);
  /// Of the last picture: time and quality.
  void showFrame();
  /// Moves the crosshair to the centre of the focus once another thread has found it.
  void goToFocus();
  /// Moves the cameras as a step that can be undone.
  void moveCameras(const QString& step, const std::function<void()>& move);

  Setup setup_;
  Document document_;
  SliceCursor cursor_;
  ViewLink cameras_;
  PlacementController placement_;
  ViewOptions options_;
  Brush brush_;
  Preferences preferences_;
  LoadJob job_;
  LoadJob focusSearch_;  ///< goToFocus()'s

  Sessions* sessions_ = nullptr;
  Actions* actions_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  ViewArea* views_ = nullptr;
  NoticeBar* notices_ = nullptr;
  QWidget* loadingBar_ = nullptr;
  QLabel* loadingText_ = nullptr;
  QProgressBar* loadingProgress_ = nullptr;
  FocusPanel* focusPanel_ = nullptr;
  AppearancePanel* appearancePanel_ = nullptr;
  CutawayPanel* cutawayPanel_ = nullptr;
  ContextLayerPanel* contextLayerPanel_ = nullptr;
  CamerasPanel* camerasPanel_ = nullptr;
  BrushPanel* brushPanel_ = nullptr;
  QLabel *pointer_ = nullptr, *frame_ = nullptr;
  int lastCamera_ = 0;  ///< of the 3-D view used last, which standard views act on
};

}  // namespace fenestra::viewer
