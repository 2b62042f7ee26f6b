#pragma once
// What the window says about a study that it has just opened: other series and segmentations beside it, what is odd
// about its slices, and the reader's warnings.

#include <QObject>

class QMainWindow;

namespace fenestra::viewer {

class FileOpener;
class NoticeBar;
class Sessions;
class StudyLoader;
struct Workspace;

class StudyNotices : public QObject {
  Q_OBJECT
 public:
  /// The window owns this, and its status bar shows remarks. All others outlive this.
  StudyNotices(QMainWindow& window, Workspace& workspace, StudyLoader& loader, FileOpener& files, Sessions& sessions,
               NoticeBar& notices);

  /// Adds the notices about the open study.
  void show();

 private:
  void offerSeries();
  void offerSegmentations();
  void warn();

  QMainWindow& window_;
  Workspace& workspace_;
  StudyLoader& loader_;
  FileOpener& files_;
  Sessions& sessions_;
  NoticeBar& notices_;
};

}  // namespace fenestra::viewer
