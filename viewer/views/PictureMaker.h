#pragma once
// Pictures of the views at any size, as they look on screen, drawn a little at a time so that the window answers.

#include <cstdint>
#include <memory>
#include <vector>

#include <QImage>
#include <QObject>
#include <QTimer>

#include "rendering/scene/View.h"
#include "viewer/model/Fidelity.h"

namespace fenestra {
class Renderer;
}

namespace fenestra::viewer {

class SliceView;
class ViewArea;
class VolumeView;

class PictureMaker : public QObject {
  Q_OBJECT
 public:
  /// `views` and what they show outlive this.
  explicit PictureMaker(ViewArea& views, QObject* parent = nullptr);
  ~PictureMaker() override;

  struct Request {
    std::vector<VolumeView*> volumes{};  ///< each drawn where it lies in the window, one beside the other
    std::vector<SliceView*> slices{};
    double scale = 1.0;   ///< pixels of the picture for each device-independent pixel of the window
    bool marks = true;    ///< crosshair, text, letters, cube and scale bar, as far as the window shows them
    bool causes = false;  ///< with marks and text: what makes each view less than exact, below its name
    double turn = 0.0;    ///< radians that the cameras turn about their vertical axis
  };
  /// Size of the picture in device-independent pixels of the window, at a scale of 1.
  QSize sizeOf(const Request& request) const;

  /// Starts a picture; drops one that is being made.
  void start(const Request& request);
  void cancel();
  bool isMaking() const { return timer_.isActive(); }
  /// How faithful each view of the last picture is and why, a line each: "C1: altered; …". Complete when it is made().
  QStringList fidelity() const { return fidelity_; }

 Q_SIGNALS:
  /// The picture of the present request: opaque, RGB.
  void made(const QImage& picture);
  /// There is no picture; `problem` is one line.
  void failed(const QString& problem);

 private:
  QRect areaOf(const Request& request) const;
  void advance();
  void begin(VolumeView& view);
  void paint(VolumeView& view, const std::vector<std::uint8_t>& pixels, QSize size);
  QRectF placeOf(const QWidget& view) const;
  void note(const QString& view, const std::vector<FidelityCause>& causes);

  ViewArea& views_;
  Request request_;
  QImage picture_;
  std::size_t next_ = 0;                ///< the next of request_.volumes
  std::unique_ptr<Renderer> renderer_;  ///< draws the present view
  View view_;
  QTimer timer_;
  QStringList fidelity_;
};

}  // namespace fenestra::viewer
