#pragma once
// The volume's histogram with the transfer function over it: opacity as height, in the function's colours.

#include <vector>

#include <QWidget>

#include "rendering/scene/Volume.h"

namespace fenestra::viewer {

class Document;

class TransferFunctionPlot : public QWidget {
  Q_OBJECT
 public:
  explicit TransferFunctionPlot(Document& document, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {240, 84}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void countValues();

  Document& document_;
  ValueRange shown_;              ///< values from the left to the right edge
  std::vector<float> histogram_;  ///< heights 0..1, logarithmic
};

}  // namespace fenestra::viewer
