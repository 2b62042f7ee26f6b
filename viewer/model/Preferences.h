#pragma once
// What is remembered between two runs. Nothing that the data says about a patient is stored: the recent list holds
// paths as the user chose them.

#include <filesystem>
#include <vector>

#include <QByteArray>
#include <QSettings>

#include "viewer/model/FramePacer.h"
#include "viewer/model/PlacementController.h"

namespace fenestra::viewer {

class Preferences {
 public:
  static constexpr int recentCount = 8;

  /// Latest first; paths that are gone are kept, they may lie on a disk that is away.
  std::vector<std::filesystem::path> recent() const;
  void addRecent(const std::filesystem::path& path);
  void clearRecent();

  /// How the 3-D views are drawn when nothing moves.
  Effort atRest() const;
  void setAtRest(const Effort& effort);

  QByteArray windowGeometry() const;
  QByteArray windowState() const;
  QByteArray viewLayout() const;
  void setLayout(const QByteArray& geometry, const QByteArray& state, const QByteArray& views);

  /// How cameras are placed; what was never stored, or makes no sense, is the default.
  PlacementSettings placement() const;
  void setPlacement(const PlacementSettings& placement);

 private:
  QSettings settings_;
};

}  // namespace fenestra::viewer
