#pragma once
// What clicks of growing-bench came to: kept in a file while it runs, and tables of them.

#include <array>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "tests/bench/GrowingTruths.h"

namespace fenestra::bench {

/// A region after a click, a correction or two.
struct GrownRegion {
  double dice = 0.0;
  /// Over twice the structure, or over 15 % of the body where the structure is less.
  bool leaks = false;
  /// The window opens to it without asking: it is no more of the body than segmentation::largeShareOfBody.
  bool opens = true;
  bool isDoubtful = false;  ///< the panel says so, see segmentation::Border
};

struct ClickOutcome {
  double plain = 0.0, values = 0.0;  ///< Dice: of a plain tolerance, the best; by values
  bool leaksByValues = false;
  std::array<GrownRegion, 3> byTissues;  ///< after a click, a correction, two
  double dragged = 0.0;                  ///< Dice of the best tolerance for the click
};

/// By structure, in the order of their seeds. A run that was stopped goes on from the file.
class ClickOutcomes {
 public:
  /// Reads the file, if it is there; add() appends to it.
  explicit ClickOutcomes(std::filesystem::path file);

  const std::vector<ClickOutcome>& of(const std::string& structure) { return outcomes_[structure]; }
  void add(const std::string& structure, const ClickOutcome& outcome);

  /// A row for each structure that has outcomes.
  void writeRows(std::ostream& page) const;
  /// What was wanted of each kind and what was reached, over all structures and over those no constant was chosen on.
  void writeGoals(std::ostream& page) const;
  /// How many of all seeds leak, and how many of these leaks open by themselves.
  void writeLeaks(std::ostream& page) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, std::vector<ClickOutcome>> outcomes_;
};

}  // namespace fenestra::bench
