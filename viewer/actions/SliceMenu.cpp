// The View menu's entries for slices: flipped, turned, in true size, played.

#include <QAction>
#include <QMainWindow>
#include <QStatusBar>

#include "viewer/actions/Actions.h"
#include "viewer/model/Workspace.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {

SliceView& Actions::activeSlice() const {
  const auto& slices = targets_.views.sliceViews();
  if (auto* active = qobject_cast<SliceView*>(targets_.views.activeView())) return *active;
  for (SliceView* view : slices)
    if (view->isVisible()) return *view;
  return *slices.front();
}

void Actions::addSlicePictures(QMenu& menu) {
  menu.addSeparator();
  menu.addAction(
      volumeAction(tr("Flip &left and right"), QKeySequence(tr("X")), [this] { activeSlice().flipAcross(); }));
  menu.addAction(volumeAction(tr("Flip &up and down"), QKeySequence(tr("Y")), [this] { activeSlice().flipDown(); }));
  menu.addAction(volumeAction(tr("&Turn by 90°"), QKeySequence(tr("Z")), [this] { activeSlice().turnClockwise(); }));
  menu.addAction(volumeAction(tr("Tru&e size"), QKeySequence(tr("J")), [this] {
    if (activeSlice().showTrueSize()) return;
    constexpr int readable = 8000;  // ms
    targets_.window.statusBar()->showMessage(
        tr("This screen does not say how large it is, so that true size cannot be shown."), readable);
  }));
  menu.addAction(preferenceToggle(tr("&Neurological convention"), QKeySequence(tr("U")), Preference::Neurological));
  menu.addSeparator();
  QAction* play = volumeAction(tr("&Play"), QKeySequence(tr("K")), [this] {
    if (!cine_.stop()) cine_.play(activeSlice());
  });
  play->setCheckable(true);
  connect(&cine_, &Cine::changed, play, [this, play] { play->setChecked(cine_.isPlaying()); });
  const auto changeSpeed = [this](int step) {
    cine_.changeSpeed(step);
    constexpr int readable = 3000;  // ms
    targets_.window.statusBar()->showMessage(tr("%n slices a second", nullptr, cine_.slicesPerSecond()), readable);
  };
  menu.addAction(play);
  menu.addAction(volumeAction(tr("Play &faster"), QKeySequence(tr("Shift+K")), [changeSpeed] { changeSpeed(1); }));
  menu.addAction(volumeAction(tr("Play slo&wer"), QKeySequence(tr("Ctrl+K")), [changeSpeed] { changeSpeed(-1); }));
  connect(&targets_.workspace.document, &Document::volumeChanged, &cine_, &Cine::stop);
}

}  // namespace fenestra::viewer
