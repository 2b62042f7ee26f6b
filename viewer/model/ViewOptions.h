#pragma once
// What is drawn over the pictures, the same in all views.

#include <QObject>

namespace fenestra::viewer {

class ViewOptions : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  bool crosshair() const { return crosshair_; }
  bool text() const { return text_; }      ///< corner text
  bool labels() const { return labels_; }  ///< label colours on the slices
  void setCrosshair(bool on) { set(crosshair_, on); }
  void setText(bool on) { set(text_, on); }
  void setLabels(bool on) { set(labels_, on); }

 Q_SIGNALS:
  void changed();

 private:
  void set(bool& option, bool on) {
    if (option == on) return;
    option = on;
    Q_EMIT changed();
  }

  bool crosshair_ = true, text_ = true, labels_ = true;
};

}  // namespace fenestra::viewer
