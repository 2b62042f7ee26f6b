#include "viewer/jobs/ReadStudy.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <system_error>

#include "io/TransferFunctionFile.h"

namespace fenestra::viewer {
Study readStudy(const PathsToOpen& paths, const Look& look, const io::Progress& progress) {
  io::OpenedVolume opened = io::openVolume(paths.volume, {.series = paths.series, .raw = {}, .progress = progress});
  Study study;
  study.scene.volume = opened.volume;
  study.scene.look = look;
  study.scene.look.focus = std::monostate{};
  study.scene.look.clipping = {};
  study.scene.look.strokes.clear();
  study.scene.look.context = io::loadContextFunction(io::defaultPreset(*opened.volume), *opened.volume);
  study.path = paths.volume;
  study.session.volume = io::sessionVolume(paths.volume, opened);
  study.series = std::move(opened.series);
  study.patient = std::move(opened.patient);
  study.otherSeries = std::move(opened.otherSeries);
  study.segmentations = std::move(opened.segmentations);
  study.warnings = std::move(opened.warnings);
  study.geometry = std::move(opened.geometry);
  if (!paths.labels.empty()) {
    io::OpenedLabels labels = io::openLabels(paths.labels, study.scene.volume->grid, progress);
    study.session.labels = io::sessionLabels(paths.labels);
    study.scene.labels = std::move(labels.labels);
    std::move(labels.warnings.begin(), labels.warnings.end(), std::back_inserter(study.warnings));
  }
  return study;
}

namespace {

/// Grows the region in the study's focus again. A volume that has changed may not hold its seeds any more.
void growFocus(Study& study, const io::Progress& progress) {
  const auto* region = std::get_if<RegionFocus>(&study.scene.look.focus);
  if (!region) return;
  const Volume& volume = *study.scene.volume;
  if (!segmentation::canGrow(volume, *region)) {
    study.warnings.push_back({io::Warning::Kind::ChangedData, segmentation::cannotGrow, {study.path}});
    study.scene.look.focus = std::monostate{};
    return;
  }
  auto growth = segmentation::growRegion(
      volume, *region, segmentation::wholeOf(volume.grid.dims),
      [&](double fraction) { return !progress || progress(fraction, "growing the region in focus"); });
  if (!growth) throw io::Cancelled();
  study.growth = std::make_shared<const segmentation::Growth>(std::move(*growth));
}

Study studyOf(io::OpenedSession opened, const io::Progress& progress) {
  Study study;
  study.scene = {opened.volume.volume, std::move(opened.labels), opened.session.look};
  study.camera = opened.session.views[0].camera;
  study.path = opened.session.volume.path;
  study.series = std::move(opened.volume.series);
  study.patient = std::move(opened.volume.patient);
  study.otherSeries = std::move(opened.volume.otherSeries);
  study.segmentations = std::move(opened.volume.segmentations);
  study.warnings = std::move(opened.warnings);
  study.geometry = std::move(opened.volume.geometry);
  study.session = std::move(opened.session);
  study.restoresSession = true;
  growFocus(study, progress);
  return study;
}

}  // namespace

Study readSession(const std::filesystem::path& file, const io::SessionPlaces& places, const io::Progress& progress) {
  Study study = studyOf(io::openSession(file, places, progress), progress);
  study.sessionFile = file;
  return study;
}

Study readAgain(const io::Session& session, io::Regularise regularise, const io::Progress& progress) {
  const io::SessionPlaces same{.volume = session.volume.path, .labels = session.labels.path, .regularise = regularise};
  return studyOf(io::openSession(session, session.volume.path.parent_path(), same, progress), progress);
}

namespace {

namespace fs = std::filesystem;

bool isFolder(const fs::path& path) {
  std::error_code unknown;
  return fs::is_directory(path, unknown);
}

/// Whether a name says that a file holds labels. File managers drop several files in any order.
bool soundsLikeLabels(const fs::path& path) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  const char* const words[] = {"seg", "label", "mask", "rtstruct"};
  return std::any_of(std::begin(words), std::end(words),
                     [&](const char* word) { return name.find(word) != std::string::npos; });
}

/// The folder that holds these folders and no others, whose series are then those of all; empty: there is none.
fs::path folderOfAll(const std::vector<fs::path>& folders) {
  const fs::path parent = folders.front().parent_path();
  std::error_code unknown;
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, unknown))
    if (std::find(folders.begin(), folders.end(), entry.path()) == folders.end()) return {};
  return unknown ? fs::path() : parent;
}

}  // namespace

PathsToOpen interpret(const std::vector<fs::path>& paths) {
  if (paths.size() == 1) return {paths.front(), {}, {}};
  const fs::path folder = paths.front().parent_path();
  const auto folders = std::count_if(paths.begin(), paths.end(), isFolder);
  if (folders == static_cast<std::ptrdiff_t>(paths.size())) {
    const fs::path all = folderOfAll(paths);
    if (!all.empty()) return {all, {}, {}};
    throw io::Error(paths[1], "is a second folder", "open one folder, or the folder that holds them all");
  }
  const bool slices = folders == 0 && std::all_of(paths.begin(), paths.end(), [&](const fs::path& path) {
                        return path.parent_path() == folder && io::volumeEnding(path).empty();
                      });
  if (slices) return {folder.empty() ? fs::path(".") : folder, {}, {}};
  if (paths.size() > 2)
    throw io::Error(paths[2], "too many files at once", "open a volume, a volume and its label map, or one folder");
  const bool swapped = folders == 1 ? isFolder(paths[1]) : soundsLikeLabels(paths[0]) && !soundsLikeLabels(paths[1]);
  return swapped ? PathsToOpen{paths[1], {}, paths[0]} : PathsToOpen{paths[0], {}, paths[1]};
}

}  // namespace fenestra::viewer
