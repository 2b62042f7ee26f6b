#pragma once
// Settings kept between two runs. Nothing that the data says about a patient is stored: the recent list holds paths as
// the user chose them.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include <QByteArray>
#include <QSettings>
#include <QVariant>

#include "viewer/model/FramePacer.h"
#include "viewer/model/PlacementController.h"

namespace fenestra::viewer {

class Preferences {
 public:
  /// Transient: all preferences have their defaults, and none is stored.
  enum class Mode : std::uint8_t { Stored, Transient };
  static constexpr int recentCount = 8;

  explicit Preferences(Mode mode = Mode::Stored);

  /// Latest first. Paths that no longer exist stay listed: they may lie on a disk that is not connected.
  std::vector<std::filesystem::path> recent() const;
  void addRecent(const std::filesystem::path& path);
  void clearRecent();

  /// How the 3-D views are drawn when nothing moves.
  Effort atRest() const;
  void setAtRest(const Effort& effort);

  /// Whether the cameras fly to where they are placed.
  bool animatesCameras() const;
  void setAnimatesCameras(bool animates);

  /// Whether patient and study are hidden in corner text and in the list of recent data.
  bool hidesPatient() const;
  void setHidesPatient(bool hides);
  bool hasLightTheme() const;
  void setLightTheme(bool light);

  /// Where the user's presets of looks are; empty when transient.
  std::filesystem::path looksFolder() const;

  QByteArray windowGeometry() const;
  QByteArray windowState() const;
  QByteArray viewLayout() const;
  void setLayout(const QByteArray& geometry, const QByteArray& state, const QByteArray& views);

  /// How cameras are placed. Values that were never stored or are out of range have their defaults.
  PlacementSettings placement() const;
  void setPlacement(const PlacementSettings& placement);

 private:
  QVariant value(const QString& key, const QVariant& otherwise = {}) const;
  void store(const QString& key, const QVariant& value);
  void remove(const QString& key);

  std::optional<QSettings> settings_;  ///< empty when transient
};

}  // namespace fenestra::viewer
