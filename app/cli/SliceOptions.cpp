#include "app/cli/SliceOptions.h"

#include <optional>
#include <string>
#include <vector>

#include "app/SceneOptions.h"
#include "app/cli/Commands.h"
#include "app/options/Numbers.h"
#include "io/base/Text.h"
#include "io/base/Words.h"

namespace fenestra::cli {
namespace {

constexpr int largestSlice = 16384;  ///< pixels a side

/// MM:max|min|mean
Slab slabIn(const std::string& text) {
  const std::vector<std::string> parts = io::split(text, ':');
  const std::optional<double> mm = parts.size() == 2 ? app::parseNumber<double>(parts[0]) : std::nullopt;
  if (!mm) throw app::WrongValue{"\"" + text + "\" is not of the form MM:max|min|mean, for example 10:max"};
  if (*mm < 0.0) throw app::WrongValue{"a slab of " + parts[0] + " mm: its thickness must be 0 or more"};
  for (const Word<SlabMode>& word : wordsOf(SlabMode{}))
    if (parts[1] == word.word) return {*mm, word.value};
  throw app::WrongValue{"\"" + parts[1] + "\" is none of max, min and mean"};
}

/// The direction of the slice.
void addDirection(app::Command command, SliceOptions& options) {
  const app::Option plane = app::addChoice<SlicePlane>(
      command, "--plane", "default axial",
      {{"axial", SlicePlane::Axial}, {"sagittal", SlicePlane::Sagittal}, {"coronal", SlicePlane::Coronal}},
      options.plane);
  const app::Option normal =
      command
          .add("--normal", "X,Y,Z",
               "a slice in any direction: across this one (LPS), whose length and sign have no effect; seen as the "
               "nearest of the three planes is, whose upper side stays up",
               [&options](const std::string& text) {
                 const std::optional<glm::dvec3> direction = app::parseVector(text);
                 if (!direction) return false;
                 const double length = glm::length(*direction);
                 if (!(length > 0.0) || !std::isfinite(length))
                   throw app::WrongValue{"\"" + text + "\" is no direction: one of its numbers must differ from 0"};
                 options.normal = *direction / length;
                 return true;
               })
          .excludes(plane);
  const app::Option facing =
      app::addChoice<io::PlacedView>(command, "--facing",
                                     "the slice that faces this camera, with the camera's right and up: that of a "
                                     "session, or as place puts it for the focus",
                                     {{"C1", io::PlacedView::Best}, {"C2", io::PlacedView::Dual}}, options.facing)
          .excludes(plane)
          .excludes(normal);
  const app::Option through =
      command.add("--through", "L,P,S",
                  "a point of the slice, mm, the middle of a picture with --size; otherwise the volume's middle, with "
                  "--facing the focus's",
                  [&options](const std::string& text) {
                    options.through = app::parseVector(text);
                    return options.through.has_value();
                  });
  const app::Option at = command.addValue("--at", options.at, "mm along S (axial), L (sagittal) or P (coronal)");
  const app::Option index =
      command.addValue("--index", options.index, "slice number, growing the same way; the middle one otherwise");
  index.excludes(at);
  for (const app::Option& number : {at, index})
    for (const app::Option& other : {normal, facing, through}) number.excludes(other);
}

}  // namespace

void addSliceOptions(app::Command command, SliceOptions& options) {
  app::addFocusOptions(command, options.study, &options.spacing);
  addDirection(command, options);
  command.add("--slab", "MM:max|min|mean",
              "the greatest, least or mean value over a thickness instead, half of it to each side",
              [&options](const std::string& text) {
                options.slab = slabIn(text);
                return true;
              });
  command.add("--size", "WxH", "picture in pixels, 1 to 16384 a side; otherwise as large as the volume",
              [&options](const std::string& text) {
                options.study.size = app::parseSize(text, largestSlice);
                return options.study.size.has_value();
              });
  command.addValue("--window", options.width, "width of the display window; the file's own otherwise").positive();
  command.addValue("--level", options.level, "centre of the display window");
  command
      .addValue("-o,--output", options.output,
                "PNG to write, or .mha: real values as float32, in their place in the patient (LPS), NaN outside the "
                "volume")
      .required()
      .as("FILE");
}

}  // namespace fenestra::cli
