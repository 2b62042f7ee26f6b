#include "viewer/MainWindow.h"

#include <cmath>

#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>

#include "viewer/Dialogs.h"
#include "viewer/NoticeBar.h"
#include "viewer/model/Paths.h"
#include "viewer/model/WindowPresets.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/CamerasPanel.h"
#include "viewer/panels/CutawayPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/views/PlacementRenderer.h"

namespace fenestra::viewer {
namespace {

constexpr int layoutVersion = 2;  ///< of the docks and toolbars; a saved layout of another version is not restored

QIcon icon(const char* name) { return QIcon(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name))); }

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

  views_ = new ViewArea(document_, cursor_, cameras_, options_, setup.gl, setup.restQuality);
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
  makeActions();
  makeStatusBar();

  // Pictures at full quality would be of cameras that are about to leave.
  connect(&placement_, &PlacementController::changed, this, [this] {
    for (VolumeView* view : views_->volumeViews()) view->hold(placement_.isBusy());
  });
  connect(views_, &ViewArea::pointed, this, &MainWindow::pointAt);
  connect(views_, &ViewArea::left, pointer_, &QLabel::clear);
  connect(views_, &ViewArea::menuRequested, this, &MainWindow::showMenu);
  connect(views_, &ViewArea::failed, this, &MainWindow::showError, Qt::QueuedConnection);
  connect(focusPanel_, &FocusPanel::structureChosen, this, &MainWindow::goToFocus);
  connect(appearancePanel_, &AppearancePanel::failed, this, &MainWindow::showError);
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
    connect(&placement_, &PlacementController::settingsChanged, this,
            [this] { preferences_.setPlacement(placement_.settings()); });
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
  camerasPanel_ = new CamerasPanel(document_, cameras_, placement_);
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
  focus->raise();
  add(tr("Context"), "contextDock", appearancePanel_);
  add(tr("Cutaway"), "cutawayDock", cutawayPanel_);
  // The list of structures takes the height that is left.
  for (QWidget* panel : {static_cast<QWidget*>(appearancePanel_), static_cast<QWidget*>(cutawayPanel_)})
    panel->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
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
  statusBar()->addPermanentWidget(new QLabel(tr("Radiological convention")));
}

void MainWindow::makeActions() {
  const auto action = [this](const QString& text, const QKeySequence& keys, auto slot) {
    auto* made = new QAction(text, this);
    if (!keys.isEmpty()) {
      made->setShortcut(keys);
      made->setToolTip(QStringLiteral("%1 (%2)").arg(QString(text).remove(QLatin1Char('&')).remove(QStringLiteral("…")),
                                                     keys.toString(QKeySequence::NativeText)));
    }
    connect(made, &QAction::triggered, this, slot);
    return made;
  };
  const auto withVolume = [this](QAction* made) {
    made->setEnabled(false);
    needVolume_ << made;
    return made;
  };
  const auto toggle = [&](const QString& text, const QKeySequence& keys, bool on, auto slot) {
    auto* made = new QAction(text, this);
    made->setCheckable(true);
    made->setChecked(on);
    made->setShortcut(keys);
    made->setToolTip(QStringLiteral("%1 (%2)").arg(text, keys.toString(QKeySequence::NativeText)));
    connect(made, &QAction::toggled, this, slot);
    return made;
  };

  QAction* openFolder = action(tr("Open &folder…"), QKeySequence(tr("Ctrl+Shift+O")), [this] { chooseFolder(); });
  openFolder->setIcon(icon("folder"));
  QAction* openFile = action(tr("&Open file…"), QKeySequence::Open, [this] { chooseFile(); });
  openFile->setIcon(icon("file"));
  QAction* labels = withVolume(action(tr("Open &labels…"), QKeySequence(tr("Ctrl+L")), [this] { chooseLabels(); }));
  labels->setIcon(icon("labels"));
  chooseSeries_ = action(tr("Choose &series…"), {}, [this] { chooseSeries(); });
  chooseSeries_->setEnabled(false);
  QMenu* file = menuBar()->addMenu(tr("&File"));
  file->addActions({openFolder, openFile});
  recentMenu_ = file->addMenu(tr("&Recent"));
  connect(recentMenu_, &QMenu::aboutToShow, this, &MainWindow::fillRecentMenu);
  sampleMenu_ = file->addMenu(tr("&Built-in phantoms"));
  sampleMenu_->menuAction()->setVisible(false);
  file->addSeparator();
  file->addActions({chooseSeries_, labels});
  file->addSeparator();
  file->addAction(action(tr("&Quit"), QKeySequence::Quit, [this] { close(); }));

  QAction* reset = withVolume(action(tr("&Reset view"), QKeySequence(tr("R")), [this] { resetActiveView(); }));
  reset->setIcon(icon("reset"));
  QAction* resetAll =
      withVolume(action(tr("Reset &all views"), QKeySequence(tr("Ctrl+R")), [this] { resetAllViews(); }));
  QAction* link = toggle(tr("&Link the 3-D views"), QKeySequence(tr("L")), cameras_.isLinked(),
                         [this](bool on) { cameras_.setLinked(on); });
  link->setIcon(icon("link"));
  link->setObjectName(QStringLiteral("link"));
  QAction* parallel = toggle(tr("&Parallel projection"), QKeySequence(tr("Ctrl+P")), false, [this](bool on) {
    cameras_.setProjection(on ? Projection::Orthographic : Projection::Perspective);
  });
  parallel->setIcon(icon("parallel"));
  connect(&document_, &Document::volumeChanged, parallel,
          [this, parallel] { parallel->setChecked(cameras_.projection() == Projection::Orthographic); });
  QAction* crosshair = toggle(tr("&Crosshair"), QKeySequence(tr("C")), options_.crosshair(),
                              [this](bool on) { options_.setCrosshair(on); });
  crosshair->setIcon(icon("crosshair"));
  QAction* overlay = toggle(tr("Label &overlay"), QKeySequence(tr("O")), options_.labels(),
                            [this](bool on) { options_.setLabels(on); });
  overlay->setIcon(icon("overlay"));
  QAction* text =
      toggle(tr("Corner &text"), QKeySequence(tr("T")), options_.text(), [this](bool on) { options_.setText(on); });
  text->setIcon(icon("text"));

  QMenu* view = menuBar()->addMenu(tr("&View"));
  QMenu* sides = view->addMenu(tr("&Look from"));
  struct Side {
    const char *letter, *name;
    StandardView view;
  };
  QList<QAction*> sideActions;
  for (const Side& side :
       {Side{"A", QT_TR_NOOP("Anterior"), StandardView::Anterior},
        Side{"P", QT_TR_NOOP("Posterior"), StandardView::Posterior}, Side{"L", QT_TR_NOOP("Left"), StandardView::Left},
        Side{"R", QT_TR_NOOP("Right"), StandardView::Right}, Side{"S", QT_TR_NOOP("Superior"), StandardView::Superior},
        Side{"I", QT_TR_NOOP("Inferior"), StandardView::Inferior}}) {
    QAction* made =
        withVolume(action(tr(side.name), QKeySequence(QStringLiteral("Shift+%1").arg(QLatin1String(side.letter))),
                          [this, which = side.view] { face(which); }));
    made->setIconText(QLatin1String(side.letter));
    sideActions << made;
  }
  sides->addActions(sideActions);
  QAction* place = action(tr("P&lace cameras"), QKeySequence(tr("F5")), [this] { placement_.place(); });
  place->setIcon(icon("place"));
  const auto enablePlace = [this, place] { place->setEnabled(placement_.canPlace()); };
  connect(&placement_, &PlacementController::changed, place, enablePlace);
  enablePlace();
  view->addAction(place);
  view->addActions({reset, resetAll});
  view->addSeparator();
  view->addActions({link, parallel});
  view->addSeparator();
  view->addActions({crosshair, overlay, text});
  view->addSeparator();
  view->addAction(action(tr("All &views"), QKeySequence(tr("Esc")), [this] {
    if (job_.isRunning())
      job_.cancel();
    else if (placement_.isBusy())
      placement_.cancel();
    else
      views_->showAll();
  }));
  view->addAction(action(tr("F&ull screen"), QKeySequence(tr("F11")),
                         [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); }));
  view->addSeparator();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) view->addAction(dock->toggleViewAction());

  QMenu* window = menuBar()->addMenu(tr("&Window/level"));
  window->addAction(withVolume(action(tr("Of the data"), QKeySequence(tr("1")), [this] { document_.resetWindow(); })));
  for (const WindowPreset& preset : ctWindowPresets)
    window->addAction(withVolume(
        action(tr("CT %1  (%2 / %3)").arg(tr(preset.name)).arg(preset.window.width).arg(preset.window.level),
               QKeySequence(QString::number(preset.key)), [this, &preset] { document_.setWindow(preset.window); })));

  QMenu* focus = menuBar()->addMenu(tr("F&ocus"));
  focus->addAction(withVolume(
      action(tr("&No focus"), QKeySequence(tr("Ctrl+Backspace")), [this] { document_.setFocus(std::monostate{}); })));

  QMenu* help = menuBar()->addMenu(tr("&Help"));
  help->addAction(action(tr("&Keys and mouse"), QKeySequence(tr("?")), [this] { showKeys(this); }));
  help->addAction(action(tr("&About Fenestra"), {}, [this] { showAbout(setup_.gl, this); }));

  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tools"));
  bar->setMovable(false);
  bar->setIconSize({18, 18});
  bar->addActions({openFolder, openFile, labels});
  bar->addSeparator();
  bar->addActions(sideActions);
  bar->addActions({reset, place});
  bar->addSeparator();
  bar->addActions({link, parallel});
  bar->addSeparator();
  bar->addActions({crosshair, overlay, text});
  connect(&document_, &Document::volumeChanged, this, [this] {
    for (QAction* each : needVolume_) each->setEnabled(true);
    chooseSeries_->setEnabled(!document_.study().otherSeries.empty());
  });
}

void MainWindow::open(Reader read) {
  job_.start([this, read = std::move(read)](const io::Progress& progress) -> LoadJob::Show {
    // Shared, because what is handed to the GUI thread must be copyable.
    auto study = std::make_shared<Study>(read(progress));
    return [this, study] { showStudy(std::move(*study)); };
  });
}

void MainWindow::open(const std::vector<std::filesystem::path>& paths) {
  try {
    const PathsToOpen chosen = interpret(paths);
    open([chosen, looks = document_.scene()](const io::Progress& progress) {
      return readStudy(chosen, looks, progress);
    });
  } catch (const io::Error& error) {
    showError(QString::fromUtf8(error.what()));
  }
}

void MainWindow::openSeries(const std::string& series) {
  PathsToOpen chosen;
  chosen.volume = document_.study().path;
  chosen.series = series;
  open(
      [chosen, looks = document_.scene()](const io::Progress& progress) { return readStudy(chosen, looks, progress); });
}

void MainWindow::openLabels(const std::filesystem::path& path) {
  job_.start([this, path, volume = document_.scene().volume](const io::Progress& progress) -> LoadJob::Show {
    const io::OpenedLabels opened = io::openLabels(path, volume->grid, progress);
    return [this, opened] {
      document_.setLabels(opened.labels);
      showWarnings(opened.warnings);
    };
  });
}

void MainWindow::addSample(const QString& name, Reader read) {
  sampleMenu_->menuAction()->setVisible(true);
  connect(sampleMenu_->addAction(name), &QAction::triggered, this, [this, read = std::move(read)] { open(read); });
}

void MainWindow::showStudy(Study study) {
  const std::filesystem::path path = study.path;
  const std::vector<io::Warning> warnings = study.warnings;
  document_.open(std::move(study));
  pages_->setCurrentWidget(views_);
  notices_->clear();
  setWindowTitle(QStringLiteral("%1 – Fenestra").arg(document_.description()));
  if (setup_.remember && !path.empty()) preferences_.addRecent(path);
  const std::size_t others = document_.study().otherSeries.size();
  if (others > 0)
    notices_->add(NoticeBar::Kind::Warning,
                  tr("There are %1 series here; this is the largest, %2.")
                      .arg(others + 1)
                      .arg(describe(document_.study().series)),
                  tr("Choose…"), [this] { chooseSeries(); });
  showWarnings(warnings);
  if (document_.study().placeCameras) placement_.place();
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

void MainWindow::fillRecentMenu() {
  recentMenu_->clear();
  for (const std::filesystem::path& path : preferences_.recent()) {
    QAction* entry = recentMenu_->addAction(QDir::toNativeSeparators(toQString(path)));
    connect(entry, &QAction::triggered, this, [this, path] { open({path}); });
  }
  if (recentMenu_->isEmpty()) {
    recentMenu_->addAction(tr("Nothing yet"))->setEnabled(false);
    return;
  }
  recentMenu_->addSeparator();
  connect(recentMenu_->addAction(tr("Forget these")), &QAction::triggered, this,
          [this] { preferences_.clearRecent(); });
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

void MainWindow::face(StandardView side) { cameras_.face(lastCamera_, side); }

void MainWindow::resetActiveView() {
  for (SliceView* view : views_->sliceViews())
    if (view->hasFocus()) {
      view->resetView();
      return;
    }
  cameras_.reset();
}

void MainWindow::resetAllViews() {
  for (SliceView* view : views_->sliceViews()) view->resetView();
  cameras_.reset();
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
  if (!document_.hasVolume() || paths.size() > 1 || QFileInfo(toQString(paths.front())).isDir()) {
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
