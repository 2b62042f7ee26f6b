#pragma once
// Patient and study as corner text. Shown in pictures on screen alone: never in titles, logs, sessions or lists.

#include <QStringList>

#include "io/VolumeReader.h"

namespace fenestra::viewer {

/// "Doe, Jane", "ID 4711", "F · 1950-01-02", the study's and the series' description, and the date; what is not known
/// has no line.
QStringList patientLines(const io::PatientText& patient, const io::SeriesInfo& series);

/// A DICOM date (YYYYMMDD) as YYYY-MM-DD; another text as it is.
QString dateText(const std::string& dicomDate);

}  // namespace fenestra::viewer
