// motion-bench: how sharp pictures in motion are at which rate. Plays a drag of the camera and one of a slider, draws
// each picture at several scales as the window does while something moves, and compares what is shown with the picture
// of the full resolution, of the same camera. The same at normal quality, whose edges are smooth. Writes motion.md and
// its charts.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/benchmark/ColourError.h"
#include "io/ImageWriter.h"
#include "rendering/Renderer.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gpu/GpuScene.h"
#include "tests/bench/Chart.h"
#include "tests/bench/MarkdownTable.h"
#include "tests/bench/Subjects.h"

namespace fenestra::bench {
namespace {

namespace fs = std::filesystem;

/// Rendered pixels per shown pixel along a side; the window's lie between the first and the last.
constexpr std::array scales{0.1875, 0.25, 0.3125, 0.375, 0.4375, 0.5, 0.625, 0.75, 1.0};
constexpr int cameras = 16, widths = 8;

struct Options {
  fs::path folder, pictures;  ///< no pictures where the latter is empty
  glm::ivec2 size{0};
  std::string only;
};

/// One of both views at one moment of a drag.
struct Moment {
  Scene scene;
  std::array<Camera, 2> pair;
};

/// Turns of 1 to 3 degrees from picture to picture, then the opening's width from step to step.
std::vector<Moment> dragOf(const Scene& scene, const Camera& camera) {
  std::vector<Moment> drag;
  Camera turned = camera;
  for (int i = 0; i < cameras; ++i) {
    drag.push_back({scene, {turned, turned.beside()}});
    turned = turned.orbited(glm::radians(2.0 + std::sin(1.1 * i)), glm::radians(0.7 * std::cos(0.9 * i)));
  }
  for (int i = 1; scene.look.cutaway.enabled && i <= widths; ++i) {
    drag.push_back(drag[cameras - 1]);
    drag.back().scene.look.cutaway.openWidth += 3.0 * i;
  }
  return drag;
}

/// Errors of what is shown, in 1/255, over all pixels of both views.
class Errors {
 public:
  void add(const std::vector<std::uint8_t>& here, const std::vector<std::uint8_t>& truth) {
    for (std::size_t i = 0; i < truth.size(); i += 4) {
      int worst = 0;
      for (std::size_t c = i; c < i + 3; ++c) {
        const int difference = std::abs(here[c] - truth[c]);
        squares_ += difference * difference;
        worst = std::max(worst, difference);
      }
      ++pixels_[static_cast<std::size_t>(worst)];
      ++count_;
    }
  }
  double rms() const { return std::sqrt(squares_ / (3.0 * static_cast<double>(count_))); }
  /// The worst channel's error that 99 % of the pixels keep.
  int percentile99() const {
    std::size_t within = 0;
    int error = -1;
    while (100 * within < 99 * count_) within += pixels_[static_cast<std::size_t>(++error)];
    return error;
  }

 private:
  double squares_ = 0.0;
  std::size_t count_ = 0;
  std::array<std::size_t, 256> pixels_{};  ///< by the error of their worst channel
};

struct AtScale {
  double scale = 0.0;
  Distribution milliseconds{};  ///< of both views' pictures, until they can be painted
  Errors errors{};
};

struct Measured {
  std::string id, name;
  std::vector<AtScale> draft{}, normal{};
};

class Player {
 public:
  Player(const Options& options, const Subject& subject)
      : options_(options),
        id_(subject.id),
        name_(subject.name),
        study_(io::readStudy(subject.options)),
        gpu_(std::make_shared<GpuScene>()) {
    for (int view = 0; view < 2; ++view) renderers_.emplace_back(gpu_);
  }

  Measured play() {
    const std::vector<Moment> drag = dragOf(study_.drawn.scene(), study_.view->camera);
    const std::vector<std::array<Bytes, 2>> truths = truthsOf(drag);
    Measured result{id_, name_};
    for (const double scale : scales) {
      result.draft.push_back(playAt(scale, Quality::Draft, drag, truths));
      result.normal.push_back(playAt(scale, Quality::Normal, drag, truths));
      std::cerr << id_ << ": scale " << scale << ", " << result.draft.back().milliseconds.median() << " ms, RMS "
                << result.draft.back().errors.rms() << '\n';
    }
    return result;
  }

 private:
  using Bytes = std::vector<std::uint8_t>;

  AtScale playAt(double scale, Quality quality, const std::vector<Moment>& drag,
                 const std::vector<std::array<Bytes, 2>>& truths) {
    AtScale at{scale};
    const View view = viewAt(scale, quality);
    show(drag.back(), view);  // compiles programs
    for (std::size_t i = 0; i < drag.size(); ++i) {
      const auto begun = std::chrono::steady_clock::now();
      const std::array<Bytes, 2> shown = show(drag[i], view);
      at.milliseconds.add(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count());
      for (std::size_t camera = 0; camera < 2; ++camera) at.errors.add(shown[camera], truths[i][camera]);
      if (i == cameras / 2 && quality == Quality::Draft) save(fixed(scale, 4), shown[0]);
    }
    return at;
  }

  /// Without occlusion and shadow, as pictures in motion are.
  View viewAt(double scale, Quality quality) const {
    View view;
    view.size = glm::max(glm::ivec2(glm::round(glm::dvec2(options_.size) * scale)), glm::ivec2(1));
    view.pixelScale = scale;
    view.quality = quality;
    view.occlusion = false;
    return view;
  }

  std::array<Bytes, 2> show(const Moment& moment, View view) {
    std::array<Bytes, 2> shown;
    for (std::size_t i = 0; i < 2; ++i) {
      view.camera = moment.pair[i];
      renderers_[i].render(moment.scene, view);
      shown[i] = renderers_[i].readPresented(options_.size);
    }
    return shown;
  }

  std::vector<std::array<Bytes, 2>> truthsOf(const std::vector<Moment>& drag) {
    std::vector<std::array<Bytes, 2>> truths;
    for (const Moment& moment : drag) truths.push_back(show(moment, viewAt(1.0, Quality::Normal)));
    save("truth", truths[cameras / 2][0]);
    return truths;
  }

  void save(const std::string& name, Bytes pixels) const {
    if (options_.pictures.empty()) return;
    for (std::size_t i = 0; i < pixels.size(); i += 4) std::swap(pixels[i], pixels[i + 2]);
    io::writePng(options_.pictures / (id_ + "-" + name + ".png"), options_.size, 4, pixels);
  }

  const Options& options_;
  std::string id_, name_;
  io::Study study_;
  std::shared_ptr<GpuScene> gpu_;
  std::vector<Renderer> renderers_;
};

/// The head and the torso as they open, and the head without an opening.
std::vector<Subject> subjectsOf(const Options& options) {
  std::vector<Subject> result;
  for (Subject& subject : reportSubjects({.only = options.only}).here) {
    if (subject.id != "head" && subject.id != "torso") continue;
    subject.options.makeStarting();
    result.push_back(subject);
    if (subject.id != "head") continue;
    subject.id = "head-plain";
    subject.name = "Visible Human head, CT: no opening";
    subject.options.look.cutaway.enabled = false;
    result.push_back(subject);
  }
  return result;
}

ChartSeries seriesOf(const std::string& name, const std::vector<AtScale>& measured) {
  ChartSeries series{name, {}};
  for (const AtScale& at : measured) {
    const double error = at.errors.rms();
    series.points.push_back({1000.0 / at.milliseconds.median(), error, error, error, fixed(at.scale, 2)});
  }
  return series;
}

Chart chartOf(const Measured& measured) {
  return {"motion-" + measured.id,
          measured.name,
          {"pictures of both views a second"},
          {"RMS, 1/255"},
          {seriesOf("draft, as shown", measured.draft), seriesOf("normal, with smooth edges", measured.normal)}};
}

std::string page(const std::vector<Measured>& all, const Options& options, const std::string& gl) {
  std::ostringstream out;
  out << "# Pictures in motion\n\nError of what is shown while something moves against the rate reached, by "
         "`motion-bench`. "
      << gl << ".\n\nA drag of " << cameras << " cameras, 1 to 3 degrees apart, then " << widths
      << " widths of the opening, where there is one. Both views, " << options.size.x << "×" << options.size.y
      << " pixels each, at fixed scales: rendered pixels per shown pixel along a side. The window picks a scale for "
         "its rate, and draws drafts. Errors, in 1/255, are those of all pixels shown, against the picture of the full "
         "resolution at normal quality, without occlusion and shadow, which pictures in motion leave out. Times are "
         "medians until both pictures can be painted; what it takes to put the window together comes to that.\n";
  for (const Measured& measured : all) {
    out << "\n## " << measured.name << "\n\n![" << measured.name << "](" << chartOf(measured).name << ".svg)\n\n"
        << tableHeader({"scale", "draft: ms", "a second", "RMS", "99 %", "normal: ms", "a second", "RMS", "99 %"});
    for (std::size_t i = 0; i < measured.draft.size(); ++i) {
      std::vector<std::string> cells{fixed(measured.draft[i].scale, 4)};
      for (const AtScale* at : {&measured.draft[i], &measured.normal[i]})
        for (const std::string& cell :
             {fixed(at->milliseconds.median(), 1), fixed(1000.0 / at->milliseconds.median(), 1),
              fixed(at->errors.rms(), 2), std::to_string(at->errors.percentile99())})
          cells.push_back(cell);
      out << tableRow(cells);
    }
  }
  return out.str();
}

int run(const Options& options) {
  egl::EglContext context;
  fs::create_directories(options.folder);
  if (!options.pictures.empty()) fs::create_directories(options.pictures);
  std::vector<Measured> all;
  for (const Subject& subject : subjectsOf(options)) {
    all.push_back(Player(options, subject).play());
    // Written after each, so that a run that is cut short leaves its results so far.
    std::ofstream(options.folder / "motion.md") << page(all, options, context.description());
    const Chart chart = chartOf(all.back());
    std::ofstream(options.folder / (chart.name + ".svg")) << svg(chart);
  }
  return 0;
}

}  // namespace
}  // namespace fenestra::bench

int main(int argc, char** argv) {
  CLI::App program{"Measures pictures in motion; writes motion.md with its charts.", "motion-bench"};
  fenestra::bench::Options options;
  std::vector<int> size{640, 480};
  program.add_option("FOLDER", options.folder, "where the page and charts go")->required();
  program.add_option("--size", size, "W,H: pixels of a view")->delimiter(',')->expected(2);
  program.add_option("--only", options.only, "head or torso alone");
  program.add_option("--pictures", options.pictures, "folder for one picture of each scale, beside its truth");
  CLI11_PARSE(program, argc, argv);
  options.size = {size[0], size[1]};
  try {
    return fenestra::bench::run(options);
  } catch (const std::exception& error) {
    std::cerr << "motion-bench: " << error.what() << '\n';
    return 1;
  }
}
