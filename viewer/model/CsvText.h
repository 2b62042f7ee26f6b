#pragma once
// Fields of CSV files (RFC 4180), the same in every language.

#include <algorithm>

#include <QLocale>
#include <QString>

namespace fenestra::viewer {

/// A text as a field: quoted where it holds what would end the field or the row.
inline QString csvField(const QString& text) {
  const auto parts = [](QChar each) {
    return each == QLatin1Char(',') || each == QLatin1Char('"') || each == QLatin1Char('\n') ||
           each == QLatin1Char('\r');
  };
  if (std::none_of(text.begin(), text.end(), parts)) return text;
  return QLatin1Char('"') + QString(text).replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
}

/// The shortest digits that read back as the same number, with a decimal point.
inline QString csvNumber(double number) { return QString::number(number, 'g', QLocale::FloatingPointShortest); }

}  // namespace fenestra::viewer
