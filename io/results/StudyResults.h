#pragma once
// Results of a study as DICOM objects: which labels and measures a report holds, and which images are meant. The
// objects themselves: io/report. All functions throw Error.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/report/Results.h"
#include "io/study/Study.h"

namespace fenestra::io {

/// What results are made from. Plain data; copies share the voxels.
struct ResultSource {
  std::filesystem::path name;  ///< that errors name
  std::string format;          ///< as VolumeInfo has it
  std::shared_ptr<const Volume> volume;
  std::shared_ptr<const LabelMap> labels;  ///< may be null
  std::vector<Measure> measures;
  std::vector<std::filesystem::path> files;  ///< of the series
  std::vector<SliceSource> slices;           ///< as scanned; empty where an archive holds them

  bool isDicom() const { return format == "DICOM" && !files.empty(); }
};
ResultSource resultSourceOf(const Study& study, const std::filesystem::path& name);

/// The DICOM files of the series, which a result is about. Throws where it is no DICOM series.
const std::vector<std::filesystem::path>& dicomFilesOf(const ResultSource& source);

/// The rows of the table of labels: those of `only`, ascending, or all when it is empty; those without voxels are left
/// out.
std::vector<report::MeasuredLabel> measuredLabels(const ResultSource& source, const std::vector<std::uint16_t>& only);

/// A DICOM segmentation of `labels`, which lie on the source's grid; `only` is ascending, empty: all. Without DICOM
/// files it is a study of its own. `description`: of the series; empty: "Segmentation".
void writeSegments(const ResultSource& source, const LabelMap& labels, const std::vector<std::uint16_t>& only,
                   const std::string& description, const std::filesystem::path& file, const Progress& progress);

struct MeasuresOutput {
  std::filesystem::path report;
  std::filesystem::path segments;        ///< the segmentation that it refers to; unused where no label has voxels
  std::vector<std::uint16_t> only = {};  ///< labels, ascending; empty: all
  std::string description = {};          ///< of both series; empty: "Measurements" and "Segmentation"
};
struct MeasuresWritten {
  std::size_t labels = 0, measures = 0;
};
/// The table of labels and the measures, marks left out, as a structured report, and the segments that it is about.
MeasuresWritten writeMeasures(const ResultSource& source, const MeasuresOutput& output, const Progress& progress);

/// Why slices were chosen, and the description of the selection's series; both may be empty.
struct KeyTexts {
  std::string why, series;
};
/// A key object selection of slices as scanned, from 0.
void writeKeySlices(const ResultSource& source, const std::vector<int>& slices, const KeyTexts& texts,
                    const std::filesystem::path& file);

}  // namespace fenestra::io
