// fenestra-cli render --method and the methods' own options, as a script uses them.

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

class MethodCommand : public ::testing::Test {
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

const std::vector<std::string> methods{"--method cone --cone-angle 50", "--method importance --importance-angle 25",
                                       "--method importance --importance average --importance-opacity 0.2",
                                       "--method importance --importance average --importance-opacity 0.4 "
                                       "--importance-sparseness screen-door"};

TEST_F(MethodCommand, PicturesAreTheReferences) {
  ASSERT_EQ(render("adaptive.png", ""), 0);
  for (const std::string& method : methods) {
    SCOPED_TRACE(method);
    ASSERT_EQ(render("here.png", method), 0);
    ASSERT_EQ(render("truth.png", method + " --reference"), 0);
    // A bound of 1/255 and two 8-bit roundings, but for what the opening's rim grazes.
    EXPECT_LT(shareBeyond(2.0, "here.png", "truth.png"), 0.01);
    EXPECT_GT(shareBeyond(2.0, "adaptive.png", "truth.png"), 0.02) << "the test would notice";
  }
}

TEST_F(MethodCommand, ParametersOfOtherMethodsLeaveThePictureAsItIs) {
  ASSERT_EQ(render("plain.png", ""), 0);
  ASSERT_EQ(render("same.png", "--method adaptive --cone-angle 70 --importance average --importance-opacity 0.9"), 0);
  EXPECT_EQ(bytes("plain.png"), bytes("same.png"));
}

TEST_F(MethodCommand, ASessionKeepsEach) {
  for (const std::string& method : methods) {
    SCOPED_TRACE(method);
    ASSERT_EQ(render("a.png", method + " --save-session " + quoted("work.fenestra")), 0);
    ASSERT_EQ(run("render " + quoted("work.fenestra") + " -o " + quoted("b.png")), 0);
    EXPECT_EQ(bytes("a.png"), bytes("b.png"));
  }
  const Method kept = io::readSession(at("work.fenestra")).look.method;
  EXPECT_EQ(kept, (Method{.kind = MethodKind::Importance,
                          .importance = ImportanceMode::Average,
                          .importanceOpacity = 0.4,
                          .sparseness = Sparseness::ScreenDoor}));
}

TEST_F(MethodCommand, RefusesWhatIsNoAngleAndNoShare) {
  for (const std::string wrong : {"--cone-angle 0", "--cone-angle 90", "--cone-angle nan", "--importance-angle 0",
                                  "--importance-opacity 1.1", "--importance some"})
    EXPECT_EQ(render("x.png", wrong), 2) << wrong;
  EXPECT_FALSE(std::filesystem::exists(at("x.png")));
}

}  // namespace
}  // namespace fenestra::tests
