// methods-bench FOLDER: what each method of opening the view shows of the focus, what it leaves of the context, and
// what it costs, over 48 views of each of four scenes. Writes FOLDER/methods.md, with HTML and CSV. Needs no display.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iostream>
#include <map>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/benchmark/Machine.h"
#include "app/benchmark/Numbers.h"
#include "app/benchmark/Timed.h"
#include "rendering/Renderer.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/reference/Certificate.h"
#include "rendering/scene/VisibleFraming.h"
#include "tests/bench/ContextMeasures.h"
#include "tests/bench/MethodVariants.h"
#include "tests/bench/MethodsPage.h"
#include "tests/bench/Subjects.h"

namespace fenestra::bench {
namespace {

struct Arguments {
  std::filesystem::path folder;
  glm::ivec2 size{112, 104};
  int compared = 3000;  ///< pixels of a picture: the least of which one may be off and 99.9 % be stated
  std::string only;
};

/// Twelve to a turn, at four heights.
std::vector<glm::dvec2> anglesOfViews() {
  std::vector<glm::dvec2> angles;
  for (const double elevation : {-45.0, -15.0, 15.0, 45.0})
    for (int i = 0; i < 12; ++i) angles.emplace_back(30.0 * i, elevation);
  return angles;
}

/// All of the focus of one grey.
Scene withFocusOf(double grey, Scene scene) {
  const glm::dvec3 colour(grey);
  Look& look = scene.look;
  look.method.of<methods::Walls>().outlines = false;  // on slices, beside the body
  look.focusAppearance.function.reset();
  look.focusAppearance.colour = colour;
  if (const auto* focus = std::get_if<LabelFocus>(&look.focus))
    for (const std::uint16_t label : focus->labels) {
      LabelSetting setting = settingFor(look.labels, label);
      setting.colour = colour;
      setting.function.reset();
      put(look.labels, setting);
    }
  return scene;
}

Scene withoutContext(Scene scene) {
  for (TransferFunction::Node& node : scene.look.context.function.nodes) node.properties.extinction = 0.0;
  scene.look.cutaway.enabled = false;
  return scene;
}

using Pixels = std::vector<std::uint8_t>;  ///< RGBA

Pixels drawn(Renderer& renderer, const Scene& scene, const View& view) {
  renderer.render(scene, view);
  return renderer.readPicture();
}

/// Mean over the pixels of the greatest difference of their channels, 0 to 255.
double meanDifference(const Pixels& a, const Pixels& b) {
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < a.size(); pixel += 4) {
    int greatest = 0;
    for (std::size_t i = pixel; i < pixel + 3; ++i) greatest = std::max(greatest, std::abs(int{a[i]} - int{b[i]}));
    sum += greatest;
  }
  return sum / (static_cast<double>(a.size()) / 4.0);
}

/// Light that comes from the focus, summed over the picture: the difference between a bright focus and a black one.
double focusIn(Renderer& renderer, const Scene& scene, const View& view) {
  constexpr double bright = 0.8;  // with room for highlights
  const Pixels shown = drawn(renderer, withFocusOf(bright, scene), view),
               black = drawn(renderer, withFocusOf(0.0, scene), view);
  double sum = 0.0;
  for (std::size_t i = 0; i < shown.size(); i += 4) sum += int{shown[i]} - int{black[i]};
  return sum;
}

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double medianOf(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// The effect of a method along the rays of its last picture.
MethodRays raysOf(const Scene& scene, glm::ivec2 size, Layers& layers) {
  if (!scene.look.cutaway.enabled) return {};
  const MethodStages stages = stagesOf(scene.look.method);
  if (stages.fading && !stages.fading->ghost) return {{}, {}, stages.fading};
  MethodRays rays{std::move(layers.tStart), {}, stages.fading};
  if (stages.lens)
    rays.shares = lensShares(*stages.lens, radiusOf(*stages.lens, scene.volume->grid), size, layers.tContext,
                             layers.tFocus, layers.lens);
  else if (stages.keepsRemoved())
    for (int j = 0; j < size.y; ++j)
      for (int i = 0; i < size.x; ++i)
        rays.shares.push_back(static_cast<float>(faintShare(stages.sparseness, stages.faintOpacity, i, j)));
  return rays;
}

/// A method with a renderer of its own, so that none finds another's stages done, and its measurements in each view.
struct Measured {
  std::string name;
  Scene scene;
  Renderer renderer;
  bool moves = false;  ///< MethodVariant::moves
  std::vector<double> seen{}, volume{}, surface{}, wrong{}, turned{}, wall{}, work{};
  int wrongPairs = 0, pairs = 0;
  double error = 0.0;

  MethodFigures figures(const Measured& plain) const {
    return {name,
            meanOf(seen),
            *std::min_element(seen.begin(), seen.end()),
            moves ? notTold : meanOf(volume),
            moves ? notTold : meanOf(surface),
            moves ? notTold : meanOf(wrong),
            wrongPairs,
            pairs,
            *std::max_element(turned.begin(), turned.end()),
            medianOf(wall),
            meanOf(work) / meanOf(plain.work),
            error};
  }
};

/// Measures all methods on one subject, view by view, so that a busy machine is busy for all of them.
class SceneMeasurement {
 public:
  SceneMeasurement(Scene scene, double aroundFocus, const Arguments& arguments, bool byProcessorTime,
                   const gl::SharedPrograms& programs)
      : scene_(blackBehind(std::move(scene))),
        arguments_(arguments),
        byProcessorTime_(byProcessorTime),
        framing_(framingOf(scene_, aroundFocus)),
        focusAlone_(std::make_shared<GpuScene>(programs)),
        sampler_(scene_) {
    // What pictures read of the context's surface is dropped when a picture does not read it.
    std::map<bool, std::shared_ptr<GpuScene>> gpu;
    for (const bool readsSurface : {false, true}) gpu[readsSurface] = std::make_shared<GpuScene>(programs);
    const auto add = [&](const std::string& name, Scene changed, bool moves) {
      // A body that is moved is one of its own on the graphics card.
      const auto own = moves ? std::make_shared<GpuScene>(programs) : gpu[readsContextSurface(changed)];
      methods_.push_back({name, std::move(changed), Renderer(own), moves});
    };
    for (const MethodVariant& variant : methodVariants()) {
      Scene opened = scene_;
      opened.look.method = variant.method;
      add(variant.caption, std::move(opened), variant.moves);
    }
    Scene closed = scene_;
    closed.look.cutaway.enabled = false;
    add("nothing opened", std::move(closed), false);
  }

  SceneFigures measure(const std::string& id, const std::string& name) {
    for (const glm::dvec2 angles : anglesOfViews()) measureView(angles);
    SceneFigures figures{id, name, methods_.back().figures(methods_.back()), {}};
    for (std::size_t i = 0; i + 1 < methods_.size(); ++i)
      figures.methods.push_back(methods_[i].figures(methods_.back()));
    return figures;
  }

 private:
  static Scene blackBehind(Scene scene) {
    scene.look.background = glm::dvec3(0.0);
    scene.look.backdrop = Backdrop::Plain;
    return scene;
  }

  static Framing framingOf(const Scene& scene, double aroundFocus) {
    if (!(aroundFocus > 0.0)) return visibleFraming(shownVolume(scene), scene.look.context.shifted());
    const glm::dvec3 centre = reference::focusCentre(scene);
    std::vector<glm::dvec3> points;
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-aroundFocus, aroundFocus}) {
        points.push_back(centre);
        points.back()[axis] += side;
      }
    return {centre, std::move(points)};
  }

  View viewFrom(glm::dvec2 angles) const {
    constexpr double methodPictureWidth = 700.0;  // pixels, which w_open of 24 refers to
    return {.camera = Camera::fromAngles(angles.x, angles.y, framing_),
            .size = arguments_.size,
            .pixelScale = arguments_.size.x / methodPictureWidth};
  }

  void measureView(glm::dvec2 angles) {
    const View view = viewFrom(angles), turned = viewFrom(angles + glm::dvec2(1.0, 0.0));
    const bool first = methods_.front().seen.empty();
    const double alone = focusIn(focusAlone_, withoutContext(scene_), view);
    std::optional<ViewSamples> samples;
    for (Measured& method : methods_) {
      if (first) method.renderer.render(method.scene, turned);  // compiles its programs
      const std::clock_t before = std::clock();
      method.wall.push_back(timed([&] { method.renderer.render(method.scene, view); }));
      const double work = 1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
      method.work.push_back(byProcessorTime_ ? work : method.wall.back());
      const Pixels picture = method.renderer.readPicture();
      Layers layers = method.renderer.readLayers();
      // The first method opens, so that its picture has the hits that all share.
      if (!samples)
        samples.emplace(sampler_, view.camera, view.size, layers.tContext, layers.tFocus, ViewSamples::Sampling{});
      if (first)
        method.error = reference::certify(layers.final, method.scene, view, {.pixels = arguments_.compared}).within;
      if (!method.moves) addContext(method, *samples, raysOf(method.scene, view.size, layers));
      method.seen.push_back(focusIn(method.renderer, method.scene, view) / alone);
      method.turned.push_back(meanDifference(picture, drawn(method.renderer, method.scene, turned)));
    }
  }

  static void addContext(Measured& method, const ViewSamples& samples, const MethodRays& rays) {
    const ContextKept kept = samples.kept(rays);
    const DepthOrder order = samples.order(rays);
    method.volume.push_back(kept.volume);
    method.surface.push_back(kept.surface);
    method.wrong.push_back(order.wrong);
    method.wrongPairs += order.wrongPairs;
    method.pairs += order.pairs;
  }

  Scene scene_;
  Arguments arguments_;
  bool byProcessorTime_;
  Framing framing_;
  Renderer focusAlone_;
  RaySampler sampler_;
  std::vector<Measured> methods_;  ///< the last one opens nothing
};

void run(const Arguments& arguments) {
  const egl::EglContext context;
  const Machine machine = thisMachine();
  Views views;
  views.only = arguments.only;
  const Subjects subjects = methodSubjects(views);
  for (const std::string& line : subjects.missing) std::cerr << line << '\n';
  const auto programs = std::make_shared<gl::ComputePrograms>();
  Report report;
  report.title = "Methods side by side";
  report.text = "Written by `methods-bench`, on " + machine.processors + ", OpenGL by " + machine.renderer +
                "; pictures of " + std::to_string(arguments.size.x) + "×" + std::to_string(arguments.size.y) +
                " pixels. In the minute before, other programs kept " + fixed(machine.load, 1) +
                " processors busy.\n\n" + methodsText();
  std::vector<SceneFigures> scenes;
  for (const Subject& subject : subjects.here) {
    SceneMeasurement measurement(io::readStudy(subject.options).drawn.scene(), subject.aroundFocus, arguments,
                                 machine.isSoftware, programs);
    scenes.push_back(measurement.measure(subject.id, subject.name));
    report.sections = {summaryOf(scenes)};
    for (const SceneFigures& scene : scenes) report.sections.push_back(sectionOf(scene));
    write(report, arguments.folder, "methods");
    std::cerr << subject.id << '\n';
  }
}

}  // namespace
}  // namespace fenestra::bench

int main(int argc, char** argv) {
  using namespace fenestra::bench;
  Arguments arguments;
  CLI::App program{"Measures what each method shows, leaves and costs.", "methods-bench"};
  program.add_option("FOLDER", arguments.folder, "where the page goes")->required();
  program.add_option("--only", arguments.only, "scenes whose id starts with it");
  program.add_option("--pixels", arguments.compared, "compared with the reference, of one picture a method");
  CLI11_PARSE(program, argc, argv);
  try {
    run(arguments);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "methods-bench: " << error.what() << '\n';
    return 1;
  }
}
