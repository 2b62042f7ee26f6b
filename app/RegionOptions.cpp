#include "app/RegionOptions.h"

#include <optional>
#include <string>
#include <vector>

#include "app/options/Numbers.h"
#include "app/options/WordOptions.h"
#include "rendering/settings/SettingWords.h"

namespace fenestra::app {
namespace {

/// An option that may be given several times, one world position each.
Option addPositions(Command command, const std::string& name, const std::string& description,
                    std::vector<glm::dvec3>& positions) {
  const std::string form = "L,P,S";
  return command
      .addRepeated(name, form, description,
                   [form, &positions](const std::vector<std::string>& texts) {
                     for (const std::string& text : texts) {
                       const std::optional<glm::dvec3> position = parseVector(text);
                       if (!position) throw WrongValue{"\"" + text + "\" is not " + form};
                       positions.push_back(*position);
                     }
                   })
      .oneEach();
}

/// A stroke of one ball: ball:L,P,S:R or -ball:L,P,S:R, with :SOFTNESS behind it.
std::optional<SelectionStroke> parseBall(const std::string& text) {
  const std::vector<std::string> parts = io::split(text, ':');
  if (parts.size() < 3 || parts.size() > 4 || (parts[0] != "ball" && parts[0] != "-ball")) return std::nullopt;
  const std::optional<glm::dvec3> centre = parseVector(parts[1]);
  const auto radius = parseNumber<double>(parts[2]);
  const auto softness = parts.size() == 4 ? parseNumber<double>(parts[3]) : 0.0;
  if (!centre || !radius || !(*radius > 0.0) || !softness || !(*softness >= 0.0 && *softness <= 1.0))
    return std::nullopt;
  return SelectionStroke{{*centre}, *radius, *softness, parts[0] == "ball"};
}

}  // namespace

Option addSeedOptions(Command command, RegionFocus& region) {
  command.group("Region growing");
  const Option seed =
      addPositions(command, "--seed", "a point in the structure, mm; may be given several times", region.inside);
  addPositions(command, "--outside", "a point that the region must not reach, mm; may be given several times",
               region.outside)
      .needs(seed);
  command
      .add("--tolerance", "T",
           "how far values may lie below the seed's, in the volume's unit; chosen from the plateaus otherwise",
           [&region](const std::string& text) {
             region.tolerance = parseNumber<double>(text);
             return region.tolerance && *region.tolerance >= 0.0;
           })
      .needs(seed);
  region.rule = RegionRule::Tissues;
  addWords<RegionRule>(command, "--by",
                       "which voxels join: those of the clicked tissue, or those whose own values lie near the seed's; "
                       "default tissues",
                       region.rule)
      .needs(seed);
  command
      .add("--ball", "R", "no voxel farther than R mm from the first --seed grows",
           [&region](const std::string& text) {
             const auto radius = parseNumber<double>(text);
             if (radius) region.ball = *radius;
             return radius && *radius > 0.0;
           })
      .needs(seed);
  command.group("Options");
  return seed;
}

std::string wordOfRule(RegionRule rule) { return wordOf(rule).word; }

Option addSelectOption(Command command, RegionFocus& region) {
  const std::string form = "[-]ball:L,P,S:R[:SOFTNESS]";
  command.group("Region growing");
  const Option select =
      command
          .addRepeated(
              "--select", form,
              "a ball to open the view to, of R mm around a point in mm, or with -ball to take from what is selected; "
              "in the outer share SOFTNESS, 0 to 1, only where values are like those inside; may be given several "
              "times",
              [form, &region](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                  const auto ball = parseBall(text);
                  if (!ball) throw WrongValue{"\"" + text + "\" is not " + form};
                  region.painted.push_back(*ball);
                }
              })
          .oneEach();
  command.group("Options");
  return select;
}

}  // namespace fenestra::app
