// NIfTI-2, which ITK does not read, against the format's reference implementation: all voxels, and the geometry. A
// program of its own, because ITK carries that implementation's first version with the same names.

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include <nifti2_io.h>

#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {

TEST(RealImage, Nifti2) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "formats/nifti/example_nifti2.nii.gz");
  const std::unique_ptr<nifti_image, decltype(&nifti_image_free)> peer(nifti_image_read(path.c_str(), 1),
                                                                       nifti_image_free);
  ASSERT_NE(peer, nullptr);
  ASSERT_EQ(peer->nt, 2);
  ASSERT_EQ(peer->datatype, NIFTI_TYPE_INT16);
  ASSERT_GT(peer->sform_code, 0);
  const double slope = peer->scl_slope != 0.0 ? peer->scl_slope : 1.0;

  const io::OpenedVolume opened = io::openVolume(path);
  warningOf(opened.warnings, io::Warning::Kind::TimePoints);
  const Grid& grid = opened.volume->grid;
  ASSERT_EQ(grid.dims, glm::ivec3(peer->nx, peer->ny, peer->nz));
  const auto* values = static_cast<const std::int16_t*>(peer->data);
  const std::vector<double> actual = realValues(*opened.volume);
  ASSERT_EQ(actual.size(), grid.voxelCount());
  for (std::size_t i = 0; i < actual.size(); ++i)
    ASSERT_EQ(actual[i], slope * values[i] + peer->scl_inter) << "voxel " << i;

  // NIfTI's world is RAS.
  const auto& rasFromIndex = peer->sto_xyz.m;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 index((corner & 1) * (grid.dims.x - 1), (corner >> 1 & 1) * (grid.dims.y - 1),
                           (corner >> 2) * (grid.dims.z - 1), 1.0);
    glm::dvec3 world(0.0);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column) world[row] += rasFromIndex[row][column] * index[column];
    world = world * glm::dvec3(-1.0, -1.0, 1.0);
    EXPECT_LT(glm::distance(glm::dvec3(grid.worldFromIndex() * index), world), 1e-9) << "corner " << corner;
  }
}

}  // namespace fenestra::tests
