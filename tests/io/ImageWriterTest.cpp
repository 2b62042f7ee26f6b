#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "io/ImageWriter.h"
#include "io/base/AtomicFile.h"
#include "io/base/Error.h"
#include "tests/io/IoTesting.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace fs = std::filesystem;

TEST(ImageWriter, ReplacesAWholeFileOrNothing) {
  const fs::path folder = scratchFolder();
  io::writeText(folder / "a.txt", "first");
  io::writeText(folder / "a.txt", "second, longer");
  EXPECT_EQ(readFile(folder / "a.txt"), "second, longer");
  EXPECT_THROW(io::writeAtomically(folder / "a.txt",
                                   [](const fs::path& temporary) {
                                     writeFile(temporary, "half");
                                     throw std::runtime_error("stopped");
                                   }),
               std::runtime_error);
  EXPECT_EQ(readFile(folder / "a.txt"), "second, longer");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  EXPECT_NE(errorOf([&] { io::writeText(folder / "none" / "a.txt", ""); }).find("none/a.txt: cannot be written"),
            std::string::npos);
}

TEST(ImageWriter, WritesIntoAPipeAndLeavesItThere) {
  const std::filesystem::path pipe = tests::scratchFolder() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const int reader = ::open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(reader, 0);
  io::writeText(pipe, "through");
  std::array<char, 16> read{};
  EXPECT_EQ(::read(reader, read.data(), read.size()), 7);
  EXPECT_STREQ(read.data(), "through");
  ::close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(ImageWriter, PngsComeBackByteForByte) {
  const fs::path path = scratchFolder() / "picture.png";
  for (const int channels : {1, 3, 4}) {
    std::vector<std::uint8_t> pixels;
    for (int i = 0; i < 5 * 3 * channels; ++i) pixels.push_back(static_cast<std::uint8_t>(i * 17));
    io::writePng(path, {5, 3}, channels, pixels);
    const io::Picture picture = io::readPicture(path);
    EXPECT_EQ(picture.size, glm::ivec2(5, 3));
    ASSERT_EQ(picture.channels, channels);
    for (std::size_t i = 0; i < pixels.size(); ++i) EXPECT_EQ(std::lround(picture.values[i] * 255.0f), pixels[i]);
  }
  const std::vector<std::uint8_t> few(3);
  EXPECT_THROW(io::writePng(path, {5, 3}, 1, few), std::invalid_argument);
}

TEST(ImageWriter, LayersComeBackBitForBit) {
  const fs::path path = scratchFolder() / "layer.mha";
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::vector<float> values{1.5f, nan, -inf, 0.1f, 5, 6, 7, 8, 9, 10, 11, 12};
  io::writeLayer(path, {3, 2}, 2, values);
  const io::Picture layer = io::readPicture(path);
  EXPECT_EQ(layer.size, glm::ivec2(3, 2));
  EXPECT_EQ(layer.channels, 2);
  EXPECT_EQ(bytesOf(layer.values), bytesOf(values));
  const std::string bytes = readFile(path);
  EXPECT_NE(bytes.find("NDims = 2\n"), std::string::npos);
  EXPECT_TRUE(bytes.ends_with(bytesOf(values)));
}

TEST(ImageWriter, DamagedPicturesAreErrors) {
  const fs::path folder = scratchFolder();
  const std::vector<std::uint8_t> pixels(64 * 64 * 3, 9);
  io::writePng(folder / "a.png", {64, 64}, 3, pixels);
  const std::vector<float> values(64 * 64, 9.0f);
  io::writeLayer(folder / "a.mha", {64, 64}, 1, values);
  for (const char* name : {"a.png", "a.mha"}) {
    const std::string bytes = readFile(folder / name);
    for (std::size_t size = 0; size + 20 < bytes.size(); size = size * 3 / 2 + 1) {
      writeFile(folder / "cut", bytes.substr(0, size));
      EXPECT_FALSE(errorOf([&] { io::readPicture(folder / "cut"); }).empty()) << name << " of " << size;
    }
  }
  EXPECT_NE(errorOf([&] { io::readPicture(folder / "none.png"); }).find("does not exist"), std::string::npos);
}

}  // namespace fenestra::tests
