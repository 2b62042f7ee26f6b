#pragma once
// A scene's voxels and tables as GPU objects, made when a picture first needs them and remade when the scene's part
// behind them changes.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "rendering/scene/Scene.h"

namespace fenestra {

class GpuScene {
 public:
  GpuScene();
  ~GpuScene();
  GpuScene(const GpuScene&) = delete;
  GpuScene& operator=(const GpuScene&) = delete;

  /// GPU memory by resource, for reports: name and bytes.
  struct Resource {
    std::string name;
    std::size_t bytes = 0;
  };
  std::vector<Resource> resources() const;

  struct State;  ///< for the passes
  State& state() { return *state_; }

 private:
  std::unique_ptr<State> state_;
};

}  // namespace fenestra
