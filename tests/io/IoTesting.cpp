#include "tests/io/IoTesting.h"

#include <fstream>
#include <sstream>

#include <bzlib.h>
#include <zlib.h>

namespace fenestra::tests {
namespace fs = std::filesystem;
namespace {

std::string deflated(const std::string& bytes, int windowBits) {
  z_stream state{};
  EXPECT_EQ(deflateInit2(&state, Z_BEST_SPEED, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string packed(deflateBound(&state, bytes.size()), '\0');
  state.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  state.avail_in = static_cast<uInt>(bytes.size());
  state.next_out = reinterpret_cast<Bytef*>(packed.data());
  state.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&state, Z_FINISH), Z_STREAM_END);
  packed.resize(state.total_out);
  deflateEnd(&state);
  return packed;
}

}  // namespace

void writeFile(const fs::path& path, const std::string& bytes) {
  // Writing over a file makes some file systems wait for the disk; thousands of small files are written here.
  fs::remove(path);
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  ASSERT_TRUE(file.good()) << path;
}

std::string readFile(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

std::string gzipped(const std::string& bytes) { return deflated(bytes, 15 + 16); }
std::string zlibbed(const std::string& bytes) { return deflated(bytes, 15); }
std::string bzipped(const std::string& bytes) {
  // The bound that bzip2's manual gives: one hundredth and 600 bytes more than the input.
  unsigned size = static_cast<unsigned>(bytes.size() + bytes.size() / 100 + 600);
  std::string packed(size, '\0');
  EXPECT_EQ(BZ2_bzBuffToBuffCompress(packed.data(), &size, const_cast<char*>(bytes.data()),
                                     static_cast<unsigned>(bytes.size()), 1, 0, 0),
            BZ_OK);
  packed.resize(size);
  return packed;
}

std::vector<double> realValues(const Volume& volume) {
  return volume.voxels.visit([&](auto scalars) {
    std::vector<double> values(scalars.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = volume.slope * static_cast<double>(scalars[i]) + volume.intercept;
    return values;
  });
}

std::string errorOf(const std::function<void()>& act) {
  try {
    act();
  } catch (const io::Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no io::Error was thrown";
  return {};
}

bool hasWarning(const std::vector<io::Warning>& warnings, io::Warning::Kind kind) {
  for (const io::Warning& warning : warnings)
    if (warning.kind == kind) return true;
  return false;
}

io::Warning warningOf(const std::vector<io::Warning>& warnings, io::Warning::Kind kind) {
  for (const io::Warning& warning : warnings)
    if (warning.kind == kind) return warning;
  ADD_FAILURE() << "no warning of the kind among: " << kindsOf(warnings);
  return {};
}

std::string kindsOf(const std::vector<io::Warning>& warnings) {
  std::string text;
  for (const io::Warning& warning : warnings) text += "[" + warning.text + "] ";
  return text;
}

void expectSameGrid(const Grid& actual, const Grid& expected, double millimetres) {
  ASSERT_EQ(actual.dims, expected.dims);
  const auto corners = actual.corners(), wanted = expected.corners();
  for (std::size_t i = 0; i < corners.size(); ++i)
    EXPECT_LE(glm::distance(corners[i], wanted[i]), millimetres)
        << "corner " << i << " at (" << corners[i].x << ", " << corners[i].y << ", " << corners[i].z << "), not ("
        << wanted[i].x << ", " << wanted[i].y << ", " << wanted[i].z << ")";
}

}  // namespace fenestra::tests
