// Measures dual-camera placement on the phantoms and the real-data collection, and writes pages and charts.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "io/study/ReadStudy.h"
#include "rendering/egl/EglContext.h"
#include "rendering/placement/Placer.h"
#include "rendering/viewpoints/Sphere.h"
#include "tests/bench/Convergence.h"
#include "tests/bench/DescriptorsPage.h"
#include "tests/bench/MarkdownTable.h"
#include "tests/bench/PlacementSubjects.h"

namespace fenestra {
namespace {

using bench::degreesBetween, bench::fixed, bench::tableHeader, bench::tableRow;

using namespace placement;
using bench::Structure;

constexpr int manyPoints = 16384;

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Median of five, after one that compiles shaders.
template <class F>
double timed(F&& f) {
  f();
  std::vector<double> times;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    f();
    times.push_back(millisecondsSince(start));
  }
  return median(times);
}

/// The measures of a pair of cameras.
struct PairMeasures {
  double degrees = 0.0;  ///< between C1 and C2
  double share = 0.0;    ///< of the focus's surface that at least one of them sees
  double endFace = 0.0;  ///< share of the focus seen through an end of the scan, the mean of both views

  /// A view that comes in through a cut end costs as much as a tenth of the surface.
  double score() const { return share - 0.2 * endFace; }
};

struct Row {
  std::string name;
  PairMeasures before, after;        ///< the search and weights before end faces were measured, and the defaults
  std::vector<PairMeasures> trials;  ///< for each of trialOptions()
  std::vector<double> times;         ///< ms, for each of candidateCounts
  double jointByMore = 0.0;          ///< joint, looked at with `manyPoints`
  double standard = 0.0, stream = 0.0, semiSphere = 0.0, jointStream = 0.0, joint = 0.0;
  double measure = 0.0, images = 0.0, refine = 0.0, choose = 0.0, chooseJoint = 0.0, chooseJointOfMany = 0.0;
  double dual = 0.0, ends = 0.0;
};

std::vector<Options> trialOptions() {
  std::vector<Options> trials;
  for (const double shareWeight : {1.0, 0.95, 0.9, 0.8, 0.6, 0.4})
    for (const double endFace : {0.0, -0.5, -1.0, -2.0})
      for (const double visibility : {0.02, 0.0, -0.02, -0.25})
        for (const double coverage : {0.0, 1.0, 4.0, 16.0})
          for (const double location : {0.0, 0.5}) {
            Options options;
            options.shareWeight = shareWeight;
            options.weights.endFace = endFace;
            options.weights.visibility = visibility;
            options.weights.coverage = coverage;
            options.weights.location = location;
            trials.push_back(options);
          }
  return trials;
}

PairMeasures measuresOf(const Measured& measured, std::size_t first, std::size_t second) {
  const Candidate &c1 = measured.candidates[first], &c2 = measured.candidates[second];
  return {degreesBetween(c1.direction, c2.direction), seenShare(c1, c2, measured.surfacePoints),
          0.5 * (c1.descriptors.endFace + c2.descriptors.endFace)};
}

/// The paper's order with the weights that were the default, C2 on C1's right and at least 45° from ±C1.
PairMeasures formerPair(const Measured& measured) {
  Options options;
  options.weights = {.visibility = -0.02, .coverage = 16.0, .location = 0.5, .orientation = 0.0, .endFace = 0.0};
  const std::size_t c1 = *choose(measured, options, false).c1;
  const glm::dvec3 direction = measured.candidates[c1].direction, right = axesAt(direction).right;
  std::size_t c2 = c1;
  double greatest = -1e300;
  for (std::size_t i = 0; i < measured.spread; ++i) {
    const glm::dvec3 other = measured.candidates[i].direction;
    const double q = quality(measured.candidates[i].descriptors, options.weights);
    if (std::abs(glm::dot(direction, other)) > std::sqrt(0.5) + 1e-9 || glm::dot(other, right) < -1e-9 || q <= greatest)
      continue;
    c2 = i;
    greatest = q;
  }
  return measuresOf(measured, c1, c2);
}

Row measureStructure(const Structure& structure) {
  const io::Study study = io::readStudy(structure.scene);
  GpuScene gpu;
  gpu.update(study.drawn.scene());
  Row row;
  row.name = structure.name;

  CandidateImages images;
  const int side = CandidateImages::sideFor(gpu);
  for (const int count : bench::candidateCounts) {
    const auto start = std::chrono::steady_clock::now();
    images.measure(gpu, ringDirections(*sideOf(count)), {}, side, true);
    row.times.push_back(millisecondsSince(start));
  }
  const Options options;
  Placer placer;
  Sampling sampling;
  const auto measureAnew = [&] {
    placer.forget();
    placer.measure(gpu, study.drawn.scene(), sampling, options);
  };
  sampling.refined = true;
  row.refine = timed(measureAnew);
  sampling.refined = false;
  row.measure = timed(measureAnew);
  row.images = timed([&] { images.measure(gpu, ringDirections(4), {}, side); });
  row.ends = timed([&] { images.measure(gpu, ringDirections(4), {}, side, true); });
  const Measured& measured = placer.measure(gpu, study.drawn.scene(), sampling, options);
  row.choose = timed([&] { choose(measured, options, false); });
  row.chooseJoint = timed([&] { choose(measured, options, true); });
  row.dual = timed([&] { chooseDual(measured, {0.0, -1.0, 0.0}, options); });
  const std::vector<Candidate> many1200 = images.measure(
      gpu, ringDirections(10), sampleSurface(study.drawn.scene(), gpu.focus(), sampling.surfacePoints), side);
  row.chooseJointOfMany =
      timed([&] { jointSearch(many1200, static_cast<std::size_t>(measured.surfacePoints), options); });

  Options stream;
  stream.region = Region::Stream;
  row.standard = bestStandardPair(measured.candidates, measured.surfacePoints).value().share;
  row.semiSphere = choose(measured, options, false).share;
  row.stream = choose(measured, stream, false).share;
  const Placement joint = choose(measured, options, true);
  row.joint = joint.share;
  const FocusSurface many = sampleSurface(study.drawn.scene(), gpu.focus(), manyPoints);
  const std::vector<Candidate> pair = images.measure(
      gpu, {measured.candidates[*joint.c1].direction, measured.candidates[*joint.c2].direction}, many, side);
  row.jointByMore = seenShare(pair[0], pair[1], many.points.size());
  row.jointStream = choose(measured, stream, true).share;
  row.before = formerPair(measured);
  row.after = measuresOf(measured, *joint.c1, *joint.c2);
  for (const Options& trial : trialOptions()) {
    const Placement placed = choose(measured, trial, true);
    row.trials.push_back(measuresOf(measured, *placed.c1, *placed.c2));
  }
  return row;
}

/// The torso's organs at a growing number of voxels along its longest side.
struct Scaled {
  glm::ivec3 dims{0};
  double images = 0.0, measure = 0.0;
};
Scaled measureScaled(int voxels) {
  io::StudyRequest options;
  options.phantom = "torso";
  options.makePlain();
  options.phantomVoxels = voxels;
  const io::Study study = io::readStudy(options);
  GpuScene gpu;
  gpu.update(study.drawn.scene());
  CandidateImages images;
  const int side = CandidateImages::sideFor(gpu);
  Placer placer;
  Scaled scaled{study.drawn.scene().volume->grid.dims, timed([&] { images.measure(gpu, ringDirections(4), {}, side); }),
                timed([&] {
                  placer.forget();
                  placer.measure(gpu, study.drawn.scene(), {}, {});
                })};
  return scaled;
}

/// Every second structure of the list, on which weights are chosen; the others show how well those do.
bool isTuned(std::size_t row) { return row % 2 == 0; }

PairMeasures meanOf(const std::vector<Row>& rows, bool tuned, const std::function<PairMeasures(const Row&)>& of) {
  PairMeasures mean;
  double count = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (isTuned(i) != tuned) continue;
    const PairMeasures one = of(rows[i]);
    mean = {mean.degrees + one.degrees, mean.share + one.share, mean.endFace + one.endFace};
    ++count;
  }
  count = std::max(count, 1.0);
  return {mean.degrees / count, mean.share / count, mean.endFace / count};
}

std::vector<std::string> cellsOf(const PairMeasures& pair) {
  return {fixed(pair.degrees, 0) + "°", fixed(pair.share, 3), fixed(pair.endFace, 2)};
}

std::string pairTable(const std::vector<Row>& rows, bool tuned) {
  std::string table =
      tableHeader({"structure", "angle before", "share before", "end face before", "angle", "share", "end face"});
  const auto add = [&](const std::string& name, const PairMeasures& before, const PairMeasures& after) {
    std::vector<std::string> cells{name};
    for (const PairMeasures& pair : {before, after})
      for (const std::string& cell : cellsOf(pair)) cells.push_back(cell);
    table += tableRow(cells);
  };
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (isTuned(i) == tuned) add(rows[i].name, rows[i].before, rows[i].after);
  add("**mean**", meanOf(rows, tuned, [](const Row& row) { return row.before; }),
      meanOf(rows, tuned, [](const Row& row) { return row.after; }));
  return table;
}

/// How the two cameras differ, and how the weights were chosen.
std::string pairSection(const std::vector<Row>& rows) {
  const Options usual;
  std::ostringstream out;
  out << "\n## Cameras that differ\n\nThe angle between C1 and C2, the share of the focus's surface that at least one "
         "of them sees, and the share of the focus that they look at through an end of the scan (mean of both). "
         "*Before*: the paper's order with weights of -0.02 (visibility), 16 (coverage) and 0.5 (location), C2 at "
         "least "
         "45° from ±C1. The weights were chosen on one half of the structures, every second one; the other half "
         "reports them.\n\nReported, on structures that no weight was chosen on:\n\n"
      << pairTable(rows, false) << "\nThe structures that the weights were chosen on:\n\n"
      << pairTable(rows, true)
      << "\n## Weights\n\nMeans over the structures that the weights were chosen on, by the score share − 0.2 · end "
         "face: "
         "the best fifteen of the joint search's trials, and the default. A view wholly through a cut end then costs "
         "as "
         "much as a tenth of the surface.\n\n"
      << tableHeader({"share weight; visibility, coverage, location, end face", "score", "angle", "share", "end face"});
  const std::vector<Options> trials = trialOptions();
  std::vector<std::pair<double, std::size_t>> order;
  std::vector<PairMeasures> means;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    means.push_back(meanOf(rows, true, [i](const Row& row) { return row.trials[i]; }));
    order.emplace_back(-means[i].score(), i);
  }
  std::sort(order.begin(), order.end());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    const std::size_t i = order[rank].second;
    const Weights& w = trials[i].weights;
    const bool isUsual = trials[i] == usual;
    if (rank >= 15 && !isUsual) continue;
    std::vector<std::string> cells{fixed(trials[i].shareWeight, 2) + "; " + fixed(w.visibility, 2) + ", " +
                                       fixed(w.coverage, 0) + ", " + fixed(w.location, 1) + ", " + fixed(w.endFace, 1) +
                                       (isUsual ? " (default)" : ""),
                                   fixed(means[i].score(), 4)};
    for (const std::string& cell : cellsOf(means[i])) cells.push_back(cell);
    out << tableRow(cells);
  }
  return out.str();
}

std::string page(const std::vector<Row>& rows, const std::vector<Scaled>& scaling, const std::string& gl) {
  std::ostringstream out;
  out << "# Dual-camera placement, measured\n\nWritten by `placement-bench` (build target of that name) on " << gl
      << ". Default weights and region (semi-sphere), candidate images of " << defaultImageSide
      << "² over the model (finer by a whole factor where the focus is small), surface shares over "
      << Sampling().surfacePoints << " points. How many directions it takes: [convergence.md](convergence.md).\n";
  out << "\n## Share of the focus's surface that the pair sees\n\nN = 192 and the six standard views. *checked*: the "
         "joint search's pair looked at with "
      << manyPoints << " points.\n\n"
      << tableHeader({"structure", "best standard pair", "stream", "semi-sphere", "joint, stream", "joint, semi-sphere",
                      "checked"});
  for (const Row& row : rows)
    out << tableRow({row.name, fixed(row.standard, 3), fixed(row.stream, 3), fixed(row.semiSphere, 3),
                     fixed(row.jointStream, 3), fixed(row.joint, 3), fixed(row.jointByMore, 3)});
  out << "\n## Times\n\nMilliseconds, median of five after one run. *images*: N = 192 candidate images alone; *ends*: "
         "with end faces; "
         "*measure*: with what each candidate sees of the surface, and all descriptors; *refined*: the same, refined; "
         "*choose*: C1 and C2 after a change of weights; *joint*: the joint search; *C2*: C2 for a dragged C1.\n\n"
      << tableHeader({"structure", "images", "ends", "measure", "refined", "choose", "joint", "joint, N = 1200", "C2"});
  for (const Row& row : rows)
    out << tableRow({row.name, fixed(row.images, 0), fixed(row.ends, 0), fixed(row.measure, 0), fixed(row.refine, 0),
                     fixed(row.choose, 2), fixed(row.chooseJoint, 2), fixed(row.chooseJointOfMany, 1),
                     fixed(row.dual, 2)});
  out << "\n## Scaling\n\nMilliseconds for N candidate images, one run each.\n\n";
  std::vector<std::string> cells{"N"};
  for (const int count : bench::candidateCounts) cells.push_back(std::to_string(count));
  out << tableHeader(cells);
  for (const Row& row : rows) {
    cells = {row.name};
    for (const double time : row.times) cells.push_back(fixed(time, 0));
    out << tableRow(cells);
  }
  out << "\nThe phantom torso's organs in volumes of growing size; milliseconds for N = 192, median of five.\n\n"
      << tableHeader({"voxels", "millions", "images", "measure"});
  for (const Scaled& scaled : scaling)
    out << tableRow(
        {std::to_string(scaled.dims.x) + "×" + std::to_string(scaled.dims.y) + "×" + std::to_string(scaled.dims.z),
         fixed(1e-6 * scaled.dims.x * scaled.dims.y * scaled.dims.z, 1), fixed(scaled.images, 0),
         fixed(scaled.measure, 0)});
  out << pairSection(rows);
  return out.str();
}

/// The pages that the program can write alone.
enum class Only { Nothing, Descriptors, Convergence };

int run(const std::filesystem::path& folder, const std::string& part, Only only) {
  egl::EglContext context;
  std::filesystem::create_directories(folder);
  if (only != Only::Convergence) bench::writeDescriptorsPage(folder, part, context.description());
  if (only != Only::Descriptors) bench::writeConvergencePage(folder, part, context.description());
  if (only != Only::Nothing) return 0;
  std::vector<Scaled> scaling;
  if (part.empty())
    for (const int voxels : {128, 256, 512}) scaling.push_back(measureScaled(voxels));
  std::vector<Row> rows;
  for (const Structure& structure : bench::structures()) {
    if (structure.name.find(part) == std::string::npos) continue;
    const auto start = std::chrono::steady_clock::now();
    rows.push_back(measureStructure(structure));
    std::cerr << structure.name << ": " << fixed(millisecondsSince(start) / 1000.0, 1) << " s\n";
    // Written after each, so that a run that is cut short leaves its results so far.
    std::ofstream(folder / "placement.md") << page(rows, scaling, context.description());
  }
  return 0;
}

}  // namespace
}  // namespace fenestra

int main(int argc, char** argv) {
  CLI::App program{
      "Measures dual-camera placement; writes placement.md, descriptors.md, and convergence.md with its charts.",
      "placement-bench"};
  std::string folder, part;
  bool onlyDescriptors = false, onlyConvergence = false;
  program.add_flag("--only-descriptors", onlyDescriptors, "descriptors.md alone");
  program.add_flag("--only-convergence", onlyConvergence, "convergence.md and its charts alone")
      ->excludes("--only-descriptors");
  program.add_option("FOLDER", folder, "where the pages and charts go")->required();
  program.add_option("PART", part, "only the structures whose names hold this");
  CLI11_PARSE(program, argc, argv);
  using fenestra::Only;
  try {
    return fenestra::run(folder, part,
                         onlyDescriptors   ? Only::Descriptors
                         : onlyConvergence ? Only::Convergence
                                           : Only::Nothing);
  } catch (const std::exception& error) {
    std::cerr << "placement-bench: " << error.what() << '\n';
    return 1;
  }
}
