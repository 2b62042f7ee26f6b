#include "viewer/model/Document.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "io/TransferFunctionFile.h"

namespace fenestra::viewer {
namespace {

/// Bytes that the growths of regions may hold together; the latest stays whatever its size. A growth has one a voxel.
constexpr std::size_t mostGrownBytes = std::size_t{256} << 20;

}  // namespace

/// From one look to another. Of the strokes only those are kept that differ: everything between what both lists begin
/// with and what both end with.
class Document::LookChange : public Change {
 public:
  LookChange(Document& document, Look before, Look after)
      : document_(document), before_(std::move(before)), after_(std::move(after)) {
    BrushStrokes &old = before_.strokes, &now = after_.strokes;
    const auto [oldEnd, nowEnd] = std::mismatch(old.begin(), old.end(), now.begin(), now.end());
    firstStroke_ = static_cast<std::size_t>(oldEnd - old.begin());
    const auto last =
        std::mismatch(old.rbegin(), std::reverse_iterator(oldEnd), now.rbegin(), std::reverse_iterator(nowEnd));
    old = {oldEnd, last.first.base()};
    now = {nowEnd, last.second.base()};
  }

  void undo() override { document_.show(replaced(document_.look(), after_, before_)); }
  void redo() override { document_.show(replaced(document_.look(), before_, after_)); }

  bool absorb(const Change& next) override {
    const auto& later = static_cast<const LookChange&>(next);
    const Look& now = document_.look();
    // Each finds its strokes at its own place.
    const Look between = later.replaced(now, later.after_, later.before_);
    *this = LookChange(document_, replaced(between, after_, before_), now);
    return true;
  }
  bool isNothing() const override { return before_ == after_; }

  std::size_t bytes() const override { return sizeof(*this) + heldBy(before_) + heldBy(after_); }

 private:
  LookChange& operator=(LookChange&& other) noexcept {
    before_ = std::move(other.before_);
    after_ = std::move(other.after_);
    firstStroke_ = other.firstStroke_;
    return *this;
  }

  /// `whole`, which is `from` with all its strokes, as `to`.
  Look replaced(const Look& whole, const Look& from, const Look& to) const {
    Look result = to;
    const auto begin = whole.strokes.begin() + static_cast<std::ptrdiff_t>(firstStroke_);
    result.strokes.insert(result.strokes.begin(), whole.strokes.begin(), begin);
    result.strokes.insert(result.strokes.end(), begin + static_cast<std::ptrdiff_t>(from.strokes.size()),
                          whole.strokes.end());
    return result;
  }

  static std::size_t heldBy(const std::vector<SelectionStroke>& strokes) {
    std::size_t bytes = strokes.capacity() * sizeof(SelectionStroke);
    for (const SelectionStroke& stroke : strokes) bytes += stroke.anchors.capacity() * sizeof(glm::dvec3);
    return bytes;
  }

  static std::size_t heldBy(const Look& look) {
    const ContextFunction& context = look.context;
    std::size_t bytes =
        look.labels.capacity() * sizeof(LabelSetting) + context.preset.capacity() + context.file.native().capacity() +
        context.function.nodes.capacity() * sizeof(TransferFunction::Node) +
        look.strokes.capacity() * sizeof(BrushStroke) + look.clipping.planes.capacity() * sizeof(HalfSpace) +
        look.clipping.exempt.capacity() * sizeof(std::uint16_t);
    for (const BrushStroke& stroke : look.strokes) bytes += stroke.anchors.capacity() * sizeof(glm::dvec3);
    bytes += look.removals.capacity() * sizeof(Removal);
    for (const Removal& removal : look.removals)
      bytes += removal.points.capacity() * sizeof(glm::dvec3) + removal.bends.capacity() * sizeof(Bend);
    if (const auto* focus = std::get_if<LabelFocus>(&look.focus))
      bytes += focus->labels.capacity() * sizeof(focus->labels[0]);
    if (const auto* focus = std::get_if<RegionFocus>(&look.focus))
      bytes += (focus->inside.capacity() + focus->outside.capacity()) * sizeof(glm::dvec3) + heldBy(focus->painted);
    return bytes;
  }

  Document& document_;
  Look before_, after_;
  std::size_t firstStroke_ = 0;  ///< place of the first that differs
};

/// From one label map to another, and from one focus to another.
class Document::LabelsChange : public Change {
 public:
  struct State {
    std::uint64_t revision;
    Focus focus;
  };
  LabelsChange(Document& document, segmentation::LabelEdit edit, State before, State after)
      : document_(document), edit_(std::move(edit)), before_(std::move(before)), after_(std::move(after)) {}

  void undo() override {
    document_.showLabels(edit_.reverted(document_.labels().get()), before_.revision, before_.focus);
  }
  void redo() override { document_.showLabels(edit_.applied(document_.labels().get()), after_.revision, after_.focus); }
  bool absorb(const Change&) override { return false; }
  bool isNothing() const override { return edit_.runs.empty() && edit_.before.labels == edit_.after.labels; }
  std::size_t bytes() const override { return sizeof(*this) + edit_.bytes(); }

 private:
  Document& document_;
  segmentation::LabelEdit edit_;
  State before_, after_;
};

/// From one list of measures to another.
class Document::MeasuresChange : public Change {
 public:
  MeasuresChange(Document& document, std::vector<Measure> before, std::vector<Measure> after)
      : document_(document), before_(std::move(before)), after_(std::move(after)) {}

  void undo() override { document_.showMeasures(before_); }
  void redo() override { document_.showMeasures(after_); }
  bool absorb(const Change& next) override {
    after_ = static_cast<const MeasuresChange&>(next).after_;
    return true;
  }
  bool isNothing() const override { return before_ == after_; }
  std::size_t bytes() const override { return sizeof(*this) + heldBy(before_) + heldBy(after_); }

 private:
  static std::size_t heldBy(const std::vector<Measure>& measures) {
    std::size_t bytes = measures.capacity() * sizeof(Measure);
    for (const Measure& each : measures) bytes += each.points.capacity() * sizeof(each.points[0]);
    return bytes;
  }

  Document& document_;
  std::vector<Measure> before_, after_;
};

void Document::open(io::Study study) {
  study_ = std::move(study);
  window_ = study_.session.window.value_or(study_.scene.volume->defaultWindow());
  inverted_ = study_.session.inverted;
  history_.clear();
  labelsRevision_ = filedRevision_ = ++lastRevision_;
  preview_ = {};
  grown_.clear();
  if (study_.growth) grown_.push_back({std::get<RegionFocus>(study_.scene.look.focus), std::move(study_.growth)});
  updateDrawn();
  Q_EMIT volumeChanged();
  showMeasures(study_.session.measures);
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

void Document::updateDrawn() { study_.drawn.update(study_.scene, growth()); }

void Document::show(Look look) {
  const Look before = std::exchange(study_.scene.look, std::move(look));
  updateDrawn();
  const Look& now = this->look();
  const bool focus = now.focus != before.focus || now.focusAppearance != before.focusAppearance;
  const bool context = now.context != before.context;
  const bool cutaway =
      now.method != before.method || now.cutaway != before.cutaway || now.contextLayer != before.contextLayer;
  const bool shading = now.shading != before.shading, strokes = now.strokes != before.strokes;
  const bool labels = now.labels != before.labels, clipping = now.clipping != before.clipping;
  const bool removals = now.removals != before.removals;
  const bool scene = focus || labels || context || cutaway || shading || clipping ||
                     now.background != before.background || now.backdrop != before.backdrop ||
                     now.backgroundTop != before.backgroundTop || now.hideTable != before.hideTable ||
                     now.reconstruction != before.reconstruction || now.labelSmoothing != before.labelSmoothing ||
                     now.edges != before.edges || removals;
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
  history_.push(name, std::make_shared<LookChange>(*this, std::move(before), this->look()));
}

void Document::noteContents(const io::Session& session) {
  if (session.volume.files == study_.session.volume.files) study_.session.volume.contents = session.volume.contents;
  if (session.labels.files == study_.session.labels.files) study_.session.labels.contents = session.labels.contents;
}

void Document::setLabels(std::shared_ptr<const LabelMap> labels, io::SessionData from) {
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
  auto change = std::make_shared<LabelsChange>(*this, std::move(edit), before, now);
  if (change->isNothing()) return;
  showLabels(std::move(after), now.revision, now.focus);
  history_.push(name, std::move(change));
}

void Document::noteLabelsFile(std::uint64_t revision, const io::SessionData& file) {
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
  setInverted(false);
  if (hasVolume()) setWindow(study_.scene.volume->defaultWindow());
}

void Document::setFocus(Focus focus) {
  Look changed = look();
  changed.focus = std::move(focus);
  edit(tr("Focus"), std::move(changed));
}

const segmentation::Growth* Document::growth() const {
  const RegionFocus* wanted = region();
  if (!wanted) return nullptr;
  for (const Grown& each : grown_)
    if (segmentation::haveSameSeeds(each.seeds, *wanted)) return each.growth.get();
  return preview_.growth && segmentation::haveSameSeeds(preview_.seeds, *wanted) ? preview_.growth.get() : nullptr;
}

void Document::setGrowth(const RegionFocus& seeds, std::shared_ptr<const segmentation::Growth> growth, bool whole) {
  if (whole) {
    preview_ = {};
    grown_.push_back({seeds, std::move(growth)});
    std::size_t bytes = 0;
    for (const Grown& each : grown_) bytes += each.growth->steps->voxels.byteCount();
    while (grown_.size() > 1 && bytes > mostGrownBytes) {
      bytes -= grown_.front().growth->steps->voxels.byteCount();
      grown_.erase(grown_.begin());
    }
  } else {
    preview_ = {seeds, std::move(growth)};
  }
  if (!region() || !segmentation::haveSameSeeds(seeds, *region())) return;
  updateDrawn();
  Q_EMIT focusChanged();
  Q_EMIT sceneChanged();
}

void Document::growFrom(glm::dvec3 world) {
  Look changed = look();
  changed.focus = RegionFocus{{world}, {}, {}};
  edit(tr("Region"), std::move(changed));
}

void Document::addSeed(glm::dvec3 world, bool inside) {
  if (!region()) return growFrom(world);
  Look changed = look();
  auto& seeds = std::get<RegionFocus>(changed.focus);
  (inside ? seeds.inside : seeds.outside).push_back(world);
  edit(inside ? tr("Add to the region") : tr("Take away from the region"), std::move(changed));
}

void Document::paintSelection(SelectionStroke stroke) {
  if (!region() && !stroke.adds) return;
  const bool adds = stroke.adds;
  Look changed = look();
  if (!region()) changed.focus = RegionFocus{};
  std::get<RegionFocus>(changed.focus).painted.push_back(std::move(stroke));
  edit(adds ? tr("Paint the region") : tr("Erase from the region"), std::move(changed));
}

std::optional<std::pair<RegionFocus, std::shared_ptr<const segmentation::Growth>>> Document::grownBefore(
    const RegionFocus& wanted) const {
  for (auto each = grown_.rbegin(); each != grown_.rend(); ++each) {
    RegionFocus first = wanted;
    if (each->seeds.painted.size() > first.painted.size()) continue;
    first.painted.resize(each->seeds.painted.size());
    if (segmentation::haveSameSeeds(first, each->seeds)) return std::pair(each->seeds, each->growth);
  }
  return std::nullopt;
}

void Document::setTolerance(std::optional<double> tolerance) {
  if (!region() || region()->tolerance == tolerance) return;
  Look changed = look();
  std::get<RegionFocus>(changed.focus).tolerance = tolerance;
  edit(tr("Tolerance"), std::move(changed));
}

void Document::moveTolerance(int steps) {
  if (!growth()) return;
  const int now = regionStep(), wanted = std::clamp(now + steps, 1, segmentation::stepCount);
  if (wanted != now) setTolerance(growth()->toleranceOf(wanted));
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
  history_.push(name, std::make_shared<MeasuresChange>(*this, std::move(before), measures_));
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
