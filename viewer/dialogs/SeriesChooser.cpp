#include "viewer/dialogs/SeriesChooser.h"

#include <algorithm>
#include <cmath>

#include <QDialogButtonBox>
#include <QPixmap>
#include <QVBoxLayout>

#include "viewer/model/NumberText.h"
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

/// "1.5 mm", and the step between slices where it is another one.
QString thicknessOf(const io::SeriesInfo& series) {
  constexpr double alike = 0.01;  // mm: headers round to it
  const auto text = [](double millimetres) { return SeriesChooser::tr("%1 mm").arg(numberText(millimetres, 3, 'g')); };
  if (series.thickness <= 0.0)
    return series.step > 0.0 ? SeriesChooser::tr("every %1").arg(text(series.step)) : QString();
  if (series.step <= 0.0 || std::abs(series.step - series.thickness) < alike) return text(series.thickness);
  return SeriesChooser::tr("%1, every %2").arg(text(series.thickness), text(series.step));
}

/// What the list calls the patient of each series; empty where that tells nothing.
QStringList patientsOf(const std::vector<io::SeriesInfo>& series, bool hidden) {
  QStringList titles;
  for (const io::SeriesInfo& each : series) titles << patientTitle(each.patient);
  QStringList all = titles;
  all.removeDuplicates();
  if (!hidden) return titles;
  for (QString& title : titles)
    title = all.size() > 1 ? SeriesChooser::tr("Patient %1").arg(all.indexOf(title) + 1) : QString();
  return titles;
}

QStringList headers() {
  return {SeriesChooser::tr("Picture"), SeriesChooser::tr("Patient"),   SeriesChooser::tr("No."),
          SeriesChooser::tr("Type"),    SeriesChooser::tr("Date"),      SeriesChooser::tr("Description"),
          SeriesChooser::tr("Part"),    SeriesChooser::tr("Thickness"), SeriesChooser::tr("Kernel"),
          SeriesChooser::tr("Size"),    SeriesChooser::tr("Images")};
}

void describe(const io::SeriesInfo& series, QTreeWidgetItem& row) {
  if (series.number) row.setText(SeriesChooser::Number, QString::number(*series.number));
  row.setText(SeriesChooser::Type, QString::fromStdString(series.modality));
  row.setText(SeriesChooser::Date, dateText(series.date));
  row.setText(SeriesChooser::Description, descriptionOf(series));
  row.setToolTip(SeriesChooser::Description, QString::fromStdString(series.study));
  row.setText(SeriesChooser::Part, QString::fromStdString(series.part));
  row.setText(SeriesChooser::Thickness, thicknessOf(series));
  row.setText(SeriesChooser::Kernel, QString::fromStdString(series.kernel));
  row.setText(SeriesChooser::Size, QStringLiteral("%1×%2×%3").arg(series.dims.x).arg(series.dims.y).arg(series.dims.z));
  row.setText(SeriesChooser::Images, QString::number(series.files.size()));
  row.setData(0, Qt::UserRole, QString::fromStdString(series.id));
}

}  // namespace

SeriesChooser::SeriesChooser(const io::Study& study, bool hidesPatient, QWidget* parent)
    : QDialog(parent), open_(study.series.id) {
  setWindowTitle(tr("Choose a series"));
  list_ = new QTreeWidget;
  list_->setRootIsDecorated(false);
  list_->setIconSize({pictureSide, pictureSide});
  list_->setHeaderLabels(headers());
  // Rows have their height before the pictures are there, so that nothing moves under the pointer.
  QPixmap blank(list_->iconSize() * devicePixelRatio());
  blank.setDevicePixelRatio(devicePixelRatio());
  blank.fill(Qt::transparent);
  const std::vector<io::SeriesInfo> all = allSeries(study);
  const QStringList patients = patientsOf(all, hidesPatient);
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto* row = new QTreeWidgetItem(list_);
    row->setIcon(Picture, blank);
    row->setText(Patient, patients[static_cast<qsizetype>(i)]);
    describe(all[i], *row);
  }
  list_->setColumnHidden(Patient, patients.join(QString()).isEmpty());
  const bool hasParts = std::any_of(all.begin(), all.end(), [](const auto& each) { return !each.part.empty(); });
  list_->setColumnHidden(Part, !hasParts);
  list_->setCurrentItem(list_->topLevelItem(0));
  for (int column = 0; column < list_->columnCount(); ++column) list_->resizeColumnToContents(column);
  thumbnails_ = new Thumbnails(all, static_cast<int>(pictureSide * devicePixelRatio()), this);
  connect(thumbnails_, &Thumbnails::made, this, [this](int index, const QImage& made) {
    QPixmap picture = QPixmap::fromImage(made);
    picture.setDevicePixelRatio(devicePixelRatio());
    list_->topLevelItem(index)->setIcon(Picture, picture);
  });

  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, &QDialog::accept);
  auto* column = new QVBoxLayout(this);
  column->addWidget(list_);
  column->addWidget(buttons);
  resize(960, 420);
}

std::optional<std::string> SeriesChooser::chosen() const {
  if (!list_->currentItem()) return std::nullopt;
  const std::string id = list_->currentItem()->data(0, Qt::UserRole).toString().toStdString();
  return id == open_ ? std::nullopt : std::optional(id);
}

}  // namespace fenestra::viewer
