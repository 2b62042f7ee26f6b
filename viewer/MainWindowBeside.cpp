// A second study beside the first: another window of this run, with views, panels and menus of its own. Each of the two
// knows the other one; the first owns the second, which stays, hidden and empty, once it was there.

#include <algorithm>

#include <QLayout>
#include <QScreen>

#include "viewer/MainWindow.h"
#include "viewer/actions/Actions.h"
#include "viewer/bars/NoticeBar.h"
#include "viewer/files/FileOpener.h"
#include "viewer/files/Sessions.h"
#include "viewer/model/StudyLink.h"
#include "viewer/panels/SeriesPanel.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {

void MainWindow::connectBeside() {
  link_->join(side(), workspace_.cursor, workspace_.cameras);
  connect(files_, &FileOpener::besideWanted, this,
          [this](const std::vector<std::filesystem::path>& paths) { showBeside().open(paths); });
  connect(panels_.series, &SeriesPanel::besideChosen, this, [this](const QString& series) {
    showBeside().files_->openSeriesOf(workspace_.document.study(), series.toStdString());
  });
  connect(views_, &ViewArea::scaled, this, [this](const SliceView* view) {
    if (link_->isLinked()) scaleOther(*view);
  });
  connect(link_.get(), &StudyLink::aligned, this, [this](int leader) {
    if (leader != side()) return;
    for (const SliceView* view : views_->sliceViews()) scaleOther(*view);
    tellFrames();
  });
}

void MainWindow::scaleOther(const SliceView& view) {
  for (SliceView* other : other()->views_->sliceViews())
    if (other->plane() == view.plane()) other->setScale(view.scale());
}

void MainWindow::tellFrames() {
  const std::string &one = workspace_.document.study().series.studyUid,
                    &two = other()->workspace_.document.study().series.studyUid;
  if (link_->isMatched() || (!one.empty() && one == two)) return;
  notices_->add(NoticeBar::Kind::Warning, NoticeBar::Subject::Linking,
                tr("The patient may lie differently in the two studies: linked without a pair of points, the same "
                   "coordinates may be other places. Unlink, put both crosshairs onto the same point, and choose Match "
                   "points; the link is as good as that pair."));
}

MainWindow& MainWindow::showBeside() {
  if (!other()) {
    Setup setup = setup_;
    setup.openFirst = {};  // that study is open here
    setup.first = this;
    second_ = std::make_unique<MainWindow>(setup);
    for (const auto& [name, read] : samples_) second_->addSample(name, read);
    second_->sessions_->shareCopies(*sessions_);
  }
  MainWindow& beside = *other();
  if (link_->isCompared()) return beside;
  alone_ = beside.alone_ = saveGeometry();
  link_->setCompared(true);
  tile();
  return beside;
}

void MainWindow::tile() {
  const QRect area = screen()->availableGeometry();
  MainWindow* both[] = {first_ ? first_ : this, first_ ? this : second_.get()};
  // The system's frame, as this window has it.
  const int title = std::max(0, geometry().top() - frameGeometry().top());
  const int frame = std::max(0, frameGeometry().width() - geometry().width());
  const int width = area.width() / 2;
  for (int at = 0; at < 2; ++at) {
    MainWindow& window = *both[at];
    window.setWindowState(window.windowState() & ~(Qt::WindowMaximized | Qt::WindowFullScreen));
    window.layout()->activate();  // without the panels that have just been hidden it can be narrower
    window.setGeometry(area.left() + at * width + frame / 2, area.top() + title, width - frame,
                       area.height() - title - frame / 2);
    window.show();
  }
}

void MainWindow::endComparison() {
  link_->setCompared(false);
  dropStudy();
  for (MainWindow* each : {this, other()}) each->notices_->end(NoticeBar::Subject::Linking);
  other()->restoreGeometry(alone_);
  alone_ = other()->alone_ = {};
  showOther();
}

void MainWindow::showOther() {
  if (!other() || !other()->isVisible()) return;
  other()->raise();
  other()->activateWindow();
}

void MainWindow::quit() {
  if (link_->isCompared() && !other()->close()) return;
  close();
}

}  // namespace fenestra::viewer
