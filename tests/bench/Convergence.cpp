#include "tests/bench/Convergence.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>

#include "rendering/placement/Placer.h"
#include "rendering/viewpoints/Sphere.h"
#include "tests/bench/MarkdownTable.h"

namespace fenestra::bench {
namespace {

using namespace placement;

constexpr int convergedCount = 12288;
/// What counts as settled.
constexpr double settledAngle = 10.0, settledLoss = 0.01;

/// The paper's placement knows the focus alone.
Options withoutHabits() {
  Options options;
  options.habits = noHabits;
  return options;
}

/// Scatter of the quality's error over 48 directions, against images four times as fine: differences below it are the
/// images', not the focus's.
double errorOfQuality(CandidateImages& images, const GpuScene& gpu, int side, const Options& options) {
  const std::vector<glm::dvec3> directions = ringDirections(2);
  const std::vector<Candidate> coarse = images.measure(gpu, directions, {}, side, true);
  const std::vector<Candidate> fine = images.measure(gpu, directions, {}, 4 * side, true);
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const double error =
        quality(coarse[i].descriptors, options.weights) - quality(fine[i].descriptors, options.weights);
    sum += error;
    squares += error * error;
  }
  const double count = static_cast<double>(directions.size());
  return std::sqrt(std::max(0.0, squares / count - sum / count * (sum / count)));
}

/// The cameras that the finest sphere gives.
struct Converged {
  Candidate c1, c2;

  Converged(const std::vector<Candidate>& candidates, const Options& options)
      : c1(candidates[bestView(candidates, options).value()]),
        c2(candidates[dualView(candidates, c1.direction, options).value()]) {}

  Deviation of(const std::vector<Candidate>& candidates, const Options& options) const {
    const Candidate& first = candidates[bestView(candidates, options).value()];
    const auto lost = [&](const Candidate& from, const Candidate& to) {
      return quality(from.descriptors, options.weights) - quality(to.descriptors, options.weights);
    };
    Deviation deviation{degreesBetween(c1.direction, first.direction), 180.0, lost(c1, first), 0.0};
    if (const auto index = dualView(candidates, first.direction, options)) {
      const Candidate& second = candidates[*index];
      deviation.c2 = degreesBetween(c2.direction, second.direction);
      deviation.lostByC2 = lost(c2, second);
    }
    return deviation;
  }
};

Convergence measure(const Structure& structure) {
  const io::Study study = io::readStudy(structure.scene);
  GpuScene gpu;
  gpu.update(study.drawn.scene());
  CandidateImages images;
  const Options options = withoutHabits();
  Convergence measured;
  measured.name = structure.name;
  measured.side = CandidateImages::sideFor(gpu);
  measured.error = errorOfQuality(images, gpu, measured.side, options);
  const auto spread = [&](int count) {
    return images.measure(gpu, ringDirections(*sideOf(count)), {}, measured.side, true);
  };
  const Converged converged(spread(convergedCount), options);
  for (std::size_t i = 0; i < candidateCounts.size(); ++i)
    measured.of[i] = converged.of(spread(candidateCounts[i]), options);
  Placer placer;
  Sampling sampling;
  sampling.refined = true;
  const Measured& refined = placer.measure(gpu, study.drawn.scene(), sampling, options);
  const auto candidate = [&](std::size_t index) {
    return refined.candidates.begin() + static_cast<std::ptrdiff_t>(index);
  };
  measured.refined = converged.of({candidate(refined.coarser), candidate(refined.spread)}, options);
  measured.refinedImages = refined.spread;
  return measured;
}

std::vector<std::string> countCells(const std::string& first) {
  std::vector<std::string> cells{first};
  for (const int count : candidateCounts) cells.push_back(std::to_string(count));
  return cells;
}

std::string angleTable(const std::vector<Convergence>& all, double Deviation::*angle) {
  std::vector<std::string> cells = countCells("N");
  cells.push_back("refined");
  std::string table = tableHeader(cells);
  for (const Convergence& one : all) {
    cells = {one.name};
    for (const Deviation& deviation : one.of) cells.push_back(fixed(deviation.*angle, 1));
    cells.push_back(fixed(one.refined.*angle, 2) + " (" + std::to_string(one.refinedImages) + ")");
    table += tableRow(cells);
  }
  return table;
}

std::string settledTable(const std::vector<Convergence>& all) {
  std::string table = tableHeader({"structure", "C1, angle", "C2, angle", "C1, quality", "C2, quality"});
  for (const Convergence& one : all) {
    std::vector<std::string> cells{one.name};
    const auto add = [&](double Deviation::*deviation, double limit) {
      const auto count = settledFrom(one, deviation, limit);
      cells.push_back(count ? std::to_string(*count) : "–");
    };
    add(&Deviation::c1, settledAngle);
    add(&Deviation::c2, settledAngle);
    add(&Deviation::lost, settledLoss);
    add(&Deviation::lostByC2, settledLoss);
    table += tableRow(cells);
  }
  return table;
}

std::string lossTable(const std::vector<Convergence>& all) {
  std::string table =
      tableHeader({"structure", "image", "error", "C1, N = 192", "C1, N = 1200", "C1, refined", "C2, refined"});
  for (const Convergence& one : all)
    table += tableRow({one.name, std::to_string(one.side) + "²", fixed(one.error, 5), fixed(one.of[3].lost, 5),
                       fixed(one.of.back().lost, 5), fixed(one.refined.lost, 5), fixed(one.refined.lostByC2, 5)});
  return table;
}

std::string page(const std::vector<Convergence>& all, const std::string& gl) {
  std::ostringstream out;
  out << "# How the cameras settle\n\nWritten by `placement-bench --only-convergence` on " << gl
      << ". The paper's Figure 7: C1 and C2 for N = 12 to 1200 candidate views, spread evenly, and for the "
         "hierarchical refinement of 48. By the focus alone, as in the paper: default weights, C2 in the half sphere "
         "beside C1, no habits (`rendering/viewpoints/Habits.h`). Candidate images of "
      << defaultImageSide
      << "² over the model, finer by a whole factor where the focus is small.\n\nHand and foot: " << bodyPartsCredit
      << " (changed: voxels with simulated values).\n\n"
         "![C1: degrees to the converged answer against N](convergence-c1.svg)\n\n"
         "![C2: degrees to the converged answer against N](convergence-c2.svg)\n\n"
         "Degrees from the answer of N = "
      << convergedCount
      << ", all by the same measure; for the refinement, the number of its images in brackets. Seen in parallel "
         "projection, opposite sides have the same outline: angles near 180° are the opposite of an equally good "
         "view.\n\nC1:\n\n"
      << angleTable(all, &Deviation::c1) << "\nC2:\n\n"
      << angleTable(all, &Deviation::c2)
      << "\n## When it has settled\n\nThe least N from which on the camera stays "
         "within "
      << fixed(settledAngle, 0) << "° of the converged one, or its quality within " << fixed(settledLoss, 2)
      << " of it; –: not by N = " << candidateCounts.back() << ".\n\n"
      << settledTable(all)
      << "\n## What is lost\n\nQuality lost to the converged answer. *Error*: scatter of the qualities against images "
         "four times as fine; what is below it is a tie.\n\n"
      << lossTable(all);
  return out.str();
}

}  // namespace

double degreesBetween(glm::dvec3 a, glm::dvec3 b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

std::optional<int> settledFrom(const Convergence& measured, double Deviation::*deviation, double limit) {
  std::optional<int> from;
  for (std::size_t i = candidateCounts.size(); i-- > 0 && measured.of[i].*deviation <= limit;)
    from = candidateCounts[i];
  return from;
}

Chart convergenceChart(const std::vector<Convergence>& measured, double Deviation::*angle, const std::string& camera) {
  std::string name = "convergence-" + camera;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  Chart chart{
      name, camera + ": degrees to the converged answer; rings: refined", {"candidate views"}, {"degrees", false}, {}};
  for (const Convergence& one : measured) {
    ChartSeries series{one.name, {}, {}};
    const auto point = [](double count, double degrees) { return ChartPoint{count, degrees, degrees, degrees, {}}; };
    for (std::size_t i = 0; i < candidateCounts.size(); ++i)
      series.points.push_back(point(candidateCounts[i], one.of[i].*angle));
    series.apart.push_back(point(static_cast<double>(one.refinedImages), one.refined.*angle));
    chart.series.push_back(std::move(series));
  }
  return chart;
}

void writeConvergencePage(const std::filesystem::path& folder, const std::string& part, const std::string& gl) {
  std::vector<Convergence> all;
  const auto add = [&](const Structure& structure, bool isCharted) {
    const bool isThere =
        std::any_of(all.begin(), all.end(), [&](const Convergence& one) { return one.name == structure.name; });
    if (isThere || structure.name.find(part) == std::string::npos) return;
    all.push_back(measure(structure));
    std::cerr << structure.name << ": C1 " << all.back().refined.c1 << "°, C2 " << all.back().refined.c2
              << "° from the converged answer when refined\n";
    // Written after each, so that a run that is cut short leaves its results so far.
    std::ofstream(folder / "convergence.md") << page(all, gl);
    if (!isCharted) return;
    for (const Chart& chart :
         {convergenceChart(all, &Deviation::c1, "C1"), convergenceChart(all, &Deviation::c2, "C2")})
      std::ofstream(folder / (chart.name + ".svg")) << svg(chart);
  };
  for (const Structure& structure : paperSubjects()) add(structure, true);
  for (const Structure& structure : structures()) add(structure, false);
}

}  // namespace fenestra::bench
