// Every readable DICOM file of the collection against GDCM: all voxels, and the geometry.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <numeric>

#include <gtest/gtest.h>

#include <gdcmByteValue.h>
#include <gdcmImageHelper.h>
#include <gdcmImageReader.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmSplitMosaicFilter.h>
#include <gdcmTrace.h>

#include "io/VolumeReader.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace fs = std::filesystem;
using io::Warning;

namespace {

/// A file as GDCM reads it.
struct Peer {
  glm::ivec3 dims{1};
  glm::dvec3 origin{0.0}, spacing{1.0};
  glm::dvec3 row{0.0}, column{0.0};
  std::vector<double> values;   ///< real, x fastest, frames in stored order
};

std::vector<double> rescaled(const gdcm::Image& image, double slope, double intercept) {
  std::vector<char> bytes(image.GetBufferLength());
  EXPECT_TRUE(image.GetBuffer(bytes.data()));
  const gdcm::PixelFormat& format = image.GetPixelFormat();
  const std::size_t word = format.GetBitsAllocated() / 8;
  std::vector<double> values(bytes.size() / word);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, bytes.data() + i * word, word);
    const std::uint64_t sign = std::uint64_t{1} << (8 * word - 1);
    const bool negative = format.GetPixelRepresentation() == 1 && (bits & sign);
    const std::int64_t stored = static_cast<std::int64_t>(bits) - (negative ? static_cast<std::int64_t>(sign) * 2 : 0);
    values[i] = slope * static_cast<double>(stored) + intercept;
  }
  return values;
}

Peer readWithGdcm(const fs::path& path, bool mosaic = false) {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::ImageHelper::SetForceRescaleInterceptSlope(true);
  gdcm::ImageHelper::SetForcePixelSpacing(true);
  gdcm::ImageReader reader;
  reader.SetFileName(path.c_str());
  EXPECT_TRUE(reader.Read()) << path;
  const gdcm::Image* image = &reader.GetImage();
  gdcm::SplitMosaicFilter splitter;
  if (mosaic) {
    splitter.SetImage(*image);
    splitter.SetFile(reader.GetFile());
    EXPECT_TRUE(splitter.Split());
    image = &splitter.GetImage();
  }
  Peer peer;
  for (unsigned axis = 0; axis < image->GetNumberOfDimensions(); ++axis) peer.dims[static_cast<int>(axis)] = static_cast<int>(image->GetDimension(axis));
  for (unsigned i = 0; i < 3; ++i) {
    const auto axis = static_cast<int>(i);
    peer.origin[axis] = image->GetOrigin(i);
    peer.spacing[axis] = image->GetSpacing(i);
    peer.row[axis] = image->GetDirectionCosines(i);
    peer.column[axis] = image->GetDirectionCosines(i + 3);
  }
  peer.values = rescaled(*image, image->GetSlope(), image->GetIntercept());
  return peer;
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

void expectPlane(const Grid& grid, const Peer& peer) {
  EXPECT_EQ(grid.dims.x, peer.dims.x);
  EXPECT_EQ(grid.dims.y, peer.dims.y);
  EXPECT_NEAR(grid.spacing.x, peer.spacing.x, 1e-9);
  EXPECT_NEAR(grid.spacing.y, peer.spacing.y, 1e-9);
  // Direction cosines in files are rounded to some six digits; ours are normalised.
  EXPECT_LE(glm::distance(grid.direction[0], peer.row), 1e-5);
  EXPECT_LE(glm::distance(grid.direction[1], peer.column), 1e-5);
}

glm::dvec3 slicePosition(const Grid& grid, int z) { return glm::dvec3(grid.worldFromIndex() * glm::dvec4(0, 0, z, 1)); }

/// A folder of single-slice files: GDCM's, sorted by their positions, are our slices. `ends`: only the first and the last
/// lie where the grid says.
void expectSeries(const fs::path& folder, std::size_t slices, bool ends = false) {
  SCOPED_TRACE(folder.filename().string());
  const io::OpenedVolume opened = io::openVolume(folder);
  const Grid& grid = opened.volume->grid;
  std::vector<Peer> peers;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    gdcm::ImageReader probe;
    probe.SetFileName(entry.path().c_str());
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
    if (entry.path().extension() != ".gz" && probe.Read()) peers.push_back(readWithGdcm(entry.path()));
  }
  ASSERT_EQ(peers.size(), slices);
  ASSERT_EQ(grid.dims.z, static_cast<int>(slices));
  const glm::dvec3 normal = glm::cross(peers[0].row, peers[0].column);
  std::sort(peers.begin(), peers.end(),
            [&](const Peer& a, const Peer& b) { return glm::dot(a.origin, normal) < glm::dot(b.origin, normal); });
  for (int z = 0; z < grid.dims.z; ++z) {
    const Peer& peer = peers[static_cast<std::size_t>(z)];
    expectPlane(grid, peer);
    // Sixteen-character decimal strings; silent below 0.01 mm.
    if (!ends || z == 0 || z + 1 == grid.dims.z) {
      EXPECT_LE(glm::distance(slicePosition(grid, z), peer.origin), 0.01) << "slice " << z;
    }
    expectSlice(*opened.volume, z, peer.values.data());
  }
}

/// One file whose frames `first`, `first + 1`, … are our slices, or the other way round.
void expectFrames(const fs::path& file, int first = 0, bool reversed = false, const std::string& series = "", bool mosaic = false,
                  double tolerance = 0.0, bool placed = true) {
  SCOPED_TRACE(file.filename().string());
  const io::OpenedVolume opened = io::openVolume(file, {.series = series});
  const Grid& grid = opened.volume->grid;
  const Peer peer = readWithGdcm(file, mosaic);
  ASSERT_LE(first + grid.dims.z, peer.dims.z);
  const std::size_t count = static_cast<std::size_t>(peer.dims.x) * static_cast<std::size_t>(peer.dims.y);
  for (int z = 0; z < grid.dims.z; ++z) {
    const int frame = first + (reversed ? grid.dims.z - 1 - z : z);
    expectSlice(*opened.volume, z, peer.values.data() + count * static_cast<std::size_t>(frame), tolerance);
  }
  if (!placed) return;
  expectPlane(grid, peer);
  if (first == 0) {
    EXPECT_LE(glm::distance(slicePosition(grid, reversed ? grid.dims.z - 1 : 0), peer.origin), 0.01);
  }
  if (grid.dims.z > 1) {
    EXPECT_NEAR(grid.spacing.z, peer.spacing.z, 1e-3);
  }
}

/// Both volumes hold the same values at the same places in the patient.
void expectSameInWorld(const Volume& actual, const Volume& reference, double relative) {
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
        const double wanted = reference.value(index);
        different += !(std::abs(actual.value({x, y, z}) - wanted) <= relative * std::abs(wanted));
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
  EXPECT_NE(warningOf(io::openVolume(folder).warnings, Warning::Kind::GantryTilt).text.find("18.5 degrees"), std::string::npos);
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

TEST(RealDicom, OddGeometryIsSaid) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  const auto warned = [&](const char* folder, Warning::Kind kind) {
    return warningOf(io::openVolume(dicom / folder).warnings, kind).text;
  };
  EXPECT_NE(warned("ct-tilt-irregular-ge", Warning::Kind::GantryTilt).find("18.5 degrees"), std::string::npos);
  EXPECT_NE(warned("ct-tilt-irregular-ge", Warning::Kind::UnevenSpacing).find("between 1.081 mm and 6.999 mm"), std::string::npos);
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
  for (const char* name : {"CT_small.dcm", "MR_small.dcm", "MR_small_bigendian.dcm", "MR_small_implicit.dcm", "MR_small_expb.dcm",
                           "MR_small_RLE.dcm", "MR_small_jp2klossless.dcm", "MR_small_jpeg_ls_lossless.dcm", "rtdose.dcm"})
    expectFrames(folder / name);
  // Projections have no place in the patient.
  for (const char* name : {"dx_image.dcm", "RG3_J2KI.dcm", "RG3_J2KR.dcm"})
    expectFrames(folder / "monochrome1" / name, 0, false, "", false, 0.0, false);
  EXPECT_NE(errorOf([&] { io::openVolume(folder / "rgb-series"); }).find("RGB"), std::string::npos);
}

TEST(RealDicom, ModalityLookupTable) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "dicom/pixel-formats/mlut_18.dcm");
  // GDCM reads the stored values and the table; looking up is three lines.
  gdcm::ImageReader reader;
  reader.SetFileName(path.c_str());
  ASSERT_TRUE(reader.Read());
  const gdcm::Item& item = reader.GetFile().GetDataSet().GetDataElement(gdcm::Tag(0x0028, 0x3000)).GetValueAsSQ()->GetItem(1);
  const auto words = [&](std::uint16_t element) {
    const gdcm::ByteValue* bytes = item.GetNestedDataSet().GetDataElement(gdcm::Tag(0x0028, element)).GetByteValue();
    std::vector<std::uint16_t> result(bytes->GetLength() / 2);
    std::memcpy(result.data(), bytes->GetPointer(), bytes->GetLength());
    return result;
  };
  const auto descriptor = words(0x3002), table = words(0x3006);
  ASSERT_EQ(descriptor.size(), 3u);
  std::vector<double> values = rescaled(reader.GetImage(), 1.0, 0.0);
  for (double& value : values) {
    const double place = value - static_cast<std::int16_t>(descriptor[1]);
    value = table[static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(table.size() - 1)))];
  }
  expectSlice(*io::openVolume(path).volume, 0, values.data());
}

TEST(RealDicom, Mosaics) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/pixel-formats/12bit");
  const std::pair<const char*, const char*> files[] = {
      {"12bitUnsigned.dcm", "2.nii"}, {"12bitUnsigned_0x0F0F.dcm", "3.nii"}, {"12bitSigned_0x0F0F.dcm", "4.nii"}};
  for (const auto& [name, reference] : files) {
    expectFrames(folder / name, 0, false, "", true, 0.0, false);
    SCOPED_TRACE(name);
    expectSameInWorld(*io::openVolume(folder / name).volume, *io::openVolume(folder / reference).volume, 0.0);
  }
}

TEST(RealDicom, EnhancedMultiFrame) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/enhanced");
  std::size_t variants = 0;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename().string().starts_with("CT0012")) {
      expectFrames(entry.path());
      ++variants;
    }
  EXPECT_EQ(variants, 10u);
  expectFrames(folder / "6_1.dcm");
  for (const char* name : {"emri_small.dcm", "emri_small_RLE.dcm", "emri_small_big_endian.dcm", "emri_small_jpeg_2k_lossless.dcm",
                           "emri_small_jpeg_ls_lossless.dcm"}) {
    expectFrames(folder / name, 0, false, "", false, 0.0, false);
    warningOf(io::openVolume(folder / name).warnings, Warning::Kind::NoGeometry);
  }
  expectFrames(folder / ".." / "seg" / "dcmqi-24x38x3" / "multiframe" / "mf.dcm");
}

TEST(RealDicom, FramesAtOnePositionAreTimePoints) {
  FENESTRA_TEST_DATA_OR_SKIP(file, "dicom/enhanced/MOVEKNEE.dcm");
  const std::vector<io::SeriesInfo> series = io::listSeries(file);
  ASSERT_EQ(series.size(), 19u);
  for (int frame = 0; frame < 19; ++frame) expectFrames(file, frame, false, series[static_cast<std::size_t>(frame)].id);
  warningOf(io::openVolume(file).warnings, Warning::Kind::TimePoints);
}

TEST(RealDicom, TwoVolumesInOneFile) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/enhanced");
  const fs::path file = folder / "IM_0027_fMAP.dcm";
  const std::vector<io::SeriesInfo> series = io::listSeries(file);
  ASSERT_EQ(series.size(), 2u);
  const std::pair<const char*, std::size_t> references[] = {{"Philips_WIP_B0_NS_801_e1.nii", 0}, {"Philips_WIP_B0_NS_801_e2_fieldmaphz.nii", 1}};
  for (const auto& [name, index] : references) {
    SCOPED_TRACE(name);
    const auto volume = io::openVolume(file, {.series = series[index].id}).volume;
    EXPECT_EQ(volume->grid.dims, glm::ivec3(64, 64, 32));
    // The reference keeps its scale in single precision.
    expectSameInWorld(*volume, *io::openVolume(folder / name).volume, 1e-6);
  }
}

TEST(RealDicom, ReferencesOfOtherConverters) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  const fs::path series = dicom / "transfer-syntax" / "mr-series";
  expectSameInWorld(*io::openVolume(series / "uncompressed").volume, *io::openVolume(series / "uncompressed_001_ground_truth.nii.gz").volume, 0.0);
  for (const char* name : {"compressed_j2k", "compressed_jpeg", "compressed_jpegls", "compressed_rle"})
    expectSameInWorld(*io::openVolume(series / name).volume, *io::openVolume(series / "compressed_001_ground_truth.nii.gz").volume, 0.0);
  const fs::path rescaled = dicom / "pixel-formats" / "per-slice-rescale-nonsquare";
  expectSameInWorld(*io::openVolume(rescaled).volume, *io::openVolume(rescaled / "002_non_isotropic_ground_truth.nii.gz").volume, 1e-6);
}

TEST(RealDicom, FarSliceIsAVolumeOfItsOwn) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "dicom/seg/highdicom");
  expectFrames(folder / "ct_image.dcm");
  const fs::path series = folder / "referenced-ct-77654033-CT2";
  const io::OpenedVolume opened = io::openVolume(series);
  ASSERT_EQ(opened.volume->grid.dims, glm::ivec3(16, 16, 3));
  const char* ordered[] = {"17136", "17166", "17196"};
  for (int z = 0; z < 3; ++z) {
    const Peer peer = readWithGdcm(series / ordered[z]);
    EXPECT_LE(glm::distance(slicePosition(opened.volume->grid, z), peer.origin), 1e-9);
    expectSlice(*opened.volume, z, peer.values.data());
  }
  ASSERT_EQ(opened.otherSeries.size(), 1u);
  const io::OpenedVolume far = io::openVolume(series, {.series = opened.otherSeries[0].id});
  expectSlice(*far.volume, 0, readWithGdcm(series / "17106").values.data());
}

TEST(RealDicom, ObjectsThatAreNoImagesAreRefused) {
  FENESTRA_TEST_DATA_OR_SKIP(dicom, "dicom");
  for (const char* name : {"seg/dcmqi/liver.dcm", "seg/dcmqi/partial_overlaps.dcm", "seg/dcmqi-24x38x3/seg/label.seg",
                           "seg/highdicom/seg_image_ct_binary.dcm", "seg/highdicom/seg_image_ct_binary_fractional.dcm",
                           "seg/highdicom/seg_image_ct_binary_overlap.dcm", "seg/highdicom/seg_image_ct_binary_single_frame.dcm",
                           "seg/highdicom/seg_image_ct_true_fractional.dcm"})
    EXPECT_NE(errorOf([&] { io::openVolume(dicom / name); }).find("DICOM segmentation"), std::string::npos) << name;
  for (const char* name : {"rtstruct/rt-utils/rt.dcm", "rtstruct/dicompyler/rtss.dcm"})
    EXPECT_NE(errorOf([&] { io::openVolume(dicom / name); }).find("holds no image"), std::string::npos) << name;
}

}  // namespace fenestra::tests
