#include "viewer/model/Document.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "io/TransferFunctionFile.h"
#include "rendering/scene/Parallel.h"

namespace fenestra::viewer {
namespace {

/// Mean world position of the voxels that `belongs` accepts; empty when there is none. Runs on all cores.
template <class Belongs>
std::optional<glm::dvec3> middle(const Grid& grid, const Voxels& voxels, const Belongs& belongs) {
  const auto width = static_cast<std::size_t>(grid.dims.x), height = static_cast<std::size_t>(grid.dims.y);
  glm::dvec3 sum(0.0);
  std::size_t count = 0;
  std::mutex mutex;
  voxels.visit([&](auto scalars) {
    parallelFor(static_cast<std::size_t>(grid.dims.z), 1, [&](std::size_t begin, std::size_t end) {
      glm::dvec3 mySum(0.0);
      std::size_t mine = 0;
      for (std::size_t z = begin; z < end; ++z)
        for (std::size_t y = 0; y < height; ++y) {
          const auto row = scalars.subspan((z * height + y) * width, width);
          for (std::size_t x = 0; x < width; ++x)
            if (belongs(row[x])) {
              mySum += glm::dvec3(x, y, z);
              ++mine;
            }
        }
      const std::scoped_lock lock(mutex);
      sum += mySum;
      count += mine;
    });
  });
  if (count == 0) return std::nullopt;
  return glm::dvec3(grid.worldFromIndex() * glm::dvec4(sum / static_cast<double>(count), 1.0));
}

}  // namespace

void Document::open(Study study) {
  study_ = std::move(study);
  unshifted_ = scene().context;
  shift_ = 0.0;
  window_ = scene().volume->defaultWindow();
  Q_EMIT volumeChanged();
  Q_EMIT labelsChanged();
  Q_EMIT focusChanged();
  Q_EMIT transferFunctionChanged();
  Q_EMIT cutawayChanged();
  Q_EMIT windowChanged();
  Q_EMIT sceneChanged();
}

void Document::setLabels(std::shared_ptr<const LabelMap> labels) {
  study_.scene.labels = std::move(labels);
  const bool focusWasLabels = std::holds_alternative<LabelFocus>(study_.scene.focus);
  if (focusWasLabels) study_.scene.focus = std::monostate{};
  Q_EMIT labelsChanged();
  if (focusWasLabels) Q_EMIT focusChanged();
  Q_EMIT sceneChanged();
}

QString Document::description() const {
  if (!hasVolume()) return {};
  const Grid& grid = study_.scene.volume->grid;
  QString text = QStringLiteral("%1×%2×%3 · %4×%5×%6 mm")
                     .arg(grid.dims.x)
                     .arg(grid.dims.y)
                     .arg(grid.dims.z)
                     .arg(grid.spacing.x, 0, 'f', 2)
                     .arg(grid.spacing.y, 0, 'f', 2)
                     .arg(grid.spacing.z, 0, 'f', 2);
  const std::string& modality = study_.series.modality;
  if (!modality.empty()) return QString::fromStdString(modality) + QStringLiteral(" · ") + text;
  return text;
}

void Document::setWindow(WindowLevel window) {
  if (window == window_) return;
  window_ = window;
  Q_EMIT windowChanged();
}

void Document::resetWindow() {
  if (hasVolume()) setWindow(study_.scene.volume->defaultWindow());
}

void Document::setFocus(Focus focus) {
  if (focus == study_.scene.focus) return;
  study_.scene.focus = std::move(focus);
  Q_EMIT focusChanged();
  Q_EMIT sceneChanged();
}

void Document::focusOn(std::uint16_t label) { setFocus(LabelFocus{{label}}); }

void Document::setFocused(std::uint16_t label, bool focused) {
  std::vector<std::uint16_t> labels;
  if (const auto* current = std::get_if<LabelFocus>(&study_.scene.focus)) labels = current->labels;
  const auto at = std::lower_bound(labels.begin(), labels.end(), label);
  const bool present = at != labels.end() && *at == label;
  if (present == focused) return;
  if (focused)
    labels.insert(at, label);
  else
    labels.erase(at);
  if (labels.empty())
    setFocus(std::monostate{});
  else
    setFocus(LabelFocus{std::move(labels)});
}

bool Document::isFocused(std::uint16_t label) const {
  const auto* current = std::get_if<LabelFocus>(&study_.scene.focus);
  return current && std::binary_search(current->labels.begin(), current->labels.end(), label);
}

std::optional<glm::dvec3> Document::focusCentre() const {
  if (!hasVolume()) return std::nullopt;
  if (const auto* labels = std::get_if<LabelFocus>(&scene().focus)) {
    std::vector<bool> wanted(std::numeric_limits<std::uint16_t>::max() + std::size_t{1}, false);
    for (const std::uint16_t label : labels->labels) wanted[label] = true;
    return middle(scene().labels->grid, scene().labels->voxels,
                  [&](auto scalar) { return wanted[static_cast<std::uint16_t>(scalar)]; });
  }
  const auto* range = std::get_if<ValueFocus>(&scene().focus);
  if (!range) return std::nullopt;
  const Volume& volume = *scene().volume;
  return middle(volume.grid, volume.voxels, [&](auto scalar) {
    const double value = volume.slope * static_cast<double>(scalar) + volume.intercept;
    return value >= range->values.low && value <= range->values.high;
  });
}

void Document::setPreset(const std::string& presetOrPath) {
  unshifted_ = io::loadTransferFunction(presetOrPath, *study_.scene.volume);
  study_.transferFunction = presetOrPath;
  shift_ = 0.0;
  applyTransferFunction();
}

void Document::setShift(double shift) {
  if (shift == shift_) return;
  shift_ = shift;
  applyTransferFunction();
}

void Document::applyTransferFunction() {
  study_.scene.context = unshifted_;
  for (TransferFunction::Node& node : study_.scene.context.nodes) node.value += shift_;
  Q_EMIT transferFunctionChanged();
  Q_EMIT sceneChanged();
}

void Document::setCutaway(const Cutaway& cutaway) {
  if (cutaway == study_.scene.cutaway) return;
  study_.scene.cutaway = cutaway;
  Q_EMIT cutawayChanged();
  Q_EMIT sceneChanged();
}

void Document::setContextLayer(const ContextLayer& layer) {
  if (layer == study_.scene.contextLayer) return;
  study_.scene.contextLayer = layer;
  Q_EMIT cutawayChanged();
  Q_EMIT sceneChanged();
}

std::optional<glm::ivec3> Document::voxelAt(glm::dvec3 world) const {
  if (!hasVolume()) return std::nullopt;
  const Grid& grid = study_.scene.volume->grid;
  const glm::dvec3 index = glm::dvec3(grid.indexFromWorld() * glm::dvec4(world, 1.0));
  // Compared as real numbers first: a far point would overflow an int.
  for (int axis = 0; axis < 3; ++axis)
    if (!(index[axis] >= -0.5 && index[axis] < grid.dims[axis] - 0.5)) return std::nullopt;
  return glm::ivec3(glm::floor(index + 0.5));
}

const Label* Document::labelAt(glm::dvec3 world) const {
  if (!study_.scene.labels) return nullptr;
  const std::optional<glm::ivec3> voxel = voxelAt(world);
  return voxel ? study_.scene.labels->find(study_.scene.labels->value(*voxel)) : nullptr;
}

}  // namespace fenestra::viewer
