// fenestra-cli render --freeze, --axis-offset and --axis-direction, as a script uses them.

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

namespace fenestra::tests::openingCameraCommandTest {
namespace {

namespace fs = std::filesystem;

class OpeningCameraCommand : public ::testing::Test {
 protected:
  /// The exit code; -1 when ended by a signal.
  int run(const std::string& arguments) const {
    const int status =
        std::system((std::string(FENESTRA_CLI) + " " + arguments + " 2>'" + at("error") + "' >/dev/null").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int render(const std::string& name, const std::string& options, const std::string& scene = torso) const {
    return run("render " + scene + " --size 120x100 --max-error 1 " + options + " -o " + quoted(name));
  }
  /// Root mean square of the differences, in 1/255.
  double difference(const std::string& a, const std::string& b) const {
    const std::vector<float> one = io::readPicture(at(a)).values, other = io::readPicture(at(b)).values;
    EXPECT_EQ(one.size(), other.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
      sum += (one[i] - other[i]) * (one[i] - other[i]);
    return 255.0 * std::sqrt(sum / static_cast<double>(one.size()));
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::string quoted(const std::string& name) const { return std::string("'").append(at(name)).append("'"); }
  std::string bytes(const std::string& name) const {
    std::ifstream file(at(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  inline static const std::string torso =
      "--phantom torso --phantom-voxels 64 --focus-labels 'left kidney' --camera 200,10";

 private:
  const fs::path folder_ = scratchFolder();
};

TEST_F(OpeningCameraCommand, LooksIntoAnOpeningThatAnotherCameraCut) {
  ASSERT_EQ(render("straight.png", ""), 0);
  ASSERT_EQ(render("aside.png", "--freeze 170,0"), 0);
  EXPECT_NE(bytes("straight.png"), bytes("aside.png"));
  ASSERT_EQ(render("truth.png", "--freeze 170,0 --reference"), 0);
  // The bound of 1/255, two roundings to 8 bits, and the pixels on the opening's rim.
  EXPECT_LT(difference("aside.png", "truth.png"), 1.0);
  EXPECT_GT(difference("straight.png", "truth.png"), 5.0) << "the test would notice";
}

TEST_F(OpeningCameraCommand, TiltsTheOpening) {
  ASSERT_EQ(render("tilted.png", "--axis-offset 30 --axis-direction 90"), 0);
  ASSERT_EQ(render("truth.png", "--axis-offset 30 --axis-direction 90 --reference"), 0);
  ASSERT_EQ(render("other.png", "--axis-offset 30 --axis-direction -90"), 0);
  EXPECT_LT(difference("tilted.png", "truth.png"), 1.0);
  EXPECT_NE(bytes("tilted.png"), bytes("other.png"));
}

TEST_F(OpeningCameraCommand, ASessionKeepsBoth) {
  ASSERT_EQ(render("a.png", "--freeze 170,0 --axis-offset 10 --save-session " + quoted("work.fenestra")), 0);
  const io::Session session = io::readSession(at("work.fenestra"));
  EXPECT_TRUE(session.views[0].frozen.has_value());
  EXPECT_EQ(session.look.cutaway.axisOffset, 10.0);
  ASSERT_EQ(run("render " + quoted("work.fenestra") + " -o " + quoted("b.png")), 0);
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
}

TEST_F(OpeningCameraCommand, RefusesWhatIsNoCamera) {
  for (const std::string wrong : {"--freeze best", "--freeze sideways", "--axis-offset 81", "--axis-offset -1",
                                  "--axis-offset nan", "--axis-direction 181"})
    EXPECT_EQ(render("x.png", wrong), 2) << wrong;
  EXPECT_EQ(render("x.png", "--freeze absent.json"), 1);
  EXPECT_FALSE(fs::exists(at("x.png")));
}

}  // namespace
}  // namespace fenestra::tests::openingCameraCommandTest
