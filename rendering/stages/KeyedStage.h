#pragma once
// A stage that runs again when what it reads has changed.

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "rendering/stages/Stage.h"

namespace fenestra {

/// A stage's images follow from its key, which states everything that it reads, and from the brush strokes, which are
/// not part of the key: where they alone have changed, the stage runs for the pixels under them, with the result of a
/// run for all, and its version stays, because later stages do the same.
template <class Key>
class KeyedStage : public Stage {
 public:
  using Stage::Stage;

  void release() override {
    Stage::release();
    forget();
    version_ = {};
  }

 protected:
  Version version() const { return version_; }  ///< tells states of the images apart
  /// What the images were made from; empty where that is not known: before the first run, and after one that was
  /// dropped half way.
  const std::optional<Key>& lastKey() const { return key_; }
  bool isStale(const Key& key) const { return key_ != key; }
  void forget() { key_.reset(); }

  /// Where strokes have changed since the images were made.
  std::vector<gl::Region> changedStrokes(const Sight& sight) const {
    return key_ ? sight.changedSince(strokes_) : std::vector<gl::Region>();
  }

  /// What of the images has to be drawn anew.
  struct Extent {
    std::optional<gl::Region> part{};   ///< all that depends on what the key has changed in; empty: the whole picture
    std::vector<gl::Region> changed{};  ///< where strokes have changed
  };

  /// Adds steps by add(regions) where the key has changed or strokes have. Until they are done the images are of no
  /// key.
  template <class Add>
  void update(const Sight& sight, Steps& steps, Key key, const Extent& extent, const Add& add) {
    const bool stale = isStale(key);
    if (!stale && extent.changed.empty()) {
      strokes_ = sight.strokes;
      return;
    }
    std::vector<gl::Region> regions;
    if (stale) regions.push_back(extent.part.value_or(gl::Region{glm::ivec2(0), sight.rays.size()}));
    if (!stale || extent.part) regions.insert(regions.end(), extent.changed.begin(), extent.changed.end());
    forget();
    addSteps(steps, regions, add, [this, made = std::move(key), strokes = sight.strokes, stale] {
      key_ = made;
      strokes_ = strokes;
      if (stale) version_ = newVersion();
    });
  }

 private:
  std::optional<Key> key_;
  std::shared_ptr<const ProjectedStrokes> strokes_;
  Version version_;
};

}  // namespace fenestra
