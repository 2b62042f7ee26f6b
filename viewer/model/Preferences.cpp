#include "viewer/model/Preferences.h"

#include <algorithm>
#include <array>

#include <QJsonArray>
#include <QJsonDocument>
#include <QScopedValueRollback>

#include "rendering/settings/Settings.h"
#include "rendering/viewpoints/Sphere.h"
#include "viewer/model/Languages.h"
#include "viewer/model/Paths.h"
#include "viewer/model/PlacementWeights.h"

namespace fenestra::viewer {
namespace {

const QString recentKey = QStringLiteral("recent");
const QString geometryKey = QStringLiteral("layout/geometry");
const QString stateKey = QStringLiteral("layout/docks");
const QString qualityKey = QStringLiteral("picture/quality");
const QString maxErrorKey = QStringLiteral("picture/maxError");
const QString viewsKey = QStringLiteral("layout/views");
const QString serversKey = QStringLiteral("archive/servers");
const QString searchesKey = QStringLiteral("archive/searches");
const QString archiveFolderKey = QStringLiteral("archive/folder");
const QString foldedKey = QStringLiteral("layout/folded");
const QString openedKey = QStringLiteral("layout/opened");
const QString ownLayoutsKey = QStringLiteral("layout/own");
const QString ownWindowsKey = QStringLiteral("window/own");
const QString keysKey = QStringLiteral("keys/changed");
const QString placementKey = QStringLiteral("placement/%1");

struct NamedPickWeight {
  const char* name;
  double placement::LiveSyncWeights::*member;
};
const std::array<NamedPickWeight, 4> namedPickWeights{{{"pickOrientation", &placement::LiveSyncWeights::orientation},
                                                       {"pickHistory", &placement::LiveSyncWeights::history},
                                                       {"pickShape", &placement::LiveSyncWeights::shape},
                                                       {"pickVisibility", &placement::LiveSyncWeights::visibility}}};

struct NamedSwitch {
  const char* name;
  bool PlacementSettings::*member;
};
const std::array<NamedSwitch, 4> namedSwitches{{{"byPick", &PlacementSettings::byPick},
                                                {"joint", &PlacementSettings::joint},
                                                {"follow", &PlacementSettings::follow},
                                                {"automatic", &PlacementSettings::automatic}}};

std::vector<const char*> widthUnits() {
  std::vector<const char*> names;
  for (const auto& word : wordsOf(WidthUnit{})) names.push_back(word.name);
  return names;
}

std::vector<const char*> languageNames() {
  std::vector<const char*> names;
  for (const Language& each : languages) names.push_back(each.name);
  return names;
}

using Kind = PreferenceEntry::Kind;

constexpr std::array table{
    PreferenceEntry{
        Preference::Language, Kind::Choice, "window/language",
        QT_TRANSLATE_NOOP("Settings", "Language (at the next start)"),
        QT_TRANSLATE_NOOP("Settings",
                          "Language of the window's texts and numbers; it changes when Fenestra starts again"),
        0, 0, static_cast<int>(languages.size()) - 1, "", languageNames},
    PreferenceEntry{Preference::LightTheme, Kind::Switch, "window/lightTheme",
                    QT_TRANSLATE_NOOP("Settings", "Light theme"),
                    QT_TRANSLATE_NOOP("Settings", "Light colours around the pictures, for bright rooms")},
    PreferenceEntry{Preference::AnimatedCameras, Kind::Switch, "picture/animatedCameras",
                    QT_TRANSLATE_NOOP("Settings", "Animate the cameras"),
                    QT_TRANSLATE_NOOP("Settings", "Cameras fly to where they are placed instead of jumping there"), 1},
    PreferenceEntry{
        Preference::PicturesPerSecond, Kind::Number, "picture/perSecond",
        QT_TRANSLATE_NOOP("Settings", "While something moves"),
        QT_TRANSLATE_NOOP("Settings",
                          "Pictures a second to aim at: more of them are smaller on a slow machine. At rest "
                          "they always have full quality"),
        12, 4, 30, QT_TRANSLATE_NOOP("Settings", "pictures/s")},
    PreferenceEntry{Preference::Background, Kind::Colour, "picture/background",
                    QT_TRANSLATE_NOOP("Settings", "Background of new data"),
                    QT_TRANSLATE_NOOP("Settings", "Colour behind the volume when data are opened without a session"), 0,
                    0, 0xffffff},
    PreferenceEntry{
        Preference::WidthUnit, Kind::Choice, "picture/widthUnit", QT_TRANSLATE_NOOP("Settings", "Unit of new openings"),
        QT_TRANSLATE_NOOP("Settings", "What the widths of the opening are in when data are opened without a session"),
        0, 0, static_cast<int>(wordsOf(WidthUnit{}).size()) - 1, "", widthUnits},
    PreferenceEntry{Preference::HidesPatient, Kind::Switch, "picture/hidesPatient",
                    QT_TRANSLATE_NOOP("Settings", "Hide the patient"),
                    QT_TRANSLATE_NOOP("Settings",
                                      "No patient and no study in corner texts, and no folder that may be named after "
                                      "them in the recent list and in what file dialogs remember")},
    PreferenceEntry{Preference::KeepsRecent, Kind::Switch, "list/keepsRecent",
                    QT_TRANSLATE_NOOP("Settings", "Remember recent data"),
                    QT_TRANSLATE_NOOP("Settings", "List the folders and files opened last in the File menu"), 1},
    PreferenceEntry{Preference::KeepsCopies, Kind::Switch, "session/copies",
                    QT_TRANSLATE_NOOP("Settings", "Keep a copy of unsaved work"),
                    QT_TRANSLATE_NOOP("Settings", "Every minute, to be offered after a crash"), 1},
    PreferenceEntry{Preference::ArchiveGigabytes, Kind::Number, "archive/gigabytes",
                    QT_TRANSLATE_NOOP("Settings", "Objects of archives, at most"),
                    QT_TRANSLATE_NOOP("Settings",
                                      "Disk space for what was retrieved from archive servers: the series used longest "
                                      "ago go first"),
                    50, 1, 100000, QT_TRANSLATE_NOOP("Settings", "GB")},
    PreferenceEntry{Preference::Neurological, Kind::Switch, "picture/neurological",
                    QT_TRANSLATE_NOOP("Settings", "Neurological convention"),
                    QT_TRANSLATE_NOOP("Settings",
                                      "Axial and coronal slices show the patient's left on the left; "
                                      "otherwise it is on the right, as radiologists have it")}};

}  // namespace

std::span<const PreferenceEntry> preferenceTable() { return table; }

Preferences::Preferences(Mode mode) {
  if (mode == Mode::Stored) settings_.emplace();
}

int Preferences::value(Preference which) const {
  const PreferenceEntry& entry = table[static_cast<std::size_t>(which)];
  const QVariant stored = value(QLatin1String(entry.key));
  if (!stored.isValid()) return entry.otherwise;
  bool isNumber = false;
  // Switches are stored as such.
  if (entry.kind == Kind::Switch) return stored.toBool();
  const int number = stored.toInt(&isNumber);
  return isNumber && number >= entry.low && number <= entry.high ? number : entry.otherwise;
}

void Preferences::set(Preference which, int wanted) {
  const PreferenceEntry& entry = table[static_cast<std::size_t>(which)];
  const int number = std::clamp(wanted, entry.low, entry.high);
  if (number == value(which)) return;
  store(QLatin1String(entry.key), entry.kind == Kind::Switch ? QVariant(number != 0) : QVariant(number));
  if (which == Preference::KeepsRecent && number == 0) clearRecent();
  Q_EMIT changed(which);
}

void Preferences::shareWith(Preferences& other) {
  followOther(other);
  other.followOther(*this);
}

void Preferences::followOther(const Preferences& from) {
  // Stored settings are the same file, which all of this process read through one copy.
  const auto pass = [this, &from](const auto& tell) {
    if (from.follows_) return;
    const QScopedValueRollback<bool> guard(follows_, true);
    if (!settings_) unstored_ = from.unstored_;
    tell();
  };
  connect(&from, &Preferences::changed, this,
          [this, pass](Preference which) { pass([this, which] { Q_EMIT changed(which); }); });
  connect(&from, &Preferences::ownChanged, this, [this, pass] { pass([this] { Q_EMIT ownChanged(); }); });
}

const char* Preferences::language() const {
  return languages[static_cast<std::size_t>(value(Preference::Language))].code;
}

void Preferences::restoreDefaults() {
  for (const PreferenceEntry& entry : table) set(entry.which, entry.otherwise);
}

Look Preferences::startingLook(Look look) const {
  const int rgb = value(Preference::Background);
  look.background = glm::dvec3((rgb >> 16) & 255, (rgb >> 8) & 255, rgb & 255) / 255.0;
  look.cutaway.unit = wordsOf(WidthUnit{})[static_cast<std::size_t>(value(Preference::WidthUnit))].value;
  return look;
}

QVariant Preferences::value(const QString& key, const QVariant& otherwise) const {
  return settings_ ? settings_->value(key, otherwise) : unstored_.value(key, otherwise);
}

void Preferences::store(const QString& key, const QVariant& value) {
  if (settings_)
    settings_->setValue(key, value);
  else
    unstored_.insert(key, value);
}

void Preferences::remove(const QString& key) {
  if (settings_)
    settings_->remove(key);
  else
    unstored_.remove(key);
}

std::filesystem::path Preferences::looksFolder() const {
  return settings_ ? toPath(settings_->fileName()).parent_path() / "looks" : std::filesystem::path();
}

std::vector<std::filesystem::path> Preferences::recent() const {
  std::vector<std::filesystem::path> paths;
  QStringList all = hiddenRecent_ + value(recentKey).toStringList();
  all.removeDuplicates();
  for (const QString& path : all.mid(0, recentCount)) paths.push_back(toPath(path));
  return paths;
}

void Preferences::addRecent(const std::filesystem::path& path) {
  if (!isOn(Preference::KeepsRecent)) return;
  std::error_code ignored;
  const std::filesystem::path absolute = std::filesystem::absolute(path, ignored);
  const bool isHidden = isOn(Preference::HidesPatient);
  QStringList paths = isHidden ? hiddenRecent_ : value(recentKey).toStringList();
  const QString text = toQString(ignored ? path : absolute);
  hiddenRecent_.removeAll(text);
  paths.removeAll(text);
  paths.prepend(text);
  while (paths.size() > recentCount) paths.removeLast();
  if (isHidden)
    hiddenRecent_ = paths;
  else
    store(recentKey, paths);
}

void Preferences::clearRecent() {
  hiddenRecent_.clear();
  remove(recentKey);
}

Effort Preferences::atRest() const {
  Effort effort;
  const int quality = value(qualityKey, static_cast<int>(effort.quality)).toInt();
  if (quality >= static_cast<int>(Quality::Draft) && quality <= static_cast<int>(Quality::High))
    effort.quality = static_cast<Quality>(quality);
  // The file may have been edited by hand: a value out of range counts as no bound.
  const double maxError = value(maxErrorKey, 0.0).toDouble();
  constexpr double least = 0.05;  // the least that --max-error takes
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

// As JSON: Qt would write maps as bytes, in which nobody can see what is kept.
QVariantList Preferences::archiveList(const QString& key) const {
  return QJsonDocument::fromJson(value(key).toString().toUtf8()).array().toVariantList();
}

void Preferences::setArchiveList(const QString& key, const QVariantList& list) {
  store(key, QString::fromUtf8(QJsonDocument(QJsonArray::fromVariantList(list)).toJson(QJsonDocument::Compact)));
}

QVariantList Preferences::archiveServers() const { return archiveList(serversKey); }
void Preferences::setArchiveServers(const QVariantList& servers) { setArchiveList(serversKey, servers); }
QVariantList Preferences::archiveSearches() const { return archiveList(searchesKey); }
void Preferences::setArchiveSearches(const QVariantList& searches) { setArchiveList(searchesKey, searches); }
std::filesystem::path Preferences::archiveFolder() const { return toPath(value(archiveFolderKey).toString()); }

void Preferences::setArchiveFolder(const std::filesystem::path& folder) {
  if (folder.empty())
    remove(archiveFolderKey);
  else
    store(archiveFolderKey, toQString(folder));
}

QByteArray Preferences::windowGeometry() const { return value(geometryKey).toByteArray(); }
QByteArray Preferences::windowState() const { return value(stateKey).toByteArray(); }
QStringList Preferences::foldedPanels() const { return value(foldedKey).toStringList(); }
void Preferences::setFoldedPanels(const QStringList& names) { store(foldedKey, names); }
QStringList Preferences::openedPanels() const { return value(openedKey).toStringList(); }
void Preferences::setOpenedPanels(const QStringList& names) { store(openedKey, names); }
QByteArray Preferences::viewLayout() const { return value(viewsKey).toByteArray(); }

void Preferences::setLayout(const QByteArray& geometry, const QByteArray& state, const QByteArray& views) {
  store(geometryKey, geometry);
  store(stateKey, state);
  store(viewsKey, views);
}

QVariantMap Preferences::ownLayouts() const { return value(ownLayoutsKey).toMap(); }

void Preferences::setOwnLayouts(const QVariantMap& layouts) {
  store(ownLayoutsKey, layouts);
  Q_EMIT ownChanged();
}

QVariantMap Preferences::ownWindows() const { return value(ownWindowsKey).toMap(); }

void Preferences::setOwnWindows(const QVariantMap& windows) {
  store(ownWindowsKey, windows);
  Q_EMIT ownChanged();
}

QByteArray Preferences::keys() const { return value(keysKey).toByteArray(); }

void Preferences::setKeys(const QByteArray& keys) {
  if (keys.isEmpty())
    remove(keysKey);
  else
    store(keysKey, keys);
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
  for (const PlacementWeight& weight : placementWeights)
    read(weight.key, placement.options.weights.*weight.member, -mostWeight, mostWeight);
  for (const NamedPickWeight& named : namedPickWeights)
    read(named.name, placement.liveSync.weights.*named.member, 0.0, mostWeight);
  read("pickReach", placement.liveSync.reach, 1.0, 1000.0);
  const auto readSwitch = [&](const char* name, bool& on) {
    if (const QVariant value = stored(name); value.isValid()) on = value.toBool();
  };
  for (const PlacementHabit& habit : placementHabits) readSwitch(habit.key, placement.options.habits.*habit.member);
  for (const NamedSwitch& named : namedSwitches) readSwitch(named.name, placement.*named.member);
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
  for (const PlacementWeight& weight : placementWeights) keep(weight.key, options.weights.*weight.member);
  for (const NamedPickWeight& named : namedPickWeights) keep(named.name, placement.liveSync.weights.*named.member);
  keep("pickReach", placement.liveSync.reach);
  for (const PlacementHabit& habit : placementHabits) keep(habit.key, options.habits.*habit.member);
  for (const NamedSwitch& named : namedSwitches) keep(named.name, placement.*named.member);
}

}  // namespace fenestra::viewer
