// fenestra-cli render --occlusion and --shadow, as a script uses them.

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
#include "io/session/SessionFile.h"
#include "tests/support/TestData.h"

namespace fenestra::tests {
namespace {

class OcclusionCommand : public ::testing::Test {
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
  /// The share of values that differ by more than so many 1/255.
  double shareBeyond(double limit, const std::string& a, const std::string& b) const {
    const std::vector<float> one = io::readPicture(at(a)).values, other = io::readPicture(at(b)).values;
    EXPECT_EQ(one.size(), other.size());
    std::size_t beyond = 0;
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
      beyond += 255.0 * std::abs(one[i] - other[i]) > limit;
    return static_cast<double>(beyond) / static_cast<double>(one.size());
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

TEST_F(OcclusionCommand, PicturesAreTheReferences) {
  const std::string both = "--occlusion 0.9 --shadow 0.8 --light=-40,50 ";
  ASSERT_EQ(render("plain.png", ""), 0);
  ASSERT_EQ(render("both.png", both), 0);
  ASSERT_EQ(render("truth.png", both + "--reference"), 0);
  // A bound of 1/255 and two 8-bit roundings, but for what the opening's rim grazes.
  EXPECT_LT(shareBeyond(2.0, "both.png", "truth.png"), 0.01);
  EXPECT_GT(shareBeyond(2.0, "plain.png", "truth.png"), 0.1) << "the test would notice";
  ASSERT_EQ(render("off.png", "--occlusion 0 --shadow 0"), 0);
  EXPECT_EQ(bytes("off.png"), bytes("plain.png"));
}

TEST_F(OcclusionCommand, ASessionKeepsBoth) {
  ASSERT_EQ(render("a.png", "--occlusion 0.35 --shadow 0.6 --save-session " + quoted("work.fenestra")), 0);
  const io::Session session = io::readSession(at("work.fenestra"));
  EXPECT_EQ(session.look.shading.occlusion, 0.35);
  EXPECT_EQ(session.look.shading.shadow, 0.6);
  ASSERT_EQ(run("render " + quoted("work.fenestra") + " -o " + quoted("b.png")), 0);
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
}

TEST_F(OcclusionCommand, RefusesWhatIsNoShare) {
  for (const std::string wrong : {"--occlusion 1.1", "--occlusion -0.1", "--shadow nan", "--shadow 2"})
    EXPECT_EQ(render("x.png", wrong), 2) << wrong;
  EXPECT_FALSE(std::filesystem::exists(at("x.png")));
}

}  // namespace
}  // namespace fenestra::tests
