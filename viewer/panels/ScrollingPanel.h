#pragma once
// A panel that scrolls vertically where the window is too low for it. The wheel over a slider or a box scrolls the
// panel, unless that control has the focus, so that scrolling changes no value by accident.

#include <QScrollArea>

namespace fenestra::viewer {

class ScrollingPanel : public QScrollArea {
 public:
  using QScrollArea::QScrollArea;

  /// To be called when `body` holds all its widgets.
  void setBody(QWidget* body);

  QSize sizeHint() const override;
  /// Its contents' width, and a few rows' height.
  QSize minimumSizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace fenestra::viewer
