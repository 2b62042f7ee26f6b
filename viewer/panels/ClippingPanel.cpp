#include "viewer/panels/ClippingPanel.h"

#include <algorithm>
#include <utility>

#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "viewer/model/Document.h"
#include "viewer/model/SliceCursor.h"
#include "viewer/model/SlicePlanes.h"
#include "viewer/model/Translation.h"
#include "viewer/model/ViewLink.h"

namespace fenestra::viewer {
namespace {

QDoubleSpinBox* millimetres() {
  auto* spin = new QDoubleSpinBox;
  spin->setDecimals(1);
  spin->setKeyboardTracking(false);
  spin->setSuffix(unitSuffix("mm"));
  return spin;
}

QToolButton* button(const QString& text, const QString& tip) {
  auto* made = new QToolButton;
  made->setText(text);
  made->setToolTip(tip);
  made->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  return made;
}

}  // namespace

ClippingPanel::ClippingPanel(Document& document, const SliceCursor& cursor, const SlicePlanes& slices,
                             const ViewLink& cameras, QWidget* parent)
    : ScrollingPanel(parent),
      document_(document),
      cursor_(cursor),
      slices_(slices),
      cameras_(cameras),
      crop_(new QCheckBox(tr("Crop to a box"))),
      planes_(new QListWidget),
      add_(button(tr("Add a plane"), tr("Cut everything off behind a plane; up to three"))),
      flip_(button(tr("Flip"), tr("Keep the other side of the plane"))),
      remove_(button(tr("Remove"), tr("Remove the plane"))),
      offset_(millimetres()),
      faces_(new QComboBox),
      exempt_(new QLabel),
      reset_(button(tr("Clip nothing"), tr("Switch off the box, and remove all planes"))) {
  setBody(makeBody());
  planes_->setAccessibleName(tr("Clip planes"));
  connectControls();
  show();
}

QLayout* ClippingPanel::makeEnds() {
  auto* grid = new QGridLayout;
  const std::array<QString, 3> names{tr("R – L"), tr("A – P"), tr("I – S")};
  const std::array<QString, 6> tips{tr("The patient's right end of the box"), tr("The patient's left end of the box"),
                                    tr("The front end of the box"),           tr("The back end of the box"),
                                    tr("The lower end of the box"),           tr("The upper end of the box")};
  for (int axis = 0; axis < 3; ++axis) {
    grid->addWidget(new QLabel(names[static_cast<std::size_t>(axis)]), axis, 0);
    for (int side = 0; side < 2; ++side) {
      const auto at = static_cast<std::size_t>(2 * axis + side);
      ends_[at] = millimetres();
      ends_[at]->setObjectName(QStringLiteral("clipEnd%1").arg(at));
      ends_[at]->setToolTip(tips[at]);
      grid->addWidget(ends_[at], axis, side + 1);
    }
  }
  return grid;
}

QLayout* ClippingPanel::makePlanes() {
  add_->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(add_);
  fillAddMenu(*menu);
  add_->setMenu(menu);
  planes_->setToolTip(tr("Drag a plane's square to move it, and the ball at its arrow to tilt it, in any view"));
  planes_->setFixedHeight(4 * planes_->fontMetrics().height());
  offset_->setToolTip(tr("Where the plane lies along its arrow"));
  auto* buttons = new QHBoxLayout;
  for (QToolButton* each : {add_, flip_, remove_}) buttons->addWidget(each);
  auto* column = new QVBoxLayout;
  column->addWidget(planes_);
  column->addLayout(buttons);
  return column;
}

void ClippingPanel::fillAddMenu(QMenu& menu) {
  const auto add = [&](SlicePlane plane, const QString& text) {
    menu.addAction(text, this, [this, plane] { addSlice(plane); });
  };
  add(SlicePlane::Axial, tr("From the axial slice"));
  add(SlicePlane::Sagittal, tr("From the sagittal slice"));
  add(SlicePlane::Coronal, tr("From the coronal slice"));
  menu.addAction(tr("Facing camera C1"), this, &ClippingPanel::addFacing);
}

QWidget* ClippingPanel::makeBody() {
  crop_->setToolTip(tr("3-D pictures show only the inside of a box along the volume's axes"));
  faces_->addItems({tr("As the transfer function"), tr("Grey, as the slices")});
  faces_->setToolTip(tr("What the cut faces show. Grey takes the window that the slices have now"));
  exempt_->setWordWrap(true);
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->addWidget(crop_);
  column->addLayout(makeEnds());
  column->addLayout(makePlanes());
  auto* form = new QFormLayout;
  form->addRow(tr("Place"), offset_);
  form->addRow(tr("Cut faces"), faces_);
  column->addLayout(form);
  column->addWidget(exempt_);
  column->addWidget(reset_);
  column->addStretch(1);
  return body;
}

void ClippingPanel::connectControls() {
  connect(crop_, &QCheckBox::clicked, this, [this](bool on) {
    edit(tr("Crop"), [&](Clipping& clipping) {
      clipping.cropped = on;
      const CropFrame frame(document_.scene().volume->grid);
      if (on && clipping.box == CropBox()) clipping.box = {frame.low, frame.high};
    });
  });
  for (int end = 0; end < 6; ++end)
    connect(ends_[static_cast<std::size_t>(end)], &QDoubleSpinBox::valueChanged, this,
            [this, end](double value) { setEnd(end / 2, end % 2, value); });
  connect(planes_, &QListWidget::currentRowChanged, this, &ClippingPanel::showPlanes);
  connect(flip_, &QToolButton::clicked, this, [this] {
    edit(tr("Flip the clip plane"), [&](Clipping& clipping) {
      HalfSpace& plane = clipping.planes.at(static_cast<std::size_t>(current()));
      plane = {-plane.normal, -plane.offset};
    });
  });
  connect(remove_, &QToolButton::clicked, this, [this] {
    edit(tr("Remove the clip plane"),
         [&](Clipping& clipping) { clipping.planes.erase(clipping.planes.begin() + current()); });
  });
  connect(offset_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (current() < 0) return;
    edit(tr("Move the clip plane"),
         [&](Clipping& clipping) { clipping.planes.at(static_cast<std::size_t>(current())).offset = value; });
  });
  connect(faces_, &QComboBox::activated, this, [this](int which) {
    edit(tr("Cut faces"),
         [&](Clipping& clipping) { clipping.grey = which == 1 ? std::optional(document_.window()) : std::nullopt; });
  });
  connect(reset_, &QToolButton::clicked, this, [this] {
    edit(tr("Clip nothing"), [](Clipping& clipping) {
      clipping.cropped = false;
      clipping.box = {};
      clipping.planes.clear();
    });
  });
  connect(&document_, &Document::clippingChanged, this, &ClippingPanel::show);
  connect(&document_, &Document::volumeChanged, this, &ClippingPanel::show);
  connect(&document_, &Document::labelsChanged, this, &ClippingPanel::show);
}

void ClippingPanel::edit(const QString& name, const std::function<void(Clipping&)>& change) {
  Clipping clipping = document_.clipping();
  change(clipping);
  document_.setClipping(std::move(clipping), name);
}

void ClippingPanel::setEnd(int axis, int side, double value) {
  const Grid& grid = document_.scene().volume->grid;
  const double least = grid.spacing[CropFrame(grid).axis[axis]];
  edit(tr("Crop"), [&](Clipping& clipping) {
    double &low = clipping.box.low[axis], &high = clipping.box.high[axis];
    if (side == 0)
      low = std::min(value, high - least);
    else
      high = std::max(value, low + least);
  });
  showBox();  // the box may be smaller than typed
}

void ClippingPanel::addPlane(const HalfSpace& plane) {
  edit(tr("Add a clip plane"), [&](Clipping& clipping) { clipping.planes.push_back(plane); });
  planes_->setCurrentRow(planes_->count() - 1);
}

void ClippingPanel::addSlice(SlicePlane plane) {
  // Towards P, I or R, where the slice is not turned.
  const glm::dvec3 normal = slices_.axes(plane).normal * (plane == SlicePlane::Coronal ? 1.0 : -1.0);
  addPlane({normal, glm::dot(normal, cursor_.position())});
}

void ClippingPanel::addFacing() {
  const glm::dvec3 normal = cameras_.camera(0).axes().forward;
  addPlane({normal, glm::dot(normal, cursor_.position())});
}

void ClippingPanel::show() {
  setEnabled(document_.hasVolume());
  if (!document_.hasVolume()) return;
  const Clipping& clipping = document_.clipping();
  crop_->setChecked(clipping.cropped);
  showBox();
  const int row = planes_->currentRow();
  {
    const QSignalBlocker quiet(planes_);
    planes_->clear();
    for (const HalfSpace& plane : clipping.planes)
      planes_->addItem(tr("Plane %1, keeps %2")
                           .arg(planes_->count() + 1)
                           .arg(QString::fromStdString(orientationLetters(plane.normal))));
    planes_->setCurrentRow(std::min(std::max(row, 0), planes_->count() - 1));
  }
  showPlanes();
  faces_->setCurrentIndex(clipping.grey ? 1 : 0);
  const auto exempt = static_cast<int>(clipping.exempt.size());
  exempt_->setText(exempt == 0 ? tr("Labels that are never clipped are chosen in the list of structures, by their "
                                    "role.")
                               : tr("Structures that are never clipped: %1").arg(exempt));
  exempt_->setVisible(document_.labels() != nullptr);
  reset_->setEnabled(clipping.cropped || !clipping.planes.empty());
}

void ClippingPanel::showBox() {
  const Clipping& clipping = document_.clipping();
  const CropFrame frame(document_.scene().volume->grid);
  const CropBox box = clipping.box == CropBox() ? CropBox{frame.low, frame.high} : clipping.box;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      QDoubleSpinBox* spin = end(axis, side);
      const QSignalBlocker quiet(spin);
      const double value = side ? box.high[axis] : box.low[axis];
      spin->setRange(std::min(frame.low[axis], value), std::max(frame.high[axis], value));
      spin->setValue(value);
      spin->setEnabled(clipping.cropped);
    }
}

void ClippingPanel::showPlanes() {
  const std::vector<HalfSpace>& planes = document_.clipping().planes;
  const bool any = current() >= 0 && current() < static_cast<int>(planes.size());
  add_->setEnabled(planes.size() < Clipping::mostPlanes);
  for (QWidget* widget : std::initializer_list<QWidget*>{flip_, remove_, offset_}) widget->setEnabled(any);
  if (!any) return;
  const QSignalBlocker quiet(offset_);
  const HalfSpace& plane = planes[static_cast<std::size_t>(current())];
  const Grid& grid = document_.scene().volume->grid;
  const double middle = glm::dot(plane.normal, grid.centre()), reach = grid.boundingRadius();
  offset_->setRange(std::min(middle - reach, plane.offset), std::max(middle + reach, plane.offset));
  offset_->setValue(plane.offset);
}

}  // namespace fenestra::viewer
