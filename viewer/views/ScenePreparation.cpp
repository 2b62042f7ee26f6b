#include "viewer/views/ScenePreparation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include "rendering/Renderer.h"
#include "rendering/scene/Edges.h"
#include "rendering/scene/Explosion.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/FaintLabels.h"
#include "rendering/scene/Importance.h"
#include "rendering/scene/Maximum.h"
#include "rendering/scene/Occlusion.h"
#include "rendering/scene/Peel.h"
#include "rendering/scene/Walls.h"
#include "rendering/settings/StartingLook.h"

namespace fenestra::viewer {
namespace {

/// Milliseconds of a trial picture until it is asked again whether to stop: short enough for a window that waits, and
/// long enough for whole tiles. A limit of 0 cuts every pass into single groups, each of them waited for.
constexpr double trialSlice = 12.0;

/// The parameters of the chosen method that decide on programs; all others have their defaults.
ChosenMethod programsOf(const Method& method) {
  return std::visit(
      []<class M>(const M& chosen) -> ChosenMethod {
        if constexpr (requires { chosen.programs(); }) return chosen.programs();
        return M{};
      },
      method.chosen());
}

/// A few voxels of CT with a focus of the kind; the programs that draw them also draw a patient. The software
/// rasteriser compiles a program anew for textures of which another side is a power of two. So sides are as in most
/// scans: slices have sides of a power of two, their number is none, and what shows reaches to no face. Volumes that
/// are drawn as splines are resampled more often: none of the sides of theirs, of their bricks and of their
/// coefficients is a power of two.
Scene sampleScene(const Focus& kind, Reconstruction reconstruction = Reconstruction::Linear) {
  const bool isLinear = reconstruction == Reconstruction::Linear;
  const int side = isLinear ? 16 : 18;
  auto volume = std::make_shared<Volume>();
  volume->grid.dims = {side, side, isLinear ? side - 1 : side};
  volume->modality = Modality::CT;
  volume->voxels = Voxels(ScalarType::Int16, volume->grid.voxelCount());
  const auto values = volume->voxels.as<std::int16_t>();
  for (int z = 1; z < side - 2; ++z)
    for (int y = 1; y < side - 1; ++y)
      for (int x = 1; x < side - 1; ++x) {
        const std::size_t at = volume->grid.offset({x, y, z});
        values[at] = static_cast<std::int16_t>(at % 2000);
      }
  volume->computeRange();
  Scene scene;
  scene.look = startingLook();
  scene.look.reconstruction = reconstruction;
  scene.volume = volume;
  if (std::holds_alternative<LabelFocus>(kind) || std::holds_alternative<RegionFocus>(kind)) {
    auto labels = std::make_shared<LabelMap>();
    labels->grid = volume->grid;
    labels->voxels = Voxels(ScalarType::UInt8, volume->grid.voxelCount());
    labels->voxels.as<std::uint8_t>()[labels->grid.offset(glm::ivec3(side / 2))] = 1;
    labels->labels = {{1, "", {1.0, 1.0, 1.0}}, {2, "", {1.0, 0.0, 0.0}}};
    scene.labels = labels;
    scene.look.focus = LabelFocus{{1}};
    const auto* expected = std::get_if<LabelFocus>(&kind);
    if (expected && expected->labels.size() > 1) scene.look.focus = LabelFocus{{1, 2}};  // of two colours
  } else if (std::holds_alternative<ValueFocus>(kind)) {
    scene.look.focus = ValueFocus{{1000.0, 1500.0}};
  }
  scene.look.context.function.nodes = {{500.0, {glm::dvec3(1.0), 0.0}}, {1000.0, {glm::dvec3(1.0), 1.0}}};
  return scene;
}

/// The middle of a view, of pixels of the same size: its picture runs the same programs in little time. The software
/// rasteriser compiles a program anew for textures of other sides that are powers of two. So the view's sides are
/// halved as stages halve them, as long as no other one becomes a power of two: then the levels of both are alike.
View middleOf(View view) {
  constexpr int longest = 48, longestAlike = 128;  // pixels
  const auto isPower = [](glm::ivec2 size) {
    return glm::bvec2(std::has_single_bit(static_cast<unsigned>(size.x)),
                      std::has_single_bit(static_cast<unsigned>(size.y)));
  };
  glm::ivec2 size = view.size;
  while (std::max(size.x, size.y) > longest) {
    const glm::ivec2 half = (size + 1) / 2;
    if (std::max(size.x, size.y) <= longestAlike && isPower(half) != isPower(view.size)) break;
    size = half;
  }
  const double share = static_cast<double>(size.y) / view.size.y;
  const double halfAngle = glm::radians(view.camera.verticalFov) * 0.5;
  view.camera.verticalFov = glm::degrees(2.0 * std::atan(std::tan(halfAngle) * share));
  view.camera.orthographicHeight *= share;
  view.size = size;
  return view;
}

/// Brings `gpuScene` up to date. True where only the focus and what casts shadows have changed, and the focus's
/// textures are of the kind they were: for others, drivers compile the programs again.
bool followsFocus(GpuScene& gpuScene, const Scene& scene, GpuScene::Use use) {
  GpuScene::Versions before = gpuScene.versions();
  const bool hadNormals{gpuScene.focusSmooth()};
  const auto peeled = gpuScene.peeled(scene);
  gpuScene.update(peeled ? peeled->scene : scene, use);
  before.focus = gpuScene.versions().focus;
  before.palette = gpuScene.versions().palette;
  before.occluders = gpuScene.versions().occluders;
  return before == gpuScene.versions() && hadNormals == static_cast<bool>(gpuScene.focusSmooth());
}

}  // namespace

ScenePreparation::ScenePreparation(ChooseSchedule chooseSchedule) : chooseSchedule_(std::move(chooseSchedule)) {}

ScenePreparation::~ScenePreparation() {
  glContext_.run([this] { gpuScene_.reset(); });
}

ScenePreparation::Kind ScenePreparation::kindOf(const Scene& scene, const View& view) const {
  const Look& look = scene.look;
  const auto* labels = std::get_if<LabelFocus>(&look.focus);
  ShownVolume volume = shownVolume(scene);
  volume.removed = nullptr;  // what remains is drawn by the same programs
  return {.volume = std::move(volume),
          .focus = look.focus.index(),
          .manyLabels = labels && labels->labels.size() > 1,
          .smoothed = labels && look.labelSmoothing != LabelSmoothing::Off,
          .byValue = hasFocusFunction(scene),
          .protects = hasCutaway(scene) && !labelsWith(LabelRole::Protected, scene).empty(),
          .translucent = hasBodies(scene),
          .lit = look.shading.enabled,
          .cutaway = hasCutaway(scene),
          .method = hasCutaway(scene) || fadingOf(look) || wallsOf(look) || explosionOf(look) || maximumOf(look)
                        ? programsOf(look.method)
                        : ChosenMethod(),
          .occluded = hasOcclusion(look) && view.occlusion,
          .contextLayer = look.contextLayer.strength > 0.0,
          .contextLines = look.contextLayer.strength > 0.0 && look.contextLayer.share < 1.0,
          .clipped = halfSpaces(look.clipping, scene.volume->grid).empty() && !explosionOf(look) ? 0
                     : look.clipping.grey                                                        ? 2
                                                                                                 : 1,
          .exempts = !look.clipping.exempt.empty(),
          .levels = !importanceLevels(scene).empty(),
          .apart = hasCutaway(scene) && (view.frozen || look.cutaway.axisOffset != 0.0),
          .smoothEdges = hasSmoothEdges(look, view),
          .sampling = samplingOf(view, scene.volume->grid, look.shading.enabled),
          .chosenBound = gpuScene_->chosenBound(scene, view)};
}

bool ScenePreparation::isKnown(const Kind& kind) const {
  return std::find(known_.begin(), known_.end(), kind) != known_.end();
}

bool ScenePreparation::isReady(const Scene& scene, const View& view) {
  if (failure_ && failed_ == shownVolume(scene)) std::rethrow_exception(failure_);
  if (glContext_.isBusy()) {
    if (isAhead_) glContext_.askToStop();
    return false;
  }
  const Kind kind = kindOf(scene, view);
  if (isKnown(kind) && gpuScene_->holds(scene, view.occlusion)) return true;
  isAhead_ = false;
  start(scene, view, kind);
  return false;
}

Scene ScenePreparation::held(Scene scene) const {
  if (!prepared_ || scheduledFor_.lock() != scene.volume || glContext_.isBusy() || gpuScene_->holds(scene, false))
    return scene;
  Scene earlier = scene;
  earlier.labels = prepared_->labels;
  earlier.structures = prepared_->structures;
  earlier.look.focus = prepared_->look.focus;
  earlier.look.labelSmoothing = prepared_->look.labelSmoothing;
  if (peelOf(earlier.look) || peelOf(prepared_->look)) {
    earlier.look.method = prepared_->look.method;
    earlier.look.cutaway.enabled = prepared_->look.cutaway.enabled;
  }
  return gpuScene_->holds(earlier, false) ? earlier : scene;
}

void ScenePreparation::prepareAhead(const Scene& scene, const View& view) {
  if (glContext_.isBusy()) return;  // the other thread has the scene
  const Kind kind = kindOf(scene, view);
  if (isKnown(kind)) return goOn();
  isAhead_ = true;
  start(scene, view, kind);
}

void ScenePreparation::warmUp(const std::vector<Focus>& kinds, Quality atRest, std::optional<double> maxError,
                              bool isRead) {
  const auto add = [&](const Scene& scene, Quality quality, bool rests) {
    const Camera camera = Camera::standard(StandardView::Anterior, scene.volume->grid);
    View view{.camera = camera, .size = glm::ivec2(80), .quality = quality};
    view.occlusion = rests;
    if (rests) view.maxError = maxError;
    samples_.push_back({scene, view});
  };
  const auto addFirst = [&](const Scene& scene) { add(scene, Quality::Normal, false); };
  const auto addMoving = [&](const Scene& scene) { add(scene, Quality::Draft, false); };
  const auto addLast = [&](const Scene& scene) { add(scene, atRest, true); };
  // What most scans are drawn by comes first. Small volumes, of which many are drawn as splines, are read soonest: what
  // they need at the start comes next.
  const Scene expected = sampleScene(kinds.front()), spline = sampleScene(kinds.front(), Reconstruction::Smoother);
  addFirst(expected);
  addFirst(spline);
  addLast(spline);
  addLast(expected);
  addMoving(expected);
  addMoving(spline);
  const std::size_t first = samples_.size();
  for (const Focus& focus : std::span(kinds).subspan(1)) {
    const Scene scene = sampleScene(focus);
    addFirst(scene);
    addMoving(scene);
    addLast(scene);
  }
  if (isRead) later_ = samples_.size() - first;
  goOn();
}

void ScenePreparation::goOn() {
  if (!known_.empty()) later_ = 0;
  if (glContext_.isBusy() || samples_.size() <= later_) return;
  isAhead_ = true;
  auto isDone = std::make_shared<bool>(false);
  glContext_.runBehind(
      [this, sample = samples_.front(), isDone](const std::atomic<bool>& stop) {
        const auto gpuScene = std::make_shared<GpuScene>(gpuScene_->programs());
        Renderer trial(gpuScene);
        trial.begin(sample.scene, sample.view);
        while (!*isDone && !stop) *isDone = trial.advance(trialSlice);
      },
      [this, isDone](std::exception_ptr error) {
        // A driver's error is reported once a picture needs the programs.
        if (error) samples_.clear();
        if (!*isDone) return;
        samples_.pop_front();
        if (!glContext_.isAskedToStop()) goOn();
      });
}

void ScenePreparation::runBehind(GlContext::Work work, GlContext::Done done) {
  glContext_.stop();
  isAhead_ = false;
  glContext_.runBehind(std::move(work), std::move(done));
}

void ScenePreparation::forgetFailure() {
  failure_ = nullptr;
  failed_ = {};
}

void ScenePreparation::letGo() {
  glContext_.stop();
  forgetFailure();
  prepared_.reset();
  known_.clear();
  scheduledFor_.reset();
  // A scene that is hardly larger than none takes the study's place.
  glContext_.run([this] { gpuScene_->update(sampleScene({}), GpuScene::Use::WithoutOcclusion); });
}

void ScenePreparation::start(const Scene& scene, const View& view, const Kind& kind) {
  // For another volume, compiling the same programs again takes almost no time.
  std::erase_if(known_, [&](const Kind& known) { return known.volume != kind.volume; });
  const bool isNew = scheduledFor_.lock() != scene.volume;
  const bool hasPrograms = isKnown(kind);
  scheduledFor_ = scene.volume;
  auto isDone = std::make_shared<bool>(false);
  glContext_.runBehind(
      [this, scene, view, isNew, hasPrograms, isDone](const std::atomic<bool>& stop) {
        if (isNew && chooseSchedule_) chooseSchedule_(gpuScene_, scene, view);
        const auto use = view.occlusion ? GpuScene::Use::Pictures : GpuScene::Use::WithoutOcclusion;
        if (hasPrograms && followsFocus(*gpuScene_, scene, use)) return;
        Renderer trial(gpuScene_);
        const View middle = middleOf(view);
        trial.begin(scene, middle);
        while (!*isDone && !stop) *isDone = trial.advance(trialSlice);
        // What puts a picture on screen has a program, too.
        if (*isDone) trial.readPresented(middle.size);
      },
      [this, scene, kind, isDone](std::exception_ptr error) {
        schedule_ = gpuScene_->schedule();
        if (*isDone) known_.push_back(kind);
        if (!error) {
          prepared_ = scene;
          prepared_->volume = nullptr;  // a closed volume takes no memory
          prepared_->removed = nullptr;
          return;
        }
        failure_ = error;
        failed_ = shownVolume(scene);
      });
}

}  // namespace fenestra::viewer
