#pragma once
// The session of the window: its file, whether it has unsaved changes, and copies that are saved automatically in case
// of a crash. A save gathers a plain io::Session; a worker hashes the data and writes. Labels that are in no file yet
// are written beside the session, as NAME.labels.nrrd.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QFutureWatcher>
#include <QObject>
#include <QStringList>
#include <QTimer>

#include "io/session/Session.h"
#include "viewer/model/Document.h"

class QLockFile;

namespace fenestra::viewer {

class PlacementController;
class SliceCursor;
class SlicePlanes;
class ViewLink;
class ViewOptions;

/// A copy that a crashed run has left behind.
struct AbandonedSession {
  std::filesystem::path file;
  QDateTime saved;
  std::shared_ptr<QLockFile> lock;  ///< held, so that no other run offers the copy, too
};

class SessionController : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    SliceCursor& cursor;
    SlicePlanes& planes;
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
  /// Waits for running saves, and removes the copy saved in case of a crash.
  ~SessionController() override;

  /// The session as it stands.
  io::Session session() const;
  /// To be called after a study was opened. Restores the window from the study's session, if it has one.
  void studyOpened();

  /// Where the session was opened from or saved to; empty before.
  const std::filesystem::path& file() const { return file_; }
  /// The steps since the last save that a user would have to do again, by their names in the order of the history. What
  /// one click does again is none: another camera, or a focus of one structure or one seed.
  QStringList unsavedWork() const;
  /// There is unsavedWork(), or the study is a copy that was never saved.
  bool isModified() const;
  /// Writes on another thread; saved() or failed() follows. One save at a time: a second waits for the first.
  void save(const std::filesystem::path& file);
  /// Blocks until nothing is being written; false when the last save failed.
  bool waitUntilSaved();

  /// From now on, unsaved changes are copied to `folder` every `milliseconds`. The folder is made when it is missing.
  void startAutosave(const std::filesystem::path& folder, int milliseconds);
  /// Also drops the present copy.
  void stopAutosave();
  /// Copies now, if there is something new to copy. Only gathering the session holds the window up.
  void autosave();
  /// Copies in `folder` whose run has ended without removing them, the latest first.
  static std::vector<AbandonedSession> abandonedIn(const std::filesystem::path& folder);
  /// Takes such a copy over: it is removed when this session is saved or given up.
  void adopt(const AbandonedSession& abandoned);
  /// Removes the present session's copy, because its contents were saved or discarded.
  void dropAutosave();
  /// Copies unsaved work now and leaves the copy behind, as a crash does: the program is being ended and cannot ask.
  void leaveCopy();
  /// Removes a copy and the labels beside it.
  static void removeCopy(const std::filesystem::path& file);

 Q_SIGNALS:
  /// isModified() or file() has changed.
  void changed();
  void saved(const QString& file);
  /// `message` is one line.
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
  /// The labels to be written beside `file`. The user's own files are never replaced.
  Labels labelsBeside(const std::filesystem::path& file, bool automatic) const;
  void finish();
  /// Takes over what a session says of the window beside the study: cameras and overlays, or the overlays alone.
  void apply(const io::Session& session);

  Parts parts_;
  WindowPart window_;
  std::filesystem::path file_;
  std::filesystem::path ownLabels_;  ///< the labels that belong to file_ alone; empty: none
  /// What a window was like before a session took it over; the next study without a session gets it back.
  std::optional<io::Session> habits_;
  bool recovered_ = false;  ///< the study came from a copy that was never saved
  bool savedWell_ = true;

  QFutureWatcher<Written> writing_;
  bool unfinished_ = false;                    ///< finish() has not handled the last write yet
  std::optional<std::filesystem::path> next_;  ///< where to save once the writer is free

  QTimer timer_;
  std::filesystem::path autosaveFolder_, autosaveFile_;
  std::shared_ptr<QLockFile> lock_;            ///< locks autosaveFile_
  std::shared_ptr<const io::Session> copied_;  ///< the copy's contents, shared with its writer; null: no copy is known
  std::uint64_t copiedRevision_ = 0;           ///< revision of the labels in copied_
};

}  // namespace fenestra::viewer
