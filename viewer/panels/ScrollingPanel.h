#pragma once
// A panel that scrolls up and down where the window is too low for it. The wheel over a slider or a box scrolls too,
// unless that was clicked before: nobody changes a value in passing.

#include <QScrollArea>

namespace fenestra::viewer {

class ScrollingPanel : public QScrollArea {
 public:
  using QScrollArea::QScrollArea;

  QSize sizeHint() const override;
  /// As wide as its contents need, and a few rows high.
  QSize minimumSizeHint() const override;

 protected:
  /// With all it will hold already in it.
  void setBody(QWidget* body);
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace fenestra::viewer
