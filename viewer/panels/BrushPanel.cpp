#include "viewer/panels/BrushPanel.h"

#include <algorithm>

#include <QButtonGroup>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QShortcut>
#include <QVBoxLayout>

#include "io/session/StrokeFile.h"
#include "viewer/Style.h"
#include "viewer/model/Document.h"
#include "viewer/model/Paths.h"
#include "viewer/panels/SliderSpin.h"
#include "viewer/panels/StrokeModel.h"

namespace fenestra::viewer {

BrushPanel::BrushPanel(Document& document, Brush& brush, QWidget* parent)
    : ScrollingPanel(parent),
      document_(document),
      brush_(brush),
      paint_(new QToolButton),
      radius_(new SliderSpin(settingOf(&BrushSettings::radius))),
      softness_(new SliderSpin(settingOf(&BrushSettings::softness))),
      depth_(new SliderSpin(settingOf(&BrushSettings::depth))),
      amount_(new SliderSpin(settingOf(&BrushSettings::amount))),
      coversFocus_(new QCheckBox(tr("May cover the focus"))),
      thisViewOnly_(new QCheckBox(tr("In the painted view only"))),
      strokes_(new StrokeModel(document, this)),
      list_(new QListView),
      delete_(new QPushButton(tr("Delete"))),
      clear_(new QPushButton(tr("Clear all"))),
      load_(new QPushButton(tr("Load…"))),
      save_(new QPushButton(tr("Save…"))) {
  paint_->setText(tr("Paint in the 3-D views"));
  paint_->setIcon(icon("brush"));
  paint_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  paint_->setCheckable(true);
  paint_->setObjectName(QStringLiteral("choice"));
  paint_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  paint_->setToolTip(tr("The left button paints; Ctrl with it still turns the view (P, and E the other way)"));
  auto* modes = new QHBoxLayout;
  modes->setSpacing(2);
  auto* group = new QButtonGroup(this);
  for (const Word<BrushMode>& each : wordsOf(BrushMode{})) {
    auto* button = new QToolButton;
    button->setText(QString::fromUtf8(each.name));
    button->setToolTip(QString::fromUtf8(each.description));
    button->setCheckable(true);
    button->setObjectName(QStringLiteral("choice"));
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    group->addButton(button);
    modes->addWidget(button);
    modes_[static_cast<std::size_t>(each.value)] = button;
    connect(button, &QToolButton::clicked, this, [this, mode = each.value] {
      BrushSettings settings = brush_.settings();
      settings.mode = mode;
      brush_.setSettings(settings);
    });
  }
  coversFocus_->setToolTip(tr("Otherwise what is restored never hides the focus"));
  thisViewOnly_->setToolTip(tr("Otherwise a stroke shows in both views"));
  list_->setModel(strokes_);
  list_->setUniformItemSizes(true);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setMinimumHeight(60);
  list_->setToolTip(tr("Tick what applies"));
  load_->setToolTip(tr("Adds the strokes of a file"));

  auto* form = new QFormLayout;
  form->addRow(tr("Radius"), radius_);
  form->addRow(tr("Softness"), softness_);
  form->addRow(tr("Depth"), depth_);
  form->addRow(tr("Amount"), amount_);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {delete_, clear_, load_, save_}) buttons->addWidget(button);
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->addWidget(paint_);
  column->addLayout(modes);
  column->addLayout(form);
  column->addWidget(coversFocus_);
  column->addWidget(thisViewOnly_);
  column->addWidget(list_, 1);
  column->addLayout(buttons);
  setBody(body);

  connect(paint_, &QToolButton::clicked, &brush_, &Brush::setActive);
  const auto bind = [this](SliderSpin* slider, double BrushSettings::*member) {
    connect(slider, &SliderSpin::edited, this, [this, member](double value) {
      BrushSettings settings = brush_.settings();
      settings.*member = value;
      brush_.setSettings(settings);
    });
  };
  bind(radius_, &BrushSettings::radius);
  bind(softness_, &BrushSettings::softness);
  bind(depth_, &BrushSettings::depth);
  bind(amount_, &BrushSettings::amount);
  const auto bindBox = [this](QCheckBox* box, bool BrushSettings::*member) {
    connect(box, &QCheckBox::clicked, this, [this, member](bool on) {
      BrushSettings settings = brush_.settings();
      settings.*member = on;
      brush_.setSettings(settings);
    });
  };
  bindBox(coversFocus_, &BrushSettings::coversFocus);
  bindBox(thisViewOnly_, &BrushSettings::thisViewOnly);
  connect(&brush_, &Brush::changed, this, &BrushPanel::showBrush);
  connect(&document_, &Document::volumeChanged, this, [this] { setEnabled(true); });
  connect(&document_, &Document::strokesChanged, this, &BrushPanel::enableButtons);
  connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &BrushPanel::enableButtons);
  connect(delete_, &QPushButton::clicked, this, &BrushPanel::deleteSelected);
  connect(new QShortcut(QKeySequence::Delete, list_, nullptr, nullptr, Qt::WidgetShortcut), &QShortcut::activated, this,
          &BrushPanel::deleteSelected);
  connect(clear_, &QPushButton::clicked, this, [this] { document_.setStrokes({}, tr("Clear strokes")); });
  const QString files = tr("Brush strokes (*.json)");
  connect(load_, &QPushButton::clicked, this, [this, files] {
    const QString file = QFileDialog::getOpenFileName(this, tr("Load brush strokes"), {}, files);
    if (!file.isEmpty()) load(file);
  });
  connect(save_, &QPushButton::clicked, this, [this, files] {
    QFileDialog dialog(this, tr("Save brush strokes"), {}, files);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(QStringLiteral("json"));
    if (dialog.exec() == QDialog::Accepted) save(dialog.selectedFiles().front());
  });
  setEnabled(false);
  showBrush();
  enableButtons();
}

void BrushPanel::showBrush() {
  const BrushSettings& settings = brush_.settings();
  paint_->setChecked(brush_.isActive());
  modeButton(settings.mode)->setChecked(true);
  radius_->setValue(settings.radius);
  softness_->setValue(settings.softness);
  depth_->setValue(settings.depth);
  amount_->setValue(settings.amount);
  const bool deep = movesRayStart(settings.mode);
  depth_->setEnabled(deep);
  amount_->setEnabled(!deep);
  coversFocus_->setEnabled(settings.mode == BrushMode::Restore);
  coversFocus_->setChecked(settings.coversFocus);
  thisViewOnly_->setChecked(settings.thisViewOnly);
}

void BrushPanel::enableButtons() {
  const bool any = !document_.strokes().empty();
  clear_->setEnabled(any);
  save_->setEnabled(any);
  delete_->setEnabled(list_->selectionModel()->hasSelection());
}

void BrushPanel::deleteSelected() {
  const QModelIndexList selected = list_->selectionModel()->selectedRows();
  if (selected.isEmpty()) return;
  BrushStrokes kept;
  for (int row = 0; row < strokes_->rowCount(); ++row)
    if (!selected.contains(strokes_->index(row))) kept.push_back(document_.strokes()[static_cast<std::size_t>(row)]);
  document_.setStrokes(std::move(kept), selected.size() == 1 ? tr("Delete stroke") : tr("Delete strokes"));
}

void BrushPanel::load(const QString& file) {
  try {
    BrushStrokes strokes = document_.strokes();
    BrushStrokes more = io::readStrokes(toPath(file));
    std::move(more.begin(), more.end(), std::back_inserter(strokes));
    document_.setStrokes(std::move(strokes), tr("Load strokes"));
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
  }
}

void BrushPanel::save(const QString& file) {
  try {
    io::writeStrokes(toPath(file), document_.strokes());
  } catch (const std::exception& error) {
    Q_EMIT failed(QString::fromUtf8(error.what()));
  }
}

}  // namespace fenestra::viewer
