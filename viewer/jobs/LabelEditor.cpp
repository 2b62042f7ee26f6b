#include "viewer/jobs/LabelEditor.h"

#include <stdexcept>

#include "viewer/model/Document.h"
#include "viewer/model/LabelName.h"

namespace fenestra::viewer {
namespace {

using namespace segmentation;

Mask edited(const Mask& mask, LabelOperation operation, double number) {
  switch (operation) {
    case LabelOperation::Grow:
      return grown(mask, number);
    case LabelOperation::Shrink:
      return shrunk(mask, number);
    case LabelOperation::FillHoles:
      return withHolesFilled(mask);
    case LabelOperation::RemoveIslands:
      break;
  }
  return withoutIslands(mask, number);
}

/// What the edit takes from other labels.
double takenFromOthers(const LabelEdit& edit) {
  std::size_t voxels = 0;
  for (const LabelRun& run : edit.runs)
    if (run.before != 0 && run.after != 0) voxels += run.length;
  return static_cast<double>(voxels) * edit.grid.voxelVolume() / mm3PerMl;
}

QString stepName(LabelOperation operation) {
  switch (operation) {
    case LabelOperation::Grow:
      return LabelEditor::tr("Grow label");
    case LabelOperation::Shrink:
      return LabelEditor::tr("Shrink label");
    case LabelOperation::FillHoles:
      return LabelEditor::tr("Fill holes");
    case LabelOperation::RemoveIslands:
      break;
  }
  return LabelEditor::tr("Remove islands");
}

}  // namespace

LabelEditor::LabelEditor(Document& document, QObject* parent) : QObject(parent), document_(document) {}

void LabelEditor::keepRegion(const QString& name, glm::dvec3 colour) {
  if (!document_.isWhole()) return;
  const std::uint16_t value = freeLabel(document_.labels().get());
  // The growth may be dropped while this runs; its steps are shared.
  start(tr("Keep region"), {value, name.trimmed().toStdString(), colour}, Overlap::Take,
        [value, growth = *document_.growth(), step = document_.regionStep()] {
          if (value == 0)
            throw std::runtime_error(tr("All 65535 values that a label may have are in use").toStdString());
          return maskAt(growth, step);
        });
}

void LabelEditor::edit(std::uint16_t label, LabelOperation operation, double number) {
  const std::shared_ptr<const LabelMap> labels = document_.labels();
  const Label* known = labels ? labels->find(label) : nullptr;
  if (!known) return;
  start(stepName(operation), *known, Overlap::Leave,
        [labels, label, operation, number] { return edited(maskOf(*labels, label), operation, number); });
}

void LabelEditor::start(const QString& step, const Label& label, Overlap overlap, MakeMask mask) {
  job_.start([this, step, label, overlap, mask = std::move(mask),
              before = document_.labels()](const io::Progress& progress) -> LoadJob::Show {
    const auto goOn = [&](double fraction) {
      if (!progress(fraction, "Editing the label")) throw io::Cancelled();
    };
    goOn(0.1);
    const Mask wanted = mask();
    goOn(0.6);
    if (volumeOf(wanted) == 0.0) throw std::runtime_error(tr("Nothing would be left of the label").toStdString());
    LabelEdit edit = relabel(before.get(), wanted, label, overlap);
    goOn(0.8);
    return [this, step, label, before, edit, after = edit.applied(before.get())] {
      if (document_.labels() != before) return;  // others were opened, or an undo came in between
      document_.editLabels(step, edit, after, LabelFocus{{label.value}});
      if (const double ml = takenFromOthers(edit); ml > 0.0) Q_EMIT tookFromOthers(nameOf(label), ml);
    };
  });
}

}  // namespace fenestra::viewer
