#pragma once
// Writes labels, measures and the focus's surface to files, in the background.

#include <filesystem>

#include <QObject>

#include "io/surface/Surface.h"
#include "viewer/jobs/LoadJob.h"

class QMainWindow;

namespace fenestra::viewer {

class Document;
class NoticeBar;
class ViewOptions;

class Exports : public QObject {
  Q_OBJECT
 public:
  enum class Labels { All, Focus };

  /// `window` is the dialogs' parent, shows in its status bar what was written, and owns this; all others outlive it.
  Exports(QMainWindow& window, const Document& document, const ViewOptions& options, NoticeBar& notices);

  bool canWriteLabels(Labels which) const;
  bool canWriteSurface() const;
  bool canWriteMeasures() const;
  /// Ask for the file, then write it.
  void chooseLabelFile(Labels which);
  void chooseSurfaceFile();
  void chooseMeasureFile();
  /// Write in the background what the document shows now; failures become notices. A DICOM segmentation names the
  /// patient unless the window hides it.
  void writeLabels(const std::filesystem::path& path, Labels which);
  /// All measures as CSV; see measuresCsv().
  void writeMeasures(const std::filesystem::path& path);
  void writeSurface(const std::filesystem::path& path, io::SurfaceFrame frame);

  LoadJob& job() { return job_; }

 private:
  LoadJob::Show written(const std::filesystem::path& path);

  QMainWindow& window_;
  const Document& document_;
  const ViewOptions& options_;
  NoticeBar& notices_;
  LoadJob job_;
};

}  // namespace fenestra::viewer
