#pragma once
// The parts of a document that its history changes.

#include <cstdint>
#include <memory>
#include <vector>

#include "io/session/Session.h"
#include "rendering/settings/Look.h"
#include "rendering/volume/LabelMap.h"
#include "rendering/volume/SliceMeasure.h"

namespace fenestra::viewer {

/// What the steps of a history read and replace. Each show...() reports what differs from before, and is no step
/// itself.
class DocumentParts {
 public:
  virtual const Look& look() const = 0;
  virtual const std::shared_ptr<const LabelMap>& labels() const = 0;
  virtual void show(Look look) = 0;
  /// `revision`: the number of the labels' state.
  virtual void showLabels(std::shared_ptr<const LabelMap> labels, std::uint64_t revision, Focus focus) = 0;
  virtual void showMeasures(std::vector<Measure> measures) = 0;
  virtual void showPath(std::vector<glm::dvec3> path) = 0;
  virtual void showKeyImages(std::vector<io::KeyImage> images) = 0;

 protected:
  ~DocumentParts() = default;
};

}  // namespace fenestra::viewer
