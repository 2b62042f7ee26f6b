#include "app/SceneOptions.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string_view>

#include <CLI/CLI.hpp>

#include "app/CameraFile.h"
#include "app/Growing.h"
#include "app/LabelOptions.h"
#include "app/LightOptions.h"
#include "app/RemovalOptions.h"
#include "app/SceneSession.h"
#include "app/SettingOptions.h"
#include "app/WallOptions.h"
#include "io/PhantomFile.h"
#include "io/TransferFunctionFile.h"
#include "io/base/ModalityWords.h"
#include "io/session/OpenSession.h"
#include "io/session/SessionFile.h"
#include "io/session/StrokeFile.h"
#include "rendering/scene/LookStyle.h"
#include "rendering/segmentation/Table.h"

namespace fenestra::app {
namespace {

namespace fs = std::filesystem;

constexpr int largestPicture = 16384;  ///< pixels a side, what OpenGL 4.5 drivers commonly offer

std::optional<CameraChoice> parseCamera(const std::string& text) {
  static const std::vector<std::pair<std::string, StandardView>> views{
      {"A", StandardView::Anterior}, {"P", StandardView::Posterior}, {"L", StandardView::Left},
      {"R", StandardView::Right},    {"S", StandardView::Superior},  {"I", StandardView::Inferior}};
  for (const auto& [letter, view] : views)
    if (text == letter) return view;
  if (text == "best") return PlacedView::Best;
  if (text == "dual") return PlacedView::Dual;
  if (const auto angles = parseNumbers<double, 2>(text, ',')) return ViewAngles{(*angles)[0], (*angles)[1]};
  if (fs::path(text).extension() == ".json") return fs::path(text);
  return std::nullopt;
}

std::size_t countVoxels(const LabelMap& labels, const std::vector<std::uint16_t>& wanted) {
  return labels.voxels.visit([&](auto scalars) {
    return static_cast<std::size_t>(std::count_if(scalars.begin(), scalars.end(), [&](auto value) {
      return std::binary_search(wanted.begin(), wanted.end(), static_cast<std::uint16_t>(value));
    }));
  });
}

/// The focus and camera that a phantom opens with: structures behind others, and a side that shows the cutaway well.
struct PhantomView {
  std::vector<std::string> focus;
  CameraChoice camera;
};
PhantomView phantomView(const std::string& phantom) {
  if (phantom == "head") return {{"tumour", "ventricles"}, ViewAngles{50.0, 20.0}};
  return {{"heart muscle", "left ventricle", "right ventricle", "left atrium", "right atrium", "aorta", "left kidney",
           "right kidney", "lesion"},
          ViewAngles{25.0, 12.0}};
}

Camera makeCamera(const SceneOptions& options, const CameraChoice& choice, const Framing& framing) {
  const Projection projection = options.projection.value_or(Projection::Perspective);
  if (const auto* view = std::get_if<StandardView>(&choice)) return Camera::standard(*view, framing, projection);
  const auto& angles = std::get<ViewAngles>(choice);
  return Camera::fromAngles(angles.azimuth, angles.elevation, framing, projection);
}

/// The part of a progress bar from `begin` to `end`.
io::Progress part(const io::Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [=](double fraction, std::string_view doing) { return progress(std::lerp(begin, end, fraction), doing); };
}

/// Sets the focus of the options, or the phantom's own; otherwise that of the session stays.
void setFocus(const SceneOptions& options, LoadedScene& loaded) {
  Scene& scene = loaded.asSet;
  std::vector<std::string> wanted = options.focusLabels;
  const bool given = options.focusRange || !options.region.empty();
  if (!options.phantom.empty() && wanted.empty() && !given) wanted = phantomView(options.phantom).focus;
  if (!options.region.empty()) {
    scene.look.focus = options.region;
  } else if (options.focusRange) {
    scene.look.focus = ValueFocus{*options.focusRange, options.focusMinimumSize};
  } else if (!wanted.empty()) {
    const fs::path file = options.labels.empty() ? fs::path(options.source()) : options.labels;
    if (!scene.labels) throw io::Error(file, "has no labels to focus on", "name a label map with --labels");
    scene.look.focus = LabelFocus{resolveLabels(*scene.labels, wanted, file)};
  }
  const auto* labels = std::get_if<LabelFocus>(&scene.look.focus);
  if (labels && countVoxels(*scene.labels, labels->labels) == 0)
    loaded.warnings.push_back({io::Warning::Kind::Other,
                               "the focus has no voxels in this volume",
                               {options.labels.empty() ? fs::path(options.source()) : options.labels}});
}

/// Grows the region in the focus, if there is one. That of a session may lie outside a volume that has changed.
void growFocus(const SceneOptions& options, LoadedScene& loaded, const io::Progress& progress) {
  Scene& scene = loaded.asSet;
  if (const auto* region = std::get_if<RegionFocus>(&scene.look.focus)) {
    if (options.region.empty() && !segmentation::canGrow(*scene.volume, *region)) {
      loaded.warnings.push_back({io::Warning::Kind::ChangedData, segmentation::cannotGrow, {options.path}});
      scene.look.focus = std::monostate{};
    } else {
      loaded.growth = grow(*scene.volume, *region, options.source(), progress);
    }
  }
  loaded.scene = Sculptor().of(loaded.growth ? segmentation::shownScene(scene, *loaded.growth) : scene);
}

/// A camera that is not placed; with a size where a file names one.
CameraFile cameraOf(const SceneOptions& options, const CameraChoice& choice, const Scene& scene) {
  if (const auto* file = std::get_if<fs::path>(&choice)) {
    CameraFile read = readCamera(*file);
    read.camera.projection = options.projection.value_or(read.camera.projection);
    return read;
  }
  return {makeCamera(options, choice, visibleFraming(shownVolume(scene), scene.look.context.shifted())), glm::ivec2(0)};
}

/// Camera, size and sampling: from the options, else from the session's view, else the defaults.
void setView(const SceneOptions& options, LoadedScene& loaded) {
  View& view = loaded.view;
  view.size = {960, 720};
  view.quality = options.quality;
  view.maxError = options.maxError;
  std::optional<CameraChoice> choice = options.camera;
  const auto* saved =
      loaded.session ? &loaded.session->views[static_cast<std::size_t>(options.viewOfSession)] : nullptr;
  if (saved) {
    view.size = saved->size;
    view.pixelScale = saved->pixelScale;
  } else if (!choice) {
    const bool plainPhantom = !options.phantom.empty() && options.focusLabels.empty() && !options.focusRange;
    choice = plainPhantom ? phantomView(options.phantom).camera : StandardView::Anterior;
  }
  if (!choice) {
    view.camera = saved->camera;
    view.camera.projection = options.projection.value_or(view.camera.projection);
    view.size = options.size.value_or(view.size);
    if (saved->fitsWidth) view.camera = view.camera.fittedTo(static_cast<double>(view.size.x) / view.size.y);
    return;
  }
  if (const auto* placed = std::get_if<PlacedView>(&*choice)) {
    loaded.placed = *placed;
    choice = StandardView::Anterior;
  }
  const CameraFile chosen = cameraOf(options, *choice, loaded.scene);
  view.camera = chosen.camera;
  if (chosen.size.x > 0) view.size = chosen.size;
  view.size = options.size.value_or(view.size);
}

/// The opening's own camera, from the options or else from the session's view.
void freezeView(const SceneOptions& options, LoadedScene& loaded) {
  View& view = loaded.view;
  if (loaded.session) view.frozen = loaded.session->views[static_cast<std::size_t>(options.viewOfSession)].frozen;
  if (!options.frozen) return;
  const CameraFile chosen = cameraOf(options, *options.frozen, loaded.scene);
  view.frozen = OpeningView{chosen.camera, chosen.size.x > 0 ? chosen.size : view.size, view.pixelScale};
}

/// `onPath` runs as soon as PATH is known: options take effect in the order in which they are added.
void addVolume(CLI::App& command, VolumeOptions& options, const std::function<void()>& onPath) {
  command.option_defaults()->group("Volume");
  auto* path =
      addParsed(command, "PATH", "PATH", "DICOM folder or file, NIfTI, NRRD, MetaImage, raw with --raw, or a session",
                [&options, onPath](const std::string& text) {
                  options.path = text;
                  if (io::isSession(options.path)) onPath();
                  return !text.empty();
                });
  std::string names;
  for (const std::string& name : io::phantomNames()) names += (names.empty() ? "" : "|") + name;
  auto* phantom =
      addParsed(command, "--phantom", names, "a built-in phantom instead of PATH", [&options](const std::string& text) {
        const std::vector<std::string> known = io::phantomNames();
        options.phantom = text;
        return std::find(known.begin(), known.end(), text) != known.end();
      });
  path->type_name("")->excludes(phantom);
  addParsed(command, "--phantom-voxels", "1..1024", "voxels along the phantom's longest side, default 256",
            [&options](const std::string& text) {
              options.phantomVoxels = parseNumber<int>(text).value_or(0);
              return options.phantomVoxels >= 1 && options.phantomVoxels <= 1024;
            })
      ->needs(phantom);
  command.add_option("--series", options.series, "the series' UID; the largest series otherwise")
      ->type_name("UID")
      ->excludes(phantom);
  addParsed(command, "--time", "N", "time point, from 1, where PATH holds several volumes of one place",
            [&options](const std::string& text) {
              options.time = parseNumber<int>(text);
              return options.time && *options.time >= 1;
            })
      ->excludes(phantom);
  command
      .add_flag("--allow-outside", options.allowOutside,
                "let a header name voxel files outside its folder; only for headers that you trust")
      ->excludes(phantom);
  auto* raw = command
                  .add_option_function<std::string>(
                      "--raw",
                      [&options](const std::string& text) {
                        try {
                          options.raw = io::parseRawDescription(text);
                        } catch (const io::Error& error) {
                          throw CLI::ValidationError("--raw", error.cause() + "; " + error.hint());
                        }
                      },
                      "how to read PATH's bytes, e.g. 256x256x128:uint16:be:skip=512")
                  ->type_name("WxHxD:TYPE[:le|be][:skip=BYTES]")
                  ->excludes(phantom);
  addChoice<io::Regularise>(command, "--regularise",
                            "resample slices that lie unevenly or askew onto even planes, default auto: linearly where "
                            "slices would be misplaced otherwise",
                            options.regularise)
      ->excludes(phantom);
  addChoice<Modality>(command, "--modality",
                      "what a volume is whose file does not say, default CT where its values are Hounsfield units",
                      options.modality)
      ->excludes(phantom);
  command
      .add_option_function<std::string>(
          "--data",
          [&options](const std::string& text) {
            if (!io::isSession(options.path)) throw CLI::ValidationError("--data", "needs a session as PATH");
            options.data = text;
          },
          "where the volume of a session is now, when it has moved or changed")
      ->type_name("PATH")
      ->excludes(phantom);
  // --raw has been parsed by now.
  addParsed(command, "--spacing", "X,Y,Z", "mm between the voxels of --raw", [&options](const std::string& text) {
    const auto spacing = parseNumbers<double, 3>(text, ',');
    if (!spacing || !std::all_of(spacing->begin(), spacing->end(), [](double mm) { return mm > 0.0; })) return false;
    if (options.raw) options.raw->spacing = {(*spacing)[0], (*spacing)[1], (*spacing)[2]};
    return true;
  })->needs(raw);
  command.option_defaults()->group("Options");
}

/// Labels, and those of them that matter. Returns the option of the latter.
CLI::Option* addLabelChoice(CLI::App& command, SceneOptions& options) {
  auto* phantom = command.get_option("--phantom");
  auto* labels = addParsed(command, "--labels", "FILE",
                           "label map, DICOM SEG or RTSTRUCT, resampled to the volume where its grid differs",
                           [&options](const std::string& text) {
                             options.labels = text;
                             return !text.empty();
                           })
                     ->excludes(phantom);
  auto* focusLabels = addParsed(command, "--focus-labels", "LABEL,...", "labels to open the view to, by value or name",
                                [&options](const std::string& text) {
                                  options.focusLabels = io::split(text, ',');
                                  return std::none_of(options.focusLabels.begin(), options.focusLabels.end(),
                                                      [](const std::string& label) { return label.empty(); });
                                });
  // Only after the whole line is parsed is it known whether there are labels for --focus-labels.
  command.parse_complete_callback([=, &options] {
    if (focusLabels->count() && !labels->count() && !phantom->count() && !io::isSession(options.path))
      throw CLI::RequiresError("--focus-labels", "--labels, --phantom or a session");
  });
  return focusLabels;
}

/// Labels and the values or labels to open the view to.
void addFocus(CLI::App& command, SceneOptions& options) {
  auto* focusLabels = addLabelChoice(command, options);
  addLabelSettings(command, options.labelChanges);
  addParsed(command, "--focus-range", "LOW:HIGH", "values to open the view to, e.g. 300:3000",
            [&options](const std::string& text) {
              const auto range = parseNumbers<double, 2>(text, ':');
              if (!range || (*range)[0] > (*range)[1]) return false;
              options.focusRange = ValueRange{(*range)[0], (*range)[1]};
              return true;
            })
      ->excludes(focusLabels);
  CLI::Option* seed = addSeedOptions(command, options.region);
  CLI::Option* select = addSelectOption(command, options.region);
  for (const char* other : {"--focus-labels", "--focus-range"})
    for (CLI::Option* region : {seed, select}) region->excludes(command.get_option(other));
  command.option_defaults()->group("Focus");
  addSetting(command, settingOf(&ValueFocus::minimumComponent), options.focusMinimumSize);
  addFocusTransfer(command, options.labelChanges);
}

/// Camera, picture size, and which view of a session they come from.
void addView(CLI::App& command, SceneOptions& options) {
  addParsed(
      command, "--camera", "A|P|L|R|S|I|AZIMUTH,ELEVATION|FILE.json|best|dual",
      "side to look from, angles in degrees (0,0 faces the patient, 90,0 is the patient's left), a camera file, or the "
      "best view of the focus or its complement, as place finds them",
      [&options](const std::string& text) {
        options.camera = parseCamera(text);
        return options.camera.has_value();
      });
  addParsed(command, "--freeze", "A|P|L|R|S|I|AZIMUTH,ELEVATION|FILE.json",
            "cut the opening for this camera instead, so that --camera looks into it from another side",
            [&options](const std::string& text) {
              options.frozen = parseCamera(text);
              return options.frozen && !std::holds_alternative<PlacedView>(*options.frozen);
            });
  addChoice<Projection>(command, "--projection", "default perspective", options.projection);
  addChoice<int>(command, "--view", "of a session: whose camera, size and strokes, default C1", {{"C1", 0}, {"C2", 1}},
                 options.viewOfSession);
  addParsed(command, "--size", "WxH", "picture in pixels, up to 16384 a side", [&options](const std::string& text) {
    const auto size = parseNumbers<int, 2>(text, 'x');
    if (!size || std::any_of(size->begin(), size->end(), [](int n) { return n < 1 || n > largestPicture; }))
      return false;
    options.size = glm::ivec2((*size)[0], (*size)[1]);
    return true;
  });
}

/// How the volume is looked at.
void addLook(CLI::App& command, SceneOptions& options) {
  Look& look = options.look;
  std::string presets;
  for (const io::TransferFunctionPreset& preset : io::transferFunctionPresets())
    presets += (presets.empty() ? "" : "|") + preset.id;
  command.add_option("--transfer-function", options.transferFunction, "optical properties of everything but the focus")
      ->type_name(presets + "|FILE.json");
  // Options apply in the order in which they are added: --look first, so that a width given beside it overrides it.
  std::string looks;
  for (const OpeningLook& each : openingLooks()) looks += (looks.empty() ? "" : "|") + std::string(each.id);
  addParsed(
      command, "--look", looks + "|FILE.json",
      "context layer and border ready made, default full; or a preset that was saved, with its transfer function, "
      "light and all",
      [&](const std::string& text) {
        if (fs::path(text).extension() == ".json") {
          options.preset = io::readLook(text);
          look = restyled(look, options.preset->look);
          return true;
        }
        const auto all = openingLooks();
        const auto chosen =
            std::find_if(all.begin(), all.end(), [&](const OpeningLook& each) { return each.id == text; });
        if (chosen == all.end()) return false;
        chosen->applyTo(look.cutaway, look.contextLayer);
        return true;
      });
  addLightPreset(command, look.shading);
  addSettings(command, look.method);
  addSettings(command, look.cutaway);
  addSettings(command, look.contextLayer);
  addSettings(command, look.shading);
  addPair(command, "--light", "AZIMUTH,ELEVATION", settingOf(&Shading::lightAzimuth),
          settingOf(&Shading::lightElevation), look.shading);
  addSettings(command, look);
  addParsed(command, "--strokes", "FILE.json", "brush strokes to apply, in place of a session's",
            [&options](const std::string& text) {
              options.strokes = text;
              return !text.empty();
            });
}

/// How the integral along rays is found.
void addSampling(CLI::App& command, SceneOptions& options) {
  addChoice<Quality>(command, "--quality", "default normal", options.quality)->each([&options](const std::string&) {
    options.maxError.reset();  // of a session
  });
  addParsed(command, "--max-error", "E",
            "greatest error of a colour that sampling may leave, in 1/255, from " + textOf(maxErrors.low) + " up",
            [&options](const std::string& text) {
              const auto error = parseNumbers<double, 1>(text, ',');
              if (!error || !maxErrors.contains((*error)[0])) return false;
              options.maxError = (*error)[0];
              return true;
            });
}

}  // namespace

std::string VolumeOptions::source() const { return phantom.empty() ? path.string() : "phantom " + phantom; }

void addVolumeOptions(CLI::App& command, VolumeOptions& options) {
  addVolume(command, options, [] {});
}

void addSceneOptions(CLI::App& command, SceneOptions& options, std::function<void(const io::Session&)> onSession) {
  addVolume(command, options, [&options, onSession = std::move(onSession)] {
    const io::Session session = io::readSession(options.path);
    useAsDefaults(session, options);
    if (onSession) onSession(session);
  });
  command.option_defaults()->group("Focus");
  addFocus(command, options);
  command.option_defaults()->group("Picture");
  addView(command, options);
  addLook(command, options);
  addClipping(command, options.clipChanges, options.look.clipping);
  addRemovals(command, options.look.removals);
  addSampling(command, options);
  command.option_defaults()->group("Options");
}

void addLabelOptions(CLI::App& command, SceneOptions& options) {
  addVolume(command, options, [] {});
  command.option_defaults()->group("Labels");
  addLabelChoice(command, options);
  command.option_defaults()->group("Options");
}

OpenedData openData(const VolumeOptions& options, const io::Progress& progress) {
  return openData(options, {}, progress);
}

OpenedData openData(const VolumeOptions& options, const fs::path& labels, const io::Progress& progress) {
  OpenedData data;
  if (!options.phantom.empty()) {
    io::OpenedPhantom phantom = io::openPhantom(options.phantom, options.phantomVoxels, progress);
    data.volume = std::move(phantom.volume);
    data.labels = std::move(phantom.labels);
  } else if (io::isSession(options.path)) {
    if (!options.series.empty() || options.raw || options.time || options.modality)
      throw io::Error(options.path, "records how its volume is read",
                      "leave out --series, --time, --raw and --modality");
    io::OpenedSession opened =
        io::openSession(options.path, {options.data, labels, options.allowOutside, options.regularise}, progress);
    data.volume = std::move(opened.volume);
    data.volume.warnings = std::move(opened.warnings);
    data.labels = std::move(opened.labels);
    data.session = std::move(opened.session);
  } else {
    const double volumeShare = labels.empty() ? 1.0 : 0.8;
    data.volume = io::openVolume(options.path, {.series = options.series,
                                                .time = options.time,
                                                .raw = options.raw,
                                                .allowOutside = options.allowOutside,
                                                .regularise = options.regularise.value_or(io::Regularise::Automatic),
                                                .modality = options.modality,
                                                .progress = part(progress, 0.0, volumeShare)});
    if (!labels.empty()) {
      io::OpenedLabels opened =
          io::openLabels(labels, data.volume.volume->grid, part(progress, volumeShare, 1.0), options.allowOutside);
      data.labels = std::move(opened.labels);
      std::move(opened.warnings.begin(), opened.warnings.end(), std::back_inserter(data.volume.warnings));
    }
  }
  return data;
}

Focus expectedFocus(const SceneOptions& options) {
  if (options.focusRange) return ValueFocus();
  const bool labelled = !options.focusLabels.empty() || !options.region.empty() || !options.phantom.empty();
  return labelled ? Focus(LabelFocus()) : Focus();
}

LoadedScene loadScene(const SceneOptions& options, const io::Progress& progress) {
  LoadedScene loaded;
  OpenedData data = openData(options, options.labels, progress);
  loaded.volume = std::move(data.volume);
  loaded.warnings = std::move(loaded.volume.warnings);
  loaded.volume.warnings.clear();
  loaded.session = std::move(data.session);
  Scene& scene = loaded.asSet;
  scene.volume = loaded.volume.volume;
  scene.labels = std::move(data.labels);
  scene.look = options.look;
  const bool hasFunction = loaded.session || options.preset;
  if (options.preset && options.transferFunction.empty())
    if (const std::string odd = io::mismatchOf(*options.preset, scene.volume->unit); !odd.empty())
      loaded.warnings.push_back({io::Warning::Kind::Other, odd, {}});
  if (!hasFunction || !options.transferFunction.empty())
    scene.look.context = io::loadContextFunction(
        options.transferFunction.empty() ? io::defaultPreset(*scene.volume) : options.transferFunction, *scene.volume);
  if (scene.look.hideTable) {
    scene.table = segmentation::tableOf(*scene.volume);
    if (scene.table->count > 0) loaded.warnings.push_back({io::Warning::Kind::Other, segmentation::tableNotice, {}});
  }
  setFocus(options, loaded);
  setLabelSettings(options, scene);
  if (options.preset) io::setLabelFunctions(scene, *options.preset);
  setFocusFunctions(options, scene);
  setClipping(options, scene);
  if (!options.strokes.empty()) scene.look.strokes = io::readStrokes(options.strokes);
  growFocus(options, loaded, progress);
  setView(options, loaded);
  freezeView(options, loaded);
  loaded.view.slices = slicesOf(options, *scene.volume);
  return loaded;
}

}  // namespace fenestra::app
