#pragma once
// What 3-D pictures leave out: a crop box with six ends, up to three planes, how capped faces look, and the labels that
// are never clipped. While its dock is in sight, the views show handles to drag (tools/ClipTool.h).

#include <array>
#include <functional>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QToolButton>

#include "rendering/settings/Clipping.h"
#include "rendering/volume/Slice.h"
#include "viewer/panels/ScrollingPanel.h"

class QMenu;

namespace fenestra::viewer {

class Document;
class SliceCursor;
class SlicePlanes;
class ViewLink;

class ClippingPanel : public ScrollingPanel {
  Q_OBJECT
 public:
  ClippingPanel(Document& document, const SliceCursor& cursor, const SlicePlanes& slices, const ViewLink& cameras,
                QWidget* parent = nullptr);

  QCheckBox* crop() const { return crop_; }
  /// The low (0) or high (1) end along L, P or S.
  QDoubleSpinBox* end(int axis, int side) const { return ends_[static_cast<std::size_t>(2 * axis + side)]; }
  QToolButton* addButton() const { return add_; }
  QListWidget* planes() const { return planes_; }
  QToolButton* flipButton() const { return flip_; }
  QToolButton* removeButton() const { return remove_; }
  QComboBox* faces() const { return faces_; }
  QToolButton* resetButton() const { return reset_; }

 private:
  QWidget* makeBody();
  QLayout* makeEnds();
  QLayout* makePlanes();
  void fillAddMenu(QMenu& menu);
  void connectControls();
  void show();
  void showBox();
  void showPlanes();
  /// Changes the clipping as one step.
  void edit(const QString& name, const std::function<void(Clipping&)>& change);
  void setEnd(int axis, int side, double value);
  /// A plane of a slice through the crosshair, which keeps what lies beyond it from the usual camera: posterior,
  /// inferior or right.
  void addSlice(SlicePlane plane);
  void addFacing();
  void addPlane(const HalfSpace& plane);
  /// The plane whose row is current; -1: none.
  int current() const { return planes_->currentRow(); }

  Document& document_;
  const SliceCursor& cursor_;
  const SlicePlanes& slices_;
  const ViewLink& cameras_;
  QCheckBox* crop_;
  std::array<QDoubleSpinBox*, 6> ends_{};
  QListWidget* planes_;
  QToolButton *add_, *flip_, *remove_;
  QDoubleSpinBox* offset_;
  QComboBox* faces_;
  QLabel* exempt_;
  QToolButton* reset_;
};

}  // namespace fenestra::viewer
