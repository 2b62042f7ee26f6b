#include "tests/io/GdcmPeer.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace fenestra::tests {
namespace {

struct Close {
  void operator()(std::FILE* pipe) const { EXPECT_EQ(::pclose(pipe), 0) << "the GDCM program failed"; }
};

std::vector<double> realValues(const GdcmRecord& header, const std::vector<char>& bytes,
                               const std::vector<std::uint16_t>& table) {
  const auto word = static_cast<std::size_t>(header.bitsAllocated / 8);
  const std::uint64_t sign = header.isSigned ? std::uint64_t{1} << (8 * word - 1) : 0;
  std::vector<double> values(bytes.size() / word);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, bytes.data() + i * word, word);
    const std::int64_t stored = static_cast<std::int64_t>(bits ^ sign) - static_cast<std::int64_t>(sign);
    if (table.empty())
      values[i] = header.slope * static_cast<double>(stored) + header.intercept;
    else
      values[i] = table[static_cast<std::size_t>(
          std::clamp<std::int64_t>(stored - header.lutFirst, 0, static_cast<std::int64_t>(table.size()) - 1))];
  }
  return values;
}

}  // namespace

std::vector<GdcmImage> readWithGdcm(const std::vector<std::filesystem::path>& files, bool dose) {
  std::string command = std::string("'") + FENESTRA_GDCM_PROGRAM + "' " + (dose ? "dose" : "rescale");
  for (const auto& file : files) command.append(" '").append(file.string()).append("'");
  // The JPEG library below GDCM says on the error stream that it tries 8 bits before 12.
  command.append(" 2>/dev/null");
  const std::unique_ptr<std::FILE, Close> pipe(::popen(command.c_str(), "r"));
  std::vector<GdcmImage> images;
  for (const auto& file : files) {
    GdcmImage image;
    if (std::fread(&image.header, sizeof image.header, 1, pipe.get()) != 1) {
      ADD_FAILURE() << "GDCM stopped at " << file;
      return images;
    }
    if (!image.header.isImage) continue;
    std::vector<char> bytes(image.header.wordBytes);
    std::vector<std::uint16_t> table(image.header.lutEntries);
    EXPECT_EQ(std::fread(bytes.data(), 1, bytes.size(), pipe.get()), bytes.size());
    EXPECT_EQ(std::fread(table.data(), 2, table.size(), pipe.get()), table.size());
    image.values = realValues(image.header, bytes, table);
    images.push_back(std::move(image));
  }
  return images;
}

}  // namespace fenestra::tests
