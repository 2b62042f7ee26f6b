#include "viewer/model/PatientLines.h"

#include <algorithm>

#include <QCoreApplication>
#include <QDate>

namespace fenestra::viewer {
namespace {

/// Without what has no glyph: control characters, and bytes of a character set that the file does not name.
QString readable(QString text) {
  text.removeIf([](QChar each) { return !each.isSpace() && (!each.isPrint() || each == QChar::ReplacementCharacter); });
  return text.simplified();
}

QString trimmed(const std::string& text) { return readable(QString::fromStdString(text)); }

/// "Doe, Jane" of a person name's first group, "Doe^Jane^Middle^Dr^" (DICOM PS3.5 6.2.1).
QString nameText(const std::string& name) {
  const QStringList parts =
      readable(QString::fromStdString(name)).section(QLatin1Char('='), 0, 0).split(QLatin1Char('^'));
  const QString given = (parts.value(1) + QLatin1Char(' ') + parts.value(2)).simplified();
  const QString family = parts.value(0).simplified();
  return given.isEmpty() ? family : family.isEmpty() ? given : family + QStringLiteral(", ") + given;
}

}  // namespace

QString dateText(const std::string& dicomDate) {
  const QString text = trimmed(dicomDate);
  const QDate date = QDate::fromString(text, QStringLiteral("yyyyMMdd"));
  return date.isValid() ? date.toString(Qt::ISODate) : text;
}

QStringList patientLines(const io::PatientText& patient, const io::SeriesInfo& series) {
  QStringList lines{nameText(patient.name)};
  if (const QString id = trimmed(patient.id); !id.isEmpty())
    lines << QCoreApplication::translate("Patient", "ID %1").arg(id);
  QStringList person{trimmed(patient.sex)};
  // Said, so that nobody takes it for the date of the scan.
  if (const QString born = dateText(patient.birthDate); !born.isEmpty())
    person << QCoreApplication::translate("Patient", "born %1").arg(born);
  person.removeAll(QString());
  lines << person.join(QStringLiteral(" · ")) << trimmed(series.study) << trimmed(series.description)
        << dateText(series.date);
  lines.removeAll(QString());
  return lines;
}

QString patientTitle(const io::PatientText& patient) {
  const QString name = nameText(patient.name), id = trimmed(patient.id);
  if (name.isEmpty() || id.isEmpty()) return name + id;
  return QStringLiteral("%1 (%2)").arg(name, id);
}

}  // namespace fenestra::viewer
