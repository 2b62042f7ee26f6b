#pragma once
// A report of tables and charts, written as Markdown, as one HTML page, and piece by piece as CSV and SVG.

#include <filesystem>
#include <string>
#include <vector>

#include "tests/bench/Chart.h"

namespace fenestra::bench {

struct Table {
  std::string name;  ///< of its CSV file
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  bool isLong = false;  ///< in the HTML page and the CSV file alone
};

struct Section {
  std::string title;
  std::string text;  ///< Markdown without markup: paragraphs, separated by empty lines
  std::vector<Chart> charts;
  std::vector<Table> tables;
};

struct Report {
  std::string title, text;
  std::vector<Section> sections;
};

/// Aligned columns, for a terminal.
std::string plainText(const Table& table);

/// Writes NAME.md and NAME.html, a CSV file for each table and an SVG file for each chart. Throws io::Error.
void write(const Report& report, const std::filesystem::path& folder, const std::string& name);

}  // namespace fenestra::bench
