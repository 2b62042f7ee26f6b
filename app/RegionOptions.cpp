#include "app/RegionOptions.h"

#include <optional>
#include <string>
#include <vector>

#include "app/OptionHelpers.h"

namespace fenestra::app {
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
              const auto numbers = parseNumbers<double, 3>(text, ',');
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

/// A stroke of one ball: ball:L,P,S:R or -ball:L,P,S:R, with :SOFTNESS behind it.
std::optional<SelectionStroke> parseBall(const std::string& text) {
  const std::vector<std::string> parts = io::split(text, ':');
  if (parts.size() < 3 || parts.size() > 4 || (parts[0] != "ball" && parts[0] != "-ball")) return std::nullopt;
  const auto centre = parseNumbers<double, 3>(parts[1], ',');
  const auto radius = parseNumber<double>(parts[2]);
  const auto softness = parts.size() == 4 ? parseNumber<double>(parts[3]) : 0.0;
  if (!centre || !radius || !(*radius > 0.0) || !softness || !(*softness >= 0.0 && *softness <= 1.0))
    return std::nullopt;
  return SelectionStroke{{{(*centre)[0], (*centre)[1], (*centre)[2]}}, *radius, *softness, parts[0] == "ball"};
}

}  // namespace

CLI::Option* addSeedOptions(CLI::App& command, RegionFocus& region) {
  command.option_defaults()->group("Region growing");
  CLI::Option* seed =
      addPositions(command, "--seed", "a point in the structure, mm; may be given several times", region.inside);
  addPositions(command, "--outside", "a point that the region must not reach, mm; may be given several times",
               region.outside)
      ->needs(seed);
  addParsed(command, "--tolerance", "T",
            "how far values may lie below the seed's, in the volume's unit; chosen from the plateaus otherwise",
            [&region](const std::string& text) {
              region.tolerance = parseNumber<double>(text);
              return region.tolerance && *region.tolerance >= 0.0;
            })
      ->needs(seed);
  command.option_defaults()->group("Options");
  return seed;
}

CLI::Option* addSelectOption(CLI::App& command, RegionFocus& region) {
  const std::string form = "[-]ball:L,P,S:R[:SOFTNESS]";
  return command
      .add_option_function<std::vector<std::string>>(
          "--select",
          [=, &region](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              const auto ball = parseBall(text);
              if (!ball) throw CLI::ValidationError("--select", "\"" + text + "\" is not " + form);
              region.painted.push_back(*ball);
            }
          },
          "a ball to open the view to, of R mm around a point in mm, or with -ball to take from what is selected; in "
          "the outer share SOFTNESS, 0 to 1, only where values are like those inside; may be given several times")
      ->group("Region growing")
      ->type_name(form)
      ->expected(1)
      ->take_all()
      ->allow_extra_args(false);
}

}  // namespace fenestra::app
