#pragma once
// The session of the window: what it is saved as, whether something is not saved yet, and copies saved by themselves in
// case of a crash. What is to be written is gathered as a plain io::Session; a worker hashes the data and writes.
// Labels that are in no file yet are written beside the session, as NAME.labels.nrrd.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include "io/session/Session.h"
#include "viewer/model/Document.h"

class QLockFile;

namespace fenestra::viewer {

class PlacementController;
class SliceCursor;
class ViewLink;
class ViewOptions;

/// A session that a run saved by itself and did not live to remove.
struct AbandonedSession {
  std::filesystem::path file;
  QDateTime saved;
  std::shared_ptr<QLockFile> lock;  ///< ours now, so that no other run offers it too
};

class SessionController : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    SliceCursor& cursor;
    ViewLink& cameras;
    PlacementController& placement;
    ViewOptions& options;
  };
  /// The window's own part of a session: the pictures' sizes and sampling, and the layout.
  struct WindowPart {
    std::function<void(io::Session&)> describe;
    std::function<void(const io::Session&)> restore;
  };

  SessionController(const Parts& parts, WindowPart window, QObject* parent = nullptr);
  /// Waits for what is being written. The copy saved in case of a crash goes.
  ~SessionController() override;

  /// The session as it stands.
  io::Session session() const;
  /// After a study was opened: the window becomes what the study's session says, if it has one.
  void studyOpened();

  /// Where the session was opened from or saved to; empty before.
  const std::filesystem::path& file() const { return file_; }
  /// There are steps since the last save.
  bool isModified() const;
  /// Writes on another thread; saved() or failed() follows. One save at a time: a second waits for the first.
  void save(const std::filesystem::path& file);
  /// Blocks until nothing is being written; false when the last save failed.
  bool waitUntilSaved();

  /// From now on, what is modified is copied to `folder` every `milliseconds`. The folder is made when it is missing.
  void startAutosave(const std::filesystem::path& folder, int milliseconds);
  /// Copies now, if there is something new to copy. The pause that the window feels is that of gathering.
  /// Drops the present copy, too.
  void stopAutosave();
  void autosave();
  /// Copies in `folder` whose run has ended without removing them, the latest first.
  static std::vector<AbandonedSession> abandonedIn(const std::filesystem::path& folder);
  /// Goes on with such a copy as its own: it goes when this session is saved or given up.
  void adopt(const AbandonedSession& abandoned);
  /// Removes the copy for the present session: what it holds was saved, or is not wanted.
  void dropAutosave();
  /// Removes a copy and the labels beside it.
  static void removeCopy(const std::filesystem::path& file);

 Q_SIGNALS:
  /// isModified() or file().
  void changed();
  void saved(const QString& file);
  /// One line.
  void failed(const QString& message);

 private:
  /// Labels that are in no file yet.
  struct Labels {
    std::shared_ptr<const LabelMap> map;  ///< null: none are to be written
    std::uint64_t revision = 0;
    std::filesystem::path file;
  };
  struct Written {
    std::filesystem::path file;
    io::Session session;  ///< with its data's contents
    Labels labels;
    bool automatic = false;
    std::string error;  ///< empty: written
  };
  void write(std::shared_ptr<const io::Session> session, const std::filesystem::path& file, bool automatic);
  /// What has to be written beside `file`. A file of the user's own is not replaced.
  Labels labelsBeside(const std::filesystem::path& file, bool automatic) const;
  void finish();

  Parts parts_;
  WindowPart window_;
  std::filesystem::path file_;
  std::filesystem::path ownLabels_;  ///< the labels that belong to file_ alone; empty: none
  bool recovered_ = false;           ///< the study came from a copy that was never saved
  bool savedWell_ = true;

  QFutureWatcher<Written> writing_;
  bool unfinished_ = false;                    ///< what was written is not acted upon yet
  std::optional<std::filesystem::path> next_;  ///< to save to when the writer is free

  QTimer timer_;
  std::filesystem::path autosaveFolder_, autosaveFile_;
  std::shared_ptr<QLockFile> lock_;            ///< of autosaveFile_
  std::shared_ptr<const io::Session> copied_;  ///< what the copy holds, shared with its writer; null: no copy is known
  std::uint64_t copiedRevision_ = 0;           ///< of the labels in copied_
};

}  // namespace fenestra::viewer
