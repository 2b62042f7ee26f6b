// Damaged and hostile sessions: each is one clear error, or a session where the damage leaves one; nothing crashes,
// hangs, or takes memory by a lie.

#include <sys/resource.h>

#include <chrono>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "io/session/SessionFile.h"
#include "io/session/StrokeFile.h"
#include "io/study/ReadStudy.h"
#include "io/study/SessionData.h"
#include "tests/io/IoTesting.h"
#include "tests/session/SessionTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::hostileSessionTest {
namespace {

namespace fs = std::filesystem;

/// Reads a file and writes the result. Any other exception than io::Error ends the test.
void readSomehow(const fs::path& file) {
  try {
    const io::Session session = io::readSession(file);
    io::textOf(session, file);
  } catch (const io::Error& error) {
    EXPECT_FALSE(error.cause().empty());
    const std::string said = error.what();
    EXPECT_TRUE(std::none_of(said.begin(), said.end(), [](unsigned char c) { return c < 0x20; })) << said;
    EXPECT_LT(said.size(), 500u + file.string().size());
  }
}

/// Resident memory at its greatest so far, MB.
long peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

class HostileSession : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = scratchFolder();
    file_ = folder_ / "a.fenestra";
    io::writeSession(file_, fullSession(folder_));
    good_ = readFile(file_);
  }

  std::string errorFrom(const std::string& text) {
    writeFile(file_, text);
    return errorOf([&] { io::readSession(file_); });
  }
  /// The good session with `from` replaced.
  std::string with(const std::string& from, const std::string& to) const {
    std::string text = good_;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }

  fs::path folder_, file_;
  std::string good_;
};

TEST_F(HostileSession, TruncatedOnesAreErrors) {
  // The last byte is a line's end, without which it is whole.
  const std::size_t whole = good_.size() - 1, step = std::max<std::size_t>(1, whole / 400);
  for (std::size_t size = 0; size < whole; size += step)
    EXPECT_FALSE(errorFrom(good_.substr(0, size)).empty()) << "cut to " << size;
}

TEST_F(HostileSession, Thorough_FlippedBitsAreErrorsOrSessions) {
  std::mt19937 random(20260131);
  for (int round = 0; round < 4000; ++round) {
    std::string text = good_;
    for (int flips = 1 + round % 3; flips > 0; --flips)
      text[random() % text.size()] ^= static_cast<char>(1 << random() % 8);
    writeFile(file_, text);
    readSomehow(file_);
  }
}

TEST_F(HostileSession, DeepNestingIsRefused) {
  for (const char* open : {"[", "{\"a\":"}) {
    std::string nested;
    for (int level = 0; level < 1000000; ++level) nested += open;
    EXPECT_NE(errorFrom(nested).find("nests too deep"), std::string::npos);
    EXPECT_NE(errorFrom(with("\"linked\": false", "\"linked\": false, \"x\": " + nested)).find("nests too deep"),
              std::string::npos);
  }
}

TEST_F(HostileSession, NumbersBeyondMeasureAreRefused) {
  for (const char* number : {"1e999", "-1e999", "99999999999999999999999999", "1e300", "-1", "NaN", "Infinity", "0x10",
                             "1.", "\"31\"", "null", "[31]", "true"})
    EXPECT_FALSE(errorFrom(with("\"open_width\": 31.0", std::string("\"open_width\": ") + number)).empty()) << number;
  for (const char* number : {"1e999", "-1", "1.5", "18446744073709551616", "-9223372036854775809"})
    EXPECT_FALSE(errorFrom(with("\"bytes\": 1234567890123", std::string("\"bytes\": ") + number)).empty()) << number;
  EXPECT_FALSE(errorFrom(with("\"version\": 4", "\"version\": 4294967300")).empty()) << "4 after 2^32";
  EXPECT_FALSE(errorFrom(with("\"version\": 4", "\"version\": -1")).empty());
  EXPECT_FALSE(errorFrom(with("\"version\": 4", "\"version\": 2.5")).empty());
}

TEST_F(HostileSession, DuplicatesAreRefused) {
  EXPECT_NE(errorFrom(with("\"linked\": false", "\"linked\": false, \"linked\": true"))
                .find("has the member \"linked\" twice"),
            std::string::npos);
  EXPECT_NE(errorFrom(with("\"follow\": false", "\"follow\": false, \"follow\": false")).find("twice"),
            std::string::npos);
  const std::string odd = "\"\\u0007\\n" + std::string(200, 'x') + "\": 1";
  const std::string said = errorFrom(with("\"linked\"", odd + ", " + odd + ", \"linked\""));
  EXPECT_NE(said.find("twice"), std::string::npos);
  EXPECT_EQ(said.find('\n'), std::string::npos);
}

TEST_F(HostileSession, TextThatIsNoUtf8IsRefused) {
  for (const char* bytes : {"\xff", "\xc0\xaf", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xe2\x82"})
    EXPECT_NE(errorFrom(with("sagittal", bytes)).find("is not valid JSON"), std::string::npos);
  EXPECT_FALSE(errorFrom(with("sagittal", std::string(1, '\0'))).empty());
}

TEST_F(HostileSession, PathsThatAreNotRelativeAreRefused) {
  const auto withPath = [&](const std::string& path) {
    return with("\"path\": \"study\"", "\"path\": \"" + path + "\"");
  };
  for (const char* path : {"/etc/passwd", "//x", "/dev/zero", "/", "a\\u0000b"})
    EXPECT_NE(errorFrom(withPath(path)).find("not relative"), std::string::npos) << path;
  EXPECT_NE(errorFrom(withPath("")).find("either a volume or a phantom"), std::string::npos);
}

/// A session may point anywhere with "..": a file there is looked at, but not opened unless it is the one that the
/// session names.
TEST_F(HostileSession, WhatLiesOutsideIsNotOpenedUnlessItsContentsAreNamed) {
  const fs::path inside = folder_ / "sent";
  fs::create_directory(inside);
  writeFile(folder_ / "secret.raw", std::string(60, 's'));
  io::Session session = fullSession(folder_);
  session.volume = {};
  session.volume.path = folder_ / "secret.raw";
  session.volume.raw = io::RawDescription{{3, 4, 5}, ScalarType::UInt8};
  session.labels = {};
  const auto missing = [&] {
    io::writeSession(inside / "a.fenestra", session);
    try {
      io::DataRequest request;
      request.path = inside / "a.fenestra";
      io::openData(request);
    } catch (const io::DataMissing& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(missing().find("../secret.raw"), std::string::npos) << "no contents named";
  session.volume.contents = {"sha256:" + std::string(64, 'a'), 60, 1};
  EXPECT_NE(missing().find("../secret.raw"), std::string::npos) << "wrong contents named";
  // A link within is no way out.
  fs::create_symlink(folder_ / "secret.raw", inside / "link.raw");
  session.volume.path = inside / "link.raw";
  EXPECT_FALSE(missing().empty());
  session.volume.contents = io::contentsOf({folder_ / "secret.raw"});
  EXPECT_TRUE(missing().empty()) << "who knows the contents may name the place";
}

TEST_F(HostileSession, SizeIsBoundedBeforeReading) {
  const long before = peakMegabytes();
  const auto start = std::chrono::steady_clock::now();
  // A text of 1 GB is refused by the file's size.
  {
    std::ofstream(file_, std::ios::binary) << R"({"format": "fenestra-session", "version": 2, "maximised": ")";
    fs::resize_file(file_, std::uintmax_t{1} << 30);
  }
  EXPECT_NE(errorOf([&] { io::readSession(file_); }).find("larger than 128 MB"), std::string::npos);
  EXPECT_NE(errorOf([&] { io::readStrokes(file_); }).find("larger than 128 MB"), std::string::npos);
  // The elements that 60 MB holds most of: one byte a value, one member in five.
  std::string zeros;
  zeros.reserve(60 << 20);
  while (zeros.size() < (60u << 20)) zeros += "0,";
  EXPECT_NE(errorFrom("[" + zeros + "0]").find("too many values"), std::string::npos);
  std::string members;
  for (int i = 0; i < 2000; ++i) members.append("\"m").append(std::to_string(i)).append("\": 0, ");
  EXPECT_NE(errorFrom(with("\"linked\"", members + "\"linked\"")).find("too many members"), std::string::npos);
  EXPECT_FALSE(errorFrom(with("sagittal", std::string(60 << 20, 'x')) + "}").empty());
  // The files themselves are up to 60 MB, held twice or three times by the test; a sanitizer doubles that.
  EXPECT_LT(peakMegabytes() - before, 1500);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST_F(HostileSession, NoFileIsNoSession) {
  EXPECT_FALSE(errorOf([&] { io::readSession("/dev/zero"); }).empty());
  EXPECT_FALSE(errorOf([&] { io::readSession(folder_); }).empty());
  EXPECT_FALSE(errorFrom("").empty());
  EXPECT_FALSE(errorFrom("{").empty());
  EXPECT_FALSE(errorFrom(std::string(100, '\0')).empty());
}

TEST_F(HostileSession, WhatContradictsItselfIsRefused) {
  EXPECT_NE(errorFrom(with("\"low\": -1000.5", "\"low\": 4000")).find("low exceeds its high"), std::string::npos);
  EXPECT_NE(errorFrom(with("\"value\": -0.1", "\"value\": 301")).find("nodes are not in order"), std::string::npos);
  EXPECT_NE(errorFrom(with("\"volume\": {", "\"phantom\": {\"name\": \"head\"}, \"volume\": {"))
                .find("either a volume or a phantom"),
            std::string::npos);
  EXPECT_NE(errorFrom(R"({"format": "fenestra-session", "version": 2})").find("lacks"), std::string::npos);
}

}  // namespace
}  // namespace fenestra::tests::hostileSessionTest
