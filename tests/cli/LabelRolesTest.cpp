// fenestra-cli render --hidden, --protected, --label-opacity and --label-colour, as a script uses them.

#include <sys/wait.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/ImageWriter.h"
#include "io/session/SessionFile.h"
#include "tests/support/TestData.h"

namespace fenestra::tests::labelRolesTest {
namespace {

namespace fs = std::filesystem;

class LabelRolesCommand : public ::testing::Test {
 protected:
  /// Draws the torso with its left kidney in focus from behind. The exit code; -1 when ended by a signal.
  int render(const std::string& name, const std::string& options, const std::string& scene = phantom) const {
    const std::string line = std::string(FENESTRA_CLI) + " render " + scene + " --size 90x80 --max-error 0.5 " +
                             options + " --layers '" + at(name) + "' -o '" + at(name + ".png") + "' 2>'" + at("error") +
                             "'";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::string quoted(const std::string& name) const { return std::string("'").append(at(name)).append("'"); }
  std::string error() const {
    std::ifstream file(at("error"));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::vector<float> layer(const std::string& run, const std::string& name) const {
    return io::readPicture(folder_ / run / (name + ".mha")).values;
  }
  bool has(const std::string& run, const std::string& name) const {
    return fs::exists(folder_ / run / (name + ".mha"));
  }

  inline static const std::string phantom =
      "--phantom torso --phantom-voxels 64 --focus-labels 'left kidney' --camera 200,10";

 private:
  const fs::path folder_ = scratchFolder();
};

double greatestDifference(const std::vector<float>& a, const std::vector<float>& b) {
  EXPECT_EQ(a.size(), b.size());
  double most = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (std::isnan(a[i]) != std::isnan(b[i]))
      return std::numeric_limits<double>::infinity();
    else if (!std::isnan(a[i]))
      most = std::max(most, std::abs(double{a[i]} - double{b[i]}));
  return most;
}

TEST_F(LabelRolesCommand, ProtectedLabelsStayAsInTheReference) {
  ASSERT_EQ(render("plain", ""), 0) << error();
  EXPECT_FALSE(has("plain", "protected_layer"));
  ASSERT_EQ(render("guarded", "--protected ribs"), 0) << error();
  ASSERT_EQ(render("truth", "--protected ribs --reference"), 0) << error();
  ASSERT_TRUE(has("guarded", "protected_layer"));
  EXPECT_EQ(greatestDifference(layer("plain", "t_start"), layer("guarded", "t_start")), 0.0)
      << "the opening is the same";
  EXPECT_EQ(layer("plain", "focus_layer"), layer("guarded", "focus_layer"));
  // Half of the bound that is asked for; the reference's hits differ by less.
  EXPECT_LE(255.0 * greatestDifference(layer("guarded", "protected_layer"), layer("truth", "protected_layer")), 0.5);
  EXPECT_GT(greatestDifference(layer("plain", "final"), layer("guarded", "final")), 0.2) << "a rib crosses the opening";
}

TEST_F(LabelRolesCommand, HiddenLabelsAreLeftOutInTheReferenceToo) {
  ASSERT_EQ(render("plain", ""), 0) << error();
  ASSERT_EQ(render("hidden", "--hidden ribs,spine"), 0) << error();
  ASSERT_EQ(render("truth", "--hidden ribs,spine --reference"), 0) << error();
  EXPECT_GT(greatestDifference(layer("plain", "final"), layer("hidden", "final")), 0.2);
  std::vector<double> errors;
  const std::vector<float> here = layer("hidden", "focus_layer"), truth = layer("truth", "focus_layer");
  ASSERT_EQ(here.size(), truth.size());
  for (std::size_t i = 0; i < here.size(); ++i) errors.push_back(255.0 * std::abs(double{here[i]} - double{truth[i]}));
  std::sort(errors.begin(), errors.end());
  // Rays that graze a surface start elsewhere; they are fewer than one in two hundred.
  EXPECT_LE(errors[errors.size() * 199 / 200], 0.5);
}

TEST_F(LabelRolesCommand, OpacityMakesLabelsOutsideTheFocusFainterAsInTheReference) {
  ASSERT_EQ(render("plain", ""), 0) << error();
  ASSERT_EQ(render("faint", "--label-opacity ribs=0.3,spine=0.1"), 0) << error();
  ASSERT_EQ(render("truth", "--label-opacity ribs=0.3,spine=0.1 --reference"), 0) << error();
  EXPECT_GT(greatestDifference(layer("plain", "final"), layer("faint", "final")), 0.1);
  std::vector<double> errors;
  const std::vector<float> here = layer("faint", "focus_layer"), truth = layer("truth", "focus_layer");
  ASSERT_EQ(here.size(), truth.size());
  for (std::size_t i = 0; i < here.size(); ++i) errors.push_back(255.0 * std::abs(double{here[i]} - double{truth[i]}));
  std::sort(errors.begin(), errors.end());
  // Rays that graze a surface start elsewhere; they are fewer than one in two hundred.
  EXPECT_LE(errors[errors.size() * 199 / 200], 0.5);
  ASSERT_EQ(render("none", "--label-opacity ribs=0"), 0) << error();
  ASSERT_EQ(render("hidden", "--hidden ribs"), 0) << error();
  EXPECT_EQ(layer("none", "final"), layer("hidden", "final"));
}

TEST_F(LabelRolesCommand, Thorough_OpacityAndColourChangeTheFocusAndComeBackFromASession) {
  ASSERT_EQ(render("plain", ""), 0) << error();
  const std::string options =
      "--label-opacity 'left kidney=0.25' --label-colour 'left kidney=#0080ff,ribs=#102030' --protected ribs "
      "--hidden liver";
  ASSERT_EQ(render("changed", options + " --save-session " + quoted("kept.fenestra")), 0) << error();
  EXPECT_GT(greatestDifference(layer("plain", "focus_layer"), layer("changed", "focus_layer")), 0.2);
  ASSERT_EQ(render("again", "", quoted("kept.fenestra")), 0) << error();
  EXPECT_EQ(layer("again", "final"), layer("changed", "final"));
  const io::Session session = io::readSession(at("kept.fenestra"));
  EXPECT_EQ(session.look.labels.size(), 3u);
  // An option changes what a session says of one label, and leaves the rest.
  ASSERT_EQ(render("opaque", "--label-opacity 'left kidney=1' --save-session " + quoted("opaque.fenestra"),
                   quoted("kept.fenestra")),
            0)
      << error();
  EXPECT_EQ(io::readSession(at("opaque.fenestra")).look.labels.size(), 3u) << "the kidney keeps its colour";
  EXPECT_GT(greatestDifference(layer("opaque", "focus_layer"), layer("changed", "focus_layer")), 0.1);
}

TEST_F(LabelRolesCommand, NamesWhatIsWrong) {
  for (const char* misuse : {"--hidden ,", "--label-opacity ribs", "--label-opacity ribs=2", "--label-opacity =0.5",
                             "--label-colour ribs=red", "--label-colour ribs=#12345"}) {
    EXPECT_EQ(render("none", misuse), 2) << misuse;
  }
  EXPECT_EQ(render("none", "--hidden rib"), 1);
  EXPECT_NE(error().find("there is no label \"rib\""), std::string::npos) << error();
  EXPECT_EQ(render("none", "--protected 'left kidney'"), 1);
  EXPECT_NE(error().find("cannot be protected: it is in focus"), std::string::npos) << error();
  EXPECT_FALSE(fs::exists(at("none.png")));
}

}  // namespace
}  // namespace fenestra::tests::labelRolesTest
