#pragma once
// What `place --descriptors` reports of the view descriptors: their values, choices and rank correlations, and
// pictures from the cameras that they would choose.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "rendering/placement/FocusViews.h"
#include "rendering/scene/View.h"

namespace fenestra::cli {

/// Which view descriptors to report.
struct DescriptorOptions {
  std::vector<placement::ViewDescriptor> wanted;  ///< in the order of the enumeration
  bool representativeViews = false;               ///< also the N best views and the tour past them
  std::filesystem::path pictures;                 ///< folder for a PNG from each camera; empty: none

  bool isEmpty() const { return wanted.empty() && !representativeViews; }
  bool needsImages() const;
};

/// All names that --descriptors takes, in order.
std::vector<std::string> descriptorNames();
/// Adds what names between commas ask for; false, and `options` unchanged, when one of them is unknown.
bool selectDescriptors(const std::string& names, DescriptorOptions& options);

/// What belongs to a placement and to its scene.
struct DescribedPlacement {
  const placement::Measured& measured;
  const placement::DescribedViews& views;
  std::size_t c1;
  std::function<nlohmann::ordered_json(std::size_t)> cameraJson;  ///< of a candidate
};
/// Adds "descriptors" and "representative_views" to `json`.
void addDescriptors(nlohmann::ordered_json& json, const DescriptorOptions& options, const DescribedPlacement& placed);

/// Draws `scene` with `view`, but from each of the chosen cameras, as NAME.png in the folder of the options. Throws
/// io::Error.
void writeDescriptorPictures(const DescriptorOptions& options, const DescribedPlacement& placed,
                             const std::shared_ptr<GpuScene>& gpu, const Scene& scene, const View& view,
                             const std::function<Camera(std::size_t)>& cameraOf);

}  // namespace fenestra::cli
