#pragma once
// Settings kept between two runs. Nothing that the data says about a patient is stored: the recent list holds paths as
// the user chose them.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include <QByteArray>
#include <QHash>
#include <QObject>
#include <QSettings>
#include <QStringList>
#include <QVariant>
#include <QVariantMap>

#include "rendering/settings/Look.h"
#include "viewer/model/FramePacer.h"
#include "viewer/model/PlacementController.h"

namespace fenestra::viewer {

/// The settings of the settings dialog.
enum class Preference : std::uint8_t {
  Language,
  LightTheme,
  AnimatedCameras,
  PicturesPerSecond,
  Background,
  WidthUnit,
  HidesPatient,
  KeepsRecent,
  KeepsCopies,
  ArchiveGigabytes,
  Neurological
};

/// A preference's declaration: storage, the dialog and the defaults are made from preferenceTable().
struct PreferenceEntry {
  /// A colour is 0xRRGGBB; a choice is an index into `words`.
  enum class Kind : std::uint8_t { Switch, Number, Colour, Choice };
  Preference which;
  Kind kind = Kind::Switch;
  const char* key;          ///< in the file of settings
  const char* name;         ///< label in the dialog
  const char* description;  ///< tool tip
  int otherwise = 0;        ///< default; 0 or 1 for a switch
  int low = 0, high = 1;
  const char* unit = "";
  std::vector<const char*> (*words)() = nullptr;  ///< the names of a choice's entries
};
std::span<const PreferenceEntry> preferenceTable();

class Preferences : public QObject {
  Q_OBJECT
 public:
  /// Transient: all preferences begin with their defaults, and none is stored.
  enum class Mode : std::uint8_t { Stored, Transient };
  static constexpr int recentCount = 8;

  explicit Preferences(Mode mode = Mode::Stored);

  /// The code of the language that was chosen (Languages.h); empty: the desktop's.
  const char* language() const;
  /// A stored value out of range counts as the default.
  int value(Preference which) const;
  bool isOn(Preference which) const { return value(which) != 0; }
  void set(Preference which, int value);
  /// For two windows of one run: what is set in one shows in the other, too. Both outlive the other's use.
  void shareWith(Preferences& other);
  /// Sets every entry of the table to its default.
  void restoreDefaults();
  /// The look that data without a session is opened with: `look`, with the user's own defaults in it.
  Look startingLook(Look look) const;

  /// Latest first. Paths that no longer exist stay listed: they may lie on a disk that is not connected.
  std::vector<std::filesystem::path> recent() const;
  /// A path that is added while the patient is hidden is known to this run alone: it may name the patient.
  void addRecent(const std::filesystem::path& path);
  void clearRecent();

  /// How the 3-D views are drawn when nothing moves.
  Effort atRest() const;
  void setAtRest(const Effort& effort);

  /// Where the user's presets of looks are; empty when transient.
  std::filesystem::path looksFolder() const;

  /// Archive servers and searches, each a map of values that viewer/archive makes; none holds a secret or what was
  /// searched of a patient.
  QVariantList archiveServers() const;
  void setArchiveServers(const QVariantList& servers);
  QVariantList archiveSearches() const;
  void setArchiveSearches(const QVariantList& searches);
  /// Where objects of archives are kept; empty: in the user's cache.
  std::filesystem::path archiveFolder() const;
  void setArchiveFolder(const std::filesystem::path& folder);

  QByteArray windowGeometry() const;
  QByteArray windowState() const;
  QByteArray viewLayout() const;
  /// Names of the panels that are folded.
  QStringList foldedPanels() const;
  void setFoldedPanels(const QStringList& names);
  /// Those that the user opened last, by the names of their objects, the latest first.
  QStringList openedPanels() const;
  void setOpenedPanels(const QStringList& names);
  void setLayout(const QByteArray& geometry, const QByteArray& state, const QByteArray& views);

  /// The user's own layouts of the views by name, as ViewArea::saveLayout() gives them.
  QVariantMap ownLayouts() const;
  void setOwnLayouts(const QVariantMap& layouts);
  /// The user's own windows by name: width and level.
  QVariantMap ownWindows() const;
  void setOwnWindows(const QVariantMap& windows);
  /// The keys that the user has changed, as KeyBindings writes them; empty: none.
  QByteArray keys() const;
  void setKeys(const QByteArray& keys);

  /// How cameras are placed. Values that were never stored or are out of range have their defaults.
  PlacementSettings placement() const;
  void setPlacement(const PlacementSettings& placement);

 Q_SIGNALS:
  void changed(Preference which);
  /// ownLayouts() or ownWindows() changed.
  void ownChanged();

 private:
  QVariant value(const QString& key, const QVariant& otherwise = {}) const;
  void store(const QString& key, const QVariant& value);
  void remove(const QString& key);
  /// Passes on what `from` says has changed.
  void followOther(const Preferences& from);
  QVariantList archiveList(const QString& key) const;
  void setArchiveList(const QString& key, const QVariantList& list);

  std::optional<QSettings> settings_;  ///< empty when transient
  QHash<QString, QVariant> unstored_;  ///< when transient
  QStringList hiddenRecent_;           ///< added while the patient is hidden, latest first
  bool follows_ = false;               ///< what changes now was set in another window
};

}  // namespace fenestra::viewer
