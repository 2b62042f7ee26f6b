#include "viewer/MainWindow.h"

#include <cmath>

#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QVBoxLayout>

#include "io/session/SessionFile.h"
#include "viewer/Actions.h"
#include "viewer/Dialogs.h"
#include "viewer/NoticeBar.h"
#include "viewer/Sessions.h"
#include "viewer/Style.h"
#include "viewer/model/CamerasChange.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/BrushPanel.h"
#include "viewer/panels/CamerasPanel.h"
#include "viewer/panels/ContextLayerPanel.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/views/PlacementRenderer.h"

namespace fenestra::viewer {
namespace {

constexpr int layoutVersion = 3;  ///< of the docks and toolbars; a saved layout of another version is not restored

/// "L 12.3  P 45.0  S 101.2 mm": the patient's own directions instead of signs.
QString patientCoordinates(glm::dvec3 world) {
  const auto one = [](double value, char positive, char negative) {
    return QStringLiteral("%1 %2").arg(QLatin1Char(value < 0.0 ? negative : positive)).arg(std::abs(value), 0, 'f', 1);
  };
  return QStringLiteral("%1   %2   %3 mm").arg(one(world.x, 'L', 'R'), one(world.y, 'P', 'A'), one(world.z, 'S', 'I'));
}

QString nameOf(const Label& label) {
  return label.name.empty() ? MainWindow::tr("label %1").arg(label.value) : QString::fromStdString(label.name);
}

QString describe(const io::SeriesInfo& series) {
  return QStringLiteral("%1 %2×%3×%4")
      .arg(QString::fromStdString(series.modality))
      .arg(series.dims.x)
      .arg(series.dims.y)
      .arg(series.dims.z)
      .trimmed();
}

/// A clause as a sentence.
QString sentence(const std::string& clause) {
  QString text = QString::fromStdString(clause);
  if (text.isEmpty()) return text;
  text[0] = text[0].toUpper();
  return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

std::vector<std::filesystem::path> localPaths(const QMimeData& data) {
  std::vector<std::filesystem::path> paths;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile()) paths.push_back(toPath(url.toLocalFile()));
  return paths;
}

}  // namespace

MainWindow::MainWindow(const Setup& setup, QWidget* parent)
    : QMainWindow(parent), setup_(setup), placement_(document_, cameras_) {
  setWindowTitle(QStringLiteral("Fenestra"));
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);

  // A new volume moves crosshair and cameras before any view draws it.
  connect(&document_, &Document::volumeChanged, this, [this] {
    const Study& study = document_.study();
    const Grid& grid = study.scene.volume->grid;
    cursor_.setGrid(grid);
    goToFocus();
    cameras_.place(study.camera.value_or(Camera::standard(StandardView::Anterior, grid, cameras_.projection())));
  });

  views_ = new ViewArea(document_, cursor_, cameras_, options_, brush_, setup.gl,
                        setup.atRest.value_or(setup.remember ? preferences_.atRest() : Effort{}));
  if (setup.gl.available) placement_.setBackend(std::make_unique<PlacementRenderer>(*views_->volumeViews().front()));
  notices_ = new NoticeBar;
  pages_ = new QStackedWidget;
  pages_->addWidget(makeWelcome());
  pages_->addWidget(views_);
  auto* centre = new QWidget;
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeLoadingBar());
  column->addWidget(notices_);
  column->addWidget(pages_, 1);
  setCentralWidget(centre);

  makeDocks();
  sessions_ = new Sessions(*this, {.describe = [this](io::Session& session) { views_->describe(session); },
                                   .restore = [this](const io::Session& session) { views_->restore(session); }});
  actions_ = new Actions(*this);
  makeStatusBar();

  // Pictures at full quality would be of cameras that are about to leave.
  connect(&placement_, &PlacementController::changed, this, [this] {
    for (VolumeView* view : views_->volumeViews()) view->hold(placement_.isBusy());
  });
  connect(&placement_, &PlacementController::leaving, this,
          [this] { document_.history().push(tr("Place cameras"), std::make_shared<CamerasChange>(cameras_)); });
  connect(views_, &ViewArea::pointed, this, &MainWindow::pointAt);
  connect(views_, &ViewArea::left, pointer_, &QLabel::clear);
  connect(views_, &ViewArea::menuRequested, this, &MainWindow::showMenu);
  connect(views_, &ViewArea::failed, this, &MainWindow::showError, Qt::QueuedConnection);
  connect(focusPanel_, &FocusPanel::structureChosen, this, &MainWindow::goToFocus);
  connect(appearancePanel_, &AppearancePanel::failed, this, &MainWindow::showError);
  connect(brushPanel_, &BrushPanel::failed, this, &MainWindow::showError);
  connect(&job_, &LoadJob::started, this, [this] {
    loadingText_->setText(tr("Opening…"));
    loadingProgress_->setValue(0);
    loadingBar_->show();
  });
  connect(&job_, &LoadJob::progressed, this, [this](double fraction, const QString& doing) {
    if (!doing.isEmpty()) loadingText_->setText(doing);
    loadingProgress_->setValue(static_cast<int>(100.0 * fraction));
  });
  connect(&job_, &LoadJob::failed, this, [this](const QString& message) {
    showError(message);
    Q_EMIT failed(message);
  });
  connect(&job_, &LoadJob::ended, this, [this] { loadingBar_->setVisible(job_.isRunning()); });
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (const auto* view = qobject_cast<VolumeView*>(now)) lastCamera_ = view->index();
  });

  resize(1440, 900);
  if (setup_.remember) {
    restoreGeometry(preferences_.windowGeometry());
    restoreState(preferences_.windowState(), layoutVersion);
    views_->restoreLayout(preferences_.viewLayout());
    placement_.setSettings(preferences_.placement());
    // What a session brings with it is that session's, not the user's habit.
    connect(camerasPanel_, &CamerasPanel::edited, this, [this](const auto& change) {
      PlacementSettings habit = preferences_.placement();
      change(habit);
      preferences_.setPlacement(habit);
    });
  }
}

QWidget* MainWindow::makeWelcome() {
  auto* page = new QFrame;
  page->setObjectName(QStringLiteral("welcome"));
  auto* title = new QLabel(QStringLiteral("Fenestra"));
  QFont large = title->font();
  large.setPointSizeF(large.pointSizeF() * 2.2);
  title->setFont(large);
  auto* text = new QLabel(tr("Drop a DICOM folder, NIfTI, NRRD or MetaImage file here."));
  auto* folder = new QPushButton(icon("folder"), tr("Open a folder…"));
  auto* file = new QPushButton(icon("file"), tr("Open a file…"));
  connect(folder, &QPushButton::clicked, this, &MainWindow::chooseFolder);
  connect(file, &QPushButton::clicked, this, &MainWindow::chooseFile);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(folder);
  buttons->addWidget(file);
  buttons->addStretch();
  auto* column = new QVBoxLayout(page);
  column->setSpacing(16);
  column->addStretch();
  column->addWidget(title, 0, Qt::AlignHCenter);
  column->addWidget(text, 0, Qt::AlignHCenter);
  column->addLayout(buttons);
  column->addStretch();
  return page;
}

QWidget* MainWindow::makeLoadingBar() {
  loadingBar_ = new QWidget;
  loadingText_ = new QLabel;
  loadingProgress_ = new QProgressBar;
  loadingProgress_->setRange(0, 100);
  loadingProgress_->setTextVisible(false);
  auto* cancel = new QPushButton(tr("Cancel"));
  connect(cancel, &QPushButton::clicked, &job_, &LoadJob::cancel);
  auto* row = new QHBoxLayout(loadingBar_);
  row->setContentsMargins(10, 5, 6, 5);
  row->addWidget(loadingText_, 1);
  row->addWidget(loadingProgress_, 2);
  row->addWidget(cancel);
  loadingBar_->hide();
  return loadingBar_;
}

void MainWindow::makeDocks() {
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  focusPanel_ = new FocusPanel(document_);
  appearancePanel_ = new AppearancePanel(document_);
  cutawayPanel_ = new CutawayPanel(document_);
  contextLayerPanel_ = new ContextLayerPanel(document_);
  camerasPanel_ = new CamerasPanel(document_, cameras_, placement_);
  brushPanel_ = new BrushPanel(document_, brush_);
  const auto add = [this](const QString& title, const char* name, QWidget* panel) {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(QLatin1String(name));
    dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    dock->setWidget(panel);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    return dock;
  };
  QDockWidget* focus = add(tr("Focus"), "focusDock", focusPanel_);
  tabifyDockWidget(focus, add(tr("Cameras"), "camerasDock", camerasPanel_));
  QDockWidget* brush = add(tr("Brush"), "brushDock", brushPanel_);
  tabifyDockWidget(focus, brush);
  focus->raise();
  connect(&brush_, &Brush::activeChanged, brush, [brush](bool active) {
    if (!active) return;
    brush->show();
    brush->raise();
  });
  add(tr("Context"), "contextDock", appearancePanel_);
  QDockWidget* cutaway = add(tr("Cutaway"), "cutawayDock", cutawayPanel_);
  tabifyDockWidget(cutaway, add(tr("Context edges"), "contextLayerDock", contextLayerPanel_));
  cutaway->raise();
  // The list of structures takes the height that is left.
  for (QWidget* panel : std::initializer_list<QWidget*>{appearancePanel_, cutawayPanel_, contextLayerPanel_})
    panel->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  resizeDocks({focus}, {310}, Qt::Horizontal);
}

void MainWindow::makeStatusBar() {
  pointer_ = new QLabel;
  pointer_->setTextFormat(Qt::PlainText);
  statusBar()->addWidget(pointer_, 1);
  if (setup_.gl.software) {
    auto* software = new QLabel(tr("Software OpenGL: smaller pictures while moving"));
    software->setToolTip(setup_.gl.renderer);
    statusBar()->addPermanentWidget(software);
  } else if (!setup_.gl.available) {
    statusBar()->addPermanentWidget(new QLabel(tr("No OpenGL: slices only")));
  }
  frame_ = new QLabel;
  frame_->setToolTip(tr("Time from the start of the last picture until it was on screen, and how finely it was drawn"));
  statusBar()->addPermanentWidget(frame_);
  connect(views_, &ViewArea::drawn, this, &MainWindow::showFrame);
  statusBar()->addPermanentWidget(new QLabel(tr("Radiological convention")));
}

void MainWindow::showFrame() {
  const std::optional<FramePacer::Measured>& last = views_->pacer().last();
  if (!last) return;
  const double milliseconds = last->milliseconds;
  QString text = milliseconds < 1000.0 ? tr("%1 ms").arg(milliseconds, 0, 'f', milliseconds < 10.0 ? 1 : 0)
                                       : tr("%1 s").arg(milliseconds / 1000.0, 0, 'f', 1);
  if (last->effort.scale < 1.0)
    text += tr(", %1 % size").arg(100.0 * last->effort.scale, 0, 'f', 0);
  else
    text += QStringLiteral(", ") + nameOf(last->effort);
  frame_->setText(text);
}

void MainWindow::setAtRest(const Effort& effort) {
  views_->setAtRest(effort.quality, effort.maxError);
  if (setup_.remember) preferences_.setAtRest(effort);
}

void MainWindow::open(Reader read, std::function<void(const io::DataMissing&)> missing) {
  job_.start(
      [this, read = std::move(read), missing = std::move(missing)](const io::Progress& progress) -> LoadJob::Show {
        try {
          // Shared, because what is handed to the GUI thread must be copyable.
          auto study = std::make_shared<Study>(read(progress));
          return [this, study] { showStudy(std::move(*study)); };
        } catch (const io::DataMissing& error) {
          if (!missing) throw;
          // Not from within the job's end: a dialog would keep it from ending.
          return [this, missing, error] { QTimer::singleShot(0, this, [missing, error] { missing(error); }); };
        }
      });
}

void MainWindow::open(const std::vector<std::filesystem::path>& paths) {
  if (!sessions_->mayGo()) return;
  if (paths.size() == 1 && io::isSession(paths.front())) {
    sessions_->open(paths.front());
    return;
  }
  try {
    const PathsToOpen chosen = interpret(paths);
    open([chosen, look = document_.scene().look](const io::Progress& progress) {
      return readStudy(chosen, look, progress);
    });
  } catch (const io::Error& error) {
    showError(QString::fromUtf8(error.what()));
  }
}

void MainWindow::openSeries(const std::string& series) {
  if (!sessions_->mayGo()) return;
  PathsToOpen chosen;
  chosen.volume = document_.study().path;
  chosen.series = series;
  open([chosen, look = document_.scene().look](const io::Progress& progress) {
    return readStudy(chosen, look, progress);
  });
}

void MainWindow::openLabels(const std::filesystem::path& path) {
  job_.start([this, path, volume = document_.scene().volume](const io::Progress& progress) -> LoadJob::Show {
    const io::OpenedLabels opened = io::openLabels(path, volume->grid, progress);
    return [this, opened, from = io::sessionLabels(path)] {
      document_.setLabels(opened.labels, from);
      showWarnings(opened.warnings);
    };
  });
}

void MainWindow::addSample(const QString& name, Reader read) {
  actions_->addSample(name, [this, read = std::move(read)] {
    if (sessions_->mayGo()) open(read);
  });
}

void MainWindow::showStudy(Study study) {
  const std::filesystem::path path = study.sessionFile.empty() ? study.path : study.sessionFile;
  const std::vector<io::Warning> warnings = study.warnings;
  document_.open(std::move(study));
  pages_->setCurrentWidget(views_);
  notices_->clear();
  sessions_->studyShown();
  rememberRecent(path);
  const std::size_t others = document_.study().otherSeries.size();
  if (others > 0 && !document_.study().restoresSession)
    notices_->add(NoticeBar::Kind::Warning,
                  tr("There are %1 series here; this is the largest, %2.")
                      .arg(others + 1)
                      .arg(describe(document_.study().series)),
                  tr("Choose…"), [this] { chooseSeries(); });
  showWarnings(warnings);
  if (document_.study().placeCameras) placement_.placeAutomatically();
  Q_EMIT opened();
}

void MainWindow::showWarnings(const std::vector<io::Warning>& warnings) {
  for (const io::Warning& warning : warnings) {
    const QString text = sentence(warning.text);
    if (warning.files.empty()) {
      notices_->add(NoticeBar::Kind::Warning, text);
      continue;
    }
    QStringList files;
    for (const std::filesystem::path& file : warning.files) files << toQString(file);
    notices_->add(NoticeBar::Kind::Warning, text, tr("Files…"), [this, text, files] {
      QMessageBox box(QMessageBox::Information, tr("Files concerned"), text, QMessageBox::Close, this);
      box.setDetailedText(files.join(QLatin1Char('\n')));
      box.exec();
    });
  }
}

void MainWindow::rememberRecent(const std::filesystem::path& path) {
  if (setup_.remember && !path.empty()) preferences_.addRecent(path);
}

void MainWindow::showError(const QString& message) { notices_->add(NoticeBar::Kind::Error, message); }

void MainWindow::chooseFile() {
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Open a volume"), {},
      tr("Volumes (*.dcm *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.hdr *.img);;All files (*)"));
  if (!file.isEmpty()) open({toPath(file)});
}

void MainWindow::chooseFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Open a DICOM folder"));
  if (!folder.isEmpty()) open({toPath(folder)});
}

void MainWindow::chooseLabels() {
  const QString file = QFileDialog::getOpenFileName(
      this, tr("Open a label map"), {}, tr("Label maps (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd);;All files (*)"));
  if (!file.isEmpty()) openLabels(toPath(file));
}

void MainWindow::chooseSeries() {
  if (const std::optional<std::string> series = askForSeries(document_.study(), this)) openSeries(*series);
}

void MainWindow::pointAt(glm::dvec3 world) {
  const std::optional<glm::ivec3> voxel = document_.voxelAt(world);
  if (!voxel) {
    pointer_->clear();
    return;
  }
  const Volume& volume = *document_.scene().volume;
  const int decimals = volume.range.high - volume.range.low < 20.0 ? 3 : 0;
  QStringList parts{QStringLiteral("%1 %2")
                        .arg(volume.value(*voxel), 0, 'f', decimals)
                        .arg(QString::fromStdString(volume.unit))
                        .trimmed(),
                    patientCoordinates(world)};
  if (const Label* label = document_.labelAt(world)) parts << nameOf(*label);
  pointer_->setText(parts.join(QStringLiteral("     ")));
}

void MainWindow::showMenu(glm::dvec3 world, QPoint globalPosition) {
  QMenu menu;
  if (const Label* label = document_.labelAt(world)) {
    const std::uint16_t value = label->value;
    connect(menu.addAction(tr("Focus on %1").arg(nameOf(*label))), &QAction::triggered, this,
            [this, value] { document_.focusOn(value); });
    const bool focused = document_.isFocused(value);
    connect(menu.addAction(focused ? tr("Take %1 out of the focus").arg(nameOf(*label))
                                   : tr("Add %1 to the focus").arg(nameOf(*label))),
            &QAction::triggered, this, [this, value, focused] { document_.setFocused(value, !focused); });
    menu.addSeparator();
  }
  connect(menu.addAction(tr("Crosshair here")), &QAction::triggered, this, [this, world] { cursor_.moveTo(world); });
  QAction* none = menu.addAction(tr("No focus"));
  none->setEnabled(!std::holds_alternative<std::monostate>(document_.focus()));
  connect(none, &QAction::triggered, this, [this] { document_.setFocus(std::monostate{}); });
  menu.exec(globalPosition);
}

void MainWindow::goToFocus() {
  if (const std::optional<glm::dvec3> centre = document_.focusCentre()) cursor_.moveTo(*centre);
}

void MainWindow::stop() {
  if (job_.isRunning())
    job_.cancel();
  else if (placement_.isBusy())
    placement_.cancel();
  else if (brush_.isActive())
    brush_.setActive(false);
  else
    views_->showAll();
}

void MainWindow::moveCameras(const QString& step, const std::function<void()>& move) {
  auto change = std::make_shared<CamerasChange>(cameras_);
  const ViewLink::Pose before = cameras_.pose();
  move();
  if (cameras_.pose() != before) document_.history().push(step, std::move(change));
}

void MainWindow::face(StandardView side) {
  moveCameras(tr("Standard view"), [&] { cameras_.face(lastCamera_, side); });
}

void MainWindow::resetActiveView() {
  for (SliceView* view : views_->sliceViews())
    if (view->hasFocus()) {
      view->resetView();
      return;
    }
  moveCameras(tr("Reset view"), [this] { cameras_.reset(); });
}

void MainWindow::resetAllViews() {
  for (SliceView* view : views_->sliceViews()) view->resetView();
  moveCameras(tr("Reset views"), [this] { cameras_.reset(); });
}

void MainWindow::whenDrawn(std::function<void()> done) {
  auto* poll = new QTimer(this);
  connect(poll, &QTimer::timeout, this, [this, poll, done = std::move(done)] {
    if (job_.isRunning() || loadingBar_->isVisible() || placement_.isBusy() || cameras_.isFlying() ||
        camerasPanel_->isDrawing() || !views_->isSettled())
      return;
    poll->stop();
    poll->deleteLater();
    done();
  });
  constexpr int milliseconds = 30;
  poll->start(milliseconds);
}

QImage MainWindow::picture() {
  QPixmap pixmap = grab();
  // While a widget is grabbed, its QPainters paint into the grab: what a 3-D view draws over its picture lands below
  // it. Its framebuffer holds both.
  QPainter painter(&pixmap);
  for (VolumeView* view : views_->volumeViews())
    if (view->isVisible()) painter.drawImage(view->mapTo(this, QPoint(0, 0)), view->grabFramebuffer());
  painter.end();
  return pixmap.toImage();
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!sessions_->mayGo()) {
    event->ignore();
    return;
  }
  if (setup_.remember) preferences_.setLayout(saveGeometry(), saveState(layoutVersion), views_->saveLayout());
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!localPaths(*event->mimeData()).empty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const std::vector<std::filesystem::path> paths = localPaths(*event->mimeData());
  if (paths.empty()) return;
  event->acceptProposedAction();
  if (!document_.hasVolume() || paths.size() > 1 || io::isSession(paths.front()) ||
      QFileInfo(toQString(paths.front())).isDir()) {
    open(paths);
    return;
  }
  // A single file may be either; asked after the drop has ended, or the source program would wait for the answer.
  QTimer::singleShot(0, this, [this, path = paths.front(), at = mapToGlobal(event->position().toPoint())] {
    QMenu menu;
    connect(menu.addAction(tr("Open as volume")), &QAction::triggered, this, [this, path] { open({path}); });
    connect(menu.addAction(tr("Open as labels of this volume")), &QAction::triggered, this,
            [this, path] { openLabels(path); });
    menu.exec(at);
  });
}

}  // namespace fenestra::viewer
