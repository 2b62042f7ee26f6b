// Every readable DICOM file of the collection against GDCM: all voxels, and the geometry.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "io/base/Words.h"
#include "tests/io/GdcmPeer.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::realDicomTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

GdcmImage readWithGdcm(const fs::path& file) {
  std::vector<GdcmImage> images = tests::readWithGdcm({file}, file.filename() == "rtdose.dcm");
  if (images.empty()) {
    ADD_FAILURE() << "GDCM reads no image from " << file;
    return {};
  }
  return std::move(images.front());
}

/// Compares slice `z` with `count` values. Slices whose rescales differ are stored as float32.
void expectSlice(const Volume& volume, int z, const double* expected, double tolerance = 0.0) {
  const std::size_t count = static_cast<std::size_t>(volume.grid.dims.x) * static_cast<std::size_t>(volume.grid.dims.y);
  const bool isFloat = volume.voxels.type() == ScalarType::Float32;
  std::size_t different = 0;
  double worst = 0.0;
  volume.voxels.visit([&](auto scalars) {
    const auto* slice = scalars.data() + count * static_cast<std::size_t>(z);
    for (std::size_t i = 0; i < count; ++i) {
      const double wanted = isFloat ? static_cast<double>(static_cast<float>(expected[i])) : expected[i];
      const double off = std::abs(volume.slope * static_cast<double>(slice[i]) + volume.intercept - wanted);
      if (off <= tolerance) continue;
      ++different;
      worst = std::max(worst, off);
    }
  });
  EXPECT_EQ(different, 0u) << "voxels of slice " << z << " differ, by up to " << worst;
}

void expectPlane(const Grid& grid, const GdcmRecord& peer) {
  EXPECT_EQ(grid.dims.x, peer.dims.x);
  EXPECT_EQ(grid.dims.y, peer.dims.y);
  EXPECT_NEAR(grid.spacing.x, peer.spacing.x, 1e-9);
  EXPECT_NEAR(grid.spacing.y, peer.spacing.y, 1e-9);
  // Direction cosines in files are rounded to some six digits; ours are normalised.
  EXPECT_LE(glm::distance(grid.direction[0], peer.row), 1e-5);
  EXPECT_LE(glm::distance(grid.direction[1], peer.column), 1e-5);
}

glm::dvec3 slicePosition(const Grid& grid, int z) { return glm::dvec3(grid.worldFromIndex() * glm::dvec4(0, 0, z, 1)); }

/// The slices of a folder as GDCM reads them, sorted by their positions.
std::vector<GdcmImage> slicesOf(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::vector<GdcmImage> slices = tests::readWithGdcm(files);
  if (slices.empty()) return slices;
  const glm::dvec3 normal = glm::cross(slices[0].header.row, slices[0].header.column);
  std::sort(slices.begin(), slices.end(), [&](const GdcmImage& a, const GdcmImage& b) {
    return glm::dot(a.header.origin, normal) < glm::dot(b.header.origin, normal);
  });
  return slices;
}

/// A folder of single-slice files: GDCM's, sorted by their positions, are our slices as stored. `ends`: only the first
/// and the last lie where the grid says.
void expectSeries(const fs::path& folder, std::size_t slices, bool ends = false) {
  SCOPED_TRACE(folder.filename().string());
  const io::OpenedVolume opened = io::openVolume(folder, {.regularise = io::Regularise::Off});
  const Grid& grid = opened.volume->grid;
  const std::vector<GdcmImage> peers = slicesOf(folder);
  ASSERT_EQ(peers.size(), slices);
  ASSERT_EQ(grid.dims.z, static_cast<int>(slices));
  for (int z = 0; z < grid.dims.z; ++z) {
    const GdcmImage& peer = peers[static_cast<std::size_t>(z)];
    expectPlane(grid, peer.header);
    // Sixteen-character decimal strings; silent below 0.01 mm.
    if (!ends || z == 0 || z + 1 == grid.dims.z) {
      EXPECT_LE(glm::distance(slicePosition(grid, z), peer.header.origin), 0.01) << "slice " << z;
    }
    expectSlice(*opened.volume, z, peer.values.data());
  }
}

/// Linear interpolation of slices at a point of the patient, on the line through it along `direction`; NaN outside.
double valueAt(const std::vector<GdcmImage>& slices, glm::dvec3 at, glm::dvec3 direction) {
  // std::lerp makes a number of NaN and a number.
  const auto lerp = [](double a, double b, double f) { return (1.0 - f) * a + f * b; };
  const GdcmRecord& first = slices[0].header;
  const glm::dvec3 row = glm::normalize(first.row), column = glm::normalize(first.column);
  const glm::dvec3 normal = glm::normalize(glm::cross(row, column));
  const auto height = [&](std::size_t slice) { return glm::dot(slices[slice].header.origin - at, normal); };
  const auto within = [&](std::size_t slice) {
    const glm::dvec3 hit = at + direction * (height(slice) / glm::dot(direction, normal)) - slices[slice].header.origin;
    const double x = glm::dot(hit, row) / first.spacing.x, y = glm::dot(hit, column) / first.spacing.y;
    if (x < 0.0 || y < 0.0 || x > first.dims.x - 1 || y > first.dims.y - 1) return std::nan("");
    const int left = std::min(static_cast<int>(x), first.dims.x - 2),
              top = std::min(static_cast<int>(y), first.dims.y - 2);
    const auto pixel = [&](int i, int j) {
      return slices[slice].values[static_cast<std::size_t>((top + j) * first.dims.x + left + i)];
    };
    return lerp(lerp(pixel(0, 0), pixel(1, 0), x - left), lerp(pixel(0, 1), pixel(1, 1), x - left), y - top);
  };
  for (std::size_t i = 0; i + 1 < slices.size(); ++i)
    if (height(i) <= 1e-6 && height(i + 1) >= -1e-6) {
      const double f = std::clamp(-height(i) / (height(i + 1) - height(i)), 0.0, 1.0);
      return f < 1e-6 ? within(i) : f > 1.0 - 1e-6 ? within(i + 1) : lerp(within(i), within(i + 1), f);
    }
  return std::nan("");
}

/// The volume's voxels are the slices' values at the voxels' places, rounded; every 7th voxel is looked at.
void expectRegular(const fs::path& folder, io::Regularise regularise) {
  SCOPED_TRACE(folder.filename().string() + ", " + wordOf(regularise).word);
  const io::OpenedVolume opened = io::openVolume(folder, {.regularise = regularise});
  const std::vector<GdcmImage> slices = slicesOf(folder);
  const Volume& volume = *opened.volume;
  ASSERT_TRUE(opened.geometry);
  EXPECT_LE(opened.geometry->displacement, 0.01);
  std::size_t compared = 0, different = 0, index = 0;
  for (int z = 0; z < volume.grid.dims.z; ++z)
    for (int y = 0; y < volume.grid.dims.y; ++y)
      for (int x = 0; x < volume.grid.dims.x; ++x, ++index) {
        if (index % 7 != 0) continue;
        const glm::dvec3 at(volume.grid.worldFromIndex() * glm::dvec4(x, y, z, 1));
        const double expected = valueAt(slices, at, volume.grid.direction[2]);
        if (std::isnan(expected)) continue;
        ++compared;
        // Half a unit by rounding; a thousandth for positions that are known to a micrometre.
        // Half a unit by rounding. Values within a micrometre of a slice or of its pixels are taken as they are: up to
        // 0.002 pixels, which is 0.6 units where neighbours differ by 300.
        different += !(std::abs(volume.value({x, y, z}) - expected) <= 0.5 + 0.6);
      }
  EXPECT_EQ(different, 0u) << "of " << compared;
  EXPECT_GT(compared, volume.grid.voxelCount() / 7 / 2);
}

/// One file whose frames `first`, `first + 1`, … are our slices, or the other way round.
void expectFrames(const fs::path& file, int first = 0, bool reversed = false, const std::string& series = "",
                  bool placed = true) {
  SCOPED_TRACE(file.filename().string());
  const io::OpenedVolume opened = io::openVolume(file, {.series = series});
  const Grid& grid = opened.volume->grid;
  const GdcmImage image = readWithGdcm(file);
  const GdcmRecord& peer = image.header;
  ASSERT_LE(first + grid.dims.z, peer.dims.z);
  const std::size_t count = static_cast<std::size_t>(peer.dims.x) * static_cast<std::size_t>(peer.dims.y);
  for (int z = 0; z < grid.dims.z; ++z) {
    const int frame = first + (reversed ? grid.dims.z - 1 - z : z);
    expectSlice(*opened.volume, z, image.values.data() + count * static_cast<std::size_t>(frame));
  }
  if (!placed) return;
  expectPlane(grid, peer);
  if (first == 0) {
    EXPECT_LE(glm::distance(slicePosition(grid, reversed ? grid.dims.z - 1 : 0), peer.origin), 0.01);
  }
  if (grid.dims.z > 1) {
    EXPECT_NEAR(grid.spacing.z, std::abs(peer.spacing.z), 1e-3);
  }
}

/// Both volumes hold the same values at the same places in the patient.
void expectSameInWorld(const Volume& actual, const Volume& reference, double tolerance, double unit = 1.0) {
  ASSERT_EQ(actual.grid.voxelCount(), reference.grid.voxelCount());
  const glm::dmat4 referenceFromActual = reference.grid.indexFromWorld() * actual.grid.worldFromIndex();
  std::size_t different = 0;
  double farthest = 0.0;
  for (int z = 0; z < actual.grid.dims.z; ++z)
    for (int y = 0; y < actual.grid.dims.y; ++y)
      for (int x = 0; x < actual.grid.dims.x; ++x) {
        const glm::dvec3 at(referenceFromActual * glm::dvec4(x, y, z, 1));
        const glm::dvec3 nearest = glm::round(at);
        farthest = std::max(farthest, glm::distance(at, nearest));
        const glm::ivec3 index(nearest);
        if (!reference.grid.contains(index)) {
          ++different;
          continue;
        }
        different += !(std::abs(actual.value({x, y, z}) - unit * reference.value(index)) <= tolerance);
      }
  EXPECT_EQ(different, 0u);
  // References are NIfTI, whose single precision adds up over a few hundred voxels.
  EXPECT_LE(farthest, 0.01) << "voxels from the lattice";
}

}  // namespace

TEST(RealDicom, VisibleHumanHead) {
  const fs::path folder = unpackTestData("visible-human/VHMCT1mm_Head.tar.xz", "VHMCT1mm_Head");
  if (folder.empty()) GTEST_SKIP() << "needs the test-data file visible-human/VHMCT1mm_Head.tar.xz";
  expectSeries(folder, 245);
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
  EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(1.0));
  EXPECT_EQ(opened.volume->grid.origin, glm::dvec3(0, 0, 1000));
}

TEST(RealDicom, TiltedPhilipsSeries) {
  const fs::path folder = unpackTestData("dicom/ct-tilt-philips-S21610_S2010.tar.xz", "S21610_S2010");
  if (folder.empty()) GTEST_SKIP() << "needs the test-data file dicom/ct-tilt-philips-S21610_S2010.tar.xz";
  expectSeries(folder, 54);
  EXPECT_NE(warningOf(io::openVolume(folder).warnings, Warning::Kind::GantryTilt).text.find("18.5 degrees"),
            std::string::npos);
}

TEST(RealDicom, SingleSliceSeries) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  expectSeries(dicom / "ct-tiny-uniform", 93);
  expectSeries(dicom / "ct-tilt-irregular-ge", 28, true);
  expectSeries(dicom / "ct-tilt-siemens-notag", 4);
  expectSeries(dicom / "ct-missing-slice", 4, true);
  expectSeries(dicom / "ct-missing-slice-tilted", 4, true);
  for (const char* name : {"uncompressed", "compressed_j2k", "compressed_jpeg", "compressed_jpegls", "compressed_rle"})
    expectSeries(dicom / "transfer-syntax" / "mr-series" / name, 4);
  expectSeries(dicom / "pixel-formats" / "per-slice-rescale-nonsquare", 4);
  expectSeries(dicom / "seg" / "dcmqi" / "ct-3slice", 3);
  expectSeries(dicom / "seg" / "dcmqi-24x38x3" / "image", 3);
  expectSeries(dicom / "rtstruct" / "rt-utils", 2);
  expectSeries(dicom / "rtstruct" / "dicompyler", 1);
  FENESTRA_TEST_DATA_OR_SKIP(torso, "labelled/totalsegmentator-dicom/example_ct_dicom");
  expectSeries(torso, 20);
}

TEST(RealDicom, IrregularSeriesAreInterpolatedAtTheirTruePlaces) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  for (const char* name : {"ct-tilt-irregular-ge", "ct-missing-slice", "ct-missing-slice-tilted"})
    for (const io::Regularise choice : {io::Regularise::Automatic, io::Regularise::Linear})
      expectRegular(dicom / name, choice);
  const fs::path tilted = unpackTestData("dicom/ct-tilt-philips-S21610_S2010.tar.xz", "S21610_S2010");
  if (!tilted.empty()) expectRegular(tilted, io::Regularise::Linear);
}

TEST(RealDicom, AMissingTiltedSliceIsWhereAnotherConverterHasIt) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/ct-missing-slice-tilted");
  // dicom2nifti fills the missing slice along the table, and then reslices at right angles with zeros outside.
  const io::OpenedVolume opened = io::openVolume(folder);
  const Volume& ours = *opened.volume;
  EXPECT_EQ(ours.grid.dims, glm::ivec3(512, 512, 5));
  const auto reference = io::openVolume(folder / "002_ground_truth.nii.gz").volume;
  const glm::dmat4 oursFromReference = ours.grid.indexFromWorld() * reference->grid.worldFromIndex();
  std::size_t compared = 0, different = 0;
  for (int z = 0; z < reference->grid.dims.z; ++z)
    for (int y = 0; y < reference->grid.dims.y; ++y)
      for (int x = 0; x < reference->grid.dims.x; ++x) {
        const glm::dvec3 at(oursFromReference * glm::dvec4(x, y, z, 1));
        const double value = reference->value({x, y, z});
        constexpr double margin = 0.01;
        if (value == 0.0 || glm::any(glm::lessThan(at, glm::dvec3(-margin))) ||
            glm::any(glm::greaterThan(at, glm::dvec3(ours.grid.dims - 1) + margin)))
          continue;
        ++compared;
        // Both round what lies in the gap, and the reference rounds again when it reslices.
        different += !(std::abs(ours.sample(at) - value) <= 1.01);
      }
  EXPECT_EQ(different, 0u) << "of " << compared;
  EXPECT_GT(compared, 800000u);
}

TEST(RealDicom, OddGeometryIsSaid) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  const auto warned = [&](const char* folder, Warning::Kind kind) {
    return warningOf(io::openVolume(dicom / folder).warnings, kind).text;
  };
  EXPECT_NE(warned("ct-tilt-irregular-ge", Warning::Kind::GantryTilt).find("18.5 degrees"), std::string::npos);
  EXPECT_NE(warned("ct-tilt-irregular-ge", Warning::Kind::UnevenSpacing).find("between 1.081 mm and 6.999 mm"),
            std::string::npos);
  EXPECT_NE(warned("ct-tilt-siemens-notag", Warning::Kind::GantryTilt).find("14 degrees"), std::string::npos);
  EXPECT_NE(warned("ct-missing-slice", Warning::Kind::MissingSlices).find("1 slice missing"), std::string::npos);
  EXPECT_NE(warned("ct-missing-slice-tilted", Warning::Kind::MissingSlices).find("1 slice missing"), std::string::npos);
  EXPECT_NE(warned("ct-missing-slice-tilted", Warning::Kind::GantryTilt).find("15.5 degrees"), std::string::npos);
  EXPECT_TRUE(io::openVolume(dicom / "ct-tiny-uniform").warnings.empty());
}

TEST(RealDicom, TransferSyntaxes) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/transfer-syntax/single-ct");
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    expectFrames(entry.path());
    ++files;
  }
  EXPECT_EQ(files, 16u);
}

TEST(RealDicom, PixelFormats) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/pixel-formats");
  for (const char* name :
       {"CT_small.dcm", "MR_small.dcm", "MR_small_bigendian.dcm", "MR_small_implicit.dcm", "MR_small_expb.dcm",
        "MR_small_RLE.dcm", "MR_small_jp2klossless.dcm", "MR_small_jpeg_ls_lossless.dcm", "rtdose.dcm"})
    expectFrames(folder / name);
  // Projections have no place in the patient.
  for (const char* name :
       {"monochrome1/dx_image.dcm", "monochrome1/RG3_J2KI.dcm", "monochrome1/RG3_J2KR.dcm", "mlut_18.dcm"})
    expectFrames(folder / name, 0, false, "", false);
  EXPECT_NE(errorOf([&] { io::openVolume(folder / "rgb-series"); }).find("RGB"), std::string::npos);
}

TEST(RealDicom, Mosaics) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/pixel-formats/12bit");
  const std::pair<const char*, const char*> files[] = {
      {"12bitUnsigned.dcm", "2.nii"}, {"12bitUnsigned_0x0F0F.dcm", "3.nii"}, {"12bitSigned_0x0F0F.dcm", "4.nii"}};
  for (const auto& [name, reference] : files) {
    SCOPED_TRACE(name);
    const auto volume = io::openVolume(folder / name).volume;
    ASSERT_EQ(volume->grid.dims, glm::ivec3(64, 64, 35));
    // GDCM reads the picture of 6 x 6 tiles.
    const GdcmImage picture = readWithGdcm(folder / name);
    ASSERT_EQ(picture.header.dims, glm::ivec3(384, 384, 1));
    std::size_t different = 0;
    for (int z = 0; z < 35; ++z)
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
          different += volume->value({x, y, z}) !=
                       picture.values[static_cast<std::size_t>((z / 6 * 64 + y) * 384 + z % 6 * 64 + x)];
    EXPECT_EQ(different, 0u);
    expectSameInWorld(*volume, *io::openVolume(folder / reference).volume, 0.0);
  }
}

TEST(RealDicom, EnhancedMultiFrame) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/enhanced");
  // Two frames, the second below the first.
  for (const char* name : {"explicit_little_endian", "fragmented_no_bot_jpeg_lossless.57",
                           "fragmented_no_bot_jpeg_lossless.70", "not_fragmented_bot_jpeg_ls.80",
                           "not_fragmented_bot_rle", "not_fragmented_no_bot_jpeg_ls.80", "not_fragmented_no_bot_rle"})
    expectFrames(folder / std::string("CT0012.").append(name).append(".dcm"), 0, true);
  expectFrames(folder / "6_1.dcm");
  for (const char* name : {"emri_small.dcm", "emri_small_RLE.dcm", "emri_small_big_endian.dcm",
                           "emri_small_jpeg_2k_lossless.dcm", "emri_small_jpeg_ls_lossless.dcm"}) {
    expectFrames(folder / name, 0, false, "", false);
    warningOf(io::openVolume(folder / name).warnings, Warning::Kind::NoGeometry);
  }
  expectFrames(folder / ".." / "seg" / "dcmqi-24x38x3" / "multiframe" / "mf.dcm");
}

TEST(RealDicom, FragmentedFramesThatGdcmDoesNotDecode) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/enhanced");
  // This file holds the image without loss, and GDCM reads it as we do.
  const GdcmImage plain = readWithGdcm(folder / "CT0012.explicit_little_endian.dcm");
  struct Variant {
    const char* name;
    double offset, tolerance;
  };
  // JPEG-LS near lossless was made with an error bound of 2. The 12-bit JPEG was made of values 1024 higher, and its
  // quality leaves errors of some dozens.
  for (const auto& [name, offset, tolerance] :
       {Variant{"jpeg_ls.80", 0.0, 0.0}, Variant{"jpeg_ls.81", 0.0, 2.0}, Variant{"jpeg_baseline.51", 1024.0, 60.0}}) {
    SCOPED_TRACE(name);
    const auto volume =
        io::openVolume(folder / std::string("CT0012.fragmented_no_bot_").append(name).append(".dcm")).volume;
    std::vector<double> expected = plain.values;
    for (double& value : expected) value += offset;
    const std::size_t count = expected.size() / 2;
    expectSlice(*volume, 0, expected.data() + count, tolerance);
    expectSlice(*volume, 1, expected.data(), tolerance);
  }
}

TEST(RealDicom, FramesAtOnePositionAreTimePoints) {
  FENESTRA_TEST_DATA_OR_SKIP(file, "dicom/enhanced/MOVEKNEE.dcm");
  const std::vector<io::SeriesInfo> series = io::listSeries(file);
  ASSERT_EQ(series.size(), 19u);
  for (int frame = 0; frame < 19; ++frame)
    expectFrames(file, frame, false, series[static_cast<std::size_t>(frame)].id, false);
  // GDCM finds no spacing in the frames' own groups; the header gives it as 0.625 in each.
  EXPECT_EQ(io::openVolume(file).volume->grid.spacing.x, 0.625);
  warningOf(io::openVolume(file).warnings, Warning::Kind::TimePoints);
}

TEST(RealDicom, TwoVolumesInOneFile) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/enhanced");
  const fs::path file = folder / "IM_0027_fMAP.dcm";
  const std::vector<io::SeriesInfo> series = io::listSeries(file);
  ASSERT_EQ(series.size(), 2u);
  const auto reference = [&](const char* name) { return io::openVolume(folder / name).volume; };
  const auto magnitude = io::openVolume(file, {.series = series[0].id}).volume;
  const auto magnitudeReference = reference("Philips_WIP_B0_NS_801_e1.nii");
  EXPECT_EQ(magnitude->grid.dims, glm::ivec3(64, 64, 32));
  // Its converter used the maker's own scale of the same stored values, in single precision.
  expectSameInWorld(*magnitude, *magnitudeReference, 1e-3, magnitude->slope / magnitudeReference->slope);
  const auto fieldMap = io::openVolume(file, {.series = series[1].id}).volume;
  EXPECT_EQ(fieldMap->grid.dims, glm::ivec3(64, 64, 32));
  // Its slope is 0.244202 where the header has 0.2442002: a fortieth of one stored step at 4095.
  expectSameInWorld(*fieldMap, *reference("Philips_WIP_B0_NS_801_e2_fieldmaphz.nii"), 0.01);
}

TEST(RealDicom, ReferencesOfOtherConverters) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  const fs::path series = dicom / "transfer-syntax" / "mr-series";
  expectSameInWorld(*io::openVolume(series / "uncompressed").volume,
                    *io::openVolume(series / "uncompressed_001_ground_truth.nii.gz").volume, 0.0);
  for (const char* name : {"compressed_j2k", "compressed_jpeg", "compressed_jpegls", "compressed_rle"})
    expectSameInWorld(*io::openVolume(series / name).volume,
                      *io::openVolume(series / "compressed_001_ground_truth.nii.gz").volume, 0.0);
  const fs::path rescaled = dicom / "pixel-formats" / "per-slice-rescale-nonsquare";
  expectSameInWorld(*io::openVolume(rescaled).volume,
                    *io::openVolume(rescaled / "002_non_isotropic_ground_truth.nii.gz").volume, 1e-5);
}

TEST(RealDicom, FarSliceIsAVolumeOfItsOwn) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/seg/highdicom");
  expectFrames(folder / "ct_image.dcm");
  const fs::path series = folder / "referenced-ct-77654033-CT2";
  const io::OpenedVolume opened = io::openVolume(series);
  ASSERT_EQ(opened.volume->grid.dims, glm::ivec3(16, 16, 3));
  const char* ordered[] = {"17136", "17166", "17196"};
  for (int z = 0; z < 3; ++z) {
    const GdcmImage peer = readWithGdcm(series / ordered[z]);
    EXPECT_LE(glm::distance(slicePosition(opened.volume->grid, z), peer.header.origin), 1e-9);
    expectSlice(*opened.volume, z, peer.values.data());
  }
  ASSERT_EQ(opened.otherSeries.size(), 1u);
  const io::OpenedVolume far = io::openVolume(series, {.series = opened.otherSeries[0].id});
  expectSlice(*far.volume, 0, readWithGdcm(series / "17106").values.data());
}

TEST(RealDicom, ObjectsThatAreNoImagesAreRefused) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  for (const char* name :
       {"seg/dcmqi/liver.dcm", "seg/dcmqi/partial_overlaps.dcm", "seg/dcmqi-24x38x3/seg/label.seg",
        "seg/highdicom/seg_image_ct_binary.dcm", "seg/highdicom/seg_image_ct_binary_fractional.dcm",
        "seg/highdicom/seg_image_ct_binary_overlap.dcm", "seg/highdicom/seg_image_ct_binary_single_frame.dcm",
        "seg/highdicom/seg_image_ct_true_fractional.dcm"})
    EXPECT_NE(errorOf([&] { io::openVolume(dicom / name); }).find("DICOM segmentation"), std::string::npos) << name;
  for (const char* name : {"rtstruct/rt-utils/rt.dcm", "rtstruct/dicompyler/rtss.dcm"})
    EXPECT_NE(errorOf([&] { io::openVolume(dicom / name); }).find("is a DICOM structure set, not an image"),
              std::string::npos)
        << name;
}

}  // namespace fenestra::tests::realDicomTest
