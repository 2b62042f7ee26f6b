#include "viewer/files/Sessions.h"

#include <QCoreApplication>
#include <QDir>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include "io/TransferFunctionFile.h"
#include "io/archive/Cache.h"
#include "io/session/SessionFile.h"
#include "io/study/ReadStudy.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/dialogs/SpacingDialog.h"
#include "viewer/jobs/StudyLoader.h"
#include "viewer/model/Paths.h"
#include "viewer/model/WayOutText.h"
#include "viewer/model/Workspace.h"
#include "viewer/panels/FileDialog.h"

namespace fenestra::viewer {
namespace {

namespace fs = std::filesystem;

/// Time between two copies: a crash loses a minute of work at most.
constexpr int autosaveMilliseconds = 60000;

FileKind sessionKind() { return {Sessions::tr("Sessions"), QLatin1String(io::sessionEnding)}; }

SessionQuestions::Answer askToSave(QWidget* parent, const QStringList& lost) {
  switch (QMessageBox::question(parent, Sessions::tr("Unsaved work"),
                                Sessions::tr("These changes since the last save would be lost. Save them?") +
                                    QStringLiteral("\n\n") + lost.join(QLatin1Char('\n')),
                                QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save)) {
    case QMessageBox::Save:
      return SessionQuestions::Answer::Save;
    case QMessageBox::Discard:
      return SessionQuestions::Answer::Discard;
    default:
      return SessionQuestions::Answer::Cancel;
  }
}

std::optional<fs::path> askForData(QWidget* parent, const io::DataMissing& missing) {
  const bool labels = missing.data() == io::DataMissing::Data::Labels;
  QMessageBox box(
      QMessageBox::Question, Sessions::tr("Where is the data now?"),
      labels ? Sessions::tr("The session's label map is needed.") : Sessions::tr("The session's volume is needed."),
      QMessageBox::Cancel, parent);
  QString cause = QString::fromStdString(missing.cause());
  if (!cause.isEmpty()) cause[0] = cause[0].toUpper();
  box.setInformativeText(cause + QLatin1Char('.'));
  const QPushButton* file = box.addButton(Sessions::tr("Choose a file…"), QMessageBox::AcceptRole);
  const QPushButton* folder =
      labels ? nullptr : box.addButton(Sessions::tr("Choose a folder…"), QMessageBox::AcceptRole);
  box.exec();
  const QString from = toQString(missing.file().parent_path());
  if (box.clickedButton() == file) return askForFile(parent, {Sessions::tr("The data"), {}, from});
  if (folder && box.clickedButton() == folder)
    return askForFolder(parent, {Sessions::tr("The data's folder"), {}, from});
  return std::nullopt;
}

std::optional<glm::dvec3> askForVoxelSize(QWidget* parent, const io::SpacingMissing& missing) {
  SpacingDialog ask(Sessions::tr("%1 %2. Say it here:")
                        .arg(toQString(missing.file().filename()), QString::fromStdString(missing.cause())),
                    parent);
  if (ask.exec() != QDialog::Accepted) return std::nullopt;
  return ask.spacing();
}

SessionQuestions::Answer askToRestore(QWidget* parent, const QDateTime& saved, const QString& study) {
  const QString when = QLocale::system().toString(saved, QLocale::ShortFormat);
  QMessageBox box(
      QMessageBox::Question, Sessions::tr("Unsaved work"),
      study.isEmpty()
          ? Sessions::tr("Fenestra ended before the session was saved. A copy from %1 can be restored.").arg(when)
          : Sessions::tr("Fenestra ended before the work on %1 was saved. A copy from %2 can be restored.")
                .arg(study, when),
      QMessageBox::NoButton, parent);
  const QPushButton* restore = box.addButton(Sessions::tr("Restore"), QMessageBox::AcceptRole);
  const QPushButton* discard = box.addButton(Sessions::tr("Discard"), QMessageBox::DestructiveRole);
  box.addButton(Sessions::tr("Ask later"), QMessageBox::RejectRole);
  box.exec();
  return box.clickedButton() == restore   ? SessionQuestions::Answer::Save
         : box.clickedButton() == discard ? SessionQuestions::Answer::Discard
                                          : SessionQuestions::Answer::Cancel;
}

/// "Opening (3)", a line for each kind of step, in the order of the history.
QStringList counted(const QStringList& steps) {
  constexpr qsizetype most = 8;
  QStringList kinds = steps, lines;
  kinds.removeDuplicates();
  for (const QString& kind : kinds.mid(0, most))
    lines << (steps.count(kind) > 1 ? QStringLiteral("%1 (%2)").arg(kind).arg(steps.count(kind)) : kind);
  if (kinds.size() > most) lines << Sessions::tr("%n more", nullptr, static_cast<int>(kinds.size() - most));
  return lines;
}

/// What a copy's work was about: its session's file, or else its data; empty where neither has a name.
QString studyOf(const fs::path& copy) try {
  const io::Session session = io::readSession(copy);
  if (!session.autosaveOf.empty()) return toQString(session.autosaveOf.filename());
  if (session.phantom) return QString::fromStdString(session.phantom->name);
  return toQString(session.volume.path.filename());
} catch (const std::exception&) {
  return {};  // opening it says what is wrong
}

/// A request whose region the user can change in the window.
io::StudyRequest editable(io::StudyRequest request) {
  request.acceptsAnyRegion = true;
  return request;
}

/// Whether a path lies where objects of archives are kept, which clears itself and must not hold a user's work.
bool isInArchiveCache(const fs::path& path, const Preferences& preferences) {
  const fs::path chosen = preferences.archiveFolder();
  const fs::path root = chosen.empty() ? io::archive::defaultCacheFolder() : chosen;
  return !root.empty() && *fs::absolute(path).lexically_relative(root).begin() != "..";
}

}  // namespace

SessionQuestions sessionDialogs(QWidget* parent) {
  return {
      .saveChanges = [parent](const QStringList& lost) { return askToSave(parent, lost); },
      .saveWhere = [parent](const fs::path& suggested) -> std::optional<fs::path> {
        const auto file =
            askForNewFile(parent, Sessions::tr("Save the session"), {sessionKind()}, toQString(suggested));
        return file ? std::optional(file->path) : std::nullopt;
      },
      .openWhich =
          [parent] {
            const FileKind kind = sessionKind();
            return askForFile(parent,
                              {Sessions::tr("Open a session"), QStringLiteral("%1 (*%2)").arg(kind.name, kind.ending)});
          },
      .dataWhere = [parent](const io::DataMissing& missing) { return askForData(parent, missing); },
      .voxelSize = [parent](const io::SpacingMissing& missing) { return askForVoxelSize(parent, missing); },
      .restoreWork = [parent](const QDateTime& saved,
                              const QString& study) { return askToRestore(parent, saved, study); },
  };
}

Sessions::Sessions(QWidget& window, Workspace& workspace, StudyLoader& loader, NoticeBar& notices,
                   SessionController::WindowPart part)
    : QObject(&window),
      window_(window),
      workspace_(workspace),
      loader_(loader),
      notices_(notices),
      controller_({workspace.document, workspace.cursor, workspace.planes, workspace.cameras, workspace.placement,
                   workspace.options},
                  std::move(part)),
      questions_(sessionDialogs(&window)) {
  loader_.setMayReplaceLabels([this] { return workspace_.document.labelsAreInFile() || mayGo(); });
  connect(&loader_.job(), &LoadJob::ended, this, [this] {
    if (!loader_.job().isRunning()) discarded_.reset();
  });
  connect(&controller_, &SessionController::changed, this, &Sessions::showTitle);
  connect(&controller_, &SessionController::saved, this, [this](const QString& file) {
    notices_.end(NoticeBar::Subject::Saving);
    workspace_.preferences.addRecent(toPath(file));
  });
  connect(&controller_, &SessionController::failed, this,
          [this](const QString& message) { notices_.addError(NoticeBar::Subject::Saving, message); });
}

void Sessions::studyShown() {
  discarded_.reset();
  controller_.studyOpened();
  if (restoring_ && workspace_.document.study().isRecovered) controller_.adopt(*restoring_);
  restoring_.reset();
}

void Sessions::showTitle() {
  const Document& document = workspace_.document;
  window_.setWindowTitle(document.hasVolume() ? QStringLiteral("%1[*] – Fenestra").arg(document.description())
                                              : QStringLiteral("Fenestra"));
  window_.setWindowModified(controller_.isModified());
}

void Sessions::open(const fs::path& file) {
  open([file] { return editable(io::requestOfSession(file)); });
}

void Sessions::open(Request request) { open(std::move(request), Told{}); }

void Sessions::open(Request request, const Told& told) {
  loader_.open(
      [request, told](const io::Progress& progress) {
        io::StudyRequest asked = request();
        if (!told.data.empty()) asked.data = told.data;
        if (!told.labels.empty()) asked.labels = told.labels;
        if (told.spacing) asked.spacing = told.spacing;
        return io::readStudy(asked, progress);
      },
      [this, request, told](const io::DataMissing& missing) {
        const std::optional<fs::path> there = questions_.dataWhere(missing);
        if (!there) {
          notices_.addError(NoticeBar::Subject::Opening, windowText(missing));
          return;
        }
        Told more = told;
        (missing.data() == io::DataMissing::Data::Labels ? more.labels : more.data) = *there;
        open(request, more);
      },
      [this, request, told](const io::SpacingMissing& missing) {
        Told more = told;
        more.spacing = questions_.voxelSize(missing);
        if (more.spacing) open(request, more);
      });
}

void Sessions::regularise(io::Regularise choice) {
  readAgain([choice](io::StudyRequest& request) { request.regularise = choice; });
}

void Sessions::setModality(std::optional<Modality> modality) {
  // What nobody chose follows the kind: the transfer function and the window that such data start with.
  const SetScene& scene = workspace_.document.study().scene;
  const ContextFunction& context = scene.look.context;
  const bool startsAnew = context.preset == io::defaultPreset(*scene.volume) && context.shift == 0.0;
  const bool hasOwnWindow = workspace_.document.window() != scene.volume->defaultWindow();
  readAgain([modality, startsAnew, hasOwnWindow](io::StudyRequest& request) {
    request.session->volume.modality = modality;
    request.startsContextAnew = startsAnew;
    if (!hasOwnWindow) request.session->window = request.slices.window = std::nullopt;
  });
}

void Sessions::readAgain(const std::function<void(io::StudyRequest&)>& change) {
  if (!workspace_.document.labelsAreInFile()) {
    notices_.addError(
        NoticeBar::Subject::Saving,
        tr("The labels that you kept are in no file yet, and reading the data again would drop them. Save the "
           "session first."));
    return;
  }
  // The choice is a change of a session that has a file, and unsaved work stays unsaved.
  const bool unsaved = controller_.isModified() || !controller_.file().empty();
  io::Session session = controller_.session();
  session.autosaveOf = controller_.file();
  io::StudyRequest request;
  request.path = request.data = session.volume.path;
  request.labels = session.labels.path;
  request.isRecovered = unsaved;
  request.startFrom(std::move(session));
  change(request);
  loader_.open([request = editable(std::move(request))](const io::Progress& progress) {
    return io::readStudy(request, progress);
  });
}

void Sessions::choose() {
  if (const std::optional<fs::path> file = questions_.openWhich(); file && mayGo()) open(*file);
}

bool Sessions::save() {
  if (controller_.file().empty()) return saveAs();
  controller_.save(controller_.file());
  return true;
}

bool Sessions::saveAs() {
  fs::path suggested = controller_.file();
  if (suggested.empty()) {
    const fs::path& data = workspace_.document.study().session.volume.path;
    const bool isPassing = data.empty() || isInArchiveCache(data, workspace_.preferences);
    suggested = (isPassing ? toPath(QDir::homePath()) : fs::absolute(data).parent_path()) / "session";
    suggested += io::sessionEnding;
  }
  std::optional<fs::path> file = questions_.saveWhere(suggested);
  if (!file) return false;
  if (!io::isSession(*file)) *file += io::sessionEnding;
  controller_.save(*file);
  return true;
}

bool Sessions::mayGo() {
  controller_.waitUntilSaved();
  if (!controller_.isModified()) return true;
  const int step = workspace_.document.undoStack().index();
  if (discarded_ == step && loader_.job().isRunning()) return true;
  // Data that is being read waits for the answer, which is about the study that is open now.
  struct Held {
    LoadJob& job;
    explicit Held(LoadJob& held) : job(held) { job.hold(); }
    ~Held() { job.release(); }
  } const held(loader_.job());
  QStringList lost = counted(controller_.unsavedWork());
  if (lost.isEmpty()) lost << tr("The restored work");
  switch (questions_.saveChanges(lost)) {
    case SessionQuestions::Answer::Save:
      return save() && controller_.waitUntilSaved();
    case SessionQuestions::Answer::Discard:
      controller_.dropAutosave();
      discarded_ = step;
      return true;
    case SessionQuestions::Answer::Cancel:
      break;
  }
  return false;
}

void Sessions::leave() { controller_.leaveCopy(); }

void Sessions::setKeepsCopies(bool keeps) {
  keepsCopies_ = keeps;
  if (copiesFolder_.empty()) return;
  if (keeps)
    controller_.startAutosave(copiesFolder_, autosaveMilliseconds);
  else
    controller_.stopAutosave();
}

bool Sessions::startRecovery(const fs::path& folder) {
  copiesFolder_ = folder;
  setKeepsCopies(keepsCopies_);
  for (const AbandonedSession& abandoned : SessionController::abandonedIn(folder)) {
    const bool hides = workspace_.options.hidesPatient();
    switch (questions_.restoreWork(abandoned.saved, hides ? QString() : studyOf(abandoned.file))) {
      case SessionQuestions::Answer::Save:
        restoring_ = abandoned;
        open([file = abandoned.file] {
          io::StudyRequest request = editable(io::requestOfSession(file));
          request.isRecovered = true;
          return request;
        });
        return true;
      case SessionQuestions::Answer::Discard:
        SessionController::removeCopy(abandoned.file);
        break;
      case SessionQuestions::Answer::Cancel:
        break;
    }
  }
  return false;
}

void Sessions::shareCopies(const Sessions& first) {
  copiesFolder_ = first.copiesFolder_;
  setKeepsCopies(keepsCopies_);
}

fs::path Sessions::recoveryFolder() {
  const QString state = qEnvironmentVariable("XDG_STATE_HOME", QDir::homePath() + QStringLiteral("/.local/state"));
  return toPath(state) / "fenestra" / "sessions";
}

}  // namespace fenestra::viewer
