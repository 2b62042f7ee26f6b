#include "viewer/views/ViewArea.h"

#include <algorithm>
#include <array>
#include <cstddef>

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
  place(arrangements().front());
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    for (const auto& [name, view] : namedViews())
      if (view == now && view != reason_) active_ = view;
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
    volumes_.push_back(view);
  }
}

void ViewArea::addReason(const GlSupport& gl) {
  auto* reason =
      new QLabel(tr("3-D views are not available here.\n\n%1\n\nThe slices work without it.").arg(gl.problem));
  reason->setObjectName(QStringLiteral("noOpenGl"));
  reason->setAlignment(Qt::AlignCenter);
  reason->setWordWrap(true);
  reason->setMargin(24);
  reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
  reason_ = reason;
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
    connect(view, &SliceView::scaled, this, [this, view] { Q_EMIT scaled(view); });
    slices_.push_back(view);
  }
}

std::optional<Schedule> ViewArea::schedule() const {
  return preparation_ ? std::optional(preparation_->schedule()) : std::nullopt;
}

void ViewArea::warmUp(const Focus& expected, bool isRead) {
  std::vector<Focus> kinds{Focus(), LabelFocus(), ValueFocus()};
  const auto first =
      std::find_if(kinds.begin(), kinds.end(), [&](const Focus& kind) { return kind.index() == expected.index(); });
  if (first != kinds.end()) std::rotate(kinds.begin(), first, first + 1);
  if (first != kinds.end()) kinds.front() = expected;
  if (preparation_) preparation_->warmUp(kinds, atRest().quality, atRest().maxError, isRead);
}

void ViewArea::letGo() {
  if (preparation_) preparation_->letGo();
}

bool ViewArea::isSettled() const {
  return std::all_of(volumes_.begin(), volumes_.end(),
                     [](const VolumeView* view) { return !view->isVisible() || view->isSettled(); });
}

bool ViewArea::isPreparing() const {
  return std::any_of(volumes_.begin(), volumes_.end(), [](const VolumeView* view) {
    return view->isVisible() && view->lateness().isLate() && !view->awaitsOthers();
  });
}

void ViewArea::takeBackWhatIsAwaited() {
  for (VolumeView* view : volumes_)
    if (view->isVisible() && view->lateness().isLate()) view->takeBackWhatIsAwaited();
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
  showViews();
  view->setFocus();
}

void ViewArea::showAll() {
  maximised_ = nullptr;
  showViews();
}

void ViewArea::showViews() {
  for (QSplitter* group : {upper_, lower_}) {
    bool any = false;
    for (const auto& [name, view] : namedViews()) {
      if (group->indexOf(view) < 0) continue;
      const bool shows = maximised_ ? view == maximised_ : arrangement_->shows(name);
      view->setVisible(shows);
      any |= shows;
    }
    group->setVisible(any);
  }
  if (!active_ || active_->isHidden())
    for (const auto& [name, view] : namedViews())
      if (!view->isHidden() && view != reason_) {
        active_ = view;
        break;
      }
  Q_EMIT arranged();
  Q_EMIT lateChanged();  // a view that is late may be out of sight now
}

void ViewArea::showNeighbour(int step) {
  std::vector<QWidget*> views;
  for (const auto& [name, view] : namedViews())
    if (view != reason_ && (maximised_ || arrangement_->shows(name))) views.push_back(view);
  const auto count = static_cast<std::ptrdiff_t>(views.size());
  const auto now = std::find(views.begin(), views.end(), maximised_ ? maximised_ : active_) - views.begin();
  QWidget* next = views[static_cast<std::size_t>((now % count + step + count) % count)];
  if (maximised_) {
    maximised_ = next;
    showViews();
  }
  next->setFocus(Qt::ShortcutFocusReason);
}

void ViewArea::place(const Arrangement& arrangement) {
  arrangement_ = &arrangement;
  const auto across = arrangement.groupsLie == Qt::Vertical ? Qt::Horizontal : Qt::Vertical;
  rows_->setOrientation(arrangement.groupsLie);
  for (QSplitter* group : {upper_, lower_}) group->setOrientation(across);
  const auto views = namedViews();
  const auto add = [&](QSplitter& group, const char* name) {
    for (const auto& [each, view] : views)
      if (name && each == name) group.addWidget(view);
  };
  for (const char* name : arrangement.groups[0]) add(*upper_, name);
  for (const char* name : arrangement.groups[1]) add(*lower_, name);
  for (const auto& [name, view] : views)
    if (!arrangement.shows(name)) lower_->addWidget(view);
  rows_->setSizes({10 * arrangement.shares[0], 10 * arrangement.shares[1]});
  for (QSplitter* group : {upper_, lower_}) group->setSizes(QList<int>(group->count(), 1000));
  showViews();
}

void ViewArea::arrange(const Arrangement& arrangement) {
  const bool hadFocus = active_ && active_->hasFocus();
  if (maximised_) showAll();
  if (&arrangement == arrangement_) return;
  layouts_[arrangement_->id] = saveLayout();
  place(arrangement);
  if (const auto before = layouts_.find(arrangement.id); before != layouts_.end()) restoreLayout(before->second);
  if (hadFocus) active_->setFocus();
}

std::vector<std::pair<std::string, QWidget*>> ViewArea::namedViews() const {
  std::vector<std::pair<std::string, QWidget*>> views;
  if (reason_) views.emplace_back("C1", reason_);
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
  stream << QByteArray(arrangement_->id);
  return layout;
}

void ViewArea::restoreLayout(const QByteArray& layout) {
  if (layout.isEmpty()) return;
  QDataStream stream(layout);
  std::array<QByteArray, 3> states;
  for (QByteArray& state : states) stream >> state;
  QByteArray id;
  if (!stream.atEnd()) stream >> id;
  const Arrangement* wanted = findArrangement(id.toStdString());
  if (!wanted) wanted = &arrangements().front();
  if (wanted != arrangement_) place(*wanted);
  const std::array<QSplitter*, 3> splitters{rows_, upper_, lower_};
  for (std::size_t i = 0; i < splitters.size(); ++i) {
    const Qt::Orientation orientation = splitters[i]->orientation();
    splitters[i]->restoreState(states[i]);
    splitters[i]->setOrientation(orientation);  // whatever a damaged state says
  }
}

}  // namespace fenestra::viewer
