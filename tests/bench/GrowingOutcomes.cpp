#include "tests/bench/GrowingOutcomes.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iomanip>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace fenestra::bench {
namespace {

/// Wanted medians of Dice; 0 where none is.
struct Goal {
  Kind kind;
  std::string name;
  std::array<double, 3> dice;
};
const std::vector<Goal> goals{{Kind::Organ, "kidneys, spleen, liver", {0.90, 0.93, 0.95}},
                              {Kind::Air, "lungs, airway", {0.95, 0.0, 0.0}},
                              {Kind::Vessel, "aorta, vena cava", {0.85, 0.90, 0.0}},
                              {Kind::Spine, "vertebrae, ribs", {0.75, 0.85, 0.90}},
                              {Kind::Bone, "femur, hip, bones of hand and foot", {0.80, 0.88, 0.92}},
                              {Kind::Fluid, "eye, ventricles, bladder", {0.85, 0.90, 0.0}},
                              {Kind::Nucleus, "nuclei of T1", {0.50, 0.65, 0.0}},
                              {Kind::Other, "others", {0.0, 0.0, 0.0}}};

std::istream& operator>>(std::istream& line, ClickOutcome& outcome) {
  line >> outcome.plain >> outcome.values >> outcome.leaksByValues >> outcome.dragged;
  for (GrownRegion& region : outcome.byTissues)
    line >> region.dice >> region.leaks >> region.opens >> region.isDoubtful;
  return line;
}

std::ostream& operator<<(std::ostream& line, const ClickOutcome& outcome) {
  line << outcome.plain << ' ' << outcome.values << ' ' << outcome.leaksByValues << ' ' << outcome.dragged;
  for (const GrownRegion& region : outcome.byTissues)
    line << ' ' << region.dice << ' ' << region.leaks << ' ' << region.opens << ' ' << region.isDoubtful;
  return line;
}

double medianOf(const std::vector<ClickOutcome>& outcomes, const std::function<double(const ClickOutcome&)>& dice) {
  std::vector<double> values;
  for (const ClickOutcome& outcome : outcomes) values.push_back(dice(outcome));
  return median(values);
}

double after(const std::vector<ClickOutcome>& outcomes, std::size_t corrections) {
  return medianOf(outcomes, [&](const ClickOutcome& outcome) { return outcome.byTissues[corrections].dice; });
}

std::string dice(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << value;
  return text.str();
}

std::string leaks(const std::vector<ClickOutcome>& outcomes, const std::function<bool(const ClickOutcome&)>& leaks) {
  const auto count = std::count_if(outcomes.begin(), outcomes.end(), leaks);
  return count ? " (" + std::to_string(count) + ")" : "";
}

/// Medians of structures: their median, and how many reach what is wanted, if anything is.
std::string reached(const std::vector<double>& medians, double wanted) {
  if (medians.empty()) return "–";
  std::string text = dice(median(medians));
  if (wanted > 0.0) {
    // As the page shows them: with two digits.
    const auto count =
        std::count_if(medians.begin(), medians.end(), [&](double value) { return value >= wanted - 0.005; });
    text += ", " + std::to_string(count) + " of " + std::to_string(medians.size());
  }
  return text;
}

}  // namespace

ClickOutcomes::ClickOutcomes(std::filesystem::path file) : file_(std::move(file)) {
  std::ifstream lines(file_);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t tab = line.find('\t');
    std::istringstream rest(tab == std::string::npos ? "" : line.substr(tab));
    ClickOutcome outcome;
    if (!(rest >> outcome)) throw std::runtime_error(file_.string() + ": not a line of outcomes: " + line);
    outcomes_[line.substr(0, tab)].push_back(outcome);
  }
}

void ClickOutcomes::add(const std::string& structure, const ClickOutcome& outcome) {
  outcomes_[structure].push_back(outcome);
  std::ofstream lines(file_, std::ios::app);
  lines << structure << '\t' << outcome << '\n';
}

void ClickOutcomes::writeRows(std::ostream& page) const {
  page << "| structure | seeds | plain tolerance, best | by values | **click** | one correction | two corrections | "
          "after one drag |\n|---|---|---|---|---|---|---|---|\n";
  for (const Structure& structure : structures()) {
    const auto found = outcomes_.find(structure.name);
    if (found == outcomes_.end() || found->second.empty()) continue;
    const std::vector<ClickOutcome>& all = found->second;
    page << "| " << structure.name << (structure.tuned ? " \\*" : "") << " | " << all.size() << " | "
         << dice(medianOf(all, [](const ClickOutcome& each) { return each.plain; })) << " | "
         << dice(medianOf(all, [](const ClickOutcome& each) { return each.values; }))
         << leaks(all, [](const ClickOutcome& each) { return each.leaksByValues; });
    for (std::size_t corrections = 0; corrections < 3; ++corrections) {
      const std::string mark = corrections == 0 ? "**" : "";
      page << " | " << mark << dice(after(all, corrections)) << mark
           << leaks(all, [&](const ClickOutcome& each) { return each.byTissues[corrections].leaks; });
    }
    page << " | " << dice(medianOf(all, [](const ClickOutcome& each) { return each.dragged; })) << " |\n";
  }
}

void ClickOutcomes::writeGoals(std::ostream& page) const {
  page << "| structures | wanted: click / one / two corrections | click | one correction | two corrections | not tuned "
          "on: click | one | two | plain tolerance, best | by values |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Goal& goal : goals) {
    std::array<std::vector<double>, 3> all, untuned;
    std::vector<double> plain, values;
    for (const Structure& structure : structures()) {
      const auto found = outcomes_.find(structure.name);
      if (structure.kind != goal.kind || found == outcomes_.end() || found->second.empty()) continue;
      for (std::size_t corrections = 0; corrections < 3; ++corrections) {
        const double reached = after(found->second, corrections);
        all[corrections].push_back(reached);
        if (!structure.tuned) untuned[corrections].push_back(reached);
      }
      plain.push_back(medianOf(found->second, [](const ClickOutcome& each) { return each.plain; }));
      values.push_back(medianOf(found->second, [](const ClickOutcome& each) { return each.values; }));
    }
    if (plain.empty()) continue;
    page << "| " << goal.name << " | ";
    for (std::size_t corrections = 0; corrections < 3; ++corrections)
      page << (corrections ? " / " : "") << (goal.dice[corrections] > 0.0 ? dice(goal.dice[corrections]) : "–");
    for (const auto* medians : {&all, &untuned})
      for (std::size_t corrections = 0; corrections < 3; ++corrections)
        page << " | " << reached((*medians)[corrections], goal.dice[corrections]);
    page << " | " << reached(plain, 0.0) << " | " << reached(values, 0.0) << " |\n";
  }
}

void ClickOutcomes::writeLeaks(std::ostream& page) const {
  page << "| after | seeds | leak | of these, open without asking | of these, called doubtful | regions that are no "
          "leak and called doubtful |\n|---|---|---|---|---|---|\n";
  constexpr std::array<const char*, 3> names{"the click", "one correction", "two corrections"};
  for (std::size_t corrections = 0; corrections < 3; ++corrections) {
    int seeds = 0, leaking = 0, opening = 0, said = 0, alarms = 0;
    for (const auto& [name, outcomes] : outcomes_)
      for (const ClickOutcome& outcome : outcomes) {
        const GrownRegion& region = outcome.byTissues[corrections];
        ++seeds;
        leaking += region.leaks;
        opening += region.leaks && region.opens;
        said += region.leaks && region.opens && region.isDoubtful;
        alarms += !region.leaks && region.isDoubtful;
      }
    if (seeds == 0) continue;
    const auto share = [&](int count) {
      std::ostringstream text;
      text << count << " (" << std::fixed << std::setprecision(1) << 100.0 * count / seeds << " %)";
      return text.str();
    };
    page << "| " << names[corrections] << " | " << seeds << " | " << share(leaking) << " | " << share(opening) << " | "
         << said << " | " << share(alarms) << " |\n";
  }
}

}  // namespace fenestra::bench
