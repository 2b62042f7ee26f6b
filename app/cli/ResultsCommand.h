#pragma once
// `report`: results as DICOM objects, and what `info` says of such objects.

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/Commands.h"
#include "app/options/Options.h"
#include "io/study/StudyRequest.h"

namespace fenestra::cli {

struct ReportOptions {
  enum class Kind : std::uint8_t { Measures, Segmentation, Capture, Keys };
  Kind kind = Kind::Measures;
  io::DataRequest data;
  std::vector<std::string> labels;  ///< those to report, by value or name; all when empty
  std::filesystem::path segments;   ///< where measures write the segmentation that they refer to; empty: beside
  std::filesystem::path picture;    ///< PNG to capture
  std::vector<int> slices;          ///< key images, as scanned, from 0
  std::string description;
  std::filesystem::path output;
};

void addReportOptions(app::Command command, ReportOptions& options);
/// Writes the object; prints what it is as JSON.
void report(const ReportOptions& options);

/// Prints what the file of `options` is, where it is a result; false for all other data.
bool describeResult(const InfoOptions& options);

}  // namespace fenestra::cli
