#include "tests/bench/Report.h"

#include <algorithm>
#include <sstream>

#include "io/base/AtomicFile.h"
#include "tests/bench/Markup.h"

namespace fenestra::bench {
namespace {

std::string csv(const Table& table) {
  std::string text;
  const auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      // RFC 4180: a cell with a separator or a quote is quoted, its quotes doubled.
      std::string cell = cells[i];
      if (cell.find_first_of(",\"\n") != std::string::npos) {
        for (std::size_t at = 0; (at = cell.find('"', at)) != std::string::npos; at += 2) cell.insert(at, 1, '"');
        cell = '"' + cell + '"';
      }
      text.append(i ? "," : "").append(cell);
    }
    text += '\n';
  };
  line(table.columns);
  for (const auto& row : table.rows) line(row);
  return text;
}

std::string markdown(const Table& table) {
  std::string text;
  const auto line = [&](const std::vector<std::string>& cells) {
    text += '|';
    for (const std::string& cell : cells) text.append(" ").append(cell).append(" |");
    text += '\n';
  };
  line(table.columns);
  text += '|';
  for (std::size_t i = 0; i < table.columns.size(); ++i) text += i == 0 ? "---|" : "---:|";
  text += '\n';
  for (const auto& row : table.rows) line(row);
  return text;
}

std::string html(const Table& table) {
  std::string text = "<table><tr>";
  for (const std::string& column : table.columns) text.append("<th>").append(escaped(column)).append("</th>");
  text += "</tr>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (const std::string& cell : row) text.append("<td>").append(escaped(cell)).append("</td>");
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string paragraphs(const std::string& text) {
  std::string result = "<p>";
  result.append(escaped(text)).append("</p>\n");
  for (std::size_t at = 0; (at = result.find("\n\n", at)) != std::string::npos; at += 8)
    result.replace(at, 2, "</p>\n<p>");
  return result;
}

std::string markdownPage(const Report& report) {
  std::string text;
  text.append("# ").append(report.title).append("\n\n").append(report.text).append("\n");
  for (const Section& section : report.sections) {
    text.append("\n## ").append(section.title).append("\n\n").append(section.text).append("\n");
    for (const Chart& chart : section.charts)
      text.append("\n![").append(chart.title).append("](").append(chart.name).append(".svg)\n");
    for (const Table& table : section.tables)
      if (!table.isLong) text.append("\n").append(markdown(table));
  }
  return text;
}

std::string htmlPage(const Report& report) {
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + escaped(report.title) +
      "</title>\n<style>body{font:15px/1.45 sans-serif;max-width:75em;margin:2em auto;padding:0 1em}"
      "svg{width:46em;max-width:100%;margin:.5em 1em .5em 0}table{border-collapse:collapse;margin:1em 0;font-size:13px}"
      "td,th{border:1px solid #ccc;padding:.2em .6em;text-align:right}td:first-child,th:first-child{text-align:left}"
      "</style></head><body>\n<h1>" +
      escaped(report.title) + "</h1>\n" + paragraphs(report.text);
  for (const Section& section : report.sections) {
    text += "<h2>" + escaped(section.title) + "</h2>\n" + paragraphs(section.text);
    for (const Chart& chart : section.charts) text += svg(chart);
    for (const Table& table : section.tables) text += html(table);
  }
  return text + "</body></html>\n";
}

/// Characters, not bytes, of UTF-8.
std::size_t lengthOf(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

}  // namespace

std::string plainText(const Table& table) {
  std::vector<std::size_t> widths(table.columns.size(), 0);
  const auto widen = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], lengthOf(cells[i]));
  };
  widen(table.columns);
  for (const auto& row : table.rows) widen(row);
  std::string text;
  const auto line = [&](const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(widths[i] - lengthOf(cells[i]), ' ');
      text += i == 0 ? cells[i] + padding : "  " + padding + cells[i];
    }
    text += '\n';
  };
  line(table.columns);
  for (const auto& row : table.rows) line(row);
  return text;
}

void write(const Report& report, const std::filesystem::path& folder, const std::string& name) {
  std::filesystem::create_directories(folder);
  io::writeText(folder / (name + ".md"), markdownPage(report));
  io::writeText(folder / (name + ".html"), htmlPage(report));
  for (const Section& section : report.sections) {
    for (const Chart& chart : section.charts) io::writeText(folder / (chart.name + ".svg"), svg(chart));
    for (const Table& table : section.tables) io::writeText(folder / (table.name + ".csv"), csv(table));
  }
}

}  // namespace fenestra::bench
