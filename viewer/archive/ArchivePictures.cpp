#include "viewer/archive/ArchivePictures.h"

#include <algorithm>
#include <array>

#include <QBuffer>
#include <QImageReader>
#include <QPainter>
#include <QScrollBar>
#include <QTreeView>

#include "io/archive/WebPicture.h"
#include "viewer/archive/ArchiveModel.h"
#include "viewer/archive/Conversation.h"

namespace fenestra::viewer {
namespace {

constexpr int rowPictureSide = 32;  ///< of the screen's points

/// Kinds of series without pixels (PS3.3 C.7.3.1.1.1).
bool hasPixels(const std::string& modality) {
  constexpr std::array without{"SR",       "KO",       "PR",  "DOC", "PLAN", "RTPLAN",
                               "RTSTRUCT", "RTRECORD", "REG", "FID", "RWV",  "AU"};
  return std::find(without.begin(), without.end(), modality) == without.end();
}

}  // namespace

ArchivePictures::ArchivePictures(Archives& archives, QTreeView& view, ArchiveModel& model)
    : archives_(archives), view_(view), model_(model) {
  view_.setIconSize({rowPictureSide, rowPictureSide});
  look_.setSingleShot(true);
  look_.setInterval(100);  // ms: rows that a wheel or a drag passes by are not asked for
  connect(&look_, &QTimer::timeout, this, &ArchivePictures::lookAtRows);
  const auto look = [this] {
    if (!server_.isEmpty()) look_.start();
  };
  connect(view_.verticalScrollBar(), &QScrollBar::valueChanged, this, look);
  connect(&view_, &QTreeView::expanded, this, look);
  connect(&view_, &QTreeView::collapsed, this, look);
  connect(&model_, &ArchiveModel::rowsInserted, this, look);
  connect(&model_, &ArchiveModel::modelReset, this, look);
  view_.viewport()->installEventFilter(this);
  model_.setPictures([this](const ArchiveNode& node, bool hides) { return pictureOf(node, hides); });
  connect(&job_, &LoadJob::failed, this, [this] { keep(QString::fromStdString(fetching_), {}, true); });
  connect(&job_, &LoadJob::ended, this, &ArchivePictures::fetchNext, Qt::QueuedConnection);
}

ArchivePictures::~ArchivePictures() {
  job_.disconnect(this);
  model_.setPictures({});
}

void ArchivePictures::setServer(const QString& id) {
  const ServerEntry* entry = archives_.find(id);
  server_ = entry && entry->kind == ServerEntry::Kind::Web ? id : QString();
  kept_.clear();
  wanted_.clear();
  job_.cancel();
  blank_ = QPixmap(view_.iconSize() * view_.devicePixelRatio());
  blank_.setDevicePixelRatio(view_.devicePixelRatio());
  blank_.fill(Qt::transparent);
  view_.setUniformRowHeights(server_.isEmpty());
}

bool ArchivePictures::eventFilter(QObject* watched, QEvent* event) {
  const QEvent::Type type = event->type();
  if (!server_.isEmpty() && (type == QEvent::Resize || type == QEvent::Show || type == QEvent::Hide)) look_.start();
  return QObject::eventFilter(watched, event);
}

QPixmap ArchivePictures::pictureOf(const ArchiveNode& node, bool hidesPatient) const {
  if (server_.isEmpty()) return {};
  const Kept* kept = kept_.object(QString::fromStdString(node.value("SeriesInstanceUID")));
  return !kept || kept->picture.isNull() || (hidesPatient && kept->couldShowNames) ? blank_ : kept->picture;
}

void ArchivePictures::lookAtRows() {
  wanted_.clear();
  const QRect sight = view_.viewport()->rect();
  if (view_.isVisible())
    for (QModelIndex row = view_.indexAt({1, 1}); row.isValid() && view_.visualRect(row).top() <= sight.bottom();
         row = view_.indexBelow(row)) {
      const ArchiveNode* node = model_.nodeAt(row);
      if (!node || node->kind != ArchiveNode::Kind::Series || !hasPixels(node->value("Modality"))) continue;
      const std::string series = node->value("SeriesInstanceUID");
      if (series.empty() || kept_.contains(QString::fromStdString(series))) continue;
      wanted_.push_back({node->parent->value("StudyInstanceUID"), series,
                         QString::fromStdString(node->value("NumberOfSeriesRelatedInstances")).toULongLong()});
    }
  const auto isFetched = [this](const Wanted& each) { return each.series == fetching_; };
  if (job_.isRunning() && std::none_of(wanted_.begin(), wanted_.end(), isFetched))
    job_.cancel();
  else
    fetchNext();
}

void ArchivePictures::fetchNext() {
  if (job_.isRunning()) return;
  // What failed or has come meanwhile is kept.
  while (!wanted_.empty() && kept_.contains(QString::fromStdString(wanted_.front().series))) wanted_.pop_front();
  const ServerEntry* entry = archives_.find(server_);
  // The search has asked for the login.
  const std::optional<AnyServer> reached =
      entry && !wanted_.empty() ? archives_.reach(*entry, Archives::Asking::Never) : std::nullopt;
  const auto* web = reached ? std::get_if<io::archive::WebServer>(&*reached) : nullptr;
  if (!web) return wanted_.clear();
  const Wanted next = wanted_.front();
  wanted_.pop_front();
  fetching_ = next.series;
  const int side = qRound(rowPictureSide * view_.devicePixelRatio());
  job_.start([this, next, side,
              talk = Conversation(archives_, entry->id, *reached)](const io::Progress& progress) -> LoadJob::Show {
    std::optional<io::archive::WebPicture> got;
    talk.run([&](const auto& server) {
      if constexpr (std::is_same_v<std::decay_t<decltype(server)>, io::archive::WebServer>)
        got = io::archive::pictureOf(server, next.study, next.series, next.objects, side, progress);
    });
    const QImage picture = got ? pictureIn(got->bytes, side) : QImage();
    return [this, picture, series = QString::fromStdString(next.series), names = !got || got->couldShowNames] {
      keep(series, picture, names);
    };
  });
}

void ArchivePictures::keep(const QString& series, const QImage& picture, bool couldShowNames) {
  auto* kept = new Kept{{}, couldShowNames};
  if (!picture.isNull()) {
    // In the middle of a square, so that the texts of all rows begin at one place.
    kept->picture = blank_;
    QPainter painter(&kept->picture);
    const QSizeF size = QSizeF(picture.size()).scaled(view_.iconSize(), Qt::KeepAspectRatio);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(
        QRectF({(view_.iconSize().width() - size.width()) / 2.0, (view_.iconSize().height() - size.height()) / 2.0},
               size),
        picture);
  }
  constexpr qsizetype overhead = 256;
  const QSize pixels = kept->picture.size();
  kept_.insert(series, kept, overhead + qsizetype{4} * pixels.width() * pixels.height());
  model_.showPicture(series.toStdString());
}

QImage ArchivePictures::pictureIn(const std::string& bytes, int side) {
  QByteArray data = QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size()));
  QBuffer buffer(&data);
  QImageReader reader(&buffer, bytes.starts_with("\xff\xd8") ? "jpeg" : "png");
  reader.setAutoDetectImageFormat(false);  // the server shall not choose among all decoders
  const QSize size = reader.size();
  constexpr int most = 4096;  // a few bytes may claim gigabytes of pixels
  if (size.isEmpty() || size.width() > most || size.height() > most) return {};
  const QSize fitting = size.scaled(side, side, Qt::KeepAspectRatio).expandedTo({1, 1});
  if (size.width() > side || size.height() > side) reader.setScaledSize(fitting);
  return reader.read();
}

}  // namespace fenestra::viewer
