// fenestra-cli: everything that needs no window. Exit codes: 0 done, 1 the input or the machine is at fault, 2 wrong
// usage.

#include <algorithm>
#include <array>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "app/Completion.h"
#include "app/OptionHelpers.h"
#include "app/RegionOptions.h"
#include "app/SceneOptions.h"
#include "app/ScheduleChoice.h"
#include "app/WallOptions.h"
#include "app/cli/Commands.h"
#include "app/cli/Report.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/RenderError.h"
#include "rendering/reference/Certificate.h"
#include "rendering/viewpoints/Sphere.h"

namespace fenestra::cli {
namespace {

constexpr int done = 0, failed = 1, misused = 2;

/// A command: its options, and how to run it; false is a failure that was already reported.
struct Command {
  CLI::App* app;
  const io::DataRequest* source;  ///< what an error that names no file is about; may be null
  std::function<bool()> run;
};

void requireSource(CLI::App& command) {
  command.final_callback([&command] {
    if (!command.get_option("PATH")->count() && !command.get_option("--phantom")->count())
      throw CLI::RequiredError("PATH or --phantom");
  });
}

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

void addDescriptorOptions(CLI::App& command, PlaceOptions& options) {
  CLI::Option* descriptors =
      command
          .add_option_function<std::string>(
              "--descriptors",
              [&options](const std::string& names) {
                if (!selectDescriptors(names, options.descriptors))
                  throw CLI::ValidationError("--descriptors", "\"" + names + "\" names no descriptors; there are " +
                                                                  joined(descriptorNames()));
              },
              "also what other view descriptors say of every direction: their values, the camera that each would "
              "choose, and rank correlations with the paper's three; names, default all: " +
                  joined(descriptorNames()))
          ->type_name("[NAME,...]")
          ->expected(0, 1)
          ->default_str(descriptorNames().front())
          ->excludes(command.get_option("--refine"));
  command
      .add_option("--pictures", options.descriptors.pictures,
                  "folder for a PNG from each of those cameras, 320x240 or as --size says")
      ->type_name("FOLDER")
      ->needs(descriptors);
}

void addPickOptions(CLI::App& command, PlaceOptions& options) {
  CLI::Option* pick = app::addParsed(command, "--pick", "L,P,S",
                                     "instead of the focus: the structure at a point, mm, by LiveSync: its label, or "
                                     "the region that grows there",
                                     [&options](const std::string& text) {
                                       const auto point = app::parseNumbers<double, 3>(text, ',');
                                       if (point) options.pick = {(*point)[0], (*point)[1], (*point)[2]};
                                       return point.has_value();
                                     });
  for (const char* other : {"--descriptors", "--refine", "--map", "--joint", "--sequential", "--weights"})
    pick->excludes(command.get_option(other));
  const placement::LiveSyncWeights usual;
  app::addParsed(command, "--pick-weights", "O,S,V",
                 "of the patient's orientation, the structure's shape and its visibility, 0 or more each, default " +
                     text(usual.orientation) + "," + text(usual.shape) + "," + text(usual.visibility),
                 [&options](const std::string& text) {
                   const auto weights = app::parseNumbers<double, 3>(text, ',');
                   if (!weights || std::any_of(weights->begin(), weights->end(), [](double w) { return w < 0.0; }))
                     return false;
                   options.liveSync.weights.orientation = (*weights)[0];
                   options.liveSync.weights.shape = (*weights)[1];
                   options.liveSync.weights.visibility = (*weights)[2];
                   return true;
                 })
      ->needs(pick);
  app::addNumber(command, "--reach", 1.0, 1000.0, "MM",
                 "how far from the point its structure counts, default " + text(options.liveSync.reach),
                 options.liveSync.reach)
      ->needs(pick);
}

void addPlacementOptions(CLI::App& command, PlaceOptions& options) {
  command.option_defaults()->group("Placement");
  command
      .add_option_function<std::string>(
          "--samples",
          [&options](const std::string& text) {
            constexpr int most = 12288;
            const std::optional<int> count = app::parseNumber<int>(text);
            if (!count || *count < 12 || *count > most)
              throw CLI::ValidationError("--samples", "\"" + text + "\" is not a number from 12 to 12288");
            if (!placement::sideOf(*count))
              throw CLI::ValidationError("--samples", "there are 12·n² directions, not " + text + "; the nearest are " +
                                                          nearestCounts(*count));
            options.sampling.count = *count;
          },
          "directions to try, 12·n² of them: 12, 48, 108, 192 (default), 300, 432, ...")
      ->type_name("N");
  command.add_flag("--refine", options.sampling.refined,
                   "instead: 48 directions, then finer where the views are best, as fine as 12288");
  app::addChoice<placement::Region>(
      command, "--region", "where the second camera may be, seen from the first, default semi-sphere",
      {{"stream", placement::Region::Stream}, {"semi-sphere", placement::Region::SemiSphere}},
      options.placement.region);
  app::addNumber(command, "--delta", 0.0, 90.0, "DEGREES", "half width of the stream, default 15",
                 options.placement.streamHalfWidth);
  const placement::Weights usual;
  app::addParsed(command, "--weights", "V,C,L",
                 "of visibility (depth; negative prefers near), coverage and location, default " +
                     text(usual.visibility) + "," + text(usual.coverage) + "," + text(usual.location),
                 [&options](const std::string& text) {
                   const auto weights = app::parseNumbers<double, 3>(text, ',');
                   if (!weights) return false;
                   options.placement.weights.visibility = (*weights)[0];
                   options.placement.weights.coverage = (*weights)[1];
                   options.placement.weights.location = (*weights)[2];
                   return true;
                 });
  const auto addWeight = [&](const char* name, const char* of, double& weight) {
    app::addNumber(command, name, -1e6, 1e6, "WEIGHT", "of " + std::string(of) + ", default " + text(weight), weight);
  };
  addWeight("--entropy", "the seen surface's entropy", options.placement.weights.entropy);
  addWeight("--mutual-information", "how typical a view is of the surface",
            options.placement.weights.mutualInformation);
  addWeight("--stability", "the likeness to neighbouring views", options.placement.weights.stability);
  addWeight("--orientation", "the nearness to a standard view", options.placement.weights.orientation);
  addWeight("--end-face", "the share of the focus seen through a cut end of the scan",
            options.placement.weights.endFace);
  CLI::Option* joint = command.add_flag("--joint", options.joint, "search both cameras at once (default)");
  CLI::Option* sequential = command.add_flag("!--sequential", options.joint,
                                             "first the best view, then the best one beside it, as the paper");
  joint->excludes(sequential);
  app::addNumber(command, "--share-weight", 0.0, 1.0, "0..1",
                 "of the surface seen by either camera in the joint search, the rest is quality's; default " +
                     text(options.placement.shareWeight),
                 options.placement.shareWeight)
      ->excludes(sequential);
  command
      .add_option("--side", options.sampling.side,
                  "pixels across the model in a candidate's image, default 128; a small focus gets more")
      ->check(CLI::Range(8, 2048))
      ->type_name("PIXELS");
  app::addChoice<bool>(command, "--json", "the two cameras, or also every candidate; default cameras",
                       {{"cameras", false}, {"all", true}}, options.everyCandidate);
  command.add_option("--map", options.map, "PNG of the quality over the sphere, the cameras marked")->type_name("FILE");
  addDescriptorOptions(command, options);
  addPickOptions(command, options);
  app::addScheduleOption(command, options.schedule);
  command.add_option("--repeat", options.repeat, "measurements to make and time")->check(CLI::Range(1, 1000));
  command.option_defaults()->group("Options");
}

void useAsDefaults(const io::Session& session, PlaceOptions& options) {
  const io::SessionPlacement& saved = session.placement;
  options.sampling.count = saved.samples;
  options.sampling.refined = saved.refined;
  options.placement.weights = saved.weights;
  options.placement.region = saved.inStream ? placement::Region::Stream : placement::Region::SemiSphere;
  options.placement.streamHalfWidth = saved.streamHalfWidth;
  options.placement.shareWeight = saved.shareWeight;
  options.joint = saved.joint;
  options.liveSync = saved.liveSync;
}

int fail(const std::string& what) {
  std::cerr << oneLine("fenestra-cli: " + what) << '\n';
  return failed;
}

int run(const Command& command) {
  const std::string source = command.source ? command.source->source() : command.app->get_name();
  try {
    return command.run() ? done : failed;
  } catch (const io::Error& error) {
    return fail(error.what());
  } catch (const egl::EglError& error) {
    return fail(source + ": " + error.what());
  } catch (const RenderError& error) {
    return fail(source + ": " + error.what());
  } catch (const gl::AllocationError& error) {
    return fail(source + ": " + error.what());
  } catch (const gl::ShaderError& error) {
    return fail(source + ": the graphics driver refuses a shader: " + error.what() +
                "; update the driver, or set LIBGL_ALWAYS_SOFTWARE=1");
  } catch (const VoxelAllocationError& error) {
    return fail(source + ": " + error.what() + "; close other programs or use a smaller volume");
  } catch (const std::bad_alloc&) {
    return fail(source + ": not enough memory; close other programs or use a smaller volume");
  } catch (const std::exception& error) {
    return fail(source + ": unexpected failure: " + error.what() + "; please report it");
  }
}

Command addInfo(CLI::App& program, InfoOptions& options) {
  CLI::App* command = program.add_subcommand("info", "geometry, type, value range, series and warnings, as JSON");
  app::addVolumeOptions(*command, options.data);
  command->add_flag("--descriptions", options.descriptions,
                    "also the series' descriptions, free texts that may name the patient");
  requireSource(*command);
  return {command, &options.data, [&] { return info(options), true; }};
}

Command addConvert(CLI::App& program, ConvertOptions& options) {
  CLI::App* command = program.add_subcommand(
      "convert",
      "write the volume's real values to .mha, .nii.gz, .nii or .nrrd; with --labels, --focus-labels or a .dcm, the "
      "label map instead, .dcm being a DICOM segmentation");
  app::addLabelOptions(*command, options.data, options.labels);
  command->add_option("-o,--output", options.output, "file to write")->required()->type_name("FILE");
  requireSource(*command);
  return {command, &options.data, [&] { return convert(options), true; }};
}

Command addSurface(CLI::App& program, SurfaceOptions& options) {
  CLI::App* command = program.add_subcommand("surface", "the focus as a closed surface of triangles");
  app::addSceneOptions(*command, options.study);
  command->add_option("-o,--output", options.output, "STL, PLY or OBJ to write")->required()->type_name("FILE");
  app::addChoice<io::SurfaceFrame>(*command, "--frame", "axes of the coordinates in mm, default lps",
                                   {{"lps", io::SurfaceFrame::Lps}, {"ras", io::SurfaceFrame::Ras}}, options.frame);
  command->add_flag("--raw-surface", options.raw, "the level set as it is, without smoothing");
  requireSource(*command);
  return {command, &options.study, [&] { return surface(options), true; }};
}

Command addSlice(CLI::App& program, SliceOptions& options) {
  CLI::App* command = program.add_subcommand("slice", "one slice as PNG, a pixel a voxel, radiological convention");
  app::addVolumeOptions(*command, options.data);
  app::addChoice<SlicePlane>(
      *command, "--plane", "default axial",
      {{"axial", SlicePlane::Axial}, {"sagittal", SlicePlane::Sagittal}, {"coronal", SlicePlane::Coronal}},
      options.plane);
  CLI::Option* at = command->add_option("--at", options.at, "mm along S (axial), L (sagittal) or P (coronal)");
  command->add_option("--index", options.index, "slice number, growing the same way; the middle one otherwise")
      ->excludes(at);
  command->add_option("--window", options.width, "width of the display window; the file's own otherwise")
      ->check(CLI::PositiveNumber);
  command->add_option("--level", options.level, "centre of the display window");
  command->add_option("-o,--output", options.output, "PNG to write")->required()->type_name("FILE");
  requireSource(*command);
  return {command, &options.data, [&] { return slice(options), true; }};
}

Command addRender(CLI::App& program, RenderOptions& options) {
  CLI::App* command = program.add_subcommand("render", "a picture with the adaptive cutaway");
  app::addSceneOptions(*command, options.study);
  command->option_defaults()->group("Picture");
  app::addWallOptions(*command, options.study);
  command->option_defaults()->group("Options");
  CLI::Option* output = command->add_option("-o,--output", options.output, "PNG to write")->type_name("FILE");
  CLI::Option* layers =
      command->add_option("--layers", options.layers, "folder for every stage, as .mha")->type_name("FOLDER");
  CLI::Option* stats = command->add_option("--stats", options.stats, "JSON of times and memory to write")
                           ->type_name("FILE")
                           ->needs(output);
  command->add_option("--save-session", options.session, "what is shown as a session, for the window or for later")
      ->type_name("FILE.fenestra");
  command->add_option("--save-look", options.look, "how the volume is looked at as a preset, for --look and the window")
      ->type_name("FILE.json");
  CLI::Option* repeat =
      command->add_option("--repeat", options.repeat, "frames to draw and time, each from the first pass on")
          ->check(CLI::Range(1, 10000))
          ->needs(output);
  app::addScheduleOption(*command, options.schedule);
  CLI::Option* reference =
      command->add_flag("--reference", options.reference,
                        "the picture, its layers or both in double precision on the CPU, without OpenGL; takes minutes "
                        "where the renderer takes seconds");
  reference->excludes(stats)->excludes(repeat);
  CLI::Option* certify =
      command
          ->add_option("--certify", options.certify,
                       "compares N random pixels with the reference and says, as JSON and in the PNG, how much of the "
                       "picture is within --max-error, or without it within which error 99.9 % of it is")
          ->type_name("[N]")
          ->expected(0, 1)
          ->default_str(std::to_string(reference::CertificateOptions{}.pixels))
          ->check(CLI::Range(1, 100'000'000))
          ->needs(output)
          ->excludes(reference);
  command->add_option("--certify-seed", options.certifySeed, "that chooses the pixels")->needs(certify);
  command->final_callback([=] {
    if (!command->get_option("PATH")->count() && !command->get_option("--phantom")->count())
      throw CLI::RequiredError("PATH or --phantom");
    const bool referenceLayers = reference->count() && layers->count();
    if (!output->count() && !referenceLayers) throw CLI::RequiredError("--output");
  });
  return {command, &options.study, [&] { return render(options), true; }};
}

Command addPlace(CLI::App& program, PlaceOptions& options) {
  CLI::App* command =
      program.add_subcommand("place", "the best view of the focus and one that complements it, as JSON");
  app::addSceneOptions(*command, options.study,
                       [&options](const io::Session& session) { useAsDefaults(session, options); });
  addPlacementOptions(*command, options);
  requireSource(*command);
  return {command, &options.study, [&] {
            // A session may ask for a refinement, whose candidates crowd where the paper's quality is best.
            if (!options.descriptors.isEmpty()) options.sampling.refined = false;
            return place(options), true;
          }};
}

Command addGrow(CLI::App& program, GrowOptions& options) {
  CLI::App* command = program.add_subcommand(
      "grow", "the structure around a point as a label map (0 and 1); its tolerance, volume and plateaus as JSON");
  app::addVolumeOptions(*command, options.data);
  app::addSeedOptions(*command, options.region)->required();
  command->add_flag("--curve", options.curve, "also the volume at every tolerance");
  command->add_option("-o,--output", options.output, ".nii.gz, .nii, .nrrd or .mha to write")
      ->required()
      ->type_name("FILE");
  requireSource(*command);
  return {command, &options.data, [&] { return grow(options), true; }};
}

Command addBenchmark(CLI::App& program, BenchmarkOptions& options) {
  CLI::App* command = program.add_subcommand(
      "benchmark", "how fast this machine draws the built-in phantom, compared with machines of the project's report");
  command
      ->add_option("-o,--output", options.output,
                   "page (.md) or JSON (.json) to write; JSON to standard output otherwise")
      ->type_name("FILE")
      ->check([](const std::string& path) {
        return path.ends_with(".md") || path.ends_with(".json") ? std::string()
                                                                : path + " ends in neither .md nor .json";
      });
  command->add_flag("--quick", options.isQuick, "in about twenty seconds instead of some minutes, without errors");
  app::addParsed(*command, "--size", "WxH", "pictures in pixels, default 700x650, that of the figures to compare with",
                 [&options](const std::string& text) {
                   const auto size = app::parseNumbers<int, 2>(text, 'x');
                   if (!size || (*size)[0] < 1 || (*size)[1] < 1) return false;
                   options.size = glm::ivec2((*size)[0], (*size)[1]);
                   return true;
                 });
  app::addScheduleOption(*command, options.schedule);
  return {command, nullptr, [&] { return benchmark(options), true; }};
}

Command addCompare(CLI::App& program, CompareOptions& options) {
  CLI::App* command = program.add_subcommand("compare", "errors between two pictures or layers, as JSON");
  command->add_option("A", options.a, "PNG or .mha")->required()->type_name("");
  command->add_option("B", options.b, "of the same size")->required()->type_name("");
  return {command, nullptr, [&] { return compare(options); }};
}

int main(int argc, char** argv) {
  CLI::App program{
      "Fenestra without a window: looks into medical volumes and pictures them with an adaptive cutaway.\n"
      "Not for diagnostic use.",
      "fenestra-cli"};
  program.require_subcommand(1);
  program.set_version_flag("--version", FENESTRA_VERSION);
  app::addCompletionOption(program);
  program.get_formatter()->column_width(40);
  InfoOptions infoOptions;
  ConvertOptions convertOptions;
  SliceOptions sliceOptions;
  SurfaceOptions surfaceOptions;
  RenderOptions renderOptions;
  PlaceOptions placeOptions;
  GrowOptions growOptions;
  BenchmarkOptions benchmarkOptions;
  CompareOptions compareOptions;
  const std::array commands{addInfo(program, infoOptions),          addConvert(program, convertOptions),
                            addSlice(program, sliceOptions),        addRender(program, renderOptions),
                            addPlace(program, placeOptions),        addGrow(program, growOptions),
                            addSurface(program, surfaceOptions),    addCompare(program, compareOptions),
                            addBenchmark(program, benchmarkOptions)};

  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    const bool named = !program.get_subcommands().empty() || error.get_name() == "ValidationError";
    const std::string what =
        named ? error.what() : "expected info, convert, slice, render, place, grow, surface, compare or benchmark";
    std::cerr << oneLine("fenestra-cli: " + what + "; see --help") << '\n';
    return misused;
  } catch (const io::Error& error) {  // of a session, which is read while parsing
    return fail(error.what());
  }
  for (const Command& each : commands)
    if (each.app->parsed()) return run(each);
  return misused;
}

}  // namespace
}  // namespace fenestra::cli

int main(int argc, char** argv) {
  try {
    return fenestra::cli::main(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "fenestra-cli: cannot start: " << fenestra::cli::oneLine(error.what()) << '\n';
    return 1;
  }
}
