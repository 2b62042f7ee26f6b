#include "viewer/panels/CutawayPanel.h"

#include <algorithm>

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "viewer/model/Translation.h"
#include "viewer/panels/CarvingRows.h"
#include "viewer/panels/ImportanceList.h"

namespace fenestra::viewer {
namespace {

/// Which ready-made look it is; -1 for none.
int lookOf(const Look& shown) {
  const auto looks = openingLooks();
  const auto at = std::find_if(looks.begin(), looks.end(), [&](const OpeningLook& look) {
    Cutaway cutaway = shown.cutaway;
    ContextLayer layer = shown.contextLayer;
    look.applyTo(cutaway, layer);
    return cutaway == shown.cutaway && layer == shown.contextLayer;
  });
  return at == looks.end() ? -1 : static_cast<int>(at - looks.begin());
}

}  // namespace

CutawayPanel::CutawayPanel(Document& document, Carving& carving, QWidget* parent)
    : QWidget(parent),
      document_(document),
      controls_(document, &Look::cutaway),
      methodControls_(document, &Look::method),
      enabled_(controls_.box(&Cutaway::enabled)),
      openWidth_(controls_.slider(&Cutaway::openWidth)),
      borderWidth_(controls_.slider(&Cutaway::borderWidth)),
      axisOffset_(controls_.slider(&Cutaway::axisOffset)),
      axisDirection_(controls_.spin(&Cutaway::axisDirection, 15.0)),
      axis_(new QHBoxLayout),
      importance_(new QHBoxLayout),
      lens_(new QHBoxLayout),
      wallPlanes_(new QHBoxLayout),
      form_(new QFormLayout(this)),
      method_(methodControls_.choice(&Method::kind)),
      importanceMode_(methodControls_.choice(&Method::importance)),
      sparseness_(methodControls_.choice(&Method::sparseness)),
      lensPlace_(methodControls_.choice(&Method::lensPlace)),
      lensFade_(methodControls_.choice(&Method::lensFade)),
      focalShape_(methodControls_.choice(&Method::focalShape)),
      wallPlacement_(methodControls_.choice(&Method::wallPlacement)),
      explosionPlanes_(methodControls_.choice(&Method::explosionPlanes)),
      explosionAxes_(methodControls_.choice(&Method::explosionAxes)),
      peelSide_(methodControls_.choice(&Method::peelSide)),
      coneAngle_(methodControls_.slider(&Method::coneAngle)),
      importanceAngle_(methodControls_.slider(&Method::importanceAngle)),
      importanceOpacity_(methodControls_.slider(&Method::importanceOpacity)),
      lensRadius_(methodControls_.slider(&Method::lensRadius)),
      lensBends_(methodControls_.slider(&Method::lensBends)),
      fadeReach_(methodControls_.slider(&Method::fadeReach)),
      fadeSharpness_(methodControls_.slider(&Method::fadeSharpness)),
      focalSize_(methodControls_.slider(&Method::focalSize)),
      focalFallOff_(methodControls_.slider(&Method::focalFallOff)),
      explosion_(methodControls_.slider(&Method::explosion)),
      ghostStrength_(methodControls_.slider(&Method::ghostStrength)),
      ghostEdge_(methodControls_.slider(&Method::ghostEdge)),
      ghostOutline_(methodControls_.slider(&Method::ghostOutline)),
      peel_(methodControls_.slider(&Method::peel)),
      peelTurn_(methodControls_.slider(&Method::peelTurn)),
      peelDepth_(methodControls_.slider(&Method::peelDepth)),
      peelRadius_(methodControls_.slider(&Method::peelRadius)),
      peelMargin_(methodControls_.slider(&Method::peelMargin)),
      lensRim_(methodControls_.spin(&Method::lensRim, 5.0)),
      wallAxial_(methodControls_.box(&Method::wallAxial)),
      wallSagittal_(methodControls_.box(&Method::wallSagittal)),
      wallCoronal_(methodControls_.box(&Method::wallCoronal)),
      wallOutlines_(methodControls_.box(&Method::wallOutlines)),
      carving_(new CarvingRows(document, carving)),
      importanceLevels_(new ImportanceList(document)),
      look_(new QComboBox),
      unit_(controls_.choice(&Cutaway::unit)),
      colour_(controls_.colour(&Cutaway::borderColour)) {
  layOut();
  connect(look_, &QComboBox::activated, this, &CutawayPanel::apply);
  connect(&document, &Document::cutawayChanged, this, &CutawayPanel::show);
  connect(&document, &Document::volumeChanged, this, &CutawayPanel::show);
  show();
}

void CutawayPanel::layOut() {
  for (const OpeningLook& look : openingLooks()) look_->addItem(translated(look.name));
  look_->setPlaceholderText(tr("own"));
  look_->setToolTip(tr("Ready-made border and context edges"));

  const auto name = [](const auto& setting) { return translated(setting.name); };
  form_->addRow(enabled_);
  addMethod(*form_);
  form_->addRow(name(settingOf(&Cutaway::openWidth)), openWidth_);
  auto* border = new QHBoxLayout;
  border->addWidget(borderWidth_, 1);
  border->addWidget(colour_);
  form_->addRow(name(settingOf(&Cutaway::borderWidth)), border);
  axis_->addWidget(axisOffset_, 1);
  axis_->addWidget(axisDirection_);
  form_->addRow(name(settingOf(&Cutaway::axisOffset)), axis_);
  form_->addRow(tr("Look"), look_);
  form_->addRow(name(settingOf(&Cutaway::unit)), unit_);
}

void CutawayPanel::apply(int openingLook) {
  Look look = document_.look();
  openingLooks()[static_cast<std::size_t>(openingLook)].applyTo(look.cutaway, look.contextLayer);
  document_.edit(tr("Look"), std::move(look));
}

void CutawayPanel::addMethod(QFormLayout& form) {
  const auto name = [](const auto& setting) { return translated(setting.name); };
  form.addRow(name(settingOf(&Method::kind)), method_);
  form.addRow(name(settingOf(&Method::coneAngle)), coneAngle_);
  // A row that appears must not widen the panel and so push the views aside.
  for (QComboBox* box : {importanceMode_, sparseness_, lensPlace_, lensFade_, focalShape_, wallPlacement_,
                         explosionPlanes_, explosionAxes_, peelSide_}) {
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(5);
  }
  importance_->addWidget(importanceMode_, 1);
  importance_->addWidget(sparseness_, 1);
  lens_->addWidget(lensFade_, 1);
  auto* label = new QLabel(name(settingOf(&Method::importance)));
  label->setWordWrap(true);
  form.addRow(label, importance_);
  form.addRow(name(settingOf(&Method::importanceAngle)), importanceAngle_);
  form.addRow(name(settingOf(&Method::importanceOpacity)), importanceOpacity_);
  form.addRow(tr("Levels"), importanceLevels_);
  form.addRow(name(settingOf(&Method::lensPlace)), lensPlace_);
  form.addRow(name(settingOf(&Method::lensRadius)), lensRadius_);
  form.addRow(name(settingOf(&Method::lensBends)), lensBends_);
  //: before the number that says how thin the line around a lens is
  lensRim_->setPrefix(tr("rim") + QLatin1Char(' '));
  lens_->addWidget(lensRim_);
  form.addRow(name(settingOf(&Method::lensFade)), lens_);
  form.addRow(name(settingOf(&Method::fadeReach)), fadeReach_);
  form.addRow(name(settingOf(&Method::fadeSharpness)), fadeSharpness_);
  form.addRow(name(settingOf(&Method::focalShape)), focalShape_);
  form.addRow(name(settingOf(&Method::focalSize)), focalSize_);
  form.addRow(name(settingOf(&Method::focalFallOff)), focalFallOff_);
  form.addRow(name(settingOf(&Method::wallPlacement)), wallPlacement_);
  // One letter a plane, as in the titles of other programs' views: three names are wider than the panel.
  wallAxial_->setText(tr("A", "axial"));
  wallSagittal_->setText(tr("S", "sagittal"));
  wallCoronal_->setText(tr("C", "coronal"));
  for (QCheckBox* box : {wallAxial_, wallSagittal_, wallCoronal_, wallOutlines_}) wallPlanes_->addWidget(box);
  wallPlanes_->addStretch(1);
  form.addRow(tr("Slices"), wallPlanes_);
  form.addRow(name(settingOf(&Method::explosion)), explosion_);
  form.addRow(name(settingOf(&Method::explosionPlanes)), explosionPlanes_);
  form.addRow(name(settingOf(&Method::explosionAxes)), explosionAxes_);
  form.addRow(carving_);
  form.addRow(name(settingOf(&Method::ghostStrength)), ghostStrength_);
  form.addRow(name(settingOf(&Method::ghostEdge)), ghostEdge_);
  form.addRow(name(settingOf(&Method::ghostOutline)), ghostOutline_);
  form.addRow(name(settingOf(&Method::peel)), peel_);
  form.addRow(name(settingOf(&Method::peelSide)), peelSide_);
  form.addRow(name(settingOf(&Method::peelTurn)), peelTurn_);
  form.addRow(name(settingOf(&Method::peelDepth)), peelDepth_);
  form.addRow(name(settingOf(&Method::peelRadius)), peelRadius_);
  form.addRow(name(settingOf(&Method::peelMargin)), peelMargin_);
}

void CutawayPanel::addFreeze(QAction* freeze) {
  auto* button = new QToolButton;
  button->setDefaultAction(freeze);
  axis_->addWidget(button);
}

void CutawayPanel::show() {
  setEnabled(document_.hasVolume());
  const Cutaway& cutaway = document_.look().cutaway;
  controls_.show();
  look_->setCurrentIndex(lookOf(document_.look()));
  const QString suffix = unitSuffix(wordOf(cutaway.unit).word);
  openWidth_->setSuffix(suffix);
  borderWidth_->setSuffix(suffix);
  for (QWidget* widget : std::initializer_list<QWidget*>{look_, openWidth_, borderWidth_, axisOffset_, unit_, colour_})
    widget->setEnabled(cutaway.enabled);
  axisDirection_->setEnabled(cutaway.enabled && cutaway.axisOffset > 0.0);
  showMethod();
}

void CutawayPanel::showMethod() {
  methodControls_.show();
  const Method& method = document_.look().method;
  const bool open = document_.look().cutaway.enabled, byImportance = method.kind == MethodKind::Importance;
  const bool byLens = method.kind == MethodKind::ClearView;
  const bool removes = method.importance == ImportanceMode::Maximum;
  form_->setRowVisible(coneAngle_, method.kind == MethodKind::Cone);
  form_->setRowVisible(importance_, byImportance);
  form_->setRowVisible(importanceAngle_, byImportance && removes);
  form_->setRowVisible(importanceOpacity_, byImportance && !removes);
  sparseness_->setVisible(byImportance && !removes);
  form_->setRowVisible(importanceLevels_, byImportance);
  form_->setRowVisible(lensPlace_, byLens);
  form_->setRowVisible(lensRadius_, byLens);
  form_->setRowVisible(lensBends_, byLens);
  form_->setRowVisible(lens_, byLens);
  const MethodStages stages = stagesOf(method);
  const bool opens = stages.start != MethodStages::Start::Entry;
  const bool byRegion = stages.fading && stages.fading->region, byView = stages.fading && stages.fading->followsLight();
  const bool byGhost = stages.fading && stages.fading->ghost;
  form_->setRowVisible(fadeReach_, byView);
  form_->setRowVisible(fadeSharpness_, byView);
  form_->setRowVisible(focalShape_, byRegion);
  form_->setRowVisible(focalSize_, byRegion);
  form_->setRowVisible(focalFallOff_, byRegion);
  form_->setRowVisible(wallPlacement_, stages.walls.has_value());
  form_->setRowVisible(wallPlanes_, stages.walls.has_value());
  const bool explodes = method.kind == MethodKind::Explode;
  form_->setRowVisible(explosion_, explodes);
  form_->setRowVisible(explosionPlanes_, explodes);
  form_->setRowVisible(explosionAxes_, explodes);
  form_->setRowVisible(carving_, method.kind == MethodKind::Sculpt || method.kind == MethodKind::Bend);
  for (QWidget* row : {ghostStrength_, ghostEdge_, ghostOutline_}) form_->setRowVisible(row, byGhost);
  for (QWidget* row :
       std::initializer_list<QWidget*>{peel_, peelSide_, peelTurn_, peelDepth_, peelRadius_, peelMargin_})
    form_->setRowVisible(row, method.kind == MethodKind::Peel);
  QString tip = translated(wordOf(method.kind).description);
  if (opens && !opensBetweenPixels(method.kind))
    tip += QStringLiteral("\n") + tr("Smooth edges, by several rays a pixel, are the adaptive cutaway's alone");
  method_->setToolTip(tip);
  methodControls_.setEnabled(open);
  carving_->setEnabled(open);
  importanceLevels_->setEnabled(open);
  for (QWidget* widget : std::initializer_list<QWidget*>{look_, axisOffset_, unit_}) widget->setEnabled(open && opens);
  axisDirection_->setEnabled(axisDirection_->isEnabled() && opens);
  // A width that the method does not have stays in sight, and says why it cannot be moved.
  const QString decides = !opens   ? tr("This method has no width: it cuts nothing away")
                          : byLens ? tr("This method has no width of its own: the focus and the lens decide on it")
                                   : tr("This method has no width of its own: the focus and the angle decide on it");
  openWidth_->setEnabled(open && stages.hasWidth);
  openWidth_->setToolTip(stages.hasWidth ? translated(settingOf(&Cutaway::openWidth).description) : decides);
  borderWidth_->setEnabled(open && stages.hasBorder);
  colour_->setEnabled(open && stages.hasBorder);
  borderWidth_->setToolTip(stages.hasBorder ? translated(settingOf(&Cutaway::borderWidth).description)
                           : byLens         ? tr("The line of this method is the rim of its lens")
                                            : tr("This method has no line: it cuts nothing away"));
}

}  // namespace fenestra::viewer
