#include "viewer/model/Document.h"

#include <algorithm>
#include <utility>

#include "io/TransferFunctionFile.h"
#include "viewer/model/DocumentChanges.h"
#include "viewer/model/PathTube.h"

namespace fenestra::viewer {

void Document::open(io::Study study) {
  study_ = std::move(study);
  window_ = study_.session.window.value_or(study_.scene.volume->defaultWindow());
  inverted_ = study_.session.inverted;
  history_.clear();
  labelsRevision_ = filedRevision_ = ++lastRevision_;
  preview_ = {};
  grown_.clear();
  opened_.clear();
  if (study_.growth) {
    const auto& seeds = std::get<RegionFocus>(study_.scene.look.focus);
    auto facts = std::make_shared<const segmentation::GrowthFacts>(*study_.scene.volume, *study_.growth);
    opened_.push_back(seeds);  // a session shows what it showed
    grown_.push_back({{std::move(study_.growth), std::move(facts)}, seeds});
  }
  updateDrawn();
  reportAll();
}

void Document::close() {
  if (!hasVolume()) return;
  study_ = {};
  window_ = {};
  inverted_ = false;
  history_.clear();
  labelsRevision_ = filedRevision_ = ++lastRevision_;
  preview_ = {};
  grown_.clear();
  opened_.clear();
  reportAll();
}

void Document::reportAll() {
  // Listeners look measures up in the new volume, so those of the study before go first.
  measures_.clear();
  measured_.clear();
  Q_EMIT volumeChanged();
  showMeasures(study_.session.measures);
  showPath(study_.session.path);
  showKeyImages(study_.session.keyImages);
  Q_EMIT labelsChanged();
  Q_EMIT focusChanged();
  Q_EMIT transferFunctionChanged();
  Q_EMIT cutawayChanged();
  Q_EMIT shadingChanged();
  Q_EMIT clippingChanged();
  Q_EMIT strokesChanged();
  Q_EMIT removalsChanged();
  Q_EMIT windowChanged();
  Q_EMIT sceneChanged();
}

bool Document::updateDrawn() {
  const Focus focusBefore = study_.drawn.focus();
  const std::shared_ptr<const LabelMap> labelsBefore = study_.drawn.labels();
  const bool shows = showsGrowth();
  study_.drawn.update(study_.scene, shows ? growth() : nullptr);
  if (shows && isWhole()) {
    openedVolume_ = regionVolume();
    if (opened_.empty() || !segmentation::haveSameSeeds(opened_.back(), *region())) opened_.push_back(*region());
  }
  return study_.drawn.focus() != focusBefore || study_.drawn.labels() != labelsBefore;
}

void Document::show(Look look) {
  Look before = std::exchange(study_.scene.look, std::move(look));
  const bool showsOther = updateDrawn();
  const Look& now = this->look();
  const auto differs = [&](auto... members) { return ((now.*members != before.*members) || ...); };
  const bool focus = differs(&Look::focus, &Look::focusAppearance), labels = differs(&Look::labels);
  const bool context = differs(&Look::context), shading = differs(&Look::shading);
  const bool cutaway = differs(&Look::method, &Look::cutaway, &Look::contextLayer);
  const bool clipping = differs(&Look::clipping), removals = differs(&Look::removals);
  const bool strokes = differs(&Look::strokes);
  if (strokes) before.strokes = now.strokes;  // nothing else leaves 3-D pictures as they are
  if (!showsOther) before.focus = now.focus;  // a region that grows leaves the pictures as they are
  const bool scene = now != before;
  if (focus) Q_EMIT focusChanged();
  if (labels) Q_EMIT labelSettingsChanged();
  if (context) Q_EMIT transferFunctionChanged();
  if (cutaway) Q_EMIT cutawayChanged();
  if (shading) Q_EMIT shadingChanged();
  if (clipping) Q_EMIT clippingChanged();
  if (strokes) Q_EMIT strokesChanged();
  if (removals) Q_EMIT removalsChanged();
  if (scene) Q_EMIT sceneChanged();
}

void Document::edit(const QString& name, Look look) {
  Look before = this->look();
  show(std::move(look));
  history_.push(name, std::make_shared<LookChange>(parts(), std::move(before), this->look()));
}

void Document::noteContents(const io::Session& session) {
  if (session.volume.files == study_.session.volume.files) study_.session.volume.contents = session.volume.contents;
  if (session.labels.files == study_.session.labels.files) study_.session.labels.contents = session.labels.contents;
}

void Document::setLabels(std::shared_ptr<const LabelMap> labels, io::SessionLabels from) {
  study_.scene.labels = std::move(labels);
  study_.session.labels = std::move(from);
  labelsRevision_ = filedRevision_ = ++lastRevision_;
  updateDrawn();
  Q_EMIT labelsChanged();
  if (std::holds_alternative<LabelFocus>(focus()) || !look().labels.empty() || !clipping().exempt.empty()) {
    Look without = look();
    if (std::holds_alternative<LabelFocus>(focus())) without.focus = std::monostate{};
    without.labels.clear();
    without.clipping.exempt.clear();
    show(std::move(without));
  } else {
    Q_EMIT sceneChanged();
  }
  history_.clear();
}

void Document::showLabels(std::shared_ptr<const LabelMap> labels, std::uint64_t revision, Focus focus) {
  study_.scene.labels = std::move(labels);
  labelsRevision_ = revision;
  study_.scene.look.focus = std::move(focus);
  updateDrawn();
  Q_EMIT labelsChanged();
  Q_EMIT focusChanged();
  Q_EMIT sceneChanged();
}

void Document::editLabels(const QString& name, segmentation::LabelEdit edit, std::shared_ptr<const LabelMap> after,
                          Focus focus) {
  const LabelsChange::State before{labelsRevision_, this->focus()}, now{++lastRevision_, std::move(focus)};
  auto change = std::make_shared<LabelsChange>(parts(), std::move(edit), before, now);
  if (change->isNothing()) return;
  showLabels(std::move(after), now.revision, now.focus);
  history_.push(name, std::move(change));
}

void Document::noteLabelsFile(std::uint64_t revision, const io::SessionLabels& file) {
  filedRevision_ = revision;
  study_.session.labels = file;
}

QString Document::description() const {
  if (!hasVolume()) return {};
  const Grid& grid = study_.scene.volume->grid;
  QString text = tr("%1×%2×%3 · %4×%5×%6 mm")
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

void Document::setInverted(bool inverted) {
  if (inverted == inverted_) return;
  inverted_ = inverted;
  Q_EMIT windowChanged();
}

void Document::resetWindow() {
  setInverted(hasVolume() && study_.scene.volume->modality == Modality::PT);
  if (hasVolume()) setWindow(study_.scene.volume->defaultWindow());
}

void Document::setFocus(Focus focus) {
  Look changed = look();
  changed.focus = std::move(focus);
  edit(tr("Focus"), std::move(changed));
}

void Document::focusOn(std::uint16_t label) { setFocus(LabelFocus{{label}}); }

void Document::setFocused(std::uint16_t label, bool focused) {
  std::vector<std::uint16_t> labels;
  if (const auto* current = std::get_if<LabelFocus>(&focus())) labels = current->labels;
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
  const auto* current = std::get_if<LabelFocus>(&focus());
  return current && std::binary_search(current->labels.begin(), current->labels.end(), label);
}

void Document::setLabelSetting(const LabelSetting& setting, const QString& name) {
  Look changed = look();
  put(changed.labels, setting);
  edit(name, std::move(changed));
}

std::optional<LabelRole> Document::roleOf(std::uint16_t label) const {
  if (isFocused(label)) return std::nullopt;
  return labelSetting(label).role;
}

void Document::setRole(std::uint16_t label, std::optional<LabelRole> role) {
  if (role == roleOf(label)) return;
  Look changed = look();
  LabelFocus focus;
  if (const auto* current = std::get_if<LabelFocus>(&changed.focus)) focus = *current;
  const auto at = std::lower_bound(focus.labels.begin(), focus.labels.end(), label);
  if (!role)
    focus.labels.insert(at, label);
  else if (isFocused(label))
    focus.labels.erase(at);
  if (!role || isFocused(label)) changed.focus = focus.labels.empty() ? Focus() : Focus(std::move(focus));
  LabelSetting setting = settingFor(changed.labels, label);
  setting.role = role.value_or(LabelRole::Context);
  put(changed.labels, setting);
  edit(tr("Role"), std::move(changed));
}

void Document::renameLabel(std::uint16_t label, const QString& name) {
  segmentation::LabelEdit change = segmentation::renamed(*labels(), label, name.toStdString());
  if (change.after.labels == change.before.labels) return;
  std::shared_ptr<const LabelMap> after = change.applied(labels().get());
  editLabels(tr("Rename"), std::move(change), std::move(after), focus());
}

void Document::setPreset(const std::string& presetOrPath) {
  Look changed = look();
  changed.context = io::loadContextFunction(presetOrPath, *study_.scene.volume);
  edit(tr("Transfer function"), std::move(changed));
}

std::string Document::preset() const {
  const ContextFunction& context = look().context;
  return context.file.empty() ? context.preset : context.file.string();
}

void Document::setShift(double shift) {
  Look changed = look();
  changed.context.shift = shift;
  edit(tr("Shift"), std::move(changed));
}

void Document::setClipping(Clipping clipping, const QString& name) {
  if (clipping == this->clipping()) return;
  Look changed = look();
  changed.clipping = std::move(clipping);
  edit(name, std::move(changed));
}

void Document::setExempt(std::uint16_t label, bool exempt) {
  Clipping changed = clipping();
  std::erase(changed.exempt, label);
  if (exempt) changed.exempt.insert(std::lower_bound(changed.exempt.begin(), changed.exempt.end(), label), label);
  setClipping(std::move(changed), tr("Never clipped"));
}

void Document::setStrokes(BrushStrokes strokes, const QString& name) {
  Look changed = look();
  changed.strokes = std::move(strokes);
  edit(name, std::move(changed));
}

void Document::setRemovals(Removals removals, const QString& name) {
  if (removals == this->removals()) return;
  Look changed = look();
  changed.removals = std::move(removals);
  edit(name, std::move(changed));
}

void Document::showMeasures(std::vector<Measure> measures) {
  measures_ = std::move(measures);
  measured_.clear();
  for (const Measure& each : measures_) measured_.push_back(valuesOf(each, *study_.scene.volume));
  Q_EMIT measuresChanged();
}

void Document::setMeasures(std::vector<Measure> measures, const QString& name) {
  std::vector<Measure> before = measures_;
  showMeasures(std::move(measures));
  history_.push(name, std::make_shared<MeasuresChange>(parts(), std::move(before), measures_));
}

void Document::showPath(std::vector<glm::dvec3> path) {
  if (path == path_) return;
  path_ = std::move(path);
  Q_EMIT pathChanged();
}

void Document::setPath(std::vector<glm::dvec3> path, const QString& name) {
  PathChange::State before{path_}, after{std::move(path)};
  if (const std::optional<double> radius = tubeRadius(focus(), path_)) {
    before.focus = focus();
    after.focus = after.path.empty() ? Focus() : tubeAround(after.path, *radius);
  }
  auto change = std::make_shared<PathChange>(parts(), std::move(before), std::move(after));
  if (change->isNothing()) return;
  change->redo();
  history_.push(name, std::move(change));
}

void Document::showKeyImages(std::vector<io::KeyImage> images) {
  if (images.empty() && keyImages_.empty()) return;
  keyImages_ = std::move(images);
  Q_EMIT keyImagesChanged();
}

void Document::setKeyImages(std::vector<io::KeyImage> images, const QString& name) {
  std::vector<io::KeyImage> before = keyImages_;
  showKeyImages(std::move(images));
  history_.push(name, std::make_shared<KeyImagesChange>(parts(), std::move(before), keyImages_));
}

std::optional<glm::ivec3> Document::voxelAt(glm::dvec3 world) const {
  return hasVolume() ? segmentation::voxelAt(study_.scene.volume->grid, world) : std::nullopt;
}

const Label* Document::labelAt(glm::dvec3 world) const {
  if (!labels()) return nullptr;
  const std::optional<glm::ivec3> voxel = voxelAt(world);
  return voxel ? labels()->find(labels()->value(*voxel)) : nullptr;
}

}  // namespace fenestra::viewer
