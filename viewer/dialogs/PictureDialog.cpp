#include "viewer/dialogs/PictureDialog.h"

#include <algorithm>
#include <cmath>

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "viewer/style/Overlay.h"
#include "viewer/views/SliceView.h"
#include "viewer/views/ViewArea.h"

namespace fenestra::viewer {
namespace {

constexpr int largestSide = 16384;  ///< pixels; what OpenGL 4.5 guarantees for a texture

QSpinBox* number(int low, int high, int value, const QString& suffix = {}) {
  auto* box = new QSpinBox;
  box->setRange(low, high);
  box->setValue(value);
  box->setSuffix(suffix);
  box->setAlignment(Qt::AlignRight);
  return box;
}

}  // namespace

std::vector<PictureDialog::Choice> PictureDialog::choices(What what, const ViewArea& views) {
  std::vector<Choice> choices;
  PictureMaker::Request all;
  for (VolumeView* view : views.volumeViews()) {
    if (!view->isVisible()) continue;
    choices.push_back({tr("C%1").arg(view->index() + 1), {.volumes = {view}}});
    all.volumes.push_back(view);
  }
  if (all.volumes.size() > 1) choices.push_back({tr("Both 3-D views"), all});
  if (what == What::Turntable) return choices;
  for (SliceView* view : views.sliceViews()) {
    if (!view->isVisible()) continue;
    choices.push_back({planeName(view->plane()), {.slices = {view}}});
    all.slices.push_back(view);
  }
  if (!all.volumes.empty() && all.slices.size() > 1) choices.push_back({tr("All views"), all});
  return choices;
}

int PictureDialog::activeOf(const std::vector<Choice>& choices, const ViewArea& views) {
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const PictureMaker::Request& of = choices[i].views;
    const bool one = of.volumes.size() + of.slices.size() == 1;
    const QWidget* view = of.volumes.empty() ? static_cast<QWidget*>(of.slices.front()) : of.volumes.front();
    if (one && view == views.activeView()) return static_cast<int>(i);
  }
  return 0;
}

PictureDialog::PictureDialog(What what, const ViewArea& views, const PictureMaker& maker, QWidget* parent)
    : QDialog(parent),
      maker_(maker),
      choices_(choices(what, views)),
      views_(new QComboBox),
      width_(number(16, largestSide, 16, tr(" px"))),
      height_(number(16, largestSide, 16, tr(" px"))),
      marks_(new QCheckBox(tr("With crosshair, text and scale"))),
      frames_(number(2, 3600, 72)),
      framesPerSecond_(number(1, 120, 24)) {
  setWindowTitle(what == What::Picture ? tr("Save a picture") : tr("Save a turntable"));
  for (const Choice& choice : choices_) views_->addItem(choice.name);
  views_->setCurrentIndex(activeOf(choices_, views));
  marks_->setChecked(what == What::Picture);
  auto* form = new QFormLayout(this);
  form->addRow(tr("Views"), views_);
  auto* size = new QHBoxLayout;
  size->addWidget(width_, 1);
  size->addWidget(new QLabel(QStringLiteral("×")));
  size->addWidget(height_, 1);
  form->addRow(tr("Size"), size);
  form->addRow(marks_);
  if (what == What::Turntable) {
    form->addRow(tr("Pictures in a turn"), frames_);
    form->addRow(tr("Pictures a second"), framesPerSecond_);
  } else {
    frames_->setParent(this);
    framesPerSecond_->setParent(this);
    frames_->hide();
    framesPerSecond_->hide();
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  form->addRow(buttons);

  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(width_, &QSpinBox::valueChanged, this, [this] { sizeChanged(width_, height_); });
  connect(height_, &QSpinBox::valueChanged, this, [this] { sizeChanged(height_, width_); });
  const auto showSize = [this] { width_->setValue(static_cast<int>(shownSize().width() * devicePixelRatioF())); };
  connect(views_, &QComboBox::currentIndexChanged, this, showSize);
  showSize();
}

QSize PictureDialog::shownSize() const {
  return maker_.sizeOf(choices_.at(static_cast<std::size_t>(views_->currentIndex())).views);
}

void PictureDialog::sizeChanged(QSpinBox* changed, QSpinBox* follows) {
  const QSize shown = shownSize();
  const double aspect = static_cast<double>(shown.width()) / shown.height();
  const QSignalBlocker quiet(follows);
  follows->setValue(
      static_cast<int>(std::lround(changed == width_ ? width_->value() / aspect : height_->value() * aspect)));
}

PictureMaker::Request PictureDialog::request() const {
  PictureMaker::Request request = choices_.at(static_cast<std::size_t>(views_->currentIndex())).views;
  request.scale = static_cast<double>(width_->value()) / shownSize().width();
  request.marks = marks_->isChecked();
  request.causes = true;  // a file has no tool tip
  return request;
}

}  // namespace fenestra::viewer
