// Damaged, mislabelled and hostile files: each gives an io::Error, or a volume where one is still readable. Nothing
// crashes, hangs, allocates what a false header asks for, or writes to the error stream.

#include <chrono>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "io/VolumeWriter.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::hostileInputTest {
namespace fs = std::filesystem;

namespace {

/// Opens as a volume and as labels. Any other exception than io::Error ends the test.
void openSomehow(const fs::path& path) {
  Grid target;
  target.dims = {4, 4, 4};
  try {
    io::openVolume(path);
  } catch (const io::Error& error) {
    EXPECT_FALSE(error.cause().empty());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
  try {
    io::openLabels(path, target);
  } catch (const io::Error&) {
  }
}

struct Sample {
  std::string name, bytes;
};

std::vector<Sample> samples() {
  const fs::path folder = scratchFolder();
  Volume volume;
  volume.grid.dims = {9, 8, 7};
  volume.voxels = Voxels(ScalarType::Int16, 504);
  for (std::size_t i = 0; i < 504; ++i)
    volume.voxels.as<std::int16_t>()[i] = static_cast<std::int16_t>(i * 37 % 4000 - 1000);
  for (const char* name : {"a.nii", "a.nii.gz", "a.nrrd", "a.mha"}) io::writeVolume(volume, folder / name);
  const std::string raw = bytesOf(std::vector<std::int16_t>(504, 77));
  const std::string nrrd =
      "NRRD0004\ntype: short\ndimension: 3\nspace: RAS\nsizes: 9 8 7\nspace directions: (1,0,0) (0,1,0) "
      "(0,0,1)\nendian: little\n";
  writeFile(folder / "gz.nrrd", nrrd + "encoding: gzip\n\n" + gzipped(raw));
  writeFile(folder / "bz2.nrrd", nrrd + "encoding: bzip2\n\n" + bzipped(raw));
  writeFile(folder / "z.mha",
            "NDims = 3\nDimSize = 9 8 7\nElementType = MET_SHORT\nCompressedData = True\nElementDataFile = LOCAL\n" +
                zlibbed(raw));
  DicomSpec spec;
  spec.columns = 19;
  spec.rows = 17;
  const std::pair<const char*, Syntax> syntaxes[] = {{"explicit", Syntax::ExplicitLittle},
                                                     {"implicit", Syntax::ImplicitLittle},
                                                     {"big", Syntax::ExplicitBig},
                                                     {"deflated", Syntax::Deflated},
                                                     {"rle", Syntax::Rle},
                                                     {"jpeg", Syntax::JpegLossless},
                                                     {"jpegls", Syntax::JpegLs}};
  for (const auto& [name, syntax] : syntaxes) {
    spec.syntax = syntax;
    writeDicom(folder / name, spec);
  }
  spec.syntax = Syntax::Rle;
  spec.frames = {FrameSpec{{0, 0, 0}}, FrameSpec{{0, 0, 1}}, FrameSpec{{0, 0, 2}}};
  writeDicom(folder / "enhanced", spec);
  if (const fs::path j2k = findTestData("dicom/pixel-formats/MR_small_jp2klossless.dcm"); !j2k.empty())
    fs::copy_file(j2k, folder / "j2k");
  std::vector<Sample> result;
  for (const auto& entry : fs::directory_iterator(folder))
    result.push_back({entry.path().filename().string(), readFile(entry.path())});
  std::sort(result.begin(), result.end(), [](const Sample& a, const Sample& b) { return a.name < b.name; });
  return result;
}

}  // namespace

TEST(HostileInput, TruncatedFilesAreErrors) {
  const std::vector<Sample> all = samples();
  const fs::path folder = scratchFolder();
  testing::internal::CaptureStderr();
  for (const Sample& sample : all) {
    SCOPED_TRACE(sample.name);
    // A compressed picture needs nothing behind its last fragment.
    const std::set<std::string> compressed{"rle", "jpeg", "jpegls", "j2k", "enhanced"};
    writeFile(folder / sample.name, sample.bytes);
    const std::vector<double> whole = realValues(*io::openVolume(folder / sample.name).volume);
    const std::size_t step = std::max<std::size_t>(1, sample.bytes.size() / 60);
    for (std::size_t size = 0; size < sample.bytes.size(); size += size < 16 ? 1 : step) {
      writeFile(folder / sample.name, sample.bytes.substr(0, size));
      openSomehow(folder / sample.name);
      SCOPED_TRACE("cut to " + std::to_string(size) + " of " + std::to_string(sample.bytes.size()));
      try {
        const io::OpenedVolume opened = io::openVolume(folder / sample.name);
        EXPECT_TRUE(compressed.contains(sample.name));
        EXPECT_EQ(realValues(*opened.volume), whole);
      } catch (const io::Error&) {
      }
    }
    fs::remove(folder / sample.name);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(HostileInput, FlippedBytesNeverCrash) {
  const std::vector<Sample> all = samples();
  const fs::path folder = scratchFolder();
  std::mt19937 random(20260131);
  testing::internal::CaptureStderr();
  for (const Sample& sample : all) {
    SCOPED_TRACE(sample.name);
    for (int round = 0; round < 150; ++round) {
      std::string bytes = sample.bytes;
      // Most damage is done to the first kilobyte, where headers are.
      const std::size_t reach = round % 3 ? std::min<std::size_t>(bytes.size(), 1024) : bytes.size();
      for (int flips = 1 + round % 4; flips > 0; --flips) bytes[random() % reach] = static_cast<char>(random());
      writeFile(folder / sample.name, bytes);
      openSomehow(folder / sample.name);
    }
    fs::remove(folder / sample.name);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(HostileInput, RandomAndMislabelledFilesAreErrors) {
  const fs::path folder = scratchFolder();
  std::mt19937 random(7);
  std::string noise(5000, '\0');
  for (char& c : noise) c = static_cast<char>(random());
  testing::internal::CaptureStderr();
  for (const char* name : {"a.nii", "a.nii.gz", "a.nrrd", "a.nhdr", "a.mha", "a.mhd", "a.dcm", "a.img", "a.hdr", "a"}) {
    writeFile(folder / name, noise);
    EXPECT_FALSE(errorOf([&] { io::openVolume(folder / name); }).empty()) << name;
    writeFile(folder / name, "This is a letter, not a volume.\n");
    EXPECT_FALSE(errorOf([&] { io::openVolume(folder / name); }).empty()) << name;
    writeFile(folder / name, gzipped(noise));
    EXPECT_FALSE(errorOf([&] { io::openVolume(folder / name); }).empty()) << name;
    writeFile(folder / name, "");
    EXPECT_NE(errorOf([&] { io::openVolume(folder / name); }).find("is empty"), std::string::npos) << name;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_NE(errorOf([&] { io::openVolume(folder / "absent"); }).find("does not exist"), std::string::npos);
  EXPECT_NE(errorOf([&] { io::openVolume("/dev/null"); }).find("neither a file nor a folder"), std::string::npos);
}

TEST(HostileInput, SizesThatLieAreRefusedAtOnce) {
  const fs::path folder = scratchFolder();
  const auto start = std::chrono::steady_clock::now();
  const auto expectRefused = [&](const char* name, const std::string& bytes) {
    writeFile(folder / name, bytes);
    EXPECT_FALSE(errorOf([&] { io::openVolume(folder / name); }).empty()) << bytes.substr(0, 200);
  };
  for (const char* sizes :
       {"1000000000 1000000000 1000000000", "2147483647 2147483647 2147483647", "-1 4 4", "0 4 4",
        "4294967296 4294967296 1", "99999999999999999999 1 1", "100000 100000 100000", "4 4", "4 4 4 4", "4 4 x", ""}) {
    for (const char* encoding : {"raw", "gzip", "bzip2", "ascii"})
      expectRefused("a.nrrd", std::string("NRRD0004\ntype: short\ndimension: 3\nsizes: ") + sizes +
                                  "\nendian: little\nencoding: " + encoding + "\n\nabc");
    for (const char* packed : {"True", "False"})
      expectRefused("a.mha", std::string("NDims = 3\nDimSize = ") + sizes +
                                 "\nElementType = MET_SHORT\nCompressedData = " + packed +
                                 "\nElementDataFile = LOCAL\nabc");
  }
  expectRefused("a.nrrd",
                "NRRD0004\ntype: short\ndimension: 4\nsizes: 1000000000 2 2 2\nkinds: list domain domain "
                "domain\nendian: little\nencoding: raw\n\nabc");
  expectRefused("a.nrrd",
                "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nendian: little\nencoding: raw\nline skip: "
                "99999999999\n\nabc");
  expectRefused("a.nrrd",
                "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nendian: little\nencoding: raw\nbyte skip: "
                "9223372036854775807\n\nabc");
  expectRefused("a.nhdr",
                "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nendian: little\nencoding: raw\ndata file: s%d 1 "
                "999999999 1\n");
  expectRefused(
      "a.nhdr",
      "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 2\nendian: little\nencoding: raw\ndata file: a.nhdr.none\n");
  expectRefused("a.mha", "NDims = 100\nDimSize = 4 4 4\nElementType = MET_SHORT\nElementDataFile = LOCAL\nabc");

  DicomSpec spec;
  // DCMTK's JPEG-LS encoder overruns its buffer with images of a few pixels.
  spec.columns = 40;
  spec.rows = 30;
  for (const Syntax syntax : {Syntax::ExplicitLittle, Syntax::Rle, Syntax::JpegLossless, Syntax::JpegLs}) {
    spec.syntax = syntax;
    writeDicom(folder / "a.dcm", spec);
    std::string bytes = readFile(folder / "a.dcm");
    const auto enlarge = [&](const char* tag) {
      const std::size_t at = bytes.find(std::string(tag, 4) + "US");
      ASSERT_NE(at, std::string::npos);
      bytes.replace(at + 8, 2, "\xff\xff");
    };
    enlarge("\x28\x00\x10\x00");
    enlarge("\x28\x00\x11\x00");
    expectRefused("a.dcm", bytes);
  }
  // Each is refused by its header; together they take well under a second, even with sanitizers.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(HostileInput, EndlesslyNestedHeadersAreRefused) {
  const fs::path folder = scratchFolder();
  const std::string sequence("\x08\x00\x40\x11SQ\x00\x00\xff\xff\xff\xff\xfe\xff\x00\xe0\xff\xff\xff\xff", 20);
  std::string nested;
  for (int level = 0; level < 100000; ++level) nested += sequence;
  for (const Syntax syntax : {Syntax::ExplicitLittle, Syntax::Deflated}) {
    DicomSpec spec;
    spec.syntax = syntax;
    writeDicom(folder / "a.dcm", spec);
    std::string bytes = readFile(folder / "a.dcm");
    const auto metaLength = static_cast<std::size_t>(static_cast<unsigned char>(bytes[140]));
    std::string packed;
    if (syntax == Syntax::Deflated) {
      // A zlib stream without its two bytes of header and four of checksum.
      packed = zlibbed(nested);
      packed = packed.substr(2, packed.size() - 6);
    }
    writeFile(folder / "a.dcm", bytes.substr(0, 144 + metaLength) + (packed.empty() ? nested : packed));
    EXPECT_NE(errorOf([&] { io::openVolume(folder / "a.dcm"); }).find("nests deeper"), std::string::npos);
  }
}

}  // namespace fenestra::tests::hostileInputTest
