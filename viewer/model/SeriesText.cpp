#include "viewer/model/SeriesText.h"

#include <cmath>

#include <QCoreApplication>
#include <QStringList>

#include "viewer/model/NumberText.h"
#include "viewer/model/PatientLines.h"

namespace fenestra::viewer {
namespace {

struct SeriesWords {
  Q_DECLARE_TR_FUNCTIONS(Series)
};

QString joined(QStringList parts) {
  parts.removeAll(QString());
  return parts.join(QStringLiteral(" · "));
}

/// "1.5 mm", and the step between slices where it is another one.
QString thicknessText(const io::SeriesInfo& series) {
  constexpr double alike = 0.01;  // mm: headers round to it
  const auto text = [](double millimetres) { return SeriesWords::tr("%1 mm").arg(numberText(millimetres, 3, 'g')); };
  if (series.thickness <= 0.0)
    return series.step > 0.0 ? SeriesWords::tr("every %1").arg(text(series.step)) : QString();
  if (series.step <= 0.0 || std::abs(series.step - series.thickness) < alike) return text(series.thickness);
  return SeriesWords::tr("%1, every %2").arg(text(series.thickness), text(series.step));
}

}  // namespace

QString seriesTitle(const io::SeriesInfo& series, SeriesNames names) {
  QStringList parts;
  if (names == SeriesNames::Shown) parts << QString::fromStdString(series.description).simplified();
  parts << QString::fromStdString(series.part);
  if (series.times > 1) parts << SeriesWords::tr("time point %1 of %2").arg(series.time).arg(series.times);
  const QString title = joined(parts), number = series.number ? QString::number(*series.number) : QString();
  if (!title.isEmpty()) return joined({number, title});
  return number.isEmpty() ? SeriesWords::tr("Series without a name") : SeriesWords::tr("Series %1").arg(number);
}

QString seriesKind(const io::SeriesInfo& series) {
  return joined(
      {QString::fromStdString(series.modality), thicknessText(series), QString::fromStdString(series.kernel)});
}

QString studyTitle(const io::SeriesInfo& series, SeriesNames names, int number) {
  if (names == SeriesNames::Hidden) return SeriesWords::tr("Study %1").arg(number);
  const QString title = joined({dateText(series.date), QString::fromStdString(series.study).simplified()});
  return title.isEmpty() ? SeriesWords::tr("Study %1").arg(number) : title;
}

}  // namespace fenestra::viewer
