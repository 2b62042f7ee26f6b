#pragma once
// Small pictures of the torso phantom by fenestra-cli render, as a script makes and compares them.

#include <sys/wait.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/ImageWriter.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {

/// The share of values that differ by more than a limit, in 1/255, between two pictures.
inline double shareBeyond(double limit, const std::string& a, const std::string& b) {
  const std::vector<float> one = io::readPicture(a).values, other = io::readPicture(b).values;
  EXPECT_EQ(one.size(), other.size());
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
    beyond += 255.0 * std::abs(one[i] - other[i]) > limit;
  return static_cast<double>(beyond) / static_cast<double>(one.size());
}

class PictureCommand : public ::testing::Test {
 protected:
  /// The exit code; -1 when ended by a signal.
  int run(const std::string& arguments) const {
    const int status =
        std::system((std::string(FENESTRA_CLI) + " " + arguments + " 2>'" + at("error") + "' >/dev/null").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int render(const std::string& name, const std::string& options) const {
    return run(
        "render --phantom torso --phantom-voxels 64 --focus-labels 'left kidney' --camera 200,10 --size 120x100 " +
        ("--max-error 1 " + options) + " -o " + quoted(name));
  }
  double shareBeyond(double limit, const std::string& a, const std::string& b) const {
    return tests::shareBeyond(limit, at(a), at(b));
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::string quoted(const std::string& name) const { return std::string("'").append(at(name)).append("'"); }
  std::string bytes(const std::string& name) const {
    std::ifstream file(at(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  const std::filesystem::path folder_ = scratchFolder();
};

}  // namespace fenestra::tests
