#pragma once
// Reads studies and label maps in the background and shows them in the document.

#include <filesystem>
#include <functional>
#include <vector>

#include <QObject>

#include "io/study/SessionData.h"
#include "viewer/jobs/LoadJob.h"
#include "viewer/model/Document.h"

namespace fenestra::viewer {

class StudyLoader : public QObject {
  Q_OBJECT
 public:
  /// Reads a study on another thread.
  using Reader = std::function<io::Study(const io::Progress&)>;
  /// Reads data that come with the program, to be looked at in that way.
  using SampleReader = std::function<io::Study(const Look&, const io::Progress&)>;
  /// Called on the GUI thread when the reader does not find a session's data.
  using Missing = std::function<void(const io::DataMissing&)>;

  /// Called on the GUI thread when the file does not say how large its voxels are.
  using Unsized = std::function<void(const io::SpacingMissing&)>;

  /// Completes a study that was read, on the reading thread.
  using Prepare = std::function<void(io::Study&)>;

  explicit StudyLoader(Document& document, Prepare prepare = {}, QObject* parent = nullptr);

  /// The document keeps its study until the new one is read. Without `missing`, missing data is a failure, and so is a
  /// missing size of voxels without `unsized`.
  void open(Reader read, Missing missing = {}, Unsized unsized = {});
  /// Asked before the document's labels are replaced by a file's.
  void setMayReplaceLabels(std::function<bool()> ask) { mayReplaceLabels_ = std::move(ask); }
  /// A label map for the document's volume, with the names and colours of `table` where one is named.
  void openLabels(const std::filesystem::path& path, const std::filesystem::path& table = {});

  /// The job that reads: its progress, its failure, and cancelling it.
  LoadJob& job() { return job_; }

 Q_SIGNALS:
  /// The document holds the study that was read.
  void opened();
  /// The document holds the label map that was read.
  void labelsOpened(const std::vector<io::Warning>& warnings);

 private:
  Document& document_;
  Prepare prepare_;
  std::function<bool()> mayReplaceLabels_;
  LoadJob job_;
};

}  // namespace fenestra::viewer
