// How the parts of the window are joined: who listens to whom.

#include <algorithm>
#include <cmath>
#include <memory>

#include <QApplication>
#include <QDockWidget>
#include <QTreeWidget>

#include "viewer/MainWindow.h"
#include "viewer/actions/MeasureMenu.h"
#include "viewer/actions/StructureMenu.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/files/FileOpener.h"
#include "viewer/guide/Tour.h"
#include "viewer/guide/WelcomePage.h"
#include "viewer/model/CamerasChange.h"
#include "viewer/model/NumberText.h"
#include "viewer/panels/AppearancePanel.h"
#include "viewer/panels/BrushPanel.h"
#include "viewer/panels/FocusPanel.h"
#include "viewer/panels/KeyImagesPanel.h"
#include "viewer/panels/LabelEditPanel.h"
#include "viewer/panels/RegionPanel.h"
#include "viewer/panels/SeriesPanel.h"
#include "viewer/panels/StrokeList.h"
#include "viewer/panels/TagsPanel.h"
#include "viewer/views/PlacementRenderer.h"
#include "viewer/views/PreviewRenderer.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {

void MainWindow::connectModels() {
  connect(&workspace_.document, &Document::volumeChanged, this, &MainWindow::followVolume);
  connect(&workspace_.placement, &PlacementController::leaving, this, [this] {
    workspace_.document.history().push(tr("Place cameras"), std::make_shared<CamerasChange>(workspace_.cameras));
  });
}

void MainWindow::connectViews() {
  if (gl_.available)
    workspace_.placement.setBackend(std::make_unique<PlacementRenderer>(*views_->volumeViews().front()));
  if (gl_.available) previews_ = std::make_unique<PreviewRenderer>(*views_->volumeViews().front());
  // While the cameras are about to move, a picture at full quality would be wasted.
  connect(&workspace_.placement, &PlacementController::changed, this, [this] {
    for (VolumeView* view : views_->volumeViews()) view->hold(workspace_.placement.isBusy());
  });
  connect(&workspace_.options, &ViewOptions::changed, this,
          [this] { notices_->hideNames(workspace_.options.hidesPatient()); });
  connect(&grower_, &RegionGrower::failed, this,
          [this](const QString& message) { notices_->addError(NoticeBar::Subject::Region, message); });
  connect(&workspace_.document, &Document::focusChanged, this, [this] {
    notices_->end(NoticeBar::Subject::Region);
    askToOpenRegion();
  });
  connect(views_, &ViewArea::menuRequested, this,
          [this](glm::dvec3 world, QPoint at) { showStructureMenu(workspace_, world, at); });
  connect(views_, &ViewArea::sliceMenuRequested, this,
          [this](SlicePlane plane, glm::dvec3 world, QPoint at) { showStructureMenu(workspace_, world, at, plane); });
  connect(views_, &ViewArea::picked, &workspace_.placement, &PlacementController::pick);
  connect(views_, &ViewArea::pickTakenBack, &workspace_.placement, &PlacementController::forgetPick);
  connect(views_, &ViewArea::measureMenuRequested, this,
          [this](std::size_t measure, QPoint at) { showMeasureMenu(workspace_, measure, at, this); });
  // From the event loop: the mouse's release is still being handled.
  connect(
      &workspace_.measuring, &MeasureMode::markWanted, this, [this] { askForMarkText(workspace_, {}, this); },
      Qt::QueuedConnection);
  // Views report while they are painted, so both come later: the study may be another one by then.
  const auto isOf = [this](const QString& (VolumeView::*text)() const, const QString& message) {
    const auto& volumes = views_->volumeViews();
    return std::any_of(volumes.begin(), volumes.end(),
                       [&](const VolumeView* view) { return (view->*text)() == message; });
  };
  connect(
      views_, &ViewArea::failed, this,
      [this, isOf](const QString& message) {
        if (isOf(&VolumeView::problem, message)) notices_->addError(NoticeBar::Subject::Views, message);
      },
      Qt::QueuedConnection);
  connect(
      views_, &ViewArea::reduced, this,
      [this, isOf](const QString& notice) {
        if (isOf(&VolumeView::reduction, notice))
          notices_->add(NoticeBar::Kind::Warning, NoticeBar::Subject::Study, notice + QLatin1Char('.'));
      },
      Qt::QueuedConnection);
}

void MainWindow::askToOpenRegion() {
  Document& document = workspace_.document;
  const std::optional<Document::Doubt> doubt = document.doubt();
  if (!doubt) return;
  const QString size = volumeText(document.regionVolume() / 1000.0);
  const QString question =
      *doubt == Document::Doubt::Share
          ? tr("The region is %1, which is %2 % of the body. The slices show its outline; open the 3-D views to it?")
                .arg(size)
                .arg(std::lround(100.0 * *document.regionShareOfBody()))
          : tr("The region, %1, has a doubtful border. The slices show its outline; open the 3-D views to it?")
                .arg(size);
  notices_->add(NoticeBar::Kind::Offer, NoticeBar::Subject::Region, question,
                {{tr("Open to it"), [&document] { document.openToRegion(); }, true},
                 {tr("Take it back"), [this] { grower_.cancel(); }, true}});
}

void MainWindow::connectPanels() {
  connect(panels_.series, &SeriesPanel::chosen, files_,
          [this](const QString& series) { files_->openSeries(series.toStdString()); });
  connect(files_, &FileOpener::seriesWanted, panels_.seriesDock, [this] {
    panels_.seriesDock->show();
    panels_.seriesDock->raise();
    panels_.series->list()->setFocus();
  });
  // After the views have noted which of them is active, because they connected before.
  connect(qApp, &QApplication::focusChanged, panels_.tags, [this] {
    const auto* slice = qobject_cast<const SliceView*>(views_->activeView());
    panels_.tags->setPlane(slice ? std::optional(slice->plane()) : std::nullopt);
  });
  connect(panels_.keyImages, &KeyImagesPanel::keepRequested, this, &MainWindow::keepKeyImage);
  connect(panels_.focus, &FocusPanel::structureChosen, this, &MainWindow::goToFocus);
  connect(panels_.focus->region(), &RegionPanel::kept, &labelEditor_, &LabelEditor::keepRegion);
  connect(panels_.focus->labelEdits(), &LabelEditPanel::edited, &labelEditor_, &LabelEditor::edit);
  connect(&labelEditor_.job(), &LoadJob::failed, this,
          [this](const QString& message) { notices_->addError(NoticeBar::Subject::Labels, message); });
  connect(&labelEditor_.job(), &LoadJob::started, this, [this] { views_->setAwaits(true); });
  connect(&labelEditor_.job(), &LoadJob::ended, this, [this] { views_->setAwaits(labelEditor_.job().isRunning()); });
  connect(&workspace_.document, &Document::labelsChanged, this, [this] {
    notices_->end(NoticeBar::Subject::Labels);
    if (workspace_.document.labels()) notices_->end(NoticeBar::Subject::Segmentations);
  });
  connect(&labelEditor_, &LabelEditor::tookFromOthers, this, [this](const QString& label, double ml) {
    notices_->add(
        NoticeBar::Kind::Warning, NoticeBar::Subject::Study,
        tr("%1 lies over other labels and took %2 from them; undo brings them back.").arg(label, volumeText(ml)));
  });
  panels_.appearance->presets().setBackend(previews_.get());
  const auto tellLook = [this](const QString& message) { notices_->addError(NoticeBar::Subject::Looks, message); };
  connect(&panels_.appearance->presets(), &PresetPicker::failed, this, tellLook);
  connect(&panels_.appearance->editor(), &TransferFunctionEditor::failed, this, tellLook);
  connect(&panels_.appearance->presets(), &PresetPicker::warned, this, [this](const QString& message) {
    notices_->add(NoticeBar::Kind::Warning, NoticeBar::Subject::Study, message + QLatin1Char('.'));
  });
  for (const std::string& problem : workspace_.looks.problems()) tellLook(QString::fromStdString(problem));
  connect(&panels_.appearance->presets(), &PresetPicker::lookChosen, files_, &FileOpener::setChosenLook);
  connect(&panels_.brush->strokes(), &StrokeList::failed, this, tellLook);
}

void MainWindow::connectLoader() {
  connect(&loader_, &StudyLoader::opened, this, &MainWindow::studyOpened);
  connect(&loader_, &StudyLoader::labelsOpened, this, [this](const std::vector<io::Warning>& warnings) {
    notices_->end(NoticeBar::Subject::Opening);
    notices_->addWarnings(warnings);
  });
  connect(&loader_.job(), &LoadJob::started, this, [this] { welcome_->setReading(true); });
  connect(&loader_.job(), &LoadJob::ended, this, [this] {
    welcome_->setReading(loader_.job().isRunning());
    if (!loader_.job().isRunning()) tour_->openingEnded();
  });
  connect(&loader_.job(), &LoadJob::failed, this, [this](const QString& message) {
    notices_->addError(NoticeBar::Subject::Opening, message);
    Q_EMIT failed(message);
  });
}

}  // namespace fenestra::viewer
