#pragma once
// Scenes drawn in several ways on one sheet: a scene a row, a way a column.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <QSize>

#include "io/study/ReadStudy.h"

namespace fenestra::bench {

/// A scene. Its pictures, from left to right, differ by the columns.
struct Row {
  std::string name, caption;
  io::StudyRequest options;
  double zoom = 1.0;
  double raise = 0.0;  ///< mm that the camera is moved up
};

struct Column {
  std::string name, caption;
  std::function<void(Look&)> apply;
  bool startsPlain = true;  ///< from the plain look, not from what the data open with
};

struct Sheet {
  std::vector<Row> rows;
  std::vector<Column> columns;
  QSize cell;
  bool hasCaptions = true;
  std::vector<Row> placed{};  ///< seen by the placed cameras, in the last column's look; together the last row
};

/// Draws the sheet into a file and, unless `folder` is empty, each picture at full size into that. Throws
/// std::runtime_error where a file cannot be written, and what reading the data throws.
void draw(const Sheet& sheet, const std::filesystem::path& output, const std::filesystem::path& folder);

}  // namespace fenestra::bench
