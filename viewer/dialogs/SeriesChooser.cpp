#include "viewer/dialogs/SeriesChooser.h"

#include <QDialogButtonBox>
#include <QPixmap>
#include <QVBoxLayout>

#include "viewer/model/PatientLines.h"

namespace fenestra::viewer {
namespace {

constexpr int pictureSide = 72;  ///< device-independent pixels

std::vector<io::SeriesInfo> allSeries(const io::Study& study) {
  std::vector<io::SeriesInfo> series{study.series};
  series.insert(series.end(), study.otherSeries.begin(), study.otherSeries.end());
  return series;
}

QString descriptionOf(const io::SeriesInfo& series) {
  const QString description = QString::fromStdString(series.description);
  if (series.times < 2) return description;
  return SeriesChooser::tr("%1 time point %2 of %3").arg(description).arg(series.time).arg(series.times).trimmed();
}

}  // namespace

SeriesChooser::SeriesChooser(const io::Study& study, QWidget* parent) : QDialog(parent), open_(study.series.id) {
  setWindowTitle(tr("Choose a series"));
  list_ = new QTreeWidget;
  list_->setRootIsDecorated(false);
  list_->setIconSize({pictureSide, pictureSide});
  list_->setHeaderLabels({tr("Picture"), tr("Type"), tr("Date"), tr("Description"), tr("Size"), tr("Images")});
  // Rows have their height before the pictures are there, so that nothing moves under the pointer.
  QPixmap blank(list_->iconSize() * devicePixelRatio());
  blank.setDevicePixelRatio(devicePixelRatio());
  blank.fill(Qt::transparent);
  const std::vector<io::SeriesInfo> all = allSeries(study);
  for (const io::SeriesInfo& series : all) {
    auto* row = new QTreeWidgetItem(list_);
    row->setIcon(0, blank);
    row->setText(1, QString::fromStdString(series.modality));
    row->setText(2, dateText(series.date));
    row->setText(3, descriptionOf(series));
    row->setToolTip(3, QString::fromStdString(series.study));
    row->setText(4, QStringLiteral("%1×%2×%3").arg(series.dims.x).arg(series.dims.y).arg(series.dims.z));
    row->setText(5, QString::number(series.files.size()));
    row->setData(0, Qt::UserRole, QString::fromStdString(series.id));
  }
  list_->setCurrentItem(list_->topLevelItem(0));
  for (int column = 0; column < list_->columnCount(); ++column) list_->resizeColumnToContents(column);
  thumbnails_ = new Thumbnails(all, static_cast<int>(pictureSide * devicePixelRatio()), this);
  connect(thumbnails_, &Thumbnails::made, this, [this](int index, const QImage& made) {
    QPixmap picture = QPixmap::fromImage(made);
    picture.setDevicePixelRatio(devicePixelRatio());
    list_->topLevelItem(index)->setIcon(0, picture);
  });

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);
  auto* column = new QVBoxLayout(this);
  column->addWidget(list_);
  column->addWidget(buttons);
  resize(720, 420);
}

std::optional<std::string> SeriesChooser::chosen() const {
  if (!list_->currentItem()) return std::nullopt;
  const std::string id = list_->currentItem()->data(0, Qt::UserRole).toString().toStdString();
  return id == open_ ? std::nullopt : std::optional(id);
}

}  // namespace fenestra::viewer
