// What a scene on the GPU tells about it on the CPU.

#include "tests/gl/GlTest.h"

namespace fenestra::tests {
namespace {

using GpuSceneTest = GlTest;

TEST_F(GpuSceneTest, FocusCentreIsTheSameWithAndWithoutIt) {
  // A block of 4×3×2 voxels and a lone voxel, whose eight cells are too few to be kept.
  Scene scene = valueScene(
      obliqueGrid({24, 9, 8}),
      [](glm::ivec3 v) {
        const bool isBlock = v.x >= 2 && v.x <= 5 && v.y >= 2 && v.y <= 4 && v.z >= 2 && v.z <= 3;
        return isBlock || v == glm::ivec3(20, 7, 6) ? 100.0 : 0.0;
      },
      50.0);
  const Grid& grid = scene.volume->grid;
  std::get<ValueFocus>(scene.look.focus).minimumComponent = 9.0 * grid.voxelVolume();
  GpuScene gpu;
  gpu.update(scene);
  ASSERT_TRUE(gpu.focus().centre(grid));
  EXPECT_EQ(gpu.focus().centre(grid), focusCentre(scene));
  const glm::dvec3 block(grid.worldFromIndex() * glm::dvec4(3.5, 3.0, 2.5, 1.0));
  EXPECT_LT(glm::distance(*gpu.focus().centre(grid), block), 1e-9);
}

}  // namespace
}  // namespace fenestra::tests
