#pragma once
// A volume as 3-D pictures show it: some of its voxels are air. Rows are masked as they are read, so there is never a
// second copy of the voxels.

#include <cmath>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include "rendering/scene/RemovedVoxels.h"
#include "rendering/settings/Reconstruction.h"
#include "rendering/volume/CoarseMask.h"
#include "rendering/volume/LabelMap.h"
#include "rendering/volume/Volume.h"

namespace fenestra {

/// What is shown; equal ones show the same.
struct ShownVolume {
  std::shared_ptr<const Volume> volume;
  std::shared_ptr<const CoarseMask> table = nullptr;       ///< hidden voxels; null: none
  std::shared_ptr<const LabelMap> labels = nullptr;        ///< on the same grid; null where no label is hidden
  std::vector<std::uint16_t> hidden = {};                  ///< labels whose voxels are hidden: ascending, each once
  Reconstruction reconstruction = Reconstruction::Linear;  ///< never Auto
  std::shared_ptr<const RemovedVoxels> removed = nullptr;  ///< on the same grid; null: nothing

  bool operator==(const ShownVolume&) const = default;
};

/// Reads the voxels. A hidden voxel has the value of air, -1000 HU, or the volume's least value where that is more or
/// there are no Hounsfield units; darker voxels stay as they are. A voxel that is removed in part has a mix
/// of its own value and of that one. Lasts no longer than the shown volume.
class ShownVoxels {
 public:
  explicit ShownVoxels(const ShownVolume& shown);

  const Volume& volume() const { return *shown_.volume; }
  /// Real value of one voxel, and at a continuous index position, as Volume has them.
  double value(glm::ivec3 index) const;
  double sample(glm::dvec3 index) const;
  /// How much of a voxel is air, of 255.
  std::uint8_t airShare(glm::ivec3 index) const {
    const bool isHidden = (shown_.table && shown_.table->contains(index)) ||
                          (shown_.labels && isHiddenLabel_[shown_.labels->value(index)]);
    return isHidden ? all : shown_.removed ? shown_.removed->at(index) : std::uint8_t{0};
  }
  /// Whether a voxel has left the focus because it is removed.
  bool isGone(glm::ivec3 index) const { return shown_.removed && RemovedVoxels::isGone(shown_.removed->at(index)); }
  /// Real value of air.
  double air() const { return volume().slope * air_ + volume().intercept; }
  bool hidesNothing() const { return !shown_.table && !shown_.labels && !shown_.removed; }

  /// A value of which a share, of 255, is air.
  template <class T>
  static T mixed(T value, T air, std::uint8_t share) {
    if (share == 0) return value;
    if (share == all) return air;
    const double own = static_cast<double>(value), mix = own + (static_cast<double>(air) - own) * (share / 255.0);
    return static_cast<T>(std::is_floating_point_v<T> ? mix : std::round(mix));
  }

  /// A row of stored scalars, of the volume's type: the volume's own where nothing in it is hidden, or a copy in
  /// `buffer`.
  template <class T>
  const T* row(int y, int z, std::vector<T>& buffer) const {
    const T* own = volume().voxels.template as<T>().data() + volume().grid.offset({0, y, z});
    if (hidesNothing()) return own;
    const int width = volume().grid.dims.x;
    const T air = airAs<T>();
    bool copied = false;
    const auto hide = [&](int x, std::uint8_t share = all) {
      if (!copied) buffer.assign(own, own + width);
      copied = true;
      T& scalar = buffer[static_cast<std::size_t>(x)];
      if (isBrighter(scalar, air)) scalar = mixed(own[x], air, share);
    };
    // First, because what is hidden has more air than what is removed in part.
    if (shown_.removed) shown_.removed->forEachIn(y, z, hide);
    if (shown_.table)
      shown_.table->forEachCell(y, z, width, [&](int begin, int end) {
        for (int x = begin; x < end; ++x) hide(x);
      });
    if (shown_.labels)
      shown_.labels->voxels.visit([&](auto labels) {
        const auto* row = labels.data() + volume().grid.offset({0, y, z});
        for (int x = 0; x < width; ++x)
          if (isHiddenLabel_[static_cast<std::uint16_t>(row[x])]) hide(x);
      });
    return copied ? buffer.data() : own;
  }

  /// A stored scalar as it is shown at a voxel.
  template <class T>
  T shown(T stored, glm::ivec3 index) const {
    const T air = airAs<T>();
    return isBrighter(stored, air) ? mixed(stored, air, airShare(index)) : stored;
  }

 private:
  static constexpr std::uint8_t all = 255;

  template <class T>
  T airAs() const {
    return static_cast<T>(std::is_floating_point_v<T> ? air_ : std::round(air_));
  }
  /// NaN counts as brighter.
  template <class T>
  bool isBrighter(T scalar, T air) const {
    return rising_ ? !(scalar <= air) : !(scalar >= air);
  }

  const ShownVolume& shown_;
  double air_ = 0.0;  ///< stored
  bool rising_ = true;
  std::vector<std::uint8_t> isHiddenLabel_;  ///< per label value; empty where none is hidden
};

/// The real value of a stored one: NaN becomes the volume's least value, ±Inf the ends of its range.
template <class T>
double realValue(const Volume& volume, T stored) {
  const double value = volume.slope * static_cast<double>(stored) + volume.intercept;
  if constexpr (std::is_integral_v<T>) return value;
  if (std::isnan(value)) return volume.range.low;
  return std::isinf(value) ? (value < 0.0 ? volume.range.low : volume.range.high) : value;
}

/// Calls f(valueAt) with valueAt(index) the real value of a voxel as it is shown.
template <class F>
decltype(auto) withValues(const ShownVolume& shown, F&& f) {
  const Volume& volume = *shown.volume;
  const ShownVoxels voxels(shown);
  return volume.voxels.visit([&](auto scalars) -> decltype(auto) {
    return f([&volume, &voxels, scalars, whole = voxels.hidesNothing()](glm::ivec3 index) {
      auto stored = scalars[volume.grid.offset(index)];
      if (!whole) stored = voxels.shown(stored, index);
      return realValue(volume, stored);
    });
  });
}

}  // namespace fenestra
