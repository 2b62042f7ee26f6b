#include "app/SceneOptions.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/ClipOptions.h"
#include "app/LabelOptions.h"
#include "app/LightOptions.h"
#include "app/RegionOptions.h"
#include "app/RemovalOptions.h"
#include "app/SettingOptions.h"
#include "io/PhantomFile.h"
#include "io/TransferFunctionFile.h"
#include "io/VolumeReader.h"
#include "io/base/SessionName.h"
#include "io/base/Words.h"
#include "io/session/SessionFile.h"
#include "rendering/scene/LookStyle.h"

namespace fenestra::app {
namespace {

namespace fs = std::filesystem;

constexpr int largestPicture = 16384;  ///< pixels a side, what OpenGL 4.5 drivers commonly offer

std::optional<io::CameraChoice> parseCamera(const std::string& text) {
  static const std::vector<std::pair<std::string, StandardView>> views{
      {"A", StandardView::Anterior}, {"P", StandardView::Posterior}, {"L", StandardView::Left},
      {"R", StandardView::Right},    {"S", StandardView::Superior},  {"I", StandardView::Inferior}};
  for (const auto& [letter, view] : views)
    if (text == letter) return view;
  if (text == "best") return io::PlacedView::Best;
  if (text == "dual") return io::PlacedView::Dual;
  if (const auto angles = parseNumbers<double, 2>(text, ',')) return io::ViewAngles{(*angles)[0], (*angles)[1]};
  if (fs::path(text).extension() == ".json") return fs::path(text);
  return std::nullopt;
}

/// `onPath` runs as soon as PATH is known: options take effect in the order in which they are added.
void addVolume(CLI::App& command, io::DataRequest& request, const std::function<void()>& onPath) {
  command.option_defaults()->group("Volume");
  auto* path =
      addParsed(command, "PATH", "PATH", "DICOM folder or file, NIfTI, NRRD, MetaImage, raw with --raw, or a session",
                [&request, onPath](const std::string& text) {
                  request.path = text;
                  if (io::isSession(request.path)) onPath();
                  return !text.empty();
                });
  std::string names;
  for (const std::string& name : io::phantomNames()) names += (names.empty() ? "" : "|") + name;
  auto* phantom =
      addParsed(command, "--phantom", names, "a built-in phantom instead of PATH", [&request](const std::string& text) {
        const std::vector<std::string> known = io::phantomNames();
        request.phantom = text;
        return std::find(known.begin(), known.end(), text) != known.end();
      });
  path->type_name("")->excludes(phantom);
  addParsed(command, "--phantom-voxels", "1..1024", "voxels along the phantom's longest side, default 256",
            [&request](const std::string& text) {
              request.phantomVoxels = parseNumber<int>(text).value_or(0);
              return request.phantomVoxels >= 1 && request.phantomVoxels <= 1024;
            })
      ->needs(phantom);
  command.add_option("--series", request.series, "the series' UID; the largest series otherwise")
      ->type_name("UID")
      ->excludes(phantom);
  addParsed(command, "--time", "N", "time point, from 1, where PATH holds several volumes of one place",
            [&request](const std::string& text) {
              request.time = parseNumber<int>(text);
              return request.time && *request.time >= 1;
            })
      ->excludes(phantom);
  command
      .add_flag("--allow-outside", request.allowOutside,
                "let a header name voxel files outside its folder; only for headers that you trust")
      ->excludes(phantom);
  auto* raw = command
                  .add_option_function<std::string>(
                      "--raw",
                      [&request](const std::string& text) {
                        try {
                          request.raw = io::parseRawDescription(text);
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
                            request.regularise)
      ->excludes(phantom);
  addChoice<Modality>(command, "--modality",
                      "what a volume is whose file does not say, default CT where its values are Hounsfield units",
                      request.modality)
      ->excludes(phantom);
  command
      .add_option_function<std::string>(
          "--data",
          [&request](const std::string& text) {
            if (!io::isSession(request.path)) throw CLI::ValidationError("--data", "needs a session as PATH");
            request.data = text;
          },
          "where the volume of a session is now, when it has moved or changed")
      ->type_name("PATH")
      ->excludes(phantom);
  // --raw has been parsed by now.
  addParsed(command, "--spacing", "X,Y,Z", "mm between the voxels of --raw", [&request](const std::string& text) {
    const auto spacing = parseNumbers<double, 3>(text, ',');
    if (!spacing || !std::all_of(spacing->begin(), spacing->end(), [](double mm) { return mm > 0.0; })) return false;
    if (request.raw) request.raw->spacing = {(*spacing)[0], (*spacing)[1], (*spacing)[2]};
    return true;
  })->needs(raw);
  command.option_defaults()->group("Options");
}

/// Labels, and those of them that matter. Returns the option of the latter.
CLI::Option* addLabelChoice(CLI::App& command, io::DataRequest& request, std::vector<std::string>& chosen) {
  auto* phantom = command.get_option("--phantom");
  auto* labels = addParsed(command, "--labels", "FILE",
                           "label map, DICOM SEG or RTSTRUCT, resampled to the volume where its grid differs",
                           [&request](const std::string& text) {
                             request.labels = text;
                             return !text.empty();
                           })
                     ->excludes(phantom);
  auto* focusLabels = addParsed(command, "--focus-labels", "LABEL,...", "labels to open the view to, by value or name",
                                [&chosen](const std::string& text) {
                                  chosen = io::split(text, ',');
                                  return std::find(chosen.begin(), chosen.end(), "") == chosen.end();
                                });
  // Only after the whole line is parsed is it known whether there are labels for --focus-labels.
  command.parse_complete_callback([=, &request] {
    if (focusLabels->count() && !labels->count() && !phantom->count() && !io::isSession(request.path))
      throw CLI::RequiresError("--focus-labels", "--labels, --phantom or a session");
  });
  return focusLabels;
}

/// Labels and the values or labels to open the view to.
void addFocus(CLI::App& command, io::StudyRequest& request) {
  auto* focusLabels = addLabelChoice(command, request, request.focusLabels);
  addLabelSettings(command, request.labelChanges);
  addParsed(command, "--focus-range", "LOW:HIGH", "values to open the view to, e.g. 300:3000",
            [&request](const std::string& text) {
              const auto range = parseNumbers<double, 2>(text, ':');
              if (!range || (*range)[0] > (*range)[1]) return false;
              request.focusRange = ValueRange{(*range)[0], (*range)[1]};
              return true;
            })
      ->excludes(focusLabels);
  CLI::Option* seed = addSeedOptions(command, request.region);
  CLI::Option* select = addSelectOption(command, request.region);
  for (const char* other : {"--focus-labels", "--focus-range"})
    for (CLI::Option* region : {seed, select}) region->excludes(command.get_option(other));
  command.option_defaults()->group("Focus");
  addSetting(command, settingOf(&ValueFocus::minimumComponent), request.focusMinimumSize);
  addFocusTransfer(command, request.labelChanges);
}

/// Camera, picture size, and which view of a session they come from.
void addView(CLI::App& command, io::StudyRequest& request) {
  addParsed(
      command, "--camera", "A|P|L|R|S|I|AZIMUTH,ELEVATION|FILE.json|best|dual",
      "side to look from, angles in degrees (0,0 faces the patient, 90,0 is the patient's left), a camera file, or the "
      "best view of the focus or its complement, as place finds them",
      [&request](const std::string& text) {
        request.camera = parseCamera(text);
        return request.camera.has_value();
      });
  addParsed(command, "--freeze", "A|P|L|R|S|I|AZIMUTH,ELEVATION|FILE.json",
            "cut the opening for this camera instead, so that --camera looks into it from another side",
            [&request](const std::string& text) {
              request.frozen = parseCamera(text);
              return request.frozen && !std::holds_alternative<io::PlacedView>(*request.frozen);
            });
  addChoice<Projection>(command, "--projection", "default perspective", request.projection);
  addChoice<int>(command, "--view", "of a session: whose camera, size and strokes, default C1", {{"C1", 0}, {"C2", 1}},
                 request.viewIndex);
  addParsed(command, "--size", "WxH", "picture in pixels, up to 16384 a side", [&request](const std::string& text) {
    const auto size = parseNumbers<int, 2>(text, 'x');
    if (!size || std::any_of(size->begin(), size->end(), [](int n) { return n < 1 || n > largestPicture; }))
      return false;
    request.size = glm::ivec2((*size)[0], (*size)[1]);
    return true;
  });
}

/// How the volume is looked at.
void addLook(CLI::App& command, io::StudyRequest& request) {
  Look& look = request.look;
  std::string presets;
  for (const io::TransferFunctionPreset& preset : io::transferFunctionPresets())
    presets += (presets.empty() ? "" : "|") + preset.id;
  command.add_option("--transfer-function", request.transferFunction, "optical properties of everything but the focus")
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
          request.preset = io::readLook(text);
          look = restyled(look, request.preset->look);
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
            [&request](const std::string& text) {
              request.strokes = text;
              return !text.empty();
            });
}

/// How the integral along rays is found.
void addSampling(CLI::App& command, io::StudyRequest& request) {
  addChoice<Quality>(command, "--quality", "default normal", request.quality)->each([&request](const std::string&) {
    request.maxError.reset();  // of a session
  });
  addParsed(command, "--max-error", "E",
            "greatest error of a colour that sampling may leave, in 1/255, from " + textOf(maxErrors.low) + " up",
            [&request](const std::string& text) {
              const auto error = parseNumbers<double, 1>(text, ',');
              if (!error || !maxErrors.contains((*error)[0])) return false;
              request.maxError = (*error)[0];
              return true;
            });
}

}  // namespace

void addVolumeOptions(CLI::App& command, io::DataRequest& request) {
  addVolume(command, request, [] {});
}

void addSceneOptions(CLI::App& command, io::StudyRequest& request, std::function<void(const io::Session&)> onSession) {
  addVolume(command, request, [&request, onSession = std::move(onSession)] {
    request.startFrom(io::readSession(request.path));
    if (onSession) onSession(*request.session);
  });
  command.option_defaults()->group("Focus");
  addFocus(command, request);
  command.option_defaults()->group("Picture");
  addView(command, request);
  addLook(command, request);
  addClipping(command, request.clipChanges, request.look.clipping);
  addRemovals(command, request.look.removals);
  addSampling(command, request);
  command.option_defaults()->group("Options");
}

void addLabelOptions(CLI::App& command, io::DataRequest& request, std::vector<std::string>& focusLabels) {
  addVolume(command, request, [] {});
  command.option_defaults()->group("Labels");
  addLabelChoice(command, request, focusLabels);
  command.option_defaults()->group("Options");
}

}  // namespace fenestra::app
