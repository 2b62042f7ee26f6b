#pragma once
// The volume of a region against its tolerance: a leak is a cliff. Marks the plateaus found and the tolerance set; a
// press or drag sets it.

#include <QWidget>

namespace fenestra::viewer {

class Document;

class TolerancePlot : public QWidget {
  Q_OBJECT
 public:
  explicit TolerancePlot(Document& document, QWidget* parent = nullptr);

  QSize sizeHint() const override { return {240, 84}; }
  /// Horizontal place of a step, and the step at a place.
  double xOf(int step) const;
  int stepAt(double x) const;

 Q_SIGNALS:
  void edited(int step);
  void dragBegun();
  void dragEnded();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  QRectF area() const;

  Document& document_;
};

}  // namespace fenestra::viewer
