// Every NIfTI-1, NRRD and MetaImage file of the collection against ITK: all voxels, and the geometry.

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <set>

#include <gtest/gtest.h>

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "io/base/VolumeEnding.h"
#include "tests/io/DifferentialPlaces.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::realImageTest {
namespace fs = std::filesystem;

namespace {

struct Peer {
  Grid grid;
  std::vector<double> values;  ///< of the first volume, x fastest
};

template <class T>
std::vector<double> asDoubles(const std::vector<char>& bytes, std::size_t count, std::size_t stride) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    T value;
    std::memcpy(&value, bytes.data() + i * stride * sizeof(T), sizeof(T));
    values[i] = static_cast<double>(value);
  }
  return values;
}

Peer readWithItk(const fs::path& path, itk::ImageIOBase& io) {
  itk::Object::SetGlobalWarningDisplay(false);
  io.SetFileName(path.string());
  io.ReadImageInformation();
  const unsigned rank = io.GetNumberOfDimensions();
  itk::ImageIORegion region(rank);
  Peer peer;
  peer.grid.dims = glm::ivec3(1);
  for (unsigned axis = 0; axis < rank; ++axis) {
    region.SetIndex(axis, 0);
    region.SetSize(axis, io.GetDimensions(axis));
    if (axis >= 3) continue;
    const auto at = static_cast<int>(axis);
    peer.grid.dims[at] = static_cast<int>(io.GetDimensions(axis));
    peer.grid.spacing[at] = io.GetSpacing(axis);
    peer.grid.origin[at] = io.GetOrigin(axis);
    const std::vector<double> direction = io.GetDirection(axis);
    for (int row = 0; row < 3; ++row) peer.grid.direction[at][row] = direction[static_cast<std::size_t>(row)];
  }
  io.SetIORegion(region);
  std::vector<char> bytes(io.GetImageSizeInBytes());
  io.Read(bytes.data());
  const std::size_t count = peer.grid.voxelCount(), stride = io.GetNumberOfComponents();
  using Type = itk::IOComponentEnum;
  switch (io.GetComponentType()) {
    case Type::UCHAR:
      peer.values = asDoubles<std::uint8_t>(bytes, count, stride);
      break;
    case Type::CHAR:
      peer.values = asDoubles<std::int8_t>(bytes, count, stride);
      break;
    case Type::USHORT:
      peer.values = asDoubles<std::uint16_t>(bytes, count, stride);
      break;
    case Type::SHORT:
      peer.values = asDoubles<std::int16_t>(bytes, count, stride);
      break;
    case Type::UINT:
      peer.values = asDoubles<std::uint32_t>(bytes, count, stride);
      break;
    case Type::INT:
      peer.values = asDoubles<std::int32_t>(bytes, count, stride);
      break;
    case Type::ULONG:
    case Type::ULONGLONG:
      peer.values = asDoubles<std::uint64_t>(bytes, count, stride);
      break;
    case Type::LONG:
    case Type::LONGLONG:
      peer.values = asDoubles<std::int64_t>(bytes, count, stride);
      break;
    case Type::FLOAT:
      peer.values = asDoubles<float>(bytes, count, stride);
      break;
    case Type::DOUBLE:
      peer.values = asDoubles<double>(bytes, count, stride);
      break;
    default:
      ADD_FAILURE() << "ITK reads another component type from " << path;
  }
  return peer;
}

Peer readWithItk(const fs::path& path) {
  const std::string name = path.filename().string();
  if (name.find(".nrrd") != std::string::npos || name.ends_with(".nhdr"))
    return readWithItk(path, *itk::NrrdImageIO::New());
  if (name.ends_with(".mha") || name.ends_with(".mhd")) return readWithItk(path, *itk::MetaImageIO::New());
  return readWithItk(path, *itk::NiftiImageIO::New());
}

/// Voxels that are not equal, nor within single precision where ITK scales in it.
std::size_t differingValues(const Volume& volume, const std::vector<double>& expected) {
  const std::vector<double> actual = realValues(volume);
  EXPECT_EQ(actual.size(), expected.size());
  if (actual.size() != expected.size()) return actual.size();
  const double relative = volume.slope == 1.0 && volume.intercept == 0.0 ? 0.0 : 1e-6;
  std::size_t different = 0;
  for (std::size_t i = 0; i < actual.size(); ++i)
    different += !(std::abs(actual[i] - expected[i]) <= relative * std::abs(expected[i]));
  return different;
}
void expectValues(const Volume& volume, const std::vector<double>& expected) {
  EXPECT_EQ(differingValues(volume, expected), 0u) << "voxels differ";
}

/// ITK makes NIfTI's axes orthonormal through single precision: a thousandth of a millimetre over a few hundred.
constexpr double geometryTolerance = 2e-3;

void expectAsItk(const fs::path& path) {
  SCOPED_TRACE(path.filename().string());
  const io::OpenedVolume opened = io::openVolume(path);
  const Peer peer = readWithItk(path);
  expectSameGrid(opened.volume->grid, peer.grid, geometryTolerance);
  expectValues(*opened.volume, peer.values);
}

}  // namespace

TEST(RealImage, Nifti) {
  FENESTRA_TEST_DATA_OR_SKIP(root, "formats/nifti");
  const fs::path data = root / ".." / "..";
  for (const char* name :
       {"ct-head/ct.nii.gz", "labelled/totalsegmentator-torso/example_ct.nii.gz",
        "labelled/totalsegmentator-torso/example_seg_fast_force_split.nii.gz",
        "labelled/totalsegmentator-dicom/example_seg_dicom.nii.gz", "labelled/brain-colin27/ch2.nii.gz",
        "labelled/brain-colin27/aal.nii.gz", "formats/nrrd/BallBinary30x30x30.nii.gz",
        "dicom/enhanced/Philips_WIP_B0_NS_801_e1.nii", "dicom/enhanced/Philips_WIP_B0_NS_801_e2_fieldmaphz.nii",
        "dicom/pixel-formats/12bit/2.nii", "dicom/pixel-formats/12bit/3.nii", "dicom/pixel-formats/12bit/4.nii",
        "dicom/transfer-syntax/mr-series/uncompressed_001_ground_truth.nii.gz",
        "dicom/transfer-syntax/mr-series/compressed_001_ground_truth.nii.gz",
        "dicom/pixel-formats/per-slice-rescale-nonsquare/002_non_isotropic_ground_truth.nii.gz",
        "dicom/ct-missing-slice-tilted/002_ground_truth.nii.gz"})
    expectAsItk(data / name);
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (!entry.is_regular_file() || entry.path().filename() == "example_nifti2.nii.gz") continue;
    expectAsItk(entry.path());
    ++files;
  }
  EXPECT_EQ(files, 27u);
}

/// Files of the collection that ITK reads otherwise, and why.
constexpr std::array itkDifferences = std::to_array<Difference>({
    {"example_nifti2", "ITK reads no NIfTI-2; the NIfTI library is compared in RealNifti2Test.cpp"},
    {"_bz2.nrrd", "ITK is built without bzip2; the plain file's voxels are compared below"},
    {"quarter.nhdr", "ITK takes no spacings beside a space; the scan's DICOM files are compared below"},
    {"hard/nrrd/micron", "ITK takes every unit for millimetres; the truth is compared in HardInputsTest.cpp"},
});

/// How the file differs from ITK's reading; empty where it does not.
std::string differenceFromItk(const fs::path& path) {
  const io::OpenedVolume opened = io::openVolume(path);
  Peer peer;
  try {
    peer = readWithItk(path);
  } catch (const itk::ExceptionObject& refused) {
    const std::string why = refused.GetDescription();
    return "ITK refuses it: " + why.substr(0, why.find('\n'));
  }
  const Grid &ours = opened.volume->grid, &theirs = peer.grid;
  if (ours.dims != theirs.dims) return "the sizes differ";
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 index(glm::dvec3(glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2) * (ours.dims - 1)), 1.0);
    const double off =
        glm::distance(glm::dvec3(ours.worldFromIndex() * index), glm::dvec3(theirs.worldFromIndex() * index));
    if (!(off <= geometryTolerance)) return "corners lie up to " + std::to_string(off) + " mm apart";
  }
  const std::size_t count = differingValues(*opened.volume, peer.values);
  return count == 0 ? std::string() : std::to_string(count) + " values differ";
}

TEST(RealImage, Thorough_EveryFileIsAsItkReadsItOrARowSaysWhyNot) {
  FENESTRA_TEST_DATA_OR_SKIP(root, "formats");
  DifferentialCounts counts;
  std::set<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(root / ".."))
    if (const std::string_view ending = io::volumeEnding(entry.path());
        entry.is_regular_file() && !ending.empty() && ending != ".img" && !ending.starts_with(".mg"))
      files.insert(entry.path().lexically_normal());
  for (const fs::path& file : files) {
    const std::string found = differenceFromItk(file);
    ++counts.compared;
    if (found.empty()) {
      ++counts.agreeing;
      continue;
    }
    const Difference* why = differenceAt(itkDifferences, file);
    if (!why) {
      ADD_FAILURE() << file << ": " << found;
      continue;
    }
    ++counts.explained;
    std::cout << file.filename() << ": " << found << "; " << why->why << "\n";
  }
  std::cout << "files: " << counts.text() << "\n";
  EXPECT_GT(counts.agreeing, 50);
}

TEST(RealImage, CtWithoutAModalityIsRecognised) {
  FENESTRA_TEST_DATA_OR_SKIP(root, "labelled");
  const fs::path data = root / "..";
  const auto recognised = [](const io::OpenedVolume& opened) {
    return std::any_of(opened.warnings.begin(), opened.warnings.end(), [](const io::Warning& warning) {
      return warning.text.find("Hounsfield units") != std::string::npos;
    });
  };
  for (const char* ct : {"labelled/totalsegmentator-torso/example_ct.nii.gz", "labelled/slicer-ctchest/CTChest4.nrrd",
                         "labelled/elastix-lung/3DCT_lung.mha"}) {
    const io::OpenedVolume opened = io::openVolume(data / ct);
    EXPECT_EQ(opened.volume->unit, "HU") << ct;
    EXPECT_EQ(opened.volume->modality, Modality::CT) << ct;
    EXPECT_EQ(opened.modality, Modality::CT) << ct;
    EXPECT_TRUE(recognised(opened)) << ct;
    const io::OpenedVolume denied = io::openVolume(data / ct, {.raw = {}, .modality = Modality::MR});
    EXPECT_EQ(denied.volume->unit, "") << ct;
    EXPECT_EQ(denied.volume->modality, Modality::MR) << ct;
    EXPECT_FALSE(recognised(denied)) << ct;
  }
  // 0 to 1, an MR, and a CT offset by 1024.
  for (const char* other : {"ct-head/ct.nii.gz", "labelled/brain-colin27/ch2.nii.gz", "visible-human/vm_head_ct.mha",
                            "visible-human/vm_head_mri.mha"}) {
    const io::OpenedVolume opened = io::openVolume(data / other);
    EXPECT_EQ(opened.volume->unit, "") << other;
    EXPECT_FALSE(opened.modality) << other;
    EXPECT_FALSE(recognised(opened)) << other;
  }
}

TEST(RealImage, NiftiOrientationsAreOneVolumeInTheWorld) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "formats/nifti/orientation");
  const auto reference = io::openVolume(folder / "LPS.nii.gz").volume;
  for (const auto& entry : fs::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename().string());
    const auto volume = io::openVolume(entry.path()).volume;
    const glm::dmat4 there = volume->grid.indexFromWorld() * reference->grid.worldFromIndex();
    std::size_t different = 0;
    for (int z = 0; z < reference->grid.dims.z; ++z)
      for (int y = 0; y < reference->grid.dims.y; ++y)
        for (int x = 0; x < reference->grid.dims.x; ++x) {
          const glm::ivec3 index(glm::round(glm::dvec3(there * glm::dvec4(x, y, z, 1))));
          different += !volume->grid.contains(index) || volume->value(index) != reference->value({x, y, z});
        }
    EXPECT_EQ(different, 0u);
  }
}

TEST(RealImage, MetaImage) {
  FENESTRA_TEST_DATA_OR_SKIP(root, "formats/metaimage");
  const fs::path data = root / ".." / "..";
  for (const char* name : {"visible-human/vm_head_ct.mha", "visible-human/vm_head_mri.mha",
                           "labelled/elastix-lung/3DCT_lung.mha", "labelled/elastix-lung/3DCT_lung_baseline_mask.mha",
                           "formats/metaimage/HeadMRVolume.mhd", "formats/metaimage/3DCT_lung_baseline_small.mha"})
    expectAsItk(data / name);
}

TEST(RealImage, Nrrd) {
  FENESTRA_TEST_DATA_OR_SKIP(root, "formats/nrrd");
  const fs::path data = root / ".." / "..";
  for (const char* name :
       {"labelled/slicer-ctchest/CTChest4.nrrd", "labelled/slicer-ctchest/Segmentation.seg.nrrd",
        "labelled/slicer-ctchest/SegmentationOverlapping.seg.nrrd", "formats/nrrd/statue-leg.nrrd",
        "formats/nrrd/BallBinary30x30x30.nrrd", "formats/nrrd/BallBinary30x30x30.nhdr",
        "formats/nrrd/BallBinary30x30x30_gz.nrrd", "formats/nrrd/BallBinary30x30x30_gz_lineskip.nrrd",
        "formats/nrrd/BallBinary30x30x30_byteskip_minus_one.nhdr",
        "formats/nrrd/BallBinary30x30x30_gz_byteskip_minus_one.nrrd", "dicom/seg/dcmqi/liver_seg.nrrd",
        "dicom/seg/dcmqi/heart_seg.nrrd", "dicom/seg/dcmqi/spine_seg.nrrd", "dicom/seg/dcmqi-24x38x3/nrrd/label.nrrd"})
    expectAsItk(data / name);
}

TEST(RealImage, NrrdVariantsThatItkDoesNotRead) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "formats/nrrd");
  // ITK is built without bzip2 and takes no byte skip of -1 with gzip; both files hold the plain file's voxels.
  const Peer plain = readWithItk(folder / "BallBinary30x30x30.nrrd");
  for (const char* name : {"BallBinary30x30x30_bz2.nrrd", "BallBinary30x30x30_byteskip_minus_one_nifti.nhdr"}) {
    SCOPED_TRACE(name);
    const io::OpenedVolume opened = io::openVolume(folder / name);
    expectSameGrid(opened.volume->grid, plain.grid, 0.0);
    expectValues(*opened.volume, plain.values);
  }
}

TEST(RealImage, LeftHandedNrrdIsNotMirrored) {
  FENESTRA_TEST_DATA_OR_SKIP(path, "formats/nrrd-raw-slices-headsq/quarter.nhdr");
  const io::OpenedVolume opened = io::openVolume(path);
  warningOf(opened.warnings, io::Warning::Kind::NoGeometry);
  // ITK refuses spacings together with a space. The DICOM files of this scan, which GDCM reads as we do, tell both the
  // voxels and which way is right: slice order reversed, z upwards.
  FENESTRA_TEST_DATA_OR_SKIP(twin, "dicom/ct-tiny-uniform");
  const auto dicom = io::openVolume(twin).volume;
  const Grid& grid = opened.volume->grid;
  ASSERT_EQ(grid.dims, dicom->grid.dims);
  EXPECT_GT(glm::dot(glm::cross(dicom->grid.direction[0], dicom->grid.direction[1]), dicom->grid.direction[2]), 0.0);
  EXPECT_EQ(grid.direction[2], -dicom->grid.direction[2]);
  std::size_t different = 0;
  for (int z = 0; z < grid.dims.z; ++z)
    for (int y = 0; y < grid.dims.y; ++y)
      for (int x = 0; x < grid.dims.x; ++x)
        different += opened.volume->value({x, y, z}) != dicom->value({x, y, grid.dims.z - 1 - z});
  EXPECT_EQ(different, 0u);
}

TEST(RealImage, LabelMapsFitTheirImages) {
  FENESTRA_TEST_DATA_OR_SKIP(root, "labelled");
  struct Pair {
    const char *image, *labels;
    std::size_t present;
    std::uint16_t value;
    const char* name;
  };
  const Pair pairs[] = {
      {"totalsegmentator-torso/example_ct.nii.gz", "totalsegmentator-torso/example_seg_fast_force_split.nii.gz", 61, 52,
       "aorta"},
      {"totalsegmentator-dicom/example_ct_dicom", "totalsegmentator-dicom/example_seg_dicom.nii.gz", 31, 5, "liver"},
      {"brain-colin27/ch2.nii.gz", "brain-colin27/aal.nii.gz", 116, 37, "Hippocampus_L"},
      {"slicer-ctchest/CTChest4.nrrd", "slicer-ctchest/Segmentation.seg.nrrd", 7, 1, "ribs"},
      {"elastix-lung/3DCT_lung.mha", "elastix-lung/3DCT_lung_baseline_mask.mha", 1, 1, "label 1"}};
  for (const Pair& pair : pairs) {
    SCOPED_TRACE(pair.labels);
    const auto volume = io::openVolume(root / pair.image).volume;
    const io::OpenedLabels opened = io::openLabels(root / pair.labels, volume->grid);
    EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
    EXPECT_EQ(opened.labels->grid, volume->grid);
    std::vector<bool> seen(65536, false);
    opened.labels->voxels.visit([&](auto scalars) {
      for (const auto value : scalars) seen[static_cast<std::size_t>(value)] = true;
    });
    EXPECT_EQ(static_cast<std::size_t>(std::count(seen.begin() + 1, seen.end(), true)), pair.present);
    ASSERT_NE(opened.labels->find(pair.value), nullptr);
    EXPECT_EQ(opened.labels->find(pair.value)->name, pair.name);
  }
}

TEST(RealImage, FlippedLabelMapMatchesVoxelForVoxel) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "labelled/totalsegmentator-dicom");
  const auto volume = io::openVolume(folder / "example_ct_dicom").volume;
  const auto labels = io::openLabels(folder / "example_seg_dicom.nii.gz", volume->grid).labels;
  const Peer stored = readWithItk(folder / "example_seg_dicom.nii.gz");
  const glm::ivec3 dims = volume->grid.dims;
  ASSERT_EQ(stored.grid.dims, dims);
  // The file's axes are left, anterior, superior; the series' are left, posterior, superior.
  std::size_t different = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        different += labels->value({x, y, z}) != stored.values[volume->grid.offset({x, dims.y - 1 - y, z})];
  EXPECT_EQ(different, 0u);
}

TEST(RealImage, OverlappingSegmentsAreMergedAndSaid) {
  FENESTRA_TEST_DATA_OR_SKIP(folder, "labelled/slicer-ctchest");
  const auto volume = io::openVolume(folder / "CTChest4.nrrd").volume;
  const io::OpenedLabels opened = io::openLabels(folder / "SegmentationOverlapping.seg.nrrd", volume->grid);
  EXPECT_FALSE(opened.labels->labels.empty());
  EXPECT_NE(warningOf(opened.warnings, io::Warning::Kind::Other).text.find("overlap"), std::string::npos);
  for (const Label& label : opened.labels->labels) EXPECT_FALSE(label.name.empty());
}

}  // namespace fenestra::tests::realImageTest
