#include "viewer/model/LabelRows.h"

#include <QStringList>

#include "viewer/model/CsvText.h"

namespace fenestra::viewer {

std::vector<LabelRow> labelRows(const LabelMap& labels, const Volume& volume) {
  const std::vector<LabelStatistics> statistics = labelStatistics(labels, volume);
  const std::vector<glm::dvec3> places = placesWithin(labels, statistics);
  std::vector<LabelRow> rows;
  for (std::size_t i = 0; i < statistics.size(); ++i)
    if (statistics[i].voxels > 0) rows.push_back({statistics[i], labels.labels[i].name, places[i]});
  return rows;
}

QString labelsCsv(const std::vector<LabelRow>& rows, const std::vector<SeenByCameras>& seen, const std::string& unit) {
  QString text = QStringLiteral(
      "label,name,voxels,volume_ml,mean,sd,min,max,unit,low_l_mm,low_p_mm,low_s_mm,high_l_mm,high_p_mm,high_s_mm,"
      "centre_l_mm,centre_p_mm,centre_s_mm,seen_by_c1,seen_by_c2\r\n");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const LabelRow& row = rows[i];
    QStringList fields{QString::number(row.label), csvField(QString::fromStdString(row.name)),
                       QString::number(row.voxels), csvNumber(row.millilitres)};
    for (const double value : {row.mean, row.deviation, row.least, row.greatest})
      fields << (row.valued > 0 ? csvNumber(value) : QString());
    fields << csvField(QString::fromStdString(unit));
    for (const glm::dvec3& place : {row.low, row.high, row.centre})
      for (int axis = 0; axis < 3; ++axis) fields << csvNumber(place[axis]);
    for (const std::optional<double>& share : {seen[i].c1, seen[i].c2})
      fields << (share ? csvNumber(*share) : QString());
    text += fields.join(QLatin1Char(',')) + QStringLiteral("\r\n");
  }
  return text;
}

}  // namespace fenestra::viewer
