#pragma once
// Opens data as a user does it: from dialogs, dropped onto the window, or named together on the command line.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QPoint>

#include "io/session/LookFile.h"
#include "viewer/jobs/StudyLoader.h"

class QMimeData;
class QWidget;

namespace fenestra::io {
struct DataRequest;
struct Study;
}  // namespace fenestra::io

namespace fenestra::viewer {

class Document;
class NoticeBar;
class Preferences;
class Sessions;
class ViewLink;
struct Workspace;

class FileOpener : public QObject {
  Q_OBJECT
 public:
  /// `window` is the dialogs' parent and owns this; all others outlive it.
  FileOpener(QWidget& window, Workspace& workspace, StudyLoader& loader, Sessions& sessions, NoticeBar& notices);

  /// A session, a volume, a volume and its label map, or slices of one folder. Asks before unsaved work is dropped.
  void open(const std::vector<std::filesystem::path>& paths);
  /// As open(). A single file beside an open volume may be a volume or its label map: a menu at `at`, in screen
  /// coordinates, asks which.
  void drop(const std::vector<std::filesystem::path>& paths, QPoint at);

  /// The preset of a whole look that studies start from; null: none.
  void setChosenLook(const io::LookPreset* preset);

  void chooseFile();
  void chooseFolder();
  void chooseLabels();
  void chooseMaskFolder();
  /// Names and colours for the label map that is open, which is in a file.
  void chooseLabelTable();
  /// Asks how large the voxels of the open study are, which its file may not say, and opens it anew.
  void chooseVoxelSize();
  /// Asks for the list of series, where the user chooses one.
  void chooseSeries() { Q_EMIT seriesWanted(); }
  /// Opens another series of what is open, by its id.
  void openSeries(const std::string& series);
  /// Opens a series of what is open in another window.
  void openSeriesOf(const io::Study& study, const std::string& series);
  /// Asks for data to open beside what is open.
  void chooseFileBeside();
  void chooseFolderBeside();
  /// Opens the next series of the folder by its number, or with -1 the one before; from the last on to the first.
  void openNeighbour(int step);

 Q_SIGNALS:
  void seriesWanted();
  /// Data are to be opened in the window beside.
  void besideWanted(const std::vector<std::filesystem::path>& paths);

 private:
  std::optional<std::filesystem::path> askForVolume();
  /// Reads data and shows them; asks for the size of voxels where the file does not say it.
  void load(const io::DataRequest& data);
  /// Reads data, in the chosen look and with the user's own defaults; see SettingOwners.h.
  StudyLoader::Reader readerOf(const io::DataRequest& data) const;

  QWidget& window_;
  Document& document_;
  const Preferences& preferences_;
  const ViewLink& cameras_;
  StudyLoader& loader_;
  Sessions& sessions_;
  NoticeBar& notices_;
  std::optional<io::LookPreset> chosenLook_;
};

/// The files that a drag brings.
std::vector<std::filesystem::path> localPaths(const QMimeData& data);

}  // namespace fenestra::viewer
