#include "viewer/archive/ArrivalView.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "io/Thumbnail.h"

namespace fenestra::viewer {
namespace {

/// Where the object is now: the folder loses its ending once the series is whole.
std::filesystem::path placeOf(const std::filesystem::path& file) {
  std::error_code unknown;
  if (std::filesystem::exists(file, unknown)) return file;
  std::filesystem::path folder = file.parent_path();
  return folder.replace_extension() / file.filename();
}

/// The only slice of a file, or its middle one, in the window that it names.
QImage sliceIn(const std::filesystem::path& file, const io::Progress& progress) {
  io::SeriesInfo alone;
  alone.files = {placeOf(file)};
  constexpr int most = 1024;  // pixels; larger pictures are made smaller
  const io::Thumbnail slice = io::makeThumbnail(alone, most, progress);
  QImage picture(slice.size.x, slice.size.y, QImage::Format_Grayscale8);
  for (int y = 0; y < slice.size.y; ++y)
    std::copy_n(slice.grey.data() + static_cast<std::ptrdiff_t>(y) * slice.size.x, slice.size.x, picture.scanLine(y));
  return picture;
}

}  // namespace

ArrivalView::ArrivalView(Retrievals& retrievals, LoadJob& opening, QWidget& over)
    : QWidget(&over), retrievals_(retrievals), opening_(opening) {
  setObjectName(QStringLiteral("arrivalView"));
  setAutoFillBackground(true);
  text_ = new QLabel;
  text_->setObjectName(QStringLiteral("arrivalText"));
  text_->setWordWrap(true);
  slider_ = new QSlider(Qt::Vertical);
  slider_->setInvertedAppearance(true);
  slider_->setPageStep(1);
  slider_->setToolTip(tr("Looks through the slices that have come"));
  slider_->setAccessibleName(tr("Slice of those that have come"));
  auto* hide = new QPushButton(tr("Hide"));
  hide->setToolTip(tr("Shows the views again; the retrieval goes on"));
  auto* cancel = new QPushButton(tr("Cancel"));
  cancel->setObjectName(QStringLiteral("arrivalCancel"));
  cancel->setToolTip(tr("Stops the retrieval; what came is kept"));
  auto* bar = new QHBoxLayout;
  bar->addWidget(text_, 1);
  bar->addWidget(hide);
  bar->addWidget(cancel);
  auto* above = new QHBoxLayout;
  above->addStretch(1);
  above->addWidget(slider_);
  auto* column = new QVBoxLayout(this);
  column->addLayout(above, 1);
  column->addLayout(bar);
  QWidget::hide();

  connect(slider_, &QSlider::valueChanged, this, &ArrivalView::choose);
  connect(hide, &QPushButton::clicked, this, [this] {
    isHidden_ = true;
    setVisible(false);
  });
  connect(cancel, &QPushButton::clicked, this, [this] {
    if (isWhole())
      opening_.cancel();
    else
      retrievals_.pause(retrieval_);
  });
  connect(&retrievals_, &Retrievals::arrived, this, &ArrivalView::add);
  connect(&retrievals_, &Retrievals::changed, this, &ArrivalView::follow);
  connect(&retrievals_, &Retrievals::listChanged, this, [this] { follow(retrieval_); });
  // Whoever opens what is ready has connected before, and may have been told not to.
  connect(&retrievals_, &Retrievals::ready, this, [this] {
    if (!opening_.isRunning()) end();
  });
  connect(&opening_, &LoadJob::ended, this, [this] {
    if (isWhole()) end();
  });
  // A file that holds no picture shows nothing; the next one that comes is tried.
  connect(
      &job_, &LoadJob::ended, this, [this] { read(); }, Qt::QueuedConnection);
  over.installEventFilter(this);
}

ArrivalView::~ArrivalView() { job_.disconnect(this); }

void ArrivalView::add(int retrieval, const io::archive::ArrivedObject& object) {
  const Retrievals::Item* item = retrievals_.find(retrieval);
  if (!item || item->state != Retrievals::State::Running) return;
  if (retrieval != retrieval_) {
    end();
    retrieval_ = retrieval;
  }
  const Key key{object.number, object.file.filename()};
  if (object.series != series_) {  // the next one of a study
    series_ = object.series;
    slices_.clear();
    shown_ = key;
  }
  total_ = object.total;
  if (std::exchange(isAhead_, object.frame > 0)) {  // the object of that frame
    slices_.clear();
    shown_ = key;
  }
  slices_.insert_or_assign(key, object.file);
  if (picture_.isNull() && !job_.isRunning()) shown_ = key;
  {
    const QSignalBlocker quiet(slider_);
    slider_->setRange(0, slicesHere() - 1);
    slider_->setValue(static_cast<int>(std::distance(slices_.begin(), slices_.find(shown_))));
  }
  if (isAhead_)
    text_->setText(tr("Not whole: frame %1 of %2 is here. The study opens, with its 3-D views, once all are.")
                       .arg(object.frame)
                       .arg(object.frames));
  else
    sayHowMany();
  read();
}

void ArrivalView::sayHowMany() {
  text_->setText(
      tr("Not whole: %1 of %2 images of this series are here. The study opens, with its 3-D views, once all are.")
          .arg(slices_.size())
          .arg(total_));
}

void ArrivalView::follow(int retrieval) {
  if (retrieval == 0 || retrieval != retrieval_) return;
  const Retrievals::Item* item = retrievals_.find(retrieval);
  if (isWhole())
    text_->setText(tr("All images are here. The study is being opened."));
  else if (!item || item->state != Retrievals::State::Running)
    end();
}

bool ArrivalView::isWhole() const {
  const Retrievals::Item* item = retrievals_.find(retrieval_);
  return item && item->state == Retrievals::State::Done;
}

void ArrivalView::end() {
  job_.cancel();
  retrieval_ = 0;
  isHidden_ = false;
  series_.clear();
  slices_.clear();
  isAhead_ = false;
  picture_ = {};
  shown_ = read_ = {};
  setVisible(false);
}

void ArrivalView::choose(int at) {
  if (at < 0 || at >= slicesHere()) return;
  shown_ = std::next(slices_.begin(), at)->first;
  read();
}

void ArrivalView::read() {
  const auto at = slices_.find(shown_);
  if (job_.isRunning() || at == slices_.end() || read_ == shown_) return;
  read_ = shown_;
  job_.start([this, file = at->second, retrieval = retrieval_](const io::Progress& progress) -> LoadJob::Show {
    const QImage picture = sliceIn(file, progress);
    return [this, picture, retrieval] {
      if (retrieval != retrieval_) return;
      picture_ = picture;
      if (!isHidden_ && !isVisible()) {
        setGeometry(parentWidget()->rect());
        raise();
        show();
      }
      update();
    };
  });
}

bool ArrivalView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
  return QWidget::eventFilter(watched, event);
}

void ArrivalView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QRect place(0, 0, slider_->x(), text_->y());
  painter.fillRect(rect().adjusted(0, 0, 0, text_->y() - height()), Qt::black);
  if (picture_.isNull()) return;
  QRect target(QPoint(), picture_.size().scaled(place.size(), Qt::KeepAspectRatio));
  target.moveCenter(place.center());
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(target, picture_);
}

void ArrivalView::wheelEvent(QWheelEvent* event) { QCoreApplication::sendEvent(slider_, event); }

}  // namespace fenestra::viewer
