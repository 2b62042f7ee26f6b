#pragma once
// Opening and saving sessions as a user does it: the questions that go with it, the title, and work that a crash left.

#include <functional>
#include <memory>
#include <optional>

#include <QObject>

#include "io/session/OpenSession.h"
#include "viewer/model/SessionController.h"

class QWidget;

namespace fenestra::viewer {

class NoticeBar;
class StudyLoader;
struct Workspace;

/// What the user is asked, as dialogs unless replaced.
struct SessionQuestions {
  enum class Answer : std::uint8_t { Save, Discard, Cancel };
  std::function<Answer()> saveChanges;
  /// A file to save to, or none.
  std::function<std::optional<std::filesystem::path>(const std::filesystem::path& suggested)> saveWhere;
  /// A session to open, or none.
  std::function<std::optional<std::filesystem::path>()> openWhich;
  /// Where data are that are not where the session says, or none.
  std::function<std::optional<std::filesystem::path>(const io::DataMissing& missing)> dataWhere;
  /// What to do with work that a crash left; Save restores it, Discard removes it.
  std::function<Answer(const QDateTime& saved)> restoreWork;
};
SessionQuestions sessionDialogs(QWidget* parent);

class Sessions : public QObject {
  Q_OBJECT
 public:
  /// Reads a session's study on another thread; asked again with other places when its data were not found.
  using Reader = std::function<Study(const io::SessionPlaces&, const io::Progress&)>;

  /// `window` is the dialogs' parent, shows the title, and owns this; all others outlive it.
  Sessions(QWidget& window, Workspace& workspace, StudyLoader& loader, NoticeBar& notices,
           SessionController::WindowPart part);

  SessionController& controller() { return controller_; }
  SessionQuestions& questions() { return questions_; }

  void open(const std::filesystem::path& file);
  void open(Reader read);
  /// A study is on show; if it is a session's, the window becomes what that says.
  void studyShown();
  /// Asks which.
  void choose();
  /// To the session's file, or asks for one. False when the user gave up.
  bool save();
  bool saveAs();
  /// Whether what is open may go: it is saved, or the user saves it now, or does not want it. False: it stays.
  bool mayGo();

  /// Keeps copies in `folder` in case of a crash, and offers those that a crash has left; true when one is being
  /// opened.
  bool startRecovery(const std::filesystem::path& folder);
  /// $XDG_STATE_HOME/fenestra/sessions, or what stands for it.
  static std::filesystem::path recoveryFolder();

 private:
  void open(Reader read, io::SessionPlaces places);
  void showTitle();

  QWidget& window_;
  Workspace& workspace_;
  StudyLoader& loader_;
  NoticeBar& notices_;
  SessionController controller_;
  SessionQuestions questions_;
  std::optional<AbandonedSession> restoring_;  ///< being opened
};

}  // namespace fenestra::viewer
