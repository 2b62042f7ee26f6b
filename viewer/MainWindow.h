#pragma once
// The window: five views, panels, and the ways to open data.

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include <QMainWindow>
#include <QPointer>

#include "io/study/StudyRequest.h"
#include "viewer/Panels.h"
#include "viewer/jobs/LabelEditor.h"
#include "viewer/jobs/RegionGrower.h"
#include "viewer/jobs/StudyLoader.h"
#include "viewer/model/FramePacer.h"
#include "viewer/model/PreviewBackend.h"
#include "viewer/model/Workspace.h"
#include "viewer/views/ChooseSchedule.h"
#include "viewer/views/GlSupport.h"

class QStackedWidget;

namespace fenestra::viewer {

class Actions;
class ArchiveDock;
class Exports;
class FileOpener;
class Guide;
class NoticeBar;
class PictureExports;
class DeidentifyDialog;
class ResultsDialog;
class Verification;
class Sessions;
class SliceView;
class StudyLink;
class StudyNotices;
class Tour;
class ViewArea;
class WelcomePage;

class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  struct Setup {
    GlSupport gl;
    std::optional<Effort> atRest = {};  ///< how 3-D views are drawn at rest; unset: as remembered
    /// The kind of focus that the first study is likely to have: programs are compiled before it is there. Unset: a
    /// study compiles what it needs, and nothing is done without one.
    std::optional<Focus> expected = {};
    ChooseSchedule chooseSchedule = {};  ///< unset: the renderer's name decides
    bool remember = true;                ///< restore and save layout, recent files and `atRest`
    /// Opens the first study, by open() or sessions(). Another thread reads it while this one builds the rest of the
    /// window; it is shown once events are handled.
    std::function<void(MainWindow&)> openFirst = {};
    MainWindow* first = nullptr;  ///< this window is for a study beside that one's, which owns it
  };

  explicit MainWindow(const Setup& setup, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Reads a study and shows it. The open study stays until then.
  void open(StudyLoader::Reader read);
  /// See FileOpener::open().
  void open(const std::vector<std::filesystem::path>& paths);
  void openLabels(const std::filesystem::path& path);
  /// An entry in the File menu and on the welcome page for data that comes with the program. The guided tour takes the
  /// first.
  void addSample(const QString& name, StudyLoader::SampleReader read);
  /// Offers data in a notice, because other data was opened first. `name` may name the patient.
  void offer(const QString& name, std::function<io::StudyRequest()> request);
  /// Ends the program in order, without a question: unsaved work is left for the next start to offer.
  void leave();

  /// The window beside, with a second study or none yet, tiled with this one. A study that is open there stays until
  /// another is.
  MainWindow& showBeside();
  /// 0: the left study, 1: the right one.
  int side() const { return first_ ? 1 : 0; }
  /// How this study and the one beside go together.
  StudyLink& link() { return *link_; }
  /// Closes this window and the one beside, unless the user keeps unsaved work.
  void quit();

  /// Calls `done` once, when nothing is being read and all views show the scene at full quality.
  void whenDrawn(std::function<void()> done);

  /// The whole window in device pixels, including the 3-D views and their overlays. Patient and study are left out
  /// unless asked for.
  enum class Patient : std::uint8_t { Hidden, Shown };
  QImage picture(Patient patient = Patient::Hidden);

  Workspace& workspace() { return workspace_; }
  Sessions& sessions() { return *sessions_; }
  Exports& exports() { return *exports_; }
  PictureExports& pictures() { return *pictures_; }
  Verification& verification() { return *verification_; }
  ViewArea& views() { return *views_; }
  NoticeBar& notices() { return *notices_; }
  ArchiveDock& archive() { return *archive_; }
  Guide& guide() { return *guide_; }
  Tour& tour() { return *tour_; }

 Q_SIGNALS:
  /// The window shows a study.
  void opened();
  /// Reading failed; the message is one line.
  void failed(const QString& message);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  /// The pages below the loading bar and the notices.
  QWidget* makeCentre();
  void connectModels();
  void connectViews();
  void connectPanels();
  /// Where the region is too large to open to it by itself.
  void askToOpenRegion();
  void connectLoader();
  void restoreLayout();
  void applyPreference(Preference which);
  /// Lays panels and views out as on the program's first run.
  void resetLayout();
  /// Adds the present state of the window to the key images.
  void keepKeyImage();
  void showResultsDialog();
  void showDeidentifyDialog();
  /// Moves crosshair and cameras to a new volume, before any view draws it.
  void followVolume();
  void studyOpened();
  /// Back to the welcome page with nothing open, after unsaved work was asked for; its memory is let go.
  void closeStudy();
  /// Lets go of the study and of what is read, without a question.
  void dropStudy();
  void storeLayout();

  void connectBeside();
  /// The window beside; null before there was one.
  MainWindow* other() const { return first_ ? first_ : second_.get(); }
  /// Lays both windows out, each on half of the screen.
  void tile();
  /// The slice of the other study shows a millimetre as large.
  void scaleOther(const SliceView& view);
  /// Says where coordinates of the two studies may not mean the same place.
  void tellFrames();
  /// This window closes, and the other one is alone again.
  void endComparison();
  void showOther();

  /// Moves the crosshair to the centre of the focus once another thread has found it.
  void goToFocus();
  /// Nothing is being read, measured or drawn.
  bool isIdle();

  const Setup setup_;
  GlSupport gl_;
  Workspace workspace_;
  StudyLoader loader_;
  RegionGrower grower_{workspace_.document};
  LabelEditor labelEditor_{workspace_.document};
  LoadJob focusSearch_;  ///< runs for goToFocus()

  ViewArea* views_;
  std::unique_ptr<PreviewBackend> previews_;  ///< draws with a view, and is destroyed before it
  NoticeBar* notices_;
  Sessions* sessions_;
  FileOpener* files_;
  StudyNotices* studyNotices_;
  Exports* exports_;
  PictureExports* pictures_;
  Verification* verification_;
  Tour* tour_;
  WelcomePage* welcome_;
  QStackedWidget* pages_;
  Panels panels_;
  ArchiveDock* archive_;
  QPointer<ResultsDialog> results_;
  QPointer<DeidentifyDialog> deidentify_;
  Guide* guide_;
  Actions* actions_;
  QByteArray firstState_, firstViews_;  ///< the layout that resetLayout() restores

  MainWindow* const first_;  ///< null in the first window
  std::shared_ptr<StudyLink> link_;
  std::vector<std::pair<QString, StudyLoader::SampleReader>> samples_;
  QByteArray alone_;  ///< the geometry before two studies were compared; empty while they are not
  std::unique_ptr<MainWindow> second_;
};

}  // namespace fenestra::viewer
