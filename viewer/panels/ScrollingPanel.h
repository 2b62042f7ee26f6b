#pragma once
// A panel that scrolls vertically where the window is too low for it. The wheel over a slider or a box scrolls the
// panel, unless that control has the focus, so that scrolling changes no value by accident. Rows that go leave the
// others where they are while the mouse may be over them.

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
  /// The height below which the panel had better be folded: that of all its contents, where none says otherwise.
  virtual int usefulHeight() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

  /// The least height of the body's rows down to the one that holds `last`. The body's layout is a QBoxLayout.
  int heightThrough(const QWidget& last) const;

 private:
  /// Keeps the body as high as the place that is scrolled to needs: the bar would move what is under the mouse else.
  void holdPlace();
  void releasePlace();
};

}  // namespace fenestra::viewer
