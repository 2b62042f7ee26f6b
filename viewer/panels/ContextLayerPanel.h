#pragma once
// The context's edges drawn over the focus: how strongly, what makes an edge, and in what colour.

#include <vector>

#include "viewer/panels/LookControls.h"
#include "viewer/panels/ScrollingPanel.h"

namespace fenestra::viewer {

class ContextLayerPanel : public ScrollingPanel {
  Q_OBJECT
 public:
  explicit ContextLayerPanel(Document& document, QWidget* parent = nullptr);

 private:
  void show();

  Document& document_;
  LookControls<ContextLayer> controls_;
  SliderSpin* strength_;
  std::vector<QWidget*> rest_;  ///< all controls but the strength's
};

}  // namespace fenestra::viewer
