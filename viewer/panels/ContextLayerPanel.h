#pragma once
// The context's edges drawn over the focus: how strongly, what makes an edge, and in what colour.

#include <vector>

#include "viewer/panels/ScrollingPanel.h"

namespace fenestra {
struct ContextLayer;
}

namespace fenestra::viewer {

class ColourButton;
class Document;
class SliderSpin;

class ContextLayerPanel : public ScrollingPanel {
  Q_OBJECT
 public:
  explicit ContextLayerPanel(Document& document, QWidget* parent = nullptr);

  SliderSpin* strength() const { return terms_.front().slider; }

 private:
  struct Term {
    SliderSpin* slider;
    double ContextLayer::*value;
  };
  void show();

  Document& document_;
  std::vector<Term> terms_;
  ColourButton* colour_;
};

}  // namespace fenestra::viewer
