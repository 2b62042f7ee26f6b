#pragma once
// Opens data as a user does it: from dialogs, dropped onto the window, or named together on the command line.

#include <filesystem>
#include <string>
#include <vector>

#include <QObject>
#include <QPoint>

#include "viewer/jobs/StudyLoader.h"

class QMimeData;
class QWidget;

namespace fenestra::io {
struct DataRequest;
}

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

  void chooseFile();
  void chooseFolder();
  void chooseLabels();
  void chooseSeries();

 private:
  void openSeries(const std::string& series);
  /// Reads data and shows them; asks for the size of voxels where the file does not say it.
  void load(const io::DataRequest& data);
  /// Reads data, with the look of the open study and the user's own defaults.
  StudyLoader::Reader readerOf(const io::DataRequest& data) const;

  QWidget& window_;
  Document& document_;
  const Preferences& preferences_;
  const ViewLink& cameras_;
  StudyLoader& loader_;
  Sessions& sessions_;
  NoticeBar& notices_;
};

/// The files that a drag brings.
std::vector<std::filesystem::path> localPaths(const QMimeData& data);

}  // namespace fenestra::viewer
