#include "io/results/StudyResults.h"

#include <algorithm>

#include "io/LabelWriter.h"

namespace fenestra::io {

ResultSource resultSourceOf(const Study& study, const std::filesystem::path& name) {
  return {name,        study.format, study.scene.volume, study.scene.labels, study.session.measures, study.series.files,
          study.slices};
}

const std::vector<std::filesystem::path>& dicomFilesOf(const ResultSource& source) {
  if (!source.isDicom())
    throw Error(
        source.name,
        "is no DICOM series (its format is " + source.format + "), and no DICOM study that the result could belong to",
        "name the DICOM files that it was made from, or write a segmentation, which is a study of its own");
  return source.files;
}

std::vector<report::MeasuredLabel> measuredLabels(const ResultSource& source, const std::vector<std::uint16_t>& only) {
  std::vector<report::MeasuredLabel> rows;
  if (!source.labels) return rows;
  for (const LabelStatistics& of : labelStatistics(*source.labels, *source.volume))
    if (of.voxels > 0 && of.label != 0 && (only.empty() || std::binary_search(only.begin(), only.end(), of.label)))
      rows.push_back({source.labels->find(of.label)->name, of});
  return rows;
}

void writeSegments(const ResultSource& source, const LabelMap& labels, const std::vector<std::uint16_t>& only,
                   const std::string& description, const std::filesystem::path& file, const Progress& progress) {
  LabelOutput output;
  output.only = only;
  output.series = source.files;
  output.description = description;
  writeLabels(labels, file, output, progress);
}

MeasuresWritten writeMeasures(const ResultSource& source, const MeasuresOutput& output, const Progress& progress) {
  const std::vector<std::filesystem::path>& files = dicomFilesOf(source);
  report::Measures measures;
  measures.labels = measuredLabels(source, output.only);
  measures.modality = source.volume->modality;
  measures.unit = source.volume->unit;
  measures.description = output.description;
  for (const Measure& measure : source.measures)
    if (!isMark(measure.kind)) measures.drawn.push_back({measure, valuesOf(measure, *source.volume)});
  if (!measures.labels.empty()) {
    measures.segmentation = output.segments;
    std::vector<std::uint16_t> only;
    for (const report::MeasuredLabel& label : measures.labels) only.push_back(label.statistics.label);
    std::sort(only.begin(), only.end());
    writeSegments(source, *source.labels, only, output.description, measures.segmentation, progress);
  }
  report::writeMeasures(measures, files, output.report);
  return {measures.labels.size(), measures.drawn.size()};
}

void writeKeySlices(const ResultSource& source, const std::vector<int>& slices, const KeyTexts& texts,
                    const std::filesystem::path& file) {
  const std::vector<std::filesystem::path>& files = dicomFilesOf(source);
  if (source.slices.empty())
    throw Error(source.name, "is an archive, whose slices cannot be told apart", "unpack it and open the folder");
  const int count = static_cast<int>(source.slices.size());
  report::KeyObjects keys;
  keys.description = texts.why;
  keys.series = texts.series;
  for (const int slice : slices) {
    if (slice < 0 || slice >= count)
      throw Error(source.name, "there is no slice " + std::to_string(slice),
                  "slices run from 0 to " + std::to_string(count - 1));
    keys.images.push_back(source.slices[static_cast<std::size_t>(slice)]);
  }
  report::writeKeyObjects(keys, files, file);
}

}  // namespace fenestra::io
