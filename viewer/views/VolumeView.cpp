#include "viewer/views/VolumeView.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <QMouseEvent>
#include <QOpenGLContext>
#include <QPainter>

#include "rendering/Renderer.h"
#include "rendering/gl/Context.h"
#include "rendering/gl/ShaderProgram.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/scene/Walls.h"
#include "viewer/model/ContextAnimation.h"
#include "viewer/model/DrawingTurns.h"
#include "viewer/model/Workspace.h"
#include "viewer/style/FocusRing.h"
#include "viewer/style/Overlay.h"
#include "viewer/tools/Canvas.h"
#include "viewer/views/PictureSurface.h"
#include "viewer/views/RefinedPicture.h"
#include "viewer/views/RenderProblem.h"
#include "viewer/views/ScenePreparation.h"

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

VolumeView::VolumeView(int index, Workspace& workspace, Shared shared, QWidget* parent)
    : QWidget(parent),
      index_(index),
      document_(workspace.document),
      cursor_(workspace.cursor),
      cameras_(workspace.cameras),
      options_(workspace.options),
      brush_(workspace.brush),
      active_(workspace.tool),
      canvas_(makeCanvas()),
      brushTool_(workspace.brush, document_, *canvas_),
      carveTool_(workspace.carving, document_, *canvas_),
      selectionTool_(workspace.selection, document_, *canvas_),
      toleranceWheel_(document_),
      clipTool_(document_, options_, active_, *canvas_),
      wallTool_(document_, cursor_, options_, active_, *canvas_),
      planeTool_(workspace, *canvas_),
      ballTool_(workspace, *canvas_),
      pathTool_(workspace.path, document_, options_, *canvas_),
      tools_({&brushTool_, &carveTool_, &selectionTool_, &toleranceWheel_, &clipTool_, &wallTool_, &planeTool_,
              &ballTool_, &pathTool_}),
      shared_(std::move(shared)),
      surface_(
          PictureSurface::make(shared_.software, *this, {.paint = [this] { paint(); }, .shown = [this] { shown(); }})) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("C%1").arg(index + 1));
  setProperty(FocusRing::drawnByWidget, true);
  setObjectName(QStringLiteral("volume%1").arg(index));
  rest_.setSingleShot(true);
  hover_.setSingleShot(true);
  connect(&hover_, &QTimer::timeout, this, &VolumeView::readUnderMouse);
  connect(&rest_, &QTimer::timeout, this, &VolumeView::settle);
  connect(&refining_, &QTimer::timeout, this, &VolumeView::refine);
  connect(&workspace.ball, &RegionBall::changed, this, &VolumeView::repaintSurface);
  connect(&workspace.path, &PathMode::changed, this, &VolumeView::repaintSurface);
  connect(&workspace.path, &PathMode::moved, this, &VolumeView::repaintSurface);
  connect(&workspace.planes, &SlicePlanes::changed, this, [this] {
    if (options_.planes()) repaintSurface();
  });
  followScene();
  followTools();
}

void VolumeView::followScene() {
  connect(&lateness_, &Lateness::changed, this, &VolumeView::repaintSurface);
  connect(&document_, &Document::volumeChanged, this, &VolumeView::forgetStudy);
  // A region that is being grown leaves the scene as it is.
  connect(&document_, &Document::focusChanged, this, &VolumeView::checkLate);
  connect(&document_, &Document::sceneChanged, this, [this] {
    disturb(ViewLink::count);
    if (!isPreparedDue_) prepare();
  });
  connect(&document_, &Document::strokesChanged, this, &VolumeView::refresh);
  connect(&cameras_, &ViewLink::changed, this, [this](int view) {
    if (view == index_) follow();
  });
  connect(&cameras_, &ViewLink::released, this, &VolumeView::settleAtOnce);
  connect(shared_.animation.get(), &ContextAnimation::moved, this, &VolumeView::redraw);
  connect(shared_.turns.get(), &DrawingTurns::turn, this, [this](int view) {
    if (view == index_ && !isPreparedDue_) draw(shownScene());
  });
  // The frame on screen ends before the next one begins.
  connect(shared_.turns.get(), &DrawingTurns::roundBegins, this, [this] { surface_->tellShown(); });
  connect(shared_.turns.get(), &DrawingTurns::roundEnded, this, [this] {
    if (isNew_) repaintSurface();
  });
  connect(&shared_.preparation->glContext(), &GlContext::freed, this, &VolumeView::contextFreed);
  connect(&options_, &ViewOptions::changed, this, [this] { repaintSurface(); });
}

void VolumeView::contextFreed() {
  if (due_ != Due::Nothing || !picture_) {
    // Each view draws in an event of its own.
    isPreparedDue_ = true;
    QMetaObject::invokeMethod(this, &VolumeView::drawPrepared, Qt::QueuedConnection);
  } else if (!settled_ && !rest_.isActive() && !refining_.isActive()) {
    // A picture at rest that waited for its preparation goes on.
    if (refinement_)
      refining_.start(0);
    else
      settle();
  }
}

void VolumeView::drawPrepared() {
  isPreparedDue_ = false;
  const Scene scene = shownScene(), held = shared_.preparation->held(scene);
  const bool isFirst = !hasPicture();
  draw(held);
  if (!isNew_) return;
  repaintSurface();
  if (isFirst) {  // at once: the other view draws in the next event
    surface_->widget().repaint();
    surface_->tellShown();
  }
  if (held == scene) return;
  settled_ = false;
  due_ = Due::Motion;
  rest_.start(restMilliseconds);
  askToDraw();
  becomeOld();
}

VolumeView::~VolumeView() {
  // GPU objects need their context when they are destroyed.
  shared_.preparation->glContext().run([this] { picture_.reset(); });
}

bool VolumeView::inGlContext(const std::function<void(const std::shared_ptr<GpuScene>&)>& work) {
  return shared_.preparation->glContext().run([&] { work(shared_.preparation->gpuScene()); });
}

bool VolumeView::isSettled() const {
  const bool told = index_ != 0 || !startsDue_;  // the slices draw the opening of the first view
  return (settled_ && !isNew_ && told && !shared_.animation->isRunning()) || !problem_.isEmpty() ||
         !document_.hasVolume();
}

void VolumeView::disturb(int views) {
  stopRefining();
  forgetStarts();
  settled_ = false;
  due_ = Due::Motion;
  moving_ = views;
  rest_.start(restMilliseconds);
  askToDraw();
  becomeOld();
}

void VolumeView::prepare() {
  if (!problem_.isEmpty() || !document_.hasVolume() || !isVisible() || !picture_) return;
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
  becomeOld();
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
  // A moving frame that is still due is left out: the picture at rest follows, after a draft where it takes long.
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
  isOld_ = false;
  checkLate();
  FramePacer& pacer = *shared_.pacer;
  pacer.refined(effort, refinedFor_, !compiled_);
  if (effort != pacer.atRest()) {
    refinement_ = pacer.atRest();
    pacer.refine(index_, 1);
  } else {
    stopRefining();
    settled_ = true;
    attemptOnPicture([this] { reportStarts(); });
    // Compile ahead, so that the first frame of a drag need not wait for its programs. A view that is still to be
    // refined would have to wait for that.
    if (const Effort moving = pacer.moving(ViewLink::count); moving != effort && pacer.mayRefine(index_))
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
  becomeOld();
}

void VolumeView::moveWalls() {
  if (!document_.hasVolume() || !dependsOnSlices(document_.look())) return;
  // The pictures of a motion show the slices, too.
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
    shared_.preparation->glContext().run([this] { picture_.reset(); });
    problem_ = tr("The 3-D views cannot be drawn. %1").arg(describeRenderProblem(error));
    Q_EMIT failed(problem_);
    repaintSurface();
  }
}

void VolumeView::attemptOnPicture(const std::function<void()>& work) {
  ScenePreparation& preparation = *shared_.preparation;
  if (!picture_ || !picture_->isShown() || !document_.hasVolume() || preparation.isBusy()) return;
  inGlContext([&](const std::shared_ptr<GpuScene>&) { attempt(work); });
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
  scene.look = shared_.animation->shown(std::move(scene.look));
  scene.look.strokes = strokesIn(index_, scene.look.strokes);
  return scene;
}

View VolumeView::viewFor(Effort effort) const {
  const double scale = devicePixelRatioF() * effort.scale;
  glm::ivec2 size = glm::max(glm::ivec2(glm::round(glm::dvec2(width(), height()) * scale)), glm::ivec2(1));
  Camera camera = shownCamera();
  if (effort.scale == FramePacer::halfScale) {
    const glm::ivec2 shown = glm::max(glm::ivec2(glm::round(glm::dvec2(width(), height()) * devicePixelRatioF())), 1);
    const glm::ivec2 covered = coveredAtHalf(shown);
    camera = camera.widened(shown, covered);
    size = covered / 2;
  }
  return {
      .camera = camera,
      .size = size,
      .pixelScale = scale,
      .quality = effort.quality,
      .maxError = effort.maxError,
      .frozen = cameras_.frozen()[static_cast<std::size_t>(index_)],
      // Left out of pictures that do not depend on them, which then need not be drawn again when slices move.
      .slices = dependsOnSlices(document_.look())
                    ? ShownSlices{cursor_.position(), document_.window(), document_.isInverted()}
                    : ShownSlices{},
      .occlusion = effort == shared_.pacer->atRest(),
  };
}

void VolumeView::askToDraw() { shared_.turns->ask(index_); }

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
  inGlContext([&](const std::shared_ptr<GpuScene>& gpuScene) {
    if (!picture_) picture_ = std::make_unique<RefinedPicture>(gpuScene);
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
  isOld_ = false;
  checkLate();
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
  // are made anew with each move of a drag, so their time is part of the next picture's, too.
  GpuScene::Versions after = gpuScene.versions();
  after.transfer = before.transfer;
  after.gaps = before.gaps;
  after.palette = before.palette;
  const bool usual = firstRuns == gl::ShaderProgram::firstRuns() && before == after;
  pacer.drew(effort, now() - start, usual);
  followed_ = pacer.frames();
}

}  // namespace fenestra::viewer
