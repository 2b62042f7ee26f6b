#pragma once
// The histogram of a volume, or of a label's voxels, logarithmic, with a transfer function over it to edit: nodes and
// trapezoids are dragged with the mouse or moved with the keys. Values run from left to right; height is the opacity of
// 1 mm. The wheel enlarges the values around the mouse.

#include <optional>
#include <utility>

#include <QWidget>

#include "viewer/model/FunctionTarget.h"
#include "viewer/model/ValueHistogram.h"

class QMenu;

namespace fenestra::viewer {

class TransferFunctionPlot : public QWidget {
  Q_OBJECT
 public:
  explicit TransferFunctionPlot(Document& document, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {240, 150}; }
  QSize minimumSizeHint() const override { return {160, 90}; }

  const FunctionTarget& target() const { return target_; }
  void setTarget(const FunctionTarget& target);
  /// Gives the target a function in place of its one material, over what most voxels of the label or the range hold, or
  /// takes it away.
  void setByValue(bool byValue);
  /// The function that is shown, over values of the volume.
  TransferFunction function() const;
  /// The node that keys, colour and exact numbers change; empty where none is selected.
  std::optional<std::size_t> selected() const;
  void select(std::size_t node);
  /// Selects a whole trapezoid by its first node: it is coloured and deleted as one.
  void selectTrapezoid(std::size_t first);

  /// The values from the left to the right edge, and from the least to the greatest that can be shown.
  ValueRange shown() const { return shown_; }
  ValueRange axis() const { return axis_; }
  /// The place of a value and an opacity in the widget.
  QPointF place(double value, double opacity) const;

  /// Give the selected node an exact value, opacity or colour; each is a step of the history.
  void setValue(double value);
  void setOpacity(double opacity);
  void setColour(glm::dvec3 colour);
  void addNode(double value, double opacity);
  void addTrapezoid(double value);
  void deleteSelected();
  /// Makes the menu of a right click at a place in the widget.
  void fillMenu(QMenu& menu, QPointF at);

 Q_SIGNALS:
  /// Another node is selected, or the function has changed.
  void changed();
  /// The user asks for a dialog of the selected node's colour.
  void colourWanted();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  /// The state before the gesture that is under way.
  struct Drag {
    Look look;
    TransferFunction function;
    Grip grip;
    QPointF from;
    bool hasMoved = false;  ///< farther than a click's tremor
  };
  QFont axisFont() const;
  QRectF area() const;
  double valueAt(double x) const;
  double opacityAt(double y) const;
  std::optional<Grip> gripAt(QPointF at) const;
  void selectPart(Grip grip);
  void countValues();
  void countLabel();
  void fitAxis();
  void follow();
  void showValues(ValueRange values);
  /// Shows a function made from function() as a step of its own.
  void edit(const TransferFunction& function);
  void dragTo(QPointF at, Qt::KeyboardModifiers modifiers);
  void endDrag();
  void cancelDrag();
  /// False where the key means nothing here.
  bool useKey(const QKeyEvent& event);
  void moveByKey(const QKeyEvent& event);
  /// The trapezoid that the selected node is a part of, or the node.
  Grip selectedGrip(Grip::Part part) const;
  /// The selected node, or all four of a selected trapezoid: first and one past the last.
  std::pair<std::size_t, std::size_t> selection() const;
  void showCursor(QPointF at);
  void drawHistogram(QPainter& painter) const;
  void drawAxes(QPainter& painter) const;
  void drawFunction(QPainter& painter) const;
  void drawHandles(QPainter& painter) const;

  Document& document_;
  FunctionTarget target_;
  ValueHistogram histogram_;
  std::optional<ValueHistogram> labelHistogram_;  ///< shown in place of histogram_ while a label is edited
  /// The data that labelHistogram_ was made from.
  struct Counted {
    std::shared_ptr<const LabelMap> labels;
    std::shared_ptr<const Volume> volume;
    std::uint16_t label = 0;
    bool operator==(const Counted&) const = default;
  } counted_;
  ValueRange axis_{0.0, 1.0}, shown_{0.0, 1.0};
  std::size_t selected_ = 0;
  bool isTrapezoidSelected_ = false;  ///< the one that the selected node belongs to
  std::optional<Drag> drag_;
  std::optional<double> panFrom_;  ///< value under the mouse when the middle button went down
};

}  // namespace fenestra::viewer
