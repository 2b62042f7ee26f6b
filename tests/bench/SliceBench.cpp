// slice-bench: how fast slices and slabs are computed through a volume of 512 × 512 × 2000 voxels. Prints a Markdown
// table. Memory: 1.1 GB.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "rendering/volume/ObliqueSlice.h"
#include "rendering/volume/Slab.h"
#include "tests/support/LargeVolume.h"

namespace {

using namespace fenestra;

Volume largeVolume() {
  Volume volume;
  volume.grid.dims = {tests::large::side, tests::large::side, tests::large::slices};
  volume.grid.spacing = {0.7, 0.7, 0.7};
  volume.voxels = Voxels(ScalarType::Int16, volume.grid.voxelCount());
  auto to = volume.voxels.as<std::int16_t>().begin();
  for (int z = 0; z < tests::large::slices; ++z) to = std::ranges::copy(tests::large::sliceOf(z), to).out;
  return volume;
}

struct Times {
  double wall = 0.0;       ///< ms, median
  double processor = 0.0;  ///< ms of all cores, least
};

/// Medians of nine runs, each of another slice, so that no voxels are at hand from the run before.
template <class F>
Times timed(F&& slice) {
  std::vector<double> walls, processors;
  for (int run = 0; run < 9; ++run) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t used = std::clock();
    slice(20 * run);
    processors.push_back(1000.0 * static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC);
    walls.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(walls.begin(), walls.end());
  return {walls[walls.size() / 2], *std::min_element(processors.begin(), processors.end())};
}

void row(const char* name, const Times& times) {
  std::printf("| %s | %.1f | %.1f | %.0f |\n", name, times.wall, times.processor, 1000.0 / times.wall);
}

/// 700 × 700 pixels of half a millimetre across `normal`.
SliceGeometry obliquely(const Grid& grid, glm::dvec3 normal) {
  return sliceAround(SlicePlane::Axial, planeAxes(grid, normal), grid.centre(), {700, 700}, 0.5);
}

}  // namespace

int main() {
  const Volume volume = largeVolume();
  std::printf("%u cores\n\n| Slice | ms | ms of processors | a second |\n|---|---:|---:|---:|\n",
              std::thread::hardware_concurrency());
  const SliceGeometry axial = sliceGeometry(volume.grid, SlicePlane::Axial);
  row("axial, 512 × 512", timed([&](int slice) { sliceValues(volume, axial, 900 + slice); }));
  row("axial, slab of 10 mm, mean", timed([&](int slice) {
        slabValues(volume, axial, 900 + slice, {10.0, SlabMode::Mean});
      }));
  struct Direction {
    const char* name;
    glm::dvec3 normal;
  };
  for (const Direction& each :
       {Direction{"20° from axial", {0.2, 0.28, 0.94}}, Direction{"20° from coronal", {0.28, 0.94, 0.2}},
        Direction{"20° from sagittal", {0.94, 0.2, 0.28}}, Direction{"diagonal", {1.0, 1.0, 1.0}}}) {
    const SliceGeometry geometry = obliquely(volume.grid, each.normal);
    const std::string name = std::string(each.name) + ", 700 × 700";
    row(name.c_str(), timed([&](int slice) { sliceValues(volume, geometry, slice); }));
    for (const auto& [mode, word] :
         {std::pair(SlabMode::Maximum, "maximum"), {SlabMode::Minimum, "minimum"}, {SlabMode::Mean, "mean"}})
      row((name + ", slab of 10 mm, " + word).c_str(), timed([&, m = mode](int slice) {
            slabValues(volume, geometry, slice, {10.0, m});
          }));
  }
  return 0;
}
