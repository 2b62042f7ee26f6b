// info, convert, measure and surface: commands on a volume and its labels, without a picture in 3-D.

#include "app/cli/Commands.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/cli/Report.h"
#include "app/cli/ResultsCommand.h"
#include "io/LabelWriter.h"
#include "io/VolumeWriter.h"
#include "io/base/Text.h"
#include "io/base/Words.h"
#include "io/study/LabelNames.h"
#include "io/study/ReadStudy.h"
#include "io/surface/Surface.h"
#include "rendering/volume/LabelStatistics.h"

namespace fenestra::cli {
namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json list(const Vector& v) {
  return Json{v.x, v.y, v.z};
}

const char* nameOf(Modality modality) {
  switch (modality) {
    case Modality::CT:
      return "CT";
    case Modality::MR:
      return "MR";
    case Modality::PT:
      return "PT";
    case Modality::US:
      return "US";
    case Modality::Unknown:
      break;
  }
  return "";
}

const char* nameOf(io::Warning::Kind kind) {
  using Kind = io::Warning::Kind;
  switch (kind) {
    case Kind::GantryTilt:
      return "gantry tilt";
    case Kind::UnevenSpacing:
      return "uneven spacing";
    case Kind::MissingSlices:
      return "missing slices";
    case Kind::DuplicateSlices:
      return "duplicate slices";
    case Kind::MixedSizes:
      return "mixed sizes";
    case Kind::MixedOrientations:
      return "mixed orientations";
    case Kind::UnreadableFiles:
      return "unreadable files";
    case Kind::NoGeometry:
      return "no geometry";
    case Kind::DamagedPixels:
      return "damaged pixels";
    case Kind::PrecisionLoss:
      return "precision loss";
    case Kind::TimePoints:
      return "time points";
    case Kind::MovedData:
      return "moved data";
    case Kind::ChangedData:
      return "changed data";
    case Kind::Recognised:
      return "recognised";
    case Kind::SlicePlacement:
      return "placement";
    case Kind::Other:
      break;
  }
  return "other";
}

Json describe(const io::SeriesInfo& series, bool descriptions) {
  Json json{
      {"id", series.id}, {"modality", series.modality}, {"dims", list(series.dims)}, {"files", series.files.size()}};
  if (!series.part.empty()) json["part"] = series.part;
  if (series.number) json["number"] = *series.number;
  if (series.thickness > 0.0) json["thickness"] = series.thickness;
  if (!series.kernel.empty()) json["kernel"] = series.kernel;
  if (descriptions) json["description"] = series.description;
  return json;
}

Json describe(const std::vector<io::Warning>& warnings) {
  Json json = Json::array();
  for (const io::Warning& warning : warnings) {
    Json files = Json::array();
    for (const std::filesystem::path& file : warning.files) files.push_back(file.string());
    json.push_back(
        {{"kind", nameOf(warning.kind)}, {"text", io::commandLineText(warning)}, {"files", std::move(files)}});
  }
  return json;
}

/// Names of structures are not free texts: they are what --focus-labels takes.
Json describe(const std::vector<io::SegmentationInfo>& segmentations, bool descriptions) {
  Json json = Json::array();
  for (const io::SegmentationInfo& segmentation : segmentations) {
    json.push_back(
        {{"file", segmentation.file.string()}, {"kind", segmentation.kind}, {"structures", segmentation.structures}});
    if (descriptions) json.back()["description"] = segmentation.description;
  }
  return json;
}

Json describe(const std::optional<io::GeometryReport>& report) {
  if (!report) return nullptr;
  return {
      {"findings", describe(report->findings)},
      {"regularised", wordOf(report->applied).word},
      {"slices", report->slices},
      {"planes", report->planes},
      {"sheared", report->sheared},
      {"scanned_step", report->scannedStep},
      {"step", report->step},
      {"displacement", report->displacement},
      {"displacement_as_is", report->displacementAsIs},
      {"interpolated_planes", report->interpolatedPlanes.size()},
      {"empty_voxels", report->emptyVoxels},
  };
}

/// Focus, labels, strokes and views of a session.
Json describe(const io::Session& session) {
  Json views = Json::array();
  for (const io::SessionView& view : session.views) views.push_back({{"size", {view.size.x, view.size.y}}});
  Json json{
      {"focus", nullptr}, {"labels", nullptr}, {"strokes", session.look.strokes.size()}, {"views", std::move(views)}};
  if (const auto* labels = std::get_if<LabelFocus>(&session.look.focus)) json["focus"] = labels->labels;
  if (const auto* range = std::get_if<ValueFocus>(&session.look.focus))
    json["focus"] = {{"low", range->values.low}, {"high", range->values.high}};
  if (const auto* region = std::get_if<RegionFocus>(&session.look.focus))
    json["focus"] = {
        {"inside", region->inside.size()}, {"outside", region->outside.size()}, {"painted", region->painted.size()}};
  if (!session.labels.path.empty()) json["labels"] = session.labels.path.string();
  return json;
}

}  // namespace

void info(const InfoOptions& options) {
  if (describeResult(options)) return;
  const io::Study study = io::openData(options.data, progressOnTerminal());
  const Volume& volume = *study.scene.volume;
  const Grid& grid = volume.grid;
  Json windows = Json::array();
  for (const WindowLevel& window : volume.windows)
    windows.push_back({{"width", window.width}, {"level", window.level}});
  Json others = Json::array();
  for (const io::SeriesInfo& series : study.otherSeries) others.push_back(describe(series, options.descriptions));
  const glm::dmat3& d = grid.direction;
  const WindowLevel shown = volume.defaultWindow();
  Json json{
      {"source", options.data.source()},
      {"format", study.format},
      {"dims", list(grid.dims)},
      {"spacing", list(grid.spacing)},
      {"origin", list(grid.origin)},
      {"direction", {{d[0].x, d[1].x, d[2].x}, {d[0].y, d[1].y, d[2].y}, {d[0].z, d[1].z, d[2].z}}},
      {"type", fenestra::nameOf(volume.voxels.type())},
      {"slope", volume.slope},
      {"intercept", volume.intercept},
      {"range", {volume.range.low, volume.range.high}},
      {"unit", volume.unit},
      {"modality", nameOf(volume.modality)},
      {"windows", std::move(windows)},
      {"default_window", {{"width", shown.width}, {"level", shown.level}}},
      {"series", describe(study.series, options.descriptions)},
      {"other_series", std::move(others)},
      {"segmentations", describe(study.segmentations, options.descriptions)},
      {"geometry", describe(study.geometry)},
      {"warnings", describe(study.warnings)},
  };
  if (study.restoresSession) json["session"] = describe(study.session);
  printJson(json);
}

void convert(const ConvertOptions& options) {
  const io::Study study = io::openData(options.data, progressOnTerminal());
  printWarnings(study.warnings);
  const bool segmentation = io::lowered(options.output.extension().string()) == ".dcm";
  if (options.data.labels.empty() && options.labels.empty() && !segmentation)
    return io::writeVolume(*study.scene.volume, options.output);
  const std::shared_ptr<const LabelMap>& labels = study.scene.labels;
  const std::filesystem::path source = options.data.labelSource();
  if (!labels) throw io::Error(source, "has no labels to write", "name a label map with --labels");
  io::LabelOutput output;
  if (!options.labels.empty()) output.only = io::resolveLabels(*labels, options.labels, source);
  output.series = study.series.files;
  io::writeLabels(*labels, options.output, output, progressOnTerminal());
}

void measure(const MeasureOptions& options) {
  const io::Study study = io::openData(options.data, progressOnTerminal());
  printWarnings(study.warnings);
  const std::shared_ptr<const LabelMap>& labels = study.scene.labels;
  const std::filesystem::path source = options.data.labelSource();
  if (!labels) throw io::Error(source, "has no labels to measure", "name a label map with --labels");
  std::vector<std::uint16_t> only;
  if (!options.labels.empty()) only = io::resolveLabels(*labels, options.labels, source);
  Json rows = Json::array();
  for (const LabelStatistics& of : labelStatistics(*labels, *study.scene.volume)) {
    if (!only.empty() && !std::binary_search(only.begin(), only.end(), of.label)) continue;
    const auto ifAny = [](bool any, const Json& value) { return any ? value : Json(nullptr); };
    const bool hasValues = of.valued > 0, hasVoxels = of.voxels > 0;
    rows.push_back({{"label", of.label},
                    {"name", labels->find(of.label)->name},
                    {"voxels", of.voxels},
                    {"ml", of.millilitres},
                    {"valued_voxels", of.valued},
                    {"mean", ifAny(hasValues, of.mean)},
                    {"sd", ifAny(hasValues, of.deviation)},
                    {"min", ifAny(hasValues, of.least)},
                    {"max", ifAny(hasValues, of.greatest)},
                    {"centre_lps", ifAny(hasVoxels, list(of.centre))},
                    {"box_lps", ifAny(hasVoxels, {list(of.low), list(of.high)})}});
  }
  printJson(Json{{"unit", study.scene.volume->unit}, {"labels", std::move(rows)}});
}

void surface(const SurfaceOptions& options) {
  const io::Study study = io::readStudy(options.study, progressOnTerminal());
  printWarnings(study.warnings);
  const io::Surface surface =
      io::extractSurface(study.drawn.scene(), options.study.source(), {.smooth = !options.raw}, progressOnTerminal());
  io::writeSurface(surface, options.output, options.frame);
  glm::dvec3 low = surface.points.front(), high = low;
  for (const glm::dvec3& point : surface.points) {
    low = glm::min(low, point);
    high = glm::max(high, point);
  }
  printJson(Json{{"points", surface.points.size()},
                 {"triangles", surface.triangles.size()},
                 {"volume_ml", surface.volume() / 1000.0},
                 {"box_lps", {list(low), list(high)}},
                 {"frame", options.frame == io::SurfaceFrame::Ras ? "ras" : "lps"}});
}

}  // namespace fenestra::cli
