// The File menu.

#include <QAction>
#include <QActionGroup>
#include <QDir>
#include <QMainWindow>
#include <QMenuBar>

#include "rendering/settings/StartingLook.h"
#include "viewer/actions/Actions.h"
#include "viewer/actions/SegmentationMenu.h"
#include "viewer/archive/ArchiveDock.h"
#include "viewer/archive/SendDialog.h"
#include "viewer/exports/Exports.h"
#include "viewer/exports/PictureExports.h"
#include "viewer/files/FileOpener.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/Paths.h"
#include "viewer/model/Workspace.h"
#include "viewer/style/Style.h"

namespace fenestra::viewer {

void Actions::makeFileMenu() {
  QAction* folder =
      action(tr("Open &folder…"), QKeySequence(tr("Ctrl+Shift+O")), [this] { targets_.files.chooseFolder(); });
  folder->setIcon(icon("folder"));
  QAction* file = action(tr("&Open file…"), QKeySequence::Open, [this] { targets_.files.chooseFile(); });
  file->setIcon(icon("file"));
  QAction* labels =
      volumeAction(tr("Open &labels…"), QKeySequence(tr("Ctrl+L")), [this] { targets_.files.chooseLabels(); });
  labels->setIcon(icon("labels"));
  QAction* series = action(tr("Choose series…"), {}, [this] { targets_.files.chooseSeries(); });
  series->setObjectName(QStringLiteral("chooseSeries"));
  QAction* next =
      action(tr("&Next series"), QKeySequence(tr("Ctrl+PgDown")), [this] { targets_.files.openNeighbour(1); });
  QAction* previous =
      action(tr("Pre&vious series"), QKeySequence(tr("Ctrl+PgUp")), [this] { targets_.files.openNeighbour(-1); });
  const auto enable = [this, series, next, previous] {
    for (QAction* each : {series, next, previous})
      each->setEnabled(!targets_.workspace.document.study().otherSeries.empty());
  };
  connect(&targets_.workspace.document, &Document::volumeChanged, series, enable);
  enable();

  QAction* session = action(tr("Open s&ession…"), {}, [this] { targets_.sessions.choose(); });
  session->setObjectName(QStringLiteral("openSession"));
  QAction* save = volumeAction(tr("&Save session"), QKeySequence::Save, [this] { targets_.sessions.save(); });
  save->setIcon(icon("save"));
  QAction* saveAs =
      volumeAction(tr("Save session &as…"), QKeySequence(tr("Ctrl+Shift+S")), [this] { targets_.sessions.saveAs(); });

  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&File"));
  menu->addActions({folder, file, session});
  addOpenBeside(*menu);
  recent_ = menu->addMenu(tr("&Recent"));
  connect(recent_, &QMenu::aboutToShow, this, &Actions::fillRecentMenu);
  samples_ = menu->addMenu(tr("&Built-in phantoms"));
  samples_->menuAction()->setVisible(false);
  menu->addSeparator();
  menu->addActions({series, next, previous, labels});
  addLabelEntries(*menu);
  addModalityMenu(*menu);
  addVoxelSize(*menu);
  addSegmentationMenu(*menu);
  menu->addSeparator();
  menu->addActions({save, saveAs});
  addExports(*menu);
  menu->addAction(volumeAction(tr("Save res&ults…"), {}, [this] { targets_.dialogs.saveResults(); }));
  menu->actions().constLast()->setObjectName(QStringLiteral("saveResults"));
  menu->actions().constLast()->setToolTip(
      tr("Measures, segmentations, pictures and key images as DICOM objects, to a folder or an archive"));
  addSending(*menu);
  menu->addSeparator();
  menu->addAction(volumeAction(tr("&Close study"), QKeySequence(tr("Ctrl+W")), [this] { targets_.closeStudy(); }));
  menu->actions().constLast()->setObjectName(QStringLiteral("closeStudy"));
  menu->addAction(action(tr("&Quit"), QKeySequence::Quit, [this] { beside_.quit(); }));
  tools_ << QList<QAction*>{folder, file, labels, save};
}

void Actions::addLabelEntries(QMenu& menu) {
  menu.addAction(volumeAction(tr("Open a folder of &masks…"), {}, [this] { targets_.files.chooseMaskFolder(); }));
  menu.actions().constLast()->setObjectName(QStringLiteral("openMasks"));
  QAction* table = menu.addAction(tr("Open a &table of labels…"));
  table->setObjectName(QStringLiteral("openLabelTable"));
  connect(table, &QAction::triggered, this, [this] { targets_.files.chooseLabelTable(); });
  const Document& document = targets_.workspace.document;
  const auto enable = [table, &document] { table->setEnabled(!document.study().session.labels.path.empty()); };
  connect(&document, &Document::volumeChanged, table, enable);
  connect(&document, &Document::labelsChanged, table, enable);
  enable();
}

void Actions::addVoxelSize(QMenu& menu) {
  QAction* size = menu.addAction(tr("Si&ze of the voxels…"));
  size->setObjectName(QStringLiteral("voxelSize"));
  connect(size, &QAction::triggered, this, [this] { targets_.files.chooseVoxelSize(); });
  const Document& document = targets_.workspace.document;
  // Other formats say it themselves.
  const auto enable = [size, &document] { size->setEnabled(document.study().format == "TIFF"); };
  connect(&document, &Document::volumeChanged, size, enable);
  enable();
}

void Actions::addModalityMenu(QMenu& menu) {
  QMenu* kinds = menu.addMenu(tr("&Kind of values"));
  auto* group = new QActionGroup(kinds);
  const Document& document = targets_.workspace.document;
  const auto add = [&](const QString& name, Modality modality) {
    QAction* entry = kinds->addAction(name);
    entry->setCheckable(true);
    group->addAction(entry);
    connect(entry, &QAction::triggered, this, [this, modality] { targets_.sessions.setModality(modality); });
    connect(&document, &Document::volumeChanged, entry, [entry, modality, &document] {
      entry->setChecked(document.hasVolume() && document.scene().volume->modality == modality);
    });
  };
  add(tr("&CT"), Modality::CT);
  add(tr("&MR"), Modality::MR);
  add(tr("&PET or SPECT"), Modality::PT);
  add(tr("&Ultrasound"), Modality::US);
  add(tr("&Other"), Modality::Unknown);
  // DICOM files say it themselves, and phantoms are of no kind.
  const auto enable = [kinds, &document] {
    const io::Study& study = document.study();
    kinds->setEnabled(document.hasVolume() && !study.session.phantom && study.format != "DICOM");
  };
  connect(&document, &Document::volumeChanged, kinds, enable);
  enable();
}

void Actions::addSegmentationMenu(QMenu& menu) {
  QMenu* segmentations = menu.addMenu(tr("Se&gmentations of this series"));
  segmentations->menuAction()->setVisible(false);
  const ViewOptions& options = targets_.workspace.options;
  const auto fill = [this, segmentations, &options] {
    const auto& found = targets_.workspace.document.study().segmentations;
    fillSegmentationMenu(*segmentations, found,
                         options.hidesPatient() ? SegmentationTitle::Nameless : SegmentationTitle::Full,
                         targets_.loader);
    segmentations->menuAction()->setVisible(!found.empty());
  };
  connect(&targets_.workspace.document, &Document::volumeChanged, segmentations, fill);
  connect(&options, &ViewOptions::changed, segmentations, fill);
}

void Actions::addExports(QMenu& menu) {
  Exports& exports = targets_.exports;
  PictureExports& pictures = targets_.pictures;
  QMenu* group = menu.addMenu(tr("E&xport"));
  group->addAction(
      volumeAction(tr("A &picture…"), QKeySequence(tr("Ctrl+E")), [&pictures] { pictures.choosePicture(); }));
  group->addAction(volumeAction(tr("A &turntable…"), {}, [&pictures] { pictures.chooseTurntable(); }));
  group->actions().constLast()->setObjectName(QStringLiteral("exportTurntable"));
  group->addSeparator();
  QAction* all = group->addAction(tr("All &labels…"));
  QAction* focus = group->addAction(tr("The &focus as labels…"));
  QAction* surface = group->addAction(tr("The focus as a &surface…"));
  all->setObjectName(QStringLiteral("exportLabels"));
  focus->setObjectName(QStringLiteral("exportFocus"));
  surface->setObjectName(QStringLiteral("exportSurface"));
  QAction* measures = group->addAction(tr("&Measures as a table…"));
  measures->setObjectName(QStringLiteral("exportMeasures"));
  connect(measures, &QAction::triggered, this, [&exports] { exports.chooseMeasureFile(); });
  connect(all, &QAction::triggered, this, [&exports] { exports.chooseLabelFile(Exports::Labels::All); });
  connect(focus, &QAction::triggered, this, [&exports] { exports.chooseLabelFile(Exports::Labels::Focus); });
  connect(surface, &QAction::triggered, this, [&exports] { exports.chooseSurfaceFile(); });
  const auto enable = [&exports, all, focus, surface, measures] {
    measures->setEnabled(exports.canWriteMeasures());
    all->setEnabled(exports.canWriteLabels(Exports::Labels::All));
    focus->setEnabled(exports.canWriteLabels(Exports::Labels::Focus));
    surface->setEnabled(exports.canWriteSurface());
  };
  Document& document = targets_.workspace.document;
  connect(&document, &Document::volumeChanged, group, enable);
  connect(&document, &Document::labelsChanged, group, enable);
  connect(&document, &Document::focusChanged, group, enable);
  connect(&document, &Document::measuresChanged, group, enable);
  enable();
}

void Actions::addSending(QMenu& menu) {
  QAction* send = menu.addAction(tr("Send to archive…"));
  send->setObjectName(QStringLiteral("sendToArchive"));
  connect(send, &QAction::triggered, this, [this] { targets_.archive.showSendDialog(); });
  QAction* copies = menu.addAction(tr("De-identify…"));
  copies->setObjectName(QStringLiteral("deidentify"));
  connect(copies, &QAction::triggered, this, [this] { targets_.dialogs.deidentify(); });
  const Document& document = targets_.workspace.document;
  const auto enable = [send, copies, &document] {
    const QString problem = SendDialog::problemOf(document);
    send->setEnabled(problem.isEmpty());
    send->setToolTip(problem.isEmpty() ? tr("The open series and its labels, to a server of the panel Archive")
                                       : problem);
    copies->setEnabled(problem.isEmpty());
    copies->setToolTip(problem.isEmpty() ? tr("Copies of the open series without what names the patient") : problem);
  };
  connect(&document, &Document::volumeChanged, send, enable);
  enable();
}

QAction* Actions::addSample(const QString& name, StudyLoader::SampleReader read) {
  samples_->menuAction()->setVisible(true);
  QAction* sample = samples_->addAction(name);
  connect(sample, &QAction::triggered, this, [this, read = std::move(read)] {
    if (!targets_.sessions.mayGo()) return;
    const Look look = targets_.workspace.preferences.startingLook(startingLook());
    targets_.loader.open([read, look](const io::Progress& progress) { return read(look, progress); });
  });
  return sample;
}

void Actions::fillRecentMenu() {
  recent_->clear();
  for (const std::filesystem::path& path : targets_.workspace.preferences.recent()) {
    // A folder or file is often named after its patient.
    QAction* entry = recent_->addAction(targets_.workspace.options.hidesPatient()
                                            ? tr("%1, name hidden").arg(recent_->actions().size() + 1)
                                            : QDir::toNativeSeparators(toQString(path)));
    connect(entry, &QAction::triggered, this, [this, path] { targets_.files.open({path}); });
  }
  if (recent_->isEmpty()) {
    recent_->addAction(tr("Nothing yet"))->setEnabled(false);
    return;
  }
  recent_->addSeparator();
  connect(recent_->addAction(tr("Forget these")), &QAction::triggered, this,
          [this] { targets_.workspace.preferences.clearRecent(); });
}

}  // namespace fenestra::viewer
