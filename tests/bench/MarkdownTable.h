#pragma once
// Tables of the pages that programs of one file write. Report.h has those of the report, with HTML and CSV.

#include <string>
#include <vector>

#include "app/benchmark/Numbers.h"

namespace fenestra::bench {

inline std::string tableRow(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

/// The first column is text, the others are numbers.
inline std::string tableHeader(const std::vector<std::string>& cells) {
  std::string rule = "|---|";
  for (std::size_t i = 1; i < cells.size(); ++i) rule += "---:|";
  return tableRow(cells) + rule + "\n";
}

}  // namespace fenestra::bench
