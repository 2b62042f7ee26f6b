#include "viewer/views/VolumeView.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <QOpenGLContext>
#include <QPainter>

#include "rendering/gl/Context.h"
#include "rendering/gl/ShaderProgram.h"
#include "rendering/scene/Walls.h"
#include "viewer/model/Brush.h"
#include "viewer/model/Document.h"
#include "viewer/model/SelectionBrush.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/ViewLink.h"
#include "viewer/model/ViewOptions.h"
#include "viewer/style/FocusRing.h"
#include "viewer/style/Overlay.h"
#include "viewer/views/PictureSurface.h"
#include "viewer/views/RenderProblem.h"

namespace fenestra::viewer {
namespace {

constexpr int restMilliseconds = 100;
/// A slice of refinement: short enough that the window answers.
constexpr double sliceMilliseconds = 30.0;
constexpr int turnMilliseconds = 4;  ///< until a view asks again whether it is its turn

/// Milliseconds on a steady clock.
double now() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

VolumeView::VolumeView(int index, Document& document, SliceCursor& cursor, ViewLink& cameras, ViewOptions& options,
                       Brush& brush, Carving& carving, SelectionBrush& selection, Shared shared, QWidget* parent)
    : QWidget(parent),
      index_(index),
      document_(document),
      cursor_(cursor),
      cameras_(cameras),
      options_(options),
      brush_(brush),
      carving_(carving),
      brushTool_(brush, document, canvas()),
      carveTool_(carving, document, spaceCanvas([](const Hit& hit) { return hit.start; })),
      selection_(selection),
      selectionTool_(selection, document, spaceCanvas([this](const Hit& hit) { return surfaceAt(hit); })),
      clipTool_(document, clipCanvas()),
      wallTool_(document, cursor, wallCanvas()),
      toleranceWheel_(document),
      shared_(std::move(shared)),
      surface_(
          PictureSurface::make(shared_.software, *this, {.paint = [this] { paint(); }, .shown = [this] { shown(); }})) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setProperty(FocusRing::drawnByWidget, true);
  setObjectName(QStringLiteral("volume%1").arg(index));
  rest_.setSingleShot(true);
  hover_.setSingleShot(true);
  connect(&hover_, &QTimer::timeout, this, &VolumeView::readUnderMouse);
  connect(&rest_, &QTimer::timeout, this, &VolumeView::settle);
  connect(&refining_, &QTimer::timeout, this, &VolumeView::refine);
  connect(&document, &Document::volumeChanged, this, [this] {
    problem_.clear();  // another volume may fit where the last one did not
    shared_.preparation->forgetFailure();
    reduction_.clear();
  });
  // A scene is prepared and about to be drawn: no other one is prepared before it.
  const auto isAwaited = std::make_shared<bool>(false);
  connect(&document, &Document::sceneChanged, this, [this, isAwaited] {
    disturb(ViewLink::count);
    if (!*isAwaited) prepare();
  });
  connect(&document, &Document::strokesChanged, this, &VolumeView::refresh);
  followTools();
  connect(&cameras, &ViewLink::changed, this, [this](int view) {
    if (view == index_) follow();
  });
  connect(&cameras, &ViewLink::released, this, &VolumeView::settleAtOnce);
  connect(shared_.flight.get(), &ContextFlight::moved, this, &VolumeView::redraw);
  connect(shared_.turns.get(), &DrawingTurns::turn, this, [this, isAwaited](int view) {
    if (view == index_ && !*isAwaited) draw(shownScene());
  });
  connect(shared_.turns.get(), &DrawingTurns::roundEnded, this, [this] {
    if (isNew_) repaintSurface();
  });
  connect(&shared_.preparation->context(), &RenderContext::freed, this, [this, isAwaited] {
    // What was prepared is drawn before anything changes the scene again, or a slider that is drawn along would keep
    // the views from drawing; each still in an event of its own.
    const auto drawPrepared = [this, isAwaited] {
      *isAwaited = false;
      const Scene scene = shownScene(), held = shared_.preparation->held(scene);
      draw(held);
      if (isNew_) repaintSurface();
      if (held == scene || !isNew_) return;
      settled_ = false;
      due_ = Due::Motion;
      rest_.start(restMilliseconds);
      askToDraw();
    };
    if (due_ != Due::Nothing || !picture_) {
      *isAwaited = true;
      QMetaObject::invokeMethod(this, drawPrepared, Qt::QueuedConnection);
    } else if (!settled_ && !rest_.isActive() && !refining_.isActive()) {
      settle();
    }
  });
  connect(&options, &ViewOptions::changed, this, [this] { repaintSurface(); });
}

VolumeView::~VolumeView() {
  // GPU objects need their context when they are destroyed.
  shared_.preparation->context().run([this] { picture_.reset(); });
}

bool VolumeView::inContext(const std::function<void(const std::shared_ptr<GpuScene>&)>& work) {
  return shared_.preparation->context().run([&] { work(shared_.preparation->gpuScene()); });
}

bool VolumeView::isSettled() const {
  const bool told = index_ != 0 || !startsDue_;  // the slices draw the opening of the first view
  return (settled_ && !isNew_ && told && !shared_.flight->isFlying()) || !problem_.isEmpty() || !document_.hasVolume();
}

void VolumeView::disturb(int views) {
  stopRefining();
  forgetStarts();
  settled_ = false;
  due_ = Due::Motion;
  moving_ = views;
  rest_.start(restMilliseconds);
  askToDraw();
}

void VolumeView::prepare() {
  if (!problem_.isEmpty() || !document_.hasVolume() || !isVisible() || !picture_ || !picture_->isShown()) return;
  attempt([this] { shared_.preparation->isReady(shownScene(), viewFor(motion())); });
}

Effort VolumeView::motion() const { return shared_.pacer->moving(moving_, shared_.pacer->leads(index_)); }

void VolumeView::follow() {
  const bool both = cameras_.isLinked() || cameras_.isFlying();
  FramePacer& pacer = *shared_.pacer;
  const int every = pacer.framesPerFollowing();
  const bool skips =
      cameras_.isLinked() && !pacer.leads(index_) && isVisible() && every > 1 && pacer.frames() - followed_ < every;
  if (!skips) return disturb(both ? ViewLink::count : 1);
  stopRefining();
  forgetStarts();
  settled_ = false;
  due_ = Due::Motion;
  rest_.start(restMilliseconds);
}

void VolumeView::redraw() { disturb(ViewLink::count); }

void VolumeView::settle() {
  if (settled_) return;
  if (held_ || !picture_ || !picture_->isShown()) {
    rest_.start(restMilliseconds);
    if (!held_) askToDraw();
    return;
  }
  due_ = Due::Nothing;
  const std::optional<Effort> first = shared_.pacer->beforeRest();
  refinement_ = first.value_or(shared_.pacer->atRest());
  shared_.pacer->refine(index_, first ? 0 : 1);
  refining_.start(0);
}

void VolumeView::settleAtOnce() {
  if (!rest_.isActive()) return;
  // A frame that is still due is left out: the picture at rest follows, with a draft before it where it takes long.
  rest_.stop();
  settle();
}

void VolumeView::stopRefining() {
  refining_.stop();
  refinement_.reset();
  if (picture_) picture_->drop();
  shared_.pacer->refine(index_, std::nullopt);
}

void VolumeView::refine() {
  if (held_ || !isVisible() || !refinement_) {
    stopRefining();
    rest_.start(restMilliseconds);
    return;
  }
  const bool isTurn = shared_.pacer->mayRefine(index_);
  refining_.setInterval(isTurn ? 0 : turnMilliseconds);
  if (!isTurn) return;
  const Effort effort = *refinement_;
  bool isReady = false;
  attempt([&] { isReady = shared_.preparation->isReady(shownScene(), viewFor(effort)); });
  if (!isReady) return refining_.stop();  // until the context is free
  bool done = false;
  attemptOnPicture([&] {
    const double start = now();
    const std::size_t firstRuns = gl::ShaderProgram::firstRuns();
    if (!picture_->isRefining()) {
      refinedFor_ = 0.0;
      compiled_ = false;
      picture_->refine(shownScene(), viewFor(effort), effort == shared_.pacer->atRest());
    }
    done = picture_->advance(sliceMilliseconds);
    if (done) surface_->take(picture_->shown());
    compiled_ |= firstRuns != gl::ShaderProgram::firstRuns();
    refinedFor_ += now() - start;
  });
  if (done) refined(effort);
}

void VolumeView::refined(Effort effort) {
  isUnpainted_ = true;
  FramePacer& pacer = *shared_.pacer;
  pacer.refined(effort, refinedFor_, !compiled_);
  if (effort != pacer.atRest()) {
    refinement_ = pacer.atRest();
    pacer.refine(index_, 1);
  } else {
    stopRefining();
    settled_ = true;
    attemptOnPicture([this] { reportStarts(); });
    // Or else the first frame of a drag would wait for its programs.
    if (const Effort moving = pacer.moving(ViewLink::count); moving != effort)
      shared_.preparation->prepareAhead(shownScene(), viewFor(moving));
  }
  repaintSurface();
}

void VolumeView::refresh() {
  stopRefining();
  forgetStarts();
  settled_ = false;
  rest_.stop();
  due_ = Due::Strokes;
  moving_ = 1;
  askToDraw();
}

void VolumeView::moveWalls() {
  if (!document_.hasVolume() || !dependsOnSlices(document_.look())) return;
  // While something else moves, its pictures show the slices, too.
  if (due_ == Due::Motion || rest_.isActive())
    disturb(ViewLink::count);
  else
    refresh();
}

void VolumeView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  surface_->widget().setGeometry(rect());
  disturb(ViewLink::count);
}

Camera VolumeView::shownCamera() const {
  return cameras_.camera(index_).fittedTo(static_cast<double>(width()) / std::max(1, height()));
}

void VolumeView::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    stopRefining();
    shared_.preparation->context().run([this] { picture_.reset(); });
    problem_ = tr("The 3-D views cannot be drawn. %1").arg(describeRenderProblem(error));
    Q_EMIT failed(problem_);
    repaintSurface();
  }
}

void VolumeView::attemptOnPicture(const std::function<void()>& work) {
  ScenePreparation& preparation = *shared_.preparation;
  if (!picture_ || !picture_->isShown() || !document_.hasVolume() || preparation.isBusy()) return;
  inContext([&](const std::shared_ptr<GpuScene>&) { attempt(work); });
}

void VolumeView::shown() {
  if (picture_ && picture_->isShown()) Q_EMIT drawn(std::exchange(isUnseen_, false));
  if (std::exchange(isTimed_, false)) shared_.pacer->end(now());
}

void VolumeView::forgetStarts() {
  startsDue_ = true;
  if (index_ == 0) Q_EMIT raysStarted(nullptr);
}

void VolumeView::reportStarts() {
  if (index_ != 0 || !picture_ || !document_.hasVolume() || !std::exchange(startsDue_, false)) return;
  auto [camera, layers] = picture_->shown().readOpening();
  auto starts = std::make_shared<RayStarts>();
  *starts = {camera, document_.scene().volume->grid, layers.size, std::move(layers.tContext), std::move(layers.tStart)};
  Q_EMIT raysStarted(std::move(starts));
}

std::optional<FinishedPicture> VolumeView::finishedPicture() {
  if (!settled_ || !problem_.isEmpty() || !document_.hasVolume()) return {};
  std::optional<FinishedPicture> finished;
  attemptOnPicture([&] {
    Renderer& renderer = picture_->shown();
    const View& view = picture_->shownView();
    const std::vector<std::uint8_t> rounded = renderer.readPicture();
    QImage image(view.size.x, view.size.y, QImage::Format_RGB32);
    image.fill(toColour(document_.look().background));
    QPainter(&image).drawImage(0, 0,
                               QImage(rounded.data(), view.size.x, view.size.y, QImage::Format_RGBA8888_Premultiplied));
    finished = FinishedPicture{shownScene(), view, renderer.readLayers().final, std::move(image)};
  });
  return finished;
}

Scene VolumeView::shownScene() const {
  Scene scene = document_.scene();
  scene.look = shared_.flight->shown(std::move(scene.look));
  scene.look.strokes = strokesIn(index_, scene.look.strokes);
  return scene;
}

View VolumeView::viewFor(Effort effort) const {
  const double scale = devicePixelRatioF() * effort.scale;
  return {
      .camera = shownCamera(),
      .size = glm::max(glm::ivec2(glm::round(glm::dvec2(width(), height()) * scale)), glm::ivec2(1)),
      .pixelScale = scale,
      .quality = effort.quality,
      .maxError = effort.maxError,
      .frozen = cameras_.frozen()[static_cast<std::size_t>(index_)],
      // Other pictures do not depend on them, and need not be drawn again when they change.
      .slices = dependsOnSlices(document_.look())
                    ? ShownSlices{cursor_.position(), document_.window(), document_.isInverted()}
                    : ShownSlices{},
  };
}

void VolumeView::draw(const Scene& scene) {
  const bool isDue = due_ != Due::Nothing || !picture_ || !picture_->isShown();
  if (!isDue || !problem_.isEmpty() || !document_.hasVolume() || !isVisible()) return;
  attempt([this, &scene] {
    if (!drawDue(scene)) return;
    const QString notice = QString::fromStdString(shared_.preparation->gpuScene()->reductionNotice());
    if (notice != std::exchange(reduction_, notice) && !notice.isEmpty()) Q_EMIT reduced(notice);
  });
}

bool VolumeView::drawDue(const Scene& scene) {
  FramePacer& pacer = *shared_.pacer;
  const Effort rest = pacer.atRest();
  View full = viewFor(rest);
  if (picture_) full.slices = picture_->shownView().slices;
  const bool onlyStrokes = due_ == Due::Strokes && picture_ && picture_->showsFull(full);
  const Effort effort = onlyStrokes ? rest : motion();
  const View view = viewFor(effort);
  if (!shared_.preparation->isReady(scene, view)) return false;
  if (due_ == Due::Strokes && !onlyStrokes) rest_.start(restMilliseconds);
  inContext([&](const std::shared_ptr<GpuScene>& gpuScene) {
    if (!picture_) picture_.emplace(gpuScene);
    if (onlyStrokes)
      picture_->draw(scene, view, true);
    else
      drawTimed(scene, view, effort, *gpuScene);
    surface_->take(picture_->shown());
  });
  due_ = Due::Nothing;
  settled_ = effort == rest;
  isNew_ = true;
  isUnpainted_ = true;
  if (settled_) attemptOnPicture([this] { reportStarts(); });
  return true;
}

void VolumeView::drawTimed(const Scene& scene, const View& view, Effort effort, const GpuScene& gpuScene) {
  FramePacer& pacer = *shared_.pacer;
  const double start = now();
  pacer.begin(effort, start);
  const std::size_t firstRuns = gl::ShaderProgram::firstRuns();
  const GpuScene::Versions before = gpuScene.versions();
  picture_->draw(scene, view, effort == pacer.atRest());
  gl::finish();
  // The first picture of a kind also compiles programs or uploads voxels. Tables of the transfer function and colours
  // are made anew with each move of a drag: they belong to what its next picture will take.
  GpuScene::Versions after = gpuScene.versions();
  after.transfer = before.transfer;
  after.gaps = before.gaps;
  after.palette = before.palette;
  const bool usual = firstRuns == gl::ShaderProgram::firstRuns() && before == after;
  pacer.drew(effort, now() - start, usual);
  followed_ = pacer.frames();
}

std::optional<QPointF> VolumeView::widgetFromWorld(glm::dvec3 world) const {
  return widgetFromWorld(world, shownCamera());
}

std::optional<QPointF> VolumeView::widgetFromWorld(glm::dvec3 world, const Camera& camera) const {
  if (!document_.hasVolume()) return std::nullopt;
  const double aspect = static_cast<double>(width()) / std::max(1, height());
  const glm::dvec4 clip = camera.clipFromWorld(aspect, document_.scene().volume->grid) * glm::dvec4(world, 1.0);
  if (!(clip.w > 0.0)) return std::nullopt;
  return QPointF(0.5 * (clip.x / clip.w + 1.0) * width(), 0.5 * (1.0 - clip.y / clip.w) * height());
}

glm::dvec3 VolumeView::shownAt(glm::dvec3 world) const {
  return picture_ && picture_->isShown() ? picture_->shown().shownAt(world) : world;
}

glm::dvec2 VolumeView::pixelAt(QPointF position) const {
  const glm::ivec2 size = picture_->shownView().size;
  return {position.x() / width() * size.x, position.y() / height() * size.y};
}

BrushTool::Canvas VolumeView::canvas() {
  return {
      .view = index_,
      .pick = [this](QPointF position, BrushMode mode, std::optional<glm::dvec3> before) -> std::optional<BrushPoint> {
        std::optional<BrushPoint> point;
        attemptOnPicture([&] { point = picture_->shown().pickBrush(pixelAt(position), mode, before); });
        return point;
      },
      .picture = [this]() -> std::vector<std::uint8_t> {
        std::vector<std::uint8_t> picture;
        attemptOnPicture([&] {
          picture_->draw(shownScene(), viewFor(shared_.pacer->atRest()), true);
          surface_->take(picture_->shown());
          picture = picture_->shown().readPicture();
        });
        return picture;
      },
      .redraw = [this] { repaintSurface(); },
  };
}

ClipTool::Canvas VolumeView::clipCanvas() {
  return {.widgetFromWorld = [this](glm::dvec3 world) { return widgetFromWorld(world); },
          .axes =
              [this] {
                const Camera::Axes axes = shownCamera().axes();
                return std::array{axes.right, axes.up};
              },
          .section = []() -> std::optional<ClipTool::Canvas::Section> { return std::nullopt; },
          .shows = [this] { return options_.clipHandles() && !takesStrokes(); }};
}

WallTool::Canvas VolumeView::wallCanvas() {
  return {.widgetFromWorld = [this](glm::dvec3 world) { return widgetFromWorld(world); },
          .axes =
              [this] {
                const Camera::Axes axes = shownCamera().axes();
                return std::array{axes.right, axes.forward};
              },
          .shows = [this] { return options_.crosshair() && !brush_.isActive(); }};
}

std::optional<VolumeView::Hit> VolumeView::pick(QPointF position) {
  std::optional<Hit> hit;
  attemptOnPicture([&] {
    Renderer& picture = picture_->shown();
    const std::optional<PickedPlace> picked = picture.pickPlace(pixelAt(position));
    if (!picked) return;
    const std::optional<BrushPoint> opened = picture.pickBrush(pixelAt(position), BrushMode::Open);
    const bool moved = picture.movesContext();
    hit = Hit{picked->place, moved ? picked->ray : rayThrough(position), opened ? opened->removed : 0.0, moved};
  });
  return hit;
}

double VolumeView::mmPerPixel(const Camera& camera) const {
  const double seen =
      camera.projection == Projection::Orthographic
          ? camera.orthographicHeight
          : 2.0 * glm::distance(camera.eye, camera.target) * std::tan(glm::radians(camera.verticalFov) * 0.5);
  return seen / std::max(1, height());
}

}  // namespace fenestra::viewer
