#pragma once
// The window's commands: its menus, its toolbar and their keys. FileActions.cpp, ViewActions.cpp and StudyActions.cpp
// hold the menus.

#include <functional>
#include <memory>

#include <QList>
#include <QMenu>
#include <QObject>

#include "viewer/actions/ViewCommands.h"
#include "viewer/dialogs/KeyBindings.h"
#include "viewer/jobs/StudyLoader.h"
#include "viewer/model/Preferences.h"
#include "viewer/views/Cine.h"
#include "viewer/views/GlSupport.h"

class QAction;
class QKeySequence;
class QMainWindow;

namespace fenestra::viewer {

class ArchiveDock;
class CutawayPanel;
class Exports;
class PictureExports;
class FileOpener;
class Guide;
class RegionGrower;
class Sessions;
class StudyLink;
class Tour;
class Verification;
class ViewArea;
struct Workspace;

class Actions : public QObject {
  Q_OBJECT
 public:
  /// The study beside this one.
  struct Beside {
    StudyLink& link;
    int side;  ///< of the link
    std::function<void()> showOther, quit;
  };
  /// Show the dialogs of their names.
  struct Dialogs {
    std::function<void()> saveResults, deidentify;
  };
  /// What the commands act on. All outlive this.
  struct Targets {
    QMainWindow& window;  ///< gets the menu bar and the toolbar; has its docks already
    Workspace& workspace;
    StudyLoader& loader;
    RegionGrower& grower;
    FileOpener& files;
    Exports& exports;
    PictureExports& pictures;
    Verification& verification;
    Sessions& sessions;
    ViewArea& views;
    GlSupport gl;
    std::function<void()> closeStudy;
    std::function<void()> resetLayout;
    std::function<void()> keepKeyImage;
    Dialogs dialogs;
    CutawayPanel& cutaway;
    ArchiveDock& archive;
    Guide& guide;
    Tour& tour;
  };

  /// The window owns this.
  Actions(const Targets& targets, const Beside& beside);

  /// An entry in the File menu for data that comes with the program; this owns it.
  QAction* addSample(const QString& name, StudyLoader::SampleReader read);

 private:
  QAction* action(const QString& text, const QKeySequence& keys, std::function<void()> does);
  /// Adds another key to an action.
  static void addKey(QAction& action, const QKeySequence& keys);
  /// Enabled while something is open.
  QAction* volumeAction(const QString& text, const QKeySequence& keys, std::function<void()> does);
  /// Follows a preference, and changes it.
  QAction* preferenceToggle(const QString& text, const QKeySequence& keys, Preference which);
  QAction* toggle(const QString& text, const QKeySequence& keys, bool on, std::function<void(bool)> does);

  void makeFileMenu();
  /// The segmentations beside the series; hidden while there are none.
  void addLabelEntries(QMenu& menu);
  void addVoxelSize(QMenu& menu);
  void addModalityMenu(QMenu& menu);
  void addSegmentationMenu(QMenu& menu);
  void addExports(QMenu& menu);
  /// Enabled while something that archives keep is open.
  void addSending(QMenu& menu);
  void addOpenBeside(QMenu& menu);
  /// How two studies that are open side by side go together.
  void makeCompareMenu(QMenu& menu);
  /// Gives the panels' room to the pictures while two studies share the screen.
  void addSidePanels(QMenu& menu);
  void makeEditMenu();
  void showSettings();
  void makeViewMenu();
  void makeLayoutMenu(QMenu& menu);
  /// How the active slice's picture lies in its view, and playing through the slices.
  void addSlicePictures(QMenu& menu);
  /// The slice that is active; while a 3-D view is, the first that shows.
  SliceView& activeSlice() const;
  void addOwnLayouts(QMenu& layouts);
  void makeLookFromMenu(QMenu& menu);
  void makeCameraEntries(QMenu& menu);
  QAction* makeFreezeEntry();
  QMenu* makeAtRestMenu();
  void makeOverlayEntries(QMenu& menu);
  /// Where the slices lie, and how thick they are.
  QMenu* makeSlicesMenu();
  /// The plane of the slice that was used last; axial before one was.
  SlicePlane usedPlane() const;
  void makeWindowLevelMenu();
  /// Windows of a modality, in sight where the study is of it.
  void addWindowPresets(QMenu& menu);
  void addOwnWindows(QMenu& menu);
  void makeMeasureMenu();
  /// The path of the curved reformat.
  void addPathEntries(QMenu& menu);
  void makeFocusMenu();
  void addRegionEntries(QMenu& menu);
  void makeHelpMenu();
  void fillRecentMenu();
  /// Does the first of these that applies: cancels reading, exporting, verifying, growing or placing; puts the active
  /// tool down; ends drawing a path, or measuring; stops playing; shows all views.
  void stop();

  Targets targets_;
  Beside beside_;
  ViewCommands viewCommands_;
  Cine cine_;
  std::unique_ptr<KeyBindings> keys_;  ///< made when all menus are
  QMenu *recent_ = nullptr, *samples_ = nullptr;
  QList<QAction*> needVolume_;
  /// The toolbar's actions, by group.
  QList<QList<QAction*>> tools_;
};

}  // namespace fenestra::viewer
