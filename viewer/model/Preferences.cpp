#include "viewer/model/Preferences.h"

#include <array>

#include <QStringList>

#include "rendering/viewpoints/Sphere.h"
#include "viewer/model/Paths.h"

namespace fenestra::viewer {
namespace {

const QString recentKey = QStringLiteral("recent");
const QString geometryKey = QStringLiteral("layout/geometry");
const QString stateKey = QStringLiteral("layout/docks");
const QString qualityKey = QStringLiteral("picture/quality");
const QString maxErrorKey = QStringLiteral("picture/maxError");
const QString viewsKey = QStringLiteral("layout/views");
const QString animatedKey = QStringLiteral("picture/animatedCameras");
const QString hidesPatientKey = QStringLiteral("picture/hidesPatient");
const QString lightKey = QStringLiteral("window/lightTheme");
const QString placementKey = QStringLiteral("placement/%1");

struct NamedWeight {
  const char* name;
  double placement::Weights::*member;
};
const std::array<NamedWeight, 8> namedWeights{{{"weightDepth", &placement::Weights::visibility},
                                               {"weightCoverage", &placement::Weights::coverage},
                                               {"weightLocation", &placement::Weights::location},
                                               {"weightEntropy", &placement::Weights::entropy},
                                               {"weightTypical", &placement::Weights::mutualInformation},
                                               {"weightStability", &placement::Weights::stability},
                                               {"weightOrientation", &placement::Weights::orientation},
                                               {"weightEndFace", &placement::Weights::endFace}}};
struct NamedSwitch {
  const char* name;
  bool PlacementSettings::*member;
};
const std::array<NamedSwitch, 3> namedSwitches{{{"joint", &PlacementSettings::joint},
                                                {"follow", &PlacementSettings::follow},
                                                {"automatic", &PlacementSettings::automatic}}};

}  // namespace

Preferences::Preferences(Mode mode) {
  if (mode == Mode::Stored) settings_.emplace();
}

QVariant Preferences::value(const QString& key, const QVariant& otherwise) const {
  return settings_ ? settings_->value(key, otherwise) : otherwise;
}

void Preferences::store(const QString& key, const QVariant& value) {
  if (settings_) settings_->setValue(key, value);
}

void Preferences::remove(const QString& key) {
  if (settings_) settings_->remove(key);
}

std::filesystem::path Preferences::looksFolder() const {
  return settings_ ? toPath(settings_->fileName()).parent_path() / "looks" : std::filesystem::path();
}

std::vector<std::filesystem::path> Preferences::recent() const {
  std::vector<std::filesystem::path> paths;
  for (const QString& path : value(recentKey).toStringList()) paths.push_back(toPath(path));
  return paths;
}

void Preferences::addRecent(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path absolute = std::filesystem::absolute(path, ignored);
  QStringList paths = value(recentKey).toStringList();
  const QString text = toQString(ignored ? path : absolute);
  paths.removeAll(text);
  paths.prepend(text);
  while (paths.size() > recentCount) paths.removeLast();
  store(recentKey, paths);
}

void Preferences::clearRecent() { remove(recentKey); }

Effort Preferences::atRest() const {
  Effort effort;
  const int quality = value(qualityKey, static_cast<int>(effort.quality)).toInt();
  if (quality >= static_cast<int>(Quality::Draft) && quality <= static_cast<int>(Quality::High))
    effort.quality = static_cast<Quality>(quality);
  // The file may have been edited by hand: a value out of range counts as no bound.
  const double maxError = value(maxErrorKey, 0.0).toDouble();
  constexpr double least = 0.05;  // as --max-error takes
  if (maxError >= least && maxError <= 255.0) effort.maxError = maxError;
  return effort;
}

void Preferences::setAtRest(const Effort& effort) {
  store(qualityKey, static_cast<int>(effort.quality));
  if (effort.maxError)
    store(maxErrorKey, *effort.maxError);
  else
    remove(maxErrorKey);
}

bool Preferences::animatesCameras() const { return value(animatedKey, true).toBool(); }
void Preferences::setAnimatesCameras(bool animates) { store(animatedKey, animates); }

bool Preferences::hidesPatient() const { return value(hidesPatientKey, false).toBool(); }
void Preferences::setHidesPatient(bool hides) { store(hidesPatientKey, hides); }
bool Preferences::hasLightTheme() const { return value(lightKey, false).toBool(); }
void Preferences::setLightTheme(bool light) { store(lightKey, light); }

QByteArray Preferences::windowGeometry() const { return value(geometryKey).toByteArray(); }
QByteArray Preferences::windowState() const { return value(stateKey).toByteArray(); }
QByteArray Preferences::viewLayout() const { return value(viewsKey).toByteArray(); }

void Preferences::setLayout(const QByteArray& geometry, const QByteArray& state, const QByteArray& views) {
  store(geometryKey, geometry);
  store(stateKey, state);
  store(viewsKey, views);
}

PlacementSettings Preferences::placement() const {
  PlacementSettings placement;
  const auto stored = [this](const char* name) { return value(placementKey.arg(QLatin1String(name))); };
  const auto read = [&](const char* name, double& value, double low, double high) {
    bool good = false;
    const double number = stored(name).toDouble(&good);
    if (good && number >= low && number <= high) value = number;
  };
  if (const int count = stored("samples").toInt(); count <= 12288 && placement::sideOf(count))
    placement.sampling.count = count;
  placement.sampling.refined = stored("refined").toBool();
  if (stored("region").toString() == QLatin1String("stream")) placement.options.region = placement::Region::Stream;
  read("streamHalfWidth", placement.options.streamHalfWidth, 0.0, 90.0);
  read("shareWeight", placement.options.shareWeight, 0.0, 1.0);
  constexpr double mostWeight = 1e3;
  for (const NamedWeight& weight : namedWeights)
    read(weight.name, placement.options.weights.*weight.member, -mostWeight, mostWeight);
  for (const NamedSwitch& named : namedSwitches)
    if (const QVariant value = stored(named.name); value.isValid()) placement.*named.member = value.toBool();
  return placement;
}

void Preferences::setPlacement(const PlacementSettings& placement) {
  const auto keep = [this](const char* name, const QVariant& value) {
    store(placementKey.arg(QLatin1String(name)), value);
  };
  const placement::Options& options = placement.options;
  keep("samples", placement.sampling.count);
  keep("refined", placement.sampling.refined);
  keep("region",
       options.region == placement::Region::Stream ? QStringLiteral("stream") : QStringLiteral("semi-sphere"));
  keep("streamHalfWidth", options.streamHalfWidth);
  keep("shareWeight", options.shareWeight);
  for (const NamedWeight& weight : namedWeights) keep(weight.name, options.weights.*weight.member);
  for (const NamedSwitch& named : namedSwitches) keep(named.name, placement.*named.member);
}

}  // namespace fenestra::viewer
