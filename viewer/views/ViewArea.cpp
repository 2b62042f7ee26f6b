#include "viewer/views/ViewArea.h"

#include <algorithm>

#include <QApplication>
#include <QDataStream>
#include <QLabel>
#include <QVBoxLayout>

#include "viewer/model/ContextAnimation.h"
#include "viewer/model/DrawingTurns.h"
#include "viewer/model/Workspace.h"
#include "viewer/views/ScenePreparation.h"

namespace fenestra::viewer {

ViewArea::ViewArea(Workspace& workspace, const GlSupport& gl, const Effort& atRest,
                   const ChooseSchedule& chooseSchedule, QWidget* parent)
    : QWidget(parent),
      pacer_(std::make_shared<FramePacer>(atRest)),
      rows_(new QSplitter(Qt::Vertical)),
      upper_(new QSplitter(Qt::Horizontal)),
      lower_(new QSplitter(Qt::Horizontal)) {
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(rows_);
  rows_->addWidget(upper_);
  rows_->addWidget(lower_);
  for (QSplitter* splitter : {rows_, upper_, lower_}) {
    splitter->setChildrenCollapsible(false);
    splitter->setHandleWidth(3);
  }

  if (gl.available)
    addVolumeViews(workspace, gl, chooseSchedule);
  else
    addReason(gl);
  addSliceViews(workspace);
  rows_->setSizes({560, 440});
  active_ = volumes_.empty() ? static_cast<QWidget*>(slices_.front()) : volumes_.front();
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    for (const auto& [name, view] : namedViews())
      if (view == now) active_ = view;
  });
}

template <class View>
void ViewArea::connectView(View* view) {
  connect(view, &View::pointed, this, &ViewArea::pointed);
  connect(view, &View::left, this, &ViewArea::left);
  connect(view, &View::maximiseRequested, this, [this, view] { toggleMaximised(view); });
}

void ViewArea::addVolumeViews(Workspace& workspace, const GlSupport& gl, const ChooseSchedule& chooseSchedule) {
  preparation_ = std::make_shared<ScenePreparation>(chooseSchedule);
  const VolumeView::Shared shared{preparation_, pacer_, std::make_shared<DrawingTurns>(*pacer_),
                                  std::make_shared<ContextAnimation>(workspace.document, workspace.cameras),
                                  gl.software};
  for (int index = 0; index < ViewLink::count; ++index) {
    auto* view = new VolumeView(index, workspace, shared);
    connectView(view);
    connect(view, &VolumeView::menuRequested, this, &ViewArea::menuRequested);
    connect(view, &VolumeView::failed, this, &ViewArea::failed);
    connect(view, &VolumeView::reduced, this, &ViewArea::reduced);
    connect(view, &VolumeView::drawn, this, &ViewArea::drawn);
    connect(&view->lateness(), &Lateness::changed, this, &ViewArea::lateChanged);
    connect(view, &VolumeView::raysStarted, &opening_, &OpeningEdge::set);
    upper_->addWidget(view);
    volumes_.push_back(view);
  }
}

void ViewArea::addReason(const GlSupport& gl) {
  auto* reason =
      new QLabel(tr("3-D views are not available here.\n\n%1\n\nThe slices below work without it.").arg(gl.problem));
  reason->setObjectName(QStringLiteral("noOpenGl"));
  reason->setAlignment(Qt::AlignCenter);
  reason->setWordWrap(true);
  reason->setMargin(24);
  reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
  upper_->addWidget(reason);
}

void ViewArea::addSliceViews(Workspace& workspace) {
  for (const SlicePlane plane : {SlicePlane::Axial, SlicePlane::Sagittal, SlicePlane::Coronal}) {
    auto* view = new SliceView(plane, workspace, opening_);
    connectView(view);
    connect(view, &SliceView::menuRequested, this,
            [this, plane](glm::dvec3 world, QPoint at) { Q_EMIT sliceMenuRequested(plane, world, at); });
    connect(view, &SliceView::measureMenuRequested, this, &ViewArea::measureMenuRequested);
    connect(view, &SliceView::picked, this, &ViewArea::picked);
    connect(view, &SliceView::pickTakenBack, this, &ViewArea::pickTakenBack);
    lower_->addWidget(view);
    slices_.push_back(view);
  }
}

std::optional<Schedule> ViewArea::schedule() const {
  return preparation_ ? std::optional(preparation_->schedule()) : std::nullopt;
}

void ViewArea::warmUp(const Focus& expected) {
  std::vector<Focus> kinds{Focus(), LabelFocus(), ValueFocus()};
  const auto first =
      std::find_if(kinds.begin(), kinds.end(), [&](const Focus& kind) { return kind.index() == expected.index(); });
  if (first != kinds.end()) std::rotate(kinds.begin(), first, first + 1);
  if (preparation_) preparation_->warmUp(kinds, atRest().quality, atRest().maxError);
}

bool ViewArea::isSettled() const {
  return std::all_of(volumes_.begin(), volumes_.end(),
                     [](const VolumeView* view) { return !view->isVisible() || view->isSettled(); });
}

bool ViewArea::isPreparing() const {
  return std::any_of(volumes_.begin(), volumes_.end(),
                     [](const VolumeView* view) { return view->lateness().isLate() && !view->awaitsOthers(); });
}

void ViewArea::takeBackWhatIsAwaited() {
  for (VolumeView* view : volumes_)
    if (view->lateness().isLate()) view->takeBackWhatIsAwaited();
}

void ViewArea::setAwaits(bool awaits) {
  for (VolumeView* view : volumes_) view->setAwaits(awaits);
  for (SliceView* view : slices_) view->setAwaits(awaits);
}

void ViewArea::toggleMaximised(QWidget* view) {
  if (maximised_) {
    showAll();
    return;
  }
  maximised_ = view;
  for (QSplitter* row : {upper_, lower_}) {
    for (int i = 0; i < row->count(); ++i) row->widget(i)->setVisible(row->widget(i) == view);
    row->setVisible(row->indexOf(view) >= 0);
  }
  view->setFocus();
}

void ViewArea::showAll() {
  maximised_ = nullptr;
  for (QSplitter* row : {upper_, lower_}) {
    for (int i = 0; i < row->count(); ++i) row->widget(i)->show();
    row->show();
  }
}

std::vector<std::pair<std::string, QWidget*>> ViewArea::namedViews() const {
  std::vector<std::pair<std::string, QWidget*>> views;
  for (VolumeView* view : volumes_) views.emplace_back(view->index() == 0 ? "C1" : "C2", view);
  constexpr const char* planes[] = {"axial", "sagittal", "coronal"};
  for (SliceView* view : slices_) views.emplace_back(planes[static_cast<std::size_t>(view->plane())], view);
  return views;
}

void ViewArea::setAtRest(Quality quality, std::optional<double> maxError) {
  pacer_->setAtRest(quality, maxError);
  for (VolumeView* view : volumes_) view->redraw();
  Q_EMIT atRestChanged();
}

void ViewArea::describe(io::Session& session) const {
  for (const VolumeView* view : volumes_) {
    const View picture = view->restView();
    io::SessionView& saved = session.views[static_cast<std::size_t>(view->index())];
    saved.size = picture.size;
    saved.pixelScale = picture.pixelScale;
  }
  session.quality = pacer_->atRest().quality;
  session.maxError = pacer_->atRest().maxError;
  session.maximised.clear();
  for (const auto& [name, view] : namedViews())
    if (view == maximised_) session.maximised = name;
  session.layout = saveLayout().toBase64().toStdString();
}

void ViewArea::restore(const io::Session& session) {
  setAtRest(session.quality, session.maxError);
  showAll();
  restoreLayout(QByteArray::fromBase64(QByteArray::fromStdString(session.layout)));
  for (const auto& [name, view] : namedViews())
    if (name == session.maximised) toggleMaximised(view);
}

QByteArray ViewArea::saveLayout() const {
  QByteArray layout;
  QDataStream stream(&layout, QIODevice::WriteOnly);
  for (const QSplitter* splitter : {rows_, upper_, lower_}) stream << splitter->saveState();
  return layout;
}

void ViewArea::restoreLayout(const QByteArray& layout) {
  QDataStream stream(layout);
  for (QSplitter* splitter : {rows_, upper_, lower_}) {
    QByteArray state;
    stream >> state;
    splitter->restoreState(state);
  }
}

}  // namespace fenestra::viewer
