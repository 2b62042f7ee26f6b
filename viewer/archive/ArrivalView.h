#pragma once
// The slices of a series that is on its way, over the views, until it is whole and has opened. Of what has come one
// slice is shown, the middle one at first; a slider looks through the others. It says that the series is not whole. Of
// an object with many frames, which comes as a whole, the middle one may be here before.

#include <filesystem>
#include <map>
#include <utility>

#include <QImage>
#include <QWidget>

#include "viewer/archive/Retrievals.h"
#include "viewer/jobs/LoadJob.h"

class QLabel;
class QSlider;

namespace fenestra::viewer {

class ArrivalView : public QWidget {
  Q_OBJECT
 public:
  /// Covers `over` while there is something to show, at the end until `opening`, the job that opens what is whole,
  /// ends. All of them outlive this, or go with it.
  ArrivalView(Retrievals& retrievals, LoadJob& opening, QWidget& over);
  /// Waits for the slice that is being read.
  ~ArrivalView() override;

  /// The slice that is shown; null before the first one was read.
  const QImage& picture() const { return picture_; }
  int slicesHere() const { return static_cast<int>(slices_.size()); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  /// Slices are in order of their number; those without one in order of their files.
  using Key = std::pair<int, std::filesystem::path>;

  void add(int retrieval, const io::archive::ArrivedObject& object);
  void follow(int retrieval);
  void choose(int at);
  void read();
  void sayHowMany();
  /// All has come, and is about to be opened.
  bool isWhole() const;
  void end();

  Retrievals& retrievals_;
  LoadJob& opening_;
  QLabel* text_;
  QSlider* slider_;
  LoadJob job_;
  int retrieval_ = 0;  ///< whose slices these are; 0: none
  bool isHidden_ = false;
  std::string series_;
  std::size_t total_ = 0;
  std::map<Key, std::filesystem::path> slices_;
  bool isAhead_ = false;  ///< slices_ is a frame alone, of an object that is on its way
  Key shown_, read_;      ///< to be shown; and the one of picture_
  QImage picture_;
};

}  // namespace fenestra::viewer
