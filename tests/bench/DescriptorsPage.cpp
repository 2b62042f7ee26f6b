#include "tests/bench/DescriptorsPage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <vector>

#include "rendering/placement/FocusViews.h"
#include "rendering/placement/Placer.h"
#include "rendering/viewpoints/RepresentativeViews.h"
#include "tests/bench/MarkdownTable.h"
#include "tests/bench/PlacementSubjects.h"

namespace fenestra::bench {
namespace {

using namespace placement;

/// The measures that descriptors are correlated with.
constexpr std::array<const char*, 4> comparedWith{"visibility (vd1)", "coverage (vd2)", "location (vd3)",
                                                  "share of the surface seen"};

struct Choice {
  double degrees = 0.0;  ///< from the paper's C1
  double share = 0.0;    ///< of the surface, that the view sees
};
struct Row {
  std::string name;
  bool isPhantom = false;
  double shareOfC1 = 0.0, bestShare = 0.0, shareOfPair = 0.0;
  std::vector<std::array<double, comparedWith.size()>> correlations;  ///< of each descriptor
  std::vector<std::vector<double>> alikeness;                         ///< of each two descriptors' preferences
  std::vector<std::optional<Choice>> choices;                         ///< of each descriptor
  RepresentativeViews views;
  double tourDegrees = 0.0;
};

Row measure(const Structure& structure) {
  const io::Study study = io::readStudy(structure.scene);
  GpuScene gpu;
  gpu.update(study.drawn.scene());
  Placer placer;
  const Measured& measured = placer.measure(gpu, study.drawn.scene(), {}, {});
  const DescribedViews views = describeViews(gpu, study.drawn.scene(), measured, {}, true);
  std::array<std::vector<double>, comparedWith.size()> lists;
  std::vector<Candidate> spread;
  for (std::size_t i = 0; i < measured.spread; ++i) {
    const Candidate& candidate = measured.candidates[i];
    lists[0].push_back(candidate.descriptors.visibility);
    lists[1].push_back(candidate.descriptors.coverage);
    lists[2].push_back(candidate.descriptors.location);
    spread.push_back(candidate);
  }
  lists[3] = views.shares();
  const std::size_t c1 = bestView(spread, {}).value();
  Row row;
  row.name = structure.name;
  row.isPhantom = structure.isPhantom;
  row.shareOfC1 = views.shares()[c1];
  row.bestShare = *std::max_element(lists[3].begin(), lists[3].end());
  row.shareOfPair = choose(measured, {}, true).share;
  for (const ViewDescriptorEntry& entry : viewDescriptors()) {
    const std::vector<double> values = views.values(entry.descriptor);
    std::array<double, comparedWith.size()> correlations{};
    for (std::size_t i = 0; i < lists.size(); ++i)
      correlations[i] = preferenceCorrelation(entry.descriptor, values, lists[i]);
    row.correlations.push_back(correlations);
    std::vector<double> alikeness;
    for (const ViewDescriptorEntry& other : viewDescriptors())
      alikeness.push_back((other.isHighBest ? 1.0 : -1.0) *
                          preferenceCorrelation(entry.descriptor, values, views.values(other.descriptor)));
    row.alikeness.push_back(std::move(alikeness));
    std::optional<Choice> choice;
    if (const auto view = choiceBy(entry.descriptor, values)) {
      const double cosine = glm::dot(spread[*view].direction, spread[c1].direction);
      choice = Choice{glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))), views.shares()[*view]};
    }
    row.choices.push_back(choice);
  }
  row.views = representativeViews(views.channel());
  std::vector<glm::dvec3> directions;
  for (const std::size_t view : row.views.views) directions.push_back(spread[view].direction);
  row.tourDegrees = glm::degrees(shortestTour(directions).length);
  return row;
}

/// "mean (least … greatest)" of the values that there are.
std::string summary(const std::vector<double>& values, int digits) {
  double sum = 0.0, count = 0.0, least = 1e300, greatest = -1e300;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    ++count;
  }
  if (count == 0.0) return "–";
  return fixed(sum / count, digits) + " (" + fixed(least, digits) + " … " + fixed(greatest, digits) + ")";
}

std::vector<const Row*> realOnes(const std::vector<Row>& rows) {
  std::vector<const Row*> real;
  for (const Row& row : rows)
    if (!row.isPhantom) real.push_back(&row);
  return real;
}

std::string correlationTable(const std::vector<Row>& rows) {
  std::vector<std::string> cells{"descriptor"};
  for (const char* with : comparedWith) cells.emplace_back(with);
  std::string table = tableHeader(cells);
  for (std::size_t d = 0; d < viewDescriptors().size(); ++d) {
    cells = {std::string(viewDescriptors()[d].name)};
    for (std::size_t i = 0; i < comparedWith.size(); ++i) {
      std::vector<double> values;
      for (const Row* row : realOnes(rows)) values.push_back(row->correlations[d][i]);
      cells.push_back(summary(values, 2));
    }
    table += tableRow(cells);
  }
  return table;
}

/// Means over the real structures.
std::string alikenessTable(const std::vector<Row>& rows) {
  std::vector<std::string> cells{"descriptor"};
  for (const ViewDescriptorEntry& entry : viewDescriptors()) cells.emplace_back(entry.name);
  std::string table = tableHeader(cells);
  for (std::size_t d = 0; d < viewDescriptors().size(); ++d) {
    cells = {std::string(viewDescriptors()[d].name)};
    for (std::size_t other = 0; other < viewDescriptors().size(); ++other) {
      double sum = 0.0, count = 0.0;
      for (const Row* row : realOnes(rows))
        if (!std::isnan(row->alikeness[d][other])) {
          sum += row->alikeness[d][other];
          ++count;
        }
      cells.push_back(count > 0.0 ? fixed(sum / count, 2) : "–");
    }
    table += tableRow(cells);
  }
  return table;
}

/// A table with a figure for each structure and descriptor, and the means over the real structures.
template <class Of>
std::string choiceTable(const std::vector<Row>& rows, int digits, const std::string& more, Of&& of) {
  std::vector<std::string> cells{"structure"};
  for (const ViewDescriptorEntry& entry : viewDescriptors()) cells.emplace_back(entry.name);
  if (!more.empty()) cells.push_back(more);
  std::string table = tableHeader(cells);
  for (const Row& row : rows) {
    cells = {row.name};
    for (const auto& choice : row.choices) cells.push_back(choice ? fixed(of(*choice), digits) : "–");
    if (!more.empty()) cells.push_back(fixed(row.shareOfC1, digits) + " / " + fixed(row.bestShare, digits));
    table += tableRow(cells);
  }
  cells = {"**mean of the real ones**"};
  for (std::size_t d = 0; d < viewDescriptors().size(); ++d) {
    double sum = 0.0, count = 0.0;
    for (const Row* row : realOnes(rows))
      if (row->choices[d]) {
        sum += of(*row->choices[d]);
        ++count;
      }
    cells.push_back(count > 0.0 ? fixed(sum / count, digits) : "–");
  }
  if (!more.empty()) {
    double ofC1 = 0.0, best = 0.0;
    const auto real = realOnes(rows);
    for (const Row* row : real) {
      ofC1 += row->shareOfC1 / static_cast<double>(real.size());
      best += row->bestShare / static_cast<double>(real.size());
    }
    cells.push_back(fixed(ofC1, digits) + " / " + fixed(best, digits));
  }
  return table + tableRow(cells);
}

std::string page(const std::vector<Row>& rows, const std::string& gl) {
  std::ostringstream out;
  out << "# View descriptors, measured\n\nWritten by `placement-bench` (build target of that name) on " << gl << ". "
      << Sampling().count << " directions, " << Sampling().surfacePoints
      << " surface points. `rendering/viewpoints/ViewDescriptors.h` defines the descriptors. All figures are the same "
         "in "
         "every run on one driver.\n\n## Rank correlation\n\nSpearman's, over the directions, of what a descriptor "
         "prefers with the paper's three descriptors as they are defined and with the share of the focus's surface "
         "that "
         "a view sees: mean (least … greatest) over the "
      << realOnes(rows).size()
      << " real structures. Positive: where the descriptor says better, the other value is greater. `vd1` is greater "
         "for "
         "a focus that is farther away; its default weight is negative. `structure-entropy` is over the structures of "
         "two labels.\n\n"
      << correlationTable(rows)
      << "\nOf the preferences of each two descriptors, the mean over the same structures:\n\n"
      << alikenessTable(rows)
      << "\n## Angle to the paper's C1\n\nDegrees between the view that a descriptor would choose and `argmax Q` with "
         "the "
         "default weights. Opposite views have the same outline in parallel projection, so angles near 180° are common "
         "for the two descriptors of the silhouette.\n\n"
      << choiceTable(rows, 0, "", [](const Choice& choice) { return choice.degrees; })
      << "\n## Share of the surface that the chosen view sees\n\nThe last column: that of the paper's C1, and the "
         "greatest "
         "of all "
      << Sampling().count << " views.\n\n"
      << choiceTable(rows, 3, "C1 / greatest", [](const Choice& choice) { return choice.share; })
      << "\n## Representative views\n\nThe N best views that together see 95 % of what can be seen, at most "
      << mostRepresentativeViews
      << ", and the length of the shortest closed tour past them. *first two*: the share that the first two see "
         "together; they may lie at any angle. *joint pair*: that of the two cameras of the joint search, which stay "
         "60° "
         "to 120° apart.\n\n"
      << tableHeader({"structure", "views", "share", "tour", "first two", "joint pair"});
  for (const Row& row : rows) {
    const std::vector<double>& shares = row.views.shares;
    out << tableRow({row.name, std::to_string(shares.size()), shares.empty() ? "–" : fixed(shares.back(), 3),
                     fixed(row.tourDegrees, 0) + "°", shares.size() < 2 ? "–" : fixed(shares[1], 3),
                     fixed(row.shareOfPair, 3)});
  }
  return out.str();
}

}  // namespace

void writeDescriptorsPage(const std::filesystem::path& folder, const std::string& part, const std::string& gl) {
  std::vector<Row> rows;
  for (const Structure& structure : structures()) {
    if (structure.name.find(part) == std::string::npos) continue;
    std::cerr << structure.name << ": descriptors\n";
    rows.push_back(measure(structure));
    std::ofstream(folder / "descriptors.md") << page(rows, gl);
  }
}

}  // namespace fenestra::bench
