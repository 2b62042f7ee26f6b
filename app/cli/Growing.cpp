#include "app/cli/Growing.h"

#include <algorithm>
#include <sstream>

#include "app/OptionHelpers.h"
#include "app/cli/Report.h"
#include "io/base/Error.h"

namespace fenestra::cli {
namespace {

/// An option that may be given several times, one world position each.
CLI::Option* addPositions(CLI::App& command, const std::string& name, const std::string& description,
                          std::vector<glm::dvec3>& positions) {
  const std::string form = "L,P,S";
  return command
      .add_option_function<std::vector<std::string>>(
          name,
          [=, &positions](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              const auto numbers = app::parseNumbers<double, 3>(text, ',');
              if (!numbers) throw CLI::ValidationError(name, "\"" + text + "\" is not " + form);
              positions.emplace_back((*numbers)[0], (*numbers)[1], (*numbers)[2]);
            }
          },
          description)
      ->type_name(form)
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

std::string textOf(glm::dvec3 position) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << position.x << ',' << position.y << ',' << position.z;
  return text.str();
}

void checkSeeds(const Grid& grid, const std::vector<glm::dvec3>& seeds, const std::string& option,
                const std::string& source) {
  for (const glm::dvec3 seed : seeds) {
    if (segmentation::voxelAt(grid, seed)) continue;
    throw io::Error(source, "does not reach to " + option + " " + textOf(seed),
                    "the volume's centre is " + textOf(grid.centre()) + " (mm, LPS)");
  }
}

}  // namespace

CLI::Option* addSeedOptions(CLI::App& command, segmentation::GrowSettings& settings) {
  command.option_defaults()->group("Region growing");
  CLI::Option* seed =
      addPositions(command, "--seed", "a point in the structure, mm; may be given several times", settings.inside);
  addPositions(command, "--outside", "a point that the region must not reach, mm; may be given several times",
               settings.outside)
      ->needs(seed);
  app::addParsed(command, "--tolerance", "T",
                 "how far values may lie below the seed's, in the volume's unit; chosen from the plateaus otherwise",
                 [&settings](const std::string& text) {
                   settings.tolerance = app::parseNumber<double>(text);
                   return settings.tolerance && *settings.tolerance >= 0.0;
                 })
      ->needs(seed);
  command.option_defaults()->group("Options");
  return seed;
}

GrownRegion growFromSeeds(const Volume& volume, const segmentation::GrowSettings& settings, const std::string& source) {
  checkSeeds(volume.grid, settings.inside, "--seed", source);
  checkSeeds(volume.grid, settings.outside, "--outside", source);
  const io::Progress shown = progressOnTerminal();
  segmentation::Progress progress;
  if (shown) progress = [&](double fraction) { return shown(fraction, "growing the region"); };
  std::optional<segmentation::Growth> growth =
      segmentation::growRegion(volume, settings, segmentation::wholeOf(volume.grid.dims), progress);
  if (!growth) throw io::Cancelled();
  GrownRegion region;
  region.growth = std::move(*growth);
  region.step = region.growth.stepOf(settings);
  region.mask = segmentation::maskAt(region.growth, region.step);
  if (segmentation::volumeOf(region.mask) == 0.0)
    throw io::Error(source, "has no region of this tolerance around the seed",
                    settings.tolerance ? "raise --tolerance" : "choose another --seed, or remove an --outside");
  return region;
}

}  // namespace fenestra::cli
