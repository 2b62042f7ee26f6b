#include "viewer/model/NumberText.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QLocale>

namespace fenestra::viewer {
namespace {

struct NumberWords {
  Q_DECLARE_TR_FUNCTIONS(Number)
};

/// Three digits at least; all before the point, in groups of three.
QString digits(double value) {
  const int decimals = value > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(value))), 0, 4) : 0;
  QString text = numberText(value, decimals);
  qsizetype point = text.indexOf(QLocale().decimalPoint());
  if (point < 0) point = text.size();
  for (qsizetype at = point - 3; at > 0; at -= 3) text.insert(at, QChar(QChar::Nbsp));
  return text;
}

}  // namespace

QString numberText(double value, int decimals, char format) {
  QLocale locale;
  locale.setNumberOptions(locale.numberOptions() | QLocale::OmitGroupSeparator);
  return locale.toString(value, format, decimals);
}

QString volumeText(double ml) {
  constexpr double perLitre = 1000.0, mostMl = 10.0 * perLitre;
  return ml < mostMl ? NumberWords::tr("%1 ml").arg(digits(ml)) : NumberWords::tr("%1 l").arg(digits(ml / perLitre));
}

QString unitText(const std::string& unit) {
  const QString text = QString::fromStdString(unit).simplified();
  // "Hounsfield Units", and as some programs spell it.
  if (text.startsWith(QLatin1String("hounsfield"), Qt::CaseInsensitive) ||
      text.startsWith(QLatin1String("houndsfield"), Qt::CaseInsensitive))
    return QStringLiteral("HU");
  constexpr qsizetype most = 10;
  return text.size() > most ? text.left(most - 1) + QChar(0x2026) : text;
}

QString unitSuffix(const std::string& unit) {
  const QString text = unitText(unit);
  return text.isEmpty() ? text : QLatin1Char(' ') + text;
}

}  // namespace fenestra::viewer
