#include "app/SceneOptions.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/ClipOptions.h"
#include "app/DataOptions.h"
#include "app/LabelOptions.h"
#include "app/LookOptions.h"
#include "app/RegionOptions.h"
#include "app/RemovalOptions.h"
#include "app/options/Numbers.h"
#include "app/options/WordOptions.h"
#include "io/session/SessionFile.h"
#include "rendering/settings/SettingWords.h"

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

/// Labels and the values or labels to open the view to.
void addFocus(Command command, io::StudyRequest& request) {
  const Option focusLabels = addLabelChoice(command, request, request.focusLabels);
  addLabelSettings(command, request.labelChanges);
  const Option focusRange = command
                                .add("--focus-range", "LOW:HIGH", "values to open the view to, e.g. 300:3000",
                                     [&request](const std::string& text) {
                                       const auto range = parseNumbers<double, 2>(text, ':');
                                       if (!range || (*range)[0] > (*range)[1]) return false;
                                       request.focusRange = ValueRange{(*range)[0], (*range)[1]};
                                       return true;
                                     })
                                .excludes(focusLabels);
  const Option seed = addSeedOptions(command, request.region);
  const Option select = addSelectOption(command, request.region);
  for (const Option& other : {focusLabels, focusRange})
    for (const Option& region : {seed, select}) region.excludes(other);
  command.group("Focus");
  addMinimumSize(command, request.focusMinimumSize);
  addFocusTransfer(command, request.labelChanges);
}

/// Camera, picture size, and which view of a session they come from.
void addView(Command command, io::StudyRequest& request) {
  command.add(
      "--camera", "A|P|L|R|S|I|AZIMUTH,ELEVATION|FILE.json|best|dual",
      "side to look from, angles in degrees (0,0 faces the patient, 90,0 is the patient's left), a camera file, or the "
      "best view of the focus or its complement, as place finds them; default A, of a thin stack the side that shows "
      "its "
      "slices",
      [&request](const std::string& text) {
        request.camera = parseCamera(text);
        return request.camera.has_value();
      });
  command.add("--freeze", "A|P|L|R|S|I|AZIMUTH,ELEVATION|FILE.json",
              "cut the opening for this camera instead, so that --camera looks into it from another side",
              [&request](const std::string& text) {
                request.frozen = parseCamera(text);
                return request.frozen && !std::holds_alternative<io::PlacedView>(*request.frozen);
              });
  addWords<Projection>(command, "--projection", "default perspective", request.projection);
  addChoice<int>(command, "--view", "of a session: whose camera, size and strokes, default C1", {{"C1", 0}, {"C2", 1}},
                 request.viewIndex);
  command.add("--size", "WxH", "picture in pixels, up to 16384 a side", [&request](const std::string& text) {
    request.size = parseSize(text, largestPicture);
    return request.size.has_value();
  });
}

}  // namespace

void addSceneOptions(Command command, io::StudyRequest& request, std::function<void(const io::Session&)> onSession) {
  addVolumeOptions(command, request, [&request, onSession = std::move(onSession)] {
    request.startFrom(io::readSession(request.path));
    if (onSession) onSession(*request.session);
  });
  command.group("Focus");
  addFocus(command, request);
  command.group("Picture");
  addView(command, request);
  addLookOptions(command, request);
  addClipping(command, request.clipChanges, request.look.clipping);
  addRemovals(command, request.look.removals);
  addSamplingOptions(command, request);
  command.group("Options");
}

void addFocusOptions(Command command, io::StudyRequest& request, std::optional<double>* pixel) {
  addVolumeOptions(
      command, request, [&request] { request.startFrom(io::readSession(request.path)); }, pixel);
  command.group("Focus");
  addFocus(command, request);
  command.group("Options");
}

}  // namespace fenestra::app
