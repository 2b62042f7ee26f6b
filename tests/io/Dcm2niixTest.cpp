// Every DICOM series of the collection against dcm2niix, a converter that shares no code with the project's reader: the
// same volume, in size, places and values, or a row that says why not. What it writes is read by the NIfTI library.

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include <nifti2_io.h>

#include "io/VolumeReader.h"
#include "tests/io/DifferentialPlaces.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::dcm2niixTest {
namespace fs = std::filesystem;

namespace {

constexpr std::array differences = std::to_array<Difference>({
    // Places.
    {"ct-tilt", "dcm2niix leaves out the shear of a tilted series, and writes a resampled one beside it"},
    {"S21610_S2010", "dcm2niix leaves out the shear of a tilted series, and writes a resampled one beside it"},
    {"ct-missing-slice", "dcm2niix spreads uneven slices by their first distance"},
    {"mixed-magnitude-and-phase-two-missing",
     "dcm2niix spreads uneven slices by their first distance; both are compared with the truth in HardDicomTest.cpp"},
    {"number-texts-comma-position",
     "dcm2niix cuts numbers at a decimal comma; the truth is compared in HardDicomTest.cpp"},
    {"nm-recon-tomo-negative",
     "dcm2niix does not know the order of the slices; the truth is compared in HardDicomTest.cpp"},
    {"MOVEKNEE", "dcm2niix stacks the 19 frames of one position, which differ in time, into a deep volume"},
    {"referenced-ct-77654033-CT2", "dcm2niix stacks a slice that lies far away with the three that lie together"},
    // Values.
    {"mlut_18", "dcm2niix applies no modality lookup table; GDCM is compared in DifferentialTest.cpp"},
    {"rtdose", "dcm2niix applies no dose grid scaling; GDCM is compared in DifferentialTest.cpp"},
    // PS3.5, 8.1.1: the pixel's value is the Bits Stored up to High Bit, here bits 0 to 11, and Pixel Representation 1
    // makes bit 11 the sign; bits 12 to 15 are none of it. The collection's reference, of a later dcm2niix, agrees.
    {"12bitSigned_0x0F0F",
     "dcm2niix masks the twelve bits but does not extend the sign: negative values come out 4096 "
     "higher; the reference is compared in RealDicomTest.cpp"},
    {"JPEGProcess1Transfer", "decoders of lossy JPEG may differ by rounding; GDCM is compared in DifferentialTest.cpp"},
    // Encodings that this build of dcm2niix does not decode; GDCM is compared in DifferentialTest.cpp.
    {"jpeg_ls", "dcm2niix is built without JPEG-LS"},
    {"jpegls", "dcm2niix is built without JPEG-LS"},
    {"JPEGLS", "dcm2niix is built without JPEG-LS"},
    {"fragmented", "dcm2niix decodes no multi-frame file in fragments"},
    {"emri_small_RLE", "dcm2niix decodes no multi-frame RLE"},
    {"emri_small_jpeg_2k", "dcm2niix decodes the first frame of JPEG 2000 alone"},
    {"monochrome1/RG3_J2K", "dcm2niix does not decode it"},
    {"DeflatedExplicit", "dcm2niix inflates no datasets"},
    {"JPEGProcess2_4", "dcm2niix decodes no JPEG of 12 bits"},
    {"JPEGProcess6_8", "dcm2niix decodes no JPEG of spectral selection"},
    {"JPEGProcess10_12", "dcm2niix decodes no progressive JPEG"},
});

using NiftiImage = std::unique_ptr<nifti_image, decltype(&nifti_image_free)>;

bool isInstalled() { return std::system("command -v dcm2niix > /dev/null") == 0; }

/// The images that dcm2niix makes of a folder, or of one file.
std::vector<NiftiImage> convert(const fs::path& place, const fs::path& out) {
  fs::remove_all(out);
  fs::create_directories(out);
  // No sidecars, Philips' display scaling as everybody's rescale, and one file alone where its folder holds others.
  const std::string options = std::string("-b n -z n -p n -f v%s_%r ") + (fs::is_directory(place) ? "" : "-s y ");
  [[maybe_unused]] const int code = std::system(
      ("dcm2niix " + options + "-o '" + out.string() + "' '" + place.string() + "' > /dev/null 2>&1").c_str());
  std::vector<NiftiImage> images;
  for (const auto& entry : fs::directory_iterator(out))
    if (entry.path().extension() == ".nii")
      images.emplace_back(nifti_image_read(entry.path().c_str(), 1), nifti_image_free);
  std::erase(images, nullptr);
  return images;
}

double storedAt(const nifti_image& image, std::size_t index) {
  switch (image.datatype) {
    case NIFTI_TYPE_UINT8:
      return static_cast<const std::uint8_t*>(image.data)[index];
    case NIFTI_TYPE_INT8:
      return static_cast<const std::int8_t*>(image.data)[index];
    case NIFTI_TYPE_INT16:
      return static_cast<const std::int16_t*>(image.data)[index];
    case NIFTI_TYPE_UINT16:
      return static_cast<const std::uint16_t*>(image.data)[index];
    case NIFTI_TYPE_INT32:
      return static_cast<const std::int32_t*>(image.data)[index];
    case NIFTI_TYPE_UINT32:
      return static_cast<const std::uint32_t*>(image.data)[index];
    case NIFTI_TYPE_FLOAT32:
      return static_cast<const float*>(image.data)[index];
    case NIFTI_TYPE_FLOAT64:
      return static_cast<const double*>(image.data)[index];
    default:
      return std::nan("");
  }
}

/// LPS from the image's voxels.
glm::dmat4 worldFromIndex(const nifti_image& image) {
  const auto& ras = image.sform_code > 0 ? image.sto_xyz.m : image.qto_xyz.m;
  glm::dmat4 matrix(1.0);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) matrix[column][row] = (row < 2 ? -1.0 : 1.0) * ras[row][column];
  return matrix;
}

/// Both lattices in voxels: where voxel (0, 0, 0) of ours is among theirs, and which way each of our axes runs there.
struct Fit {
  glm::dmat4 theirsFromOurs{1.0};
  double millimetres = 0.0;  ///< how far the corners lie from voxels of theirs
};
Fit fitOf(const Grid& grid, const nifti_image& image) {
  const glm::dmat4 theirs = worldFromIndex(image), between = glm::inverse(theirs) * grid.worldFromIndex();
  Fit fit;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) fit.theirsFromOurs[column][row] = std::round(between[column][row]);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 index((corner & 1) * (grid.dims.x - 1), (corner >> 1 & 1) * (grid.dims.y - 1),
                           (corner >> 2) * (grid.dims.z - 1), 1.0);
    fit.millimetres = std::max(fit.millimetres, glm::distance(glm::dvec3(grid.worldFromIndex() * index),
                                                              glm::dvec3(theirs * (fit.theirsFromOurs * index))));
  }
  return fit;
}
/// The four ways in which rows and slices may run, whatever the places.
std::vector<Fit> unplacedFits(const Grid& grid) {
  std::vector<Fit> fits;
  for (const bool turnsRows : {false, true})
    for (const bool turnsSlices : {false, true}) {
      Fit fit;
      const auto turn = [&](int axis) {
        fit.theirsFromOurs[axis][axis] = -1.0;
        fit.theirsFromOurs[3][axis] = grid.dims[axis] - 1;
      };
      if (turnsRows) turn(1);
      if (turnsSlices) turn(2);
      fits.push_back(fit);
    }
  return fits;
}

/// How many voxels of our volume have another value in the image's volume `time`; slopes are of single precision there.
std::size_t differing(const Volume& volume, const nifti_image& image, std::int64_t time, const Fit& fit) {
  const glm::ivec3 size(image.nx, image.ny, image.nz);
  const double slope = image.scl_slope != 0.0 ? image.scl_slope : 1.0, intercept = image.scl_inter;
  std::size_t count = 0;
  for (int z = 0; z < volume.grid.dims.z; ++z)
    for (int y = 0; y < volume.grid.dims.y; ++y)
      for (int x = 0; x < volume.grid.dims.x; ++x) {
        const glm::ivec3 there(glm::round(glm::dvec3(fit.theirsFromOurs * glm::dvec4(x, y, z, 1.0))));
        if (glm::any(glm::lessThan(there, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(there, size))) {
          ++count;
          continue;
        }
        const std::size_t index = static_cast<std::size_t>(
            there.x + size.x * (there.y + size.y * (there.z + static_cast<std::int64_t>(size.z) * time)));
        const double stored = storedAt(image, index), theirs = slope * stored + intercept;
        const double ours = volume.value({x, y, z});
        const double rounding = 2e-7 * (std::abs(slope * stored) + std::abs(intercept) + std::abs(ours));
        count += !(std::abs(ours - theirs) <= rounding);
      }
  return count;
}

bool hasPlaces(const io::OpenedVolume& opened) {
  return std::none_of(opened.warnings.begin(), opened.warnings.end(),
                      [](const io::Warning& warning) { return warning.kind == io::Warning::Kind::NoGeometry; });
}

/// The least number of values that differ from a volume of the image; all, where the sizes differ.
std::size_t leastDiffering(const Volume& volume, const nifti_image& image, const std::vector<Fit>& fits) {
  std::size_t least = volume.grid.voxelCount();
  if (static_cast<std::int64_t>(least) != image.nx * image.ny * image.nz) return least;
  for (const Fit& fit : fits)
    for (std::int64_t time = 0; time < std::max<std::int64_t>(1, image.nt); ++time)
      least = std::min(least, differing(volume, image, time, fit));
  return least;
}

/// How our volume differs from the image that is nearest to it; empty where one is the same.
std::string differenceOf(const io::OpenedVolume& opened, const std::vector<NiftiImage>& images) {
  constexpr double alike = 0.01;  // mm: sixteen-character decimal strings, and single precision in NIfTI
  if (images.empty()) return "dcm2niix makes no volume of it";
  const Volume& volume = *opened.volume;
  std::string sizes;
  std::size_t least = volume.grid.voxelCount();
  double farthest = 0.0;
  for (const NiftiImage& image : images) {
    sizes += " " + std::to_string(image->nx) + " x " + std::to_string(image->ny) + " x " + std::to_string(image->nz);
    const Fit placed = fitOf(volume.grid, *image);
    if (!hasPlaces(opened)) {
      least = std::min(least, leastDiffering(volume, *image, unplacedFits(volume.grid)));
    } else if (placed.millimetres <= alike) {
      least = std::min(least, leastDiffering(volume, *image, {placed}));
    } else if (leastDiffering(volume, *image, unplacedFits(volume.grid)) == 0) {
      farthest = placed.millimetres;
    }
    if (least == 0) return {};
  }
  if (farthest > 0.0) return "values agree, places are up to " + std::to_string(farthest) + " mm apart";
  if (least < volume.grid.voxelCount())
    return std::to_string(least) + " of " + std::to_string(volume.grid.voxelCount()) + " values differ";
  return "dcm2niix makes other volumes:" + sizes;
}

/// All volumes at one place.
void compareAt(const fs::path& place, const fs::path& out, DifferentialCounts& counts) {
  const std::vector<io::SeriesInfo> series = imageSeriesAt(place);
  if (series.empty()) return;
  const std::vector<NiftiImage> images = convert(place, out);
  compareSeries(
      place, series, differences, [&images](const io::OpenedVolume& opened) { return differenceOf(opened, images); },
      counts);
}

}  // namespace

TEST(Dcm2niix, Thorough_EveryDicomSeriesIsAsDcm2niixConvertsItOrARowSaysWhyNot) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  if (!isInstalled()) GTEST_SKIP() << "dcm2niix is not installed";
  const fs::path out = scratchFolder() / "nifti";
  DifferentialCounts counts;
  for (const fs::path& place : dicomPlaces()) compareAt(place, out, counts);
  std::cout << "volumes: " << counts.text() << "\n";
  EXPECT_GT(counts.agreeing, 40);
}

}  // namespace fenestra::tests::dcm2niixTest
