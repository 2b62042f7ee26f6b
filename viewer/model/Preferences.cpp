#include "viewer/model/Preferences.h"

#include <QStringList>

#include "viewer/model/Paths.h"

namespace fenestra::viewer {
namespace {

const QString recentKey = QStringLiteral("recent");
const QString geometryKey = QStringLiteral("layout/geometry");
const QString stateKey = QStringLiteral("layout/docks");
const QString qualityKey = QStringLiteral("picture/quality");
const QString maxErrorKey = QStringLiteral("picture/maxError");
const QString viewsKey = QStringLiteral("layout/views");

}  // namespace

std::vector<std::filesystem::path> Preferences::recent() const {
  std::vector<std::filesystem::path> paths;
  for (const QString& path : settings_.value(recentKey).toStringList()) paths.push_back(toPath(path));
  return paths;
}

void Preferences::addRecent(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path absolute = std::filesystem::absolute(path, ignored);
  QStringList paths = settings_.value(recentKey).toStringList();
  const QString text = toQString(ignored ? path : absolute);
  paths.removeAll(text);
  paths.prepend(text);
  while (paths.size() > recentCount) paths.removeLast();
  settings_.setValue(recentKey, paths);
}

void Preferences::clearRecent() { settings_.remove(recentKey); }

Effort Preferences::atRest() const {
  Effort effort;
  const int quality = settings_.value(qualityKey, static_cast<int>(effort.quality)).toInt();
  if (quality >= static_cast<int>(Quality::Draft) && quality <= static_cast<int>(Quality::High))
    effort.quality = static_cast<Quality>(quality);
  // The file may have been edited by hand: what is no bound is none.
  const double maxError = settings_.value(maxErrorKey, 0.0).toDouble();
  constexpr double least = 0.05;  // as --max-error takes
  if (maxError >= least && maxError <= 255.0) effort.maxError = maxError;
  return effort;
}

void Preferences::setAtRest(const Effort& effort) {
  settings_.setValue(qualityKey, static_cast<int>(effort.quality));
  if (effort.maxError)
    settings_.setValue(maxErrorKey, *effort.maxError);
  else
    settings_.remove(maxErrorKey);
}

QByteArray Preferences::windowGeometry() const { return settings_.value(geometryKey).toByteArray(); }
QByteArray Preferences::windowState() const { return settings_.value(stateKey).toByteArray(); }
QByteArray Preferences::viewLayout() const { return settings_.value(viewsKey).toByteArray(); }

void Preferences::setLayout(const QByteArray& geometry, const QByteArray& state, const QByteArray& views) {
  settings_.setValue(geometryKey, geometry);
  settings_.setValue(stateKey, state);
  settings_.setValue(viewsKey, views);
}

}  // namespace fenestra::viewer
