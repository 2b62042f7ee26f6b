// fenestra-cli: everything that needs no window. Exit codes: 0 done, 1 the input or the machine is at fault, 2 wrong
// usage.

#include <algorithm>
#include <array>
#include <exception>
#include <functional>
#include <iostream>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/DataOptions.h"
#include "app/RegionOptions.h"
#include "app/SceneOptions.h"
#include "app/ScheduleChoice.h"
#include "app/WallOptions.h"
#include "app/cli/ArchiveCommand.h"
#include "app/cli/Commands.h"
#include "app/cli/DeidentifyCommand.h"
#include "app/cli/PlacementOptions.h"
#include "app/cli/ReformatOptions.h"
#include "app/cli/Report.h"
#include "app/cli/ResultsCommand.h"
#include "app/cli/SliceOptions.h"
#include "app/options/Completion.h"
#include "app/options/Numbers.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gl/ShaderProgram.h"
#include "rendering/gl/Texture.h"
#include "rendering/gpu/RenderError.h"
#include "rendering/reference/Certificate.h"

namespace fenestra::cli {
namespace {

constexpr int done = 0, failed = 1, misused = 2;

/// A command that can be run; false is a failure that was already reported.
struct Runnable {
  app::Command command;
  const io::DataRequest* source;  ///< what an error that names no file is about; may be null
  std::function<bool()> run;
};

void requireSource(app::Command command) {
  if (!command.isGiven("PATH") && !command.isGiven("--phantom")) throw app::MissingOption{"PATH or --phantom"};
}

int fail(const std::string& what) {
  std::cerr << oneLine("fenestra-cli: " + what) << '\n';
  return failed;
}

int run(const Runnable& command) {
  const std::string source = command.source ? command.source->source() : command.command.name();
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

/// The options of a scene, which begins in the plain look: the pictures and placements of a script stay as they are
/// when the look changes that the window opens new data in.
void addScene(app::Command command, io::StudyRequest& study, std::function<void(const io::Session&)> onSession = {}) {
  study.makePlain();
  app::addSceneOptions(command, study, std::move(onSession));
}

Runnable addInfo(app::Program& program, InfoOptions& options) {
  const app::Command command = program.addCommand("info", "geometry, type, value range, series and warnings, as JSON");
  app::addVolumeOptions(command, options.data);
  command.addFlag("--descriptions", options.descriptions,
                  "also the series' descriptions, free texts that may name the patient");
  const app::Option asTags = command.addFlag("--tags", options.tags, "the DICOM attributes of a slice's file instead");
  command.addValue("--search", options.search, "only attributes whose tag, name or value holds it, in any case")
      .as("TEXT")
      .needs(asTags);
  command.addValue("--slice", options.slice, "number of the slice as scanned, from 0; the middle one otherwise")
      .as("K")
      .needs(asTags);
  command.addFlag("--with-patient", options.withPatient, "also values that may identify the patient").needs(asTags);
  command.atLast([command] { requireSource(command); });
  return {command, &options.data, [&] { return options.tags ? tags(options) : info(options), true; }};
}

Runnable addConvert(app::Program& program, ConvertOptions& options) {
  const app::Command command = program.addCommand(
      "convert",
      "write the volume's real values to .mha, .nii.gz, .nii or .nrrd; with --labels, --focus-labels or a .dcm, the "
      "label map instead, .dcm being a DICOM segmentation");
  app::addVolumeOptions(command, options.data);
  command.group("Labels");
  app::addLabelChoice(command, options.data, options.labels);
  command.group("Options");
  command.addValue("-o,--output", options.output, "file to write").required().as("FILE");
  command.atLast([command] { requireSource(command); });
  return {command, &options.data, [&] { return convert(options), true; }};
}

Runnable addMeasure(app::Program& program, MeasureOptions& options) {
  const app::Command command = program.addCommand(
      "measure", "volume, mean, standard deviation, range and place of each label, or of --focus-labels, as JSON");
  app::addVolumeOptions(command, options.data);
  command.group("Labels");
  app::addLabelChoice(command, options.data, options.labels);
  command.atLast([command] { requireSource(command); });
  return {command, &options.data, [&] { return measure(options), true; }};
}

Runnable addSurface(app::Program& program, SurfaceOptions& options) {
  const app::Command command = program.addCommand("surface", "the focus as a closed surface of triangles");
  addScene(command, options.study);
  command.addValue("-o,--output", options.output, "STL, PLY or OBJ to write").required().as("FILE");
  app::addChoice<io::SurfaceFrame>(command, "--frame", "axes of the coordinates in mm, default lps",
                                   {{"lps", io::SurfaceFrame::Lps}, {"ras", io::SurfaceFrame::Ras}}, options.frame);
  command.addFlag("--raw-surface", options.raw, "the level set as it is, without smoothing");
  command.atLast([command] { requireSource(command); });
  return {command, &options.study, [&] { return surface(options), true; }};
}

Runnable addSlice(app::Program& program, SliceOptions& options) {
  const app::Command command =
      program.addCommand("slice", "a slice in any direction, or a slab, as PNG or as real values; its place as JSON");
  addSliceOptions(command, options);
  command.atLast([command] { requireSource(command); });
  return {command, &options.study, [&] { return slice(options), true; }};
}

Runnable addReformat(app::Program& program, ReformatOptions& options) {
  const app::Command command = program.addCommand(
      "reformat", "the volume straightened along a path or a vessel, or cut across it; length and areas as JSON");
  addReformatOptions(command, options);
  command.atLast([command] { requireSource(command); });
  return {command, &options.study, [&] { return reformat(options), true; }};
}

/// What render writes, and how it draws.
void addRenderOptions(app::Command command, RenderOptions& options) {
  const app::Option output = command.addValue("-o,--output", options.output, "PNG to write").as("FILE");
  const app::Option layers =
      command.addValue("--layers", options.layers, "folder for every stage, as .mha").as("FOLDER");
  const app::Option stats =
      command.addValue("--stats", options.stats, "JSON of times and memory to write").as("FILE").needs(output);
  command.addValue("--save-session", options.session, "what is shown as a session, for the window or for later")
      .as("FILE.fenestra");
  command.addValue("--save-look", options.look, "how the volume is looked at as a preset, for --look and the window")
      .as("FILE.json");
  const app::Option repeat =
      command.addValue("--repeat", options.repeat, "frames to draw and time, each from the first pass on")
          .within(1, 10000)
          .needs(output);
  app::addScheduleOption(command, options.schedule);
  const app::Option reference =
      command.addFlag("--reference", options.reference,
                      "the picture, its layers or both in double precision on the CPU, without OpenGL; takes minutes "
                      "where the renderer takes seconds");
  reference.excludes(stats).excludes(repeat);
  const app::Option certify =
      command
          .addValue("--certify", options.certify,
                    "compares N random pixels with the reference and says, as JSON and in the PNG, how much of the "
                    "picture is within --max-error, or without it within which error 99.9 % of it is")
          .as("[N]")
          .orElse(std::to_string(reference::CertificateOptions{}.pixels))
          .within(1, 100'000'000)
          .needs(output)
          .excludes(reference);
  command.addValue("--certify-seed", options.certifySeed, "that chooses the pixels").needs(certify);
  command.atLast([=] {
    requireSource(command);
    const bool referenceLayers = reference.isGiven() && layers.isGiven();
    if (!output.isGiven() && !referenceLayers) throw app::MissingOption{"--output"};
  });
}

Runnable addRender(app::Program& program, RenderOptions& options) {
  const app::Command command = program.addCommand("render", "a picture with the adaptive cutaway");
  addScene(command, options.study);
  command.group("Picture");
  app::addWallOptions(command, options.study);
  command.group("Options");
  addRenderOptions(command, options);
  return {command, &options.study, [&] { return render(options), true; }};
}

Runnable addPlace(app::Program& program, PlaceOptions& options) {
  const app::Command command =
      program.addCommand("place", "the best view of the focus and one that complements it, as JSON");
  addScene(command, options.study, [&options](const io::Session& session) { useAsDefaults(session, options); });
  addPlacementOptions(command, options);
  command.atLast([command] { requireSource(command); });
  return {command, &options.study, [&] {
            // A session may ask for a refinement, whose candidates crowd where the paper's quality is best.
            if (!options.descriptors.isEmpty()) options.sampling.refined = false;
            return place(options), true;
          }};
}

Runnable addGrow(app::Program& program, GrowOptions& options) {
  const app::Command command = program.addCommand(
      "grow", "the structure around a point as a label map (0 and 1); its tolerance, volume and plateaus as JSON");
  app::addVolumeOptions(command, options.data);
  app::addSeedOptions(command, options.region).required();
  command.addFlag("--curve", options.curve, "also the volume at every tolerance");
  command.addValue("-o,--output", options.output, ".nii.gz, .nii, .nrrd or .mha to write").required().as("FILE");
  command.atLast([command] { requireSource(command); });
  return {command, &options.data, [&] { return grow(options), true; }};
}

Runnable addBenchmark(app::Program& program, BenchmarkOptions& options) {
  const app::Command command = program.addCommand(
      "benchmark", "how fast this machine draws the built-in phantom, compared with machines of the project's report");
  command
      .addValue("-o,--output", options.output, "page (.md) or JSON (.json) to write; JSON to standard output otherwise")
      .as("FILE")
      .refusing([](const std::string& path) {
        return path.ends_with(".md") || path.ends_with(".json") ? std::string()
                                                                : path + " ends in neither .md nor .json";
      });
  command.addFlag("--quick", options.isQuick, "in about twenty seconds instead of some minutes, without errors");
  command.add("--size", "WxH", "pictures in pixels, default 700x650, that of the figures to compare with",
              [&options](const std::string& text) {
                options.size = app::parseSize(text, std::numeric_limits<int>::max());
                return options.size.has_value();
              });
  app::addScheduleOption(command, options.schedule);
  return {command, nullptr, [&] { return benchmark(options), true; }};
}

Runnable addCompare(app::Program& program, CompareOptions& options) {
  const app::Command command = program.addCommand("compare", "errors between two pictures or layers, as JSON");
  command.addValue("A", options.a, "PNG or .mha").required().as("");
  command.addValue("B", options.b, "of the same size").required().as("");
  return {command, nullptr, [&] { return compare(options); }};
}

Runnable addArchive(app::Program& program, ArchiveOptions& options) {
  const app::Command command = program.addCommand("archive",
                                                  "asks an archive server (PACS) for studies, retrieves them, and "
                                                  "sends objects to it; echo asks whether it answers");
  addArchiveOptions(command, options);
  return {command, nullptr, [&] { return archive(options); }};
}

Runnable addDeidentify(app::Program& program, DeidentifyOptions& options) {
  const app::Command command = program.addCommand(
      "deidentify", "copies DICOM objects without what names people; pixels and geometry stay as they are");
  addDeidentifyOptions(command, options);
  return {command, nullptr, [&] { return deidentify(options), true; }};
}

Runnable addReport(app::Program& program, ReportOptions& options) {
  const app::Command command = program.addCommand(
      "report",
      "results as DICOM objects in the study of their series: tables of labels and measures as a structured report, "
      "segmentations, pictures, key images");
  addReportOptions(command, options);
  return {command, &options.data, [&] { return report(options), true; }};
}

int main(int argc, char** argv) {
  app::Program program(
      "Fenestra without a window: looks into medical volumes and pictures them with an adaptive cutaway.\n"
      "Not for diagnostic use.",
      "fenestra-cli", FENESTRA_VERSION);
  app::addCompletionOption(program);
  program.setHelpColumn(40);
  InfoOptions infoOptions;
  ConvertOptions convertOptions;
  MeasureOptions measureOptions;
  SliceOptions sliceOptions;
  ReformatOptions reformatOptions;
  SurfaceOptions surfaceOptions;
  RenderOptions renderOptions;
  PlaceOptions placeOptions;
  GrowOptions growOptions;
  BenchmarkOptions benchmarkOptions;
  CompareOptions compareOptions;
  ArchiveOptions archiveOptions;
  DeidentifyOptions deidentifyOptions;
  ReportOptions reportOptions;
  const std::array commands{addInfo(program, infoOptions),
                            addConvert(program, convertOptions),
                            addMeasure(program, measureOptions),
                            addSlice(program, sliceOptions),
                            addReformat(program, reformatOptions),
                            addRender(program, renderOptions),
                            addPlace(program, placeOptions),
                            addGrow(program, growOptions),
                            addSurface(program, surfaceOptions),
                            addCompare(program, compareOptions),
                            addBenchmark(program, benchmarkOptions),
                            addArchive(program, archiveOptions),
                            addDeidentify(program, deidentifyOptions),
                            addReport(program, reportOptions)};
  try {
    const app::Program::Parsed parsed = program.parse(argc, argv);
    if (parsed.exitCode) return *parsed.exitCode;
    if (!parsed.mistake.empty()) {
      std::cerr << oneLine("fenestra-cli: " + parsed.mistake + "; see --help") << '\n';
      return misused;
    }
  } catch (const io::Error& error) {  // of a session, which is read while parsing
    return fail(error.what());
  }
  for (const Runnable& each : commands)
    if (each.command.isNamed()) return run(each);
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
