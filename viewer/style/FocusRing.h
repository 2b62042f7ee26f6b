#pragma once
// A ring around the control that has the keyboard focus, the same for every kind of control and in every theme.

#include <QPointer>
#include <QWidget>

namespace fenestra::viewer {

class FocusRing : public QObject {
  Q_OBJECT
 public:
  /// A widget with this property set marks its focus itself.
  static constexpr const char* drawnByWidget = "drawsFocus";

  /// Follows the focus of the whole application.
  explicit FocusRing(QObject* parent);
  ~FocusRing() override;

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void moveTo(QWidget* control);

  QPointer<QWidget> control_;  ///< that has the ring
  /// A child of the control, so that it moves, scrolls and is clipped with it; a child of its parent where it lies
  /// around the control.
  QPointer<QWidget> ring_;
};

}  // namespace fenestra::viewer
