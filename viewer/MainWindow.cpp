#include "viewer/MainWindow.h"

#include <memory>

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QPainter>
#include <QScreen>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "io/study/ReadStudy.h"
#include "rendering/gpu/FocusIndexing.h"
#include "rendering/scene/VisibleFraming.h"
#include "rendering/segmentation/Couch.h"
#include "rendering/settings/FlatStack.h"
#include "viewer/DockFolding.h"
#include "viewer/DockHeights.h"
#include "viewer/StudyNotices.h"
#include "viewer/UndoKeys.h"
#include "viewer/actions/Actions.h"
#include "viewer/archive/ArchiveDock.h"
#include "viewer/bars/LoadingBar.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/bars/StatusBar.h"
#include "viewer/bars/StudyDialogs.h"
#include "viewer/bars/StudyLinkBar.h"
#include "viewer/bars/WaitingBar.h"
#include "viewer/exports/Exports.h"
#include "viewer/exports/PictureExports.h"
#include "viewer/exports/Verification.h"
#include "viewer/files/FileOpener.h"
#include "viewer/files/Sessions.h"
#include "viewer/guide/Guide.h"
#include "viewer/guide/Tour.h"
#include "viewer/guide/WelcomePage.h"
#include "viewer/model/PatientLines.h"
#include "viewer/model/StudyLink.h"
#include "viewer/panels/CamerasPanel.h"
#include "viewer/panels/FileDialog.h"
#include "viewer/panels/ReformatPanel.h"
#include "viewer/panels/SeriesPanel.h"
#include "viewer/results/DeidentifyDialog.h"
#include "viewer/results/ResultsDialog.h"
#include "viewer/style/FocusRing.h"
#include "viewer/style/Style.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {
namespace {

constexpr int layoutVersion = 6;  ///< of docks and toolbars; layouts saved with another version are ignored

/// Adds what the window derives from the voxels. Runs in the background, after the study was read.
void prepare(io::Study& study) {
  SetScene& scene = study.scene;
  if (!scene.table) {
    scene.table = segmentation::tableOf(*scene.volume);
    if (scene.table->count > 0 && scene.look.hideTable) study.warnings.push_back(io::tableWarning());
  }
  const Scene shown = sceneOf(scene);
  if (!study.view) study.visible = visibleFraming(shownVolume(shown), shown.look.context.shifted());
  // A region is looked at where it was clicked; the centre of a bent one may lie outside of it.
  const auto* region = std::get_if<RegionFocus>(&scene.look.focus);
  study.crosshair = region ? region->origin() : focusCentre(shown);
}

void prepareFrame(QMainWindow& window) {
  window.setWindowTitle(QStringLiteral("Fenestra"));
  window.setAcceptDrops(true);
  new FocusRing(&window);
  new UndoKeys(&window);
  window.setDockOptions(QMainWindow::AnimatedDocks | QMainWindow::AllowNestedDocks | QMainWindow::AllowTabbedDocks);
}

}  // namespace

MainWindow::MainWindow(const Setup& setup, QWidget* parent)
    : QMainWindow(parent),
      setup_(setup),
      gl_(setup.gl),
      workspace_(setup.remember ? Preferences::Mode::Stored : Preferences::Mode::Transient),
      loader_(workspace_.document, prepare),
      first_(setup.first),
      link_(first_ ? first_->link_ : std::make_shared<StudyLink>()) {
  if (first_) workspace_.preferences.shareWith(first_->workspace_.preferences);
  if (workspace_.preferences.isOn(Preference::LightTheme)) applyPreference(Preference::LightTheme);
  prepareFrame(*this);

  connectModels();  // before the views connect, so that the models are up to date when a view draws
  views_ = new ViewArea(workspace_, gl_, setup.atRest.value_or(workspace_.preferences.atRest()), setup.chooseSchedule);
  if (setup.expected) views_->warmUp(*setup.expected, static_cast<bool>(setup.openFirst));
  notices_ = new NoticeBar;
  sessions_ = new Sessions(*this, workspace_, loader_, *notices_,
                           {.describe = [this](io::Session& session) { views_->describe(session); },
                            .restore = [this](const io::Session& session) { views_->restore(session); }});
  if (setup.openFirst) setup.openFirst(*this);
  files_ = new FileOpener(*this, workspace_, loader_, *sessions_, *notices_);
  exports_ = new Exports(*this, workspace_.document, workspace_.options, *notices_);
  pictures_ = new PictureExports(*this, workspace_.document, *views_, *notices_);
  verification_ = new Verification(*this, workspace_.document, *views_, *notices_,
                                   [this] { return sessions_->controller().session(); });
  studyNotices_ = new StudyNotices(*this, workspace_, loader_, *files_, *sessions_, *notices_);
  setCentralWidget(makeCentre());
  panels_ = makePanels(*this, workspace_);
  archive_ = new ArchiveDock(*this, workspace_, loader_.job(), [this](const auto& folder) { files_->open({folder}); });
  guide_ = new Guide(*this);
  connect(panels_.folding, &DockFolding::opened, guide_, &Guide::opened);
  connect(welcome_, &WelcomePage::guideRequested, guide_, [this] { guide_->open(); });
  const Actions::Beside beside{*link_, side(), [this] { showOther(); }, [this] { quit(); }};
  const Actions::Dialogs dialogs{[this] { showResultsDialog(); }, [this] { showDeidentifyDialog(); }};
  actions_ = new Actions({*this, workspace_, loader_, grower_, *files_, *exports_, *pictures_, *verification_,
                          *sessions_, *views_, gl_, [this] { closeStudy(); }, [this] { resetLayout(); },
                          [this] { keepKeyImage(); }, dialogs, *panels_.cutaway, *archive_, *guide_, *tour_},
                         beside);
  setStatusBar(new StatusBar(workspace_.document, workspace_.options, *views_, gl_));
  // Below the pictures: a bar above them would resize them, and each click would draw them again.
  // What comes and goes in the status bar must not make the window wider.
  statusBar()->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  statusBar()->addPermanentWidget(new WaitingBar(*views_));
  statusBar()->addPermanentWidget(
      new LoadingBar(grower_.job(), tr("Growing the region"), [this] { grower_.cancel(); }));
  statusBar()->addPermanentWidget(new LoadingBar(labelEditor_.job(), tr("Editing the label")));

  statusBar()->addPermanentWidget(
      new LoadingBar(verification_->job(), tr("Verifying the picture"), [this] { verification_->cancel(); }));

  connectViews();
  connectPanels();
  connectLoader();
  connectBeside();
  // The system's frame around the window is not known before it is shown: a twentieth of the screen is left for it.
  resize(QSize(1440, 900).boundedTo(screen()->availableSize() * 0.95));
  firstState_ = saveState(layoutVersion);
  firstViews_ = views_->saveLayout();
  restoreLayout();
}

// Hiding makes widgets lay out and read the document: do so while the document exists, not in ~QWidget().
MainWindow::~MainWindow() {
  delete results_;  // its worker uses the archive's servers
  hide();
}

QWidget* MainWindow::makeCentre() {
  tour_ = new Tour(workspace_, *views_);
  welcome_ = new WelcomePage(*files_, workspace_, *tour_, gl_);
  pages_ = new QStackedWidget;
  pages_->addWidget(welcome_);
  pages_->addWidget(views_);
  auto* centre = new QWidget;
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(new LoadingBar(loader_.job(), tr("Opening…")));
  column->addWidget(new LoadingBar(exports_->job(), tr("Writing…")));
  column->addWidget(notices_);
  column->addWidget(tour_);
  column->addWidget(new StudyLinkBar(*link_, side()));
  column->addWidget(pages_, 1);
  return centre;
}

void MainWindow::restoreLayout() {
  Preferences& preferences = workspace_.preferences;
  if (!first_) restoreGeometry(preferences.windowGeometry());
  panels_.heights->restore(preferences.openedPanels());
  panels_.folding->restore(preferences.foldedPanels());
  connect(panels_.folding, &DockFolding::changed, this, [this, &preferences] {
    preferences.setFoldedPanels(panels_.folding->folded());
    preferences.setOpenedPanels(panels_.heights->openedLast());
  });
  if (restoreState(preferences.windowState(), layoutVersion)) panels_.heights->keepWhatTheUserChose();
  views_->restoreLayout(preferences.viewLayout());
  workspace_.placement.setSettings(preferences.placement());
  for (const Preference which : {Preference::AnimatedCameras, Preference::PicturesPerSecond, Preference::HidesPatient,
                                 Preference::KeepsCopies, Preference::Neurological})
    applyPreference(which);
  connect(&preferences, &Preferences::changed, this, &MainWindow::applyPreference);
  // Only what the user changes in the panel is remembered: a session's settings are that session's.
  connect(&panels_.cameras->form(), &PlacementForm::edited, this, [&preferences](const auto& change) {
    PlacementSettings habit = preferences.placement();
    change(habit);
    preferences.setPlacement(habit);
  });
}

void MainWindow::applyPreference(Preference which) {
  const int value = workspace_.preferences.value(which);
  switch (which) {
    case Preference::LightTheme:
      return applyStyle(*qApp, value ? Theme::Light : Theme::Dark);
    case Preference::AnimatedCameras:
      return workspace_.cameras.setAnimated(value != 0);
    case Preference::PicturesPerSecond:
      return views_->setPicturesPerSecond(value);
    case Preference::HidesPatient:
      setFileDialogsPrivate(value != 0);
      return workspace_.options.setHidesPatient(value != 0);
    case Preference::KeepsCopies:
      return sessions_->setKeepsCopies(value != 0);
    case Preference::Neurological:
      return workspace_.options.setNeurological(value != 0);
    case Preference::Background:
    case Preference::WidthUnit:
    case Preference::KeepsRecent:
    case Preference::ArchiveGigabytes:
      return;  // takes effect when something is opened
    case Preference::Language:
      return;  // at the next start: texts are set once, when their widgets are made
  }
}

void MainWindow::resetLayout() {
  panels_.heights->restore({});
  workspace_.preferences.setOpenedPanels({});
  panels_.folding->restore({});
  restoreState(firstState_, layoutVersion);
  panels_.heights->reset();
  views_->showAll();
  views_->restoreLayout(firstViews_);
}

void MainWindow::followVolume() {
  link_->end();  // before this study's crosshair and cameras move
  if (!workspace_.document.hasVolume()) return focusSearch_.cancel();
  const io::Study& study = workspace_.document.study();
  const Grid& grid = study.scene.volume->grid;
  ViewLink& cameras = workspace_.cameras;
  workspace_.cursor.setGrid(grid);
  focusSearch_.cancel();
  if (study.crosshair) workspace_.cursor.moveTo(*study.crosshair);
  const Camera first =
      study.view ? study.view->camera : firstCamera(grid, study.visible.value_or(grid), cameras.projection());
  cameras.place({first, secondCamera(first, grid)});
}

void MainWindow::open(StudyLoader::Reader read) { loader_.open(std::move(read)); }

void MainWindow::open(const std::vector<std::filesystem::path>& paths) { files_->open(paths); }

void MainWindow::openLabels(const std::filesystem::path& path) { loader_.openLabels(path); }

void MainWindow::addSample(const QString& name, StudyLoader::SampleReader read) {
  samples_.emplace_back(name, read);
  QAction* sample = actions_->addSample(name, std::move(read));
  welcome_->addSample(*sample);
  if (!tour_->canStart())
    tour_->setPhantom([this, sample] {
      sample->trigger();
      return loader_.job().isRunning();
    });
}

void MainWindow::studyOpened() {
  const io::Study& study = workspace_.document.study();
  pages_->setCurrentWidget(views_);
  notices_->forgetStudy();
  closeStudyDialogs(*this);
  statusBar()->clearMessage();
  tour_->studyOpened();
  sessions_->studyShown();
  const std::filesystem::path& path = study.sessionFile.empty() ? study.session.volume.path : study.sessionFile;
  if (!path.empty()) workspace_.preferences.addRecent(path);
  studyNotices_->show();
  if (study.placed) workspace_.placement.placeAutomatically();
  Q_EMIT opened();
}

void MainWindow::closeStudy() {
  if (link_->isCompared()) {
    close();
    return;
  }
  if (workspace_.document.hasVolume() && sessions_->mayGo()) dropStudy();
}

void MainWindow::dropStudy() {
  loader_.job().cancel();
  if (!workspace_.document.hasVolume()) return;
  grower_.cancel();
  labelEditor_.job().cancel();
  workspace_.placement.cancel();
  workspace_.tool.putDown();
  workspace_.measuring.stop();
  pages_->setCurrentWidget(welcome_);
  workspace_.document.close();
  views_->letGo();
  notices_->forgetStudy();
  closeStudyDialogs(*this);
  statusBar()->clearMessage();
  sessions_->studyShown();
}

void MainWindow::goToFocus() {
  focusSearch_.start([this, scene = workspace_.document.scene()](const io::Progress&) -> LoadJob::Show {
    return [this, centre = focusCentre(scene)] {
      if (centre) workspace_.cursor.moveTo(*centre);
    };
  });
}

bool MainWindow::isIdle() {
  return !loader_.job().isRunning() && !exports_->job().isRunning() && !pictures_->isBusy() &&
         !verification_->isBusy() && !focusSearch_.isRunning() && !grower_.isGrowing() &&
         !labelEditor_.job().isRunning() && !panels_.reformat->isBusy() && !workspace_.placement.isBusy() &&
         !workspace_.cameras.isFlying() && !panels_.cameras->bestViews().isDrawing() && views_->isSettled();
}

void MainWindow::whenDrawn(std::function<void()> done) {
  auto* poll = new QTimer(this);
  connect(poll, &QTimer::timeout, this, [this, poll, done = std::move(done)] {
    workspace_.cameras.finishFlight();
    if (!isIdle()) return;
    static_cast<StatusBar*>(statusBar())->showFrame();  // the last picture may not have reached the screen yet
    poll->stop();
    poll->deleteLater();
    done();
  });
  constexpr int milliseconds = 30;
  poll->start(milliseconds);
}

void MainWindow::offer(const QString& name, std::function<io::StudyRequest()> request) {
  const QString text = tr("%1 was named at the start and is not open.");
  notices_->add(NoticeBar::Kind::Offer, NoticeBar::Subject::Offered, text.arg(name),
                {{tr("Open"),
                  [this, request = std::move(request)] {
                    if (!sessions_->mayGo()) return;
                    notices_->end(NoticeBar::Subject::Offered);
                    sessions_->open(request);
                  }}},
                text.arg(tr("Other data")));
}

void MainWindow::leave() {
  sessions_->leave();
  if (MainWindow* beside = other()) beside->sessions_->leave();
  link_->setCompared(false);  // the panels come back before their state is stored
  storeLayout();
  QCoreApplication::exit(0);
}

void MainWindow::storeLayout() {
  workspace_.preferences.setLayout(alone_.isEmpty() ? saveGeometry() : alone_, saveState(layoutVersion),
                                   views_->saveLayout());
}

QImage MainWindow::picture(Patient patient) {
  ViewOptions& options = workspace_.options;
  if (patient == Patient::Hidden && !options.hidesPatient() &&
      !patientLines(workspace_.document.study().patient, workspace_.document.study().series).isEmpty()) {
    options.setHidesPatient(true);
    QImage without = picture(Patient::Hidden);
    options.setHidesPatient(false);
    return without;
  }
  QPixmap pixmap = grab();
  // grab() paints an OpenGL widget's picture over its marks, so the 3-D views are painted again.
  QPainter painter(&pixmap);
  for (VolumeView* view : views_->volumeViews())
    if (view->isVisible()) painter.drawImage(view->mapTo(this, QPoint(0, 0)), view->grabSurface());
  painter.end();
  return pixmap.toImage();
}

void MainWindow::keepKeyImage() {
  // Without the patient: sessions keep the picture.
  const QImage whole = picture(Patient::Hidden);
  const double scale = whole.devicePixelRatio();
  const QRect area(views_->mapTo(this, QPoint(0, 0)) * scale, views_->size() * scale);
  if (!workspace_.keyImages.add(whole.copy(area)))
    notices_->addError(
        NoticeBar::Subject::Study,
        tr("There are %1 key images; delete some to keep another.").arg(workspace_.document.keyImages().size()));
}

void MainWindow::showResultsDialog() {
  if (!results_) {
    results_ = new ResultsDialog({workspace_.document, workspace_.options, *views_, archive_->archives()}, this);
    results_->setAttribute(Qt::WA_DeleteOnClose);
    markAsStudyDialog(*results_);
  }
  results_->show();
  results_->raise();
  results_->activateWindow();
}

void MainWindow::showDeidentifyDialog() {
  if (!deidentify_) {
    deidentify_ = new DeidentifyDialog(archive_->archives(), workspace_.document, this);
    deidentify_->setAttribute(Qt::WA_DeleteOnClose);
    markAsStudyDialog(*deidentify_);
  }
  deidentify_->show();
  deidentify_->raise();
  deidentify_->activateWindow();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!sessions_->mayGo()) {
    event->ignore();
    return;
  }
  if (link_->isCompared())
    endComparison();
  else
    storeLayout();
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!localPaths(*event->mimeData()).empty() || !SeriesPanel::seriesOf(*event->mimeData()).isEmpty())
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  if (const QString series = SeriesPanel::seriesOf(*event->mimeData()); !series.isEmpty()) {
    event->acceptProposedAction();
    // Opened from the event loop: the drag goes on until the drop has ended, and opening may ask.
    const bool fromBeside = other() && other()->panels_.series->isSourceOf(*event->mimeData());
    if (!fromBeside && !panels_.series->isSourceOf(*event->mimeData())) return;  // of another program
    QTimer::singleShot(0, panels_.series, [this, series, fromBeside] {
      if (fromBeside && other())
        files_->openSeriesOf(other()->workspace_.document.study(), series.toStdString());
      else
        panels_.series->choose(series);
    });
    return;
  }
  const std::vector<std::filesystem::path> paths = localPaths(*event->mimeData());
  if (paths.empty()) return;
  event->acceptProposedAction();
  files_->drop(paths, mapToGlobal(event->position().toPoint()));
}

}  // namespace fenestra::viewer
