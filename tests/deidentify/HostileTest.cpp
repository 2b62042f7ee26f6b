// Objects that are damaged on purpose: a run ends with copies or an error, never with a crash, and nothing is left
// behind.

#include <random>

#include <gtest/gtest.h>

#include "io/VolumeReader.h"
#include "io/deidentify/Deidentify.h"
#include "tests/io/DicomMakes.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::deidentify_hostile {
namespace {

namespace fs = std::filesystem;

class DeidentifyHostile : public ::testing::Test {
 protected:
  /// Whether there are copies; the error otherwise.
  std::string outcomeOf(const std::string& bytes) {
    const fs::path file = folder_ / "in.dcm", out = folder_ / "out";
    fs::remove_all(out);
    writeFile(file, bytes);
    std::string error;
    try {
      io::deidentify::deidentify({.inputs = {file}, .output = out, .options = {.cleanDescriptors = true}});
    } catch (const io::Error& thrown) {
      error = thrown.what();
    }
    EXPECT_EQ(fs::exists(out), error.empty()) << error;
    std::size_t entries = 0;
    for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++entries;
    EXPECT_EQ(entries, error.empty() ? 2u : 1u) << error;
    return error;
  }

  std::string whole() {
    const fs::path file = folder_ / "whole.dcm";
    writeEdited(file, pictureSpec(),
                {set(0x00100010, "PN", "Mustermann^Erika"),
                 set(0x00400275, "SQ", item(element(0x00321060, "LO", "Thorax") + element(0x00400009, "SH", "1 ")))});
    const std::string bytes = readFile(file);
    fs::remove(file);
    return bytes;
  }

  const fs::path folder_ = scratchFolder();
};

TEST_F(DeidentifyHostile, RefusesSequencesThatNestWithoutEnd) {
  std::string inside = element(0x00100010, "PN", "Mustermann");
  for (int level = 0; level < 600; ++level) inside = sequence(0x00081140, inside);
  const fs::path file = folder_ / "deep.dcm";
  writeEdited(file, pictureSpec(), {});
  const std::string head = readFile(file);
  fs::remove(file);
  const std::size_t at = head.find(std::string("\x20\x00\x0d\x00", 4));  // before Study Instance UID
  ASSERT_NE(at, std::string::npos);
  EXPECT_NE(outcomeOf(head.substr(0, at) + inside + head.substr(at)).find("nests deeper"), std::string::npos);
}

TEST_F(DeidentifyHostile, EndsWhereverAFileEnds) {
  const std::string bytes = whole();
  for (std::size_t length = 0; length < bytes.size(); length += 7) outcomeOf(bytes.substr(0, length));
}

TEST_F(DeidentifyHostile, EndsWhateverBytesAreChanged) {
  const std::string bytes = whole();
  std::mt19937 random(20);  // NOLINT: the same each time
  for (int round = 0; round < 400; ++round) {
    std::string damaged = bytes;
    for (int change = 0; change < 4; ++change)
      damaged[132 + random() % std::min<std::size_t>(bytes.size() - 132, 900)] = static_cast<char>(random() & 0xff);
    outcomeOf(damaged);
  }
}

TEST_F(DeidentifyHostile, BelievesNoHugeLength) {
  std::string bytes = whole();
  const std::size_t name = bytes.find("Mustermann^Erika");
  ASSERT_NE(name, std::string::npos);
  bytes[name - 2] = bytes[name - 1] = '\xff';
  outcomeOf(bytes);
}

}  // namespace
}  // namespace fenestra::tests::deidentify_hostile
