#include "app/benchmark/Benchmark.h"

#include <utility>

#include "app/benchmark/Measurable.h"
#include "app/benchmark/Timed.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/placement/Placer.h"
#include "rendering/reference/Picture.h"
#include "rendering/scene/VisibleFraming.h"

namespace fenestra::bench {
namespace {

using Progress = std::function<void(double, std::string_view)>;

/// One pixel of each block of this side is compared with the reference.
constexpr int comparedBlock = 12;

struct Subject {
  std::string id, name;
  Scene scene;
  int cameras;  ///< along the path, as the figures of other machines
};

std::vector<Subject> subjectsOf(const Scene& opened) {
  const Scene plain = plainScene(opened);
  Scene lit = plain;
  lit.look.shading.enabled = true;
  return {{"plain", "plain volume rendering, unlit", plain, 2},
          {"lit", "plain volume rendering, lit", std::move(lit), 2},
          {"opened", "opened around the focus, lit", opened, 1}};
}

std::vector<Setting> settingsFor(bool isQuick) {
  std::vector<Setting> settings = unboundedSettings();
  const std::vector<double> bounds = isQuick ? std::vector{4.0} : std::vector{8.0, 4.0, 2.0, 1.0, 0.5};
  for (Setting& each : boundSettings(bounds)) settings.push_back(std::move(each));
  return settings;
}

/// What the first view's compared pixels should be.
std::vector<glm::dvec4> truthOf(const Measurable& what) {
  reference::PictureOptions options;
  options.pixels = what.pixels;
  reference::Stages stages;
  if (hasCutaway(what.scene)) stages = reference::geometricStages(what.scene, what.cameras.front(), what.size);
  return reference::picture(what.scene, what.cameras.front(), what.size, stages, options).final;
}

SceneTimes timesOf(const Subject& subject, Schedule schedule, const BenchmarkOptions& options) {
  Measurable what{subject.name, subject.scene, options.size, cameraPath(subject.scene, subject.cameras), {}, {}};
  if (!options.isQuick) {
    what.pixels = sampledPixels(options.size, comparedBlock);
    what.truths = {truthOf(what)};
  }
  const auto gpu = std::make_shared<GpuScene>();
  gpu->setSchedule(schedule);
  Renderer renderer(gpu);
  const std::vector<Setting> settings = settingsFor(options.isQuick);
  constexpr int rounds = 5;
  const std::vector<Measured> measured = measure(renderer, what, settings, options.isQuick ? 1 : rounds);
  SceneTimes times{subject.id, subject.name, {}};
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const Distribution& milliseconds = measured[i].milliseconds;
    SettingTime time{settings[i].name,
                     settings[i].maxError,
                     milliseconds.percentile(0.0),
                     milliseconds.median(),
                     milliseconds.max(),
                     {},
                     {}};
    if (!options.isQuick) {
      time.error = measured[i].errors.channel.percentile(99.99);
      time.rms = measured[i].errors.squares.rms();
    }
    times.settings.push_back(std::move(time));
  }
  return times;
}

/// Places the cameras, and turns the pair as a user does.
void measurePair(BenchmarkResult& result, const std::shared_ptr<GpuScene>& gpu, const Scene& scene,
                 const BenchmarkOptions& options) {
  placement::Placer placer;
  placement::Placement chosen;
  const placement::Measured* measured = nullptr;
  result.placing = timed([&] {
    measured = &placer.measure(*gpu, scene, {}, {});
    chosen = placement::choose(*measured, {}, placement::jointByDefault);
  });
  if (!chosen.c1 || !chosen.c2) return;
  const Framing framed = visibleFraming(shownVolume(scene), scene.look.context.shifted());
  std::vector<View> views;
  for (const std::size_t which : {*chosen.c1, *chosen.c2})
    views.push_back({Camera::fromDirection(measured->candidates[which].direction, framed), options.size});
  Renderer first(gpu), second(gpu);
  Distribution milliseconds;
  const int turns = options.isQuick ? 2 : 10;
  for (int turn = 0; turn <= turns; ++turn) {
    for (View& view : views) view.camera = view.camera.orbited(0.05, 0.0);
    const double time = timed([&] {
      first.render(scene, views[0]);
      second.render(scene, views[1]);
    });
    if (turn > 0) milliseconds.add(time);  // the first pair allocates its images
  }
  result.both = milliseconds.median();
}

}  // namespace

BenchmarkResult runBenchmark(const std::shared_ptr<GpuScene>& gpu, const Scene& opened, const BenchmarkOptions& options,
                             const Progress& progress) {
  const auto tell = [&](double share, std::string_view doing) {
    if (progress) progress(share, doing);
  };
  BenchmarkResult result;
  result.machine = thisMachine();
  result.size = options.size;
  result.isQuick = options.isQuick;
  tell(0.0, "first picture");
  {
    Renderer renderer(gpu);
    const View view{cameraPath(opened, 1).front(), options.size};
    result.first = timed([&] { renderer.render(opened, view); });
  }
  result.schedule = nameOf(gpu->schedule());
  tell(0.1, "both cameras");
  measurePair(result, gpu, opened, options);
  double done = 0.2;
  for (const Subject& subject : subjectsOf(opened)) {
    tell(done, subject.name);
    result.scenes.push_back(timesOf(subject, gpu->schedule(), options));
    done += 0.26;
  }
  tell(1.0, "done");
  return result;
}

}  // namespace fenestra::bench
