#pragma once
// Keeps the window answering while a scene becomes drawable: another thread uploads its voxels and compiles the
// programs that draw it.

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "rendering/ViewSampling.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/scene/View.h"
#include "viewer/views/ChooseSchedule.h"
#include "viewer/views/GlContext.h"

namespace fenestra::viewer {

class ScenePreparation {
 public:
  explicit ScenePreparation(ChooseSchedule chooseSchedule);
  ~ScenePreparation();

  GlContext& glContext() { return glContext_; }
  const std::shared_ptr<GpuScene>& gpuScene() const { return gpuScene_; }

  /// True: the picture can be drawn now, and its renderer will not be held up. False: another thread prepares it, or
  /// does other work; ask again when the context is freed(). Throws the error that preparing this volume ended with.
  bool isReady(const Scene& scene, const View& view);
  /// Compiles for a picture that may follow, unless something else is under way or asked for meanwhile.
  void prepareAhead(const Scene& scene, const View& view);
  /// Compiles what draws a CT with each kind of focus, the first one first, while nothing else is asked for. Where a
  /// study `isRead` meanwhile, which needs the processor, the other kinds wait until it is drawn.
  void warmUp(const std::vector<Focus>& kinds, Quality atRest, std::optional<double> maxError, bool isRead);
  /// Other work in the context on another thread; see GlContext. Work for a picture that may follow ends first.
  void runBehind(GlContext::Work work, GlContext::Done done);
  /// Another thread has the context, and a view waits for its work.
  bool isBusy() const { return glContext_.isBusy() && !isAhead_; }
  /// `scene` as far as the device holds it: where its focus or its peeled layer is not prepared yet, with those that
  /// were prepared last.
  Scene held(Scene scene) const;
  /// The schedule of the last scene that was prepared.
  Schedule schedule() const { return schedule_; }
  /// Lets a volume that could not be prepared be tried again.
  void forgetFailure();
  /// No study is open: its textures are freed, and nothing of it is kept.
  void letGo();

 private:
  /// Everything that decides which programs draw a picture.
  struct Kind {
    ShownVolume volume;
    std::size_t focus = 0;
    bool manyLabels = false, smoothed = false, byValue = false, protects = false, translucent = false, lit = false,
         cutaway = false;
    ChosenMethod method{};  ///< without the numbers that decide on no program
    bool occluded = false;  ///< ambient occlusion or shadows
    bool contextLayer = false, contextLines = false;
    int clipped = 0;       ///< 2: with grey faces
    bool exempts = false;  ///< clipping spares some labels
    bool levels = false;   ///< several levels of importance
    bool apart = false;    ///< another camera cuts the opening
    bool smoothEdges = false;
    ViewSampling sampling{};
    std::optional<double> chosenBound{};  ///< BoundChoice.h
    bool operator==(const Kind&) const = default;
  };
  /// While no other thread has the scene.
  Kind kindOf(const Scene& scene, const View& view) const;
  bool isKnown(const Kind& kind) const;
  void start(const Scene& scene, const View& view, const Kind& kind);
  /// Goes on with warmUp().
  void goOn();

  ChooseSchedule chooseSchedule_;
  std::shared_ptr<GpuScene> gpuScene_ = std::make_shared<GpuScene>();
  std::weak_ptr<const Volume> scheduledFor_;  ///< the volume that a schedule was chosen for
  std::vector<Kind> known_;
  std::optional<Scene> prepared_;  ///< the last scene that another thread has prepared
  Schedule schedule_ = Schedule::Plain;
  struct Sample {
    Scene scene;
    View view;
  };
  std::deque<Sample> samples_;  ///< pictures whose programs are to be compiled
  std::size_t later_ = 0;       ///< so many of them, the last ones, wait until a study is drawn
  bool isAhead_ = false;        ///< the background work is for a picture that is not due yet
  std::exception_ptr failure_;
  ShownVolume failed_;
  GlContext glContext_;
};

}  // namespace fenestra::viewer
