// Files as other systems write them, beyond the letter of the standard: each must read as the same image.

#include <unistd.h>
#include <cstdlib>
#include <functional>
#include <numeric>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "tests/io/DicomBytes.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::dicomVariantsTest {
namespace fs = std::filesystem;
using io::Warning;

namespace {

std::vector<double> valuesOf(const DicomSpec& spec) { return {spec.words.begin(), spec.words.end()}; }

void edit(const fs::path& path, const std::function<void(DicomBytes&)>& how) {
  DicomBytes bytes(readFile(path));
  how(bytes);
  writeFile(path, bytes.bytes());
}

}  // namespace

TEST(DicomVariants, ElementsOfUnknownVrAreReadByTheDictionary) {
  const fs::path path = scratchFolder() / "image";
  DicomSpec spec = pictureSpec();
  spec.modality = "MR";
  spec.position = glm::dvec3(-10, 20, 30);
  spec.pixelSpacing = "0.859\\0.5";
  spec.slope = "2";
  spec.intercept = "-100";
  writeDicom(path, spec);
  const io::OpenedVolume known = io::openVolume(path);
  edit(path, [](DicomBytes& bytes) {
    for (const std::uint32_t tag :
         {0x00080060u, 0x00200032u, 0x00200037u, 0x00280002u, 0x00280004u, 0x00280010u, 0x00280011u, 0x00280030u,
          0x00280100u, 0x00280101u, 0x00280102u, 0x00280103u, 0x00281052u, 0x00281053u, 0x7fe00010u})
      bytes.makeUnknown(tag);
  });
  const io::OpenedVolume opened = io::openVolume(path);
  EXPECT_EQ(opened.series.modality, "MR");
  EXPECT_EQ(opened.volume->grid, known.volume->grid);
  EXPECT_EQ(opened.volume->grid.spacing, glm::dvec3(0.5, 0.859, 1.0));
  EXPECT_EQ(opened.volume->grid.origin, glm::dvec3(-10, 20, 30));
  EXPECT_EQ(realValues(*opened.volume), realValues(*known.volume));
  EXPECT_EQ(opened.volume->value({1, 0, 0}), 2.0 * 1 - 100.0);
}

TEST(DicomVariants, DosesOfUnknownVrAreScaled) {
  const fs::path path = scratchFolder() / "dose";
  DicomSpec spec = pictureSpec();
  spec.sopClass = "1.2.840.10008.5.1.4.1.1.481.2";
  spec.modality = "RTDOSE";
  spec.doseScaling = "0.001";
  spec.frameOffsets = "0";
  writeDicom(path, spec);
  edit(path, [](DicomBytes& bytes) { bytes.makeUnknown(0x3004000e); });
  EXPECT_EQ(io::openVolume(path).volume->value({3, 0, 0}), 9 * 0.001);
}

TEST(DicomVariants, AFrameOfReferenceForEachSliceMakesOneVolume) {
  const fs::path folder = scratchFolder();
  for (int slice = 0; slice < 275; ++slice) {
    DicomSpec spec;
    spec.instance = "1.2.3." + std::to_string(slice + 1);
    spec.frameOfReference = "1.2.9." + std::to_string(slice + 1);
    spec.position = glm::dvec3(0, 0, slice * 2.5);
    spec.words.assign(12, static_cast<std::uint32_t>(slice));
    writeDicom(folder / spec.instance, spec);
  }
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.volume->grid.dims, glm::ivec3(4, 3, 275));
  EXPECT_EQ(opened.volume->grid.spacing.z, 2.5);
  EXPECT_EQ(opened.volume->value({0, 0, 274}), 274.0);
  EXPECT_TRUE(opened.otherSeries.empty());
  ASSERT_EQ(opened.warnings.size(), 1u) << kindsOf(opened.warnings);
  EXPECT_NE(opened.warnings[0].text.find("275 frames of reference"), std::string::npos) << opened.warnings[0].text;
}

TEST(DicomVariants, FramesOfReferenceOfManySlicesStayApart) {
  const fs::path folder = scratchFolder();
  for (int slice = 0; slice < 7; ++slice) {
    DicomSpec spec;
    spec.instance = "1.2.3." + std::to_string(slice + 1);
    spec.frameOfReference = slice < 5 ? "1.2.9" : "1.2.8";
    spec.position = glm::dvec3(0, 0, slice % 5);
    writeDicom(folder / spec.instance, spec);
  }
  const io::OpenedVolume opened = io::openVolume(folder);
  EXPECT_EQ(opened.volume->grid.dims.z, 5);
  ASSERT_EQ(opened.otherSeries.size(), 1u);
  EXPECT_EQ(opened.otherSeries[0].dims.z, 2);
}

TEST(DicomVariants, CompressedPixelsNeedNoEndOfSequence) {
  for (const Syntax syntax : {Syntax::Rle, Syntax::JpegLossless, Syntax::JpegLs}) {
    const fs::path path = scratchFolder() / "image";
    const DicomSpec spec = pictureSpec(syntax);
    writeDicom(path, spec);
    const std::string bytes = readFile(path);
    writeFile(path, bytes.substr(0, bytes.size() - 8));
    EXPECT_EQ(realValues(*io::openVolume(path).volume), valuesOf(spec));
  }
}

TEST(DicomVariants, PreambleAndMetaHeaderMayBeMissing) {
  for (const Syntax syntax : {Syntax::ExplicitLittle, Syntax::ImplicitLittle}) {
    const fs::path path = scratchFolder() / "image";
    const DicomSpec spec = pictureSpec(syntax);
    writeDicom(path, spec);
    const std::string bytes = readFile(path);
    const auto metaLength = static_cast<std::size_t>(static_cast<unsigned char>(bytes[140]));
    for (const std::size_t dropped : {std::size_t{132}, 144 + metaLength}) {
      writeFile(path, bytes.substr(dropped));
      EXPECT_EQ(realValues(*io::openVolume(path).volume), valuesOf(spec)) << dropped;
    }
  }
}

TEST(DicomVariants, NarrowCodestreamsFillWiderPixels) {
  struct Case {
    Syntax syntax;
    int stored;
  };
  for (const auto& [syntax, stored] : {Case{Syntax::JpegLs, 7}, Case{Syntax::JpegLs, 8}, Case{Syntax::JpegLossless, 8}})
    for (const int allocated : {8, 16, 32}) {
      SCOPED_TRACE(std::to_string(stored) + " in " + std::to_string(allocated));
      const fs::path path = scratchFolder() / "image";
      DicomSpec spec = pictureSpec(syntax);
      spec.bitsAllocated = 8;
      spec.bitsStored = stored;
      spec.highBit = stored - 1;
      // Smooth: DCMTK's JPEG-LS encoder overruns its buffer where packing does not make the picture smaller.
      for (std::size_t i = 0; i < spec.words.size(); ++i) spec.words[i] = static_cast<std::uint32_t>(i / 10);
      writeDicom(path, spec);
      edit(path, [&](DicomBytes& bytes) { bytes.set(0x00280100, "US", shortValue(allocated)); });
      EXPECT_EQ(realValues(*io::openVolume(path).volume), valuesOf(spec));
    }
}

TEST(DicomVariants, FloatAndDoublePixelsKeepTheirValues) {
  const fs::path path = scratchFolder() / "map";
  const auto check = [&](std::uint32_t tag, const char* vr, auto first, ScalarType type) {
    using T = decltype(first);
    std::vector<T> values(1200);
    std::iota(values.begin(), values.end(), first);
    DicomSpec spec = pictureSpec();
    spec.slope = "0.5";
    spec.intercept = "10";
    writeDicom(path, spec);
    edit(path, [&](DicomBytes& bytes) {
      for (const std::uint32_t integer : {0x7fe00010u, 0x00280101u, 0x00280102u, 0x00280103u}) bytes.drop(integer);
      bytes.set(0x00280100, "US", shortValue(static_cast<int>(8 * sizeof(T))));
      bytes.set(tag, vr, bytesOf(values));
    });
    const io::OpenedVolume opened = io::openVolume(path);
    EXPECT_EQ(opened.volume->voxels.type(), type);
    std::vector<double> expected;
    for (const T value : values) expected.push_back(0.5 * static_cast<double>(value) + 10.0);
    EXPECT_EQ(realValues(*opened.volume), expected);
    EXPECT_TRUE(opened.warnings.empty()) << kindsOf(opened.warnings);
  };
  check(0x7fe00008, "OF", -600.25f, ScalarType::Float32);
  check(0x7fe00009, "OD", 1e-3, ScalarType::Float64);
}

TEST(DicomVariants, FloatFramesOfOneFileAreOrderedByPosition) {
  const fs::path path = scratchFolder() / "map";
  DicomSpec spec;
  spec.frames = {{{0, 0, 2}}, {{0, 0, 0}}};
  spec.explicitLengths = true;
  writeDicom(path, spec);
  std::vector<float> values(24);
  std::iota(values.begin(), values.end(), 0.5f);
  edit(path, [&](DicomBytes& bytes) {
    bytes.drop(0x7fe00010);
    bytes.set(0x00280100, "US", shortValue(32));
    bytes.set(0x7fe00008, "OF", bytesOf(values));
  });
  const io::OpenedVolume opened = io::openVolume(path);
  EXPECT_EQ(opened.volume->value({0, 0, 0}), 12.5);
  EXPECT_EQ(opened.volume->value({0, 0, 1}), 0.5);
}

TEST(DicomVariants, FoldersThatCannotBeListedAreSaid) {
  // The folder is not below the build folder: a checkout in root's home cannot be reached by the user that root becomes
  // below.
  std::string name = (fs::temp_directory_path() / "fenestra-closed-XXXXXX").string();
  ASSERT_NE(::mkdtemp(name.data()), nullptr);
  const fs::path folder = name;
  fs::permissions(folder, fs::perms(0755));
  writeDicom(folder / "image", pictureSpec());
  fs::create_directories(folder / "closed");
  fs::permissions(folder / "closed", fs::perms::none);
  // Permissions do not bind root.
  constexpr uid_t nobody = 65534;
  const bool isRoot = ::geteuid() == 0;
  if (isRoot) {
    ASSERT_EQ(::seteuid(nobody), 0);
  }
  std::vector<Warning> warnings;
  EXPECT_NO_THROW(warnings = io::openVolume(folder).warnings);
  const std::string error = errorOf([&] { io::openVolume(folder / "closed"); });
  if (isRoot) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  fs::permissions(folder / "closed", fs::perms::owner_all);
  fs::remove_all(folder);
  EXPECT_NE(warningOf(warnings, Warning::Kind::UnreadableFiles).text.find("1 folder left out: not readable"),
            std::string::npos);
  EXPECT_NE(error.find("cannot be listed: Permission denied"), std::string::npos) << error;
}

}  // namespace fenestra::tests::dicomVariantsTest
