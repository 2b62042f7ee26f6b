// fenestra-cli --modality, for volumes whose files do not name one.

#include <array>

#include "io/session/SessionFile.h"
#include "tests/cli/CommandLine.h"

namespace fenestra::tests::studyOptionsTest {
namespace {

class StudyOptions : public CommandLine {
 protected:
  /// 4³ voxels of 16 bits whose values look like no Hounsfield units.
  std::string volume() const {
    write(at("volume.raw"), randomBytes(128));
    write(at("volume.mhd"),
          "ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementType = MET_SHORT\nElementSpacing = 1 1 1\n"
          "ElementDataFile = volume.raw\n");
    return at("volume.mhd");
  }
};

TEST_F(StudyOptions, ModalitySaysWhatAVolumeIs) {
  const std::string file = volume();
  const Json unsaid = run({"info", file}).json();
  EXPECT_EQ(unsaid.at("unit"), "");
  for (const auto& [option, modality, unit] :
       {std::array<std::string, 3>{"CT", "CT", "HU"}, std::array<std::string, 3>{"MR", "MR", ""},
        std::array<std::string, 3>{"other", unsaid.at("modality"), ""}}) {
    const Result result = run({"info", file, "--modality", option});
    ASSERT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(result.json().at("modality"), modality) << option;
    EXPECT_EQ(result.json().at("unit"), unit) << option;
  }
}

TEST_F(StudyOptions, ASessionKeepsTheModality) {
  const std::string file = volume();
  ASSERT_EQ(run({"render", file, "--modality", "CT", "--size", "20x20", "--save-session", at("work.fenestra"), "-o",
                 at("a.png")})
                .exitCode,
            0);
  EXPECT_EQ(io::readSession(at("work.fenestra")).volume.modality, Modality::CT);
  EXPECT_EQ(run({"info", at("work.fenestra")}).json().at("unit"), "HU");
  expectFailure(run({"info", at("work.fenestra"), "--modality", "MR"}), at("work.fenestra"));
}

TEST_F(StudyOptions, WrongModalitiesAreWrongUsage) {
  EXPECT_EQ(run({"info", volume(), "--modality", "PET scan"}).exitCode, 2);
  EXPECT_EQ(run({"info", "--phantom", "torso", "--modality", "CT"}).exitCode, 2);
}

}  // namespace
}  // namespace fenestra::tests::studyOptionsTest
