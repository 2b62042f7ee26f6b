#include "viewer/model/MeasureText.h"

#include <QCoreApplication>
#include <QLocale>

#include "viewer/model/Document.h"
#include "viewer/model/NumberText.h"

namespace fenestra::viewer {
namespace {

struct MeasureWords {
  Q_DECLARE_TR_FUNCTIONS(Measure)
};

QString exact(double number) { return QString::number(number, 'g', QLocale::FloatingPointShortest); }
QString exact(const std::optional<double>& number) { return number ? exact(*number) : QString(); }

/// A text as a field of RFC 4180, which is quoted where it would end the field. A spreadsheet takes one that begins
/// like a formula for a formula: an apostrophe before it keeps it a text.
QString quoted(QString text) {
  if (!text.isEmpty() && QStringLiteral("=+-@").contains(text.front())) text.prepend(QLatin1Char('\''));
  if (!text.contains(QLatin1Char(',')) && !text.contains(QLatin1Char('"'))) return text;
  return QLatin1Char('"') + text.replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
}

QString csvRow(const Measure& measure, const MeasureValues& values, const QString& unit) {
  QStringList row{nameOf(measure.kind).toLower(), exact(values.length), exact(values.angle), exact(values.area)};
  if (const auto& region = values.region)
    row << exact(region->mean) << exact(region->deviation) << exact(region->least) << exact(region->greatest)
        << QString::number(region->count) << unit;
  else
    row << QStringList(6);
  for (std::size_t point = 0; point < 3; ++point)
    for (int axis = 0; axis < 3; ++axis)
      row << (point < measure.points.size() ? exact(measure.points[point][axis]) : QString());
  row << quoted(QString::fromStdString(measure.text));
  return row.join(QLatin1Char(','));
}

}  // namespace

QString nameOf(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::Distance:
      return MeasureWords::tr("Distance");
    case MeasureKind::Angle:
      return MeasureWords::tr("Angle");
    case MeasureKind::Ellipse:
      return MeasureWords::tr("Ellipse");
    case MeasureKind::Arrow:
      return MeasureWords::tr("Arrow");
    case MeasureKind::Text:
      return MeasureWords::tr("Text");
    case MeasureKind::Rectangle:
      break;
  }
  return MeasureWords::tr("Rectangle");
}

QString valueText(double value, ValueRange range) { return numberText(value, range.high - range.low < 20.0 ? 3 : 0); }

QStringList linesOf(const Measure& measure, const MeasureValues& values, const Volume& volume) {
  QStringList lines;
  if (!measure.text.empty()) lines << QString::fromStdString(measure.text);
  if (values.length) lines << MeasureWords::tr("%1 mm").arg(*values.length, 0, 'f', 1);
  if (values.angle) lines << MeasureWords::tr("%1°").arg(*values.angle, 0, 'f', 1);
  if (const auto& region = values.region) {
    const int decimals = volume.range.high - volume.range.low < 20.0 ? 3 : 1;
    lines << MeasureWords::tr("Mean %1 %2").arg(region->mean, 0, 'f', decimals).arg(unitText(volume.unit)).trimmed()
          << MeasureWords::tr("SD %1").arg(region->deviation, 0, 'f', decimals)
          << MeasureWords::tr("%1 to %2")
                 .arg(valueText(region->least, volume.range), valueText(region->greatest, volume.range));
  }
  if (values.area) {
    constexpr double perCm2 = 100.0;  // mm²
    lines << (*values.area < perCm2 ? MeasureWords::tr("%1 mm²").arg(*values.area, 0, 'f', 1)
                                    : MeasureWords::tr("%1 cm²").arg(*values.area / perCm2, 0, 'f', 2));
  }
  return lines;
}

std::string markText(QString text) {
  text = text.simplified();
  while (text.toUtf8().size() > static_cast<qsizetype>(Measure::longestText)) text.chop(1);
  if (!text.isEmpty() && text.back().isHighSurrogate()) text.chop(1);
  return text.toStdString();
}

QString measuresCsv(const Document& document, std::optional<std::size_t> only) {
  QString text = QStringLiteral(
      "kind,length_mm,angle_deg,area_mm2,mean,sd,min,max,pixels,unit,"
      "l1_mm,p1_mm,s1_mm,l2_mm,p2_mm,s2_mm,l3_mm,p3_mm,s3_mm,text\r\n");
  const QString unit = QString::fromStdString(document.scene().volume->unit);
  for (std::size_t index = 0; index < document.measures().size(); ++index)
    if (!only || *only == index)
      text += csvRow(document.measures()[index], document.measured(index), unit) + QStringLiteral("\r\n");
  return text;
}

}  // namespace fenestra::viewer
