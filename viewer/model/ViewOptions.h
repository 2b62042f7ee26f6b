#pragma once
// What is drawn over the pictures and what a click on them does, in all views alike.

#include <QObject>

namespace fenestra::viewer {

class ViewOptions : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  bool crosshair() const { return crosshair_; }
  bool text() const { return text_; }                  ///< corner text
  bool labels() const { return labels_; }              ///< label colours on the slices
  bool measures() const { return measures_; }          ///< drawn on the slices
  bool grows() const { return grows_; }                ///< a click chooses the label there, or grows a region
  bool hidesPatient() const { return hidesPatient_; }  ///< no patient or study anywhere in the window
  bool clipHandles() const { return clipHandles_; }    ///< the crop box and clip planes have handles to drag
  bool planes() const { return planes_; }              ///< the slices' outlines in the 3-D views, with handles to turn
  bool followsPath() const { return followsPath_; }    ///< the cameras go along the path with its place
  bool isNeurological() const {
    return neurological_;
  }  ///< axial and coronal slices have the patient's left on the left
  void setCrosshair(bool on) { set(crosshair_, on); }
  void setText(bool on) { set(text_, on); }
  void setLabels(bool on) { set(labels_, on); }
  void setMeasures(bool on) { set(measures_, on); }
  void setGrows(bool on) { set(grows_, on); }
  void setHidesPatient(bool on) { set(hidesPatient_, on); }
  void setClipHandles(bool on) { set(clipHandles_, on); }
  void setPlanes(bool on) { set(planes_, on); }
  void setFollowsPath(bool on) { set(followsPath_, on); }
  void setNeurological(bool on) { set(neurological_, on); }

 Q_SIGNALS:
  void changed();

 private:
  void set(bool& option, bool on) {
    if (option == on) return;
    option = on;
    Q_EMIT changed();
  }

  bool crosshair_ = true, text_ = true, labels_ = true, measures_ = true, grows_ = true, hidesPatient_ = false,
       clipHandles_ = false, planes_ = false, neurological_ = false, followsPath_ = false;
};

}  // namespace fenestra::viewer
