#include "app/cli/ReformatOptions.h"

#include "app/SceneOptions.h"
#include "app/cli/Commands.h"
#include "app/options/Numbers.h"

namespace fenestra::cli {

void addReformatOptions(app::Command command, ReformatOptions& options) {
  app::addFocusOptions(command, options.study, &options.spacing);
  command
      .addValue("--path", options.path,
                "the path to follow: {\"points\": [[l,p,s],...]}, mm; otherwise the centre line of the focus")
      .as("FILE.json");
  app::addNumber(command, "--width", 0.01, 10'000.0, "MM", "of the picture across the path, default 50", options.width);
  app::addNumber(command, "--angle", -360.0, 360.0, "DEGREES",
                 "about the path; 0 begins across the patient's left, and turns no more than the path does",
                 options.angle);
  command.add("--section", "MM", "instead: the section across the path, so far from its beginning",
              [&options](const std::string& text) {
                options.section = app::parseNumber<double>(text);
                return options.section.has_value();
              });
  command.addValue("--window", options.windowWidth, "width of the display window; the file's own otherwise").positive();
  command.addValue("--level", options.level, "centre of the display window");
  command
      .addValue("-o,--output", options.output,
                "PNG to write, or .mha: real values as float32, NaN outside the volume; the path's beginning on top")
      .required()
      .as("FILE");
}

}  // namespace fenestra::cli
