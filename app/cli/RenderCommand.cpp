#include "app/cli/Commands.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <system_error>

#include <nlohmann/json.hpp>

#include "app/ScheduleChoice.h"
#include "app/cli/PlacedCamera.h"
#include "app/cli/ReadBesideContext.h"
#include "app/cli/Report.h"
#include "io/ImageWriter.h"
#include "io/base/AtomicFile.h"
#include "io/session/CameraFile.h"
#include "io/session/LookFile.h"
#include "io/session/SessionFile.h"
#include "io/study/PictureProof.h"
#include "io/study/ReadStudy.h"
#include "io/study/SessionData.h"
#include "rendering/Renderer.h"
#include "rendering/egl/EglContext.h"
#include "rendering/gpu/GpuScene.h"
#include "rendering/reference/Picture.h"

namespace fenestra::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Writes one layer as NAME.mha; a stage that the scene does not use has no file.
void writeLayer(const fs::path& folder, const char* name, glm::ivec2 size, const std::vector<float>& values) {
  if (!values.empty()) io::writeLayer(folder / (std::string(name) + ".mha"), size, 1, values);
}
void writeLayer(const fs::path& folder, const char* name, glm::ivec2 size, const std::vector<glm::vec4>& values) {
  if (values.empty()) return;
  io::writeLayer(folder / (std::string(name) + ".mha"), size, 4, {&values[0].x, values.size() * 4});
}

void writeLayers(const fs::path& folder, const Layers& layers, const View& view, const Grid& grid) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw io::Error(folder, "cannot be made: " + error.message(), "choose a folder you may write to");
  io::writeCamera(folder / "camera.json", {view.camera, view.size}, grid);
  writeLayer(folder, "t_context", layers.size, layers.tContext);
  writeLayer(folder, "t_focus", layers.size, layers.tFocus);
  writeLayer(folder, "t_focus_filled", layers.size, layers.tFocusFilled);
  writeLayer(folder, "t_start", layers.size, layers.tStart);
  writeLayer(folder, "distance", layers.size, layers.distance);
  if (!layers.edits.empty())
    io::writeLayer(folder / "edit_map.mha", layers.size, 2, {&layers.edits[0].x, layers.edits.size() * 2});
  writeLayer(folder, "focus_layer", layers.size, layers.focusLayer);
  writeLayer(folder, "faint_layer", layers.size, layers.faintLayer);
  writeLayer(folder, "protected_layer", layers.size, layers.protectedLayer);
  writeLayer(folder, "context_layer", layers.size, layers.contextLayer);
  writeLayer(folder, "lens", layers.size, layers.lens);
  writeLayer(folder, "walls", layers.size, layers.walls);
  writeLayer(folder, "final", layers.size, layers.final);
}

Layers referenceLayers(const Scene& scene, const View& view) {
  const auto single = [](const reference::Image& image) { return std::vector<float>(image.begin(), image.end()); };
  const auto colours = [](const std::vector<glm::dvec4>& image) {
    return std::vector<glm::vec4>(image.begin(), image.end());
  };
  reference::PictureOptions options;
  options.pixelScale = view.pixelScale;
  options.slices = view.slices;
  reference::Stages stages;
  if (hasCutaway(scene)) stages = reference::geometricStages(scene, view);
  const reference::Picture picture =
      reference::picture(reference::asDrawn(scene, view), view.camera, view.size, stages, options);
  Layers layers;
  layers.size = view.size;
  layers.tContext = single(stages.hits.tContext);
  layers.tFocus = single(stages.hits.tFocus);
  layers.tFocusFilled = single(stages.tFocusFilled);
  layers.distance = single(stages.distance);
  layers.tStart = single(stages.tStart);
  for (std::size_t i = 0; i < stages.editOffset.size(); ++i)
    layers.edits.emplace_back(stages.editOffset[i], stages.editFactor[i]);
  layers.focusLayer = colours(picture.focusLayer);
  layers.faintLayer = colours(picture.faintLayer);
  layers.protectedLayer = colours(picture.protectedLayer);
  layers.contextLayer = colours(picture.contextLayer);
  layers.lens = colours(picture.lens);
  layers.walls = colours(picture.walls);
  layers.final = colours(picture.final);
  return layers;
}

/// The colours of an opaque picture.
std::vector<std::uint8_t> withoutAlpha(const std::vector<std::uint8_t>& picture) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(picture.size() / 4 * 3);
  for (std::size_t i = 0; i < picture.size(); ++i)
    if (i % 4 != 3) rgb.push_back(picture[i]);
  return rgb;
}

/// A picture over its background, opaque RGB.
std::vector<std::uint8_t> overBackground(const std::vector<glm::vec4>& premultiplied, glm::ivec2 size,
                                         const Look& look) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(premultiplied.size() * 3);
  for (std::size_t i = 0; i < premultiplied.size(); ++i) {
    const glm::vec4& front = premultiplied[i];
    const double row = static_cast<double>(i / static_cast<std::size_t>(size.x)) + 0.5;
    const glm::vec3 colour = glm::vec3(front) + (1.0f - front.a) * glm::vec3(backgroundAt(look, 1.0 - row / size.y));
    for (int channel = 0; channel < 3; ++channel)
      rgb.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(colour[channel], 0.0f, 1.0f) * 255.0f)));
  }
  return rgb;
}

/// The first frame uploads the volume and compiles shaders; it counts only where it is alone.
std::vector<double> warmFrames(const std::vector<double>& frames) {
  std::vector<double> warm(frames.begin() + (frames.size() > 1 ? 1 : 0), frames.end());
  std::sort(warm.begin(), warm.end());
  return warm;
}

/// The bound on a pixel's error that the picture is drawn within, in 1/255: the one that was asked for, or else the one
/// that normal quality has chosen; null where there is none.
Json boundOf(const Scene& scene, const View& view, const GpuScene& gpuScene) {
  const std::optional<double> asked = errorBound(view), bound = asked ? asked : gpuScene.chosenBound(scene, view);
  return bound ? Json(*bound) : Json();
}

Json statistics(const std::string& description, const Scene& scene, const View& view, const Renderer& renderer,
                const GpuScene& gpuScene, const std::vector<double>& frames) {
  Json passes = Json::array();
  for (std::size_t pass = 0; pass < passCount; ++pass) {
    const PassStats& stats = renderer.stats()[pass];
    passes.push_back({{"name", nameOf(static_cast<Pass>(pass))}, {"runs", stats.runs}, {"ms", stats.milliseconds}});
  }
  Json resources = Json::array();
  for (const GpuScene::Resource& resource : gpuScene.resources())
    resources.push_back({{"name", resource.name}, {"bytes", resource.bytes}});
  resources.push_back({{"name", "images"}, {"bytes", renderer.imageBytes()}});
  const std::vector<double> warm = warmFrames(frames);
  return {
      {"gl", description},
      {"schedule", nameOf(gpuScene.schedule())},
      {"size", {view.size.x, view.size.y}},
      {"passes", std::move(passes)},
      {"resources", std::move(resources)},
      {"total_ms", frames.back()},
      {"frames_ms", frames},
      {"median_ms", warm[warm.size() / 2]},
      {"min_ms", warm.front()},
      {"max_error", boundOf(scene, view, gpuScene)},
  };
}

/// With the data's contents.
io::Session sessionToSave(const io::Study& study) {
  io::Session session = io::sessionOf(study);
  io::noteContents(session, progressOnTerminal());
  return session;
}

io::PngText prove(const RenderOptions& options, const Scene& scene, const View& view, const io::Session& session,
                  const std::vector<glm::vec4>& picture) {
  const reference::CertificateOptions sample{
      .pixels = *options.certify, .seed = options.certifySeed, .within = errorBound(view)};
  return io::proofOf(reference::certify(picture, scene, view, sample), session);
}

}  // namespace

void render(const RenderOptions& options) {
  const bool isPlaced = options.study.camera && std::holds_alternative<io::PlacedView>(*options.study.camera);
  std::optional<egl::EglContext> context;
  io::Study study = isPlaced || !options.reference ? readBesideContext(options.study, context)
                                                   : io::readStudy(options.study, progressOnTerminal());
  printWarnings(study.warnings);
  Scene scene = study.drawn.scene();
  View& view = *study.view;
  const auto gpuScene = context ? std::make_shared<GpuScene>() : nullptr;
  if (context) app::chooseSchedule(options.schedule, gpuScene, scene, view);
  if (study.placed) view.camera = placedCamera(options.study.source(), study, *gpuScene, *study.placed);
  io::Session session;
  if (!options.session.empty() || options.certify) session = sessionToSave(study);
  if (!options.session.empty()) io::writeSession(options.session, session);
  if (!options.look.empty()) io::writeLook(options.look, io::presetOf(options.look.stem().string(), study.scene));
  const bool second = study.placed == io::PlacedView::Dual;
  scene.look.strokes = strokesIn(second ? 1 : study.viewIndex, scene.look.strokes);
  if (options.reference) {
    const Layers layers = referenceLayers(scene, view);
    if (!options.layers.empty()) writeLayers(options.layers, layers, view, scene.volume->grid);
    if (!options.output.empty())
      io::writePng(options.output, view.size, 3, overBackground(layers.final, view.size, scene.look));
    return;
  }

  Renderer renderer(gpuScene);
  renderer.setTiming(!options.stats.empty());
  std::vector<std::uint8_t> picture;
  std::vector<double> frames;
  for (int frame = 0; frame < options.repeat; ++frame) {
    // An unchanged view would run no pass, so the eye moves by the smallest step of a double.
    if (frame > 0) view.camera.eye.x = std::nextafter(view.camera.eye.x, std::numeric_limits<double>::infinity());
    const auto start = std::chrono::steady_clock::now();
    renderer.render(scene, view);
    picture = renderer.readPicture();
    frames.push_back(millisecondsSince(start));
  }
  printReduction(*gpuScene);
  std::vector<io::PngText> proof;
  if (options.certify) {
    proof = {prove(options, scene, view, session, renderer.readLayers().final)};
    printJson(Json::parse(proof.front().text));
  }
  io::writePng(options.output, view.size, 3, withoutAlpha(picture), proof);
  if (!options.layers.empty()) writeLayers(options.layers, renderer.readLayers(), view, scene.volume->grid);
  if (!options.stats.empty())
    io::writeText(options.stats,
                  statistics(context->description(), scene, view, renderer, *gpuScene, frames).dump(2) + "\n");
}

}  // namespace fenestra::cli
