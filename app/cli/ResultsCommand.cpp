#include "app/cli/ResultsCommand.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>

#include <nlohmann/json.hpp>

#include "app/DataOptions.h"
#include "app/cli/Report.h"
#include "io/ImageWriter.h"
#include "io/LabelWriter.h"
#include "io/report/Results.h"
#include "io/study/LabelNames.h"
#include "io/study/ReadStudy.h"

namespace fenestra::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using ReportKind = ReportOptions::Kind;

std::optional<int> wholeNumber(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

/// "3,17,40-44"; false: it is not of that form. More than a million slices are a slip of the keyboard.
bool readSlices(const std::string& text, std::vector<int>& slices) {
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t dash = part.find('-');
    const auto first = wholeNumber(part.substr(0, dash));
    const auto last = dash == std::string::npos ? first : wholeNumber(part.substr(dash + 1));
    if (!first || !last || *last < *first || *last - *first > 1'000'000) return false;
    for (int slice = *first; slice <= *last; ++slice) slices.push_back(slice);
  }
  return !slices.empty();
}

bool isDicom(const io::Study& study) { return study.format == "DICOM" && !study.series.files.empty(); }

/// The DICOM files of the series, which a result of this kind is about.
const std::vector<fs::path>& seriesOf(const io::Study& study, const ReportOptions& options) {
  if (!isDicom(study))
    throw io::Error(
        options.data.source(),
        "is no DICOM series (its format is " + study.format + "), and no DICOM study that the result could belong to",
        "name the DICOM files that it was made from, or write a segmentation, which is a study of its own");
  return study.series.files;
}

/// The labels to report, those without voxels left out.
std::vector<io::report::MeasuredLabel> measuredLabels(const io::Study& study, const ReportOptions& options) {
  std::vector<io::report::MeasuredLabel> rows;
  const std::shared_ptr<const LabelMap>& labels = study.scene.labels;
  if (!labels) return rows;
  std::vector<std::uint16_t> only;
  if (!options.labels.empty()) only = io::resolveLabels(*labels, options.labels, options.data.labelSource());
  for (const LabelStatistics& of : labelStatistics(*labels, *study.scene.volume))
    if (of.voxels > 0 && of.label != 0 && (only.empty() || std::binary_search(only.begin(), only.end(), of.label)))
      rows.push_back({labels->find(of.label)->name, of});
  return rows;
}

void writeSegments(const io::Study& study, std::vector<std::uint16_t> only, const fs::path& file) {
  io::LabelOutput output;
  std::sort(only.begin(), only.end());
  output.only = std::move(only);
  output.series = study.series.files;
  io::writeLabels(*study.scene.labels, file, output, progressOnTerminal());
}

Json reportMeasures(const io::Study& study, const ReportOptions& options) {
  io::report::Measures measures;
  measures.labels = measuredLabels(study, options);
  measures.modality = study.scene.volume->modality;
  measures.unit = study.scene.volume->unit;
  for (const Measure& measure : study.session.measures)
    measures.drawn.push_back({measure, valuesOf(measure, *study.scene.volume)});
  const std::vector<fs::path>& series = seriesOf(study, options);
  if (!measures.labels.empty()) {
    measures.segmentation = options.segments;
    if (measures.segmentation.empty())
      measures.segmentation = options.output.parent_path() / (options.output.stem().string() + "-segments.dcm");
    std::vector<std::uint16_t> only;
    for (const io::report::MeasuredLabel& label : measures.labels) only.push_back(label.statistics.label);
    writeSegments(study, std::move(only), measures.segmentation);
  }
  io::report::writeMeasures(measures, series, options.output);
  return {{"segments", measures.labels.empty() ? Json(nullptr) : Json(measures.segmentation.string())},
          {"labels", measures.labels.size()},
          {"measures", measures.drawn.size()}};
}

Json reportSegmentation(const io::Study& study, const ReportOptions& options) {
  if (!study.scene.labels)
    throw io::Error(options.data.labelSource(), "has no labels to report", "name a label map with --labels");
  std::vector<std::uint16_t> only;
  if (!options.labels.empty())
    only = io::resolveLabels(*study.scene.labels, options.labels, options.data.labelSource());
  writeSegments(study, std::move(only), options.output);
  return Json::object();
}

/// What was done to the voxels before they could be pictured.
std::vector<std::string> alterations(const io::Study& study) {
  std::vector<std::string> sentences;
  for (const io::Warning& warning : study.warnings) {
    using Kind = io::Warning::Kind;
    const bool isGeometry =
        study.geometry && std::find(study.geometry->findings.begin(), study.geometry->findings.end(), warning) !=
                              study.geometry->findings.end();
    if (isGeometry || warning.kind == Kind::DamagedPixels || warning.kind == Kind::PrecisionLoss)
      sentences.push_back(warning.text);
  }
  return sentences;
}

Json reportCapture(const io::Study& study, const ReportOptions& options) {
  const io::Picture picture = io::readPicture(options.picture);
  const std::vector<io::PngText> texts = io::readPngTexts(options.picture);  // refuses what is no PNG
  io::report::Capture capture;
  capture.size = picture.size;
  const auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t at = 0; at < picture.values.size(); at += channels) {
    // Over black, as the window's background is where a picture lets it through.
    const float opacity = channels == 4 ? picture.values[at + 3] : 1.0f;
    for (std::size_t c = 0; c < 3; ++c)
      capture.pixels.push_back(
          static_cast<std::uint8_t>(std::lround(picture.values[at + (channels >= 3 ? c : 0)] * opacity * 255.0f)));
  }
  capture.description = options.description;
  capture.alters = alterations(study);
  for (const io::PngText& text : texts) capture.comments += (capture.comments.empty() ? "" : "\n") + text.text;
  io::report::writeCapture(capture, isDicom(study) ? study.series.files : std::vector<fs::path>(), options.output);
  return {{"size", {picture.size.x, picture.size.y}}};
}

Json reportKeys(const io::Study& study, const ReportOptions& options) {
  const std::vector<fs::path>& series = seriesOf(study, options);
  if (study.slices.empty())
    throw io::Error(options.data.source(), "is an archive, whose slices cannot be told apart",
                    "unpack it and open the folder");
  const int count = static_cast<int>(study.slices.size());
  io::report::KeyObjects keys;
  keys.description = options.description;
  for (const int slice : options.slices) {
    if (slice >= count)
      throw io::Error(options.data.source(), "there is no slice " + std::to_string(slice),
                      "slices run from 0 to " + std::to_string(count - 1));
    keys.images.push_back(study.slices[static_cast<std::size_t>(slice)]);
  }
  io::report::writeKeyObjects(keys, series, options.output);
  return {{"slices", options.slices}};
}

Json jsonOf(const io::report::ResultObject::Value& value) {
  Json json{{"of", value.group},
            {"name", value.name},
            {"derivation", value.derivation.empty() ? Json(nullptr) : Json(value.derivation)},
            {"value", value.value},
            {"unit", value.unit},
            {"segment", value.segment > 0 ? Json(value.segment) : Json(nullptr)}};
  Json points = Json::array();
  for (const glm::dvec3 point : value.points) points.push_back(listOf(point));
  if (!value.points.empty()) json["points_lps"] = std::move(points);
  return json;
}

}  // namespace

void addReportOptions(app::Command command, ReportOptions& options) {
  app::addChoice<ReportKind>(command, "KIND", "measures, segmentation, capture or keys",
                             {{"measures", ReportKind::Measures},
                              {"segmentation", ReportKind::Segmentation},
                              {"capture", ReportKind::Capture},
                              {"keys", ReportKind::Keys}},
                             options.kind)
      .required();
  app::addVolumeOptions(command, options.data);
  command.group("Labels");
  app::addLabelChoice(command, options.data, options.labels);
  command.group("Options");
  command.addValue("-o,--output", options.output, "DICOM file to write").required().as("OUT.dcm");
  const app::Option segments =
      command
          .addValue("--segments", options.segments,
                    "of measures: where the segmentation goes that they refer to; OUT-segments.dcm otherwise")
          .as("FILE.dcm");
  const app::Option picture =
      command.addValue("--picture", options.picture, "of a capture: the picture").as("FILE.png");
  const app::Option slices =
      command.add("--slices", "K,K-K", "of keys: numbers of the slices as scanned, from 0",
                  [&options](const std::string& text) { return readSlices(text, options.slices); });
  command.addValue("--description", options.description, "of a capture or of keys: what it shows, or why").as("TEXT");
  command.atLast([command, segments, picture, slices, &options] {
    if (!command.isGiven("PATH") && !command.isGiven("--phantom")) throw app::MissingOption{"PATH or --phantom"};
    if (options.kind == ReportKind::Capture && !picture.isGiven()) throw app::MissingOption{"--picture", "capture"};
    if (options.kind == ReportKind::Keys && !slices.isGiven()) throw app::MissingOption{"--slices", "keys"};
    if (options.output.extension() != ".dcm")
      throw app::WrongValue{"--output: " + options.output.string() + " does not end in .dcm"};
  });
}

void report(const ReportOptions& options) {
  const io::Study study = io::openData(options.data, progressOnTerminal());
  printWarnings(study.warnings);
  const std::map<ReportKind, std::pair<const char*, Json (*)(const io::Study&, const ReportOptions&)>> kinds{
      {ReportKind::Measures, {"measures", reportMeasures}},
      {ReportKind::Segmentation, {"segmentation", reportSegmentation}},
      {ReportKind::Capture, {"capture", reportCapture}},
      {ReportKind::Keys, {"keys", reportKeys}}};
  const auto& [name, write] = kinds.at(options.kind);
  const Json details = write(study, options);
  const std::optional<io::report::ResultObject> written = io::report::readResult(options.output);
  Json json{{"source", options.data.source()}, {"kind", name}, {"file", options.output.string()}};
  if (written) {
    json["study"] = written->study;
    json["series"] = written->series;
    json["instance"] = written->instance;
  }
  json.update(details);
  printJson(json);
}

bool describeResult(const InfoOptions& options) {
  if (options.tags || options.data.raw || options.data.path.empty()) return false;
  const std::optional<io::report::ResultObject> result = io::report::readResult(options.data.path);
  if (!result) return false;
  // Its reader says what is wrong with one that holds no segments.
  if (result->kind == "segmentation" && result->segments.empty()) return false;
  Json values = Json::array(), images = Json::array();
  for (const auto& value : result->values) values.push_back(jsonOf(value));
  for (const auto& image : result->images) {
    images.push_back({{"instance", image.instance}});
    if (!image.frames.empty()) images.back()["frames"] = image.frames;
  }
  Json json{{"source", options.data.source()},
            {"format", "DICOM"},
            {"kind", result->kind},
            {"title", result->title},
            {"sop_class", result->sopClass},
            {"instance", result->instance},
            {"series", result->series},
            {"study", result->study},
            {"frame_of_reference", result->frameOfReference}};
  if (result->kind == "segmentation") json["segments"] = result->segments;
  if (result->kind == "measures") json["measures"] = std::move(values);
  if (result->kind == "keys") json["images"] = std::move(images);
  if (options.descriptions) {
    json["description"] = result->description;
    json["texts"] = result->texts;
  }
  printJson(json);
  return true;
}

}  // namespace fenestra::cli
