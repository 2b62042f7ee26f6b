#pragma once
// A series as text, for lists on screen.

#include <QString>

#include "io/base/Reading.h"

namespace fenestra::viewer {

/// Whether texts that name the patient, or that somebody typed and that may do so, are left out.
enum class SeriesNames : std::uint8_t { Shown, Hidden };

/// "4 · Head 1.0": number, description, what tells the volume from others of its series, time point; "Series 4" where
/// there is nothing but a number.
QString seriesTitle(const io::SeriesInfo& series, SeriesNames names);

/// "CT · 1.5 mm, every 1 mm · B30f": kind, thickness, reconstruction kernel; only what is known.
QString seriesKind(const io::SeriesInfo& series);

/// "2021-02-03 · Thorax": date and description of the study; "Study 2", with `number` 2, where names are hidden or
/// there are none.
QString studyTitle(const io::SeriesInfo& series, SeriesNames names, int number);

}  // namespace fenestra::viewer
