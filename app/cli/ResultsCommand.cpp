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
#include "io/results/StudyResults.h"
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

io::ResultSource sourceOf(const io::Study& study, const ReportOptions& options) {
  return io::resultSourceOf(study, options.data.source());
}

/// The labels that the user named, ascending; empty: all.
std::vector<std::uint16_t> chosenLabels(const io::Study& study, const ReportOptions& options) {
  std::vector<std::uint16_t> only;
  if (study.scene.labels && !options.labels.empty())
    only = io::resolveLabels(*study.scene.labels, options.labels, options.data.labelSource());
  std::sort(only.begin(), only.end());
  return only;
}

Json reportMeasures(const io::Study& study, const ReportOptions& options) {
  io::MeasuresOutput output;
  output.report = options.output;
  output.segments = options.segments;
  if (output.segments.empty())
    output.segments = options.output.parent_path() / (options.output.stem().string() + "-segments.dcm");
  output.only = chosenLabels(study, options);
  output.description = options.description;
  const io::MeasuresWritten written = io::writeMeasures(sourceOf(study, options), output, progressOnTerminal());
  return {{"segments", written.labels == 0 ? Json(nullptr) : Json(output.segments.string())},
          {"labels", written.labels},
          {"measures", written.measures}};
}

Json reportSegmentation(const io::Study& study, const ReportOptions& options) {
  if (!study.scene.labels)
    throw io::Error(options.data.labelSource(), "has no labels to report", "name a label map with --labels");
  io::writeSegments(sourceOf(study, options), *study.scene.labels, chosenLabels(study, options), options.description,
                    options.output, progressOnTerminal());
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
  io::report::writeCapture(capture, sourceOf(study, options).isDicom() ? study.series.files : std::vector<fs::path>(),
                           options.output);
  return {{"size", {picture.size.x, picture.size.y}}};
}

Json reportKeys(const io::Study& study, const ReportOptions& options) {
  io::writeKeySlices(sourceOf(study, options), options.slices, {options.description, options.description},
                     options.output);
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
  command.addValue("--description", options.description, "what the result shows, or why the keys were chosen")
      .as("TEXT");
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
