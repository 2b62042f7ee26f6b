// fenestra-cli render with --crop, --clip-plane, --clip-exempt and --clip-grey, and sessions that keep them.

#include <sys/wait.h>
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

namespace fenestra::tests::clippingCommandTest {
namespace {

namespace fs = std::filesystem;

class ClippingCommand : public ::testing::Test {
 protected:
  /// With `options` in the shell's own syntax. The exit code; -1 when ended by a signal.
  int render(const std::string& options) const {
    return run(" render --phantom torso --phantom-voxels 48 --size 70x60 --camera 20,10 " + options);
  }
  int run(const std::string& arguments) const {
    const std::string command = FENESTRA_CLI + arguments + " >'" + at("output") + "' 2>'" + at("error") + "'";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::string error() const {
    std::ifstream file(at("error"));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string bytes(const std::string& name) const {
    std::ifstream file(at(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::vector<float> layer(const std::string& name, const std::string& options) const {
    EXPECT_EQ(render("-o '" + at("a.png") + "' --layers '" + at("layers") + "' " + options), 0) << error();
    return io::readPicture(folder_ / "layers" / (name + ".mha")).values;
  }

 private:
  const fs::path folder_ = scratchFolder();
};

TEST_F(ClippingCommand, Thorough_RaysStartAndEndAtTheBoxAndPlanes) {
  const std::vector<float> whole = layer("t_context", "");
  for (const char* options : {"--crop :,-20:,:", "--clip-plane 0,1,0,-20", "--clip-plane 0,-20,0,0,3,0"}) {
    const std::vector<float> cut = layer("t_context", options);
    ASSERT_EQ(cut.size(), whole.size());
    std::size_t later = 0;
    for (std::size_t i = 0; i < cut.size(); ++i) {
      if (std::isnan(cut[i])) continue;
      EXPECT_GE(cut[i], whole[i] - 1e-3) << options;
      later += cut[i] > whole[i] + 1.0f;
    }
    EXPECT_GT(later, 200u) << options;
  }
}

TEST_F(ClippingCommand, ABoxAndTheSamePlanesAreTheSamePicture) {
  ASSERT_EQ(render("-o '" + at("box.png") + "' --crop -60:70,-20:,:"), 0) << error();
  ASSERT_EQ(
      render("-o '" + at("planes.png") + "' --clip-plane 1,0,0,-60 --clip-plane -1,0,0,-70 --clip-plane 0,1,0,-20"), 0)
      << error();
  EXPECT_EQ(bytes("box.png"), bytes("planes.png"));
  ASSERT_EQ(render("-o '" + at("whole.png") + "'"), 0);
  EXPECT_NE(bytes("box.png"), bytes("whole.png"));
}

TEST_F(ClippingCommand, Thorough_PicturesAreWithinTheirBound) {
  for (const char* options : {"--crop -60:70,-20:,:", "--clip-plane 0.3,1,0.2,-15 --clip-exempt liver,6",
                              "--clip-plane 0,1,0,-20 --clip-grey 400,40"})
    for (const char* bound : {"4", "0.5"}) {
      ASSERT_EQ(render(std::string("-o '") + at("a.png") + "' --certify 1500 --max-error " + bound + " " + options), 0)
          << error();
      EXPECT_NE(bytes("output").find("\"exceeding\": 0"), std::string::npos) << options << ' ' << bytes("output");
    }
}

TEST_F(ClippingCommand, Thorough_ASessionKeepsIt) {
  const std::string options = " --crop -60:70,-20:,: --clip-plane 0.3,1,0.2,-15 --clip-exempt liver --clip-grey 400,40";
  ASSERT_EQ(render("-o '" + at("a.png") + "' --save-session '" + at("a.fenestra") + "'" + options), 0) << error();
  const io::Session session = io::readSession(at("a.fenestra"));
  EXPECT_TRUE(session.look.clipping.cropped);
  EXPECT_EQ(session.look.clipping.box.low.y, -20.0);
  EXPECT_EQ(session.look.clipping.planes.size(), 1u);
  EXPECT_EQ(session.look.clipping.exempt.size(), 1u);
  EXPECT_EQ(session.look.clipping.grey, (WindowLevel{400.0, 40.0}));
  ASSERT_EQ(run(" render '" + at("a.fenestra") + "' -o '" + at("b.png") + "'"), 0) << error();
  EXPECT_EQ(bytes("a.png"), bytes("b.png"));
  ASSERT_EQ(run(" render '" + at("a.fenestra") + "' -o '" + at("c.png") +
                "' --crop none --clip-plane none --clip-exempt none --clip-grey none"),
            0)
      << error();
  ASSERT_EQ(render("-o '" + at("whole.png") + "'"), 0);
  EXPECT_EQ(bytes("c.png"), bytes("whole.png"));
}

TEST_F(ClippingCommand, PlacementLeavesOutWhatIsClipped) {
  const std::string place =
      " place --phantom torso --phantom-voxels 48 --focus-labels 'left kidney,right kidney' "
      "--samples 12 ";
  ASSERT_EQ(run(place), 0) << error();
  const std::string whole = bytes("output");
  ASSERT_EQ(run(place + "--crop 0:,:,:"), 0) << error();
  EXPECT_NE(bytes("output"), whole);
}

TEST_F(ClippingCommand, MistakesAreExplained) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"--crop 1,2,3", "is not L0:L1,P0:P1,S0:S1"},
      {"--crop 50:-50,:,:", "lower end first"},
      {"--crop :,:,nan:", "is not L0:L1,P0:P1,S0:S1"},
      {"--crop 5000:,:,:", "has nothing inside the crop box along L"},
      {"--clip-plane 0,0,0,5", "normal of no length"},
      {"--clip-plane 1,2,3", "is not NX,NY,NZ,D"},
      {"--clip-plane 1,0,0,0 --clip-plane 1,0,0,0 --clip-plane 1,0,0,0 --clip-plane 1,0,0,0", "more than three"},
      {"--clip-exempt nonsense", "there is no label \"nonsense\""},
      {"--clip-grey 0,40", "is not WIDTH,LEVEL"}};
  for (const auto& [options, message] : cases) {
    EXPECT_NE(render("-o '" + at("a.png") + "' " + options), 0) << options;
    EXPECT_NE(error().find(message), std::string::npos) << options << ": " << error();
  }
}

}  // namespace
}  // namespace fenestra::tests::clippingCommandTest
