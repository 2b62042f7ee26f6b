#pragma once
// Opens and saves sessions as a user does it: asks the questions, shows the window's title, and recovers work after a
// crash.

#include <functional>
#include <memory>
#include <optional>

#include <QObject>

#include "io/study/SessionData.h"
#include "io/study/StudyRequest.h"
#include "viewer/model/SessionController.h"

class QWidget;

namespace fenestra::viewer {

class NoticeBar;
class StudyLoader;
struct Workspace;

/// The questions to the user: dialogs, unless a test replaces them.
struct SessionQuestions {
  enum class Answer : std::uint8_t { Save, Discard, Cancel };
  /// `lost`: what would be lost, a line for each kind of step.
  std::function<Answer(const QStringList& lost)> saveChanges;
  /// A file to save to, or none.
  std::function<std::optional<std::filesystem::path>(const std::filesystem::path& suggested)> saveWhere;
  /// A session to open, or none.
  std::function<std::optional<std::filesystem::path>()> openWhich;
  /// Where the data is that the session does not find, or none.
  std::function<std::optional<std::filesystem::path>(const io::DataMissing& missing)> dataWhere;
  /// How large voxels are, mm, of a file that does not say it; or none.
  std::function<std::optional<glm::dvec3>(const io::SpacingMissing& missing)> voxelSize;
  /// What to do with work recovered after a crash: Save restores it, Discard removes it.
  /// `study` names what was worked on; empty where that may name the patient, who is hidden.
  std::function<Answer(const QDateTime& saved, const QString& study)> restoreWork;
};
SessionQuestions sessionDialogs(QWidget* parent);

class Sessions : public QObject {
  Q_OBJECT
 public:
  /// What to read, told on the reading thread. Called again when the data was not found and the user says where it is.
  using Request = std::function<io::StudyRequest()>;

  /// `window` is the dialogs' parent, shows the title, and owns this; all others outlive it.
  Sessions(QWidget& window, Workspace& workspace, StudyLoader& loader, NoticeBar& notices,
           SessionController::WindowPart part);

  SessionController& controller() { return controller_; }
  SessionQuestions& questions() { return questions_; }

  void open(const std::filesystem::path& file);
  void open(Request request);
  /// Reads the open study's slices again and places them in another way. The history is cleared; everything else stays
  /// as it is.
  void regularise(io::Regularise choice);
  /// Reads it again as data of that kind; unset: as its file says.
  void setModality(std::optional<Modality> modality);
  /// To be called when the window shows a new study. Restores the window from the study's session, if it has one.
  void studyShown();
  /// Asks for a session and opens it.
  void choose();
  /// Saves to the session's file; without one, asks for it. False when the user cancels.
  bool save();
  bool saveAs();
  /// Whether the open study may be closed: it is saved, or the user saves it now or discards the changes.
  /// While other data is read, what was discarded for it is not asked about again.
  bool mayGo();
  /// The program is being ended and cannot ask: unsaved work is left behind as a copy, for the next start to offer.
  void leave();

  /// Whether unsaved work is copied in case of a crash, once startRecovery() says where.
  void setKeepsCopies(bool keeps);
  /// Starts saving copies to `folder`, and offers to restore the copies of a run that crashed. True when the user
  /// restores one.
  bool startRecovery(const std::filesystem::path& folder);
  /// Saves copies where another window of this run does, whose startRecovery() has asked for those of earlier runs.
  void shareCopies(const Sessions& first);
  /// $XDG_STATE_HOME/fenestra/sessions; ~/.local/state replaces an unset variable.
  static std::filesystem::path recoveryFolder();

 private:
  /// Reads the open study's files again after `change`; everything else stays as it is.
  void readAgain(const std::function<void(io::StudyRequest&)>& change);
  /// What the user has said of the data so far; empty: nothing.
  struct Told {
    std::filesystem::path data, labels;
    std::optional<glm::dvec3> spacing;
  };
  void open(Request request, const Told& told);
  void showTitle();

  QWidget& window_;
  Workspace& workspace_;
  StudyLoader& loader_;
  NoticeBar& notices_;
  SessionController controller_;
  std::filesystem::path copiesFolder_;  ///< empty before startRecovery()
  bool keepsCopies_ = true;
  SessionQuestions questions_;
  std::optional<AbandonedSession> restoring_;  ///< the copy being opened
  std::optional<int> discarded_;  ///< where the history stood when its work was given up for data that is being read
};

}  // namespace fenestra::viewer
