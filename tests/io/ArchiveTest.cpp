#include <cstdlib>
#include <map>

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include "io/LabelReader.h"
#include "io/VolumeReader.h"
#include "tests/io/DicomWriter.h"
#include "tests/io/IoTesting.h"
#include "tests/io/LabelFiles.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::archiveTest {
namespace fs = std::filesystem;

namespace {

enum class Packed { Zip, EncryptedZip, Tar, TarGzip, TarXz };
using Entries = std::vector<std::pair<std::string, std::string>>;  // name and bytes

void writeArchive(const fs::path& path, Packed how, const Entries& entries) {
  archive* writer = archive_write_new();
  if (how == Packed::Zip || how == Packed::EncryptedZip) archive_write_set_format_zip(writer);
  if (how == Packed::EncryptedZip) {
    archive_write_set_options(writer, "zip:encryption=zipcrypt");
    archive_write_set_passphrase(writer, "secret");
  }
  if (how == Packed::Tar || how == Packed::TarGzip || how == Packed::TarXz)
    archive_write_set_format_pax_restricted(writer);
  if (how == Packed::TarGzip) archive_write_add_filter_gzip(writer);
  if (how == Packed::TarXz) archive_write_add_filter_xz(writer);
  ASSERT_EQ(archive_write_open_filename(writer, path.c_str()), ARCHIVE_OK);
  for (const auto& [name, bytes] : entries) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(bytes.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    ASSERT_EQ(archive_write_header(writer, entry), ARCHIVE_OK) << archive_error_string(writer);
    archive_write_data(writer, bytes.data(), bytes.size());
    archive_entry_free(entry);
  }
  ASSERT_EQ(archive_write_close(writer), ARCHIVE_OK);
  archive_write_free(writer);
}

/// Five slices 2 mm apart.
fs::path writeSeries(const fs::path& folder) {
  fs::create_directories(folder);
  for (int slice = 0; slice < 5; ++slice) {
    DicomSpec spec;
    spec.instance = "1.2.3." + std::to_string(slice);
    spec.position = glm::dvec3(0, 0, 2 * slice);
    for (int i = 0; i < 12; ++i) spec.words.push_back(static_cast<std::uint32_t>(20 * slice + i));
    writeDicom(folder / ("slice" + std::to_string(slice) + ".dcm"), spec);
  }
  return folder;
}

Entries entriesOf(const fs::path& folder, const std::string& below) {
  Entries entries;
  for (const auto& entry : fs::directory_iterator(folder))
    entries.emplace_back(below + entry.path().filename().string(), readFile(entry.path()));
  return entries;
}

/// Points temporary files at a folder of the test's own, so that it sees whether any is left.
class Archive : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = scratchFolder();
    fs::create_directories(folder_ / "temporary");
    ::setenv("TMPDIR", (folder_ / "temporary").c_str(), 1);
  }
  void TearDown() override {
    EXPECT_TRUE(fs::is_empty(folder_ / "temporary")) << "unpacked files are left";
    ::unsetenv("TMPDIR");
  }
  fs::path folder_;
};

}  // namespace

TEST_F(Archive, ADicomSeriesOpensAsItsFolderDoes) {
  const fs::path series = writeSeries(folder_ / "series");
  const io::OpenedVolume expected = io::openVolume(series);
  const std::map<std::string, Packed> kinds{
      {"a.zip", Packed::Zip}, {"a.tar", Packed::Tar}, {"a.tar.gz", Packed::TarGzip}, {"a.tar.xz", Packed::TarXz}};
  for (const auto& [name, how] : kinds) {
    writeArchive(folder_ / name, how, entriesOf(series, "study/"));
    const io::OpenedVolume opened = io::openVolume(folder_ / name);
    EXPECT_EQ(realValues(*opened.volume), realValues(*expected.volume)) << name;
    expectSameGrid(opened.volume->grid, expected.volume->grid, 0.0);
    EXPECT_EQ(opened.series.id, expected.series.id);
    // Sessions find the data again by the archive.
    EXPECT_EQ(opened.series.files, std::vector<fs::path>{folder_ / name});
    EXPECT_EQ(io::listSeries(folder_ / name).size(), 1u);
  }
}

TEST_F(Archive, APackedDicomFileOpens) {
  const fs::path series = writeSeries(folder_ / "series");
  writeFile(folder_ / "one.dcm.gz", gzipped(readFile(series / "slice3.dcm")));
  writeFile(folder_ / "one.dcm.bz2", bzipped(readFile(series / "slice3.dcm")));
  const auto expected = realValues(*io::openVolume(series / "slice3.dcm").volume);
  EXPECT_EQ(realValues(*io::openVolume(folder_ / "one.dcm.gz").volume), expected);
  EXPECT_EQ(realValues(*io::openVolume(folder_ / "one.dcm.bz2").volume), expected);
}

TEST_F(Archive, AFolderOfPackedDicomFilesOpensAsTheUnpackedOneDoes) {
  const fs::path series = writeSeries(folder_ / "series"), packed = folder_ / "packed";
  const io::OpenedVolume expected = io::openVolume(series);
  fs::create_directories(packed);
  for (const auto& [name, bytes] : entriesOf(series, "")) writeFile(packed / (name + ".gz"), gzipped(bytes));
  writeFile(packed / "notes.txt.gz", gzipped("no image here"));
  SegSpec seg;
  seg.columns = 4;
  seg.frames = {{1, glm::dvec3(0, 0, 2), {0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}}};
  writeSeg(folder_ / "seg.dcm", seg);
  writeFile(packed / "seg.dcm.gz", gzipped(readFile(folder_ / "seg.dcm")));

  const io::OpenedVolume opened = io::openVolume(packed);
  EXPECT_EQ(realValues(*opened.volume), realValues(*expected.volume));
  expectSameGrid(opened.volume->grid, expected.volume->grid, 0.0);
  // Messages, sessions and the list of segmentations name the packed files.
  ASSERT_EQ(opened.series.files.size(), 5u);
  EXPECT_EQ(opened.series.files.front(), packed / "slice0.dcm.gz");
  EXPECT_EQ(io::listSeries(packed).front().files, opened.series.files);
  EXPECT_EQ(warningOf(opened.warnings, io::Warning::Kind::UnreadableFiles).files,
            std::vector<fs::path>{packed / "notes.txt.gz"});
  ASSERT_EQ(opened.segmentations.size(), 1u);
  EXPECT_EQ(opened.segmentations.front().file, packed / "seg.dcm.gz");
  EXPECT_EQ(io::openLabels(packed / "seg.dcm.gz", opened.volume->grid).labels->value({1, 0, 1}), 1);
}

TEST_F(Archive, APackedFileThatIsDamagedIsNamed) {
  const fs::path series = writeSeries(folder_ / "series"), packed = folder_ / "packed";
  fs::create_directories(packed);
  for (const auto& [name, bytes] : entriesOf(series, "")) writeFile(packed / (name + ".gz"), gzipped(bytes));
  const std::string whole = readFile(packed / "slice2.dcm.gz");
  writeFile(packed / "slice2.dcm.gz", whole.substr(0, whole.size() - 20));
  const io::OpenedVolume opened = io::openVolume(packed);
  EXPECT_EQ(warningOf(opened.warnings, io::Warning::Kind::UnreadableFiles).files,
            std::vector<fs::path>{packed / "slice2.dcm.gz"});
}

TEST_F(Archive, SegmentationsInItAreOfferedAndOpen) {
  Entries entries = entriesOf(writeSeries(folder_ / "series"), "study/");
  SegSpec seg;
  seg.columns = 4;
  seg.frames = {{1, glm::dvec3(0, 0, 2), {0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}}};
  writeSeg(folder_ / "seg.dcm", seg);
  entries.emplace_back("study/seg.dcm", readFile(folder_ / "seg.dcm"));
  const fs::path archive = folder_ / "a.zip";
  writeArchive(archive, Packed::Zip, entries);

  const io::OpenedVolume opened = io::openVolume(archive);
  ASSERT_EQ(opened.segmentations.size(), 1u);
  const fs::path file = opened.segmentations.front().file;
  EXPECT_EQ(file, archive / "study" / "seg.dcm");
  const io::OpenedLabels labels = io::openLabels(file, opened.volume->grid);
  EXPECT_EQ(labels.labels->value({1, 0, 1}), 1);
  EXPECT_EQ(labels.labels->value({2, 0, 1}), 0);
  EXPECT_EQ(io::labelFiles(file), std::vector<fs::path>{archive});

  const auto errorFor = [&](const fs::path& path) {
    return errorOf([&] { io::openLabels(path, opened.volume->grid); });
  };
  EXPECT_NE(errorFor(archive / "study" / "absent.dcm").find("is not in the archive"), std::string::npos);
  EXPECT_NE(errorFor(archive).find("is an archive of 6 files"), std::string::npos) << errorFor(archive);
  EXPECT_NE(errorFor(archive / "study" / "slice0.dcm").find((archive / "study" / "slice0.dcm").string()),
            std::string::npos);
  EXPECT_NE(errorFor(folder_ / "absent.zip" / "seg.dcm").find("does not exist"), std::string::npos);
}

TEST_F(Archive, AVolumeInTwoFilesOpens) {
  const std::string header =
      "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = a.raw\n";
  writeArchive(folder_ / "a.zip", Packed::Zip, {{"x/a.mhd", header}, {"x/a.raw", "abcdefgh"}});
  EXPECT_EQ(io::openVolume(folder_ / "a.zip").volume->voxels.count(), 8u);
}

TEST_F(Archive, WarningsAndErrorsNameTheArchive) {
  Entries entries = entriesOf(writeSeries(folder_ / "series"), "study/");
  entries.emplace_back("study/broken.dcm", readFile(folder_ / "series" / "slice0.dcm").substr(0, 200));
  writeArchive(folder_ / "a.zip", Packed::Zip, entries);
  const io::OpenedVolume opened = io::openVolume(folder_ / "a.zip");
  const io::Warning unreadable = warningOf(opened.warnings, io::Warning::Kind::UnreadableFiles);
  ASSERT_EQ(unreadable.files.size(), 1u);
  EXPECT_EQ(unreadable.files[0], folder_ / "a.zip" / "study/broken.dcm");

  writeArchive(folder_ / "b.zip", Packed::Zip, {{"notes.txt", "no image here"}});
  const std::string error = errorOf([&] { io::openVolume(folder_ / "b.zip"); });
  EXPECT_NE(error.find((folder_ / "b.zip" / "notes.txt").string() + ": holds no volume"), std::string::npos) << error;
}

TEST_F(Archive, NothingIsWrittenOutsideItsFolder) {
  Entries entries = entriesOf(writeSeries(folder_ / "series"), "");
  entries.emplace_back("../escaped.dcm", "x");
  entries.emplace_back("a/../../../escaped.dcm", "x");
  entries.emplace_back((folder_ / "absolute.dcm").string(), "x");
  for (const auto& [name, how] : std::map<std::string, Packed>{{"a.zip", Packed::Zip}, {"a.tar", Packed::Tar}}) {
    writeArchive(folder_ / name, how, entries);
    EXPECT_EQ(io::openVolume(folder_ / name).volume->grid.dims.z, 5);
  }
  EXPECT_FALSE(fs::exists(folder_ / "absolute.dcm"));
  EXPECT_FALSE(fs::exists(folder_ / "temporary" / "escaped.dcm"));
  EXPECT_FALSE(fs::exists(folder_ / "escaped.dcm"));
}

TEST_F(Archive, WhatGrowsBeyondMeasureIsRefused) {
  // 300 MB of zeros in 300 kB.
  writeArchive(folder_ / "bomb.zip", Packed::Zip, {{"a.dcm", std::string(300'000'000, '\0')}});
  EXPECT_NE(errorOf([&] { io::openVolume(folder_ / "bomb.zip"); }).find("unpacks to over 200 times"),
            std::string::npos);
}

TEST_F(Archive, WhatCannotBeUnpackedIsAnError) {
  const Entries entries = entriesOf(writeSeries(folder_ / "series"), "");
  const auto errorFor = [&](const std::string& name) { return errorOf([&] { io::openVolume(folder_ / name); }); };
  writeArchive(folder_ / "secret.zip", Packed::EncryptedZip, entries);
  EXPECT_NE(errorFor("secret.zip").find("is encrypted"), std::string::npos);
  writeArchive(folder_ / "a.zip", Packed::Zip, entries);
  const std::string whole = readFile(folder_ / "a.zip");
  writeFile(folder_ / "half.zip", whole.substr(0, whole.size() / 2));
  EXPECT_NE(errorFor("half.zip").find("cannot be unpacked"), std::string::npos);
  writeArchive(folder_ / "empty.zip", Packed::Zip, {});
  EXPECT_NE(errorFor("empty.zip").find("archive without files"), std::string::npos);
  writeArchive(folder_ / "nested.zip", Packed::Zip, {{"a.zip", whole}});
  EXPECT_NE(errorFor("nested.zip").find("an archive in an archive"), std::string::npos);
  ::setenv("TMPDIR", (folder_ / "missing").c_str(), 1);
  EXPECT_NE(errorFor("a.zip").find("TMPDIR"), std::string::npos);
}

TEST_F(Archive, UnpackingCanBeCancelled) {
  writeArchive(folder_ / "a.zip", Packed::Zip, entriesOf(writeSeries(folder_ / "series"), ""));
  io::OpenOptions options;
  options.progress = [](double, std::string_view doing) { return doing != "unpacking"; };
  EXPECT_THROW(io::openVolume(folder_ / "a.zip", options), io::Cancelled);
}

}  // namespace fenestra::tests::archiveTest
