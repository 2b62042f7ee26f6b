#pragma once
// Patient and study as text. Shown in pictures and in the list of series on screen alone: never in
// titles, logs, sessions or lists of files.

#include <QStringList>

#include "io/VolumeReader.h"

namespace fenestra::viewer {

/// "Doe, Jane", "ID 4711", "F · born 1950-01-02", the study's and the series' description, and the date; what is not
/// known has no line.
QStringList patientLines(const io::PatientText& patient, const io::SeriesInfo& series);

/// "Doe, Jane (4711)"; only what is known.
QString patientTitle(const io::PatientText& patient);

/// A DICOM date (YYYYMMDD) as YYYY-MM-DD; another text as it is.
QString dateText(const std::string& dicomDate);

}  // namespace fenestra::viewer
