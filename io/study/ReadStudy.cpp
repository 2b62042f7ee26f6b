#include "io/study/ReadStudy.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "io/LabelReader.h"
#include "io/PhantomFile.h"
#include "io/TransferFunctionFile.h"
#include "io/VolumeReader.h"
#include "io/base/SessionName.h"
#include "io/session/SessionFile.h"
#include "io/session/StrokeFile.h"
#include "io/study/FirstView.h"
#include "io/study/GrowRegion.h"
#include "io/study/LabelNames.h"
#include "io/study/LookChanges.h"
#include "io/study/PhantomView.h"
#include "io/study/SessionData.h"
#include "rendering/segmentation/Couch.h"

namespace fenestra::io {
namespace {

namespace fs = std::filesystem;

void makePhantom(const SessionPhantom& phantom, Study& study, const Progress& progress) {
  OpenedPhantom opened = openPhantom(phantom.name, phantom.voxels, progress);
  takeVolume(std::move(opened.volume), study);
  study.scene.labels = std::move(opened.labels);
}

void openSession(const DataRequest& request, Study& study, const Progress& progress) {
  if (!request.series.empty() || request.raw || request.spacing || request.time || request.modality)
    throw Error(request.path, "records how its volume is read", WayOut::OmitReading);
  study.session = request.session ? *request.session : readSession(request.path);
  study.restoresSession = true;
  study.isRecovered = request.isRecovered;
  if (study.isRecovered)
    study.sessionFile = std::exchange(study.session.autosaveOf, {});
  else if (isSession(request.path))
    study.sessionFile = request.path;
  if (!study.session.phantom) return openSessionData(request, study, progress);
  if (!request.data.empty() || !request.labels.empty() || !request.labelTable.empty())
    throw Error(request.path, "shows a phantom, which is not read from files", WayOut::OmitData);
  makePhantom(*study.session.phantom, study, progress);
}

void openFiles(const DataRequest& request, Study& study, const Progress& progress) {
  const double volumeShare = request.labels.empty() ? 1.0 : 0.8;
  OpenOptions options{.series = request.series,
                      .time = request.time,
                      .raw = request.raw,
                      .spacing = request.spacing,
                      .allowOutside = request.allowOutside,
                      .regularise = request.regularise.value_or(Regularise::Automatic),
                      .modality = request.modality,
                      .progress = partOf(progress, 0.0, volumeShare)};
  takeVolume(openVolume(request.path, options), study);
  study.session.volume = sessionVolume(request.path, study, options);
  if (request.labels.empty()) return;
  OpenedLabels opened = openLabels(request.labels, study.scene.volume->grid, partOf(progress, volumeShare, 1.0),
                                   request.allowOutside, request.labelTable);
  study.scene.labels = std::move(opened.labels);
  std::move(opened.warnings.begin(), opened.warnings.end(), std::back_inserter(study.warnings));
  study.session.labels = sessionLabels(request.labels, request.labelTable);
}

ContextFunction contextOf(const StudyRequest& request, const Volume& volume) {
  if (!request.transferFunction.empty()) return loadContextFunction(request.transferFunction, volume);
  return request.startsPlain ? loadContextFunction(plainPreset(volume), volume) : startingContext(volume);
}

void setContext(const StudyRequest& request, Study& study) {
  SetScene& scene = study.scene;
  const bool hasFunction = (study.restoresSession && !request.startsContextAnew) || request.preset;
  if (request.preset && request.transferFunction.empty())
    if (const std::string odd = mismatchOf(*request.preset, scene.volume->unit); !odd.empty())
      study.warnings.push_back({Warning::Kind::Other, odd, {}});
  if (!hasFunction || !request.transferFunction.empty()) scene.look.context = contextOf(request, *scene.volume);
  if (!scene.look.hideTable) return;
  scene.table = segmentation::tableOf(*scene.volume);
  if (scene.table->count > 0) study.warnings.push_back(tableWarning());
}

/// What Automatic stood for before version 3 of sessions.
void keepFormerAutomatic(Study& study) {
  Look& look = study.scene.look;
  const bool isOfSession = std::exchange(study.session.formerAutomatic, false);
  if (!isOfSession || look.reconstruction != Reconstruction::Auto) return;
  const Reconstruction now = reconstructionOf(Scene{study.scene.volume, nullptr, look});
  if (now == Reconstruction::Smoother) look.reconstruction = Reconstruction::Smooth;
}

bool hasVoxels(const LabelMap& labels, const std::vector<std::uint16_t>& wanted) {
  return labels.voxels.visit([&](auto scalars) {
    return std::any_of(scalars.begin(), scalars.end(), [&](auto value) {
      return std::binary_search(wanted.begin(), wanted.end(), static_cast<std::uint16_t>(value));
    });
  });
}

/// Sets the focus of the request, or the phantom's own; otherwise that of the session stays.
void setFocus(const StudyRequest& request, Study& study) {
  SetScene& scene = study.scene;
  std::vector<std::string> wanted = request.focusLabels;
  const bool given = request.focusRange || !request.region.empty();
  if (!request.phantom.empty() && wanted.empty() && !given) wanted = phantomView(request.phantom).focus;
  if (!request.region.empty()) {
    scene.look.focus = request.region;
  } else if (request.focusRange) {
    scene.look.focus = ValueFocus{*request.focusRange, request.focusMinimumSize};
  } else if (!wanted.empty()) {
    const fs::path file = request.labelSource();
    if (!scene.labels) throw Error(file, "has no labels to focus on", WayOut::NameLabels);
    scene.look.focus = LabelFocus{resolveLabels(*scene.labels, wanted, file)};
  }
  const auto* labels = std::get_if<LabelFocus>(&scene.look.focus);
  if (labels && scene.labels && !hasVoxels(*scene.labels, labels->labels))
    study.warnings.push_back({Warning::Kind::Other, "the focus has no voxels in this volume", {request.labelSource()}});
}

/// Grows the region in the focus, if there is one. That of a session may lie outside a volume that has changed.
void growFocus(const StudyRequest& request, Study& study, const Progress& progress) {
  const auto* region = std::get_if<RegionFocus>(&study.scene.look.focus);
  if (!region) return;
  const Volume& volume = *study.scene.volume;
  const bool isOfSession = request.region.empty();
  if (isOfSession && !segmentation::canGrow(volume, *region)) {
    study.warnings.push_back({Warning::Kind::ChangedData, segmentation::cannotGrow, {request.path}});
    study.scene.look.focus = std::monostate{};
  } else if (isOfSession && request.acceptsAnyRegion) {
    study.growth = growRegion(volume, *region, progress, study.memory);
  } else {
    study.growth = growWholeRegion(volume, *region, request.source(), progress);
  }
}

}  // namespace

Warning tableWarning() {
  return {
      Warning::Kind::Other, "the scanner's table is left out of 3-D pictures; slices show it", {}, WayOut::ShowTable};
}

Study openData(const DataRequest& request, const Progress& progress) {
  Study study;
  if (!request.phantom.empty()) {
    study.session.phantom = {request.phantom, request.phantomVoxels};
    makePhantom(*study.session.phantom, study, progress);
  } else if (request.session || isSession(request.path)) {
    openSession(request, study, progress);
  } else {
    openFiles(request, study, progress);
  }
  study.scene.look = study.session.look;
  return study;
}

Study readStudy(const StudyRequest& request, const Progress& progress) {
  Study study = openData(request, progress);
  study.scene.look = request.look;
  keepFormerAutomatic(study);
  setContext(request, study);
  setFocus(request, study);
  setLabelSettings(request, study.scene);
  if (request.preset) setLabelFunctions(study.scene, *request.preset);
  setFocusFunctions(request, study.scene);
  setClipping(request, study.scene);
  if (!request.strokes.empty()) study.scene.look.strokes = readStrokes(request.strokes);
  growFocus(request, study, progress);
  study.drawn.update(study.scene, study.growth.get());
  setFirstView(request, study);
  study.session = sessionOf(study);
  return study;
}

}  // namespace fenestra::io
