#include "rendering/gpu/GpuScene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <iomanip>
#include <limits>
#include <sstream>

#include "rendering/gpu/PreIntegration.h"
#include "rendering/gpu/TransferTables.h"
#include "rendering/volume/Threads.h"

namespace fenestra {
namespace {

/// Opacity of 1 mm above which the context counts as there (method: ε).
constexpr double contextThreshold = 1.0 / 255.0;

/// Entry = coded value · x + y in tables over `span`.
glm::vec2 tableMap(ValueRange span, const VolumeTexture& coding) {
  const double perReal = (GpuScene::tableSize - 1) / (span.high - span.low);
  return glm::vec2(coding.slope * perReal, (coding.offset - span.low) * perReal);
}

/// What labels of the focus are shown as.
struct PaletteEntry {
  glm::vec4 colour{0.0f};   ///< and opacity
  glm::vec4 table{0.0f};    ///< see GpuScene::focusTable
  std::uint16_t label = 0;  ///< of a translucent one: its bodies are its own
  bool operator==(const PaletteEntry&) const = default;
};

/// How the labels in focus are shown; those that are shown as they come are left out.
LabelSettings settingsInFocus(const Scene& scene) {
  LabelSettings settings;
  const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
  if (!focus || !focusesStructures(scene)) return settings;
  for (const LabelSetting& each : scene.look.labels)
    if (std::binary_search(focus->labels.begin(), focus->labels.end(), each.label)) settings.push_back(each);
  return settings;
}

}  // namespace

void GpuScene::update(const Scene& scene, Use use) {
  if (!schedule_) schedule_ = usualSchedule();
  if (fitted_.isOfOther(scene)) {
    release();  // first: two volumes may not fit, and the driver is asked how much is free
    const DeviceLimits limits = limits_ ? *limits_ : deviceLimits();
    fitted_.take(scene, limits);
    chooseRefinement(scene, limits);
  }
  std::exception_ptr first;
  for (;;) try {
      updateAll(fitted_.of(scene), use);
      labelSource_ = scene.labels;
      return;
    } catch (const gl::AllocationError&) {
      // The first error names the size that the user can do something about.
      if (!first) first = std::current_exception();
      release();
      if (refinement_ > 1) {
        refinement_ = 1;
        continue;
      }
      if (!fitted_.coarsen()) std::rethrow_exception(first);
    }
}

void GpuScene::chooseRefinement(const Scene& scene, const DeviceLimits& limits) {
  refinement_ = 1;
  refusedBytes_ = 0;
  if (reconstructionOf(scene) == Reconstruction::Linear) return;
  const glm::ivec3 dims = scene.volume->grid.dims;
  const std::size_t bytes = refinedBytes(*scene.volume, splineRefinement, scene.look.shading.enabled);
  const bool fits = fitted_.factor() == glm::ivec3(1) && (!limits.bytes || bytes <= *limits.bytes) &&
                    std::max({dims.x, dims.y, dims.z}) * splineRefinement <= limits.side;
  refinement_ = fits ? splineRefinement : 1;
  if (!fits) refusedBytes_ = bytes;
}

std::vector<OctantMask> GpuScene::drawnOccupied(const FocusIndex& focus) const {
  std::vector<OctantMask> occupied =
      refinement_ > 1 ? refinedOccupied(focus, grid().dims, refinement_) : focus.occupied();
  for (OctantMask& brick : occupied) brick = brick ? wholeBrick : 0;
  return occupied;
}

bool GpuScene::holds(const Scene& scene, bool occlusion) const {
  if (!peeler_.knows(scene)) return false;
  const auto peeled = peeler_.known(scene);
  return holdsAsDrawn(peeled ? peeled->scene : scene, occlusion);
}

bool GpuScene::holdsAsDrawn(const Scene& scene, bool occlusion) const {
  if (!shown_.volume || fitted_.isOfOther(scene) || scene.look.focus != focusWanted_) return false;
  if (std::holds_alternative<LabelFocus>(scene.look.focus) &&
      (scene.labels != labelSource_ || scene.look.labelSmoothing != labelSmoothing_))
    return false;
  const bool wantsDerivative = readsContextSurface(scene);
  return (gradient_.texture || !scene.look.shading.enabled) && (derivative_.texture || !wantsDerivative) &&
         (!occlusion || !hasOcclusion(scene.look) || occluders_.isOf(occludersKey(scene))) &&
         (focalDistances_.any() || !fadesByDistance(scene.look));
}

Occluders::Key GpuScene::occludersKey(const Scene& scene) const {
  const Versions& v = versions_;
  return {v.volume,          v.focus,        v.transfer,   v.palette,
          v.protectedLabels, v.exemptLabels, v.importance, scene.look.focusAppearance.extinction};
}

gl::ShaderProgram& GpuScene::presentation(bool enlarged) {
  gl::ShaderProgram& program = enlarged ? enlargeProgram_ : presentProgram_;
  if (!program)
    program = gl::ShaderProgram::graphics("Present.vert", enlarged ? "PresentEnlarged.frag" : "Present.frag");
  return program;
}

std::string GpuScene::reductionNotice() const {
  const glm::ivec3 factor = fitted_.factor();
  if (factor == glm::ivec3(1) && refusedBytes_ > 0) {
    std::ostringstream gigabytes;
    gigabytes << std::fixed << std::setprecision(1) << static_cast<double>(refusedBytes_) / 1e9;
    return "3-D pictures are made with straight lines between the voxels, because smooth curves would take " +
           gigabytes.str() + " GB of memory for so many voxels; cut the volume down or resample it for those";
  }
  if (factor == glm::ivec3(1)) return {};
  return "3-D pictures show " + std::to_string(factor.x) + "×" + std::to_string(factor.y) + "×" +
         std::to_string(factor.z) + " voxels as one, because the whole volume does not fit into this machine's " +
         "graphics memory or 3-D textures; slices show every voxel";
}

void GpuScene::release() {
  shown_ = {};
  spline_ = {};
  coefficients_ = {};
  normalCoefficients_ = {};
  volumeTexture_ = {};
  gradient_ = {};
  derivative_ = {};
  for (gl::Texture* texture : {&contextSkip_, &occupiedSkip_, &focusSkip_, &focusPaletteIndex_, &focusPalette_})
    *texture = {};
  focus_.release();
  protected_ = {};
  exempt_ = {};
  importance_.clear();
  occluders_.release();
  focalDistances_.release();
  faint_.release();
  faintLabels_ = {};
  faintOpacities_ = {};
  paletteMap_ = {};
}

void GpuScene::updateAll(const Scene& scene, Use use) {
  ShownVolume shown = shownVolume(scene);
  const bool volumeChanged = shown != shown_;
  if (volumeChanged) updateVolume(std::move(shown));

  const bool contextChanged = updateContext(scene);

  // A label map matters only while its labels are in focus.
  const bool usesLabels = std::holds_alternative<LabelFocus>(scene.look.focus);
  const bool focusChanged = volumeChanged || scene.look.focus != focusWanted_ ||
                            (usesLabels && (scene.labels != labels_ || scene.look.labelSmoothing != labelSmoothing_));
  LabelSettings focusSettings = settingsInFocus(scene);
  const bool coloursChanged =
      focusChanged || !transferTables_ || scene.look.focusAppearance != appearance_ || focusSettings != focusSettings_;
  labels_ = usesLabels ? scene.labels : nullptr;
  const GpuFocus::Change changed = focusChanged ? updateFocus(scene) : GpuFocus::Change{};
  const std::size_t focusFunctions = focusFunctions_.size();
  if (coloursChanged) updateFocusColours(scene);
  appearance_ = scene.look.focusAppearance;
  focusSettings_ = std::move(focusSettings);

  updateKeptLabels(scene, volumeChanged);

  const bool transferChanged = volumeChanged || contextChanged || focusFunctions_.size() != focusFunctions;
  const bool occupancyChanged = transferChanged && updateTransfer();
  updateSkips(changed, occupancyChanged);

  updateLight(scene, use, changed, occupancyChanged);
  const bool wantsDerivative = readsContextSurface(scene);
  if (!wantsDerivative) derivative_ = {};
  if (wantsDerivative && !derivative_.texture && use != Use::FirstHits) {
    derivative_ = makeDerivativeVolume(shown_);
    ++versions_.derivative;
  }
}

void GpuScene::updateLight(const Scene& scene, Use use, const GpuFocus::Change& focus, bool occupancyChanged) {
  const auto mayMake = [use](bool isThere) { return use != Use::FirstHits || isThere; };
  const bool isLit = scene.look.shading.enabled;
  if (!isLit) gradient_ = {};
  if (!isLit) normalCoefficients_ = {};
  if (isLit && mayMake(static_cast<bool>(gradient_.texture))) updateGradient(focus, occupancyChanged);
  focus_.updateSmooth(isLit && mayMake(static_cast<bool>(focus_.smooth())));
  if ((use == Use::Pictures || !hasOcclusion(scene.look)) &&
      occluders_.update(scene, focus_.index(), occludersKey(scene)))
    ++versions_.occluders;
  if (mayMake(focalDistances_.any())) focalDistances_.update(scene, {versions_.volume, versions_.focus});
}

void GpuScene::updateVolume(ShownVolume shown) {
  release();
  if (refinement_ > 1) {
    spline_.emplace(shown);
    const ShownVolume samples{refinedVolume(*shown.volume, *spline_, refinement_)};
    together(
        [&] {
          volumeTexture_ = makeVolumeTexture(samples);
          coefficients_ = makeCoefficients(*spline_, volumeTexture_);
        },
        [&] {
          bricks_ = brickRanges(samples, WithOctants::No);  // those would have to be widened, too
          widen(bricks_, *samples.volume);
          voxelBricks_ = brickRanges(shown, WithOctants::No);  // rays leap by those of the drawn grid
        });
  } else {
    together([&] { volumeTexture_ = makeVolumeTexture(shown); }, [&] { bricks_ = brickRanges(shown); });
    voxelBricks_ = {};
  }
  shown_ = std::move(shown);
  ++versions_.volume;
}

void GpuScene::updateSkips(const GpuFocus::Change& focus, bool occupancyChanged) {
  if (focus_.index().kind == FocusIndex::Kind::None) return;
  struct Skip {
    gl::Texture& texture;
    std::vector<OctantMask> occupied;
    std::vector<std::uint16_t> texels;
  };
  std::vector<Skip> skips;
  const bool focusFlipped = focus.isNew || !focus.flipped.empty();
  std::vector<OctantMask> inFocus;
  if (focusFlipped || occupancyChanged) inFocus = drawnOccupied(focus_.index());
  if (focusFlipped) skips.push_back({focusSkip_, inFocus, {}});
  const bool anyFlipped = focus.isNew || occupancyChanged || (focusFlipped && refinement_ > 1) ||
                          std::any_of(focus.flipped.begin(), focus.flipped.end(),
                                      [&](std::size_t brick) { return contextOccupied_[brick] != wholeBrick; });
  if (anyFlipped) {
    std::vector<OctantMask> occupied = std::move(inFocus);
    for (std::size_t i = 0; i < occupied.size(); ++i) occupied[i] |= contextOccupied_[i];
    skips.push_back({occupiedSkip_, std::move(occupied), {}});
  }
  parallelFor(skips.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) skips[i].texels = skipTexels(bricks_.dims, skips[i].occupied);
  });
  for (const Skip& skip : skips) {
    if (!skip.texture) skip.texture = gl::Texture::make3D(gl::Format::R16UI, bricks_.dims);
    skip.texture.upload(std::span<const std::uint16_t>(skip.texels));
  }
}

GpuFocus::Change GpuScene::updateFocus(const Scene& scene) {
  GpuFocus::Change change = focus_.update(scene, refinement_ > 1 ? voxelBricks_ : bricks_);
  focusWanted_ = scene.look.focus;
  labelSmoothing_ = scene.look.labelSmoothing;
  if (change.isNew)
    for (gl::Texture* texture : {&focusSkip_, &occupiedSkip_}) *texture = {};
  ++versions_.focus;
  return change;
}

void GpuScene::updateFocusColours(const Scene& scene) {
  ++versions_.palette;
  focusPalette_ = {};
  focusColour_ = glm::vec3(scene.look.focusAppearance.colour);
  focusIsTranslucent_ = false;
  // The voxels' entries depend on the labels and on which of them share a material, not on the materials.
  gl::Texture index = std::exchange(focusPaletteIndex_, {});
  focusTable_ = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
  std::vector<TransferFunction> functions;
  const auto tableOf = [&](const TransferFunction& function) {
    auto at = std::find(functions.begin(), functions.end(), function);
    if (at == functions.end()) at = functions.insert(at, function);
    const glm::vec2 map = tableMap(tableSpan(function, shown_.volume->range, tableSize), volumeTexture_);
    return glm::vec4(rowsPerFunction * (1 + (at - functions.begin())), map, 1.0f);
  };
  if (std::holds_alternative<ValueFocus>(scene.look.focus))
    if (const auto& function = focusFunction(scene)) focusTable_ = tableOf(*function);

  // Palette entry per label value; one for all needs no texture.
  std::vector<PaletteEntry> palette;
  std::vector<std::uint8_t> entryOf(1 << 16, 0);
  const auto* focus = std::get_if<LabelFocus>(&scene.look.focus);
  if (focus && scene.labels)
    for (const std::uint16_t value : focus->labels) {
      const DrawnInFocus drawn = drawnInFocus(scene, value);
      PaletteEntry entry;
      if (drawn.function)
        entry.table = tableOf(*drawn.function);
      else
        entry.colour = glm::vec4(glm::vec3(drawn.material.colour), 0.0f);
      entry.colour.a = entry.table.w = static_cast<float>(drawn.opacity);
      if (drawn.opacity < 1.0) entry.label = value;
      focusIsTranslucent_ |= drawn.opacity < 1.0;
      auto at = std::find(palette.begin(), palette.end(), entry);
      // Entry 0 is "no label"; beyond 254 colours the last one serves for the rest.
      if (at == palette.end() && palette.size() < 254) at = palette.insert(palette.end(), entry);
      entryOf[value] = static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(at - palette.begin(), 253) + 1);
    }
  updateFocusTables(std::move(functions));
  if (palette.empty()) return;
  focusColour_ = glm::vec3(palette.front().colour);
  focusTable_ = palette.front().table;
  if (palette.size() < 2 || !focus_.index().box) return;
  palette.insert(palette.begin(), palette.front());
  std::vector<glm::vec4> texels;
  for (const PaletteEntry& entry : palette) texels.push_back(entry.colour);
  if (focusByValue())
    for (const PaletteEntry& entry : palette) texels.push_back(entry.table);
  focusPalette_ = gl::Texture::make2D(
      gl::Format::RGBA32F, {static_cast<int>(palette.size()), static_cast<int>(texels.size() / palette.size())});
  focusPalette_.upload(std::span<const glm::vec4>(texels));
  if (index && scene.labels == paletteMap_ && entryOf == paletteEntries_) {
    focusPaletteIndex_ = std::move(index);
    return;
  }
  index = {};
  makePaletteIndex(*scene.labels, entryOf);
  paletteMap_ = scene.labels;
  paletteEntries_ = std::move(entryOf);
}

void GpuScene::updateFocusTables(std::vector<TransferFunction> functions) {
  const std::vector<TransferFunction> before = std::exchange(focusFunctions_, std::move(functions));
  // A texture of other rows is made with the context's table.
  if (!transferTables_ || focusFunctions_.size() != before.size() || focusFunctions_ == before) return;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (focusFunctions_[i] != before[i]) uploadFocusTable(i);
  updateSegments();
}

void GpuScene::uploadFocusTable(std::size_t i) {
  const TransferFunction& function = focusFunctions_[i];
  uploadTables(TransferTables(function, tableSpan(function, shown_.volume->range, tableSize), tableSize), 1 + i);
}

void GpuScene::uploadTables(const TransferTables& tables, std::size_t function) {
  int row = rowsPerFunction * static_cast<int>(function);
  for (const auto* texels : {&tables.properties, &tables.integrals})
    transferTables_.upload({0, row++, 0}, {tableSize, 1, 1}, std::as_bytes(std::span(*texels)));
}

void GpuScene::updateSegments() {
  const auto segmentsOf = [&](const TransferFunction& function) {
    const ValueRange span = tableSpan(function, shown_.volume->range, tableSize);
    // Equal values stay equal where they are interpolated, but for a unit in the last place or two; the map and its
    // float32 factors add four roundings of half a unit, 2^-24, of the terms that it adds.
    const double terms = tableSize + std::abs(tableMap(span, volumeTexture_).y);
    return TransferSegments(function, span, tableSize, std::ldexp(8.0 * terms, -24));
  };
  TransferSegments all = segmentsOf(context_);
  for (const TransferFunction& function : focusFunctions_) all.append(segmentsOf(function));
  transferSegments_ = all.texture(segmentsPerRow);
  segmentOfEntry_ = gl::Buffer(std::as_bytes(std::span(all.ofEntry)));
}

bool GpuScene::updateContext(const Scene& scene) {
  FaintLabels faint = faintLabels(scene);
  const bool indexChanged = faint_.update(faint, structuresOf(scene));
  if (!faint_.any()) faint = {};
  const FaintLabels before = std::exchange(faintLabels_, std::move(faint));
  const TransferFunction function = std::exchange(context_, scene.look.context.shifted());
  if (indexChanged) gaps_.clear();
  if (faintLabels_ != before) updateFaintOpacities();
  return indexChanged || faintLabels_ != before || context_ != function;
}

void GpuScene::updateFaintOpacities() {
  faintOpacities_ = {};
  if (!faintLabels_.any()) return;
  std::vector<float> texels;
  for (std::size_t number = 0; number <= faintLabels_.opacities.size(); ++number)
    texels.push_back(static_cast<float>(faintLabels_.opacityOf(number)));
  faintOpacities_ = gl::Texture::make2D(gl::Format::R32F, {static_cast<int>(texels.size()), 1});
  faintOpacities_.upload(std::span<const float>(texels));
}

void GpuScene::updateGaps() {
  // Hit points depend on these alone, so a change of colour leaves them valid.
  std::vector<double> thresholds;
  for (std::size_t number = 0; number <= faintLabels_.opacities.size(); ++number)
    thresholds.push_back(std::min(contextThreshold / faintLabels_.opacityOf(number), 1.0));
  std::vector<glm::vec2> gaps = codedGaps(context_, thresholds, volumeTexture_);
  if (gaps == gaps_ && gapBuffer_) return;
  gaps_ = std::move(gaps);
  gapBuffer_ = gl::Buffer(std::as_bytes(std::span(gaps_)));
  ++versions_.gaps;
}

bool GpuScene::updateTransfer() {
  ++versions_.transfer;
  preIntegration_ = {};
  updateGaps();
  const ValueRange span = tableSpan(context_, shown_.volume->range, tableSize);
  const TransferTables tables(context_, span, tableSize);
  const int rows = rowsPerFunction * static_cast<int>(1 + focusFunctions_.size());
  if (!transferTables_ || transferTables_.size().y != rows) {
    transferTables_ = gl::Texture::make2D(gl::Format::RGBA32F, {tableSize, rows});
    for (std::size_t i = 0; i < focusFunctions_.size(); ++i) uploadFocusTable(i);
  }
  uploadTables(tables, 0);
  updateSegments();
  firstMaterial_ = tables.properties.front();
  lastMaterial_ = tables.properties.back();
  visibleEntries_ = tables.visible();
  transferMap_ = tableMap(span, volumeTexture_);

  return updateOccupancy();
}

const gl::Texture& GpuScene::preIntegration() const {
  if (preIntegration_) return preIntegration_;
  const glm::dmat3 cell(drawnGrid().worldFromIndex());
  double longest = 0.0;
  for (const glm::dvec3 diagonal : {glm::dvec3(1, 1, 1), {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}})
    longest = std::max(longest, glm::length(cell * diagonal));
  const PreIntegration made(context_, tableSpan(context_, shown_.volume->range, tableSize), tableSize, longest);
  preIntegration_ = made.texture();
  preIntegrationLevel_ = made.firstLevel;
  return preIntegration_;
}

bool GpuScene::updateOccupancy() {
  // Exactly: a brick whose values reach no further than the node where opacity begins stays empty, although the tables,
  // which are read to the nearest entry, may show a little there.
  const std::vector<ValueRange> empty = context_.emptyRanges();
  const auto isEmpty = [&](const ValueRange& values) {
    return std::any_of(empty.begin(), empty.end(),
                       [&](const ValueRange& range) { return values.low >= range.low && values.high <= range.high; });
  };
  std::vector<OctantMask> occupied(bricks_.ranges.size());
  constexpr std::size_t worthAThread = 1 << 16;
  parallelFor(occupied.size(), worthAThread, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const ValueRange& brick = bricks_.ranges[i];
      occupied[i] = isEmpty(brick) ? 0 : wholeBrick;
      if (occupied[i] == 0 || bricks_.octants.empty()) continue;
      for (std::size_t octant = 0; octant < 8; ++octant)
        if (isEmpty(rangeOf(bricks_.octants[i], octant, brick)))
          occupied[i] &= static_cast<OctantMask>(~(1u << octant));
    }
  });
  if (occupied == contextOccupied_ && contextSkip_ && contextSkip_.size() == bricks_.dims) return false;
  contextOccupied_ = std::move(occupied);
  contextSkip_ = gl::Texture::make3D(gl::Format::R16UI, bricks_.dims);
  contextSkip_.upload(std::span<const std::uint16_t>(skipTexels(bricks_.dims, contextOccupied_)));
  return true;
}

std::vector<GpuScene::Resource> GpuScene::resources() const {
  std::vector<Resource> all;
  const auto add = [&](const char* name, std::size_t bytes) {
    if (bytes > 0) all.push_back({name, bytes});
  };
  const auto of = [](const gl::Texture& texture) { return texture ? texture.bytes() : 0; };
  add("volume", of(volumeTexture_.texture));
  add("spline", of(coefficients_) + of(normalCoefficients_));
  add("gradient", of(gradient_.texture));
  add("derivative volume", of(derivative_.texture));
  add("pre-integration", of(preIntegration_));
  add("transfer tables", of(transferTables_) + of(transferSegments_) + segmentOfEntry_.bytes());
  add("empty-space skipping", of(contextSkip_) + of(occupiedSkip_) + of(focusSkip_));
  add("faint labels",
      of(faint_.texture()) + of(faintOpacities_) + of(protected_.faint.texture()) + of(exempt_.faint.texture()));
  add("focus index", of(focus_.bricks()) + focus_.cells().bytes());
  add("focus palette", of(focusPaletteIndex_) + of(focusPalette_));
  add("focus normals", of(focus_.smooth()));
  add("protected labels", of(protected_.bricks) + of(protected_.skip) + protected_.cells.bytes());
  add("occluders", occluders_.bytes());
  add("distances to the focus", focalDistances_.bytes());
  std::size_t important = 0;
  for (const KeptLabels& each : importance_) important += of(each.bricks) + of(each.skip) + each.cells.bytes();
  add("levels of importance", important);
  add("exempt labels", of(exempt_.bricks) + of(exempt_.skip) + exempt_.cells.bytes());
  return all;
}

}  // namespace fenestra
