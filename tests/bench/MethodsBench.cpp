// methods-bench FOLDER: what each method of opening the view shows of the focus, what it leaves of the context, and
// what it costs, over 48 views of each of the report's subjects. Writes FOLDER/methods.md, with HTML and CSV. Needs no
// display.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/benchmark/Machine.h"
#include "app/benchmark/Text.h"
#include "app/benchmark/Timed.h"
#include "rendering/Renderer.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/reference/Certificate.h"
#include "rendering/scene/Fading.h"
#include "rendering/scene/Framing.h"
#include "tests/bench/MethodVariants.h"
#include "tests/bench/Report.h"
#include "tests/bench/Subjects.h"

namespace fenestra::bench {
namespace {

struct Arguments {
  std::filesystem::path folder;
  glm::ivec2 size{280, 260};
  int compared = 500;  ///< pixels of a picture
  std::string only;
};

/// Twelve to a turn, at four heights.
std::vector<glm::dvec2> anglesOfViews() {
  std::vector<glm::dvec2> angles;
  for (const double elevation : {-45.0, -15.0, 15.0, 45.0})
    for (int i = 0; i < 12; ++i) angles.emplace_back(30.0 * i, elevation);
  return angles;
}

/// All of the focus in one colour: what a picture shows of the focus is then linear in that colour.
Scene inOneColour(Scene scene, glm::dvec3 colour, bool lit) {
  scene.look.shading.enabled = lit && scene.look.shading.enabled;
  scene.look.focusAppearance.function.reset();
  scene.look.focusAppearance.colour = colour;
  if (const auto* focus = std::get_if<LabelFocus>(&scene.look.focus))
    for (const std::uint16_t label : focus->labels) {
      LabelSetting setting = settingFor(scene.look.labels, label);
      setting.colour = colour;
      setting.function.reset();
      put(scene.look.labels, setting);
    }
  return scene;
}

Scene withoutContext(Scene scene) {
  for (TransferFunction::Node& node : scene.look.context.function.nodes) node.properties.extinction = 0.0;
  scene.look.cutaway.enabled = false;
  return scene;
}

using Pixels = std::vector<std::uint8_t>;  ///< RGBA

/// Greatest difference of a pixel's channels, 0 to 255.
int difference(const Pixels& a, const Pixels& b, std::size_t pixel) {
  int greatest = 0;
  for (std::size_t i = 4 * pixel; i < 4 * pixel + 3; ++i)
    greatest = std::max(greatest, std::abs(int{a[i]} - int{b[i]}));
  return greatest;
}

double meanDifference(const Pixels& a, const Pixels& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size() / 4; ++i) sum += difference(a, b, i);
  return sum / (static_cast<double>(a.size()) / 4.0);
}

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Of a method, over all views.
struct Measured {
  std::vector<double> seen;    ///< share of the focus
  std::vector<double> kept;    ///< share of the body's picture
  std::vector<double> turned;  ///< mean change of a pixel between views 1° apart, 1/255
  std::vector<double> milliseconds;
  double error = 0.0;  ///< of 99.9 % of the pixels of the first view, 1/255

  double medianTime() const {
    std::vector<double> sorted = milliseconds;
    std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

/// Measures methods on one subject.
class MethodMeasurement {
 public:
  MethodMeasurement(Scene scene, const Arguments& arguments)
      : scene_(std::move(scene)),
        arguments_(arguments),
        framing_(visibleFraming(shownVolume(scene_), scene_.look.context.shifted())),
        gpu_(std::make_shared<GpuScene>()),
        plain_(gpu_) {
    scene_.look.background = glm::dvec3(0.0);
  }

  /// A renderer of its own, so that no method finds another's stages done.
  Measured measure(const Method& method) {
    Renderer renderer(gpu_);
    Scene opened = scene_;
    opened.look.method = method;
    Scene closed = scene_;
    closed.look.cutaway.enabled = false;
    Measured measured;
    for (const glm::dvec2 angles : anglesOfViews()) {
      const View view = viewFrom(angles);
      measured.milliseconds.push_back(timed([&] { renderer.render(opened, view); }));
      const Pixels picture = renderer.readPicture();
      if (measured.kept.empty())
        measured.error =
            reference::certify(renderer.readLayers().final, opened, view, {.pixels = arguments_.compared}).within;
      measured.kept.push_back(keptOf(picture, drawn(plain_, closed, view)));
      // How much fades depends on the light.
      const auto fading = fadingOf(opened.look);
      const bool lit = fading && fading->followsLight();
      measured.seen.push_back(focusIn(renderer, opened, view, lit) /
                              focusIn(plain_, withoutContext(scene_), view, lit));
      measured.turned.push_back(
          meanDifference(picture, drawn(renderer, opened, viewFrom(angles + glm::dvec2(1.0, 0.0)))));
    }
    return measured;
  }

  /// The greatest mean change between views 1° apart where nothing is opened.
  double changeOfPlain() {
    Scene closed = scene_;
    closed.look.cutaway.enabled = false;
    double greatest = 0.0;
    for (const glm::dvec2 angles : anglesOfViews())
      greatest = std::max(greatest, meanDifference(drawn(plain_, closed, viewFrom(angles)),
                                                   drawn(plain_, closed, viewFrom(angles + glm::dvec2(1.0, 0.0)))));
    return greatest;
  }

 private:
  View viewFrom(glm::dvec2 angles) const {
    constexpr double methodPictureWidth = 700.0;  // pixels, which w_open of 24 refers to
    return {.camera = Camera::fromAngles(angles.x, angles.y, framing_),
            .size = arguments_.size,
            .pixelScale = arguments_.size.x / methodPictureWidth};
  }
  static Pixels drawn(Renderer& renderer, const Scene& scene, const View& view) {
    renderer.render(scene, view);
    return renderer.readPicture();
  }
  /// Weights of the focus, summed over the picture.
  static double focusIn(Renderer& renderer, const Scene& scene, const View& view, bool lit) {
    const Pixels white = drawn(renderer, inOneColour(scene, glm::dvec3(1.0), lit), view);
    const Pixels black = drawn(renderer, inOneColour(scene, glm::dvec3(0.0), lit), view);
    double sum = 0.0;
    for (std::size_t i = 0; i < white.size(); i += 4) sum += int{white[i + 1]} - int{black[i + 1]};
    return sum;
  }
  static double keptOf(const Pixels& picture, const Pixels& plain) {
    constexpr int same = 8, opaque = 128;
    std::size_t body = 0, kept = 0;
    for (std::size_t i = 0; i < plain.size() / 4; ++i) {
      if (plain[4 * i + 3] < opaque) continue;
      ++body;
      kept += difference(picture, plain, i) <= same;
    }
    return static_cast<double>(kept) / static_cast<double>(std::max<std::size_t>(body, 1));
  }

  Scene scene_;
  Arguments arguments_;
  Framing framing_;
  std::shared_ptr<GpuScene> gpu_;
  Renderer plain_;
};

const char* const text =
    "Every method at its defaults, the same focus, context and cameras; nothing was tuned for these scenes. 48 views: "
    "twelve "
    "to a turn, at elevations of -45°, -15°, 15° and 45°, normal quality. Widths in pixels are those of pictures 700 "
    "pixels "
    "wide.\n\n"
    "*Focus seen*: how much of the focus reaches the eye, weighted by what it is seen through, of what would if there "
    "were "
    "no context; from unlit pictures with the focus once white and once black, or of the context-preserving method, "
    "whose fading "
    "depends on the light, from lit ones. Edges and borders over the focus count "
    "as "
    "hiding it. *Least*: the worst view. *Picture kept*: the share of the body's pixels that are within 8/255 of the "
    "picture in which nothing is opened. *Turning*: the largest mean change of a pixel between views 1° apart, in "
    "1/255; "
    "where nothing is opened, it is the number in brackets beside the subject. *ms*: one frame after the camera moved, "
    "the "
    "median of the views. *Error*: at least 99.9 % of the pixels of the first view are within so many 1/255 of the "
    "method's own reference, with 95 % confidence, or the greatest of those compared where they are too few to say so. "
    "Pairs of structures in the wrong order of depth are not counted: no method here draws one before another that "
    "lies "
    "nearer, except by what it leaves out.";

Section sectionOf(const Subject& subject, const Arguments& arguments) {
  MethodMeasurement measurement(app::loadScene(subject.options).scene, arguments);
  Section section;
  section.title = subject.name + " (" + number(measurement.changeOfPlain()) + ")";
  Table table{
      subject.id, {"method", "focus seen", "least", "picture kept", "least kept", "turning", "ms", "error"}, {}};
  for (const MethodVariant& variant : methodVariants()) {
    const Measured measured = measurement.measure(variant.method);
    const auto least = [](const std::vector<double>& values) {
      return *std::min_element(values.begin(), values.end());
    };
    table.rows.push_back({variant.caption, fixed(meanOf(measured.seen), 3), fixed(least(measured.seen), 3),
                          fixed(meanOf(measured.kept), 3), fixed(least(measured.kept), 3),
                          number(*std::max_element(measured.turned.begin(), measured.turned.end())),
                          fixed(measured.medianTime(), 1), number(measured.error)});
    std::cerr << subject.id << ", " << variant.name << '\n';
  }
  section.tables.push_back(std::move(table));
  return section;
}

void run(const Arguments& arguments) {
  const egl::EglContext context;
  Views views;
  views.only = arguments.only;
  const Subjects subjects = reportSubjects(views);
  Report report;
  report.title = "Methods side by side";
  report.text = "Written by `methods-bench`, on " + processors() + ", OpenGL by " + context.description() +
                "; pictures of " + std::to_string(arguments.size.x) + "×" + std::to_string(arguments.size.y) +
                " pixels.\n\n" + text;
  for (const std::string& line : subjects.missing) std::cerr << line << '\n';
  for (const Subject& subject : subjects.here) {
    report.sections.push_back(sectionOf(subject, arguments));
    write(report, arguments.folder, "methods");
  }
}

}  // namespace
}  // namespace fenestra::bench

int main(int argc, char** argv) {
  using namespace fenestra::bench;
  Arguments arguments;
  CLI::App program{"Measures what each method shows, leaves and costs.", "methods-bench"};
  program.add_option("FOLDER", arguments.folder, "where the page goes")->required();
  program.add_option("--only", arguments.only, "subjects whose id starts with it");
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
