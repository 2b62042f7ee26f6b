#include "app/cli/PlacementOptions.h"

#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "app/ScheduleChoice.h"
#include "app/cli/Commands.h"
#include "app/options/Numbers.h"
#include "rendering/viewpoints/Sphere.h"

namespace fenestra::cli {
namespace {

/// The numbers of HEALPix directions nearest to `count`.
std::string nearestCounts(int count) {
  int nside = 1;
  while (12 * (nside + 1) * (nside + 1) <= count) ++nside;
  return std::to_string(12 * nside * nside) + " and " + std::to_string(12 * (nside + 1) * (nside + 1));
}

std::string text(double number) {
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

std::string joined(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& each : list) text += (text.empty() ? "" : ", ") + each;
  return text;
}

void addDescriptorOptions(app::Command command, PlaceOptions& options) {
  const app::Option descriptors =
      command
          .add("--descriptors", "[NAME,...]",
               "also what other view descriptors say of every direction: their values, the camera that each would "
               "choose, and rank correlations with the paper's three; names, default all: " +
                   joined(descriptorNames()),
               [&options](const std::string& names) {
                 if (!selectDescriptors(names, options.descriptors))
                   throw app::WrongValue{"\"" + names + "\" names no descriptors; there are " +
                                         joined(descriptorNames())};
                 return true;
               })
          .orElse(descriptorNames().front())
          .excludes(command.option("--refine"));
  command
      .addValue("--pictures", options.descriptors.pictures,
                "folder for a PNG from each of those cameras, 320x240 or as --size says")
      .as("FOLDER")
      .needs(descriptors);
}

/// Three numbers between commas that are 0 or more.
std::optional<glm::dvec3> weightsIn(const std::string& text) {
  const std::optional<glm::dvec3> weights = app::parseVector(text);
  return weights && glm::all(glm::greaterThanEqual(*weights, glm::dvec3(0.0))) ? weights : std::nullopt;
}

void addPickOptions(app::Command command, PlaceOptions& options) {
  const app::Option pick = command.add("--pick", "L,P,S",
                                       "instead of the focus: the structure at a point, mm, by LiveSync: its label, or "
                                       "the region that grows there",
                                       [&options](const std::string& text) {
                                         options.pick = app::parseVector(text);
                                         return options.pick.has_value();
                                       });
  for (const char* other : {"--descriptors", "--refine", "--map", "--joint", "--sequential", "--weights"})
    pick.excludes(command.option(other));
  const placement::LiveSyncWeights usual;
  command
      .add("--pick-weights", "O,S,V",
           "of the patient's orientation, the structure's shape and its visibility, 0 or more each, default " +
               text(usual.orientation) + "," + text(usual.shape) + "," + text(usual.visibility),
           [&options](const std::string& text) {
             const std::optional<glm::dvec3> weights = weightsIn(text);
             if (weights) options.liveSync.weights = {weights->x, weights->y, weights->z};
             return weights.has_value();
           })
      .needs(pick);
  app::addNumber(command, "--reach", 1.0, 1000.0, "MM",
                 "how far from the point its structure counts, default " + text(options.liveSync.reach),
                 options.liveSync.reach)
      .needs(pick);
}

/// The number of directions to try.
bool takeSamples(const std::string& text, int& target) {
  constexpr int most = 12288;
  const std::optional<int> count = app::parseNumber<int>(text);
  if (!count || *count < 12 || *count > most)
    throw app::WrongValue{"\"" + text + "\" is not a number from 12 to 12288"};
  if (!placement::sideOf(*count))
    throw app::WrongValue{"there are 12·n² directions, not " + text + "; the nearest are " + nearestCounts(*count)};
  target = *count;
  return true;
}

void addWeights(app::Command command, placement::Weights& weights) {
  const placement::Weights usual;
  command.add("--weights", "V,C,L",
              "of visibility (depth; negative prefers near), coverage and location, default " + text(usual.visibility) +
                  "," + text(usual.coverage) + "," + text(usual.location),
              [&weights](const std::string& text) {
                const std::optional<glm::dvec3> given = app::parseVector(text);
                if (!given) return false;
                weights.visibility = given->x;
                weights.coverage = given->y;
                weights.location = given->z;
                return true;
              });
  const auto add = [&](const char* name, const char* of, double& weight) {
    app::addNumber(command, name, -1e6, 1e6, "WEIGHT", "of " + std::string(of) + ", default " + text(weight), weight);
  };
  add("--entropy", "the seen surface's entropy", weights.entropy);
  add("--mutual-information", "how typical a view is of the surface", weights.mutualInformation);
  add("--stability", "the likeness to neighbouring views", weights.stability);
  add("--orientation", "the nearness to a standard view", weights.orientation);
  add("--end-face", "the share of the focus seen through a cut end of the scan", weights.endFace);
}

void addHabits(app::Command command, placement::Habits& habits) {
  const auto add = [&](const char* name, const std::string& meaning, bool& habit) {
    app::addChoice<bool>(command, name, meaning + "; default on", {{"on", true}, {"off", false}}, habit);
  };
  add("--avoid-cut-ends",
      "not through an end of the scan where the body goes on, unless no other view shows two thirds",
      habits.avoidCutEnds);
  add("--upright-first", "from around the patient rather than from above or below, where both show as much",
      habits.uprightFirst);
  add("--flat-from-front", "a thin stack of slices from its front, not edge-on", habits.flatFromFront);
  add("--near-side-first", "from the side of the body that the focus is nearer to, where both show as much",
      habits.nearSideFirst);
}

}  // namespace

void addPlacementOptions(app::Command command, PlaceOptions& options) {
  command.group("Placement");
  command.add("--samples", "N", "directions to try, 12·n² of them: 12, 48, 108, 192 (default), 300, 432, ...",
              [&options](const std::string& text) { return takeSamples(text, options.sampling.count); });
  command.addFlag("--refine", options.sampling.refined,
                  "instead: 48 directions, then finer where the views are best, as fine as 12288");
  app::addChoice<placement::Region>(
      command, "--region", "where the second camera may be, seen from the first, default semi-sphere",
      {{"stream", placement::Region::Stream}, {"semi-sphere", placement::Region::SemiSphere}},
      options.placement.region);
  app::addNumber(command, "--delta", 0.0, 90.0, "DEGREES", "half width of the stream, default 15",
                 options.placement.streamHalfWidth);
  addWeights(command, options.placement.weights);
  addHabits(command, options.placement.habits);
  const app::Option joint = command.addFlag("--joint", options.joint, "search both cameras at once (default)");
  const app::Option sequential =
      command.addFlag("!--sequential", options.joint, "first the best view, then the best one beside it, as the paper");
  joint.excludes(sequential);
  app::addNumber(command, "--share-weight", 0.0, 1.0, "0..1",
                 "of the surface seen by either camera in the joint search, the rest is quality's; default " +
                     text(options.placement.shareWeight),
                 options.placement.shareWeight)
      .excludes(sequential);
  command
      .addValue("--side", options.sampling.side,
                "pixels across the model in a candidate's image, default 128; a small focus gets more")
      .within(8, 2048)
      .as("PIXELS");
  app::addChoice<bool>(command, "--json", "the two cameras, or also every candidate; default cameras",
                       {{"cameras", false}, {"all", true}}, options.everyCandidate);
  command.addValue("--map", options.map, "PNG of the quality over the sphere, the cameras marked").as("FILE");
  addDescriptorOptions(command, options);
  addPickOptions(command, options);
  app::addScheduleOption(command, options.schedule);
  command.addValue("--repeat", options.repeat, "measurements to make and time").within(1, 1000);
  command.group("Options");
}

void useAsDefaults(const io::Session& session, PlaceOptions& options) {
  const io::SessionPlacement& saved = session.placement;
  options.sampling.count = saved.samples;
  options.sampling.refined = saved.refined;
  options.placement.weights = saved.weights;
  options.placement.habits = saved.habits;
  options.placement.region = saved.inStream ? placement::Region::Stream : placement::Region::SemiSphere;
  options.placement.streamHalfWidth = saved.streamHalfWidth;
  options.placement.shareWeight = saved.shareWeight;
  options.joint = saved.joint;
  options.liveSync = saved.liveSync;
}

}  // namespace fenestra::cli
