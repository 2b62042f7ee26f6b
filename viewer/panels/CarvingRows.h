#pragma once
// How the mouse carves, and a button that restores everything: rows of the Cutaway panel.

#include <QComboBox>
#include <QToolButton>
#include <QWidget>

#include "rendering/methods/Method.h"

namespace fenestra::viewer {

class Carving;
class Document;
class SliderSpin;

class CarvingRows : public QWidget {
  Q_OBJECT
 public:
  CarvingRows(Document& document, Carving& carving, QWidget* parent = nullptr);

  QToolButton* carve() const { return carve_; }
  QToolButton* restore() const { return restore_; }
  QComboBox* shape() const { return shape_; }

 private:
  void layOut();
  /// Chooses the shape that suits another method.
  void followMethod();
  void show();

  Document& document_;
  Carving& carving_;
  MethodKind method_;  ///< the method that the shape was last chosen for
  QToolButton *carve_, *restore_;
  QComboBox* shape_;
  SliderSpin *size_, *softness_, *depth_;
};

}  // namespace fenestra::viewer
