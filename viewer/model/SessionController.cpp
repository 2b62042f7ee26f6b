#include "viewer/model/SessionController.h"

#include <algorithm>
#include <system_error>

#include <QDir>
#include <QFileInfo>
#include <QLockFile>
#include <QUuid>
#include <QtConcurrentRun>

#include "io/LabelWriter.h"
#include "io/session/SessionFile.h"
#include "io/study/SessionData.h"
#include "viewer/model/Paths.h"
#include "viewer/model/PlacementController.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/SlicePlanes.h"
#include "viewer/model/UserWork.h"
#include "viewer/model/ViewLink.h"
#include "viewer/model/ViewOptions.h"

namespace fenestra::viewer {
namespace {

namespace fs = std::filesystem;

io::SessionPlacement sessionFrom(const PlacementSettings& settings) {
  return {.samples = settings.sampling.count,
          .refined = settings.sampling.refined,
          .weights = settings.options.weights,
          .habits = settings.options.habits,
          .inStream = settings.options.region == placement::Region::Stream,
          .streamHalfWidth = settings.options.streamHalfWidth,
          .shareWeight = settings.options.shareWeight,
          .joint = settings.joint,
          .follow = settings.follow,
          .automatic = settings.automatic,
          .byPick = settings.byPick,
          .liveSync = settings.liveSync};
}

PlacementSettings settingsFrom(const io::SessionPlacement& saved, PlacementSettings settings) {
  settings.sampling.count = saved.samples;
  settings.sampling.refined = saved.refined;
  settings.options.weights = saved.weights;
  settings.options.habits = saved.habits;
  settings.options.region = saved.inStream ? placement::Region::Stream : placement::Region::SemiSphere;
  settings.options.streamHalfWidth = saved.streamHalfWidth;
  settings.options.shareWeight = saved.shareWeight;
  settings.joint = saved.joint;
  settings.follow = saved.follow;
  settings.automatic = saved.automatic;
  settings.byPick = saved.byPick;
  settings.liveSync = saved.liveSync;
  return settings;
}

QString lockName(const fs::path& file) { return toQString(file) + QStringLiteral(".lock"); }

/// Where the labels of a session are written; a later number where that name is taken.
fs::path labelsFile(const fs::path& session, int number = 1) {
  fs::path name = session.stem();
  if (number > 1) name += "-" + std::to_string(number);
  name += ".labels.nrrd";
  return fs::absolute(session).parent_path() / name;
}

/// A lock that is stale when the process that took it is gone, however old it is.
std::shared_ptr<QLockFile> lockFor(const fs::path& file) {
  auto lock = std::make_shared<QLockFile>(lockName(file));
  lock->setStaleLockTime(0);
  return lock;
}

}  // namespace

SessionController::SessionController(const Parts& parts, WindowPart window, QObject* parent)
    : QObject(parent), parts_(parts), window_(std::move(window)) {
  connect(&writing_, &QFutureWatcherBase::finished, this, &SessionController::finish);
  connect(&parts_.document.undoStack(), &QUndoStack::cleanChanged, this, &SessionController::changed);
  connect(&parts_.document.undoStack(), &QUndoStack::indexChanged, this, &SessionController::changed);
  connect(&timer_, &QTimer::timeout, this, &SessionController::autosave);
}

SessionController::~SessionController() {
  writing_.disconnect(this);
  writing_.waitForFinished();
  dropAutosave();
}

io::Session SessionController::session() const {
  const Document& document = parts_.document;
  io::Session session = document.study().session;
  session.look = document.look();
  if (!document.labels()) session.labels = {};
  const ViewLink::Pose pose = parts_.cameras.pose();
  for (std::size_t view = 0; view < session.views.size(); ++view) {
    session.views[view].camera = pose.cameras[view];
    session.views[view].fitsWidth = true;
    session.home[view] = pose.home[view];
    session.views[view].frozen = parts_.cameras.frozen()[view];
  }
  session.linked = parts_.cameras.isLinked();
  session.window = document.window();
  session.inverted = document.isInverted();
  session.crosshair = parts_.cursor.position();
  session.planes = parts_.planes.poses();
  session.measures = document.measures();
  session.path = document.path();
  session.followsPath = parts_.options.followsPath();
  session.keyImages = document.keyImages();
  session.overlays = {parts_.options.crosshair(), parts_.options.text(), parts_.options.labels(),
                      parts_.options.measures(), parts_.options.planes()};
  session.placement = sessionFrom(parts_.placement.settings());
  session.autosaveOf.clear();
  window_.describe(session);
  return session;
}

void SessionController::studyOpened() {
  dropAutosave();
  const io::Study& study = parts_.document.study();
  file_ = study.sessionFile;
  ownLabels_ = !file_.empty() && study.session.labels.path == labelsFile(file_) ? labelsFile(file_) : fs::path();
  recovered_ = study.isRecovered;
  copied_.reset();
  parts_.cameras.setFrozen({study.view ? study.view->frozen : std::nullopt, std::nullopt});
  if (study.restoresSession) {
    const io::Session& session = study.session;
    if (!habits_) habits_ = this->session();
    apply(session);
    parts_.cameras.setPose({{session.views[0].camera, session.views[1].camera}, session.home});
    parts_.cameras.setFrozen({session.views[0].frozen, session.views[1].frozen});
    if (session.crosshair) parts_.cursor.moveTo(*session.crosshair);
    parts_.planes.setPoses(session.planes);
    // The quality sphere shows what the cameras were chosen from; they stay.
    if (session.placement.automatic) parts_.placement.measureAlone();
  } else if (habits_) {
    apply(*std::exchange(habits_, std::nullopt));
  }
  Q_EMIT changed();
}

void SessionController::apply(const io::Session& session) {
  parts_.placement.setSettings(settingsFrom(session.placement, parts_.placement.settings()));
  parts_.cameras.setLinked(session.linked);
  parts_.options.setCrosshair(session.overlays.crosshair);
  parts_.options.setText(session.overlays.text);
  parts_.options.setLabels(session.overlays.labels);
  parts_.options.setMeasures(session.overlays.measures);
  parts_.options.setPlanes(session.overlays.planes);
  parts_.options.setFollowsPath(session.followsPath);
  window_.restore(session);
}

QStringList SessionController::unsavedWork() const {
  const QUndoStack& stack = parts_.document.undoStack();
  const int clean = std::max(stack.cleanIndex(), 0);
  QStringList work;
  for (int step = std::min(clean, stack.index()); step < std::max(clean, stack.index()); ++step)
    if (const QString name = stack.text(step); isWork(name, parts_.document.focus())) work << name;
  return work;
}

bool SessionController::isModified() const {
  return parts_.document.hasVolume() && (recovered_ || !unsavedWork().isEmpty());
}

void SessionController::save(const fs::path& file) {
  if (writing_.isRunning()) {
    next_ = file;
    return;
  }
  // Steps that follow are not in the file. Should writing fail, finish() marks all steps as unsaved.
  parts_.document.undoStack().setClean();
  recovered_ = false;
  write(std::make_shared<const io::Session>(session()), file, false);
  Q_EMIT changed();
}

bool SessionController::waitUntilSaved() {
  do {
    writing_.waitForFinished();
    finish();
  } while (writing_.isRunning());
  return savedWell_;
}

SessionController::Labels SessionController::labelsBeside(const fs::path& file, bool automatic) const {
  const Document& document = parts_.document;
  if (document.labelsAreInFile()) return {};
  int number = 1;
  std::error_code unknown;
  while (!automatic && fs::exists(labelsFile(file, number), unknown) && labelsFile(file, number) != ownLabels_)
    ++number;
  return {document.labels(), document.labelsRevision(), labelsFile(file, number)};
}

void SessionController::write(std::shared_ptr<const io::Session> session, const fs::path& file, bool automatic) {
  unfinished_ = true;
  const Labels labels = labelsBeside(file, automatic);
  writing_.setFuture(QtConcurrent::run([session = std::move(session), labels, file, automatic]() -> Written {
    Written written{file, *session, labels, automatic, {}};
    try {
      if (labels.map) {
        io::writeLabels(*labels.map, labels.file);
        written.session.labels = io::sessionLabels(labels.file);
      }
      io::noteContents(written.session);
      io::writeSession(file, written.session);
    } catch (const std::exception& error) {
      written.error = error.what();
    }
    return written;
  }));
}

void SessionController::finish() {
  if (!std::exchange(unfinished_, false)) return;
  const Written written = writing_.result();
  parts_.document.noteContents(written.session);
  if (written.automatic) {
    // A failed copy is tried again in silence; the user's own save reports the problem.
    if (!written.error.empty()) copied_.reset();
  } else {
    savedWell_ = written.error.empty();
    if (savedWell_) {
      file_ = written.file;
      if (written.labels.map) {
        ownLabels_ = written.labels.file;
        parts_.document.noteLabelsFile(written.labels.revision, written.session.labels);
      }
      if (!isModified()) dropAutosave();
      Q_EMIT saved(toQString(written.file));
    } else {
      parts_.document.undoStack().resetClean();
      Q_EMIT failed(QString::fromStdString(written.error));
    }
    Q_EMIT changed();
  }
  if (const auto next = std::exchange(next_, std::nullopt)) save(*next);
}

void SessionController::startAutosave(const fs::path& folder, int milliseconds) {
  QDir().mkpath(toQString(folder));
  autosaveFolder_ = folder;
  timer_.start(milliseconds);
}

void SessionController::stopAutosave() {
  timer_.stop();
  autosaveFolder_.clear();
  dropAutosave();
}

void SessionController::autosave() {
  if (autosaveFolder_.empty() || writing_.isRunning() || !isModified()) return;
  io::Session gathered = session();
  gathered.autosaveOf = file_;
  const std::uint64_t revision = parts_.document.labelsRevision();
  if (copied_ && *copied_ == gathered && copiedRevision_ == revision) return;
  if (autosaveFile_.empty()) {
    const fs::path file =
        autosaveFolder_ / (QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString() + io::sessionEnding);
    auto lock = lockFor(file);
    if (!lock->tryLock(0)) return;
    lock_ = std::move(lock);
    autosaveFile_ = file;
  }
  copied_ = std::make_shared<const io::Session>(std::move(gathered));
  copiedRevision_ = revision;
  write(copied_, autosaveFile_, true);
}

std::vector<AbandonedSession> SessionController::abandonedIn(const fs::path& folder) {
  std::vector<AbandonedSession> found;
  const QFileInfoList files =
      QDir(toQString(folder)).entryInfoList({QStringLiteral("*%1").arg(QLatin1String(io::sessionEnding))}, QDir::Files);
  for (const QFileInfo& file : files) {
    const fs::path path = toPath(file.filePath());
    auto lock = lockFor(path);
    if (lock->tryLock(0)) found.push_back({path, file.lastModified(), std::move(lock)});
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.saved > b.saved; });
  return found;
}

void SessionController::adopt(const AbandonedSession& abandoned) {
  autosaveFile_ = abandoned.file;
  lock_ = abandoned.lock;
  // The labels beside the copy are removed with it.
  if (parts_.document.study().session.labels.path == labelsFile(abandoned.file)) parts_.document.noteLabelsFile(0, {});
}

void SessionController::dropAutosave() {
  if (autosaveFile_.empty()) return;
  removeCopy(autosaveFile_);
  autosaveFile_.clear();
  copied_.reset();
  lock_.reset();
}

void SessionController::leaveCopy() {
  waitUntilSaved();
  autosave();
  writing_.waitForFinished();
  if (!isModified()) return dropAutosave();
  autosaveFile_.clear();
  lock_.reset();
}

void SessionController::removeCopy(const fs::path& file) {
  std::error_code ignored;
  fs::remove(file, ignored);
  fs::remove(labelsFile(file), ignored);
}

}  // namespace fenestra::viewer
